// SPDX-License-Identifier: BSL-1.0
#include <fmt/format.h>

#include "commands/commands.hpp"
#include "compare/comparison_html.hpp"
#include "compare/comparison_markdown.hpp"
#include "compare/comparison_record.hpp"
#include "compare/comparison_text.hpp"

namespace carom::tool {

int compare_files(const CompareArguments& arguments) {
  const compare::Comparison comparison =
      compare::compare_reports(compare::read_report(arguments.before), compare::read_report(arguments.now));
  if (arguments.format == "json") {
    fmt::print("{}\n", compare::comparison_record(comparison).dump(2));
  } else if (arguments.format == "markdown") {
    fmt::print("{}", compare::comparison_markdown(comparison));
  } else if (arguments.format == "html") {
    fmt::print("{}", compare::comparison_html(comparison));
  } else {
    fmt::print("{}", compare::comparison_text(comparison));
  }
  return comparison.count_new(false) > 0 ? exit_violated : exit_all_hold;
}

}  // namespace carom::tool
