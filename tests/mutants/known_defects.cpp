// SPDX-License-Identifier: BSL-1.0
#include "known_defects.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <stdexcept>
#include <utility>

namespace carom::mutants {
namespace {

using namespace std::string_view_literals;

/// The constants of mutable_solver.cpp and misread.cpp that a diagnosis states.
constexpr std::array limits{
    std::pair{"restitution_threshold"sv, PlantedLimit{"speed of approach |N·V⁻|/‖N‖ [m/s] is at most ", 0.2}},
    std::pair{"mass_ratio_capped"sv, PlantedLimit{"the larger mass over the smaller is at least ", 100}},
    std::pair{"heavy_as_immovable"sv, PlantedLimit{"the larger mass over the smaller is at least ", 1e6}},
    std::pair{"impulse_capped"sv, PlantedLimit{"impulses were limited to ", 10}},
    std::pair{"tiny_lever_arm_as_zero"sv, PlantedLimit{"the shorter lever arm [m] is at most ", 1e-6}},
    std::pair{"small_moments_as_infinite"sv,
              PlantedLimit{"product of a body's three moments [kg³ m⁶] is at most ", 1e-32}},
    std::pair{"slow_approach_ignored"sv, PlantedLimit{"speed of approach |N·V⁻|/‖N‖ [m/s] is at most ", 1e-3}},
};

std::string trimmed(const std::string& text) {
  const std::size_t first = text.find_first_not_of(' ');
  return first == std::string::npos ? "" : text.substr(first, text.find_last_not_of(' ') - first + 1);
}

/// Calls `visit` with each part of `says` until it returns false.
template <class Visit>
void for_each_part(const std::string& says, const Visit& visit) {
  static const std::string mark = "…";
  for (std::size_t begin = 0; begin <= says.size();) {
    const std::size_t end = std::min(says.find(mark, begin), says.size());
    if (!visit(trimmed(says.substr(begin, end - begin)))) {
      return;
    }
    begin = end + mark.size();
  }
}

const Mutant& mutant_named(const std::string& name) {
  const auto found = std::ranges::find(all_mutants(), name, &Mutant::name);
  if (found == all_mutants().end()) {
    throw std::invalid_argument("there is no mutant " + name);
  }
  return *found;
}

}  // namespace

std::vector<KnownDefect> known_defects() {
  std::ifstream page(CAROM_DIAGNOSES_PAGE);
  std::vector<KnownDefect> rows;
  for (std::string line; std::getline(page, line);) {
    const std::size_t name_end = line.find_first_not_of("abcdefghijklmnopqrstuvwxyz_", 3);
    if (!line.starts_with("| `") || name_end == std::string::npos || line.substr(name_end, 2) != "`:") {
      continue;
    }
    const std::size_t bar = line.find('|', name_end);
    KnownDefect& row = rows.emplace_back();
    row.mutant = &mutant_named(line.substr(3, name_end - 3));
    row.says = trimmed(line.substr(bar + 1, line.rfind('|') - bar - 1));
    const auto* limit = std::ranges::find(limits, row.mutant->name, &decltype(limits)::value_type::first);
    if (limit != limits.end()) {
      row.limit = limit->second;
    }
  }
  return rows;
}

std::string missing_part(const std::string& text, const std::string& says) {
  std::string missing;
  std::size_t place = 0;
  for_each_part(says, [&](const std::string& part) {
    place = text.find(part, place);
    if (place == std::string::npos) {
      missing = part;
    }
    return missing.empty();
  });
  return missing;
}

bool is_named_in(const std::string& text, const KnownDefect& defect) {
  std::string says = defect.says;
  if (defect.limit) {
    // The number after the last part is the limit alone. It depends on the sampled cases.
    says = says.substr(0, says.find_last_not_of("0123456789.e+-") + 1);
  }
  if (!missing_part(text, says).empty()) {
    return false;
  }
  if (!defect.limit) {
    return true;
  }
  const std::size_t before = text.find(defect.limit->before);
  if (before == std::string::npos) {
    return false;
  }
  const double stated = std::strtod(text.c_str() + before + defect.limit->before.size(), nullptr);
  constexpr double nearness = 0.1;
  return std::abs(stated - defect.limit->value) <= nearness * defect.limit->value;
}

}  // namespace carom::mutants
