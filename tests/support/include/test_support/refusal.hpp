// The error message of a call.
#pragma once

#include <string>

namespace gsbench::test {

// The message of the Error that the call throws; empty if it does not throw.
template <class Error, class Call>
std::string refusal_of(const Call& call) {
  try {
    call();
  } catch (const Error& error) {
    return error.what();
  }
  return "";
}

}  // namespace gsbench::test
