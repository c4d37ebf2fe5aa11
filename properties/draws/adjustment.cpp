// SPDX-License-Identifier: BSL-1.0
#include <carom/properties/draws/adjustment.hpp>

namespace carom::properties {

std::string_view name_of(Adjustment adjustment) {
  switch (adjustment) {
    case Adjustment::moments_enlarged:
      return "moments_enlarged";
    case Adjustment::moved_to_origin:
      return "moved_to_origin";
    case Adjustment::reversed:
      return "reversed";
    case Adjustment::drawn_again:
      return "drawn_again";
  }
  return "";
}

}  // namespace carom::properties
