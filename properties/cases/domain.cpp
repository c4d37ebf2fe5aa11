// SPDX-License-Identifier: BSL-1.0
#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <set>
#include <stdexcept>

#include <fmt/format.h>

#include <carom/collision/expects.hpp>
#include <carom/collision/json/json.hpp>
#include <carom/collision/validate.hpp>
#include <carom/properties/cases/domain.hpp>
#include <carom/properties/draws/general_collision.hpp>
#include <carom/properties/draws/relative_velocity.hpp>
#include <carom/properties/draws/vectors.hpp>
#include <carom/properties/features/geometry.hpp>

namespace carom::properties {
namespace {

struct QuantityFacts {
  std::string_view name;
  std::string_view unit;  // empty if there is none
  Range whole = {};
};

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr PerLimitedQuantity<QuantityFacts> facts{{{{"size", "m"},
                                                    {"mass", "kg"},
                                                    {"mass_ratio", "", {1, infinity}},
                                                    {"moment_ratio", "", {1, infinity}},
                                                    {"size_ratio", "", {1, infinity}},
                                                    {"speed", "m/s"},
                                                    {"approach", "m/s"},
                                                    {"spin", ""},
                                                    {"distance", ""},
                                                    {"restitution", "", {0, 1}},
                                                    {"friction", ""},
                                                    {"tangential_restitution", "", {-1, 1}}}}};

constexpr std::array domains{
    NamedDomain{"games", "what the manuals of game engines state", "size=0.1:10,speed=:500,distance=:500,friction=:1"},
    NamedDomain{"robotics", "links of published robots, and what simulators of robots state",
                "size=0.003:1,mass=0.002:120,moment_ratio=:200,speed=:10,friction=:1"},
    NamedDomain{"granular", "particles of published simulations, and what their programs accept",
                "size=3e-05:0.1,mass=1e-09:11,mass_ratio=:92,size_ratio=:4.5,speed=:4,approach=:4,restitution=0.05:,"
                "friction=:1,tangential_restitution=0:"},
    NamedDomain{"everything", "all valid collisions", ""},
};

/// Appends x, unless it is zero.
void add_unless_zero(std::vector<double>& values, double x) {
  if (x != 0) {
    values.push_back(x);
  }
}

/// Calls use(body) for each body that is immovable, or for each that is not.
template <class Use>
void for_each_body(const Collision& c, bool immovable, const Use& use) {
  for (const Body* body : {&c.a, &c.b}) {
    if (body->immovable == immovable) {
      use(*body);
    }
  }
}

double greater_speed(const Collision& c) { return std::max(length(c.a.velocity), length(c.b.velocity)); }

double speed_of_spin(const Body& body) { return length(body.angular_velocity) * features::radius_of_gyration(body); }

double quotient_of_greater(double x, double y) { return std::max(x, y) / std::min(x, y); }

/// None if the text is not a finite number.
std::optional<double> number_from(std::string_view text) {
  double number{};
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  const bool is_number = error == std::errc() && end == text.data() + text.size() && std::isfinite(number);
  return is_number ? std::optional(number) : std::nullopt;
}

}  // namespace

std::string_view name_of(LimitedQuantity quantity) { return facts[quantity].name; }

std::string_view unit_of(LimitedQuantity quantity) { return facts[quantity].unit; }

Range whole_range(LimitedQuantity quantity) { return facts[quantity].whole; }

std::span<const NamedDomain> named_domains() { return domains; }

Domain::Domain() {
  for (const LimitedQuantity quantity : all_limited_quantities) {
    ranges[quantity] = whole_range(quantity);
  }
}

double reach_of_wall(const Collision& collision, const Body& wall) {
  return std::max(length(features::lever_arm(collision, wall)), features::least_radius_of_gyration(collision));
}

std::vector<double> values_of(const Collision& c, LimitedQuantity quantity) {
  CAROM_EXPECTS(validate(c).empty(), describe(validate(c)));
  std::vector<double> values;
  const bool are_movable = !c.a.immovable && !c.b.immovable;
  const auto for_each_movable = [&](const auto& use) { for_each_body(c, false, use); };
  const auto for_each_wall = [&](const auto& use) { for_each_body(c, true, use); };
  switch (quantity) {
    case LimitedQuantity::size:
      for_each_movable([&](const Body& body) {
        add_unless_zero(values, length(features::lever_arm(c, body)));
        values.push_back(features::radius_of_gyration(body));
      });
      for_each_wall([&](const Body& wall) {
        if (const double r = length(features::lever_arm(c, wall)); r < features::least_radius_of_gyration(c)) {
          add_unless_zero(values, r);
        }
      });
      break;
    case LimitedQuantity::mass:
      for_each_movable([&](const Body& body) { values.push_back(body.mass); });
      break;
    case LimitedQuantity::mass_ratio:
      if (are_movable) {
        values.push_back(quotient_of_greater(c.a.mass, c.b.mass));
      }
      break;
    case LimitedQuantity::moment_ratio:
      for_each_movable([&](const Body& body) { values.push_back(moment_ratio(body)); });
      break;
    case LimitedQuantity::size_ratio:
      if (are_movable) {
        values.push_back(quotient_of_greater(features::radius_of_gyration(c.a), features::radius_of_gyration(c.b)));
      }
      break;
    case LimitedQuantity::speed:
      add_unless_zero(values, length(c.a.velocity));
      add_unless_zero(values, length(c.b.velocity));
      for_each_wall(
          [&](const Body& wall) { add_unless_zero(values, length(wall.angular_velocity) * reach_of_wall(c, wall)); });
      if (greater_speed(c) == 0) {
        for_each_movable([&](const Body& body) { add_unless_zero(values, speed_of_spin(body)); });
      }
      break;
    case LimitedQuantity::approach:
      if (is_approaching(c)) {
        values.push_back(-dot(c.normal, relative_velocity(c)) / length(c.normal));
      }
      break;
    case LimitedQuantity::spin:
      if (const double speed = greater_speed(c); speed > 0) {
        for_each_movable([&](const Body& body) { add_unless_zero(values, speed_of_spin(body) / speed); });
      }
      break;
    case LimitedQuantity::distance:
      if (const double radius = features::least_radius_of_gyration(c); radius > 0) {
        add_unless_zero(values, length(c.point) / radius);
        for_each_wall([&](const Body& wall) { add_unless_zero(values, length(wall.position) / radius); });
      }
      break;
    case LimitedQuantity::restitution:
      values.push_back(c.restitution);
      break;
    case LimitedQuantity::friction:
      values.push_back(c.friction);
      break;
    case LimitedQuantity::tangential_restitution:
      values.push_back(c.tangential_restitution);
      break;
  }
  return values;
}

std::optional<std::string_view> name_outside(const Domain& domain, const Collision& collision) {
  if (domain.is_everything() || !validate(collision).empty()) {
    return std::nullopt;
  }
  if (const std::optional<std::string_view> kind = kind_outside(domain.kinds, collision)) {
    return kind;
  }
  for (const LimitedQuantity quantity : all_limited_quantities) {
    const Range& range = domain.ranges[quantity];
    if (range == whole_range(quantity)) {
      continue;
    }
    const std::vector<double> values = values_of(collision, quantity);
    if (!std::all_of(values.begin(), values.end(), [&](double x) { return range.contains(x); })) {
      return name_of(quantity);
    }
  }
  return std::nullopt;
}

void set_range(Domain& domain, LimitedQuantity quantity, std::optional<double> least, std::optional<double> most) {
  const Range whole = whole_range(quantity);
  const Range range{least.value_or(whole.least), most.value_or(whole.most)};
  const auto is_end = [&](const std::optional<double>& end) {
    return !end || (std::isfinite(*end) && whole.contains(*end));
  };
  if (!is_end(least) || !is_end(most) || !(range.least <= range.most)) {
    const std::string limit = std::isfinite(whole.most) ? fmt::format("{}", whole.most) : "infinity";
    throw std::invalid_argument(
        fmt::format("{}: expected two numbers from {} to {}, the lesser first, found {}:{}", name_of(quantity),
                    whole.least, limit, least ? fmt::format("{}", *least) : "", most ? fmt::format("{}", *most) : ""));
  }
  domain.ranges[quantity] = range;
}

std::optional<LimitedQuantity> quantity_named(std::string_view name) {
  const auto found = std::find_if(all_limited_quantities.begin(), all_limited_quantities.end(),
                                  [&](LimitedQuantity quantity) { return name_of(quantity) == name; });
  return found == all_limited_quantities.end() ? std::nullopt : std::optional(*found);
}

namespace {

[[noreturn]] void fail_unknown(std::string_view part) {
  std::vector<std::string_view> names;
  std::ranges::transform(facts, std::back_inserter(names), [](const QuantityFacts& one) { return one.name; });
  std::vector<std::string_view> named;
  std::ranges::transform(domains, std::back_inserter(named), [](const NamedDomain& one) { return one.name; });
  throw std::invalid_argument(
      fmt::format("'{}' names no quantity; expected QUANTITY=LEAST:MOST with one of {}, KIND=VALUE with one of {}, or "
                  "a domain: {}; "
                  "commas join these",
                  part, fmt::join(names, ", "), fmt::join(kind_names(), ", "), fmt::join(named, ", ")));
}

/// Reads "0.1:10", or "0.1" for one value.
void set_range_from(Domain& domain, LimitedQuantity quantity, std::string_view range) {
  const std::size_t colon = std::min(range.find(':'), range.size());
  const auto end_from = [&](std::string_view digits) {
    const std::optional<double> number = number_from(digits);
    if (!number && !(digits.empty() && colon < range.size())) {
      throw std::invalid_argument(
          fmt::format("{}: expected LEAST:MOST with finite numbers, found '{}'", name_of(quantity), range));
    }
    return number;
  };
  const std::optional<double> least = end_from(range.substr(0, colon));
  set_range(domain, quantity, least, colon < range.size() ? end_from(range.substr(colon + 1)) : least);
}

/// Reads a list of ranges and kinds, and of a named domain, whose ranges the others replace. Empty text stands for
/// everything.
Domain domain_from_list(std::string_view text) {
  std::vector<std::string_view> parts;
  for (std::size_t begin = 0; !text.empty() && begin <= text.size();) {
    const std::size_t end = std::min(text.find(',', begin), text.size());
    parts.push_back(text.substr(begin, end - begin));
    begin = end + 1;
  }
  Domain domain;
  const auto is_named = [](std::string_view part) { return domain_named(part).has_value(); };
  if (const auto named = std::find_if(parts.begin(), parts.end(), is_named); named != parts.end()) {
    if (const auto other = std::find_if(named + 1, parts.end(), is_named); other != parts.end()) {
      throw std::invalid_argument(fmt::format("expected one of the domains {} and {}", *named, *other));
    }
    domain = *domain_named(*named);
    parts.erase(named);
  }
  std::set<std::string_view> given;
  for (const std::string_view part : parts) {
    const std::size_t sign = std::min(part.find('='), part.size());
    const std::string_view name = part.substr(0, sign);
    const std::string_view limit = part.substr(std::min(sign + 1, part.size()));
    if (!given.insert(name).second) {
      throw std::invalid_argument(fmt::format("{} occurs twice", name));
    }
    if (const std::optional<LimitedQuantity> quantity = quantity_named(name)) {
      set_range_from(domain, *quantity, limit);
    } else if (std::ranges::count(kind_names(), name) > 0) {
      set_kind(domain.kinds, name, limit);
    } else {
      fail_unknown(part);
    }
  }
  return domain;
}

}  // namespace

Domain domain_from(std::string_view text) {
  if (!text.starts_with('{')) {
    return domain_from_list(text);
  }
  try {
    return domain_from_list(domain_from_json(parse_json(text)));
  } catch (const FormatError& error) {
    throw std::invalid_argument(error.what());
  }
}

std::string to_text(const Domain& domain) {
  std::string text;
  for (const LimitedQuantity quantity : all_limited_quantities) {
    const Range& range = domain.ranges[quantity];
    const Range whole = whole_range(quantity);
    if (range == whole) {
      continue;
    }
    const std::string least = range.least == whole.least ? "" : fmt::format("{}", range.least);
    const std::string most = range.most == whole.most ? "" : fmt::format("{}", range.most);
    text += fmt::format("{}{}={}:{}", text.empty() ? "" : ",", name_of(quantity), least, most);
  }
  for (const auto& [name, value] : texts_of(domain.kinds)) {
    text += fmt::format("{}{}={}", text.empty() ? "" : ",", name, value);
  }
  return text.empty() ? "everything" : text;
}

std::optional<Domain> domain_named(std::string_view name) {
  for (const NamedDomain& named : named_domains()) {
    if (named.name == name) {
      return domain_from_list(named.ranges);
    }
  }
  return std::nullopt;
}

}  // namespace carom::properties
