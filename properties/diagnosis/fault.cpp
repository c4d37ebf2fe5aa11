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
  double length = 0;  // ‖F‖ as computed
};

struct Told {
  Step step = Step::none;
  std::optional<Shares> shares;  // set if the impulse is wrong
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

Told told_of(const ViolatedCase& violated, Law law) {
  const oracles::ExactCase exact_case(violated.one.collision);
  const Exact& c = exact_case.exact();
  const Outcome<Rational> after = oracles::lift(std::get<ReportedOutcome>(violated.answer));
  if ((c.a.immovable && moved(c.a, after.a)) || (c.b.immovable && moved(c.b, after.b))) {
    return {Step::immovable_moved, {}};
  }
  if (exact_case.state() != oracles::ContactState::colliding) {
    return {moved_visibly(c.a, after.a) || moved_visibly(c.b, after.b) ? Step::moved_apart : Step::none, {}};
  }
  if (!moved(c.a, after.a) && !moved(c.b, after.b)) {
    return {Step::left_as_it_was, {}};
  }
  if (!c.a.immovable && !c.b.immovable) {
    const auto sides = oracles::equation::LinearMomentum{}(c, after);
    if (differ(sides.left, sides.right)) {
      return {Step::reaction, {}};
    }
  }
  const bool a = is_spin_wrong(c, after, true);
  const bool b = is_spin_wrong(c, after, false);
  if (a || b) {
    return {a && b ? Step::spin_of_both : (a ? Step::spin_of_a : Step::spin_of_b), {}};
  }
  const std::optional<Vector3<Rational>> right = right_impulse(violated, exact_case, law);
  if (!right) {
    const bool is_right = std::abs(computed_restitution(c, after) - violated.one.collision.restitution) <= visible;
    return {is_right ? Step::none : Step::restitution, {}};
  }
  const Vector3<Rational> computed = oracles::impulse_on_a(c, after, oracles::reads_impulse_off_a(c));
  if (!differ(computed, *right)) {
    return {Step::none, {}};
  }
  const Vector3<Rational> missed = computed - *right;
  const double right_along = oracles::nearest_double(c.normal.dot(*right));
  const double length = norm(c.normal);
  return {Step::impulse, Shares{oracles::nearest_double(c.normal.dot(computed)) / right_along,
                                norm(c.normal.cross(missed)) / length / std::max(norm(*right), norm(computed)),
                                violated.one.collision.restitution, computed_restitution(c, after), norm(computed)}};
}

bool are_alike(const std::vector<double>& numbers) {
  const auto [least, greatest] = std::minmax_element(numbers.begin(), numbers.end());
  return *greatest - *least <= visible * std::max(std::abs(*least), std::abs(*greatest));
}

/// The one ε that all outcomes show, or the one number that all add to ε, in words. Otherwise empty.
std::string restitution_in_words(const std::vector<Shares>& all, bool is_normal_right) {
  if (is_normal_right) {
    return {};
  }
  std::vector<double> added;
  std::vector<double> computed;
  for (const Shares& shares : all) {
    added.push_back(shares.computed_restitution - shares.restitution);
    computed.push_back(shares.computed_restitution);
  }
  if (are_alike(computed)) {
    return fmt::format("the bodies separate as if ε were always {:.4g}, ", computed[0] + 0.0);  // −0 + 0 is 0
  }
  if (are_alike(added)) {
    return fmt::format("the bodies separate as if {:.4g} were added to ε, ", added[0]);
  }
  return {};
}

/// The size that many impulses share, in words. Empty if there is none.
std::string limit_in_words(const std::vector<Shares>& all) {
  constexpr std::size_t least = 5;
  for (const Shares& one : all) {
    const auto same = static_cast<std::size_t>(std::count_if(all.begin(), all.end(), [&](const Shares& other) {
      return std::abs(other.length - one.length) <= visible * visible * one.length;
    }));
    if (same >= std::max(least, all.size() / 4)) {
      return fmt::format("{} of {} impulses are {:.4g} N s, as if this were a limit, ", same, all.size(), one.length);
    }
  }
  return {};
}

std::string impulse_in_words(const std::vector<Shares>& all) {
  std::vector<double> along;
  std::size_t across = 0;
  for (const Shares& shares : all) {
    along.push_back(shares.along);
    across += shares.across > visible ? 1 : 0;
  }
  std::sort(along.begin(), along.end());
  const double middle = along[along.size() / 2];
  const bool is_normal_right = std::abs(along.front() - 1) < visible && std::abs(along.back() - 1) < visible;
  const bool is_constant = along.back() - along.front() < visible * std::abs(middle);
  std::string text = "The impulse is applied correctly to both bodies, but it differs from the law's impulse: ";
  if (is_normal_right) {
    text += "its normal part is right, ";
  } else if (is_constant) {
    text += fmt::format("its normal part is {:.4g} times the right one, ", middle);
  } else {
    text +=
        fmt::format("its normal part is between {:.3g} and {:.3g} times the right one, ", along.front(), along.back());
  }
  text += restitution_in_words(all, is_normal_right) + limit_in_words(all);
  return text + (across == 0 ? "and its tangential part is right."
                             : fmt::format("and its tangential part is wrong in {} of {}.", across, all.size()));
}

}  // namespace

/// Speeds that many wrong outcomes share and the law does not give, in words. Empty if there are none.
std::string limits_in_words(std::span<const ViolatedCase> cases, Law law) {
  struct Size {
    OutcomeVector vector;
    double computed;
  };
  std::vector<Size> sizes;  // those that the law does not give
  for (const ViolatedCase& violated : cases) {
    const std::optional<KnownCase> known = known_case(violated, law);
    for (const OutcomeVector k : all_outcome_vectors) {
      const double computed = known ? vectors(known->answered)[k]->norm() : 0;
      if (computed > 0 && std::abs(computed - vectors(known->truth)[k]->norm()) > visible * computed) {
        sizes.push_back({k, computed});
      }
    }
  }
  constexpr std::size_t least = 5;
  for (const Size& one : sizes) {
    const bool is_spin =
        one.vector == OutcomeVector::angular_velocity_of_a || one.vector == OutcomeVector::angular_velocity_of_b;
    std::size_t alike = 0;
    for (const Size& other : sizes) {
      const bool of_same_kind = is_spin == (other.vector == OutcomeVector::angular_velocity_of_a ||
                                            other.vector == OutcomeVector::angular_velocity_of_b);
      alike += of_same_kind && std::abs(other.computed - one.computed) <= visible * visible * one.computed ? 1 : 0;
    }
    if (alike >= std::max(least, cases.size() / 4)) {
      return fmt::format(" {} of the wrong {} are {:.6g} {}, as if this were a limit.", alike,
                         is_spin ? "spins" : "speeds", one.computed, is_spin ? "rad/s" : "m/s");
    }
  }
  return {};
}

std::vector<std::string> lines_of(const Fault& fault) {
  std::vector<std::string> lines{fault.what};
  if (!fault.where.empty()) {
    lines.push_back(fault.where);
  }
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
  for (const ViolatedCase& violated : cases) {
    const Told told = told_of(violated, law);
    ++counts[static_cast<std::size_t>(told.step)];
    if (told.shares) {
      shares.push_back(*told.shares);
    }
  }
  const auto count_of = [&](Step step) -> std::size_t& { return counts[static_cast<std::size_t>(step)]; };
  const std::size_t of_a = count_of(Step::spin_of_a);
  const std::size_t of_b = count_of(Step::spin_of_b);
  const std::size_t of_both = count_of(Step::spin_of_both);
  count_of(Step::spin_of_both) += of_a + of_b;
  count_of(Step::spin_of_a) = count_of(Step::spin_of_b) = 0;
  const auto most = std::max_element(counts.begin(), counts.end());
  const std::string share = fmt::format(" ({} of {} examined outcomes)", *most, cases.size());
  const std::string limits = limits_in_words(cases, law);
  switch (static_cast<Step>(most - counts.begin())) {
    case Step::immovable_moved:
      return {"An immovable body's velocity or spin changes" + share + '.', "the treatment of bodies of infinite mass"};
    case Step::moved_apart:
      return {"It changes the velocities of contacts that do not approach" + share + '.', "the condition N·V⁻ < 0"};
    case Step::left_as_it_was:
      return {"It does not change the velocities of colliding contacts" + share + '.',
              "the condition for solving a contact: thresholds, sleeping bodies, filters"};
    case Step::reaction:
      return {"The linear momentum is not conserved: A does not gain what B loses" + share + '.' + limits,
              "the application of the impulse to each body: masses, signs, other terms"};
    case Step::spin_of_both:
    case Step::spin_of_a:
    case Step::spin_of_b:
      return {fmt::format("The velocities follow from an impulse, but the angular velocities do not: J Δw is not r × "
                          "F. This concerns A in {}, B in {}, and both in {} of {} examined outcomes.",
                          of_a, of_b, of_both, cases.size()) +
                  limits,
              limits.empty() ? "the lever arms, the frame of the inertia tensor, fast paths for some inertias, other "
                               "terms of the angular velocity"
                             : "limits on the angular velocity"};
    case Step::impulse:
      return {impulse_in_words(shares) + share + limits,
              "the computation of the impulse: the relative velocity, K, the law, limits on any of these"};
    case Step::restitution:
      return {"The velocities follow from an impulse, but the normal velocity after it is not −ε N·V⁻" + share + '.',
              "the restitution, and the part of the impulse along the normal"};
    case Step::none:
      break;
  }
  return {"The error is less than a thousandth of the change of velocity: lost digits rather than a wrong formula" +
              share + '.',
          "the claimed precision (`precision`), intermediate results in single precision, cancellation, iterations "
          "that end early"};
}

}  // namespace carom::properties::diagnosis
