// SPDX-License-Identifier: BSL-1.0
#include <array>
#include <cmath>
#include <variant>

#include <fmt/format.h>

#include <carom/properties/records/broken_words.hpp>

namespace carom::properties::records {
namespace {

namespace equation = oracles::equation;

/// To five digits. Numbers that are only rounding of `size` are 0.
std::string shown(double number, double size) {
  constexpr double negligible = 1e-9;  // far below the five digits shown, far above the rounding of binary64
  return fmt::format("{:.5g}", std::abs(number) < negligible * size ? 0 : number);
}

Eigen::Index worst_of(const Vector3<double>& difference) {
  Eigen::Index worst = 0;
  difference.cwiseAbs().maxCoeff(&worst);
  return worst;
}

class Words {
 public:
  Words(const Collision& collision, const Outcome<double>& after) : c_(collision), after_(after) {}

  std::string operator()(const equation::LinearMomentum& of) const {
    const auto sides = of(c_, after_);
    const Eigen::Index k = worst_of(sides.left - sides.right);
    const double before = c_.a.mass * c_.a.velocity[k] + c_.b.mass * c_.b.velocity[k];
    const double then = c_.a.mass * after_.a.velocity[k] + c_.b.mass * after_.b.velocity[k];
    const double gain = sides.left[k];
    const double loss = sides.right[k];
    const double size = std::abs(gain) + std::abs(loss);
    return fmt::format("linear momentum along {}: {} kg m/s before, {} after; A gains {}, and B loses {}", "xyz"[k],
                       shown(before, size), shown(then, size), shown(gain, size), shown(loss, size));
  }

  std::string operator()(const equation::AngularMomentum& of) const {
    const auto sides = of(c_, after_);
    const Eigen::Index k = worst_of(sides.left - sides.right);
    const double size = std::abs(sides.left[k]) + std::abs(sides.right[k]);
    return fmt::format("angular momentum of {} about {}: the spin changes by {} kg m²/s, the impulse demands {}",
                       of.of_a ? 'A' : 'B', "xyz"[k], shown(sides.left[k], size), shown(sides.right[k], size));
  }

  std::string operator()(const equation::Untouched& of) const {
    const bool is_of_a = of.vector == OutcomeVector::velocity_of_a || of.vector == OutcomeVector::angular_velocity_of_a;
    const bool is_spin =
        of.vector == OutcomeVector::angular_velocity_of_a || of.vector == OutcomeVector::angular_velocity_of_b;
    const auto sides = of(c_, after_);
    const Eigen::Index k = worst_of(sides.left - sides.right);
    const bool is_immovable = (is_of_a ? c_.a : c_.b).immovable;
    return fmt::format("{} of {} {} {}: {:.5g} {} before, {:.5g} after; {}", is_spin ? "angular velocity" : "velocity",
                       is_of_a ? 'A' : 'B', is_spin ? "about" : "along", "xyz"[k], sides.right[k],
                       is_spin ? "rad/s" : "m/s", sides.left[k],
                       is_immovable ? "the body is immovable" : "the bodies do not approach");
  }

  std::string operator()(const equation::Restitution& of) const {
    const auto sides = of(c_, after_);
    const double length = c_.normal.norm();
    const double before = oracles::normal_velocity_before(c_) / length;
    return fmt::format(
        "restitution: the normal velocity is {:.5g} m/s before and {:.5g} after, and ε = {:.5g} demands {:.5g}", before,
        sides.left[0] / length, c_.restitution, sides.right[0] / length);
  }

  std::string operator()(const equation::NonPenetration& of) const {
    return fmt::format("penetration: the bodies still approach at {:.5g} m/s after the impulse",
                       -of(c_, after_).left[0] / c_.normal.norm());
  }

  std::string operator()(const equation::PartingSpeed& of) const {
    const auto sides = of(c_, after_);
    return fmt::format("restitution: the bodies meet at {:.5g} m/s, and part at {:.5g}",
                       sides.right[0] / c_.normal.norm(), sides.left[0] / c_.normal.norm());
  }

  std::string operator()(const equation::Push& of) const {
    return fmt::format("the impulse pulls the bodies together: its normal part is {:.5g} N s",
                       normal_part(of.read_off_a));
  }

  std::string operator()(const equation::FrictionlessDirection& of) const {
    return fmt::format(
        "friction: the impulse across the normal is {:.5g} N s, beside {:.5g} along it; the law has none",
        tangential_part(of.read_off_a), normal_part(of.read_off_a));
  }

  std::string operator()(const equation::ReflectionPlane& of) const {
    const auto sides = of(c_, after_);
    const double length = c_.normal.norm();
    return fmt::format(
        "tangential velocity of the contact point: the law keeps it, and it changes by {:.5g} m/s, from {:.5g}",
        (sides.left - sides.right).norm() / length, sides.right.norm() / length);
  }

  std::string operator()(const equation::Sticks& of) const {
    return fmt::format("slip: the contact point still slips at {:.5g} m/s after the impulse, and the law stops it",
                       of(c_, after_).left.norm() / c_.normal.norm());
  }

  std::string operator()(const equation::FrictionCone& of) const {
    return fmt::format("friction: the impulse across the normal is {:.5g} N s, and μ times that along it is {:.5g}",
                       tangential_part(of.read_off_a), c_.friction * normal_part(of.read_off_a));
  }

  std::string operator()(const equation::FrictionAlongSlip& of) const {
    return fmt::format("friction: {:.3g}° from the line of the slip after the impulse", angle(of.read_off_a));
  }

  std::string operator()(const equation::FrictionAgainstSlip& of) const {
    return fmt::format("friction: it points along the slip after the impulse, at {:.3g}°, and should oppose it",
                       angle(of.read_off_a));
  }

  /// No check of a record makes another equation.
  template <class Other>
  std::string operator()(const Other& /*of*/) const {
    return "an equation is not satisfied";
  }

 private:
  [[nodiscard]] double normal_part(bool off_a) const {
    return c_.normal.dot(oracles::impulse_on_a(c_, after_, off_a)) / c_.normal.norm();
  }
  [[nodiscard]] double tangential_part(bool off_a) const {
    return c_.normal.cross(oracles::impulse_on_a(c_, after_, off_a)).norm() / c_.normal.norm();
  }
  /// Between the friction and the slip after the impulse [degrees].
  [[nodiscard]] double angle(bool off_a) const {
    const auto [friction, slip] = oracles::friction_and_slip(c_, after_, off_a);
    constexpr double degrees = 57.29577951308232;
    return degrees * std::atan2(friction.cross(slip).norm(), friction.dot(slip));
  }

  const Collision& c_;
  const Outcome<double>& after_;
};

}  // namespace

const char* worst_axis(const Vector3<double>& difference) {
  constexpr std::array axes{"x", "y", "z"};
  return axes.at(static_cast<std::size_t>(worst_of(difference)));
}

std::string broken_words(const oracles::Equation& equation, const Collision& collision, const Outcome<double>& after) {
  return std::visit(Words(collision, after), equation);
}

}  // namespace carom::properties::records
