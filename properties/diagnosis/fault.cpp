// SPDX-License-Identifier: BSL-1.0
#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include <fmt/format.h>

#include <carom/collision/expects.hpp>
#include <carom/oracles/judge/coulomb_answers.hpp>
#include <carom/oracles/laws/equations.hpp>
#include <carom/properties/diagnosis/fault.hpp>
#include <carom/properties/diagnosis/friction.hpp>
#include <carom/properties/diagnosis/where.hpp>

namespace carom::properties::diagnosis {
namespace {

enum class Step {
  immovable_moved,
  moved_apart,
  left_as_it_was,
  reaction,
  spin_of_both,
  spin_of_a,
  spin_of_b,
  impulse,
  restitution,  // of a law that permits many impulses
  none,         // no step is off by more than a thousandth
};
constexpr std::array all_steps{Step::immovable_moved, Step::moved_apart, Step::left_as_it_was, Step::reaction,
                               Step::spin_of_both,    Step::spin_of_a,   Step::spin_of_b,      Step::impulse,
                               Step::restitution,     Step::none};

using oracles::Rational;
using Exact = BasicCollision<Rational>;

constexpr double visible = 0x1p-10;

double norm(const Vector3<Rational>& v) {
  return std::hypot(oracles::nearest_double(v[0]), oracles::nearest_double(v[1]), oracles::nearest_double(v[2]));
}

/// Whether x and y differ by more than a thousandth of the largest of `size`, ‖x‖ and ‖y‖.
bool differ(const Vector3<Rational>& x, const Vector3<Rational>& y, double size = 0) {
  return norm(Vector3<Rational>(x - y)) > visible * std::max({norm(x), norm(y), size});
}

bool moved(const BasicBody<Rational>& body, const BodyVelocity<Rational>& after) {
  return after.velocity != body.velocity || after.angular_velocity != body.angular_velocity;
}

bool moved_visibly(const BasicBody<Rational>& body, const BodyVelocity<Rational>& after) {
  return differ(after.velocity, body.velocity) || differ(after.angular_velocity, body.angular_velocity);
}

bool is_spin_wrong(const Exact& c, const Outcome<Rational>& after, bool of_a) {
  const BasicBody<Rational>& body = of_a ? c.a : c.b;
  if (body.immovable) {
    return false;
  }
  const auto sides = oracles::equation::AngularMomentum{of_a}(c, after);
  const BodyVelocity<Rational>& motion = of_a ? after.a : after.b;
  const double size = norm(oracles::lever_arm(body, c.point)) * norm(oracles::impulse_on(body, motion));
  return differ(sides.left, sides.right, size);
}

/// A computed impulse compared with the right one. `along` is the ratio of the components along the normal. `across` is
/// the error across the normal, divided by the length of the longer impulse.
struct Shares {
  double along = 0;
  double across = 0;
  double restitution = 0;  // of the collision
  double computed_restitution = 0;
};

/// Friction as computed. F_T and V_T are the parts of F and V across N.
struct Friction {
  double of_cone = 0;           // ‖F_T‖ / (μ N·F / ‖N‖); infinite if μ = 0
  double of_slip = 0;           // the share of ‖V_T⁻‖ that it stops; NaN if V_T⁻ = 0
  double against_before = 0;    // the cosine of the angle between F_T and −V_T⁻; NaN if one is 0
  double against_after = 0;     // the same for V_T⁺
  double against_reversed = 0;  // the same for the slip before with the spins reversed
};

struct Told {
  Step step = Step::none;
  std::optional<Shares> shares;      // set if the impulse is wrong and the law determines it
  std::optional<Friction> friction;  // set if the law has friction and the contact collides
};

/// −N·V⁺ / N·V⁻. Precondition: the contact collides.
double computed_restitution(const Exact& c, const Outcome<Rational>& after) {
  return -oracles::nearest_double(c.normal.dot(oracles::relative_velocity<Rational>(c, after)) /
                                  oracles::normal_velocity_before(c));
}

/// The law's impulse on A. Of several answers of `coulomb`, the one nearest to the outcome counts. No value if the law
/// permits any impulse. Precondition: the contact collides.
std::optional<Vector3<Rational>> right_impulse(const ViolatedCase& violated, const oracles::ExactCase& exact_case,
                                               Law law) {
  if (const std::optional<KnownCase> known = known_case(violated, law)) {
    return known->impulse.cast<Rational>();
  }
  if (law != Law::coulomb) {
    return std::nullopt;
  }
  const std::vector<oracles::CoulombAnswer> answers = coulomb_answers(exact_case);
  return answers[nearest_answer(exact_case, answers, std::get<ReportedOutcome>(violated.answer)).number].truth.impulse;
}

/// The cosine of the angle between x and −y; NaN if one is 0.
double cosine_against(const Vector3<Rational>& x, const Vector3<Rational>& y) {
  return oracles::nearest_double(-x.dot(y)) / (norm(x) * norm(y));
}

Friction friction_of(const Exact& c, const Outcome<Rational>& after) {
  const auto across = [&](const Vector3<Rational>& v) {
    return Vector3<Rational>(v - c.normal * Rational(c.normal.dot(v) / c.normal.dot(c.normal)));
  };
  const Vector3<Rational> impulse = oracles::impulse_on_a(c, after, oracles::reads_impulse_off_a(c));
  const Vector3<Rational> tangential = across(impulse);
  const Vector3<Rational> slip_before = across(oracles::relative_velocity<Rational>(c, unchanged(c)));
  const Vector3<Rational> slip_after = across(oracles::relative_velocity<Rational>(c, after));
  Outcome<Rational> reversed = unchanged(c);
  reversed.a.angular_velocity = -reversed.a.angular_velocity;
  reversed.b.angular_velocity = -reversed.b.angular_velocity;
  const Vector3<Rational> slip_of_reversed = across(oracles::relative_velocity<Rational>(c, reversed));
  const double limit =
      oracles::nearest_double(c.friction) * oracles::nearest_double(c.normal.dot(impulse)) / norm(c.normal);
  return {norm(tangential) / limit, 1 - norm(slip_after) / norm(slip_before), cosine_against(tangential, slip_before),
          cosine_against(tangential, slip_after), cosine_against(tangential, slip_of_reversed)};
}

Told told_of(const ViolatedCase& violated, Law law) {
  const oracles::ExactCase exact_case(violated.one.collision);
  const Exact& c = exact_case.exact();
  const Outcome<Rational> after = oracles::lift(std::get<ReportedOutcome>(violated.answer));
  if ((c.a.immovable && moved(c.a, after.a)) || (c.b.immovable && moved(c.b, after.b))) {
    return {Step::immovable_moved, {}, {}};
  }
  if (exact_case.state() != oracles::ContactState::colliding) {
    return {moved_visibly(c.a, after.a) || moved_visibly(c.b, after.b) ? Step::moved_apart : Step::none, {}, {}};
  }
  if (!moved(c.a, after.a) && !moved(c.b, after.b)) {
    return {Step::left_as_it_was, {}, {}};
  }
  if (!c.a.immovable && !c.b.immovable) {
    const auto sides = oracles::equation::LinearMomentum{}(c, after);
    if (differ(sides.left, sides.right)) {
      return {Step::reaction, {}, {}};
    }
  }
  const bool a = is_spin_wrong(c, after, true);
  const bool b = is_spin_wrong(c, after, false);
  if (a || b) {
    return {a && b ? Step::spin_of_both : (a ? Step::spin_of_a : Step::spin_of_b), {}, {}};
  }
  const std::optional<Friction> friction =
      law == Law::any || has_friction(law) ? std::optional(friction_of(c, after)) : std::nullopt;
  const std::optional<Vector3<Rational>> right = right_impulse(violated, exact_case, law);
  if (!right) {
    const bool is_right = std::abs(computed_restitution(c, after) - violated.one.collision.restitution) <= visible;
    return {is_right ? Step::none : Step::restitution, {}, friction};
  }
  const Vector3<Rational> computed = oracles::impulse_on_a(c, after, oracles::reads_impulse_off_a(c));
  if (!differ(computed, *right)) {
    return {Step::none, {}, {}};
  }
  const Vector3<Rational> missed = computed - *right;
  const double right_along = oracles::nearest_double(c.normal.dot(*right));
  const double length = norm(c.normal);
  return {Step::impulse,
          Shares{oracles::nearest_double(c.normal.dot(computed)) / right_along,
                 norm(c.normal.cross(missed)) / length / std::max(norm(*right), norm(computed)),
                 violated.one.collision.restitution, computed_restitution(c, after)},
          friction};
}

/// The fault of friction in most of the outcomes, in words. Empty if there is none.
std::string friction_in_words(const std::vector<Friction>& all) {
  const auto count_of = [&](const auto& is_such) {
    return static_cast<std::size_t>(std::count_if(all.begin(), all.end(), is_such));
  };
  const auto most = [&](const auto& is_such) { return 2 * count_of(is_such) > all.size(); };
  const auto range_of = [&](double Friction::*number) {
    const auto [least, greatest] = std::minmax_element(
        all.begin(), all.end(), [&](const Friction& x, const Friction& y) { return x.*number < y.*number; });
    return std::pair((*least).*number, (*greatest).*number);
  };
  const auto is_along_slip = [](const Friction& one) {
    return one.against_before < -visible && one.against_after < visible;
  };
  const auto exceeds_cone = [](const Friction& one) { return one.of_cone > 1 + visible; };
  const auto leaves_slip = [](const Friction& one) { return one.of_cone < 1 - visible && one.of_slip < 1 - visible; };
  const auto is_oblique = [](const Friction& one) { return one.against_after < 1 - visible; };
  const auto is_of_reversed_spin = [](const Friction& one) { return one.against_reversed > 1 - visible; };
  const auto is_of_slip = [](const Friction& one) {
    return std::max(one.against_before, one.against_after) > 1 - visible;
  };
  if (most(is_of_reversed_spin) && !most(is_of_slip)) {
    return fmt::format("The spin has the wrong sign in the slip that friction opposes, in {} of {} wrong outcomes",
                       count_of(is_of_reversed_spin), all.size());
  }
  if (most(is_along_slip)) {
    return fmt::format("Friction drives the slip in {} of {} wrong outcomes: F_T is along V_T, and not against it",
                       count_of(is_along_slip), all.size());
  }
  if (most(exceeds_cone)) {
    // A box about a circle reaches √2 radii.
    constexpr double least_of_box = 1.2;
    constexpr double corner_of_box = 1.4143;
    constexpr double spread_of_box = 1.05;  // a box exceeds the cone by another factor in each direction
    const auto [least, greatest] = range_of(&Friction::of_cone);
    if (greatest > least_of_box && greatest < corner_of_box && greatest > spread_of_box * least) {
      return fmt::format(
          "Friction exceeds μ F_n by up to {:.3g} in {} of {} wrong outcomes, as by a box in place of the cone",
          greatest, count_of(exceeds_cone), all.size());
    }
    return fmt::format("Friction ‖F_T‖ exceeds μ F_n in {} of {} wrong outcomes, by a factor up to {:.4g}",
                       count_of(exceeds_cone), all.size(), greatest);
  }
  if (most(leaves_slip)) {
    const auto [least, greatest] = range_of(&Friction::of_slip);
    return fmt::format("Friction below μ F_n leaves a slip in {} of {} wrong outcomes: it stops {:.3g} to {:.3g} of it",
                       count_of(leaves_slip), all.size(), least, greatest);
  }
  if (most(is_oblique)) {
    return fmt::format("Friction is not against the slip after the impulse in {} of {} wrong outcomes",
                       count_of(is_oblique), all.size());
  }
  return {};
}

struct Words {
  std::string what;
  std::string look_at;
};

Words impulse_in_words(const std::vector<Shares>& all, const std::vector<Friction>& frictions) {
  std::vector<double> along;
  std::size_t across = 0;
  for (const Shares& shares : all) {
    along.push_back(shares.along);
    across += shares.across > visible ? 1 : 0;
  }
  std::sort(along.begin(), along.end());
  const double middle = along[along.size() / 2];
  const bool is_normal_right = std::abs(along.front() - 1) < visible && std::abs(along.back() - 1) < visible;
  const bool is_restitution_right = std::all_of(all.begin(), all.end(), [](const Shares& one) {
    return std::abs(one.computed_restitution - one.restitution) < visible;
  });
  const std::string look_at =
      "the computation of the impulse: the relative velocity, K, the law, limits on any of these";
  if (is_normal_right || (is_restitution_right && !frictions.empty())) {
    const std::string friction = friction_in_words(frictions);
    return {friction.empty() ? "The normal velocity after its impulse is right, and the tangential part is wrong."
                             : friction + '.',
            "friction: the slip V_T, what stops it, the limit μ F_n, the direction; " + look_at};
  }
  const std::string tangential = across == 0 ? ", and its tangential part is right" : "";
  if (along.back() - along.front() < visible * std::abs(middle)) {
    return {fmt::format("The normal part of its impulse is {:.4g} times the right one{}.", middle, tangential),
            look_at};
  }
  const auto shown = [](double x) { return std::abs(x) < visible ? 0 : x; };
  return {fmt::format("The normal part of its impulse is between {:.3g} and {:.3g} times the right one{}.",
                      shown(along.front()), shown(along.back()), tangential),
          look_at};
}

}  // namespace

std::vector<std::string> lines_of(const Fault& fault) {
  std::vector<std::string> lines{in_one_sentence(fault.what, fault.where)};
  if (!fault.look_at.empty()) {
    lines.push_back("Look at: " + fault.look_at);
  }
  return lines;
}

std::string in_words(std::span<const Fault> faults, const std::string& indent, std::size_t most) {
  std::string text;
  std::size_t count = 0;
  for (const Fault& fault : faults) {
    for (const std::string& line : lines_of(fault)) {
      text += count < most ? indent + line + '\n' : "";
      ++count;
    }
  }
  return text;
}

Fault fault_of_matrix(MatrixFault kind) {
  switch (kind) {
    case MatrixFault::missing:
      return {"Its outcomes are right. It shows no collision matrix of some contacts that collide.",
              "paths that solve a contact without C: spheres, no friction, equal masses"};
    case MatrixFault::out_of_bounds:
      return {
          "Its outcomes are right. The collision matrix that it shows is not positive definite, or it is too large.",
          "the computation of C: signs, the transpose of [r], the moments of inertia"};
    case MatrixFault::another:
      break;
  }
  return {
      "Its outcomes are right. The collision matrix that it shows is not that of the contact, or is not the one that "
      "it "
      "solves with.",
      "the shown matrix: its axes, its rows and columns, the contact that it belongs to"};
}

Fault fault_of_memory() {
  return {
      "It gives another answer if it is asked again: it keeps state from earlier collisions, or its answer depends "
      "on the spelling of the request.",
      "caches, warm starts, random numbers, state that is not reset; the parser of numbers and of optional fields"};
}

Fault fault_of(std::span<const ViolatedCase> cases, Law law) {
  CAROM_EXPECTS(!cases.empty());
  std::array<std::size_t, all_steps.size()> counts{};
  std::vector<Shares> shares;
  std::vector<Friction> frictions;
  for (const ViolatedCase& violated : cases) {
    const Told told = told_of(violated, law);
    ++counts[static_cast<std::size_t>(told.step)];
    if (told.shares) {
      shares.push_back(*told.shares);
    }
    if (told.friction) {
      frictions.push_back(*told.friction);
    }
  }
  const auto count_of = [&](Step step) -> std::size_t& { return counts[static_cast<std::size_t>(step)]; };
  const std::size_t of_a = count_of(Step::spin_of_a);
  const std::size_t of_b = count_of(Step::spin_of_b);
  count_of(Step::spin_of_both) += of_a + of_b;
  count_of(Step::spin_of_a) = count_of(Step::spin_of_b) = 0;
  const auto most = std::max_element(counts.begin(), counts.end());
  switch (static_cast<Step>(most - counts.begin())) {
    case Step::immovable_moved:
      return {"An immovable body's velocity or spin changes.", "the treatment of bodies of infinite mass"};
    case Step::moved_apart:
      return {"It changes the velocities of contacts that do not approach.", "the condition N·V⁻ < 0"};
    case Step::left_as_it_was:
      return {"It does not change the velocities of colliding contacts.",
              "the condition for solving a contact: thresholds, sleeping bodies, filters"};
    case Step::reaction:
      return {"A does not gain the linear momentum that B loses.",
              "the application of the impulse to each body: masses, signs, other terms"};
    case Step::spin_of_both:
    case Step::spin_of_a:
    case Step::spin_of_b: {
      const char* const whose = of_b == 0 && of_a == *most ? " of A" : of_a == 0 && of_b == *most ? " of B" : "";
      return {fmt::format("The change of spin{} does not follow from the impulse: J Δw is not r × F.", whose),
              "the lever arms, the frame of the inertia tensor, fast paths for some inertias, other terms of the "
              "angular velocity"};
    }
    case Step::impulse: {
      const auto [what, look_at] = impulse_in_words(shares, frictions);
      return {what, look_at};
    }
    case Step::restitution:
      return {"The normal velocity after the impulse is not −ε N·V⁻.",
              "the restitution, and the part of the impulse along the normal"};
    case Step::none:
      break;
  }
  return {"The error is less than a thousandth of the change of velocity: lost digits rather than a wrong formula.",
          "the claimed precision (`precision`), intermediate results in single precision, cancellation, iterations "
          "that end early"};
}

}  // namespace carom::properties::diagnosis
