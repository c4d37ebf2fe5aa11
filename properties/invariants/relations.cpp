// SPDX-License-Identifier: BSL-1.0
#include <algorithm>
#include <cmath>
#include <type_traits>
#include <utility>

#include <carom/oracles/bounds/stage.hpp>
#include <carom/oracles/judge/coulomb_answers.hpp>
#include <carom/properties/draws/relative_velocity.hpp>
#include <carom/properties/draws/vectors.hpp>
#include <carom/properties/invariants/invariant_groups.hpp>
#include <carom/properties/invariants/verdicts.hpp>

namespace carom::properties {
namespace {

using oracles::Rational;
std::variant<const oracles::LiftedOutcome*, Verdict> outcome_of(const Related& related) {
  if (const auto* outcome = std::get_if<oracles::LiftedOutcome>(&related.answer)) {
    return outcome;
  }
  if (const auto* skipped = std::get_if<Skipped>(&related.answer)) {
    return does_not_apply("the subject skipped the related collision: " + skipped->why);
  }
  if (std::holds_alternative<Failed>(related.answer)) {
    return does_not_apply("the subject did not answer the related collision; `finite` judges this");
  }
  const auto* refused = std::get_if<Refused>(&related.answer);
  return refused != nullptr ? violation(ViolationKind::related_refused, ": " + refused->why)
                            : violation(ViolationKind::related_not_finite);
}

/// Compares `expected(first)` with `second`. `expected` maps outcomes of any number type.
template <class Expected>
Verdict agree(const Evidence& e, const oracles::LiftedOutcome& first, const Expected& expected,
              const oracles::LiftedOutcome& second, const oracles::Sensitivity& sensitivity) {
  const auto enclosed = expected(first.enclosed());
  Verdict worst;
  for (const OutcomeVector k : all_outcome_vectors) {
    const auto exact_pair = [&] {
      const auto exactly = expected(first.exact());
      return std::pair{*vectors(exactly)[k], *vectors(second.exact())[k]};
    };
    worst = both(std::move(worst), vector_equals(*vectors(enclosed)[k], *vectors(second.enclosed())[k], exact_pair,
                                                 e.yardstick.allowed(sensitivity[k]), e.yardstick.filtered(),
                                                 name_of(k), "as related and as computed"));
  }
  return worst;
}

/// Whether the permitted error is certainly finite. If so, a lower bound of the permitted error may decide.
bool is_surely_finite(const Evidence& e, const oracles::ExactCase& exact_case, const oracles::LiftedOutcome& outcome) {
  return e.yardstick.uses_bounds() && exact_case.is_moderate(e.law) && outcome.is_moderate();
}

oracles::Sensitivity weighted_sum(double factor, const oracles::Sensitivity& first,
                                  const oracles::Sensitivity& second) {
  oracles::Sensitivity sum{};
  for (const OutcomeVector k : all_outcome_vectors) {
    sum[k] = factor * first[k] + second[k];
  }
  return sum;
}

/// The sensitivity of the law's answer, with the permitted noise. No value if it is not known. Precondition: the law
/// determines the answer.
std::optional<oracles::Sensitivity> sensitivity_of(const Evidence& e, const oracles::ExactCase& exact_case) {
  if (e.law != Law::coulomb) {
    return exact_case.sensitivity_with_noise(e.law, e.yardstick);
  }
  std::optional<oracles::Sensitivity> sum = oracles::coulomb_sensitivity(exact_case, e.allowance());
  if (sum) {
    oracles::add_permitted_noise(exact_case.collision(), e.yardstick, *sum);
  }
  return sum;
}

/// A cheap lower bound of `sensitivity_of`. Precondition: is_surely_finite of the case.
oracles::Sensitivity sensitivity_below(const Evidence& e, const oracles::ExactCase& exact_case) {
  return e.law == Law::coulomb ? oracles::coulomb_sensitivity_below(exact_case) : exact_case.sensitivity_below(e.law);
}

Verdict without_one_answer() { return does_not_apply("the law may have several answers to the contact"); }

/// For where the sensitivity is not known: a difference that even its lower bound permits holds.
template <class Expected>
Verdict agree_below(const Evidence& e, const oracles::LiftedOutcome& first, const Expected& expected,
                    const oracles::LiftedOutcome& second, const oracles::Sensitivity& below) {
  Verdict verdict = agree(e, first, expected, second, below);
  return verdict.status == Status::holds ? verdict : without_one_answer();
}

bool same_numbers(const ReportedOutcome& left, const ReportedOutcome& right) {
  const auto x = vectors(left);
  const auto y = vectors(right);
  return std::ranges::all_of(all_outcome_vectors, [&](OutcomeVector k) { return *x[k] == *y[k]; });
}

/// The verdict of a relation that maps the collision, and so the exact outcome, exactly. Both outcomes then have the
/// same sensitivity. `back` maps the related outcome back without rounding: it only changes positions of numbers, signs
/// and exponents.
template <class Back>
Verdict exactly_mapped(const Evidence& e, const Related& related, const Back& back) {
  const auto answer = outcome_of(related);
  if (const auto* verdict = std::get_if<Verdict>(&answer)) {
    return *verdict;
  }
  const oracles::LiftedOutcome& mapped = *std::get<const oracles::LiftedOutcome*>(answer);
  if (has_two_answers(e, e.exact_case)) {
    return between_two_answers();
  }
  if (is_surely_finite(e, e.exact_case, e.outcome) && mapped.is_moderate()) {
    const ReportedOutcome mapped_back = back(*mapped.reported());
    if (same_numbers(mapped_back, *e.outcome.reported())) {
      count(oracles::Stage::same_bits);
      return {};
    }
    const oracles::Sensitivity below = sensitivity_below(e, e.exact_case);
    if (surely_near(back(mapped.enclosed()), e.outcome.enclosed(), e.allowance(), weighted_sum(1, below, below))) {
      return {};
    }
  }
  const auto sensitivity = sensitivity_of(e, e.exact_case);
  if (!sensitivity) {
    const oracles::Sensitivity below = sensitivity_below(e, e.exact_case);
    return agree_below(e, mapped, back, e.outcome, weighted_sum(1, below, below));
  }
  return agree(e, mapped, back, e.outcome, weighted_sum(1, *sensitivity, *sensitivity));
}

/// Whether the law determines the answers to both related collisions, if it determines the answer to the case. Both
/// have the same lever arms, the same approach, and so the same friction.
bool determines_answers(const Evidence& e, const oracles::ExactCase& first_case) {
  const Collision& c = e.exact_case.collision();
  const Collision& first = first_case.collision();
  const bool is_alike = first.point == c.point && first.a.position == c.a.position &&
                        first.b.position == c.b.position && first_case.state() == e.exact_case.state();
  return e.law != Law::coulomb || is_alike || oracles::has_one_coulomb_answer(first_case, e.allowance());
}

/// `expected` maps the outcome of the first related collision to that of the second. Each outcome may have its own
/// error; `expected` multiplies the first error by `factor`.
template <class Expected>
Verdict related_pair(const Evidence& e, std::span<const Related> related, double factor, const Expected& expected) {
  const auto first = outcome_of(related[0]);
  const auto second = outcome_of(related[1]);
  for (const auto* answer : {&first, &second}) {
    if (const auto* verdict = std::get_if<Verdict>(answer)) {
      return *verdict;
    }
  }
  const oracles::ExactCase& first_case = related[0].exact_case;
  const oracles::ExactCase& second_case = related[1].exact_case;
  const oracles::LiftedOutcome& first_outcome = *std::get<const oracles::LiftedOutcome*>(first);
  const oracles::LiftedOutcome& second_outcome = *std::get<const oracles::LiftedOutcome*>(second);
  if (has_two_answers(e, first_case) || has_two_answers(e, second_case)) {
    return between_two_answers();
  }
  if (!determines_answers(e, first_case)) {
    return without_one_answer();
  }
  if (is_surely_finite(e, first_case, first_outcome) && is_surely_finite(e, second_case, second_outcome)) {
    const Outcome<oracles::Enclosure> second_expected = expected(first_outcome.enclosed());
    const auto agree_by = [&](const oracles::Sensitivity& of_first, const oracles::Sensitivity& of_second) {
      return surely_near(second_expected, second_outcome.enclosed(), e.allowance(),
                         weighted_sum(factor, of_first, of_second));
    };
    if (agree_by(first_case.norms_before(), second_case.norms_before()) ||
        agree_by(sensitivity_below(e, first_case), sensitivity_below(e, second_case))) {
      return {};
    }
  }
  const auto of_first = sensitivity_of(e, first_case);
  const auto of_second = sensitivity_of(e, second_case);
  if (!of_first || !of_second) {
    return agree_below(e, first_outcome, expected, second_outcome,
                       weighted_sum(factor, sensitivity_below(e, first_case), sensitivity_below(e, second_case)));
  }
  return agree(e, first_outcome, expected, second_outcome, weighted_sum(factor, *of_first, *of_second));
}

/// Applies `polar` to polar vectors, and `axial` to the angular velocities.
template <class Polar, class Axial>
Collision mapped_vectors(Collision c, const Polar& polar, const Axial& axial) {
  for (Body* body : {&c.a, &c.b}) {
    body->position = polar(body->position);
    body->velocity = polar(body->velocity);
    body->angular_velocity = axial(body->angular_velocity);
  }
  c.point = polar(c.point);
  c.normal = polar(c.normal);
  return c;
}

template <class T, class Polar, class Axial>
Outcome<T> mapped_vectors(const Outcome<T>& y, const Polar& polar, const Axial& axial) {
  return {{polar(y.a.velocity), axial(y.a.angular_velocity)}, {polar(y.b.velocity), axial(y.b.angular_velocity)}};
}

/// Takes axis `from` to axis `to`, and axis `to` to the negative axis `from`.
struct QuarterTurn {
  int from;
  int to;

  template <class S>
  [[nodiscard]] Vector3<S> operator()(const Vector3<S>& v) const {
    Vector3<S> turned = v;
    turned[to] = v[from];
    turned[from] = -v[to];
    return turned;
  }
  [[nodiscard]] QuarterTurn inverse() const { return {to, from}; }
};

constexpr QuarterTurn about_z{0, 1};
constexpr QuarterTurn about_x{1, 2};

/// A quarter turn of the plane, or without a plane two turns of space.
std::vector<QuarterTurn> turns_in(const Kinds& kinds) {
  const std::optional<int> axis = normal_axis(kinds);
  return axis ? std::vector{QuarterTurn{(*axis + 1) % 3, (*axis + 2) % 3}} : std::vector{about_z, about_x};
}

/// Let R be the rotation of a body, and T the quarter turn. The orientation becomes T R Tᵀ, and two principal moments
/// change places. This is exact. The alternative, T R with the same moments, would need √½ in the quaternion.
Collision turned(const Collision& collision, const QuarterTurn& turn) {
  Collision c = mapped_vectors(collision, turn, turn);
  for (Body* body : {&c.a, &c.b}) {
    body->orientation.tail<3>() = turn(Vector3<double>(body->orientation.tail<3>()));
    std::swap(body->principal_inertia[turn.from], body->principal_inertia[turn.to]);
  }
  return c;
}

template <class S>
Vector3<S> mirrored_polar(Vector3<S> v) {
  v[0] = -v[0];
  return v;
}

template <class S>
Vector3<S> mirrored_axial(Vector3<S> v) {
  v[1] = -v[1];
  v[2] = -v[2];
  return v;
}

/// The units of mass, length and time change by these powers of two, so the unit of every computed quantity changes.
/// Exponents 5, −3 and 2 would keep the unit of impulse.
constexpr int mass_exponent = 5;
constexpr int length_exponent = -3;
constexpr int time_exponent = 1;

template <class T>
T times_power_of_two(const T& number, int exponent) {
  return number * T(std::ldexp(1.0, exponent));
}

/// An exponent e such that every component is below 2^e in size; 1 if all components are zero.
int exponent_above(std::initializer_list<const Vector3<double>*> of) {
  double largest = 0;
  for (const auto* vector : of) {
    largest = std::max(largest, vector->cwiseAbs().maxCoeff());
  }
  return largest > 0 ? std::ilogb(largest) + 1 : 1;
}

/// Rounds to multiples of 2^(exponent − 48). Sums of such multiples below 2^(exponent + 1) are exact in binary64.
Vector3<double> on_grid(const Vector3<double>& vector, int exponent) {
  Vector3<double> result;
  for (int i = 0; i < 3; ++i) {
    result[i] = std::ldexp(std::round(std::ldexp(vector[i], 48 - exponent)), exponent - 48);
  }
  return result;
}

Vector3<double> offset(int exponent) { return Vector3<double>{1, -0.5, 0.75} * std::ldexp(1.0, exponent); }

/// Rounds to 50 bits, so that three times each component is exact.
Vector3<double> to_50_bits(const Vector3<double>& vector) {
  return vector.unaryExpr([](double x) { return rounded_to_bits(x, 50); });
}

constexpr double velocity_factor = 3;

template <class T>
decltype(auto) collision_in(const oracles::ExactCase& exact_case) {
  if constexpr (std::is_same_v<T, Rational>) {
    return exact_case.exact();
  } else if constexpr (std::is_same_v<T, oracles::Enclosure>) {
    return exact_case.enclosed();
  } else {
    return exact_case.collision();
  }
}

/// The outcome plus the change of velocity from the first to the second related collision. The two collisions have the
/// same angular velocities.
template <class T>
Outcome<T> plus_added_velocity(const Outcome<T>& y, std::span<const Related> related) {
  const auto& from = collision_in<T>(related[0].exact_case);
  const auto& to = collision_in<T>(related[1].exact_case);
  const auto shifted = [&](const BodyVelocity<T>& motion, const auto& before, const auto& after) {
    return BodyVelocity<T>{
        Vector3<T>(motion.velocity + (after.velocity.template cast<T>() - before.velocity.template cast<T>())),
        motion.angular_velocity};
  };
  return {shifted(y.a, from.a, to.a), shifted(y.b, from.b, to.b)};
}

std::vector<Collision> ask_swap(const Collision& collision, const Kinds&) {
  Collision swapped = collision;
  std::swap(swapped.a, swapped.b);
  swapped.normal = -swapped.normal;
  return {swapped};
}

Verdict check_swap(const Evidence& e, std::span<const Related> related) {
  return exactly_mapped(e, related[0], [](auto y) {
    std::swap(y.a, y.b);
    return y;
  });
}

std::vector<Collision> ask_galilean(const Collision& collision, const Kinds& kinds) {
  const int exponent = exponent_above({&collision.a.velocity, &collision.b.velocity});
  Collision rounded = collision;
  rounded.a.velocity = on_grid(collision.a.velocity, exponent);
  rounded.b.velocity = on_grid(collision.b.velocity, exponent);
  Collision moving = rounded;
  moving.a.velocity += in_plane(kinds, offset(exponent));
  moving.b.velocity += in_plane(kinds, offset(exponent));
  return {rounded, moving};
}

Verdict check_added_velocity(const Evidence& e, std::span<const Related> related) {
  return related_pair(e, related, 1, [&](const auto& y) { return plus_added_velocity(y, related); });
}

std::vector<Collision> ask_translation(const Collision& collision, const Kinds& kinds) {
  const int exponent = exponent_above({&collision.a.position, &collision.b.position, &collision.point});
  Collision rounded = collision;
  for (Vector3<double>* place : {&rounded.a.position, &rounded.b.position, &rounded.point}) {
    *place = on_grid(*place, exponent);
  }
  Collision translated = rounded;
  for (Vector3<double>* place : {&translated.a.position, &translated.b.position, &translated.point}) {
    *place += in_plane(kinds, offset(exponent));
  }
  return {rounded, translated};
}

Verdict check_translation(const Evidence& e, std::span<const Related> related) {
  return related_pair(e, related, 1, [](const auto& y) { return y; });
}

std::vector<Collision> ask_rotation(const Collision& collision, const Kinds& kinds) {
  std::vector<Collision> rotated;
  for (const QuarterTurn& turn : turns_in(kinds)) {
    rotated.push_back(turned(collision, turn));
  }
  return rotated;
}

Verdict check_rotation(const Evidence& e, std::span<const Related> related) {
  const std::vector<QuarterTurn> turns = turns_in(e.kinds);
  Verdict worst;
  for (std::size_t i = 0; i < turns.size(); ++i) {
    worst = both(std::move(worst), exactly_mapped(e, related[i], [back = turns[i].inverse()](const auto& y) {
                   return mapped_vectors(y, back, back);
                 }));
  }
  return worst;
}

std::vector<Collision> ask_reflection_symmetry(const Collision& collision, const Kinds&) {
  Collision mirrored = mapped_vectors(collision, mirrored_polar<double>, mirrored_axial<double>);
  for (Body* body : {&mirrored.a, &mirrored.b}) {
    body->orientation.tail<3>() = mirrored_axial(Vector3<double>(body->orientation.tail<3>()));
  }
  return {mirrored};
}

Verdict check_reflection_symmetry(const Evidence& e, std::span<const Related> related) {
  return exactly_mapped(e, related[0], [](const auto& y) {
    const auto polar = [](const auto& v) { return mirrored_polar(v); };
    const auto axial = [](const auto& v) { return mirrored_axial(v); };
    return mapped_vectors(y, polar, axial);
  });
}

std::vector<Collision> ask_unit_scaling(const Collision& collision, const Kinds&) {
  const double mass = std::ldexp(1.0, mass_exponent);
  const double length = std::ldexp(1.0, length_exponent);
  const double time = std::ldexp(1.0, time_exponent);
  Collision scaled = collision;
  for (Body* body : {&scaled.a, &scaled.b}) {
    body->mass *= mass;
    body->principal_inertia *= mass * length * length;
    body->position *= length;
    body->velocity *= length / time;
    body->angular_velocity /= time;
  }
  scaled.point *= length;
  return {scaled};
}

Verdict check_unit_scaling(const Evidence& e, std::span<const Related> related) {
  return exactly_mapped(e, related[0], [](auto back) {
    for (auto* motion : {&back.a, &back.b}) {
      for (int i = 0; i < 3; ++i) {
        motion->velocity[i] = times_power_of_two(motion->velocity[i], time_exponent - length_exponent);
        motion->angular_velocity[i] = times_power_of_two(motion->angular_velocity[i], time_exponent);
      }
    }
    return back;
  });
}

std::vector<Collision> ask_homogeneous(const Collision& collision, const Kinds&) {
  Collision rounded = collision;
  for (Body* body : {&rounded.a, &rounded.b}) {
    body->velocity = to_50_bits(body->velocity);
    body->angular_velocity = to_50_bits(body->angular_velocity);
  }
  Collision faster = rounded;
  for (Body* body : {&faster.a, &faster.b}) {
    body->velocity *= velocity_factor;
    body->angular_velocity *= velocity_factor;
  }
  return {rounded, faster};
}

Verdict check_homogeneous(const Evidence& e, std::span<const Related> related) {
  return related_pair(e, related, velocity_factor, [](const auto& y) {
    using T = std::decay_t<decltype(y.a.velocity[0])>;
    return map_outcome<T>(y, [](const T& number) { return T(number * T(velocity_factor)); });
  });
}

/// In the first collision, the bodies meet head-on without spin. The second adds a tangential velocity, 2⁻³⁰ times as
/// fast as the approach. The normal is rounded to 20 bits, so both collisions are exact.
std::vector<Collision> ask_continuous(const Collision& collision, const Kinds& kinds) {
  const int exponent = exponent_above({&collision.normal});
  Collision head_on = collision;
  for (int i = 0; i < 3; ++i) {
    head_on.normal[i] = std::round(std::ldexp(collision.normal[i], 20 - exponent));
  }
  for (Body* body : {&head_on.a, &head_on.b}) {
    body->velocity.setZero();
    body->angular_velocity.setZero();
  }
  const Vector3<double> approach = head_on.normal * std::ldexp(1.0, -20);
  const Vector3<double> across = normal_axis(kinds) ? turns_in(kinds).front()(approach) : orthogonal(approach);
  const Vector3<double> tangential = across * std::ldexp(1.0, -30);
  Collision oblique = head_on;
  if (collision.a.immovable) {
    head_on.b.velocity = approach;
    oblique.b.velocity = approach + tangential;
  } else {
    head_on.a.velocity = -approach;
    oblique.a.velocity = tangential - approach;
  }
  return {head_on, oblique};
}

std::vector<Collision> ask_repeat(const Collision& collision, const Outcome<double>& outcome, const Kinds& kinds) {
  Collision second = with_velocities(collision, outcome);
  stop_outside(kinds, second);  // takes rounding out of a plane
  return {second};
}

/// A bound of the error of N·V⁺, divided by the allowance.
double slack_of_separation(const Evidence& e) {
  const Collision& c = e.exact_case.collision();
  const oracles::Sensitivity sensitivity = e.exact_case.sensitivity_with_noise(e.law, e.yardstick);
  const auto moment = [&](const Body& body) {
    return Vector3<double>(oracles::lever_arm<double>(body, c.point)).cross(c.normal).lpNorm<1>();
  };
  const double normal = c.normal.lpNorm<1>();
  return normal * (sensitivity[OutcomeVector::velocity_of_a] + sensitivity[OutcomeVector::velocity_of_b]) +
         moment(c.a) * sensitivity[OutcomeVector::angular_velocity_of_a] +
         moment(c.b) * sensitivity[OutcomeVector::angular_velocity_of_b];
}

Verdict check_repeat(const Evidence& e, std::span<const Related> related) {
  if (e.exact_case.state() != oracles::ContactState::colliding || e.exact_case.collision().restitution == 0) {
    return does_not_apply("the contact is not colliding, or ε = 0");
  }
  const Collision& c = e.exact_case.collision();
  const double approach = std::abs(c.normal.dot(relative_velocity(c)));
  if (c.restitution * approach <= 2 * e.allowance() * slack_of_separation(e)) {
    return does_not_apply("the separation after the impulse is within rounding");
  }
  const Related& second = related[0];
  // The question has the velocities of the first outcome, with its permitted error, rounded to binary64.
  if (second.exact_case.is_grazing(2 * e.allowance() + unit_roundoff(Precision::binary64))) {
    return does_not_apply("after the impulse, rounding decides whether the contact collides");
  }
  const auto answer = outcome_of(second);
  if (const auto* verdict = std::get_if<Verdict>(&answer)) {
    return *verdict;
  }
  const oracles::LiftedOutcome& after = *std::get<const oracles::LiftedOutcome*>(answer);
  if (is_surely_untouched(second.exact_case, after, e.yardstick)) {
    return {};
  }
  Verdict worst;
  for (const OutcomeVector k : all_outcome_vectors) {
    worst = both(std::move(worst),
                 verdict_of(oracles::compare(oracles::equation::Untouched{k}, oracles::EquationForm::equal,
                                             second.exact_case, after, e.yardstick),
                            fmt::format("{}, after a second impulse and before it", name_of(k))));
  }
  return worst;
}

/// Under `coulomb`, the gate asks where the law certainly has one answer.
std::vector<Law> with_one_answer() {
  std::vector<Law> laws = with_truth();
  laws.push_back(Law::coulomb);
  return laws;
}

}  // namespace

std::vector<Invariant> relation_invariants() {
  return {
      Invariant{"swap", "If A and B are swapped and the normal is reversed, each body has the same outcome.",
                R"(y(B, A, -N) = (y_B, y_A)(A, B, N))", "Newton's third law; failure case 19", "valid collisions",
                with_one_answer(), AboutRelation{ask_swap, check_swap},
                Proof{ProvedOf::its_laws, {{"swap", "relations.v"}}}, explains_none,
                [](const Kinds& kinds) { return kinds.movable != Movable::a && kinds.movable != Movable::b; }},
      Invariant{"galilean",
                "If both bodies get an additional common velocity, the outcome gets the same additional velocity.",
                R"(y(v_A + c, v_B + c) = y(v_A, v_B) + c)", "Galilean invariance",
                "valid collisions with velocities rounded to a grid, so that the sum is exact", with_one_answer(),
                AboutRelation{ask_galilean, check_added_velocity},
                Proof{ProvedOf::its_laws, {{"galilean", "relations.v"}}}, explains_none,
                [](const Kinds& kinds) {
                  return kinds.walls == Walls::any || kinds.movable == Movable::any || kinds.movable == Movable::both;
                }},
      Invariant{"translation", "The outcome does not depend on the position of the origin.",
                R"(y(X + t, P + t) = y(X, P))", "homogeneity of space",
                "valid collisions with positions rounded to a grid, so that the sum is exact", with_one_answer(),
                AboutRelation{ask_translation, check_translation},
                Proof{ProvedOf::its_laws, {{"translation", "relations.v"}}}},
      Invariant{"rotation", "If the collision is rotated by 90°, the outcome is rotated by 90°.", R"(y(T x) = T y(x))",
                "isotropy of space", "valid collisions, rotated about z and about x", with_one_answer(),
                AboutRelation{ask_rotation, check_rotation},
                Proof{ProvedOf::its_laws, {{"rotation", "relations.v"}, {"answer_turned", "turned_descriptions.v"}}}},
      Invariant{"reflection_symmetry", "The outcome of a mirrored collision is the mirrored outcome.",
                R"(y(M x) = M y(x))", "parity; angular velocities are axial vectors",
                "valid collisions, mirrored in x = 0", with_one_answer(),
                AboutRelation{ask_reflection_symmetry, check_reflection_symmetry},
                Proof{ProvedOf::its_laws,
                      {{"reflection_symmetry", "relations.v"}, {"answer_mirrored", "turned_descriptions.v"}}}},
      Invariant{"unit_scaling", "The outcome does not depend on the units of mass, length and time.",
                R"(y(2^a \mathrm{kg}, 2^b \mathrm{m}, 2^c \mathrm{s}) = y(\mathrm{kg}, \mathrm{m}, \mathrm{s}))",
                "dimensional analysis; failure cases 21, 31", "valid collisions", with_one_answer(),
                AboutRelation{ask_unit_scaling, check_unit_scaling},
                Proof{ProvedOf::its_laws, {{"unit_scaling", "relations.v"}}}},
      Invariant{"homogeneous", "If the velocities are multiplied by 3, the outcome is multiplied by 3.",
                R"(y(k V) = k\, y(V),\ k = 3)",
                "the laws are positively homogeneous in the velocities; failure cases 21, 38",
                "valid collisions, velocities rounded to 50 bits", with_one_answer(),
                AboutRelation{ask_homogeneous, check_homogeneous},
                Proof{ProvedOf::its_laws, {{"homogeneous", "relations.v"}}}},
      Invariant{"continuous",
                "A small tangential velocity changes the outcome little: for v_t → 0 the outcome converges to the "
                "head-on one.",
                R"(y(v_n, v_t) - (v_n, v_t) = y(v_n, 0) - (v_n, 0),\ v_t = 2^{-30} v_n)",
                "the laws depend on N·V⁻ alone; failure cases 3, 4",
                "valid collisions, changed to head-on contacts without spin",
                std::vector{Law::frictionless, Law::reflection}, AboutRelation{ask_continuous, check_added_velocity}},
      Invariant{"repeat", "A second impulse does not change the outcome.",
                R"(\varepsilon > 0 \Rightarrow y(x \text{ with } y(x)) = y(x))", "note eq. 17",
                "colliding contacts with ε > 0", with_truth(), AboutRelation{ask_repeat, check_repeat},
                Proof{ProvedOf::its_laws, {{"repeat_of_every_law", "every_law.v"}, {"repeat", "laws_of_impulse.v"}}}}};
}

}  // namespace carom::properties
