// SPDX-License-Identifier: BSL-1.0
#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <type_traits>

#include <carom/collision/expects.hpp>
#include <carom/oracles/laws/kinematics.hpp>
#include <carom/oracles/laws/mechanics.hpp>
#include <carom/oracles/truths/models.hpp>
#include <carom/oracles/truths/sensitivity.hpp>

namespace carom::oracles {
namespace {

/// V⁻, computed in enclosures. Its terms may cancel, and the rest must still give the direction of the slip.
template <class S>
Vector3<S> velocity_before(const BasicCollision<Enclosure>& c) {
  Vector3<Enclosure> velocity = relative_velocity<Enclosure>(c, unchanged(c));
  if constexpr (std::is_same_v<S, Enclosure>) {
    return velocity;
  } else {
    return velocity.unaryExpr([](const Enclosure& x) { return S(x.middle()); });
  }
}

template <class S>
struct Differentiable {
  explicit Differentiable(const Collision& collision)
      : c(map_numbers<S>(collision, [](double x) { return S(x); })),
        indices(collision),
        velocity(velocity_before<S>(map_numbers<Enclosure>(collision, [](double x) { return Enclosure(x); }))) {}

  BasicCollision<S> c;
  InputIndices indices;
  Vector3<S> velocity;  // V⁻
};

template <class S>
struct Wanted {
  Vector3<S> change;
  Jacobian<S> derivative = Jacobian<S>::Zero();
};

/// The change of relative velocity that the law requires, and its derivatives by the chain rule through V⁻.
/// `restitution` is ε as an input, or a constant.
template <class LawType, class S>
Wanted<S> wanted_of(const Differentiable<S>& of, const Dual<S, 7>& restitution) {
  const BasicCollision<S>& c = of.c;
  Wanted<S> result;
  Jacobian<S> d_velocity = Jacobian<S>::Zero();
  const auto add_body = [&](const BasicBody<S>& body, const InputIndices::OfBody& index, int sign) {
    constexpr int own = 9;  // position, velocity, angular velocity; and the contact point
    using T = Dual<S, own + 3>;
    const Vector3<T> arm = inputs<own + 3>(c.point, own) - inputs<own + 3>(body.position, 0);
    const Vector3<T> at_point =
        point_velocity<T>({inputs<own + 3>(body.velocity, 3), inputs<own + 3>(body.angular_velocity, 6)}, arm);
    d_velocity.template middleCols<own>(index.position) += S(sign) * derivatives<own>(at_point, 0);
    d_velocity.template middleCols<3>(of.indices.point()) += S(sign) * derivatives<3>(at_point, own);
  };
  add_body(c.a, of.indices.a, 1);
  add_body(c.b, of.indices.b, -1);
  using T = Dual<S, 7>;  // normal, restitution, relative velocity
  const Vector3<T> wanted =
      LawType::template wanted_change<T>(inputs<7>(c.normal, 0), restitution, inputs<7>(of.velocity, 4));
  result.change = value(wanted);
  result.derivative = derivatives<3>(wanted, 4) * d_velocity;
  result.derivative.template middleCols<4>(of.indices.normal()) += derivatives<4>(wanted, 0);
  return result;
}

template <class S>
struct Differentiated {
  Vector3<S> impulse;
  PerVector<Vector3<S>> change;
  Derivatives<S> derivatives;
};

template <class LawType, class S>
Differentiated<S> differentiated(const Differentiable<S>& of, const Dual<S, 7>& restitution) {
  const BasicCollision<S>& c = of.c;
  const InputIndices& indices = of.indices;
  const Wanted<S> wanted = wanted_of<LawType>(of, restitution);
  const Vector3<S> impulse = LawType::template impulse_for<S>(c, wanted.change, nullptr);
  const BodyResponse<S> a = response_of<S>(c.a, c.point, impulse, indices.a, indices.point());
  const BodyResponse<S> b = response_of<S>(c.b, c.point, -impulse, indices.b, indices.point());
  const Jacobian<S> left = a.d_at_point - b.d_at_point - wanted.derivative;
  return {impulse,
          {a.velocity * impulse, a.angular_velocity * impulse, -b.velocity * impulse, -b.angular_velocity * impulse},
          LawType::template derivatives<S>(c, {a, b, impulse, wanted.change, left, indices.normal()})};
}

template <class S>
using Row = Eigen::Matrix<S, 1, collision_inputs>;

/// κ of `rough` (rough.hpp), and its derivatives.
template <class S>
struct Share {
  S value{};
  Row<S> derivative = Row<S>::Zero();
};

template <class S>
Share<S> friction_share(const Differentiable<S>& of, const Differentiated<S>& approach, const Differentiated<S>& point,
                        Branch branch) {
  const BasicCollision<S>& c = of.c;
  const InputIndices& indices = of.indices;
  const Vector3<S> d = point.impulse - approach.impulse;
  Share<S> share{Rough::friction_share<S>(c, approach.impulse, d, branch)};
  if (branch == Branch::inside_cone) {
    share.derivative[indices.tangential_restitution()] = S(1);
    return share;
  }
  // κ q = μ (1 + ε) p with p = N·P_I and q = ‖N × D‖ − μ N·D.
  const Jacobian<S> d_of_d = point.derivatives.of_impulse - approach.derivatives.of_impulse;
  const Vector3<S>& n = c.normal;
  const S rebound = S(1) + c.restitution;
  const Vector3<S> tangential = n.cross(d);
  using std::sqrt;
  const Vector3<S> along = tangential / S(sqrt(S(tangential.dot(tangential))));
  const S p = n.dot(approach.impulse);
  const S q = Rough::divisor<S>(c, d);
  // The derivatives ∂(N·D) and ∂‖N × D‖ = t·(∂N × D + N × ∂D). The unit vector t, `along` in the code, is along N × D.
  Row<S> d_normal = n.transpose() * d_of_d;
  d_normal.template segment<3>(indices.normal()) += d.transpose();
  Row<S> d_tangential = along.cross(n).transpose() * d_of_d;
  d_tangential.template segment<3>(indices.normal()) += d.cross(along).transpose();
  Row<S> d_p = n.transpose() * approach.derivatives.of_impulse;
  d_p.template segment<3>(indices.normal()) += approach.impulse.transpose();
  Row<S> numerator = S(c.friction * rebound) * d_p;
  numerator[indices.friction()] += rebound * p;
  numerator[indices.restitution()] += c.friction * p;
  Row<S> d_q = d_tangential - c.friction * d_normal;
  d_q[indices.friction()] -= n.dot(d);
  share.derivative = (numerator - share.value * d_q) / q;
  return share;
}

template <class LawType, class S>
PerVector<Jacobian<S>> change_derivatives(const Differentiable<S>& of, Branch branch) {
  using T = Dual<S, 7>;
  const BasicCollision<S>& c = of.c;
  if constexpr (LinearLaw<LawType>) {
    return differentiated<LawType>(of, T::input(c.restitution, 3)).derivatives.of_change;
  } else {
    const Differentiated<S> approach = differentiated<typename LawType::StopsApproach>(of, T(0));
    const Differentiated<S> point = differentiated<typename LawType::StopsPoint>(of, T(0));
    const Share<S> share = friction_share(of, approach, point, branch);
    const S rebound = S(1) + c.restitution;
    PerVector<Jacobian<S>> result;
    for (const OutcomeVector k : all_outcome_vectors) {
      const Jacobian<S>& of_approach = approach.derivatives.of_change[k];
      result[k] = rebound * of_approach + share.value * (point.derivatives.of_change[k] - of_approach) +
                  (point.change[k] - approach.change[k]) * share.derivative;
      result[k].col(of.indices.restitution()) += approach.change[k];
    }
    return result;
  }
}

/// The derivatives ∂y_k of the law's answer to a contact that collides.
template <class S>
PerVector<Jacobian<S>> outcome_derivatives(const Differentiable<S>& of, Law law, Branch branch) {
  PerVector<Jacobian<S>> derivatives =
      with_law(law, branch, [&]<class LawType>(LawType) { return change_derivatives<LawType>(of, branch); });
  const InputIndices& indices = of.indices;
  const PerVector<Eigen::Index> before{indices.a.velocity(), indices.a.angular_velocity(), indices.b.velocity(),
                                       indices.b.angular_velocity()};
  for (const OutcomeVector k : all_outcome_vectors) {
    for (Eigen::Index i = 0; i < 3; ++i) {
      derivatives[k](i, before[k] + i) += S(1);
    }
  }
  return derivatives;
}

template <class S, int Rows>
using Derivative = Eigen::Matrix<S, Rows, collision_inputs, Eigen::RowMajor>;

/// Σ_q ‖∂y/∂q‖ ‖q‖. NaN if squares may have left the range of binary64.
template <int Rows>
double weighted_norm(const Derivative<double, Rows>& jacobian, const std::vector<Quantity>& quantities) {
  double sum = 0;
  bool is_zero = true;
  for (const Quantity& q : quantities) {
    const auto of_quantity =
        jacobian.middleCols(static_cast<Eigen::Index>(q.first), static_cast<Eigen::Index>(q.count));
    sum += of_quantity.norm() * q.length;
    is_zero = is_zero && (q.length == 0 || of_quantity.isZero(0));
  }
  if (is_zero) {
    return 0;
  }
  return sum >= least_sum_by_squares && sum <= largest_sum_by_squares ? sum : std::numeric_limits<double>::quiet_NaN();
}

/// Σ_q ‖∂y/∂q‖ ‖q‖ with number(derivative) in place of each derivative.
template <int Rows, class Number>
double enclosed_norm(const Derivative<Enclosure, Rows>& jacobian, const std::vector<Quantity>& quantities,
                     const Number& number) {
  return sum_over_quantities(quantities, Rows, [&](std::size_t i, std::size_t j) {
    return number(jacobian(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(j)));
  });
}

constexpr double thousandth = 0x1p-10;

/// The error of a sensitivity is less than 2⁹ roundings of the arithmetic, times `growth_of_roundings`. Up to this
/// growth, the sensitivity is correct to a thousandth. The error radii of double-double arithmetic may be larger,
/// because their bounds do not use K ⪰ λI.
constexpr double largest_growth_for(double roundoff) { return thousandth / roundoff / 0x1p+9; }

}  // namespace

double growth_in_collision_matrix(const Collision& collision) {
  CAROM_EXPECTS(has_movable_body(collision));
  const double lambda = inverse_mass(collision);
  double terms = lambda;
  for (const Body* body : {&collision.a, &collision.b}) {
    const double arm = norm_of(lever_arm<double>(*body, collision.point));
    terms += body->immovable ? 0 : arm * arm / body->principal_inertia.minCoeff();
  }
  return terms / lambda;
}

double growth_of_roundings(const Collision& collision, const BasicCollision<Enclosure>& enclosed, Law law,
                           Branch branch) {
  const double growth = growth_in_collision_matrix(collision);
  if (law != Law::rough || branch != Branch::on_cone) {
    return growth;
  }
  double largest_impulse{};
  for (const Body* body : {&collision.a, &collision.b}) {
    const double arm = norm_of(lever_arm<double>(*body, collision.point));
    largest_impulse += (norm_of(body->velocity) + norm_of(body->angular_velocity) * arm) / inverse_mass(collision);
  }
  const Vector3<Enclosure> d = detail::RoughImpulses<Enclosure>(enclosed, nullptr).difference();
  const double divisor = Rough::divisor<Enclosure>(enclosed, d).magnitude_below();
  return growth * (1 + collision.friction) * norm_of(collision.normal) * largest_impulse / divisor;
}

Sensitivity norms_before(const Collision& collision) { return norms_of(unchanged(collision)); }

std::optional<Sensitivity> colliding_sensitivity(const Collision& collision, Law law, Branch branch) {
  CAROM_EXPECTS(has_movable_body(collision));
  if (growth_in_collision_matrix(collision) > largest_growth_for(0x1p-53)) {
    return std::nullopt;
  }
  const Differentiable<double> of(collision);
  const PerVector<Jacobian<double>> derivatives = outcome_derivatives(of, law, branch);
  Sensitivity result = norms_before(collision);
  for (const OutcomeVector k : all_outcome_vectors) {
    result[k] += weighted_norm(derivatives[k], of.indices.quantities);
  }
  const bool is_known = std::all_of(result.begin(), result.end(), [](double sum) { return std::isfinite(sum); });
  return is_known ? std::optional<Sensitivity>(result) : std::nullopt;
}

std::optional<Sensitivity> enclosed_sensitivity(const Collision& collision, Law law, Branch branch, bool is_moderate) {
  CAROM_EXPECTS(has_movable_body(collision));
  const Differentiable<Enclosure> of(collision);
  const PerVector<Jacobian<Enclosure>> derivatives = outcome_derivatives(of, law, branch);
  const std::vector<Quantity>& quantities = of.indices.quantities;
  bool is_bounded_to_a_thousandth = true;
  Sensitivity result = norms_before(collision);
  for (const OutcomeVector k : all_outcome_vectors) {
    const double unknown = enclosed_norm(derivatives[k], quantities, [](const Enclosure& x) { return x.radius(); });
    result[k] += enclosed_norm(derivatives[k], quantities, [](const Enclosure& x) { return std::abs(x.middle()); });
    if (!std::isfinite(unknown) || !std::isfinite(result[k])) {
      return std::nullopt;
    }
    is_bounded_to_a_thousandth = is_bounded_to_a_thousandth && unknown <= thousandth * result[k];
  }
  if (is_bounded_to_a_thousandth ||
      (is_moderate && growth_of_roundings(collision, of.c, law, branch) <= largest_growth_for(0x1p-102))) {
    return result;
  }
  return std::nullopt;
}

namespace {

Sensitivity sensitivity_of_outcome(const Collision& collision, const auto& outcome,
                                   const std::vector<Quantity>& quantities) {
  Sensitivity result = norms_before(collision);
  const auto parts = vectors(outcome);
  for (const OutcomeVector k : all_outcome_vectors) {
    result[k] += sensitivity_of({&(*parts[k])[0], &(*parts[k])[1], &(*parts[k])[2]}, quantities);
  }
  return result;
}

using RationalDual = Dual<Rational, collision_inputs>;
using RadicalDual = Dual<Radical, collision_inputs>;

RadicalDual lifted(const RationalDual& x) {
  RadicalDual result(Radical(x.value));
  std::transform(x.derivative.begin(), x.derivative.end(), result.derivative.begin(),
                 [](const Rational& derivative) { return Radical(derivative); });
  return result;
}

/// The answer of `rough` on the cone's surface. The root ‖N × D‖ enters only through κ, so ℚ suffices for the
/// responses.
Outcome<RadicalDual> answer_on_cone(const BasicCollision<RationalDual>& c) {
  const auto lift = [](const Vector3<RationalDual>& v) {
    return Vector3<RadicalDual>{lifted(v[0]), lifted(v[1]), lifted(v[2])};
  };
  const detail::RoughImpulses<RationalDual> of(c, nullptr);
  const Outcome<RationalDual> by_approach = response<RationalDual>(c, of.stops_approach);
  const Outcome<RationalDual> by_friction = response<RationalDual>(c, of.difference());
  const auto in_radicals = map_numbers<RadicalDual>(c, [](const RationalDual& x) { return lifted(x); });
  const RadicalDual share =
      Rough::friction_share<RadicalDual>(in_radicals, lift(of.stops_approach), lift(of.difference()), Branch::on_cone);
  Outcome<RadicalDual> answer = unchanged(in_radicals);
  for (const OutcomeVector k : all_outcome_vectors) {
    *vectors(answer)[k] += Rough::combined<RadicalDual>(in_radicals, lift(*vectors(by_approach)[k]),
                                                        lift(*vectors(by_friction)[k]), share);
  }
  return answer;
}

}  // namespace

Sensitivity exact_sensitivity(const Collision& collision, Law law, Branch branch) {
  const auto inputs = dual_inputs<Rational, collision_inputs>(collision, [](double x) { return Rational(x); });
  if (branch == Branch::on_cone) {
    return sensitivity_of_outcome(collision, answer_on_cone(inputs.collision), inputs.quantities);
  }
  return sensitivity_of_outcome(collision, colliding_truth(inputs.collision, law, branch).outcome, inputs.quantities);
}

namespace {

/// A lower bound of |μ N·F − ‖N × F‖| for F with κ = 1 + e_t, by enclosures, because the difference can be as small as
/// a rounding error of binary64.
double distance_from_cone(const BasicCollision<Enclosure>& c) {
  const detail::RoughImpulses<Enclosure> of(c, nullptr);
  const Vector3<Enclosure> whole = Rough::combined<Enclosure>(c, of.stops_approach, of.difference(),
                                                              Enclosure(Enclosure(1.0) + c.tangential_restitution));
  // The scaled impulse has a size near 1, so that its square stays in the range of numbers.
  const double size = whole.unaryExpr([](const Enclosure& x) { return x.middle(); }).lpNorm<Eigen::Infinity>();
  const double unit = std::isnormal(size) ? std::ldexp(1.0, std::ilogb(size)) : 1;
  const Vector3<Enclosure> scaled = whole * Enclosure(1 / unit);
  const Vector3<Enclosure> tangential = c.normal.cross(scaled);
  return unit *
         Enclosure(c.friction * c.normal.dot(scaled) - sqrt(Enclosure(tangential.dot(tangential)))).magnitude_below();
}

/// The derivatives ∂(μ N·F) and ∂(N × F), for F with κ = 1 + e_t.
template <class S>
struct ConeDerivatives {
  Row<S> limit;
  Jacobian<S> tangential = Jacobian<S>::Zero();
};

template <class S>
ConeDerivatives<S> cone_derivatives(const Differentiable<S>& of) {
  CAROM_EXPECTS(has_movable_body(of.c));
  const BasicCollision<S>& c = of.c;
  const InputIndices& indices = of.indices;
  using T = Dual<S, 7>;
  const Differentiated<S> approach = differentiated<Rough::StopsApproach>(of, T(0));
  const Differentiated<S> point = differentiated<Rough::StopsPoint>(of, T(0));
  const Vector3<S> d = point.impulse - approach.impulse;
  const S share = S(1) + c.tangential_restitution;
  const Vector3<S> whole = Rough::combined<S>(c, approach.impulse, d, share);
  const Jacobian<S>& d_approach = approach.derivatives.of_impulse;
  Jacobian<S> d_whole = S(S(1) + c.restitution) * d_approach + share * (point.derivatives.of_impulse - d_approach);
  d_whole.col(indices.restitution()) += approach.impulse;
  d_whole.col(indices.tangential_restitution()) += d;
  const Vector3<S>& n = c.normal;
  ConeDerivatives<S> result{c.friction * (n.transpose() * d_whole)};
  result.limit.template segment<3>(indices.normal()) += c.friction * whole.transpose();
  result.limit[indices.friction()] = n.dot(whole);
  for (Eigen::Index j = 0; j < d_whole.cols(); ++j) {
    const Vector3<S> column = d_whole.col(j);
    result.tangential.col(j) = n.cross(column);
  }
  for (Eigen::Index i = 0; i < 3; ++i) {
    result.tangential.col(indices.normal() + i) += Vector3<S>(Vector3<S>::Unit(i)).cross(whole);
  }
  return result;
}

}  // namespace

ConeDistance cone_distance(const Collision& collision) {
  const Differentiable<double> of(collision);
  const ConeDerivatives<double> derivatives = cone_derivatives(of);
  const std::vector<Quantity>& quantities = of.indices.quantities;
  return {distance_from_cone(map_numbers<Enclosure>(collision, [](double x) { return Enclosure(x); })),
          weighted_norm(derivatives.limit, quantities) + weighted_norm(derivatives.tangential, quantities)};
}

ConeDistance enclosed_cone_distance(const Collision& collision) {
  const Differentiable<Enclosure> of(collision);
  const ConeDerivatives<Enclosure> derivatives = cone_derivatives(of);
  const auto above = [&](const auto& jacobian) {
    return enclosed_norm(jacobian, of.indices.quantities, [](const Enclosure& x) { return x.magnitude_above(); });
  };
  return {distance_from_cone(of.c), above(derivatives.limit) + above(derivatives.tangential)};
}

namespace {

/// Beyond the range of numbers, a part of second order is left out.
void drop_infinite(Sensitivity& scale) {
  for (const OutcomeVector k : all_outcome_vectors) {
    scale[k] = std::isfinite(scale[k]) ? scale[k] : 0;
  }
}

/// ‖J⁻¹ (I − f fᵀ)‖_F for the unit vector f: the largest spin that a torque of length 1 across f may cause.
double response_across(const Body& body, const Vector3<double>& f) {
  const Vector3<double> in_body = turned<double>(conjugate(body.orientation), f);
  return root_of_squares(3, [&](std::size_t i) {
    const double y = in_body[static_cast<Eigen::Index>((i + 1) % 3)];
    const double z = in_body[static_cast<Eigen::Index>((i + 2) % 3)];
    return std::sqrt(y * y + z * z) / body.principal_inertia[static_cast<Eigen::Index>(i)];
  });
}

/// Adds the changes of the velocities if K changes by at most `change_of(body)` ‖J⁻¹ (I − f fᵀ)‖ for each movable body,
/// with f along the impulse F. F then changes by at most the sum of these changes times ‖F‖ / λ, because K ⪰ λI.
template <class ChangeOf>
void add_change_of_matrix(const Collision& c, const Vector3<double>& impulse, const ChangeOf& change_of,
                          Sensitivity& scale) {
  const double length = norm_of(impulse);
  if (length == 0) {
    return;
  }
  double sum = 0;
  for (const Body* body : {&c.a, &c.b}) {
    sum += body->immovable ? 0 : change_of(*body) * response_across(*body, impulse / length);
  }
  const double change = sum / inverse_mass(c) * length;
  const auto add_body = [&](const Body& body, OutcomeVector velocity, OutcomeVector spin) {
    if (!body.immovable) {
      scale[velocity] += change / body.mass;
      scale[spin] += change * norm_of(lever_arm(body, c.point)) / body.principal_inertia.minCoeff();
    }
  };
  add_body(c.a, OutcomeVector::velocity_of_a, OutcomeVector::angular_velocity_of_a);
  add_body(c.b, OutcomeVector::velocity_of_b, OutcomeVector::angular_velocity_of_b);
}

}  // namespace

Sensitivity second_order(const Collision& c) {
  double speed = 0;
  double lambda = 0;
  for (const Body* body : {&c.a, &c.b}) {
    speed += norm_of(body->velocity) + norm_of(body->angular_velocity) * length_of_lever_arm(*body, c.point);
    lambda += body->immovable ? 0 : 1 / body->mass;
  }
  const double impulse = 2 * speed / lambda;  // not used if both bodies are immovable
  const auto of_velocity = [&](const Body& body) {
    return norm_of(body.velocity) + (body.immovable ? 0 : impulse / body.mass);
  };
  const auto of_spin = [&](const Body& body) {
    return norm_of(body.angular_velocity) +
           (body.immovable ? 0 : impulse * length_of_lever_arm(body, c.point) / body.principal_inertia.minCoeff());
  };
  Sensitivity scale{};
  scale[OutcomeVector::velocity_of_a] = of_velocity(c.a);
  scale[OutcomeVector::angular_velocity_of_a] = of_spin(c.a);
  scale[OutcomeVector::velocity_of_b] = of_velocity(c.b);
  scale[OutcomeVector::angular_velocity_of_b] = of_spin(c.b);
  drop_infinite(scale);
  return scale;
}

Sensitivity second_order_of_arms(const Collision& c, std::initializer_list<Vector3<double>> impulses) {
  const auto squared = [&](const Body& body) {
    return length_of_lever_arm(body, c.point) * length_of_lever_arm(body, c.point);
  };
  Sensitivity scale{};
  for (const Vector3<double>& impulse : impulses) {
    add_change_of_matrix(c, impulse, squared, scale);
  }
  drop_infinite(scale);
  return scale;
}

Sensitivity second_order_from_rest(const Collision& c, double normal_velocity_sensitivity) {
  const double normal = norm_of(c.normal);
  // |N·V⁻| and its rounding are at most the allowance times the sensitivity each, and λ ‖F‖ ≤ (1 + ε) |N·V⁻| / ‖N‖.
  const double impulse = (1 + c.restitution) * 2 * normal_velocity_sensitivity / (normal * inverse_mass(c));
  const auto crossed = [&](const Body& body) {
    return 2 * length_of_lever_arm(body, c.point) * norm_of(lever_arm(body, c.point));
  };
  Sensitivity scale{};
  add_change_of_matrix(c, c.normal * (impulse / normal), crossed, scale);
  drop_infinite(scale);
  return scale;
}

}  // namespace carom::oracles
