#include <algorithm>
#include <cmath>

#include <simulated/outlet.hpp>

namespace gsbench::simulated {

using models::ContactEdge;

Outlet::Outlet(const OutletParameters& parameters, const std::string& id, std::uint32_t index)
    : parameters_(parameters), index_(index) {
  gs::app::set_text(identity_.id, id.c_str());
  gs::app::set_text(identity_.board, "simulated");
  identity_.instance = index;
  identity_.build = GSBENCH_FIRMWARE_BUILD;
}

bool Outlet::start(std::int64_t sample_rate_hz, int nominal_hz, float noise_rms_pu,
                   std::uint64_t seed) {
  *this = Outlet(parameters_, identity_.id, index_);
  sample_rate_hz_ = sample_rate_hz;
  noise_rms_pu_ = noise_rms_pu;
  seed_ = seed;
  gs::outlet::Hardware hardware;
  hardware.sample_rate_hz = static_cast<std::int32_t>(sample_rate_hz);
  hardware.nominal_hz = nominal_hz;
  hardware.counts_per_pu = models::kCounts_per_pu;
  return app_.start(hardware, identity_, nullptr, collector_);
}

void Outlet::send(std::int64_t tick, const gs::wire::Downlink& message) {
  const std::int64_t delay =
      std::llround(parameters_.downlink_ms * 1e-3 * static_cast<double>(sample_rate_hz_));
  pending_.push_back({tick + delay, message});
}

void Outlet::feed(std::int64_t first_tick, const float* voltage_pu, std::size_t count) {
  const std::int64_t end_tick = first_tick + static_cast<std::int64_t>(count);
  std::int64_t tick = first_tick;
  while (tick < end_tick) {
    while (!pending_.empty() && pending_.front().tick <= tick) {
      app_.receive(pending_.front().message, collector_);
      pending_.pop_front();
    }
    const std::int64_t next =
        pending_.empty() ? end_tick : std::min(end_tick, pending_.front().tick);
    feed_undisturbed(tick, voltage_pu + (tick - first_tick), static_cast<std::size_t>(next - tick));
    tick = next;
  }
  follow_relay();
}

void Outlet::feed_undisturbed(std::int64_t first_tick, const float* voltage_pu, std::size_t count) {
  // Small enough for the cache, and a multiple of the noise batches.
  constexpr std::size_t kChunk = 2048;
  const models::Stream stream{seed_, models::kSourceNoise, index_};
  volts_.resize(kChunk);
  samples_.resize(kChunk);
  for (std::size_t done = 0; done < count; done += kChunk) {
    const std::size_t length = std::min(kChunk, count - done);
    std::copy_n(voltage_pu + done, length, volts_.begin());
    if (noise_rms_pu_ > 0.0F) {
      models::add_gaussian(stream, static_cast<std::uint64_t>(first_tick) + done, length,
                           noise_rms_pu_, volts_.data());
    }
    std::transform(volts_.begin(), volts_.begin() + static_cast<std::ptrdiff_t>(length),
                   samples_.begin(),
                   [](float volts) { return models::adc_counts(volts, models::kCounts_per_pu); });
    app_.feed(samples_.data(), length, collector_);
  }
}

// The coil changes at the sample that the firmware reports.
void Outlet::follow_relay() {
  for (; relay_changes_read_ < collector_.messages.size(); ++relay_changes_read_) {
    const gs::wire::Uplink& message = collector_.messages[relay_changes_read_];
    if (message.kind == gs::wire::UplinkKind::kRelay) {
      turn_coil(static_cast<std::int64_t>(message.sample), message.relay.closed);
    }
  }
}

// The contact follows by the relay model. If the coil turns back before the contact has moved, the
// contact does not move.
void Outlet::turn_coil(std::int64_t coil_tick, bool closes) {
  const std::uint64_t change = coil_changes_++;
  if (coil_tick < contact_moves_tick_) {
    edges_.erase(std::find_if(edges_.begin(), edges_.end(),
                              [&](const ContactEdge& e) { return e.tick >= contact_moves_tick_; }),
                 edges_.end());
    contact_moves_tick_ = coil_tick;
    return;
  }
  const models::Stream stream{seed_, models::kRelayModel, index_};
  const std::vector<ContactEdge> edges =
      contact_edges(parameters_.relay, stream, change, coil_tick, closes, sample_rate_hz_);
  contact_moves_tick_ = edges.front().tick;
  edges_.insert(edges_.end(), edges.begin(), edges.end());
}

void Outlet::take_messages(std::vector<gs::wire::Uplink>& messages) {
  follow_relay();
  messages.insert(messages.end(), collector_.messages.begin(), collector_.messages.end());
  collector_.messages.clear();
  relay_changes_read_ = 0;
}

void Outlet::take_edges(std::vector<ContactEdge>& edges, std::int64_t up_to_tick) {
  const auto future = std::find_if(edges_.begin(), edges_.end(),
                                   [&](const ContactEdge& e) { return e.tick >= up_to_tick; });
  edges.insert(edges.end(), edges_.begin(), future);
  edges_.erase(edges_.begin(), future);
}

}  // namespace gsbench::simulated
