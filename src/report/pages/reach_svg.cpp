// SPDX-License-Identifier: BSL-1.0
#include <fmt/format.h>

#include <carom/collision/expects.hpp>
#include <carom/report/pages/reach_pages.hpp>
#include <carom/report/pictures/range_bars.hpp>
#include <carom/report/results/words.hpp>

namespace carom::report {
namespace {

Interval interval_of(const properties::Range& range) { return {range.least, range.most}; }

}  // namespace

std::string reach_svg(const MeasuredDomain& measured, const properties::Domain& beside,
                      const std::string& name_of_beside) {
  const auto& [subject, deviates, options, reach, effects] = measured;
  CAROM_EXPECTS(measured.is_known(), subject);
  RangePicture picture{
      fmt::format("The domain of {}", shown(subject)),
      fmt::format("For each quantity, a bar shows where {} holds if only this quantity leaves the core {}.",
                  shown(subject), to_text(options.core)),
      limit_in_words(options.limits),
      reach.stricter ? limit_in_words(*options.stricter) : "",
      beside.is_everything() ? "" : shown(name_of_beside),
      {}};
  for (const properties::LimitedQuantity quantity : properties::all_limited_quantities) {
    RangeBar bar{std::string(name_of(quantity)), std::string(unit_of(quantity)), !is_linear(quantity),
                 interval_of(properties::searched_range(quantity)),
                 interval_of(range_of(reach.ends, options.core, quantity))};
    if (reach.stricter && !reach.stricter->faces.empty()) {
      bar.loses_none = interval_of(range_of(*reach.stricter, options.core, quantity));
    }
    if (beside.ranges[quantity] != properties::whole_range(quantity)) {
      bar.beside = interval_of(beside.ranges[quantity]);
    }
    picture.bars.push_back(std::move(bar));
  }
  return range_bars(picture);
}

}  // namespace carom::report
