// SPDX-License-Identifier: BSL-1.0
#include <array>
#include <cmath>
#include <iterator>
#include <numbers>
#include <utility>

#include <carom/properties/diagnosis/hypothesis.hpp>

namespace carom::properties::diagnosis {
namespace {

Mistake of_order(FrictionOrder order, FrictionResponse response = FrictionResponse::along_slip) {
  return with_friction([order, response](FrictionSteps& steps) {
    steps.order = order;
    steps.response = response;
  });
}

Mistake of_limit(FrictionLimit limit, FrictionOrder order = FrictionOrder::together) {
  return with_friction([limit, order](FrictionSteps& steps) {
    steps.limit = limit;
    steps.order = steps.order == FrictionOrder::together ? order : steps.order;
  });
}

/// A limit on each of two tangents, which a solver may choose in several ways.
std::vector<Mistake> with_tangents(FrictionLimit limit) {
  std::vector<Mistake> all;
  for (const Tangents tangents :
       {Tangents::beside_normal, Tangents::of_least_axis, Tangents::branchless, Tangents::of_slip}) {
    for (const FrictionOrder order : {FrictionOrder::together, FrictionOrder::after_normal}) {
      all.push_back(with_friction([=](FrictionSteps& steps) {
        steps.limit = limit;
        steps.tangents = tangents;
        if (order != FrictionOrder::together) {
          steps.order = order;
          steps.response = FrictionResponse::by_matrix;
        }
      }));
    }
  }
  return all;
}

/// The factor of the spins in the slip. Friction stops this slip in one pass, or as time goes on.
std::vector<Mistake> with_spins(double of_a, double of_b) {
  std::vector<Mistake> all;
  for (const auto& [order, response] : {std::pair(FrictionOrder::together, FrictionResponse::along_slip),
                                        std::pair(FrictionOrder::of_slip_before, FrictionResponse::along_slip),
                                        std::pair(FrictionOrder::of_slip_before, FrictionResponse::of_read_slip)}) {
    all.push_back(with_friction([of_a, of_b, order = order, response = response](FrictionSteps& steps) {
      steps.spin_of_a *= of_a;
      steps.spin_of_b *= of_b;
      steps.order = order;
      steps.response = response;
    }));
  }
  return all;
}

Mistake with_response(FrictionResponse response, FrictionOrder order) {
  return with_friction([response, order](FrictionSteps& steps) {
    steps.response = response;
    steps.order = steps.order == FrictionOrder::together ? order : steps.order;
  });
}

std::vector<Hypothesis> misread_slip() {
  const std::string spins = "the slip V_T: v + w × r of each body, with the order w × r, and its sign for A and B";
  return {
      {"friction had the wrong sign, along the slip",
       "the sign of friction: it is against the slip V_T of A over B",
       {with_friction([](FrictionSteps& steps) { steps.stopped *= -1; })}},
      {"the spin had the wrong sign in the slip, so that its friction has the wrong sign", spins, with_spins(-1, -1)},
      {"the spin were left out of the slip", spins, with_spins(0, 0)},
      {"the spin of A had the wrong sign in the slip", spins, with_spins(-1, 1)},
      {"the spin of B had the wrong sign in the slip", spins, with_spins(1, -1)},
      {"the spin of A were left out of the slip", spins, with_spins(0, 1)},
      {"the spin of B were left out of the slip", spins, with_spins(1, 0)},
      {"the slip had w × r / ‖r‖, without the radius",
       "the slip V_T: its lever arm r has a length",
       {with_friction([](FrictionSteps& steps) { steps.has_arms_of_length_1 = true; })}},
  };
}

std::vector<Hypothesis> misread_order() {
  const std::string passes =
      "the order of the two impulses: friction also changes N·V, and the normal impulse changes the slip";
  const std::string direction = "the direction of friction that the cone limits: against the slip after the impulse";
  return {
      {"friction were solved once, after the normal impulse",
       passes,
       {of_order(FrictionOrder::after_normal), of_order(FrictionOrder::after_normal, FrictionResponse::by_matrix),
        of_order(FrictionOrder::of_slip_before), of_order(FrictionOrder::of_slip_before, FrictionResponse::by_matrix),
        of_order(FrictionOrder::apart_from_normal)}},
      {"friction were solved once, before the normal impulse",
       passes,
       {of_order(FrictionOrder::before_normal), of_order(FrictionOrder::before_normal, FrictionResponse::by_matrix),
        of_order(FrictionOrder::before_approach),
        of_order(FrictionOrder::before_approach, FrictionResponse::by_matrix)}},
      {"friction beyond the cone were against the slip before the impulse",
       direction,
       {of_order(FrictionOrder::along_slip)}},
      {"friction beyond the cone were along the impulse that stops the slip",
       direction,
       {of_order(FrictionOrder::along_sticking)}},
  };
}

std::vector<Hypothesis> misread_limit() {
  const std::string limit = "the limit of friction: ‖F_T‖ ≤ μ F_n, for the vector F_T";
  const std::string stop =
      "the impulse that stops the slip: V_T over 1/m and r × J⁻¹ (r × t), for a solid sphere 2/7 m";
  return {
      {"friction were ignored",
       "the tangential impulse: it is missing, or μ is not read",
       {computed_as([](Collision& c) { c.friction = 0; }), with_friction([](FrictionSteps& steps) {
          steps.order = FrictionOrder::of_slip_before;
          steps.stopped = 0;
        })}},
      {"friction always stopped the slip",
       "the limit of friction: it is missing, or static friction always acts",
       {of_limit(FrictionLimit::none), of_limit(FrictionLimit::none, FrictionOrder::after_normal),
        of_limit(FrictionLimit::none, FrictionOrder::of_slip_before)}},
      {"friction were always μ F_n, even if less stops the slip",
       "the limit of friction: it is the least of μ F_n and the impulse that stops the slip",
       {of_limit(FrictionLimit::always), of_limit(FrictionLimit::always, FrictionOrder::after_normal),
        of_limit(FrictionLimit::always, FrictionOrder::of_slip_before)}},
      {"friction were limited along each of two tangents, by a box in place of the cone", limit,
       with_tangents(FrictionLimit::box)},
      {"friction were limited by a pyramid in the cone", limit, with_tangents(FrictionLimit::pyramid)},
      {"friction stopped the slip of bodies that cannot turn",
       stop,
       {with_response(FrictionResponse::without_turning, FrictionOrder::together),
        with_response(FrictionResponse::without_turning, FrictionOrder::of_slip_before),
        with_response(FrictionResponse::without_turning, FrictionOrder::after_normal)}},
      {"friction stopped the slip of solid spheres",
       stop,
       {with_response(FrictionResponse::of_solid_spheres, FrictionOrder::of_slip_before),
        with_response(FrictionResponse::of_solid_spheres, FrictionOrder::after_normal),
        with_response(FrictionResponse::of_solid_spheres, FrictionOrder::together)}},
  };
}

std::vector<Hypothesis> misread_friction_coefficient() {
  const std::string source = "the source of μ: its unit, the combination of two coefficients, defaults";
  const auto of = [&](const char* as_if, void (*change)(Collision&)) {
    return Hypothesis{as_if, source, {computed_as(change)}};
  };
  return {of("μ were squared", [](Collision& c) { c.friction *= c.friction; }),
          of("the square root of μ were taken", [](Collision& c) { c.friction = std::sqrt(c.friction); }),
          of("μ were an angle in degrees",
             [](Collision& c) {
               constexpr double degree = std::numbers::pi / 180;
               c.friction = std::abs(std::tan(c.friction * degree));
             }),
          of("μ were an angle in radians", [](Collision& c) { c.friction = std::abs(std::tan(c.friction)); }),
          of("μ were multiplied by 1 + ε", [](Collision& c) { c.friction *= 1 + c.restitution; }),
          of("μ were divided by 1 + ε", [](Collision& c) { c.friction /= 1 + c.restitution; })};
}

}  // namespace

std::vector<Hypothesis> misread_friction() {
  std::vector<Hypothesis> joined;
  for (const auto part : {misread_slip, misread_order, misread_limit, misread_friction_coefficient}) {
    std::ranges::move(part(), std::back_inserter(joined));
  }
  for (Hypothesis& hypothesis : joined) {
    hypothesis.changes_application = false;
    // A solver that computes friction otherwise has no e_t.
    const std::vector<Mistake> with_restitution = hypothesis.mistakes;
    for (const Mistake& mistake : with_restitution) {
      hypothesis.mistakes.push_back([mistake](Steps& steps, const KnownCase& one) {
        steps.computed_from.tangential_restitution = 0;
        return steps.law == Law::rough && mistake(steps, one);
      });
    }
  }
  return joined;
}

}  // namespace carom::properties::diagnosis
