// SPDX-License-Identifier: BSL-1.0
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include <carom/collision/expects.hpp>
#include <carom/properties/gate/declared_effects.hpp>
#include <carom/properties/gate/witness.hpp>
#include <carom/report/results/merged_run.hpp>
#include <carom/report/results/values_json.hpp>
#include <carom/report/results/words.hpp>

namespace carom::report {
namespace {

using properties::SubjectResult;
using properties::Witness;

/// The facts that are the same in all shards of a run, in words. Each has the name of its field.
using RunFacts = std::vector<std::pair<std::string, std::string>>;

RunFacts run_facts(const Run& run) {
  const properties::GateOptions& options = run.options;
  std::vector<std::string> families;
  for (const auto* of_run : {&options.families, &options.beyond_domain}) {
    for (const properties::Family* family : *of_run) {
      families.emplace_back(family->name);
    }
  }
  RunFacts facts{{"number of shards", std::to_string(options.shard.of)},
                 {"seed", std::to_string(options.seed)},
                 {"cases of each family", std::to_string(options.cases)},
                 {"families", listed(families)},
                 {"within", properties::to_text(options.within)},
                 {"yardstick", Json<oracles::Limits>::write(options.limits).dump()},
                 {"relations_every", std::to_string(options.relations_every)},
                 {"deviates", listed(run.deviates)}};
  std::vector<std::string> names;
  for (const properties::SubjectResult& result : run.results) {
    names.push_back(result.subject.name);
  }
  for (const Subject& subject : run.absent) {
    names.push_back(subject.name + " (absent)");
  }
  facts.emplace_back("subjects", listed(names));
  for (std::size_t s = 0; s < run.results.size(); ++s) {
    const Subject& subject = run.results[s].subject;
    const std::string of = " of " + subject.name;
    facts.emplace_back("specification" + of, subject.specification);
    facts.emplace_back("version" + of, subject.version);
    facts.emplace_back("law" + of, std::string(name_of(subject.law)));
    facts.emplace_back("precision" + of, std::string(name_of(subject.precision)));
    facts.emplace_back("deviates" + of, listed(subject.deviates));
    facts.emplace_back("claims" + of, properties::to_text(subject.effects));
    facts.emplace_back("collision matrix" + of, subject.shows_collision_matrix ? "shown" : "not shown");
    facts.emplace_back("counts" + of, run.counts[s] ? "true" : "false");
  }
  return facts;
}

void require_one_run(const std::vector<ReadShard>& shards) {
  const RunFacts expected = run_facts(shards[0].run);
  for (const ReadShard& shard : shards) {
    const RunFacts facts = run_facts(shard.run);
    for (std::size_t i = 0; i < std::min(expected.size(), facts.size()); ++i) {
      if (expected[i] != facts[i]) {
        throw MergeError(fmt::format(
            "the shards do not belong to one run: {}: {} in {}, but {} in {}; merge only shards of the same run",
            expected[i].first, shown(expected[i].second), shown(shards[0].file), shown(facts[i].second),
            shown(shard.file)));
      }
    }
  }
}

void require_all_once(const std::vector<ReadShard>& shards) {
  const std::uint64_t of = shards[0].run.options.shard.of;
  std::vector<const ReadShard*> by_number(shards.size() + 1);
  for (const ReadShard& shard : shards) {
    const std::uint64_t number = shard.run.options.shard.number;
    if (number > shards.size()) {
      continue;
    }
    if (by_number[number] != nullptr) {
      throw MergeError(fmt::format("shard {} of {} occurs twice: {} and {}; give each shard once", number, of,
                                   shown(by_number[number]->file), shown(shard.file)));
    }
    by_number[number] = &shard;
  }
  for (std::uint64_t number = 1; number <= of; ++number) {
    if (number >= by_number.size() || by_number[number] == nullptr) {
      throw MergeError(fmt::format("shard {} of {} is missing; give the directories of all shards", number, of));
    }
  }
}

/// The number of cases in the witness's family that violate the witness's invariant.
std::uint64_t violated_beside(const Witness& witness, const SubjectResult& result,
                              const std::vector<const properties::Family*>& families) {
  for (std::size_t f = 0; f < families.size(); ++f) {
    const auto count = result.families[f].counts.find(witness.invariant);
    if (families[f] == witness.family && count != result.families[f].counts.end()) {
      return count->second.violated;
    }
  }
  return 0;
}

/// One witness for each invariant, from all shards.
std::vector<Witness> best_witnesses(const SubjectResult& result,
                                    const std::vector<const properties::Family*>& families) {
  std::vector<Witness> best;
  for (const properties::Invariant* invariant : result.violated_invariants()) {
    const Witness* chosen = nullptr;
    for (const Witness& witness : result.witnesses) {
      if (witness.invariant != invariant) {
        continue;
      }
      const auto rank = [&](const Witness& one) {
        return std::pair(violated_beside(one, result, families),
                         properties::seriousness(one.verdict, one.shrunk.collision));
      };
      if (chosen == nullptr || rank(witness) > rank(*chosen)) {
        chosen = &witness;
      }
    }
    if (chosen == nullptr) {
      throw MergeError(fmt::format("{} violates {}, but no shard has a witness of this; run the shards again",
                                   shown(result.subject.name), invariant->name));
    }
    best.push_back(*chosen);
  }
  return best;
}

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
    sum.families[f].order_cases();
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

/// Makes the sum a report of `shard`, which consists of the added shards: draws its sample, and states if too few cases
/// were judged.
void complete_sum(properties::GateReport& sum, const properties::Shard& shard) {
  sum.options.shard = shard;
  sum.sampled.assign(sum.options.families.size(), {});
  // Only the diagnosis of violations and the hint for many skips read the sample.
  const auto is_explained = [&](const SubjectResult& result) {
    return !result.violated_invariants().empty() || skips_too_many(result, sum.coverage);
  };
  if (std::any_of(sum.results.begin(), sum.results.end(), is_explained)) {
    std::transform(sum.options.families.begin(), sum.options.families.end(), sum.sampled.begin(),
                   [&](const properties::Family* family) { return sample_of(sum.options, *family); });
  }
  properties::state_what_was_not_judged(sum);
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

Run merged_run(const std::vector<ReadShard>& shards) {
  if (shards.empty()) {
    throw MergeError("no shards are given; give the directories of all shards");
  }
  require_one_run(shards);
  require_all_once(shards);
  std::vector<const ReadShard*> ordered;
  for (const ReadShard& shard : shards) {
    ordered.push_back(&shard);
  }
  std::sort(ordered.begin(), ordered.end(), [](const ReadShard* x, const ReadShard* y) {
    return x->run.options.shard.number < y->run.options.shard.number;
  });
  Run merged = ordered[0]->run;
  for (std::size_t i = 1; i < ordered.size(); ++i) {
    add_report(merged, ordered[i]->run);
  }
  complete_sum(merged, {});
  for (SubjectResult& result : merged.results) {
    result.witnesses = best_witnesses(result, merged.options.families);
  }
  merged.is_shard = false;
  return diagnosed(std::move(merged));
}

}  // namespace carom::report
