// Unwraps a driver's result, for tests that do not test for errors.
#pragma once

#include <stdexcept>

#include <drivers/result.hpp>

namespace gsbench::test {

// Throws std::runtime_error with the driver's error.
template <class T>
T demand(drivers::Result<T> result) {
  if (!result.ok()) {
    throw std::runtime_error(result.error());
  }
  return result.take();
}

}  // namespace gsbench::test
