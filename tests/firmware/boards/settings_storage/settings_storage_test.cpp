#include <firmware_test/settings.hpp>
#include <firmware_test/simulated_flash.hpp>
#include <settings_storage/settings_storage.hpp>

#include <functional>
#include <optional>
#include <vector>

#include <gtest/gtest.h>

#include <outlet/crc32.hpp>
#include <wire/codec.hpp>

namespace gs::settings_storage {
namespace {

using test::SimulatedFlash;

constexpr std::size_t kSequenceAt = 4;
constexpr std::size_t kSettingsAt = 12;

outlet::Settings settings(std::uint32_t version) {
  outlet::Settings settings = test::ieee24_settings();
  settings.version = version;
  settings.accumulated_mw = 10.0F * static_cast<float>(version);
  // Different lengths, so that the CRC is at different offsets.
  settings.condition_rows = static_cast<std::uint8_t>(settings.condition_rows - version % 3);
  return settings;
}

using Load = std::function<std::optional<outlet::Settings>(Flash&)>;

std::optional<outlet::Settings> load(Flash& flash) {
  outlet::Settings loaded;
  if (!FlashSettingsStorage(flash).load(loaded)) {
    return std::nullopt;
  }
  return loaded;
}

std::uint32_t version_in(Flash& flash) {
  const auto loaded = load(flash);
  return loaded ? loaded->version : 0;
}

// Cuts power at each step of storing version 3 over version 2. Returns the number of steps after
// which neither version was valid.
template <class FlashUnderTest>
int steps_that_leave_neither(const Load& load_after) {
  int neither = 0;
  for (int step = 0;; ++step) {
    FlashUnderTest flash;
    FlashSettingsStorage storage(flash);
    EXPECT_TRUE(storage.keep(settings(1)));
    if (!storage.keep(settings(2))) {
      ++neither;
    }
    flash.cut_power_after(step);
    const bool kept = storage.keep(settings(3));
    const bool finished = flash.has_power();
    flash.restore_power();
    const auto found = load_after(flash);
    const bool old_or_new = found && (outlet::digest(*found) == outlet::digest(settings(2)) ||
                                      outlet::digest(*found) == outlet::digest(settings(3)));
    if (!old_or_new || (kept && found->version != 3)) {
      ++neither;
    }
    if (finished) {
      EXPECT_GT(step, 100) << "a set has more than 50 words of two steps each";
      return neither;
    }
  }
}

class StoredSettings : public testing::Test {
 protected:
  SimulatedFlash flash_;
  FlashSettingsStorage storage_{flash_};
};

TEST(SettingsStorage, IsEmptyAndUsableWhenNew) {
  SimulatedFlash flash;
  EXPECT_FALSE(load(flash));
  EXPECT_TRUE(FlashSettingsStorage(flash).usable());
}

TEST_F(StoredSettings, LoadsTheNewestSet) {
  for (std::uint32_t version = 1; version <= 5; ++version) {
    ASSERT_TRUE(storage_.keep(settings(version)));
    const auto found = load(flash_);
    ASSERT_TRUE(found);
    EXPECT_EQ(outlet::digest(*found), outlet::digest(settings(version)));
    EXPECT_TRUE(storage_.usable());
  }
  // Both slots share the wear.
  EXPECT_EQ(flash_.erases(0), 3);
  EXPECT_EQ(flash_.erases(1), 2);
}

TEST(SettingsStorage, ALossOfPowerAtAnyStepLeavesTheOldOrTheNewSet) {
  EXPECT_EQ(steps_that_leave_neither<SimulatedFlash>(load), 0);
}

TEST(SettingsStorage, StoresTheNextSetAfterALossOfPowerAtAnyStep) {
  for (int step = 0;; ++step) {
    SimulatedFlash flash;
    FlashSettingsStorage storage(flash);
    ASSERT_TRUE(storage.keep(settings(1)));
    flash.cut_power_after(step);
    storage.keep(settings(2));
    const bool finished = flash.has_power();
    flash.restore_power();
    ASSERT_TRUE(storage.usable()) << step;
    // A second loss of power must not destroy the valid set.
    const std::uint32_t before = version_in(flash);
    flash.cut_power_after(step / 2);
    storage.keep(settings(3));
    flash.restore_power();
    ASSERT_GE(version_in(flash), before) << step;
    ASSERT_TRUE(storage.keep(settings(4))) << step;
    ASSERT_EQ(version_in(flash), 4U) << step;
    if (finished) {
      break;
    }
  }
}

TEST(SettingsStorage, ALossOfPowerWhileStoringTheFirstSetLeavesItOrNone) {
  for (int step = 0;; ++step) {
    SimulatedFlash flash;
    FlashSettingsStorage storage(flash);
    flash.cut_power_after(step);
    storage.keep(settings(1));
    const bool finished = flash.has_power();
    flash.restore_power();
    EXPECT_LE(version_in(flash), 1U);
    if (finished) {
      EXPECT_EQ(version_in(flash), 1U);
      break;
    }
  }
}

// Proofs of the checks above: deliberate defects must be detected.

class ErasesTheOtherSlot final : public SimulatedFlash {
 public:
  bool erase(int slot) override {
    SimulatedFlash::erase(slot);
    return SimulatedFlash::erase(1 - slot);
  }
};

TEST(SettingsStorage, ErasingTheSlotInUseFailsTheLossOfPowerTest) {
  EXPECT_GT(steps_that_leave_neither<ErasesTheOtherSlot>(load), 0);
}

std::optional<outlet::Settings> load_without_crc(Flash& flash) {
  const bool has[2] = {flash.read(0, 0) != 0xFFFFFFFFU, flash.read(1, 0) != 0xFFFFFFFFU};
  const int slot =
      has[1] && (!has[0] || flash.read(1, kSequenceAt) > flash.read(0, kSequenceAt)) ? 1 : 0;
  std::vector<std::uint8_t> bytes;
  for (std::size_t at = kSettingsAt; at < kSettingsAt + wire::kLongestMessage; at += 4) {
    for (int shift = 0; shift < 32; shift += 8) {
      bytes.push_back(static_cast<std::uint8_t>(flash.read(slot, at) >> shift));
    }
  }
  outlet::Settings found;
  if (wire::decode(bytes.data(), bytes.size(), found) != wire::Decoded::kOk) {
    return std::nullopt;
  }
  return found;
}

TEST(SettingsStorage, LoadingWithoutTheCrcFailsTheLossOfPowerTest) {
  EXPECT_GT(steps_that_leave_neither<SimulatedFlash>(load_without_crc), 0);
}

TEST(SettingsStorage, LoadsTheOldSetIfABitOfTheNewOneIsCorrupt) {
  for (std::size_t offset = 0; offset < 64; offset += 4) {
    SimulatedFlash flash;
    FlashSettingsStorage storage(flash);
    ASSERT_TRUE(storage.keep(settings(1)));
    ASSERT_TRUE(storage.keep(settings(2)));
    flash.word(1, offset) ^= 1U << (offset % 32);
    EXPECT_EQ(version_in(flash), 1U) << offset;
  }
}

TEST_F(StoredSettings, IsNotUsableIfTheOnlySetIsCorrupt) {
  ASSERT_TRUE(storage_.keep(settings(1)));
  flash_.word(0, 40) ^= 4U;
  EXPECT_FALSE(load(flash_));
  EXPECT_FALSE(storage_.usable());
  EXPECT_TRUE(storage_.keep(settings(2)));
  EXPECT_TRUE(storage_.usable());
}

TEST_F(StoredSettings, AProgrammingFailureIsReportedAndLeavesTheOldSet) {
  ASSERT_TRUE(storage_.keep(settings(1)));
  flash_.refuse_to_program(true);
  EXPECT_FALSE(storage_.keep(settings(2)));
  EXPECT_FALSE(storage_.keep(settings(3)));
  EXPECT_EQ(version_in(flash_), 1U);
  flash_.refuse_to_program(false);
  EXPECT_TRUE(storage_.keep(settings(4)));
  EXPECT_EQ(version_in(flash_), 4U);
}

// The lowest bit of the magic, which is 1, always reads 0.
class HasAStuckBit final : public SimulatedFlash {
 public:
  bool program(int slot, std::size_t offset, std::uint32_t value) override {
    return SimulatedFlash::program(slot, offset, slot == 1 && offset == 0 ? value & ~1U : value);
  }
};

TEST(SettingsStorage, StoringFailsIfTheFlashReadsBackDifferently) {
  HasAStuckBit flash;
  FlashSettingsStorage storage(flash);
  ASSERT_TRUE(storage.keep(settings(1)));
  EXPECT_FALSE(storage.keep(settings(2)));
  EXPECT_EQ(version_in(flash), 1U);
}

// Changes one word of a valid slot and updates the CRC.
void rewrite(SimulatedFlash& flash, int slot, std::size_t changed_at, std::uint32_t changed) {
  const std::uint32_t length = flash.read(slot, 8);
  outlet::Crc32 crc;
  std::size_t at = 0;
  for (; at < kSettingsAt + (length + 3) / 4 * 4; at += 4) {
    if (at == changed_at) {
      flash.word(slot, at) = changed;
    }
    const std::uint32_t word = flash.read(slot, at);
    for (int shift = 0; shift < 32; shift += 8) {
      crc.add(static_cast<std::uint8_t>(word >> shift));
    }
  }
  flash.word(slot, at) = crc.value();
}

TEST_F(StoredSettings, LoadsTheOlderSetIfTheNewestCannotBeDecoded) {
  ASSERT_TRUE(storage_.keep(settings(1)));
  ASSERT_TRUE(storage_.keep(settings(2)));
  rewrite(flash_, 1, kSettingsAt, 0);  // like another firmware's format
  EXPECT_EQ(version_in(flash_), 1U);
}

TEST_F(StoredSettings, FindsTheNewestSetWhenSequenceNumbersWrap) {
  ASSERT_TRUE(storage_.keep(settings(1)));
  // As after 2^32 − 1 sets.
  rewrite(flash_, 0, kSequenceAt, 0xFFFFFFFFU);
  ASSERT_EQ(version_in(flash_), 1U);
  ASSERT_TRUE(storage_.keep(settings(2)));
  EXPECT_EQ(flash_.read(1, kSequenceAt), 0U);
  EXPECT_EQ(version_in(flash_), 2U);
  ASSERT_TRUE(storage_.keep(settings(3)));
  EXPECT_EQ(version_in(flash_), 3U);
}

}  // namespace
}  // namespace gs::settings_storage
