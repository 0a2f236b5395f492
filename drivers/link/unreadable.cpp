#include <cmath>
#include <limits>
#include <type_traits>

#include <link/unreadable.hpp>
#include <wire/cbor.hpp>
#include <wire/codec.hpp>
#include <wire/fields.hpp>

namespace gsbench::link {
namespace {

namespace cbor = gs::wire::cbor;
using gs::wire::UplinkKind;

constexpr const char* kCutOff = "is cut off, or has an indefinite length";

std::string text_of(float value) {
  return std::isnan(value) ? "NaN" : std::to_string(value);
}

// Visits the fields of wire/fields.hpp, and stops at the first that is missing, of another type or
// out of range. codec.cpp does the same without reasons.
class Reason {
 public:
  Reason(cbor::Reader& reader, std::size_t items, std::vector<std::string> names)
      : reader_(reader), items_(items), names_(std::move(names)) {}

  void operator()(bool& value) {
    if (next() && !reader_.boolean(value)) {
      refuse_type("is not a bool");
    }
  }
  void operator()(float& value) {
    if (next() && !reader_.single(value)) {
      refuse_type("is not a 32-bit float");
    }
  }
  void operator()(std::int32_t& value) {
    constexpr std::int64_t kLeast = std::numeric_limits<std::int32_t>::min();
    constexpr std::int64_t kMost = std::numeric_limits<std::int32_t>::max();
    std::int64_t wide = 0;
    if (!next()) {
      return;
    }
    if (!reader_.integer(wide)) {
      refuse_type("is not an integer");
    } else if (wide < kLeast || wide > kMost) {
      refuse_range(std::to_string(wide), kLeast, kMost);
    } else {
      value = static_cast<std::int32_t>(wide);
    }
  }
  template <class T>
  void operator()(T& value) {
    static_assert(std::is_unsigned_v<T>);
    read(value, T{0}, static_cast<T>(-1));
  }
  template <std::size_t N>
  void operator()(char (&text)[N]) {
    if (next() && !reader_.text(text, N - 1)) {
      refuse_type("is not text of at most " + std::to_string(N - 1) +
                  " printable ASCII characters");
    }
  }
  template <class E>
  void choice(E& value, E last, E first = E{}) {
    std::uint8_t raw = 0;
    read(raw, static_cast<std::uint8_t>(first), static_cast<std::uint8_t>(last));
    value = static_cast<E>(raw);
  }

  void finish() {
    for (; why_.empty() && items_ > 0; --items_) {
      if (!reader_.skip()) {
        why_ = std::string("an item after its fields ") + kCutOff;
      }
    }
    if (why_.empty() && reader_.left() > 0) {
      why_ = std::to_string(reader_.left()) + " bytes follow its array";
    }
  }

  const std::string& why() const { return why_; }

 private:
  bool next() {
    if (!why_.empty()) {
      return false;
    }
    name_ = names_[at_++];
    if (items_ == 0) {
      why_ = name_ + " is missing";
      return false;
    }
    --items_;
    return true;
  }

  template <class T>
  void read(T& value, T least, T most) {
    std::uint64_t wide = 0;
    if (!next()) {
      return;
    }
    if (!reader_.unsigned_integer(wide)) {
      refuse_type("is not an unsigned integer");
    } else if (wide < least || wide > most) {
      refuse_range(std::to_string(wide), std::uint64_t{least}, std::uint64_t{most});
    } else {
      value = static_cast<T>(wide);
    }
  }

  void refuse_type(const std::string& why) {
    cbor::Reader copy = reader_;
    why_ = name_ + ' ' + (copy.skip() ? why : kCutOff);
  }
  template <class T>
  void refuse_range(const std::string& value, T least, T most) {
    why_ = name_ + " is " + value + ", not " + std::to_string(least) + " … " + std::to_string(most);
  }

  cbor::Reader& reader_;
  std::size_t items_;
  std::vector<std::string> names_;
  std::size_t at_ = 0;
  std::string name_;
  std::string why_;
};

// Ranges that the types do not have. Empty: all fields are within them.
std::string out_of_range(const gs::wire::Hello& hello) {
  if (hello.id[0] == '\0') {
    return "id is empty";
  }
  gs::wire::Hello id_only = hello;
  id_only.protocol_version = 0;
  if (!gs::wire::is_valid(id_only)) {
    return "id is \"" + std::string(hello.id) +
           "\", which has other characters than letters, digits, '-', '_' and '.'";
  }
  if (hello.sample_rate_hz < gs::wire::kLeastSampleRate_hz ||
      hello.sample_rate_hz > gs::wire::kMostSampleRate_hz) {
    return "sample_rate_hz is " + std::to_string(hello.sample_rate_hz) + ", not " +
           std::to_string(gs::wire::kLeastSampleRate_hz) + " … " +
           std::to_string(gs::wire::kMostSampleRate_hz);
  }
  if (hello.nominal_hz != 50 && hello.nominal_hz != 60) {
    return "nominal_hz is " + std::to_string(hello.nominal_hz) + ", not 50 or 60";
  }
  for (const auto& [name, delay_s] : {std::pair("tracker_delay_s", hello.tracker_delay_s),
                                      std::pair("voltage_delay_s", hello.voltage_delay_s)}) {
    if (!(delay_s >= 0.0F && delay_s <= gs::wire::kLongestDelay_s)) {
      return std::string(name) + " is " + text_of(delay_s) + ", not 0 … 1";
    }
  }
  return "";
}

std::string fault(const std::string& why) {
  return "sent a message that cannot be read: " + why;
}

}  // namespace

std::vector<std::string> field_names(UplinkKind kind) {
  switch (kind) {
    case UplinkKind::kHello:
      return {"protocol_version",
              "id",
              "start_number",
              "board",
              "instance",
              "firmware_version",
              "build",
              "capabilities",
              "sample_rate_hz",
              "nominal_hz",
              "tracker_delay_s",
              "voltage_delay_s",
              "settings_version",
              "settings_digest",
              "session",
              "next_number"};
    case UplinkKind::kSettingsAnswer:
      return {"error", "version", "digest", "kept"};
    case UplinkKind::kMeasurement:
      return {"frequency_hz", "rocof_hz_s", "voltage_pu", "validity"};
    case UplinkKind::kEvent:
      return {"baseline_hz", "baseline_rocof_hz_s"};
    case UplinkKind::kLse:
      return {"loss_mw"};
    case UplinkKind::kEstimate:
      return {"loss_mw", "loss_sigma_mw", "loss_instant_s", "trust"};
    case UplinkKind::kDecision:
      return {"loss_mw",        "loss_sigma_mw", "nadir_hz", "required_mw",
              "shed_before_mw", "hits",          "trust",    "shed"};
    case UplinkKind::kRelay:
      return {"closed", "cause"};
    case UplinkKind::kAborted:
      return {};
    case UplinkKind::kCommandAnswer:
      return {"request", "closed", "session"};
    case UplinkKind::kStatus:
      return {"reports",      "relay_closed", "cause",           "phase",
              "samples_lost", "messages_bad", "messages_unsent", "messages_dropped"};
    case UplinkKind::kSelfTest:
      return {"failed", "fingerprint"};
    case UplinkKind::kEcho:
      return {"token"};
    case UplinkKind::kError:
      return {"code", "detail"};
  }
  return {};
}

std::string unreadable_fault(const std::uint8_t* bytes, std::size_t size) {
  if (size > gs::wire::kLongestMessage) {
    return fault("it has " + std::to_string(size) + " bytes, more than " +
                 std::to_string(gs::wire::kLongestMessage));
  }
  cbor::Reader reader(bytes, size);
  std::size_t items = 0;
  if (!reader.array(items)) {
    return fault("it is not a whole CBOR array of definite length");
  }
  std::uint64_t number = 0;
  if (items == 0 || !reader.unsigned_integer(number)) {
    return fault("its kind is not an unsigned integer");
  }
  const bool known = number > 0 && number <= static_cast<std::uint64_t>(gs::wire::kLastUplink);
  gs::wire::Uplink message;
  message.kind = known ? static_cast<UplinkKind>(number) : gs::wire::kLastUplink;
  const bool is_hello = message.kind == UplinkKind::kHello;
  std::vector<std::string> names = {"sequence", "sample"};
  if (!is_hello) {
    names.emplace_back("start_number");
  }
  for (std::string& name : field_names(message.kind)) {
    names.push_back(std::move(name));
  }
  Reason reason(reader, items - 1, std::move(names));
  std::uint32_t sequence = 0;
  reason(sequence);
  gs::wire::uplink_head(message, reason);
  if (known) {
    gs::wire::uplink_fields(message, reason);
  }
  reason.finish();
  const std::string why =
      reason.why().empty() && is_hello ? out_of_range(message.hello) : reason.why();
  if (is_hello) {
    return "its hello cannot be read: " + why;
  }
  return fault(
      (known ? gs::wire::to_string(message.kind) : "unknown kind " + std::to_string(number)) +
      ", " + why);
}

}  // namespace gsbench::link
