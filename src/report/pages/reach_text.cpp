// SPDX-License-Identifier: BSL-1.0
#include <algorithm>

#include <fmt/format.h>

#include <carom/properties/gate/in_words.hpp>
#include <carom/properties/gate/unjudged.hpp>
#include <carom/report/pages/document.hpp>
#include <carom/report/pages/reach_pages.hpp>
#include <carom/report/results/version.hpp>
#include <carom/report/results/words.hpp>

namespace carom::report {
namespace {

using properties::Face;

std::string witness_text(const properties::Witness& witness) {
  return fmt::format("{}\n  {}\n", properties::in_words(witness.shrunk.collision, "  ").substr(2),
                     shown(properties::in_words(witness.verdict)));
}

std::string end_in_words(double end) { return fmt::format("{:.3g}", end); }

/// The end of the same range with the stricter limits.
std::string stricter_end(const properties::Ends& stricter, const Face& face) {
  const auto found = std::find_if(stricter.faces.begin(), stricter.faces.end(), [&](const Face& other) {
    return other.quantity == face.quantity && other.is_upper == face.is_upper;
  });
  return found == stricter.faces.end() ? "" : end_in_words(found->end);
}

Table table_of(const MeasuredDomain& measured) {
  const properties::WidestDomain& reach = measured.reach;
  const bool has_stricter = reach.stricter && !reach.stricter->faces.empty();
  Table table{"The ends of each range", {{"quantity"}, {"end"}, {"holds to", true}}, {}};
  if (has_stricter) {
    table.columns.push_back({"at " + limit_in_words(*measured.options.stricter), true});
  }
  table.columns.push_back({"in the domain", true});
  table.columns.push_back({"violated beyond"});
  for (const Face& face : reach.ends.faces) {
    const properties::Range& range = reach.domain.ranges[face.quantity];
    std::vector<Cell> row{
        {std::string(name_of(face.quantity))}, {face.is_upper ? "most" : "least"}, {end_in_words(face.end)}};
    if (has_stricter) {
      row.push_back({stricter_end(*reach.stricter, face)});
    }
    row.push_back({end_in_words(face.is_upper ? range.most : range.least)});
    row.push_back({face.beyond          ? std::string(face.beyond->invariant->name)
                   : face.error.empty() ? std::string("the search ends here")
                                        : "error: " + shown(face.error)});
    table.rows.push_back({std::move(row)});
  }
  return table;
}

/// Empty if the stricter limits hold in the core, or if there is none.
std::string stricter_in_core(const MeasuredDomain& measured) {
  const std::optional<properties::Ends>& stricter = measured.reach.stricter;
  if (!stricter || !stricter->faces.empty()) {
    return "";
  }
  const std::string limit = limit_in_words(*measured.options.stricter);
  return stricter->in_core
             ? fmt::format("\nAt {}, the subject violates {} where the search starts.\n\n  {}", limit,
                           stricter->in_core->invariant->name, witness_text(*stricter->in_core))
             : fmt::format("\nAt {}, the subject could not be judged: {}\n", limit, shown(stricter->error));
}

}  // namespace

std::string reach_text(const MeasuredDomain& measured) {
  const auto& [subject, deviates, options, reach, declared] = measured;
  const std::string effects = properties::to_text(declared);
  std::string text =
      fmt::format("Carom {}: the domain of {}, seed {}, limit {}\nThe search starts from {}.\n{}{}\n", version,
                  shown(subject), options.seed, limit_in_words(options.limits), to_text(options.core),
                  deviates.empty() ? "" : fmt::format("Not judged: {}.\n", fmt::join(deviates, ", ")),
                  effects.empty() ? "" : fmt::format("Judged without its declared effects: {}.\n", effects));
  if (!reach.ends.error.empty()) {
    return text + fmt::format("The subject could not be judged in these ranges: {}\n", shown(reach.ends.error));
  }
  if (reach.ends.in_core) {
    return text + fmt::format(
                      "The subject violates {} in these ranges, so it has no domain around them. Choose other "
                      "ranges by --core.\n\n  {}",
                      reach.ends.in_core->invariant->name, witness_text(*reach.ends.in_core));
  }
  text += in_text({table_of(measured)});
  text += fmt::format(
      "\n*holds to*: only this quantity leaves the core. *in the domain*: all quantities leave it together{}.\n\n"
      "{}\n\nNo violation in {} fresh cases of this domain. A defect that shows in fewer than 3 of "
      "so many cases can be missed.\n",
      reach.share < 1 ? fmt::format(", {:.0f} % of the way", 100 * reach.share) : "", to_text(reach.domain),
      reach.cases);
  for (const properties::Unjudged reason : properties::all_reasons_unjudged) {
    if (reach.unjudged[reason] > 0) {
      text += fmt::format("{} of the cases were not judged: {}.\n", reach.unjudged[reason], in_words(reason));
    }
  }
  text += stricter_in_core(measured);
  for (const Face& face : reach.ends.faces) {
    if (face.beyond) {
      text +=
          fmt::format("\n{} {} {:.3g}: violates {}\n  {}", name_of(face.quantity), face.is_upper ? "above" : "below",
                      face.end, face.beyond->invariant->name, witness_text(*face.beyond));
    }
  }
  return text;
}

}  // namespace carom::report
