// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <string_view>
#include <utility>

#include <carom/properties/invariants/invariant.hpp>

namespace carom::unit {

/// Replaces the check of an invariant in the list of all invariants. The destructor restores it. One thread at a time
/// may judge while this object is made or destroyed.
class PlantedFormula {
 public:
  PlantedFormula(std::string_view invariant, properties::Verdict (*check)(const properties::Evidence&))
      : planted_(const_cast<properties::Invariant&>(*properties::invariant_named(invariant))), right_(planted_.about) {
    std::get<properties::AboutOutcome>(planted_.about).check = check;
  }
  ~PlantedFormula() { planted_.about = std::move(right_); }
  PlantedFormula(const PlantedFormula&) = delete;
  PlantedFormula& operator=(const PlantedFormula&) = delete;

 private:
  properties::Invariant& planted_;  // an element of a vector, which is no const object
  decltype(properties::Invariant::about) right_;
};

}  // namespace carom::unit
