// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <string_view>

#include <carom/collision/precision.hpp>
#include <carom/report/pictures/plot.hpp>

namespace carom::report {

/// The colour of a method's precision, which is the same in all pictures.
[[nodiscard]] constexpr std::string_view colour_of(Precision precision) {
  switch (precision) {
    case Precision::binary32:
      return orange;
    case Precision::binary64:
      return blue;
    case Precision::extended:
      break;
  }
  return green;
}

/// In a dark page a picture is dark too: this rule inverts lightness, and keeps hues.
inline constexpr std::string_view dark_style =
    "@media (prefers-color-scheme: dark) { svg { filter: invert(0.93) hue-rotate(180deg) } }";

}  // namespace carom::report
