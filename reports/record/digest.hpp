// SHA-256 over the fields of a record, in their order. Numbers count by value: every NaN is the
// same, and so are 0 and -0, since SQLite keeps neither apart.
#pragma once

#include <QCryptographicHash>
#include <cstdint>
#include <string>
#include <vector>

#include <record/run_record.hpp>

namespace gsbench::record {

class Digest {
 public:
  void add(const std::string& text);
  void add(std::int64_t value);
  void add(std::uint64_t value);
  void add(double value);
  void add(bool value);
  void add(Verdict verdict);
  void add(const std::vector<std::int64_t>& ticks);
  void add(const std::vector<float>& values);
  void add(const std::vector<double>& values);
  void add(const std::vector<std::uint8_t>& values);

  void add_content(const RunRecord& head);  // no outlets, no run id, no wall-clock stamps
  void add(const OutletRecord& outlet);

  std::string hexadecimal() const;

 private:
  void add_bytes(const void* data, std::size_t size);

  QCryptographicHash hash_{QCryptographicHash::Sha256};
};

// Seals of what one owner has stored.
std::string seal_of_run(const RunRecord& head, bool complete);
std::string seal_of_outlet(const OutletRecord& outlet);

}  // namespace gsbench::record
