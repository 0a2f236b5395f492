// Uses heap, exceptions and libm, to prove that the check detects them.
#include <cmath>

namespace gs::test {

float* offend(float x) {
  if (x < 0.0F) {
    throw x;
  }
  return new float(std::sin(x));
}

}  // namespace gs::test
