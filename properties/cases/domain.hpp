// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <array>
#include <limits>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <carom/collision/collision.hpp>
#include <carom/collision/enum_array.hpp>
#include <carom/properties/cases/kinds.hpp>

namespace carom::properties {

/// The quantities of a collision that a domain limits. docs/reference/domains.md gives the formula of each.
enum class LimitedQuantity {
  size,
  mass,
  mass_ratio,
  moment_ratio,
  size_ratio,
  speed,
  approach,
  spin,
  distance,
  restitution,
  friction,
  tangential_restitution,
};
inline constexpr std::array all_limited_quantities{
    LimitedQuantity::size,         LimitedQuantity::mass,       LimitedQuantity::mass_ratio,
    LimitedQuantity::moment_ratio, LimitedQuantity::size_ratio, LimitedQuantity::speed,
    LimitedQuantity::approach,     LimitedQuantity::spin,       LimitedQuantity::distance,
    LimitedQuantity::restitution,  LimitedQuantity::friction,   LimitedQuantity::tangential_restitution};
static_assert(counts_from_zero_to(all_limited_quantities, LimitedQuantity::tangential_restitution));

template <class T>
using PerLimitedQuantity = EnumArray<LimitedQuantity, T, all_limited_quantities.size()>;

/// Both ends belong to the range.
struct Range {
  double least = 0;
  double most = std::numeric_limits<double>::infinity();

  [[nodiscard]] bool contains(double x) const { return least <= x && x <= most; }
  friend bool operator==(const Range&, const Range&) = default;
};

/// The widest range of a quantity: 0 to ∞ [SI units]; ratios from 1, ε from 0 to 1, and e_t from −1 to 1.
[[nodiscard]] Range whole_range(LimitedQuantity quantity);

/// A set of collisions: each quantity of the collision lies in its range, and the collision lies in the kinds. A domain
/// decides which collisions the gate poses. It never decides a verdict.
struct Domain {
  PerLimitedQuantity<Range> ranges;
  Kinds kinds;

  /// Every valid collision.
  Domain();

  [[nodiscard]] bool is_everything() const {
    static const Domain everything;
    return *this == everything;
  }
  friend bool operator==(const Domain&, const Domain&) = default;
};

/// The values of the quantity, rounded; none if the collision does not have the quantity. Lever arms, speeds, spins and
/// distances that are zero lie in every range, and are left out. Precondition: the collision is valid.
[[nodiscard]] std::vector<double> values_of(const Collision& collision, LimitedQuantity quantity);

/// The distance at which the speed of a wall's spin counts [m]: the wall's lever arm, but at least the lesser radius of
/// gyration of the movable bodies.
[[nodiscard]] double reach_of_wall(const Collision& collision, const Body& wall);

/// The name of the first quantity that lies outside of its range, or of the first kind outside of which the collision
/// lies. None if the domain contains the collision. An invalid collision has no quantities, so every domain contains
/// it.
[[nodiscard]] std::optional<std::string_view> name_outside(const Domain& domain, const Collision& collision);

[[nodiscard]] inline bool contains(const Domain& domain, const Collision& collision) {
  return !name_outside(domain, collision);
}

/// Sets the range. Throws std::invalid_argument if the ends are not finite numbers in `whole_range`, or if the first
/// is greater than the second. An absent end is that of `whole_range`.
void set_range(Domain& domain, LimitedQuantity quantity, std::optional<double> least, std::optional<double> most);

/// "mass_ratio".
[[nodiscard]] std::string_view name_of(LimitedQuantity quantity);

/// "m", "kg" or "m/s"; empty for a quantity without a unit.
[[nodiscard]] std::string_view unit_of(LimitedQuantity quantity);

/// None if no quantity has this name.
[[nodiscard]] std::optional<LimitedQuantity> quantity_named(std::string_view name);

/// Reads a domain. "size=0.1:10,mass_ratio=:100" lists the ranges that are not whole, and "restitution=0.5" permits one
/// value. "plane=xy" limits a kind. {"size": [0.1, 10], "mass_ratio": [null, 100], "plane": "xy"} gives the same as
/// JSON. "games" is the name of a shipped domain; in "games,speed=:50,plane=xy" the other parts replace its ranges.
/// Empty text stands for everything. Throws std::invalid_argument with the wrong part.
[[nodiscard]] Domain domain_from(std::string_view text);

/// The text that `domain_from` reads back; "everything" if no range and no kind is limited.
[[nodiscard]] std::string to_text(const Domain& domain);

/// A domain that ships with Carom. docs/reference/domains.md has its sources.
struct NamedDomain {
  std::string_view name;
  std::string_view summary;
  std::string_view ranges;  // for `domain_from`
};
[[nodiscard]] std::span<const NamedDomain> named_domains();

/// The ranges of the shipped domain with this name; none if there is no such domain.
[[nodiscard]] std::optional<Domain> domain_named(std::string_view name);

}  // namespace carom::properties
