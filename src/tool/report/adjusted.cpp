// SPDX-License-Identifier: BSL-1.0
#include "report/adjusted.hpp"

#include <fmt/format.h>

namespace carom::tool {

std::string adjusted_sentences(const properties::GateReport& report) {
  using properties::Adjustment;
  properties::Coverage all;
  for (const properties::Coverage& of_family : report.coverage) {
    all += of_family;
  }
  return fmt::format(
      "Families changed some cases after they drew them. They enlarged moments in {} cases, so that the contact lies "
      "on the body. They moved {} cases to the origin, so that parallel vectors are parallel. They reversed {} cases "
      "that separated. They drew {} cases again that left the domain.",
      all.adjusted[Adjustment::moments_enlarged], all.adjusted[Adjustment::moved_to_origin],
      all.adjusted[Adjustment::reversed], all.adjusted[Adjustment::drawn_again]);
}

}  // namespace carom::tool
