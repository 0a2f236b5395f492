// Does what firmware must not, so that the check that forbids it is seen to fail.
#include <cmath>

namespace gs::test {

float* offend(float x) {
  if (x < 0.0F) {
    throw x;
  }
  return new float(std::sin(x));
}

}  // namespace gs::test
