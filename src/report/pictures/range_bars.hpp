// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <optional>
#include <string>
#include <vector>

namespace carom::report {

/// From `low` to `high`.
struct Interval {
  double low;
  double high;
};

/// The values of one quantity, and those with which a solver holds.
struct RangeBar {
  std::string name;
  std::string unit;  // empty for a number without a unit
  bool is_logarithmic;
  Interval searched;                        // the whole bar
  Interval holds;                           // with the limit of the picture
  std::optional<Interval> loses_none = {};  // holds with the stricter limit
  std::optional<Interval> beside = {};      // a range to compare with, drawn as a thin line
};

struct RangePicture {
  std::string title;
  std::string description;  // for readers who do not see the picture
  std::string limit;        // such as "3 digits"
  std::string stricter;     // a limit such as "32 ulps"; empty for none
  std::string beside;       // the name of the thin lines; empty for none
  std::vector<RangeBar> bars;
};

/// An SVG with one bar for each quantity. The parts of a bar say where the solver holds, loses digits (if the picture
/// has a stricter limit), and fails. All logarithmic bars share an axis. All linear bars share another. Preconditions:
/// every bar has `low` < `high` in `searched`, and a logarithmic bar has `low` > 0 there.
[[nodiscard]] std::string range_bars(const RangePicture& picture);

}  // namespace carom::report
