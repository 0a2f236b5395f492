#include "digest.hpp"

#include "fields.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include <record/store.hpp>

namespace gsbench::record {
namespace {

template <class Float>
Float canonical(Float value) {
  if (std::isnan(value)) return std::numeric_limits<Float>::quiet_NaN();
  return value + Float{0};  // -0 becomes 0
}

template <class Float>
std::vector<Float> canonical(std::vector<Float> values) {
  for (Float& value : values) value = canonical(value);
  return values;
}

}  // namespace

void Digest::add_bytes(const void* data, std::size_t size) {
  // QCryptographicHash counts in int.
  constexpr std::size_t kPiece = std::size_t{1} << 30U;
  const char* bytes = static_cast<const char*>(data);
  while (size > 0) {
    const std::size_t piece = std::min(size, kPiece);
    hash_.addData(bytes, static_cast<int>(piece));
    bytes += piece;
    size -= piece;
  }
}

void Digest::add(std::uint64_t value) {
  add_bytes(&value, sizeof(value));
}
void Digest::add(std::int64_t value) {
  add(static_cast<std::uint64_t>(value));
}
void Digest::add(bool value) {
  add(static_cast<std::uint64_t>(value));
}
void Digest::add(Verdict verdict) {
  add(static_cast<std::uint64_t>(verdict));
}

void Digest::add(double value) {
  const double plain = canonical(value);
  add_bytes(&plain, sizeof(plain));
}

void Digest::add(const std::string& text) {
  add(static_cast<std::uint64_t>(text.size()));
  add_bytes(text.data(), text.size());
}

void Digest::add(const std::vector<std::int64_t>& ticks) {
  add(static_cast<std::uint64_t>(ticks.size()));
  add_bytes(ticks.data(), ticks.size() * sizeof(std::int64_t));
}

void Digest::add(const std::vector<float>& values) {
  add(static_cast<std::uint64_t>(values.size()));
  const std::vector<float> plain = canonical(values);
  add_bytes(plain.data(), plain.size() * sizeof(float));
}

void Digest::add(const std::vector<double>& values) {
  add(static_cast<std::uint64_t>(values.size()));
  const std::vector<double> plain = canonical(values);
  add_bytes(plain.data(), plain.size() * sizeof(double));
}

void Digest::add(const std::vector<std::uint8_t>& values) {
  add(static_cast<std::uint64_t>(values.size()));
  add_bytes(values.data(), values.size());
}

namespace {

template <class Part>
void add_fields(Digest& digest, const Part& part) {
  Fields<Part>::visit(part, [&](const char*, const auto& field) { digest.add(field); });
}

template <class Part>
void add_parts(Digest& digest, const std::vector<Part>& parts) {
  digest.add(static_cast<std::uint64_t>(parts.size()));
  for (const Part& part : parts) add_fields(digest, part);
}

}  // namespace

void Digest::add_content(const RunRecord& head) {
  Fields<RunRecord>::visit_content(head, [&](const char*, const auto& field) { add(field); });
  add_parts(*this, head.comparisons);
  add_fields(*this, head.truth);
  add_parts(*this, head.stimulus);
}

void Digest::add(const OutletRecord& outlet) {
  add_fields(*this, outlet);
  add(static_cast<std::uint64_t>(outlet.settings.size()));
  for (const auto& [name, value] : outlet.settings) {
    add(name);
    add(value);
  }
  add_parts(*this, outlet.measurements);
  add_parts(*this, outlet.marks);
  add_fields(*this, outlet.trace);
  add_fields(*this, outlet.estimates);
}

std::string Digest::hexadecimal() const {
  return hash_.result().toHex().toStdString();
}

std::string seal_of_run(const RunRecord& head, bool complete) {
  Digest digest;
  digest.add(complete);
  digest.add(head.run_id);
  digest.add(head.started_utc);
  digest.add(head.finished_utc);
  digest.add_content(head);
  return digest.hexadecimal();
}

std::string seal_of_outlet(const OutletRecord& outlet) {
  Digest digest;
  digest.add(outlet);
  return digest.hexadecimal();
}

std::string content_digest(const RunRecord& run) {
  Digest digest;
  digest.add_content(run);
  digest.add(static_cast<std::uint64_t>(run.outlets.size()));
  for (const OutletRecord& outlet : run.outlets) digest.add(outlet);
  return digest.hexadecimal();
}

}  // namespace gsbench::record
