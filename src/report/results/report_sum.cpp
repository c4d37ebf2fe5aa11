// SPDX-License-Identifier: BSL-1.0
#include <algorithm>
#include <cstddef>
#include <cstdint>

#include <carom/collision/expects.hpp>
#include <carom/properties/gate/witness.hpp>
#include <carom/report/results/report_sum.hpp>

namespace carom::report {
namespace {

using properties::SubjectResult;

void add_result(SubjectResult& sum, const SubjectResult& part) {
  CAROM_EXPECTS(sum.subject.name == part.subject.name && sum.families.size() == part.families.size(), sum.subject.name,
                part.subject.name);
  const auto cases = static_cast<double>(sum.cases());
  const auto more = static_cast<double>(part.cases());
  if (cases + more > 0) {
    sum.nanoseconds_per_solve =
        (sum.nanoseconds_per_solve * cases + part.nanoseconds_per_solve * more) / (cases + more);
  }
  if (sum.error.empty()) {
    sum.error = part.error;
  }
  for (std::size_t f = 0; f < sum.families.size(); ++f) {
    sum.families[f] += part.families[f];
    sum.families[f].order_violated_cases();
  }
  if (sum.beyond_domain.size() < part.beyond_domain.size()) {
    sum.beyond_domain.resize(part.beyond_domain.size());
  }
  for (std::size_t f = 0; f < part.beyond_domain.size(); ++f) {
    sum.beyond_domain[f] += part.beyond_domain[f];
  }
  if (sum.error_beyond_domain.empty()) {
    sum.error_beyond_domain = part.error_beyond_domain;
  }
  sum.digits += part.digits;
  sum.witnesses.insert(sum.witnesses.end(), part.witnesses.begin(), part.witnesses.end());
}

/// The sampled cases of the family that belong to the shard. The other cases stay default-constructed.
std::vector<properties::SampledCase> sample_of(const properties::GateOptions& options,
                                               const properties::Family& family) {
  std::vector<properties::SampledCase> sample = properties::drawn_sample(
      options.within, family, options.seed, options.cases * static_cast<std::uint64_t>(family.weight));
  for (std::size_t index = 0; index < sample.size(); ++index) {
    if (index % options.shard.of != options.shard.number - 1) {
      sample[index] = {};
    }
  }
  return sample;
}

}  // namespace

void add_report(properties::GateReport& sum, const properties::GateReport& part) {
  CAROM_EXPECTS(sum.results.size() == part.results.size(), sum.results.size(), part.results.size());
  for (std::size_t f = 0; f < sum.coverage.size(); ++f) {
    sum.coverage[f] += part.coverage[f];
  }
  sum.features += part.features;
  sum.judge_error = sum.judge_error ? sum.judge_error : part.judge_error;
  for (std::size_t s = 0; s < sum.results.size(); ++s) {
    add_result(sum.results[s], part.results[s]);
  }
}

void complete_sum(properties::GateReport& sum, const properties::Shard& shard) {
  sum.options.shard = shard;
  sum.sampled.assign(sum.options.families.size(), {});
  // Only a report of violations reads the sample.
  const auto is_violated = [](const SubjectResult& result) { return !result.violated_invariants().empty(); };
  if (std::any_of(sum.results.begin(), sum.results.end(), is_violated)) {
    std::transform(sum.options.families.begin(), sum.options.families.end(), sum.sampled.begin(),
                   [&](const properties::Family* family) { return sample_of(sum.options, *family); });
  }
  properties::state_what_was_not_judged(sum);
}

void complete_run(properties::GateReport& sum, const properties::GateOptions& options,
                  const std::vector<Subject>& subjects) {
  CAROM_EXPECTS(sum.results.size() == subjects.size(), sum.results.size(), subjects.size());
  sum.options = options;
  sum.interrupted = options.stop.stop_requested();
  complete_sum(sum, options.shard);
  for (std::size_t s = 0; s < subjects.size(); ++s) {
    sum.results[s].subject = subjects[s];
    sum.results[s].witnesses.clear();
  }
  properties::add_witnesses(sum);
}

}  // namespace carom::report
