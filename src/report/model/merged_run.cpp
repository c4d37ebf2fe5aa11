// SPDX-License-Identifier: BSL-1.0
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <utility>

#include <fmt/format.h>

#include <carom/collision/expects.hpp>
#include <carom/properties/trial/declared_effects.hpp>
#include <carom/report/model/answer_json.hpp>
#include <carom/report/model/merged_run.hpp>
#include <carom/report/model/words.hpp>

namespace carom::report {
namespace {

using properties::SubjectResult;
using properties::Witness;

[[noreturn]] void fail_different(const ReadShard& first, const ReadShard& other, const std::string& field,
                                 const std::string& of_first, const std::string& of_other) {
  throw MergeError(
      fmt::format("the shards do not belong to one run: {}: {} in {}, but {} in {}; merge only shards of the same run",
                  field, shown(of_first), shown(first.file), shown(of_other), shown(other.file)));
}

/// The facts that must be the same in all shards, by the name of the field.
std::vector<std::pair<std::string, std::string>> common_facts(const ReadShard& shard) {
  const properties::GateOptions& options = shard.report.options;
  std::vector<std::string> families;
  for (const auto* of_run : {&options.families, &options.beyond_domain}) {
    for (const properties::Family* family : *of_run) {
      families.emplace_back(family->name);
    }
  }
  std::vector<std::pair<std::string, std::string>> facts{
      {"number of shards", std::to_string(options.shard.of)},
      {"seed", std::to_string(options.seed)},
      {"cases of each family", std::to_string(options.cases)},
      {"families", listed(families)},
      {"within", properties::to_text(options.within)},
      {"yardstick", Json<oracles::Yardstick>::write(options.yardstick).dump()},
      {"relations_every", std::to_string(options.relations_every)},
      {"deviates", listed(shard.run.settings.deviates)}};
  std::vector<std::string> names;
  for (const SubjectResult& result : shard.report.results) {
    names.push_back(result.subject.name);
  }
  for (const Subject& subject : shard.run.absent) {
    names.push_back(subject.name + " (absent)");
  }
  facts.emplace_back("subjects", listed(names));
  for (std::size_t s = 0; s < shard.report.results.size(); ++s) {
    const Subject& subject = shard.report.results[s].subject;
    const std::string of = " of " + subject.name;
    facts.emplace_back("specification" + of, subject.specification);
    facts.emplace_back("version" + of, subject.version);
    facts.emplace_back("law" + of, std::string(name_of(subject.law)));
    facts.emplace_back("precision" + of, std::string(name_of(subject.precision)));
    facts.emplace_back("deviates" + of, listed(subject.deviates));
    facts.emplace_back("claims" + of, properties::to_text(subject.effects));
    facts.emplace_back("collision matrix" + of, subject.shows_collision_matrix ? "shown" : "not shown");
    facts.emplace_back("counts" + of, shard.run.subjects[s].counts ? "true" : "false");
  }
  return facts;
}

void require_one_run(const std::vector<ReadShard>& shards) {
  const auto expected = common_facts(shards[0]);
  for (const ReadShard& shard : shards) {
    const auto facts = common_facts(shard);
    for (std::size_t i = 0; i < std::min(facts.size(), expected.size()); ++i) {
      if (facts[i] != expected[i]) {
        fail_different(shards[0], shard, expected[i].first, expected[i].second, facts[i].second);
      }
    }
  }
}

void require_all_once(const std::vector<ReadShard>& shards) {
  const std::uint64_t of = shards[0].report.options.shard.of;
  std::vector<const ReadShard*> by_number(shards.size() + 1);
  for (const ReadShard& shard : shards) {
    const std::uint64_t number = shard.report.options.shard.number;
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

void add(SubjectResult& sum, const SubjectResult& part) {
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

/// The number of cases in the witness's family that violate the witness's invariant.
std::uint64_t violated_beside(const Witness& witness, const SubjectResult& result,
                              const std::vector<const properties::Family*>& families) {
  for (std::size_t f = 0; f < families.size(); ++f) {
    const auto count = result.families[f].counts.find(witness.invariant);
    if (families[f]->name == witness.family && count != result.families[f].counts.end()) {
      return count->second.violated;
    }
  }
  return 0;
}

/// One witness for each invariant, from all shards.
std::vector<Witness> best_witnesses(const SubjectResult& result,
                                    const std::vector<const properties::Family*>& families) {
  std::vector<Witness> best;
  for (const std::string& invariant : result.violated_invariants()) {
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
                                   shown(result.subject.name), invariant));
    }
    best.push_back(*chosen);
  }
  return best;
}

}  // namespace

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
    return x->report.options.shard.number < y->report.options.shard.number;
  });
  properties::GateReport report = ordered[0]->report;
  report.options.shard = {};
  for (std::size_t i = 1; i < ordered.size(); ++i) {
    const properties::GateReport& part = ordered[i]->report;
    for (std::size_t f = 0; f < report.coverage.size(); ++f) {
      report.coverage[f] += part.coverage[f];
    }
    report.features += part.features;
    for (std::size_t s = 0; s < report.results.size(); ++s) {
      add(report.results[s], part.results[s]);
    }
  }
  for (const properties::Family* family : report.options.families) {
    // The sample is drawn again, for the diagnoses.
    report.sampled.push_back(
        properties::drawn_sample(report.options.within, *family, report.options.seed,
                                 report.options.cases * static_cast<std::uint64_t>(family->weight)));
  }
  for (SubjectResult& result : report.results) {
    result.witnesses = best_witnesses(result, report.options.families);
    result.not_judged = properties::why_not_judged(result, report.options.families, report.coverage);
  }
  const Run& first = ordered[0]->run;
  std::vector<bool> counts;
  for (const JudgedSubject& subject : first.subjects) {
    counts.push_back(subject.counts);
  }
  Run merged = run_of(std::move(report), counts, first.absent, first.environment, first.settings.deviates, false);
  merged.settings.without_case = first.settings.without_case;
  return merged;
}

}  // namespace carom::report
