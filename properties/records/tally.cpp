// SPDX-License-Identifier: BSL-1.0
#include <algorithm>
#include <charconv>
#include <cmath>
#include <set>
#include <string_view>
#include <utility>

#include <carom/collision/validate.hpp>
#include <carom/properties/diagnosis/diagnosis.hpp>
#include <carom/properties/features/coverage.hpp>
#include <carom/properties/gate/in_words.hpp>
#include <carom/properties/records/tally.hpp>

namespace carom::properties::records {
namespace {

constexpr std::size_t most_unknown = 20;
constexpr std::size_t most_text = 1000;  // of a kept unknown field [bytes]

/// The first unknown fields, each cut to a short text. A record may have megabytes.
nlohmann::json shortened(const nlohmann::json& others) {
  nlohmann::json kept = nlohmann::json::object();
  for (const auto& [name, value] : others.items()) {
    if (kept.size() == most_unknown) {
      break;
    }
    const std::string text = value.dump(-1, ' ', true, nlohmann::json::error_handler_t::replace);
    kept[name] = text.size() <= most_text ? value : nlohmann::json(text.substr(0, most_text) + "…");
  }
  return kept;
}

double seriousness_of(const std::vector<Broken>& broken) {
  const auto less = [](const Broken& x, const Broken& y) { return x.ratio < y.ratio; };
  return std::max_element(broken.begin(), broken.end(), less)->ratio;
}

/// The number of the line or element at the end of a place in the file; 1 if the file is one record.
std::uint64_t number_of(const std::string& place, const std::string& file) {
  std::uint64_t number = 1;
  const std::string_view in_file = std::string_view(place).substr(std::min(file.size(), place.size()));
  std::from_chars(in_file.data() + in_file.find_last_not_of("0123456789") + 1, in_file.data() + in_file.size(), number);
  return number;
}

/// The law that most records satisfy, if this is more than a third of those that it judges. A log with a defect in some
/// contacts still shows its law in the others.
Law usual_law(const RecordsReport& report) {
  Law usual = Law::any;
  std::uint64_t most = 0;
  for (const Law law : all_laws) {
    if (law != Law::any && report.satisfied[law] > most && 3 * report.satisfied[law] > report.judged[law]) {
      usual = law;
      most = report.satisfied[law];
    }
  }
  return usual;
}

}  // namespace

void RecordTally::Values::add(const std::optional<double>& value) {
  if (value && std::isfinite(*value)) {
    sample.add(*value);
    least = std::min(least, *value);
    greatest = std::max(greatest, *value);
  }
}

Spread RecordTally::Values::spread() const {
  Spread spread{sample.count(), 0, least, greatest};
  std::vector<double> values = sample.values();
  if (!values.empty()) {
    const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
    std::nth_element(values.begin(), middle, values.end());
    spread.median = *middle;
    if (values.size() % 2 == 0) {
      spread.median = (*middle + *std::max_element(values.begin(), middle)) / 2;
    }
  }
  return spread;
}

void RecordTally::keep_if_worst(const std::string& place, Record record, std::vector<Broken> broken) {
  std::vector<PlacedRecord>& worst = report_.worst;
  const double own = seriousness_of(broken);
  if (worst.size() == most_worst && seriousness_of(worst.back().broken) >= own) {
    return;
  }
  const auto at = std::find_if(worst.begin(), worst.end(),
                               [&](const PlacedRecord& other) { return seriousness_of(other.broken) < own; });
  record.others = shortened(record.others);
  worst.insert(at, {place, std::move(record), std::move(broken)});
  if (worst.size() > most_worst) {
    worst.pop_back();
  }
}

void RecordTally::add(const std::string& place, Record record, JudgedRecord judged) {
  ++report_.records;
  for (const Law law : all_laws) {
    if (const std::optional<bool> satisfied = judged.satisfied[law]) {
      ++report_.judged[law];
      report_.satisfied[law] += *satisfied ? 1 : 0;
    }
  }
  restitution_.add(judged.implied.restitution);
  friction_.add(judged.implied.friction);
  tangential_restitution_.add(judged.implied.tangential_restitution);
  for (const auto& [name, value] : record.others.items()) {
    if (report_.unknown.size() < most_unknown) {
      report_.unknown.insert(name);
    }
  }
  Sampled sampled{record.collision, record.after, {}};
  std::set<const Invariant*> violated;
  for (const Broken& broken : judged.broken) {
    violated.insert(broken.invariant);
  }
  for (const Invariant* invariant : violated) {
    ++report_.violations[invariant];
    sampled.violated.push_back(invariant);
  }
  report_.hold_reversed += judged.holds_reversed ? 1 : 0;
  if (!judged.broken.empty()) {
    ++report_.violated;
    report_.violated_apart += judged.separates ? 1 : 0;
    if (report_.violated_at.size() < most_violated_at) {
      report_.violated_at.push_back(number_of(place, report_.file));
    }
    violated_.add(sampled);
    keep_if_worst(place, std::move(record), std::move(judged.broken));
  } else if (!judged.satisfied[report_.law]) {
    ++report_.not_judged;
  }
  sample_.add(std::move(sampled));
}

void RecordTally::add_faults(RecordsReport& report) const {
  constexpr std::uint64_t least_violated = 5;
  if (report.violated < least_violated) {
    return;
  }
  std::vector<const Sampled*> sample;
  for (const Sampled& one : sample_.values()) {
    // If few records are violated, the violated ones come from their own sample.
    if (one.violated.empty() || report.violated >= report.records / 10) {
      sample.push_back(&one);
    }
  }
  if (report.violated < report.records / 10) {
    for (const Sampled& one : violated_.values()) {
      sample.push_back(&one);
    }
  }
  static const Family recorded{.name = "recorded", .summary = "recorded collisions", .generate = nullptr};
  GateReport gate;
  gate.options.families = {&recorded};
  gate.coverage.resize(1);
  gate.sampled.resize(1);
  SubjectResult result;
  result.subject.name = report.file;
  result.subject.law = report.diagnosed_as;
  result.subject.precision = report.resolution.precision;
  FamilyResult& family = result.families.emplace_back();
  family.cases = sample.size();
  family.sampled = sample.size();
  for (std::size_t i = 0; i < sample.size(); ++i) {
    const Sampled& one = *sample[i];
    const Case posed{.collision = one.collision};
    const JudgedCase judged_case(posed);
    gate.sampled[0].push_back(sampled_case(judged_case, feature_places_of(one.collision)));
    const ReportedOutcome answer(reported(one.after));
    for (const Invariant* invariant : one.violated) {
      ++family.counts[invariant].violated;
      family.violated_cases[invariant].push_back(i);
      family.keep_answer(i, answer);
    }
    if (!one.violated.empty()) {
      ++family.violated;
      keep_if_first(family.first_violated, {i, posed, answer});
    }
  }
  gate.results.push_back(std::move(result));
  report.faults = diagnosis::diagnose(gate.results.front(), gate).faults;
}

RecordsReport RecordTally::report() const {
  RecordsReport report = report_;
  report.restitution = restitution_.spread();
  report.friction = friction_.spread();
  report.tangential_restitution = tangential_restitution_.spread();
  report.diagnosed_as = report.has_law ? report.law : usual_law(report);
  // No verdict depends on the faults.
  (void)why_failed([&] { add_faults(report); });
  return report;
}

}  // namespace carom::properties::records
