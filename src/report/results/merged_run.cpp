// SPDX-License-Identifier: BSL-1.0
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <utility>

#include <fmt/format.h>

#include <carom/report/results/merged_run.hpp>
#include <carom/report/results/report_sum.hpp>
#include <carom/report/results/run_facts.hpp>
#include <carom/report/results/words.hpp>

namespace carom::report {
namespace {

using properties::SubjectResult;
using properties::Witness;

[[noreturn]] void fail_different(const ReadShard& first, const ReadShard& other, const FactDifference& difference) {
  throw MergeError(fmt::format(
      "the shards do not belong to one run: {}: {} in {}, but {} in {}; merge only shards of the same run",
      difference.field, shown(difference.first), shown(first.file), shown(difference.second), shown(other.file)));
}

void require_one_run(const std::vector<ReadShard>& shards) {
  const RunFacts expected = run_facts(shards[0].run);
  for (const ReadShard& shard : shards) {
    if (const std::optional<FactDifference> difference = first_difference(expected, run_facts(shard.run))) {
      fail_different(shards[0], shard, *difference);
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
