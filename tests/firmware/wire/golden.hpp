// Messages whose bytes are known for ever.
#pragma once

#include <wire_test/messages.hpp>

#include <string>
#include <vector>

namespace gs::wire::test {

struct Golden {
  std::string name;
  Bytes is;         // what the encoder makes of it now
  std::string was;  // in hexadecimal: what it made of it when the protocol was fixed
};

std::vector<Golden> goldens();

}  // namespace gs::wire::test
