// SPDX-License-Identifier: BSL-1.0
#include <cmath>

#include <carom/oracles/judge/permitted_residual.hpp>

namespace carom::oracles {
namespace {

class Residual {
 public:
  Residual(const PermittedInputs& inputs, const Collision& collision, const Outcome<double>& after,
           const PerVector<double>& sizes)
      : inputs_(inputs), collision_(collision), after_(after), sizes_(sizes) {}

  double operator()(const equation::AngularMomentum& of) const {
    const VectorBall& arm = of.of_a ? inputs_.lever_arm_of_a() : inputs_.lever_arm_of_b();
    return cross(arm, impulse_on(of.of_a)).radius;
  }
  double operator()(const equation::Restitution&) const {
    const ScalarBall rebound = inputs_.scalar(collision_.restitution) * inputs_.normal_velocity();
    return norm_of(collision_.normal) * (dot(inputs_.unit_normal(), velocity_after()).radius + rebound.radius);
  }
  double operator()(const equation::NonPenetration&) const {
    return norm_of(collision_.normal) * dot(inputs_.unit_normal(), velocity_after()).radius;
  }
  double operator()(const equation::PartingSpeed&) const {
    return norm_of(collision_.normal) *
           (dot(inputs_.unit_normal(), velocity_after()).radius + inputs_.normal_velocity().radius);
  }
  /// The impulse contains no lever arm. So only the bound moves: (b + δ)² − b² for a bound b that moves by δ.
  double operator()(const equation::ImpulseBound& bound) const {
    const double factor = factor_of(bound.of, collision_);
    const double length = factor * norm_of(collision_.normal);
    return bound.of == ImpulseBoundOf::approach ? growth_of_square(length * std::abs(inputs_.normal_velocity().centre),
                                                                   length * inputs_.normal_velocity().radius)
                                                : growth_of_square(factor * norm_of(inputs_.relative_velocity().centre),
                                                                   factor * inputs_.relative_velocity().radius);
  }
  double operator()(const equation::ReflectionPlane&) const {
    const VectorBall before = cross(inputs_.unit_normal(), inputs_.relative_velocity());
    return norm_of(collision_.normal) * (slip().radius + before.radius);
  }
  double operator()(const equation::Sticks&) const { return norm_of(collision_.normal) * slip().radius; }
  double operator()(const equation::FrictionAlongSlip& of) const {
    return squared_normal() * cross(friction(of.read_off_a), slip()).radius;
  }
  double operator()(const equation::FrictionAgainstSlip& of) const {
    return squared_normal() * dot(friction(of.read_off_a), slip()).radius;
  }
  double operator()(const equation::Energy&) const {
    double radius = 0;
    for (const bool a : {true, false}) {
      const Body& body = a ? collision_.a : collision_.b;
      if (body.immovable) {
        const VectorBall& arm = a ? inputs_.lever_arm_of_a() : inputs_.lever_arm_of_b();
        const VectorBall velocity = inputs_.vector(body.velocity) + cross(inputs_.vector(body.angular_velocity), arm);
        radius += dot(velocity, impulse_on(!a)).radius;
      }
    }
    return radius;
  }

  // These equations contain no lever arm, or only positions X as lever arms about the world's origin.
  double operator()(const equation::LinearMomentum&) const { return 0; }
  double operator()(const equation::TotalAngularMomentum&) const { return 0; }
  double operator()(const equation::Untouched&) const { return 0; }
  double operator()(const equation::Push&) const { return 0; }
  double operator()(const equation::FrictionlessDirection&) const { return 0; }
  double operator()(const equation::FrictionCone&) const { return 0; }

  [[nodiscard]] double of_change(const Matrix3<double>& matrix, bool read_off_a) const {
    return velocity_after().radius + inputs_.relative_velocity().radius + matrix.norm() * impulse_on(read_off_a).radius;
  }

 private:
  [[nodiscard]] VectorBall output(OutcomeVector k) const {
    return {*vectors(after_)[k], inputs_.allowance() * sizes_[k]};
  }

  [[nodiscard]] VectorBall impulse_on(bool a) const {
    const Body& body = a ? collision_.a : collision_.b;
    const VectorBall change =
        output(a ? OutcomeVector::velocity_of_a : OutcomeVector::velocity_of_b) - inputs_.vector(body.velocity);
    return inputs_.scalar(body.mass) * change;
  }

  [[nodiscard]] VectorBall velocity_after() const {
    return output(OutcomeVector::velocity_of_a) +
           cross(output(OutcomeVector::angular_velocity_of_a), inputs_.lever_arm_of_a()) -
           (output(OutcomeVector::velocity_of_b) +
            cross(output(OutcomeVector::angular_velocity_of_b), inputs_.lever_arm_of_b()));
  }

  /// N × V⁺ / ‖N‖.
  [[nodiscard]] VectorBall slip() const { return cross(inputs_.unit_normal(), velocity_after()); }
  /// N × F / ‖N‖.
  [[nodiscard]] VectorBall friction(bool read_off_a) const {
    return cross(inputs_.unit_normal(), impulse_on(read_off_a));
  }

  [[nodiscard]] static double growth_of_square(double bound, double change) { return change * (2 * bound + change); }

  [[nodiscard]] double squared_normal() const {
    const double length = norm_of(collision_.normal);
    return length * length;
  }

  const PermittedInputs& inputs_;
  const Collision& collision_;
  const Outcome<double>& after_;
  const PerVector<double>& sizes_;
};

}  // namespace

double permitted_residual(const Equation& equation, const PermittedInputs& inputs, const Collision& collision,
                          const Outcome<double>& after, const PerVector<double>& sizes) {
  return std::visit(Residual(inputs, collision, after, sizes), equation);
}

double permitted_residual_of_change(const Matrix3<double>& matrix, bool read_off_a, const PermittedInputs& inputs,
                                    const Collision& collision, const Outcome<double>& after,
                                    const PerVector<double>& sizes) {
  return Residual(inputs, collision, after, sizes).of_change(matrix, read_off_a);
}

}  // namespace carom::oracles
