// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <random>
#include <set>
#include <string>
#include <vector>

#include <carom/properties/diagnosis/fault.hpp>
#include <carom/properties/records/judged_record.hpp>

namespace carom::properties::records {

/// A sample of fixed size. Each added value is as likely to be in it as any other. The same values give the same
/// sample.
template <class T>
class Sample {
 public:
  explicit Sample(std::size_t most) : most_(most) {}

  void add(T value) {
    ++count_;
    if (values_.size() < most_) {
      values_.push_back(std::move(value));
    } else if (const std::uint64_t place = random_() % count_; place < most_) {
      values_[place] = std::move(value);
    }
  }
  [[nodiscard]] std::uint64_t count() const { return count_; }  // of the added values
  [[nodiscard]] const std::vector<T>& values() const { return values_; }

 private:
  std::size_t most_;
  std::uint64_t count_ = 0;
  std::vector<T> values_;
  std::mt19937_64 random_;
};

/// The values that records imply for a coefficient. The other members have no meaning if `count` is 0.
struct Spread {
  std::uint64_t count = 0;
  double median = 0;  // of a sample, if the values are many
  double least = 0;
  double greatest = 0;
};

struct PlacedRecord {
  std::string place;  // "records.jsonl:3"
  Record record;
  std::vector<Broken> broken;
};

/// The results of all records of a file. Their size does not grow with the number of records.
struct RecordsReport {
  std::string file;
  Law law = Law::any;
  bool has_law = false;  // whether the user named the law
  Resolution resolution;
  std::uint64_t records = 0;
  std::uint64_t violated = 0;
  std::uint64_t not_judged = 0;
  std::uint64_t violated_apart = 0;        // violated records whose bodies do not approach
  std::uint64_t hold_reversed = 0;         // records that hold with −N
  std::vector<std::uint64_t> violated_at;  // the lines or elements of the first violated records
  PerLaw<std::uint64_t> judged{};          // records that were judged by each law
  PerLaw<std::uint64_t> satisfied{};       // the number of those records that satisfy it
  PerInvariant<std::uint64_t> violations;
  Spread restitution;
  Spread friction;
  Spread tangential_restitution;
  std::vector<PlacedRecord> worst;  // the worst first
  std::set<std::string> unknown;    // fields that no law reads
  Law diagnosed_as = Law::any;      // the law of the diagnosis
  std::vector<diagnosis::Fault> faults;
  std::string error;         // why the file was not read to its end; empty if it was
  bool interrupted = false;  // by the user

  [[nodiscard]] std::uint64_t held() const { return records - violated - not_judged; }
};

inline constexpr std::size_t most_worst = 10;
inline constexpr std::size_t most_violated_at = 10'000;

class RecordTally {
 public:
  /// The law by which the records are judged, and what describes the file.
  explicit RecordTally(RecordsReport head) : report_(std::move(head)) {}

  /// Adds records in the order of the file.
  void add(const std::string& place, Record record, JudgedRecord judged);

  /// The results so far, with the likely faults. This takes time.
  [[nodiscard]] RecordsReport report() const;

 private:
  struct Sampled {
    Collision collision;
    Outcome<double> after;
    std::vector<const Invariant*> violated;
  };
  struct Values {
    Sample<double> sample{10'000};
    double least = std::numeric_limits<double>::infinity();
    double greatest = -std::numeric_limits<double>::infinity();

    void add(const std::optional<double>& value);
    [[nodiscard]] Spread spread() const;
  };

  void keep_if_worst(const std::string& place, Record record, std::vector<Broken> broken);
  void add_faults(RecordsReport& report) const;

  RecordsReport report_;
  Values restitution_;
  Values friction_;
  Values tangential_restitution_;
  Sample<Sampled> sample_{1000};   // of all records
  Sample<Sampled> violated_{200};  // of the violated ones
};

}  // namespace carom::properties::records
