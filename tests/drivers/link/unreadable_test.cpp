// The reasons for which a message from an outlet cannot be read.
#include <wire_test/messages.hpp>

#include <cmath>
#include <cstring>
#include <fstream>
#include <functional>

#include <gmock/gmock.h>

#include <link/unreadable.hpp>
#include <wire/codec.hpp>

namespace gsbench::link {
namespace {

using gs::wire::Hello;
using gs::wire::Uplink;
using gs::wire::UplinkKind;
using gs::wire::test::Bytes;
using gs::wire::test::encoded;

Uplink good_hello() {
  Uplink message;
  std::strcpy(message.hello.id, "a");
  message.hello.sample_rate_hz = 8000;
  message.hello.nominal_hz = 50;
  return message;
}

bool is_refused(const Bytes& bytes) {
  Uplink message;
  std::uint32_t sequence = 0;
  return gs::wire::decode(bytes.data(), bytes.size(), message, sequence) ==
         gs::wire::Decoded::kMalformed;
}

std::string fault_of(const Bytes& bytes) {
  EXPECT_TRUE(is_refused(bytes));
  return unreadable_fault(bytes.data(), bytes.size());
}

std::string hello_fault(const std::function<void(Hello&)>& change) {
  Uplink message = good_hello();
  change(message.hello);
  return fault_of(encoded(message, 0));
}

TEST(Unreadable, AHelloOutOfItsLimitsIsNamedWithFieldAndLimit) {
  const std::string begin = "its hello cannot be read: ";
  EXPECT_EQ(hello_fault([](Hello& hello) { hello.nominal_hz = 55; }),
            begin + "nominal_hz is 55, not 50 or 60");
  EXPECT_EQ(hello_fault([](Hello& hello) { hello.sample_rate_hz = 999; }),
            begin + "sample_rate_hz is 999, not 1000 … 1000000");
  EXPECT_EQ(hello_fault([](Hello& hello) { hello.sample_rate_hz = 1000001; }),
            begin + "sample_rate_hz is 1000001, not 1000 … 1000000");
  EXPECT_EQ(hello_fault([](Hello& hello) { hello.tracker_delay_s = std::nanf(""); }),
            begin + "tracker_delay_s is NaN, not 0 … 1");
  EXPECT_EQ(hello_fault([](Hello& hello) { hello.voltage_delay_s = 1.5F; }),
            begin + "voltage_delay_s is 1.500000, not 0 … 1");
  EXPECT_EQ(hello_fault([](Hello& hello) { std::strcpy(hello.id, "$x"); }),
            begin +
                "id is \"$x\", which has other characters than letters, digits, '-', '_' and "
                "'.'");
  EXPECT_EQ(hello_fault([](Hello& hello) { hello.id[0] = '\0'; }), begin + "id is empty");
}

TEST(Unreadable, AFieldIsNamedWithWhatIsWrongWithIt) {
  const std::string begin = "sent a message that cannot be read: ";
  // [14, 0, 0, 0, code, detail]
  EXPECT_EQ(fault_of({0x86, 0x0E, 0x00, 0x00, 0x00, 0x0A, 0x00}),
            begin + "error, code is 10, not 1 … 9");
  EXPECT_EQ(fault_of({0x86, 0x0E, 0x00, 0x00, 0x00, 0x01, 0xF5}),
            begin + "error, detail is not an unsigned integer");
  EXPECT_EQ(fault_of({0x86, 0x0E, 0x00, 0x00, 0x00, 0x01, 0x1B, 0, 0, 0, 1, 0, 0, 0, 0}),
            begin + "error, detail is 4294967296, not 0 … 4294967295");
  EXPECT_EQ(fault_of({0x85, 0x0E, 0x00, 0x00, 0x00, 0x01}), begin + "error, detail is missing");
  EXPECT_EQ(fault_of({0x86, 0x0E, 0x00, 0x00, 0x00, 0x01, 0x1A}),
            begin + "error, detail is cut off, or has an indefinite length");
  EXPECT_EQ(fault_of({0x86, 0x0E, 0x00, 0x00, 0x00, 0x01, 0x00, 0x00, 0x00}),
            begin + "error, 2 bytes follow its array");
  EXPECT_EQ(fault_of({0x87, 0x0E, 0x00, 0x00, 0x00, 0x01, 0x00, 0x9F}),
            begin + "error, an item after its fields is cut off, or has an indefinite length");
  EXPECT_EQ(fault_of({0x82, 0x18, 0x63, 0x00}), begin + "unknown kind 99, sample is missing");
  EXPECT_EQ(fault_of({0x82, 0xF5, 0x00}), begin + "its kind is not an unsigned integer");
  EXPECT_EQ(fault_of({0xFF}), begin + "it is not a whole CBOR array of definite length");
  EXPECT_EQ(fault_of(Bytes(561, 0)), begin + "it has 561 bytes, more than 560");
}

TEST(Unreadable, AReasonIsFoundForWhateverIsRefused) {
  int refused = 0;
  const auto try_it = [&](const Bytes& bytes) {
    if (is_refused(bytes)) {
      ++refused;
      const std::string fault = unreadable_fault(bytes.data(), bytes.size());
      EXPECT_NE(fault.back(), ' ') << fault << gs::wire::test::hex(bytes);
    }
  };
  for (const Uplink& message : gs::wire::test::many_uplinks(3)) {
    const Bytes whole = encoded(message, 7);
    for (std::size_t at = 0; at < whole.size(); ++at) {
      try_it(Bytes(whole.begin(), whole.begin() + static_cast<std::ptrdiff_t>(at)));
      for (const int flipped : {0x01, 0x20, 0x80}) {
        Bytes changed = whole;
        changed[at] = static_cast<std::uint8_t>(changed[at] ^ flipped);
        try_it(changed);
      }
    }
  }
  EXPECT_GT(refused, 1000);
}

// Rows of the protocol's text: "### 14 error" and "| 0 | code | enumeration | …".
TEST(Unreadable, TheNamesOfFieldsAreThoseOfTheProtocol) {
  std::ifstream file(GSBENCH_SOURCE_DIR "/firmware/wire/README.md");
  std::string line;
  while (std::getline(file, line) && line != "## Uplink") {
  }
  std::vector<std::vector<std::string>> names;
  while (std::getline(file, line) && line.rfind("## ", 0) != 0) {
    if (line.rfind("### ", 0) == 0) {
      names.emplace_back();
    } else if (!names.empty() && line.size() > 2 && line[0] == '|' && line[2] >= '0' &&
               line[2] <= '9') {
      const std::size_t begin = line.find('|', 1) + 2;
      names.back().push_back(line.substr(begin, line.find(' ', begin) - begin));
    }
  }
  ASSERT_EQ(names.size(), static_cast<std::size_t>(gs::wire::kLastUplink));
  for (std::size_t i = 0; i < names.size(); ++i) {
    EXPECT_EQ(names[i], field_names(static_cast<UplinkKind>(i + 1))) << i + 1;
  }
}

}  // namespace
}  // namespace gsbench::link
