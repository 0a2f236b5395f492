#include <algorithm>
#include <chrono>
#include <cmath>

#include <emulation/wire.hpp>

namespace gsbench::emulation {
namespace {

constexpr auto kInterval = std::chrono::milliseconds(2);
constexpr std::int64_t kMostAtOnce = 512;  // steps, 8 ms
// A contact moves at least 6.5 ms after its coil, so edges are known so far ahead.
constexpr std::int64_t kAhead = 384;  // steps, 6 ms
constexpr double kWirePi = 3.14159265358979323846;
constexpr double kSqrt2 = 1.41421356237309504880;

}  // namespace

Wire::Wire(Terminals& terminals, Output& output, const TrueTime& time, const WireOptions& options)
    : terminals_(terminals),
      output_(output),
      time_(time),
      options_(options),
      contacts_(terminals.size()) {
  // Bilinear transform of 1/(s² + √2·s + 1), exact at the cut-off frequency.
  const double k = std::tan(kWirePi * options.cutoff_hz / TrueTime::kRate_hz);
  const double denominator = 1.0 + kSqrt2 * k + k * k;
  b0_ = k * k / denominator;
  a1_ = 2.0 * (k * k - 1.0) / denominator;
  a2_ = (1.0 - kSqrt2 * k + k * k) / denominator;
  // Gain and scale to per unit of the nominal peak are part of the filter: it is linear.
  b0_ *= options.gain / (options.nominal_v * kSqrt2);
  terminals.connect(TrueTime::kRate_hz, {0.0F, options.seed});
  thread_ = std::thread([this] { run(); });
}

Wire::~Wire() {
  ending_ = true;
  thread_.join();
}

double Wire::worst_lateness_s() const {
  return static_cast<double>(worst_lateness_steps_) / TrueTime::kRate_hz;
}

void Wire::run() {
  while (!ending_) {
    bring_up_to(time_.now());
    std::this_thread::sleep_for(kInterval);
  }
}

void Wire::bring_up_to(std::int64_t now_step) {
  while (step_ < now_step && !ending_) {
    const auto count = static_cast<std::size_t>(std::min(now_step - step_, kMostAtOnce));
    voltage_.resize(count);
    output_.render(step_, count, voltage_.data());
    filter();
    terminals_.feed(voltage_.data(), count);
    if (options_.on_voltage) {
      options_.on_voltage(voltage_.data(), count);
    }
    step_ += static_cast<std::int64_t>(count);
    look_ahead();
    pass_edges();
  }
}

void Wire::filter() {
  for (float& sample : voltage_) {
    const auto in = static_cast<double>(sample);
    const double out = b0_ * in + z1_;
    z1_ = 2.0 * b0_ * in - a1_ * out + z2_;
    z2_ = b0_ * in - a2_ * out;
    sample = static_cast<float>(out);
  }
}

void Wire::look_ahead() {
  const std::int64_t now_step = time_.now();
  const std::lock_guard<std::mutex> lock(contacts_mutex_);
  for (std::size_t i = 0; i < contacts_.size(); ++i) {
    edges_.clear();
    terminals_.take_edges(i, step_ + kAhead, edges_);
    for (const models::ContactEdge& edge : edges_) {
      worst_lateness_steps_ = std::max<std::int64_t>(worst_lateness_steps_, now_step - edge.tick);
      contacts_[i].ahead.push_back(edge);
    }
  }
}

void Wire::pass_edges() {
  for (std::size_t i = 0; i < contacts_.size(); ++i) {
    edges_.clear();
    {
      const std::lock_guard<std::mutex> lock(contacts_mutex_);
      Contact& contact = contacts_[i];
      for (; !contact.ahead.empty() && contact.ahead.front().tick < step_;
           contact.ahead.pop_front()) {
        contact.closed = contact.ahead.front().closed;
        edges_.push_back(contact.ahead.front());
      }
    }
    for (const models::ContactEdge& edge : edges_) {
      if (options_.on_edge) {
        options_.on_edge(i, edge.tick, edge.closed);
      }
    }
  }
}

bool Wire::contact_closed(std::size_t outlet) const {
  const std::int64_t now_step = time_.now();
  const std::lock_guard<std::mutex> lock(contacts_mutex_);
  const Contact& contact = contacts_[outlet];
  bool closed = contact.closed;
  for (const models::ContactEdge& edge : contact.ahead) {
    closed = edge.tick <= now_step ? edge.closed : closed;
  }
  return closed;
}

}  // namespace gsbench::emulation
