// SPDX-License-Identifier: BSL-1.0
#include <cmath>
#include <optional>
#include <type_traits>

#include <carom/collision/expects.hpp>
#include <carom/oracles/bounds/moderate.hpp>
#include <carom/oracles/bounds/norm.hpp>
#include <carom/oracles/bounds/quantities.hpp>
#include <carom/oracles/bounds/slopes.hpp>
#include <carom/oracles/bounds/stage.hpp>
#include <carom/oracles/judge/compare.hpp>
#include <carom/oracles/judge/norm_at_most.hpp>
#include <carom/oracles/judge/permitted_residual.hpp>

namespace carom::oracles {
namespace {

/// The components of left − right that an inequality does not permit. For an equation, all components.
template <class T, int N, class IsPermitted>
Components<T> missing(const Sides<T, N>& sides, EquationForm form, const IsPermitted& is_permitted) {
  Components<T> all = difference(sides.left, sides.right);
  if (form == EquationForm::equal) {
    return all;
  }
  const int permitted_sign = form == EquationForm::at_least ? 1 : -1;
  Components<T> result;
  for (const T& x : all) {
    if (!is_permitted(x, permitted_sign)) {
      result.push_back(x);
    }
  }
  return result;
}

/// `missing`, plus the components of uncertain sign.
template <int N>
Components<Enclosure> possibly_missing(const Sides<Enclosure, N>& sides, EquationForm form) {
  return missing(sides, form, [](const Enclosure& x, int sign) { return x.sign().value_or(-sign) != -sign; });
}

/// The errors of the outputs by underflow, divided by u. An operation that underflows has an error of η = u s, the
/// least positive number. F has an error of (1 + m) η: η of its own, and m η by the approach velocity in the formula of
/// F. So F / m has an error of (1 + 1/m) η, and r × F one of (1 + ‖r‖ + m ‖r‖) η.
PerVector<double> lost_to_underflow(const Collision& c, double s) {
  PerVector<double> lost{};
  const auto add = [&](const Body& body, OutcomeVector velocity, OutcomeVector spin) {
    if (!body.immovable) {
      const double r = norm_of(Vector3<double>(c.point - body.position));
      lost[velocity] = s * (1 + 1 / body.mass);
      lost[spin] = s * (1 + (1 + r + body.mass * r) / body.principal_inertia.minCoeff());
    }
  };
  if (s > 0) {
    add(c.a, OutcomeVector::velocity_of_a, OutcomeVector::angular_velocity_of_a);
    add(c.b, OutcomeVector::velocity_of_b, OutcomeVector::angular_velocity_of_b);
  }
  return lost;
}

/// ‖ŷ_k‖ + ‖y_k⁻‖ plus the loss by underflow and the noise. ŷ_k is the sum of y_k⁻ and a change, so ŷ_k has an error of
/// u times the larger of these two terms, even if ŷ_k is zero.
PerVector<double> sizes_of_outputs(const ExactCase& exact_case, const LiftedOutcome& outcome,
                                   const Yardstick& yardstick) {
  PerVector<double> sizes = lost_to_underflow(exact_case.collision(), yardstick.least_size());
  const PerVector<double> norms = outcome.norms();
  for (const OutcomeVector k : all_outcome_vectors) {
    sizes[k] += norms[k] + exact_case.norms_before()[k];
  }
  add_permitted_noise(exact_case.collision(), yardstick, sizes);
  return sizes;
}

/// The part of the scale by the outputs: Σ_k ‖∂g/∂ŷ_k‖ times the size of output k.
template <class S>
S part_by_outputs(const PerVector<S>& slopes, const PerVector<double>& sizes) {
  S part(0);
  for (const OutcomeVector k : all_outcome_vectors) {
    part += slopes[k] * static_cast<S>(sizes[k]);
  }
  return part;
}

/// Whether the product of a scale and an allowance stays in the range of binary64.
template <class S>
bool is_in_range(S scale) {
  return scale >= static_cast<S>(smallest_scale) && scale <= static_cast<S>(largest_scale);
}

/// Whether the slopes ‖∂g/∂ŷ_k‖ need the digits of the outcome beyond binary64, because their terms may cancel. The
/// slopes of an affine equation do not depend on the outcome.
template <class OneEquation>
bool needs_all_digits(const OneEquation& equation, const LiftedOutcome& outcome) {
  if constexpr (std::is_convertible_v<const OneEquation&, Equation>) {
    return !equation.name() && outcome.reported() != nullptr && !outcome.is_exactly_rounded();
  } else {
    return false;
  }
}

/// The part of the scale by the outputs, in binary64. The case stores the slopes of an affine equation.
template <class OneEquation>
double part_by_outputs(const OneEquation& equation, const ExactCase& exact_case, const LiftedOutcome& outcome,
                       const PerVector<double>& sizes) {
  const Collision& collision = exact_case.collision();
  if constexpr (std::is_convertible_v<const OneEquation&, Equation>) {
    if (const std::optional<AffineEquation> name = equation.name()) {
      return part_by_outputs(exact_case.slopes(*name, [&] { return slopes_of(equation, collision); }), sizes);
    }
  }
  if (needs_all_digits(equation, outcome)) {
    return static_cast<double>(
        part_by_outputs(output_slopes<long double, outcome_inputs>(equation, collision, *outcome.reported()), sizes));
  }
  return part_by_outputs(output_slopes<double, outcome_inputs>(equation, collision, outcome.rounded()), sizes);
}

/// The second-order error of an equation that is quadratic in the outcome, divided by the allowance α. The slopes do
/// not contain this error. It is 0 for an affine equation.
template <class OneEquation>
double part_by_curvature(const OneEquation& /*affine*/, const ExactCase& /*exact_case*/,
                         const LiftedOutcome& /*outcome*/, double /*allowance*/) {
  return 0;
}
/// The outputs have errors δ_k = α (‖ŷ_k‖ + ‖y_k⁻‖). If the slopes vanish, as for a body that moves with a moving wall,
/// the energy has an error of (m δ_v² + I δ_w²) / 2.
double part_by_curvature(const equation::Energy& /*energy*/, const ExactCase& exact_case, const LiftedOutcome& outcome,
                         double allowance) {
  const PerVector<double> norms = outcome.norms();
  const auto squared = [&](OutcomeVector k) {
    const double size = norms[k] + exact_case.norms_before()[k];
    return size * size;
  };
  const auto of_body = [&](const Body& body, OutcomeVector velocity, OutcomeVector spin) {
    return body.immovable ? 0 : (body.mass * squared(velocity) + body.principal_inertia.maxCoeff() * squared(spin)) / 2;
  };
  const Collision& c = exact_case.collision();
  return allowance * (of_body(c.a, OutcomeVector::velocity_of_a, OutcomeVector::angular_velocity_of_a) +
                      of_body(c.b, OutcomeVector::velocity_of_b, OutcomeVector::angular_velocity_of_b));
}

/// The lever arm moves by α (‖P‖ + ‖X‖ + s), and Δv by α (‖v̂‖ + ‖v⁻‖). If r = 0 and Δv is of the order of rounding, the
/// slopes of r × m Δv vanish, and the product of both changes remains.
double part_by_curvature(const equation::AngularMomentum& of, const ExactCase& exact_case, const LiftedOutcome& outcome,
                         double allowance) {
  const Body& body = of.of_a ? exact_case.collision().a : exact_case.collision().b;
  const OutcomeVector k = of.of_a ? OutcomeVector::velocity_of_a : OutcomeVector::velocity_of_b;
  const double size = outcome.norms()[k] + exact_case.norms_before()[k];
  return allowance * length_of_lever_arm(body, exact_case.collision().point) * body.mass * size;
}

/// F has an error of δ = α m (‖v̂‖ + ‖v⁻‖), with the mass and the velocities of the body whose velocity change gives F.
/// If the slopes vanish, ‖N × F‖² has an error of ‖N‖² δ², and (μ N·F)² one of μ² ‖N‖² δ².
double part_by_curvature(const equation::FrictionCone& cone, const ExactCase& exact_case, const LiftedOutcome& outcome,
                         double allowance) {
  const Collision& c = exact_case.collision();
  const OutcomeVector k = cone.read_off_a ? OutcomeVector::velocity_of_a : OutcomeVector::velocity_of_b;
  const double size = outcome.norms()[k] + exact_case.norms_before()[k];
  const double impulse = (cone.read_off_a ? c.a.mass : c.b.mass) * size * norm_of(c.normal);
  return allowance * impulse * impulse * (1 + c.friction * c.friction);
}

/// λ F has an error of α λ m (‖v̂‖ + ‖v⁻‖), as in the friction cone, and V⁻ has one of α times the sizes of its terms.
/// If the slopes vanish, as for bodies at rest, the squares of these errors remain. The bound is c ‖V⁻‖ or c |N·V⁻|.
double part_by_curvature(const equation::ImpulseBound& bound, const ExactCase& exact_case, const LiftedOutcome& outcome,
                         double allowance) {
  const Collision& c = exact_case.collision();
  const OutcomeVector k = bound.read_off_a ? OutcomeVector::velocity_of_a : OutcomeVector::velocity_of_b;
  const double size = outcome.norms()[k] + exact_case.norms_before()[k];
  double of_impulse = inverse_mass(c) * (bound.read_off_a ? c.a.mass : c.b.mass) * size;
  double of_bound = 0;
  if (bound.of == ImpulseBoundOf::approach) {
    of_impulse *= norm_of(c.normal);
    of_bound = exact_case.normal_velocity_sensitivity();
  } else {
    for (const Body* body : {&c.a, &c.b}) {
      const double arm = norm_of(lever_arm<double>(*body, c.point)) + length_of_lever_arm(*body, c.point);
      of_bound += norm_of(body->velocity) + norm_of(body->angular_velocity) * arm;
    }
  }
  of_bound *= factor_of(bound.of, c);
  return allowance * (of_impulse * of_impulse + of_bound * of_bound);
}

/// N × F and N × V⁺ have errors of α times the sizes of the terms from which they are computed. If the slopes vanish,
/// the product of N × F and N × V⁺ has the product of these errors.
template <class OneEquation>
requires std::is_same_v<OneEquation, equation::FrictionAlongSlip> ||
    std::is_same_v<OneEquation, equation::FrictionAgainstSlip>
double part_by_curvature(const OneEquation& of, const ExactCase& exact_case, const LiftedOutcome& outcome,
                         double allowance) {
  const Collision& c = exact_case.collision();
  const PerVector<double> norms = outcome.norms();
  const auto size = [&](OutcomeVector k) { return norms[k] + exact_case.norms_before()[k]; };
  const double impulse =
      of.read_off_a ? c.a.mass * size(OutcomeVector::velocity_of_a) : c.b.mass * size(OutcomeVector::velocity_of_b);
  const auto at_point = [&](const Body& body, OutcomeVector velocity, OutcomeVector spin) {
    return size(velocity) + norm_of(Vector3<double>(c.point - body.position)) * size(spin);
  };
  const double velocity = at_point(c.a, OutcomeVector::velocity_of_a, OutcomeVector::angular_velocity_of_a) +
                          at_point(c.b, OutcomeVector::velocity_of_b, OutcomeVector::angular_velocity_of_b);
  return allowance * impulse * velocity * norm_of(c.normal) * norm_of(c.normal);
}

/// V⁺ − V⁻ = C F for the collision matrix C that a subject reports.
struct ByShownMatrix {
  const LiftedMatrix& shown;
  bool read_off_a;

  template <class T>
  [[nodiscard]] Sides<T, 3> operator()(const BasicCollision<T>& c, const Outcome<T>& after) const {
    return change_by_matrix<T>(c, after, shown.in<T>(), impulse_on_a(c, after, read_off_a));
  }
};

/// C may differ from the exact K by E = α Σ_q ‖∂K/∂q‖ ‖q‖ (Frobenius norm). So C F has a permitted error of ‖F‖ E.
double part_by_curvature(const ByShownMatrix& by_matrix, const ExactCase& exact_case, const LiftedOutcome& outcome,
                         double allowance) {
  const Vector3<double> impulse = impulse_on_a(exact_case.collision(), outcome.rounded(), by_matrix.read_off_a);
  return exact_case.collision_matrix_sensitivity(allowance) * norm_of(impulse);
}

double permitted_residual(const ByShownMatrix& by_matrix, const PermittedInputs& permitted, const Collision& collision,
                          const Outcome<double>& after, const PerVector<double>& sizes) {
  return permitted_residual_of_change(by_matrix.shown.in<double>(), by_matrix.read_off_a, permitted, collision, after,
                                      sizes);
}

/// Whether the product in part_by_curvature keeps its digits. The sensitivity of K is not extreme if the collision is
/// moderate.
bool has_part_by_matrix(const ByShownMatrix& by_matrix, const ExactCase& exact_case, const LiftedOutcome& outcome,
                        double allowance) {
  const double impulse = norm_of(impulse_on_a(exact_case.collision(), outcome.rounded(), by_matrix.read_off_a));
  return impulse == 0 || (exact_case.is_moderate() && impulse >= smallest_scale) ||
         std::isnormal(part_by_curvature(by_matrix, exact_case, outcome, allowance));
}

/// The scale of an equation. No value if the scale leaves the range of binary64.
template <class OneEquation>
std::optional<double> scale_of(const OneEquation& equation, const ExactCase& exact_case, const LiftedOutcome& outcome,
                               const PerVector<double>& sizes, double allowance) {
  const double by_curvature = part_by_curvature(equation, exact_case, outcome, allowance);
  if (!needs_all_digits(equation, outcome)) {
    const double scale = part_by_inputs(equation, exact_case.differentiated(), outcome.rounded()) +
                         part_by_outputs(equation, exact_case, outcome, sizes) + by_curvature;
    if (is_in_range(scale)) {
      return scale;
    }
  }
  // Products of extreme numbers leave the range of binary64. Wide has a wider range and more digits.
  using Wide = long double;
  const auto inputs = dual_inputs<Wide, collision_inputs>(exact_case.collision(), [](double x) { return Wide(x); });
  const auto parts = [&](const auto& at) {
    return part_by_inputs(equation, inputs, at) +
           part_by_outputs(output_slopes<Wide, collision_inputs>(equation, exact_case.collision(), at), sizes);
  };
  const Wide wide = (outcome.reported() != nullptr ? parts(*outcome.reported()) : parts(outcome.rounded())) +
                    static_cast<Wide>(by_curvature);
  return wide == 0 || is_in_range(wide) ? std::optional<double>(static_cast<double>(wide)) : std::nullopt;
}

/// A cheap lower bound of the scale: the part by the outputs. Precondition: the collision and the outcome are moderate.
template <class OneEquation>
double part_of_scale(const OneEquation& equation, const ExactCase& exact_case, const LiftedOutcome& outcome,
                     const PerVector<double>& sizes) {
  CAROM_EXPECTS(exact_case.is_moderate() && outcome.is_moderate());
  const double part = part_by_outputs(equation, exact_case, outcome, sizes);
  return is_in_range(part) ? part : 0;
}

double part_of_scale(const ByShownMatrix& by_matrix, const ExactCase& exact_case, const LiftedOutcome& outcome,
                     const PerVector<double>& sizes) {
  CAROM_EXPECTS(exact_case.is_moderate() && outcome.is_moderate() && by_matrix.shown.is_moderate());
  const double part = part_by_outputs(
      slopes_of_change(by_matrix.shown.in<double>(), by_matrix.read_off_a, exact_case.collision()), sizes);
  return is_in_range(part) ? part : 0;
}

template <class T, int N>
EquationCheck violation(const Sides<T, N>& sides, const Components<T>& missed, double allowed) {
  EquationCheck comparison{false, true, norm(missed), allowed, {}, {}};
  for (Eigen::Index i = 0; i < sides.left.size(); ++i) {
    comparison.left.push_back(rounded(sides.left[i]));
    comparison.right.push_back(rounded(sides.right[i]));
  }
  return comparison;
}

/// An equation at an outcome, and the residual that rounding may cause. The residual is computed at first use, because
/// a part of it decides most comparisons.
template <class OneEquation>
class Compared {
 public:
  Compared(const OneEquation& equation, EquationForm form, const ExactCase& exact_case, const LiftedOutcome& outcome,
           const Yardstick& yardstick)
      : equation_(equation),
        form_(form),
        exact_case_(exact_case),
        outcome_(outcome),
        yardstick_(yardstick),
        sizes_(sizes_of_outputs(exact_case, outcome, yardstick)) {}

  /// No value if the error bounds do not decide. Precondition: yardstick.uses_bounds().
  [[nodiscard]] std::optional<EquationCheck> by_enclosures() const {
    const auto sides = equation_(exact_case_.enclosed(), outcome_.enclosed());
    const auto missed = possibly_missing(sides, form_);
    if (missed.empty() || norm_at_most(missed, surely_allowed()).value_or(false)) {
      return EquationCheck{};
    }
    const std::optional<double> bound = allowed();
    const std::optional<bool> within = bound ? norm_at_most(missed, *bound) : std::nullopt;
    if (!within) {
      return std::nullopt;
    }
    return *within ? EquationCheck{} : violation(sides, missed, *bound);
  }

  [[nodiscard]] EquationCheck by_rationals() const {
    const auto sides = equation_(exact_case_.exact(), outcome_.exact());
    const auto missed = missing(sides, form_, [](const Rational& x, int sign) { return sign_of(x) != -sign; });
    if (norm_at_most(missed, 0)) {
      return {};
    }
    const std::optional<double> bound = allowed();
    if (!bound) {
      return {.is_decided = false};
    }
    return norm_at_most(missed, *bound) ? EquationCheck{} : violation(sides, missed, *bound);
  }

 private:
  /// A part of the permitted residual. If a number is not moderate, the scale may leave the range of binary64 although
  /// this part does not, so the part is 0.
  [[nodiscard]] double surely_allowed() const {
    return exact_case_.is_moderate() && outcome_.is_moderate()
               ? yardstick_.allowance() * part_of_scale(equation_, exact_case_, outcome_, sizes_)
               : 0;
  }

  [[nodiscard]] std::optional<double> allowed() const {
    return allowed_.get([&]() -> std::optional<double> {
      const double allowance = yardstick_.allowance();
      if (allowance == 0) {
        return 0;
      }
      std::optional<double> scale = scale_of(equation_, exact_case_, outcome_, sizes_, allowance);
      if (const PermittedInputs* permitted = scale ? exact_case_.permitted_inputs(allowance) : nullptr) {
        *scale +=
            permitted_residual(equation_, *permitted, exact_case_.collision(), outcome_.rounded(), sizes_) / allowance;
      }
      return scale ? yardstick_.allowed(*scale) : std::nullopt;
    });
  }

  const OneEquation& equation_;
  EquationForm form_;
  const ExactCase& exact_case_;
  const LiftedOutcome& outcome_;
  const Yardstick& yardstick_;
  PerVector<double> sizes_;
  Lazy<std::optional<double>> allowed_;
};

template <class OneEquation>
EquationCheck compare_one(const OneEquation& equation, EquationForm form, const ExactCase& exact_case,
                          const LiftedOutcome& outcome, const Yardstick& yardstick) {
  const Compared<OneEquation> compared(equation, form, exact_case, outcome, yardstick);
  if (yardstick.uses_bounds()) {
    if (std::optional<EquationCheck> decided = compared.by_enclosures()) {
      count(Stage::enclosure);
      return *std::move(decided);
    }
  }
  count(Stage::rational);
  return compared.by_rationals();
}

}  // namespace

EquationCheck compare(const Equation& equation, EquationForm form, const ExactCase& exact_case,
                      const LiftedOutcome& outcome, const Yardstick& yardstick) {
  return std::visit([&](const auto& one) { return compare_one(one, form, exact_case, outcome, yardstick); }, equation);
}

EquationCheck compare_change_by(const LiftedMatrix& shown, const ExactCase& exact_case, const LiftedOutcome& outcome,
                                const Yardstick& yardstick) {
  CAROM_EXPECTS(shown.is_finite());
  const ByShownMatrix equation{shown, reads_impulse_off_a(exact_case.collision())};
  if (yardstick.allowance() > 0 && !has_part_by_matrix(equation, exact_case, outcome, yardstick.allowance())) {
    return {.is_decided = false};
  }
  // Products of moderate numbers stay in the range of binary64.
  const bool filtered = yardstick.filtered() && shown.is_moderate();
  return compare_one(equation, EquationForm::equal, exact_case, outcome, yardstick.with_filters(filtered));
}

}  // namespace carom::oracles
