// SHA-256 of the fields of a record, in their order. All NaNs are equal, and so are 0 and -0,
// because SQLite does not distinguish them.
#include "seals.hpp"

#include <QCryptographicHash>
#include <algorithm>
#include <cmath>
#include <limits>
#include <type_traits>

#include <record/store.hpp>

namespace gsbench::record {
namespace {

template <class Float>
Float canonical(Float value) {
  if (std::isnan(value)) {
    return std::numeric_limits<Float>::quiet_NaN();
  }
  return value + Float{0};  // -0 becomes 0
}

class Digest {
 public:
  // With `stored`, the fields of a file only.
  explicit Digest(const StoredFields* stored = nullptr) : stored_(stored) {}

  template <class Field>
  void add(const Field& field) {
    if constexpr (std::is_same_v<Field, double>) {
      const double plain = canonical(field);
      add_bytes(&plain, sizeof plain);
    } else if constexpr (std::is_integral_v<Field> || std::is_enum_v<Field>) {
      const auto whole = static_cast<std::uint64_t>(field);
      add_bytes(&whole, sizeof whole);
    } else {  // a text or a column
      add(field.size());
      add_values(field);
    }
  }

  template <class Values>
  void add_values(const Values& values) {
    if constexpr (std::is_floating_point_v<typename Values::value_type>) {
      Values plain = values;
      for (auto& value : plain) {
        value = canonical(value);
      }
      add_bytes(plain.data(), plain.size() * sizeof plain[0]);
    } else {
      add_bytes(values.data(), values.size() * sizeof values[0]);
    }
  }

  template <class Part>
  void add_fields(const Part& part) {
    visit_fields<Part>(part, [&](const char* name, const auto& field) {
      if (stored_ == nullptr || is_stored<Part>(name)) {
        add_field<table_name<Part> == nullptr>(field);
      }
    });
  }

  template <class Part>
  bool is_stored(const char* name) const {
    if constexpr (table_name<Part> == nullptr) {
      return stored_->has_column(name);
    } else {
      return stored_->has(table_name<Part>, name);
    }
  }

  // An empty column of a trace is not stored and counts as none, except in version 6.
  template <bool kOfATrace, class Field>
  void add_field(const Field& field) {
    if constexpr (kOfATrace) {
      if (field.empty() && (stored_ == nullptr || !stored_->is_sealed_as_whole())) {
        return;
      }
    }
    add(field);
  }

  template <class Part>
  void add_parts(const std::vector<Part>& parts) {
    add(parts.size());
    for (const Part& part : parts) {
      add_fields(part);
    }
  }

  // Without outlets, run id and wall-clock times.
  void add_content(const RunRecord& head) {
    visit_content(head, [&](const char*, const auto& field) { add(field); });
    add_parts_of_head(head);
  }

  void add_parts_of_head(const RunRecord& head) {
    add_parts(head.clocks);
    add_parts(head.comparisons);
    add_fields(head.reference);
    add_parts(head.stimulus);
  }

  void add_results(const OutletRecord& outlet) {
    add_fields(outlet);
    add(outlet.settings.size());
    for (const auto& [name, value] : outlet.settings) {
      add(name);
      add(value);
    }
    add_parts(outlet.measurements);
  }

  void add_reports(const Reports& reports) {
    add_parts(reports.marks);
    add_fields(reports.trace);
    add_fields(reports.estimates);
  }

  std::string hexadecimal() const { return hash_.result().toHex().toStdString(); }

 private:
  void add_bytes(const void* data, std::size_t size) {
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

  const StoredFields* stored_;
  QCryptographicHash hash_{QCryptographicHash::Sha256};
};

}  // namespace

std::string seal_of_run(const RunRecord& head, bool complete, const std::string& seals_of_outlets,
                        const StoredFields* stored) {
  Digest digest(stored);
  digest.add(complete);
  digest.add_fields(head);
  digest.add_parts_of_head(head);
  if (!seals_of_outlets.empty()) {
    digest.add(seals_of_outlets);
  }
  return digest.hexadecimal();
}

std::string seal_of_results(const OutletRecord& outlet, const StoredFields* stored) {
  Digest digest(stored);
  digest.add_results(outlet);
  return digest.hexadecimal();
}

std::string seal_of_reports(const std::string& before, const Reports& reports,
                            const StoredFields* stored) {
  Digest digest(stored);
  digest.add(before);
  digest.add_reports(reports);
  digest.add_parts(reports.sent);
  return digest.hexadecimal();
}

std::string seal_of_whole(const OutletRecord& outlet, const StoredFields& stored) {
  Digest digest(&stored);
  digest.add_results(outlet);
  digest.add_reports(outlet.reports);
  return digest.hexadecimal();
}

struct ContentDigest::Impl {
  Digest digest;
  std::map<std::string, Digest> columns;  // of the outlet's traces, whose length is not known yet
};

ContentDigest::ContentDigest() : impl_(std::make_unique<Impl>()) {}
ContentDigest::~ContentDigest() = default;

void ContentDigest::add_traces(const Reports& piece) {
  const auto add = [this](const char* name, const auto& column) {
    impl_->columns[name].add_values(column);
  };
  visit_fields<MeasurementTrace>(piece.trace, add);
  visit_fields<EstimateTrace>(piece.estimates, add);
}

void ContentDigest::add_outlet(const OutletRecord& outlet) {
  impl_->digest.add_results(outlet);
  impl_->digest.add_parts(outlet.reports.marks);
  impl_->digest.add_parts(outlet.reports.sent);
  add_traces({});  // an outlet without any piece has the same digest as one with empty traces
  for (const auto& [name, column] : impl_->columns) {
    impl_->digest.add(column.hexadecimal());
  }
  impl_->columns.clear();
}

std::string ContentDigest::of(const RunRecord& head) {
  impl_->digest.add_content(head);
  return impl_->digest.hexadecimal();
}

std::string content_digest(const RunRecord& run) {
  ContentDigest digest;
  for (const OutletRecord& outlet : run.outlets) {
    digest.add_traces(outlet.reports);
    digest.add_outlet(outlet);
  }
  return digest.of(run);
}

}  // namespace gsbench::record
