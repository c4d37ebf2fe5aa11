// SPDX-License-Identifier: BSL-1.0
#include <algorithm>
#include <array>
#include <cmath>
#include <span>
#include <type_traits>
#include <utility>

#include <fmt/format.h>

#include <carom/oracles/bounds/lazy.hpp>
#include <carom/oracles/bounds/lifted_outcome.hpp>
#include <carom/oracles/bounds/slopes.hpp>
#include <carom/oracles/judge/compare.hpp>
#include <carom/oracles/judge/exact_case.hpp>
#include <carom/oracles/truths/models.hpp>
#include <carom/properties/records/broken_words.hpp>
#include <carom/properties/records/judged_record.hpp>

namespace carom::properties::records {
namespace {

namespace equation = oracles::equation;
using oracles::Equation;
using oracles::EquationForm;

/// F as the law `rough` demands it on this branch, and F from the velocities.
struct RoughImpulse {
  oracles::Branch branch;
  bool read_off_a;

  template <class T>
  [[nodiscard]] oracles::Sides<T, 3> operator()(const BasicCollision<T>& c, const Outcome<T>& after) const {
    return {oracles::impulse_on_a(c, after, read_off_a), oracles::colliding_impulse<T>(c, Law::rough, branch)};
  }
  [[nodiscard]] std::string words(const Collision& c, const Outcome<double>& after) const {
    const auto sides = (*this)(c, after);
    const Vector3<double> difference = sides.left - sides.right;
    return fmt::format("impulse: it differs from that of the law by {:.5g} N s of {:.5g}, most along {}",
                       difference.norm(), sides.right.norm(), worst_axis(difference));
  }
};

/// λ² ‖F‖² and (1 + e)² ‖V⁻‖², with the largest tangential restitution e that the record permits.
struct WidestBound {
  bool read_off_a;
  bool is_known;  // whether ε and e_t are recorded

  template <class T>
  [[nodiscard]] oracles::Sides<T, 1> operator()(const BasicCollision<T>& c, const Outcome<T>& after) const {
    const Vector3<T> impulse = oracles::inverse_mass(c) * oracles::impulse_on_a(c, after, read_off_a);
    const Vector3<T> before = oracles::relative_velocity<T>(c, unchanged(c));
    T factor(2);
    if (is_known) {
      const bool is_tangential = number(c.tangential_restitution) > number(c.restitution);
      factor = T(1) + (is_tangential ? c.tangential_restitution : c.restitution);
    }
    return {oracles::Scalar1<T>(impulse.dot(impulse)), oracles::Scalar1<T>(T(factor * factor * before.dot(before)))};
  }
  [[nodiscard]] std::string words(const Collision& c, const Outcome<double>& after) const {
    const auto sides = (*this)(c, after);
    return fmt::format("the impulse is too large: it changes velocities by {:.5g} m/s, at most {:.5g} is possible",
                       std::sqrt(sides.left[0]), std::sqrt(sides.right[0]));
  }

 private:
  template <class T>
  static double number(const T& x) {
    if constexpr (std::is_same_v<T, double>) {
      return x;
    } else {
      return x.value;
    }
  }
};

/// Half units of the last digits of a record.
struct HalfUnits {
  std::vector<oracles::Quantity> inputs;  // with half units as lengths
  PerVector<double> before{};             // of the velocities
  PerVector<double> after{};
};

std::optional<OutcomeVector> velocity_named(const FieldPath& path) {
  for (const OutcomeVector k : all_outcome_vectors) {
    const std::string_view name = name_of(k);
    if (name.substr(0, 1) == path.body && name.substr(2) == path.field) {
      return k;
    }
  }
  return std::nullopt;
}

HalfUnits half_units_of(const Record& record, const Resolution& resolution) {
  HalfUnits half;
  std::vector<oracles::Quantity>& quantities = half.inputs;
  std::vector<double> components;
  std::size_t count = 0;
  FieldPath of;
  const auto close = [&] {
    if (components.empty()) {
      return;
    }
    double& length = quantities.back().length;
    length = resolution.half_unit(*recorded_field(FieldPath{of.body, of.field}.text()), components);
    const Record::Shape& shape = record.shapes.at(of.body == "a" ? 0 : 1);
    if (of.field == "principal_inertia" && shape.length != 0) {
      const double mass = (of.body == "a" ? record.collision.a : record.collision.b).mass;
      length = components[0] / mass * resolution.half_unit(RecordedField::mass, {&mass, 1}) +
               std::abs(shape.moments_by_length[of.component]) *
                   resolution.half_unit(RecordedField::size, {&shape.length, 1});
    }
    if (const auto k = velocity_named(of)) {
      half.before[*k] = length;
    }
    components.clear();
  };
  for_each_number(
      [&](const FieldPath& path, const double& number) {
        if (path.component <= 0 || path.field == "principal_inertia") {
          close();
          quantities.push_back({count, 0, 0});
          of = path;
        }
        ++quantities.back().count;
        components.push_back(number);
        ++count;
      },
      record.collision);
  close();
  const auto after = vectors(record.after);
  for (const OutcomeVector k : all_outcome_vectors) {
    half.after[k] = resolution.half_unit(RecordedField::after, {after[k]->data(), 3});
  }
  return half;
}

/// The components of left − right that an inequality does not permit, as a length.
template <int N>
double residual_of(const oracles::Sides<double, N>& sides, EquationForm form) {
  double squares = 0;
  for (Eigen::Index i = 0; i < sides.left.size(); ++i) {
    const double x = sides.left[i] - sides.right[i];
    const bool is_permitted = (form == EquationForm::at_least && x >= 0) || (form == EquationForm::at_most && x <= 0);
    squares += is_permitted ? 0 : x * x;
  }
  return std::sqrt(squares);
}

const Invariant* named(const char* name) {
  const Invariant* const invariant = invariant_named(name);
  CAROM_EXPECTS(invariant != nullptr, name);
  return invariant;
}

/// The results of several checks.
struct Checks {
  std::vector<Broken> broken = {};
  bool is_decided = true;  // false if numbers leave their range

  [[nodiscard]] bool hold() const { return is_decided && broken.empty(); }

  Checks& operator+=(Checks other) {
    std::move(other.broken.begin(), other.broken.end(), std::back_inserter(broken));
    is_decided = is_decided && other.is_decided;
    return *this;
  }
};

class Judge {
 public:
  Judge(const Record& record, const Resolution& resolution)
      : record_(record),
        c_(record.collision),
        is_exact_(resolution.form == Resolution::Form::exact),
        exact_case_(record.collision),
        outcome_(map_outcome<long double>(record.after, [](double x) { return static_cast<long double>(x); })),
        yardstick_(oracles::Yardstick::of(resolution.precision)),
        half_(half_units_of(record, resolution)),
        off_a_(has_movable_body(c_) && oracles::reads_impulse_off_a(c_)) {
    const Outcome<double> before = unchanged(c_);
    const double approach = c_.normal.dot(oracles::relative_velocity<double>(c_, before));
    doubt_ = yardstick_.allowance() * exact_case_.normal_velocity_sensitivity() +
             slack_of(equation::NonPenetration{}, before, half_.before);
    may_collide_ = has_movable_body(c_) && (approach - doubt_ < 0);
    may_separate_ = !has_movable_body(c_) || approach + doubt_ >= 0;
    if (may_collide_) {
      shared_ = shared_checks();
    }
  }
  Judge(const Judge&) = delete;
  Judge& operator=(const Judge&) = delete;

  [[nodiscard]] bool is_judged_by(Law law) const {
    return law != Law::rough || (record_.has_restitution && record_.has_friction && record_.has_tangential_restitution);
  }

  /// If `has_all`, every broken invariant is found, otherwise one.
  [[nodiscard]] Checks by(Law law, bool has_all) const {
    if (!may_collide_) {
      return untouched(true, true);
    }
    Checks colliding = shared_;
    if (has_all || colliding.hold()) {
      colliding += own_checks(law);
    }
    if (may_separate_ && !colliding.hold()) {
      Checks resting = untouched(true, true);
      if (resting.hold()) {
        return resting;
      }
    }
    return colliding;
  }

  [[nodiscard]] bool separates() const { return has_movable_body(c_) && !may_collide_; }
  [[nodiscard]] bool is_direction_open() const { return may_collide_ && may_separate_; }

  [[nodiscard]] Implied implied() const {
    constexpr double most_doubt = 0.05;
    Implied implied;
    const Vector3<double> n = c_.normal.normalized();
    const Vector3<double> before = oracles::relative_velocity<double>(c_, unchanged(c_));
    const Vector3<double> after = oracles::relative_velocity<double>(c_, record_.after);
    const double approach = -n.dot(before);
    if (may_separate_ || doubt_ > most_doubt * approach * c_.normal.norm()) {
      return implied;
    }
    implied.restitution = n.dot(after) / approach;
    const Vector3<double> impulse = oracles::impulse_on_a(c_, record_.after, off_a_);
    const double normal_part = n.dot(impulse);
    if (normal_part > 0 && !sticks().hold()) {
      implied.friction = n.cross(impulse).norm() / normal_part;
    }
    const double slip = n.cross(before).norm();
    // V⁻ is known about as well across the normal as along it.
    if (slip > most_doubt * before.norm() && doubt_ < most_doubt * slip * c_.normal.norm()) {
      const oracles::detail::RoughImpulses<double> of(c_, nullptr);
      const Vector3<double> d = of.difference();
      const Vector3<double> rest = impulse - (1 + *implied.restitution) * of.stops_approach;
      implied.tangential_restitution = rest.dot(d) / d.squaredNorm() - 1;
    }
    return implied;
  }

 private:
  /// The residual that half units of the numbers can cause, to first order. Each number moves alone, because this takes
  /// less time than differentiation.
  template <class OneEquation>
  [[nodiscard]] double slack_of(const OneEquation& one, const Outcome<double>& at,
                                const PerVector<double>& of_outputs) const {
    if (is_exact_) {
      return 0;
    }
    Collision moved = c_;
    std::vector<double*> numbers;
    for_each_number([&](const FieldPath& /*path*/, double& number) { numbers.push_back(&number); }, moved);
    const auto difference = [](const auto& sides) { return (sides.left - sides.right).eval(); };
    const auto here = difference(one(c_, at));
    const auto squared_change = [&](double& number, double by, const auto& sides) {
      const double kept = std::exchange(number, number + by);
      const double squared = (difference(sides()) - here).squaredNorm();
      number = kept;
      return squared;
    };
    double slack = 0;
    for (const oracles::Quantity& q : half_.inputs) {
      double squares = 0;
      for (std::size_t j = q.first; q.length > 0 && j < q.first + q.count; ++j) {
        squares += squared_change(*numbers[j], q.length, [&] { return one(moved, at); });
      }
      slack += std::sqrt(squares);
    }
    Outcome<double> after = at;
    const auto outputs = vectors(after);
    for (const OutcomeVector k : all_outcome_vectors) {
      double squares = 0;
      for (int i = 0; of_outputs[k] > 0 && i < 3; ++i) {
        squares += squared_change((*outputs[k])[i], of_outputs[k], [&] { return one(c_, after); });
      }
      slack += std::sqrt(squares);
    }
    return slack;
  }

  [[nodiscard]] Checks check(const char* invariant, const Equation& equation,
                             EquationForm form = EquationForm::equal) const {
    return std::visit(
        [&](const auto& one) -> Checks {
          const double residual = residual_of(one(c_, record_.after), form);
          const double slack = residual == 0 ? 0 : slack_of(one, record_.after, half_.after);
          if (residual <= slack) {
            return {};
          }
          const oracles::EquationCheck exactly = oracles::compare(equation, form, exact_case_, outcome_, yardstick_);
          if (!exactly.is_decided) {
            return {{}, false};
          }
          if (exactly.holds || exactly.residual <= exactly.allowed + slack) {
            return {};
          }
          return {{{named(invariant), exactly.residual / (exactly.allowed + slack),
                    broken_words(equation, c_, record_.after)}}};
        },
        equation);
  }

  /// The check of an equation that the judge of the gate does not know, in binary64.
  template <class OneEquation>
  [[nodiscard]] Checks check_here(const char* invariant, const OneEquation& one, EquationForm form) const {
    const double residual = residual_of(one(c_, record_.after), form);
    if (residual == 0) {
      return {};
    }
    double scale = oracles::part_by_inputs(one, exact_case_.differentiated(), record_.after);
    const PerVector<double> slopes = oracles::output_slopes<double, oracles::outcome_inputs>(one, c_, record_.after);
    for (const OutcomeVector k : all_outcome_vectors) {
      scale += slopes[k] * (outcome_.norms()[k] + exact_case_.norms_before()[k]);
    }
    const double permitted = yardstick_.allowance() * scale + slack_of(one, record_.after, half_.after);
    if (!std::isfinite(residual) || !std::isfinite(permitted)) {
      return {{}, false};
    }
    return residual <= permitted ? Checks{}
                                 : Checks{{{named(invariant), residual / permitted, one.words(c_, record_.after)}}};
  }

  [[nodiscard]] const Checks& sticks() const {
    return sticks_.get([this] { return check("sticks", equation::Sticks{}); });
  }

  /// The velocities of the bodies that keep them.
  [[nodiscard]] Checks untouched(bool of_a, bool of_b) const {
    Checks checks;
    for (const bool a : {true, false}) {
      if (!(a ? of_a : of_b)) {
        continue;
      }
      const char* const name = (a ? c_.a : c_.b).immovable ? "immovable_untouched" : "separating_untouched";
      for (const OutcomeVector vector : vectors_of_body(a)) {
        checks += check(name, equation::Untouched{vector});
      }
    }
    return checks;
  }

  /// The demands of all laws on a contact that collides.
  [[nodiscard]] Checks shared_checks() const {
    Checks checks = untouched(c_.a.immovable, c_.b.immovable);
    if (!c_.a.immovable && !c_.b.immovable) {
      checks += check("linear_momentum", equation::LinearMomentum{});
    }
    for (const bool a : {true, false}) {
      if (!(a ? c_.a : c_.b).immovable) {
        checks += check("angular_momentum", equation::AngularMomentum{a});
      }
    }
    if (record_.has_restitution) {
      return checks += check("restitution", equation::Restitution{});
    }
    checks += check("non_penetration", equation::NonPenetration{}, EquationForm::at_least);
    return checks += check("parting_speed", equation::PartingSpeed{true}, EquationForm::at_most);
  }

  /// The further demands of the law.
  [[nodiscard]] Checks own_checks(Law law) const {
    switch (law) {
      case Law::frictionless:
        return check("frictionless_direction", equation::FrictionlessDirection{off_a_});
      case Law::reflection:
        return check("reflection_plane", equation::ReflectionPlane{});
      case Law::sticking:
        return sticks();
      case Law::rough:
        return rough_checks();
      case Law::coulomb:
        return coulomb_checks();
      case Law::any:
        break;
    }
    const bool is_known = record_.has_restitution && record_.has_tangential_restitution;
    return check_here("impulse_bound", WidestBound{off_a_, is_known}, EquationForm::at_most);
  }

  [[nodiscard]] Checks rough_checks() const {
    const oracles::Branch branch = exact_case_.branch(Law::rough);
    Checks checks = check_here("backward_error", RoughImpulse{branch, off_a_}, EquationForm::equal);
    if (!checks.hold() && branch != oracles::Branch::only) {
      // The digits may leave open whether the impulse reaches the cone.
      Checks cone = check("friction_cone", equation::FrictionCone{off_a_}, EquationForm::equal);
      Checks other =
          check_here("backward_error", RoughImpulse{oracles::other_side(branch), off_a_}, EquationForm::equal);
      if (cone.hold() && other.hold()) {
        return other;
      }
    }
    return checks;
  }

  [[nodiscard]] Checks coulomb_checks() const {
    Checks checks = check("push", equation::Push{off_a_}, EquationForm::at_least);
    if (record_.has_friction) {
      checks += check("friction_cone", equation::FrictionCone{off_a_}, EquationForm::at_most);
    }
    if (sticks().hold()) {
      return checks;
    }
    if (record_.has_friction) {
      checks += check("slip_opposed", equation::FrictionCone{off_a_}, EquationForm::at_least);
    }
    checks += check("slip_opposed", equation::FrictionAlongSlip{off_a_});
    return checks += check("slip_opposed", equation::FrictionAgainstSlip{off_a_}, EquationForm::at_most);
  }

  const Record& record_;
  const Collision& c_;
  bool is_exact_;
  oracles::ExactCase exact_case_;
  oracles::LiftedOutcome outcome_;
  oracles::Yardstick yardstick_;
  HalfUnits half_;
  bool off_a_;        // whether the velocities of A give the impulse
  double doubt_ = 0;  // of N·V⁻
  bool may_collide_ = false;
  bool may_separate_ = false;
  Checks shared_ = {};
  oracles::Lazy<Checks> sticks_;
};

bool is_finite(const Outcome<double>& outcome) {
  const auto all = vectors(outcome);
  return std::all_of(all.begin(), all.end(), [](const Vector3<double>* v) { return v->allFinite(); });
}

}  // namespace

JudgedRecord judged(const Record& record, const Resolution& resolution, Law law, bool all_laws) {
  JudgedRecord result;
  if (!is_finite(record.after)) {
    for (const Law one : all_laws ? std::span<const Law>(carom::all_laws) : std::span<const Law>(&law, 1)) {
      result.satisfied[one] = false;
    }
    result.broken.push_back({.invariant = named("finite"), .words = "the velocities after contain infinities or NaN"});
    return result;
  }
  const Judge judge(record, resolution);
  for (const Law one : all_laws ? std::span<const Law>(carom::all_laws) : std::span<const Law>(&law, 1)) {
    if (!judge.is_judged_by(one)) {
      continue;
    }
    Checks checks = judge.by(one, one == law);
    if (checks.is_decided || !checks.broken.empty()) {
      result.satisfied[one] = checks.broken.empty();
    }
    if (one == law) {
      result.broken = std::move(checks.broken);
    }
  }
  std::stable_sort(result.broken.begin(), result.broken.end(), [](const Broken& x, const Broken& y) {
    return std::pair(x.invariant->rank_as_cause, -x.ratio) < std::pair(y.invariant->rank_as_cause, -y.ratio);
  });
  if (has_movable_body(record.collision)) {
    result.implied = judge.implied();
  }
  result.separates = judge.separates();
  if (!result.broken.empty() || judge.is_direction_open()) {
    Record reversed = record;
    reversed.collision.normal = -record.collision.normal;
    result.holds_reversed = Judge(reversed, resolution).by(law, false).hold();
  }
  return result;
}

}  // namespace carom::properties::records
