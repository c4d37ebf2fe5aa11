// SPDX-License-Identifier: BSL-1.0
#include <algorithm>
#include <cstddef>

#include <carom/properties/gate/declared_effects.hpp>
#include <carom/report/results/answer_json.hpp>
#include <carom/report/results/run_facts.hpp>
#include <carom/report/results/words.hpp>

namespace carom::report {

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

std::optional<FactDifference> first_difference(const RunFacts& first, const RunFacts& second) {
  for (std::size_t i = 0; i < std::min(first.size(), second.size()); ++i) {
    if (first[i] != second[i]) {
      return FactDifference{first[i].first, first[i].second, second[i].second};
    }
  }
  return std::nullopt;
}

}  // namespace carom::report
