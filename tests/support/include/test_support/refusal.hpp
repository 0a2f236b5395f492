// What a call is refused with.
#pragma once

#include <string>

namespace gsbench::test {

// The message of the Error that it throws; empty where it throws none.
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
