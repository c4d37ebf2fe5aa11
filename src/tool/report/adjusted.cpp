// SPDX-License-Identifier: GPL-3.0-or-later
#include "report/adjusted.hpp"

#include <fmt/format.h>

namespace carom::tool {

std::string adjusted_sentence(const properties::GateReport& report) {
  using properties::Adjustment;
  properties::Coverage all;
  for (const properties::Coverage& of_family : report.coverage) {
    all += of_family;
  }
  return fmt::format(
      "Families changed cases before anything was judged: in {} they enlarged moments, so that the contact lies on the "
      "body; {} they moved to the origin, so that parallel vectors are parallel; {} that separated they reversed; {} "
      "that left the domain they drew again.",
      all.adjusted[Adjustment::moments_enlarged], all.adjusted[Adjustment::moved_to_origin],
      all.adjusted[Adjustment::reversed], all.adjusted[Adjustment::drawn_again]);
}

}  // namespace carom::tool
