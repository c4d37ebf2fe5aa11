// SPDX-License-Identifier: BSL-1.0
#include <array>

#include <fmt/format.h>

#include <carom/properties/features/coverage.hpp>
#include <carom/report/pages/parts.hpp>

namespace carom::report {
namespace {

struct Counted {
  const char* name;
  std::uint64_t properties::Coverage::*count;
};

using properties::Coverage;
constexpr std::array counted{Counted{"cases", &Coverage::cases},
                             Counted{"colliding", &Coverage::colliding},
                             Counted{"resting", &Coverage::resting},
                             Counted{"separating", &Coverage::separating},
                             Counted{"inert", &Coverage::inert},
                             Counted{"invalid", &Coverage::invalid},
                             Counted{"one wall", &Coverage::one_immovable},
                             Counted{"spheres", &Coverage::spheres},
                             Counted{"head-on", &Coverage::head_on},
                             Counted{"ε = 0", &Coverage::inelastic},
                             Counted{"ε = 1", &Coverage::elastic}};

Cell number_cell(std::uint64_t number) { return Cell(std::to_string(number), number == 0 ? "number zero" : "number"); }

}  // namespace

Table coverage_table(const Run& run) {
  Table table{"Cases of each family, by kind of contact", {{"family"}}, {}};
  for (const Counted& one : counted) {
    table.columns.push_back({one.name, true});
  }
  for (std::size_t f = 0; f < run.coverage.size(); ++f) {
    Cell name{std::string(run.options.families[f]->name)};
    name.small = run.options.families[f]->summary;
    Row row{{std::move(name)}};
    for (const Counted& one : counted) {
      row.cells.push_back(number_cell(run.coverage[f].*one.count));
    }
    table.rows.push_back(std::move(row));
  }
  return table;
}

std::string features_in_words(const Run& run) {
  const std::string met = fmt::format("{} pairs of features in colliding cases", run.features.met_pairs());
  return run.options.within.is_everything()
             ? fmt::format("{} (20,000 cases of each family have {})", met, properties::pairs_of_long_run)
             : met;
}

Table features_table(const Run& run) {
  Table table{"Number of colliding cases with each feature, over all families",
              {{"feature"}, {"definition"}, {"cases", true}},
              {}};
  for (std::size_t i = 0; i < properties::all_features().size(); ++i) {
    const properties::Feature& feature = properties::all_features()[i];
    table.rows.push_back({{std::string(feature.name), Cell(std::string(feature.statement), "word"),
                           number_cell(run.features.count(i))}});
  }
  return table;
}

}  // namespace carom::report
