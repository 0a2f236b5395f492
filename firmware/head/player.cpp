#include <head/player.hpp>

namespace gs::head {

void Player::switch_off() {
  state_ = State::kOff;
  fault_ = Fault::kNone;
  samples_.clear();  // no interrupt takes samples now
}

void Player::forget() {
  has_begun_ = false;
  position_ = 0;
}

void Player::arm() {
  samples_.clear();
  forget();
  prefill_ = 0;
  fed_ = true;
  state_ = State::kArmed;
}

std::uint64_t Player::position() const {
  // Two words: an interrupt can change them between the two reads. It then has run to its end
  // before the second pair of reads.
  std::uint64_t position = position_;
  for (std::uint64_t again = position_; again != position; again = position_) {
    position = again;
  }
  return position;
}

void Player::next_codes(std::uint64_t first_count, std::uint16_t* out, std::size_t count) {
  if (fed_) {
    fed_ = false;
    silent_codes_ = 0;
  }
  if (state_ == State::kArmed && prefill_ != 0 && samples_.used() >= prefill_) {
    begin(first_count);
  }
  for (std::size_t i = 0; i < count; ++i) {
    watch();
    out[i] = next_code();
  }
  codes_ = codes_ + static_cast<std::uint32_t>(count);
}

void Player::begin(std::uint64_t count) {
  std::int16_t sample = 0;
  samples_.take(sample);
  interpolator_.begin(sample);
  begin_count_ = count;
  has_begun_ = true;
  enter(State::kPlaying);
}

void Player::watch() {
  if (is_active() && silent_codes_++ == kWatchdogCodes) {
    watchdog_trips_ = watchdog_trips_ + 1;
    fail(Fault::kWatchdog);
  }
}

std::uint16_t Player::next_code() {
  if (state_ != State::kPlaying) {
    return kMidScale;
  }
  if (interpolator_.needs_sample()) {
    std::int16_t sample = 0;
    if (!samples_.take(sample)) {
      underruns_ = underruns_ + 1;
      fail(Fault::kUnderrun);
      return kMidScale;
    }
    interpolator_.add(sample);
  }
  if (interpolator_.at_sample()) {
    position_ = position_ + 1;
  }
  return interpolator_.next();
}

void Player::fail(Fault fault) {
  if (is_active()) {
    fault_ = fault;
    enter(State::kFaulted);
  }
}

void Player::enter(State state) {
  state_ = state;
  changes_ = changes_ + 1;
}

}  // namespace gs::head
