// The tables and examples of protocol.md against the code.
#include <head_test/rig.hpp>

#include <cstdio>
#include <fstream>
#include <map>
#include <sstream>

#include <gtest/gtest.h>

#include <head/fields.hpp>
#include <wire/frame.hpp>

namespace gs::head::test {
namespace {

std::vector<std::string> lines_of_text() {
  std::ifstream file(GSBENCH_SOURCE_DIR "/firmware/head/protocol.md");
  EXPECT_TRUE(file.is_open());
  std::vector<std::string> lines;
  for (std::string line; std::getline(file, line);) {
    lines.push_back(line);
  }
  return lines;
}

std::string hex(const Bytes& bytes) {
  std::string text;
  for (const std::uint8_t byte : bytes) {
    char digits[4];
    std::snprintf(digits, sizeof digits, "%02x", byte);
    text += (text.empty() ? "" : " ") + std::string(digits);
  }
  return text;
}

Bytes framed(const Bytes& message) {
  Bytes out(wire::kLongestFrame);
  out.resize(wire::frame(message.data(), message.size(), out.data(), out.size()));
  return out;
}

// Examples, from an emulated run.
std::vector<std::pair<std::string, Bytes>> goldens() {
  Status status;
  status.state = State::kPlaying;
  status.run = 7;
  status.expected = 5;
  status.position = 256;
  status.room = 3838;
  status.count = 2520000;
  status.echo = 9;
  status.edges = 1;
  status.closed = 1;
  Edge edge;
  edge.input = 0;
  edge.closed = true;
  edge.count = 1234567;
  return {{"hello", encoded(
                        [] {
                          Hello hello;
                          const Hardware board = hardware();
                          hello.flags = board.flags;
                          std::copy(board.board, board.board + sizeof hello.board, hello.board);
                          std::copy(board.unique_id, board.unique_id + kUniqueIdBytes,
                                    hello.unique_id);
                          hello.firmware_version = kFirmwareVersion;
                          hello.build = board.build;
                          hello.counts_per_sample = board.counts_per_sample;
                          return hello;
                        }(),
                        0)},
          {"identify", encoded(Identify{}, 0)},
          {"identify as a frame", framed(encoded(Identify{}, 0))},
          {"arm", encoded(Arm{7}, 1)},
          {"samples", encoded(samples_message(0, {0, 1000, -1000}), 2)},
          {"play", encoded(Play{512}, 4)},
          {"ping", encoded(Ping{9}, 5)},
          {"status", encoded(status, 11)},
          {"edge", encoded(edge, 12)},
          {"resend edges", encoded(ResendEdges{0}, 5)},
          {"refused", encoded(Refused{Refusal::kGap, 9, 6}, 13)},
          {"stop", encoded(Stop{}, 9)}};
}

// Each example is the line "**name**: …", and the next ```hex block.
TEST(ProtocolText, ExamplesAreTheEncodedMessages) {
  std::map<std::string, std::string> examples;
  std::string name;
  bool within = false;
  for (const std::string& line : lines_of_text()) {
    if (line.rfind("**", 0) == 0) {
      name = line.substr(2, line.find("**", 2) - 2);
    } else if (line == "```hex") {
      within = true;
    } else if (line.rfind("```", 0) == 0) {
      within = false;
    } else if (within) {
      std::string& example = examples[name];
      example += (example.empty() ? "" : " ") + line;
    }
  }
  std::map<std::string, std::string> expected;
  for (const auto& [one, bytes] : goldens()) {
    expected[one] = hex(bytes);
  }
  EXPECT_EQ(examples, expected);
}

// The types of the fields, as the text names them.
class TypeNames {
 public:
  template <class Integer>
  void operator()(Integer&) {
    names_.push_back((std::is_signed_v<Integer> ? "i" : "u") + std::to_string(8 * sizeof(Integer)));
  }
  void operator()(bool&) { names_.emplace_back("bool"); }
  void operator()(char (&)[kBoardBytes + 1]) { names_.emplace_back("16 bytes"); }
  void operator()(std::uint8_t (&)[kUniqueIdBytes]) { names_.emplace_back("12 bytes"); }
  template <class Enum>
  void choice(Enum&, Enum, Enum = Enum{}) {
    names_.emplace_back("u8");
  }
  void samples(std::int16_t (&)[kLongestSamples], std::uint16_t) {
    names_.emplace_back("i16 × count");
  }
  const std::vector<std::string>& names() const { return names_; }

 private:
  std::vector<std::string> names_;
};

// The second column of the first table after this heading.
std::vector<std::string> types_in_text(const std::string& heading) {
  std::vector<std::string> types;
  bool within = false;
  int row = 0;
  for (const std::string& line : lines_of_text()) {
    if (line.rfind("### ", 0) == 0) {
      within = line.rfind("### " + heading, 0) == 0;
    } else if (within && !line.empty() && line[0] == '|') {
      if (++row > 2) {
        const auto second = line.find('|', 1) + 2;
        types.push_back(line.substr(second, line.find(" |", second) - second));
      }
    } else if (within && row > 0) {
      break;
    }
  }
  return types;
}

template <class Message>
void expect_types() {
  char heading[4];
  std::snprintf(heading, sizeof heading, "%02x", static_cast<unsigned>(Message::kKind));
  TypeNames names;
  Message message;
  fields(message, names);
  EXPECT_EQ(types_in_text(heading), names.names()) << heading;
}

TEST(ProtocolText, TablesOfFieldsAreThoseOfTheCode) {
  expect_types<Identify>();
  expect_types<Arm>();
  expect_types<Samples>();
  expect_types<Play>();
  expect_types<Stop>();
  expect_types<Ping>();
  expect_types<ResendEdges>();
  expect_types<Hello>();
  expect_types<Status>();
  expect_types<Edge>();
  expect_types<Refused>();
}

// Rows "| 3 text … |" of the table with this head, by number.
std::size_t rows_of_table(const std::string& head) {
  bool within = false;
  std::size_t rows = 0;
  for (const std::string& line : lines_of_text()) {
    if (line.rfind(head, 0) == 0) {
      within = true;
    } else if (within && (line.empty() || line[0] != '|')) {
      break;
    } else if (within && line.rfind("|--", 0) != 0) {
      const std::size_t number = std::stoul(line.substr(2));
      EXPECT_EQ(number, rows + (head == "| reason | |" ? 1 : 0));
      ++rows;
    }
  }
  return rows;
}

TEST(ProtocolText, ListsAllStatesFaultsAndReasons) {
  EXPECT_EQ(rows_of_table("| state | output |"), static_cast<std::size_t>(kLastState) + 1);
  EXPECT_EQ(rows_of_table("| fault | cause |"), static_cast<std::size_t>(kLastFault) + 1);
  EXPECT_EQ(rows_of_table("| reason | |"), static_cast<std::size_t>(kLastRefusal));
}

}  // namespace
}  // namespace gs::head::test
