// SPDX-License-Identifier: BSL-1.0
#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

#include <carom/collision/validate.hpp>
#include <carom/impulse/contact.hpp>
#include <carom/impulse/coulomb.hpp>
#include <carom/impulse/reflection_in_basis.hpp>
#include <carom/impulse/rough.hpp>
#include <carom/impulse/solve3.hpp>
#include <carom/impulse/sticking.hpp>

#include "catalogue.hpp"

namespace carom::mutants {
namespace {

using Vector = Vector3<double>;
using Matrix = Matrix3<double>;
using ContactBody = impulse::ContactBody<double>;
using Contact = impulse::Contact<double>;

/// If two moments are equal, sets the third moment to the same value.
void take_for_sphere(Vector& moments) {
  for (int i = 0; i < 3; ++i) {
    if (moments[i] == moments[(i + 1) % 3]) {
      moments.setConstant(moments[i]);
      return;
    }
  }
}

/// A defect in reading a collision or a body. It changes what the solver solves.
template <class Read>
struct Misreading {
  std::string_view defect;
  void (*read)(Read&);
};

constexpr Misreading<Body> misread_bodies[]{
    {"negative_quaternion_conjugated", [](Body& b) { b.orientation[0] = std::abs(b.orientation[0]); }},
    {"small_turn_as_none",
     [](Body& b) {
       constexpr double small = 0.95;  // cosine of half the angle
       if (std::abs(b.orientation[0]) > small * b.orientation.stableNorm()) {
         b.orientation = {1, 0, 0, 0};
       }
     }},
    {"half_turn_divides",
     [](Body& b) {
       if (b.orientation[0] == 0) {
         b.orientation.setConstant(std::numeric_limits<double>::quiet_NaN());
       }
     }},
    {"two_equal_moments_as_sphere", [](Body& b) { take_for_sphere(b.principal_inertia); }},
    {"moments_sorted", [](Body& b) { std::sort(b.principal_inertia.begin(), b.principal_inertia.end()); }},
    {"inverse_moments_capped",
     [](Body& b) {
       constexpr double least = 1e-6;  // [kg m²]
       b.principal_inertia = b.principal_inertia.cwiseMax(least);
     }},
    {"small_moments_as_infinite",
     [](Body& b) {
       constexpr double least_product = 1e-32;
       if (b.principal_inertia.prod() < least_product) {
         b.principal_inertia.setConstant(std::numeric_limits<double>::infinity());
       }
     }},
    {"velocities_in_fixed_point",
     [](Body& b) {
       constexpr double step = 1e-9;  // [m/s]
       b.velocity = (b.velocity / step).array().round() * step;
     }},
    {"resting_body_asleep",
     [](Body& b) { b.immovable = b.immovable || (b.velocity.isZero(0) && b.angular_velocity.isZero(0)); }},
};

constexpr Misreading<Collision> misread_collisions[]{
    {"near_axis_as_axis",
     [](Collision& c) {
       constexpr double near = 0.999;
       int axis = 0;
       const double largest = c.normal.cwiseAbs().maxCoeff(&axis);
       if (largest >= near * c.normal.stableNorm()) {
         c.normal = Vector(Vector::Unit(axis) * std::copysign(largest, c.normal[axis]));
       }
     }},
    {"heavy_as_immovable",
     [](Collision& c) {
       constexpr double ratio = 1e6;
       const bool are_movable = !c.a.immovable && !c.b.immovable;
       c.a.immovable = c.a.immovable || (are_movable && c.a.mass >= ratio * c.b.mass);
       c.b.immovable = c.b.immovable || (are_movable && c.b.mass >= ratio * c.a.mass);
     }},
    {"restitution_ignored", [](Collision& c) { c.restitution = 0; }},
    {"restitution_by_place",
     [](Collision& c) {
       constexpr double share = 0.1;
       c.restitution *= 1 - share * std::abs(std::sin(c.point[0]));
     }},
    {"restitution_from_friction",
     [](Collision& c) {
       c.restitution = c.friction > 0 ? std::min(1.0, (c.restitution + c.friction) / 2) : c.restitution;
     }},
    {"elastic_lossy",
     [](Collision& c) {
       constexpr double loss = 1e-9;
       c.restitution = c.restitution == 1 ? 1 - loss : c.restitution;
     }},
};

/// A vector orthogonal to `vector`, of similar length.
Vector beside(const Vector& vector) {
  return std::abs(vector[0]) < std::abs(vector[2]) ? Vector(0, -vector[2], vector[1])
                                                   : Vector(-vector[1], vector[0], 0);
}

/// The basis {N, T0, T1} of J. R. Frisvad (Building an Orthonormal Basis from a 3D Unit Vector Without Normalization,
/// 2012). Near the pole N = (0, 0, −1), T0 and T1 are constant, so the basis is orthonormal only at the pole itself.
Matrix basis_of_2012(const Vector& n) {
  constexpr double near_pole = -0.999;
  Matrix basis;
  if (n[2] < near_pole) {
    basis << n, Vector(0, -1, 0), Vector(-1, 0, 0);
    return basis;
  }
  const double a = 1 / (1 + n[2]);
  const double b = -n[0] * n[1] * a;
  basis << n, Vector(1 - n[0] * n[0] * a, b, -n[0]), Vector(b, 1 - n[1] * n[1] * a, -n[1]);
  return basis;
}

/// {N, T0, T1} with T0 orthogonal to the axis to which N is least parallel. If two axes tie, T0 = T1 = 0.
Matrix basis_without_ties(const Vector& n) {
  Vector t0 = Vector::Zero();
  for (int i = 0; i < 3; ++i) {
    const double others = std::min(std::abs(n[(i + 1) % 3]), std::abs(n[(i + 2) % 3]));
    if (std::abs(n[i]) < others) {
      t0 = n.cross(Vector::Unit(i)).normalized();
    }
  }
  Matrix basis;
  basis << n, t0, n.cross(t0);
  return basis;
}

void keep_spin_if_identity(const Body& body, BodyVelocity<double>& after) {
  if (body.orientation == Quaternion<double>(1, 0, 0, 0)) {
    after.angular_velocity = body.angular_velocity;
  }
}

class Solver {
 public:
  Solver(Law law, std::vector<std::string_view> defects) : law_(law), defects_(std::move(defects)) {}

  [[nodiscard]] Answer answer(const Collision& collision) {
    std::vector<InputError> refusal = validate(collision);
    std::erase_if(refusal, [&](const InputError& wrong) {
      return (has("accepts_restitution_above_one") && wrong.field == "restitution") ||
             (has("accepts_mass_zero") && wrong.field.ends_with(".mass")) ||
             (has("accepts_normal_zero") && wrong.field == "normal");
    });
    if (!refusal.empty()) {
      return Refused{describe(refusal)};
    }
    if (has("demands_unit_normal")) {
      constexpr double unit_tolerance = 1e-6;  // part of the defect, as in real engines; the judge does not use it
      if (std::abs(collision.normal.squaredNorm() - 1) > unit_tolerance) {
        return Refused{"normal: expected a vector of length 1"};
      }
    }
    formed_.reset();
    ReportedOutcome outcome = reported(answered(collision));
    if (formed_) {
      outcome.collision_matrix = shown(*formed_).cast<long double>();
    }
    return outcome;
  }

 private:
  [[nodiscard]] bool has(std::string_view defect) const {
    return std::ranges::find(defects_, defect) != defects_.end();
  }

  // Reading the bodies.

  [[nodiscard]] ContactBody read_body(const Body& body, const Body& other, const Vector& point, bool is_a) const {
    ContactBody result = impulse::make_contact_body<double>(body, point);
    if (has("lever_arm_from_origin")) {
      result.lever_arm = point;
    }
    if (has("lever_arm_of_other_body") && is_a) {
      result.lever_arm = point - other.position;
    }
    if (has("lever_arm_in_float")) {
      result.lever_arm = (point.cast<float>() - body.position.cast<float>()).cast<double>();
    }
    if (has("lever_arm_normalised")) {
      const double length = std::sqrt(result.lever_arm.squaredNorm());
      result.lever_arm = result.lever_arm / length * length;
    }
    if (has("tiny_lever_arm_as_zero")) {
      constexpr double tiny = 1e-12;  // [m²]
      if (result.lever_arm.squaredNorm() < tiny) {
        result.lever_arm.setZero();
      }
    }
    if (body.immovable) {
      if (has("immovable_as_heavy")) {
        constexpr double heavy = 1e10;
        result.inverse_mass = 1 / heavy;
        result.inertia = {Matrix::Identity(), Vector::Constant(1 / heavy)};
      }
      return result;
    }
    const Quaternion<double> q = impulse::without_extreme_length<double>(body.orientation);
    if (has("inertia_in_body_frame")) {
      result.inertia.axes = Matrix::Identity();
    }
    if (has("quaternion_unnormalised")) {
      result.inertia.axes *= body.orientation.squaredNorm();
    }
    if (has("quaternion_order")) {
      result.inertia.axes = impulse::rotation_matrix<double>({q[3], q[0], q[1], q[2]});
    }
    if (has("spin_in_body_frame")) {
      result.angular_velocity = impulse::rotation_matrix(q) * body.angular_velocity;
    }
    return result;
  }

  [[nodiscard]] Contact read(const Collision& c) const {
    const bool keeps_length = has("normal_length_ignored");
    const Vector normal = keeps_length ? c.normal : impulse::without_extreme_length<double>(c.normal);
    Contact contact{{}, {}, normal, c.restitution, c.friction, c.tangential_restitution};
    Vector point = c.point;
    if (has("contact_point_displaced")) {
      constexpr double displacement = 1e-3;  // [m]
      point += beside(contact.normal).normalized() * displacement;
    }
    contact.a = read_body(c.a, c.b, point, true);
    contact.b = read_body(c.b, c.a, point, false);
    if (has("anchors_apart")) {
      constexpr double thickness = 0.01;  // [m]
      const Vector half = contact.normal.normalized() * (thickness / 2);
      contact.a.lever_arm += half;
      contact.b.lever_arm -= half;
    }
    return contact;
  }

  // The relative velocity, and whether the contact is colliding.

  /// The part of a body's motion that enters the relative velocity. A sound solver uses all of the motion.
  [[nodiscard]] BodyVelocity<double> motion(const ContactBody& body, bool is_a) const {
    const bool is_wall = body.inverse_mass == 0;
    if ((has("other_body_left_out") && !is_a) || (has("wall_velocity_as_zero") && is_wall)) {
      return {};
    }
    if (has("wall_spin_as_zero") && is_wall) {
      return {body.velocity, Vector::Zero()};
    }
    const bool is_reversed = has("spin_crossed_in_reverse_for_b") && !is_a;
    return {body.velocity, is_reversed ? Vector(-body.angular_velocity) : body.angular_velocity};
  }

  /// The relative velocity V, with N·V equal to `normal_velocity_of` (impulse/sticking.hpp).
  [[nodiscard]] Vector relative_velocity(const Contact& contact) const {
    Contact moving = contact;
    for (const auto body : {&Contact::a, &Contact::b}) {
      const BodyVelocity<double> as_read = motion(contact.*body, body == &Contact::a);
      (moving.*body).velocity = as_read.velocity;
      (moving.*body).angular_velocity = as_read.angular_velocity;
    }
    return impulse::relative_velocity_along_normal(moving);
  }

  [[nodiscard]] double normal_velocity_of(const Contact& contact) const {
    const auto of_body = [&](const ContactBody& body, bool is_a) {
      const BodyVelocity<double> as_read = motion(body, is_a);
      return contact.normal.dot(as_read.velocity) + as_read.angular_velocity.dot(body.lever_arm.cross(contact.normal));
    };
    return of_body(contact.a, true) - of_body(contact.b, false);
  }

  [[nodiscard]] bool is_colliding(const Contact& contact, double normal_velocity) const {
    if (contact.a.inverse_mass + contact.b.inverse_mass == 0 && !has("immovable_pair_divides")) {
      return false;
    }
    if (has("approach_of_centres")) {
      return contact.normal.dot(contact.a.velocity - contact.b.velocity) < 0;
    }
    if (has("slow_separating_pulled")) {
      constexpr double slow = 0.05;  // [m/s]
      return normal_velocity < slow * std::sqrt(contact.normal.squaredNorm());
    }
    if (has("slow_approach_ignored") || has("approach_as_resting")) {
      const double slow = has("slow_approach_ignored") ? 1e-3 : 1e-10;  // [m/s]
      return normal_velocity < -slow * std::sqrt(contact.normal.squaredNorm());
    }
    return normal_velocity < 0 || has("separating_pulled");
  }

  // The collision matrix.

  [[nodiscard]] double lambda(const Contact& contact) const {
    double inverse_mass_a = contact.a.inverse_mass;
    double inverse_mass_b = contact.b.inverse_mass;
    if (has("immovable_mass_in_lambda")) {
      constexpr double default_mass = 1;
      inverse_mass_a = inverse_mass_a == 0 ? 1 / default_mass : inverse_mass_a;
      inverse_mass_b = inverse_mass_b == 0 ? 1 / default_mass : inverse_mass_b;
    }
    if (has("mass_ratio_capped")) {
      constexpr double largest_ratio = 100;
      const double larger = std::max(inverse_mass_a, inverse_mass_b);
      inverse_mass_a = inverse_mass_a == 0 ? 0 : std::max(inverse_mass_a, larger / largest_ratio);
      inverse_mass_b = inverse_mass_b == 0 ? 0 : std::max(inverse_mass_b, larger / largest_ratio);
    }
    return inverse_mass_a + inverse_mass_b;
  }

  /// The factor of the angular term; 1 in a sound solver.
  [[nodiscard]] double angular_weight(const Contact& contact) const {
    const bool at_a_centre = contact.a.lever_arm.isZero(0) || contact.b.lever_arm.isZero(0);
    const bool equal_masses = contact.a.inverse_mass == contact.b.inverse_mass;
    if ((has("centre_contact_skips_turning") && at_a_centre) || (has("equal_masses_exchange") && equal_masses)) {
      return 0;
    }
    if (has("angular_term_twice")) {
      return 2;
    }
    if (has("angular_term_subtracted")) {
      return -1;
    }
    constexpr double square_centimetres_in_square_metre = 1e4;
    return has("moments_too_small") ? square_centimetres_in_square_metre : 1;
  }

  [[nodiscard]] const ContactBody& second_body(const Contact& contact) const {
    return has("angular_term_of_a_for_both") ? contact.a : contact.b;
  }

  /// N·K N for the frictionless law, without K.
  [[nodiscard]] double normal_response(const Contact& contact) const {
    const Vector& n = contact.normal;
    const auto angular_term = [&](const ContactBody& body) {
      return impulse::angular_part_along(body.inertia, body.lever_arm, n);
    };
    const double angular = angular_term(contact.a) + angular_term(second_body(contact));
    const double squared_length = has("normal_length_ignored") ? 1 : n.dot(n);
    double linear = lambda(contact) * squared_length;
    if (has("regularised")) {
      linear += regularisation * squared_length;
    }
    return linear + angular * angular_weight(contact);
  }

  [[nodiscard]] Matrix collision_matrix(const Contact& contact) const {
    const auto angular_term = [](const ContactBody& body) -> Matrix {
      return impulse::angular_part_of_collision_matrix(body.inertia, body.lever_arm);
    };
    const Matrix angular = angular_term(contact.a) + angular_term(second_body(contact));
    Matrix matrix = Matrix::Identity() * lambda(contact) + angular * angular_weight(contact);
    if (has("lambda_twice_in_tangents")) {
      const Vector& n = contact.normal;
      matrix += (Matrix::Identity() - n * n.transpose() / n.dot(n)) * lambda(contact);
    }
    if (has("regularised")) {
      matrix += Matrix::Identity() * regularisation;
    }
    formed_ = matrix;
    return matrix;
  }

  [[nodiscard]] Matrix shown(const Matrix& matrix) const {
    if (has("one_triangle_shown")) {
      return matrix.triangularView<Eigen::Lower>();
    }
    return has("diagonal_shown") ? Matrix(matrix.diagonal().asDiagonal()) : matrix;
  }

  // The law.

  /// ε. In a sound solver, ε does not depend on N·V⁻.
  [[nodiscard]] double restitution_of(const Contact& contact, double normal_velocity) const {
    const double length = std::sqrt(contact.normal.squaredNorm());
    double restitution = contact.restitution;
    if (has("velocity_twice_in_restitution")) {
      restitution *= -normal_velocity / length;
    }
    if (has("restitution_threshold")) {
      constexpr double threshold = 0.2;  // [m/s]
      restitution = -normal_velocity < threshold * length ? 0 : restitution;
    }
    if (has("restitution_increased")) {
      constexpr double increase = 0.1;
      restitution += increase;
    }
    if (has("restitution_by_size")) {
      restitution /= 1 + contact.a.lever_arm.norm();
    }
    return restitution;
  }

  [[nodiscard]] Vector solve(const Matrix& matrix, const Vector& right_hand_side) const {
    if (has("determinant_in_float")) {
      const auto determinant = static_cast<double>(matrix.cast<float>().eval().determinant());
      return impulse::Adjugate::solve<double>(matrix, right_hand_side) * (matrix.determinant() / determinant);
    }
    return impulse::Ldlt::solve<double>(matrix, right_hand_side);
  }

  [[nodiscard]] static Vector across_normal(const Contact& contact, const Vector& v) {
    const Vector& n = contact.normal;
    return v - n * (n.dot(v) / n.squaredNorm());
  }

  /// The errors that defects make in the slip. The solver adds them to V⁻, because a recomputed slip would have
  /// rounding errors in all components.
  [[nodiscard]] Vector slip_added(const Contact& contact) const {
    const Vector v = relative_velocity(contact);
    const Vector slip = across_normal(contact, v);
    const Vector of_centres = contact.a.velocity - contact.b.velocity;
    Vector added = Vector::Zero();
    if (has("slip_without_spin")) {
      added += across_normal(contact, of_centres - v);
    }
    if (has("slip_crossed_in_reverse")) {
      added += across_normal(contact, 2 * (of_centres - v));
    }
    if (has("slip_stopped_by_mass_alone")) {
      added += across_normal(contact, collision_matrix(contact) * slip / lambda(contact)) - slip;
    }
    if (has("slip_left_over")) {
      constexpr double left_over = 1e-9;  // the defect itself
      added += slip * -left_over;
    }
    if (has("slip_reversed")) {
      added += slip * tangential_restitution_;
    }
    if (has("tangents_not_orthogonal")) {
      added += v - slip;
    }
    if (has("friction_reversed")) {
      added -= 2 * slip;
    }
    if (has("slip_stopped_by_two_fifths")) {
      constexpr double too_much = 7.0 / 5;  // 2/5 in place of 2/7
      added += slip * (too_much - 1);
    }
    if (has("slip_without_radius")) {
      const auto missing = [](const ContactBody& body) -> Vector {
        const Vector& r = body.lever_arm;
        return body.angular_velocity.cross(Vector(r.stableNormalized() - r));
      };
      added += across_normal(contact, missing(contact.a) - missing(contact.b));
    }
    return added;
  }

  [[nodiscard]] double friction_of(const Contact& contact) const {
    if (has("cone_wider")) {
      constexpr double wider = 1e-9;  // the defect itself
      return contact.friction * (1 + wider);
    }
    if (has("friction_in_degrees")) {
      constexpr double degree = 3.14159265358979323846 / 180;
      return std::abs(std::tan(contact.friction * degree));
    }
    if (has("friction_in_percent")) {
      constexpr double percent = 0.01;
      return contact.friction * percent;
    }
    constexpr double slowest = 1e-16;  // the defect itself [m/s]
    const bool is_left =
        has("slow_slip_left") && across_normal(contact, relative_velocity(contact)).stableNorm() < slowest;
    if (is_left || has("friction_left_out")) {
      return 0;
    }
    return has("friction_multiplied") ? contact.friction * contact.friction : contact.friction;
  }

  /// Friction by the slip before or after the normal impulse, and each of both impulses once.
  [[nodiscard]] Vector impulse_in_one_pass(const Contact& contact, const Matrix& k, double normal_velocity,
                                           const Vector& frictionless_impulse) const {
    const bool is_after = has("friction_after_normal");
    const Vector velocity = relative_velocity(contact);
    const Vector slip = across_normal(contact, is_after ? Vector(velocity + k * frictionless_impulse) : velocity);
    if (slip.isZero(0)) {
      return frictionless_impulse;
    }
    const Vector along = slip.normalized();
    const double stopping = slip.norm() / along.dot(k * along);
    const Vector friction = along * -std::min(friction_of(contact) * frictionless_impulse.norm(), stopping);
    if (is_after) {
      return frictionless_impulse + friction;
    }
    const Vector& n = contact.normal;
    const double change = -(1 + restitution_of(contact, normal_velocity)) * normal_velocity;
    return friction + n * ((change - n.dot(k * friction)) / n.dot(k * n));
  }

  [[nodiscard]] Vector coulomb_impulse(const Contact& contact, double normal_velocity,
                                       const Vector& frictionless_impulse) const {
    const double friction = friction_of(contact);
    const Matrix k = collision_matrix(contact);
    if (friction == 0) {
      return frictionless_impulse;
    }
    const Matrix basis = impulse::stable_tangent_basis(contact);
    const Matrix matrix = impulse::in_basis<double>(k, basis);
    const Vector velocity =
        basis.transpose() * (impulse::relative_velocity_along_normal(contact) + slip_added(contact));
    const Vector change{-(1 + restitution_of(contact, normal_velocity)) * normal_velocity / contact.normal.norm(),
                        -velocity[1], -velocity[2]};
    const impulse::detail::SlipResistance<double> law(matrix, change, lambda(contact), friction);
    Vector impulse = law.impulse(0);
    const Vector slip{0, velocity[1], velocity[2]};
    if (has("friction_after_normal") || has("friction_before_normal")) {
      return impulse_in_one_pass(contact, k, normal_velocity, frictionless_impulse);
    }
    if (has("always_slides") && slip.norm() > 0) {
      const Vector along = Vector::UnitX() - slip * (friction / slip.norm());
      return impulse::times(basis, Vector(along * (change[0] / matrix.row(0).dot(along))));
    }
    if (has("cone_not_asked") || law.is_in_cone(impulse)) {
      return impulse::times(basis, impulse);
    }
    const auto with_tangents = [&](double x, double y) -> Vector {
      return {(change[0] - matrix(0, 1) * x - matrix(0, 2) * y) / matrix(0, 0), x, y};
    };
    if (has("friction_along_sticking")) {
      const Vector tangential{0, impulse[1], impulse[2]};
      const Vector along = Vector::UnitX() + tangential * (friction / tangential.norm());
      impulse = along * (change[0] / matrix.row(0).dot(along));
    } else if (has("friction_along_slip") && slip.norm() > 0) {
      const Vector along = Vector::UnitX() - slip * (friction / slip.norm());
      impulse = along * (change[0] / matrix.row(0).dot(along));
    } else if (has("friction_clamped_by_axis")) {
      const double limit = friction * std::abs(impulse[0]);
      impulse = with_tangents(std::clamp(impulse[1], -limit, limit), std::clamp(impulse[2], -limit, limit));
    } else {
      impulse = law.impulse_on_cone();
    }
    return impulse::times(basis, impulse);
  }

  /// The friction κ D of the law `rough` (impulse/rough.hpp defines κ and D).
  [[nodiscard]] Vector friction_impulse(const Contact& contact, const Vector& frictionless_impulse,
                                        double normal_velocity) const {
    const Vector& n = contact.normal;
    const Matrix k = collision_matrix(contact);
    const Vector stops_approach = n * (-normal_velocity / normal_response(contact));
    const Vector velocity = relative_velocity(contact) + slip_added(contact);
    Vector d = -solve(k, velocity) - stops_approach;
    const Vector tangent = across_normal(contact, velocity + impulse::times(k, stops_approach));
    if (has("friction_along_slip") && tangent.squaredNorm() > 0) {
      d = -tangent * (across_normal(contact, d).norm() / tangent.norm());
    }
    if (has("friction_kept_out_of_normal")) {
      d = across_normal(contact, d);
    }
    if (has("friction_along_rounded_tangents")) {
      const Matrix basis = impulse::tangent_basis(contact);
      d = basis * (basis.transpose() * d);
    }
    double whole = 1 + contact.tangential_restitution;
    if (has("tangential_restitution_ignored")) {
      whole = 1;
    }
    if (has("tangential_restitution_reversed")) {
      whole = 1 - contact.tangential_restitution;
    }
    const double friction = friction_of(contact);
    const double limit = friction * n.dot(has("friction_before_restitution") ? stops_approach : frictionless_impulse);
    if (has("friction_clamped_by_axis") || has("friction_in_pyramid")) {
      const Vector along = beside(n).normalized();
      const Vector across = n.cross(along).normalized();
      const double length = n.norm();
      double x = whole * d.dot(along);
      double y = whole * d.dot(across);
      if (has("friction_in_pyramid")) {
        const double share = std::min(1.0, limit / length / std::max(std::abs(x) + std::abs(y), limit / length));
        x *= share;
        y *= share;
      } else {
        x = std::clamp(x, -limit / length, limit / length);
        y = std::clamp(y, -limit / length, limit / length);
      }
      return along * x + across * y;
    }
    const double divisor = impulse::detail::length<double>(impulse::cross(n, d)) - friction * n.dot(d);
    return d * (whole * divisor <= limit ? whole : limit / divisor);
  }

  [[nodiscard]] Vector lawful_impulse(const Contact& contact, double normal_velocity) const {
    const Vector& n = contact.normal;
    const double restitution = restitution_of(contact, normal_velocity);
    const double change = -(1 + restitution) * normal_velocity;  // of N·V
    const bool along_normal = has("head_on_falls_back") && n.cross(relative_velocity(contact)).isZero(0);
    Vector as_frictionless = n * (change / normal_response(contact));
    if (along_normal || has("normal_matrix_for_tangents")) {
      return as_frictionless;
    }
    const double squared_length = has("normal_length_ignored") ? 1 : n.dot(n);
    const Vector along = n * (change / squared_length);
    switch (law_) {
      case Law::reflection:
        return solve(collision_matrix(contact), along);
      case Law::sticking:
        if (has("slip_stopped_as_of_spheres")) {
          constexpr double share_of_solid_sphere = 2.0 / 7;
          const Vector slip = across_normal(contact, relative_velocity(contact));
          return as_frictionless - slip * (share_of_solid_sphere / lambda(contact));
        }
        return solve(collision_matrix(contact), -(relative_velocity(contact) + slip_added(contact) +
                                                  n * (restitution * normal_velocity / squared_length)));
      case Law::rough:
        return as_frictionless + friction_impulse(contact, as_frictionless, normal_velocity);
      case Law::coulomb:
        return has("rough_for_coulomb") ? as_frictionless + friction_impulse(contact, as_frictionless, normal_velocity)
                                        : coulomb_impulse(contact, normal_velocity, as_frictionless);
      case Law::frictionless:
      case Law::any:  // no mutant claims it
        break;
    }
    return as_frictionless;
  }

  [[nodiscard]] Vector impulse_of(const Contact& contact, double normal_velocity) const {
    Vector impulse = lawful_impulse(contact, normal_velocity);
    if (has("impulse_capped")) {
      constexpr double largest = 10;  // [N s]
      impulse *= std::min(1.0, largest / impulse.norm());
    }
    if (has("small_impulse_dropped")) {
      constexpr double smallest = 1e-12;  // [N s]
      impulse *= impulse.norm() < smallest ? 0 : 1;
    }
    const Vector slip = across_normal(contact, relative_velocity(contact));
    if (has("friction_added") && slip.squaredNorm() > 0) {
      constexpr double friction = 0.1;
      impulse -= slip.normalized() * (friction * impulse.norm());
    }
    if (has("tangent_of_nothing")) {
      constexpr double friction = 0;
      impulse -= slip / slip.norm() * (friction * impulse.norm());
    }
    return impulse;
  }

  // Applying the impulse.

  [[nodiscard]] BodyVelocity<double> pushed(const ContactBody& body, const ContactBody& other, const Vector& impulse,
                                            bool is_a) const {
    double inverse_mass = body.inverse_mass;
    if (has("wrong_mass_in_reaction") && !is_a) {
      inverse_mass = other.inverse_mass;
    }
    if (has("masses_left_out")) {
      inverse_mass = inverse_mass > 0 ? 1 : 0;
    }
    Vector spin = impulse::angular_response(body.inertia, body.lever_arm, impulse);
    if (has("spin_of_b_reversed") && !is_a) {
      spin = -spin;
    }
    if (has("spin_in_plane_only")) {
      spin = Vector(0, 0, spin[2]);
    }
    if (has("spin_about_normal_stopped") && inverse_mass > 0) {
      const Vector about_normal = contact_normal_.normalized();
      spin -= about_normal * about_normal.dot(body.angular_velocity + spin);
    }
    if (has("reaction_dropped") && !is_a) {
      return {body.velocity, body.angular_velocity};
    }
    BodyVelocity<double> after{body.velocity + impulse * inverse_mass, body.angular_velocity + spin};
    if (has("angular_factor_on_mass")) {
      constexpr double angular_factor = 0.5;
      after.velocity = body.velocity + impulse * (inverse_mass * angular_factor);
    }
    if (has("gyroscopic_torque") && body.inverse_mass > 0) {
      constexpr double step = 1.0 / 60;  // [s]
      const Vector& w = body.angular_velocity;
      const auto [axes, inverse_moments] = body.inertia;
      const Vector angular_momentum = axes * (axes.transpose() * w).cwiseQuotient(inverse_moments);
      const Vector torque = axes.transpose() * w.cross(angular_momentum);
      after.angular_velocity -= axes * torque.cwiseProduct(inverse_moments) * step;
    }
    if (has("gravity_of_step") && body.inverse_mass > 0) {
      constexpr double in_a_step = 9.81 / 60;  // [m/s]
      after.velocity[1] -= in_a_step;
    }
    return after;
  }

  [[nodiscard]] Outcome<double> pushed_apart(const Contact& contact, const Vector& on_a, const Vector& on_b) const {
    Outcome<double> after{pushed(contact.a, contact.b, has("normal_flipped_for_a") ? Vector(-on_a) : on_a, true),
                          pushed(contact.b, contact.a, on_b, false)};
    if (has("push_out_velocity")) {
      constexpr double push_out = 0.1;  // [m/s]
      const Vector direction = contact.normal.normalized();
      after.a.velocity += direction * (contact.a.inverse_mass > 0 ? push_out : 0);
      after.b.velocity -= direction * (contact.b.inverse_mass > 0 ? push_out : 0);
    }
    if (has("normal_in_plane_as_planar") && contact.normal[2] == 0) {
      after.a.angular_velocity.head<2>() = contact.a.angular_velocity.head<2>();
      after.b.angular_velocity.head<2>() = contact.b.angular_velocity.head<2>();
    }
    return after;
  }

  /// The impulse of the defects that push bodies at rest.
  [[nodiscard]] std::optional<Vector> push_of_resting(const Contact& contact) const {
    const bool is_pushed = has("resting_pushed_apart") || has("resting_pushed_aside");
    if (!is_pushed || lambda(contact) == 0 || !relative_velocity(contact).isZero(0)) {
      return std::nullopt;
    }
    constexpr double push = 10;  // [m/s]
    const Vector normal = contact.normal.normalized();
    const Vector direction = has("resting_pushed_apart") ? normal : Vector(beside(normal).normalized());
    return direction * (push / lambda(contact));
  }

  [[nodiscard]] Outcome<double> solved(const Collision& collision) {
    Collision misread = collision;
    for (const auto& [defect, misread_body] : misread_bodies) {
      if (has(defect)) {
        misread_body(misread.a);
        misread_body(misread.b);
      }
    }
    for (const auto& [defect, misread_collision] : misread_collisions) {
      if (has(defect)) {
        misread_collision(misread);
      }
    }
    const Contact contact = read(misread);
    double normal_velocity = normal_velocity_of(contact);
    if (!is_colliding(contact, normal_velocity)) {
      if (const std::optional<Vector> push = push_of_resting(contact)) {
        return pushed_apart(contact, *push, -*push);
      }
      return unchanged(collision);
    }
    static_cast<void>(collision_matrix(contact));  // shown also if the solve needs none
    if (has("contact_skipped_at_times") && skips_this_one()) {
      return unchanged(collision);
    }
    if (has("velocity_of_frame_before")) {
      normal_velocity = std::exchange(previous_approach_, normal_velocity);
    }
    tangential_restitution_ = collision.tangential_restitution;
    contact_normal_ = contact.normal;
    if (has("tangent_from_rounding")) {
      return impulse::reflection_in_basis(contact);
    }
    if (has("basis_near_pole") || has("component_tie")) {
      const Vector n = contact.normal.normalized();
      return impulse::reflection_in_given_basis(contact,
                                                has("component_tie") ? basis_without_ties(n) : basis_of_2012(n));
    }
    Outcome<double> after;
    if (has("each_body_alone")) {
      const auto alone = [&](const Contact& of_both, ContactBody Contact::*other) -> Vector {
        Contact one = of_both;
        (one.*other).inverse_mass = 0;
        (one.*other).inertia = impulse::PrincipalInertia<double>::immovable();
        const bool is_wall = one.a.inverse_mass + one.b.inverse_mass == 0;
        return is_wall ? Vector(Vector::Zero()) : impulse_of(one, normal_velocity);
      };
      after = pushed_apart(contact, alone(contact, &Contact::b), -alone(contact, &Contact::a));
    } else {
      Vector impulse = impulse_of(contact, normal_velocity);
      if (has("warm_start_kept")) {
        constexpr double kept = 1e-3;
        impulse += kept * std::exchange(previous_impulse_, impulse);
      }
      after = pushed_apart(contact, impulse, -impulse);
    }
    if (has("spin_in_body_frame")) {
      // The misread spin affects only the impulse. The solver adds the change of the spin to the spin as given.
      after.a.angular_velocity += collision.a.angular_velocity - contact.a.angular_velocity;
      after.b.angular_velocity += collision.b.angular_velocity - contact.b.angular_velocity;
    }
    if (has("identity_drops_spin")) {
      keep_spin_if_identity(collision.a, after.a);
      keep_spin_if_identity(collision.b, after.b);
    }
    return after;
  }

  // The answer.

  [[nodiscard]] Outcome<double> answered(const Collision& collision) {
    if (has("input_returned")) {
      return unchanged(collision);
    }
    if (has("constant_outcome")) {
      return {{{1, 0, 0}, {0, 0, 0}}, {{-1, 0, 0}, {0, 0, 0}}};
    }
    Outcome<double> outcome = solved(collision);
    if (has("previous_outcome")) {
      return std::exchange(previous_, outcome);
    }
    if (has("outcome_to_ten_digits")) {
      constexpr double error = 1e-10;  // the defect itself
      return map_outcome<double>(outcome, [](double x) { return x * (1 + error); });
    }
    if (has("outcome_in_float")) {
      return map_outcome<double>(outcome, [](double x) { return static_cast<double>(static_cast<float>(x)); });
    }
    return outcome;
  }

  [[nodiscard]] bool skips_this_one() {
    constexpr unsigned every = 16;
    return ++contacts_ % every == 0;
  }

  static constexpr double regularisation = 1e-3;  // [1/kg]

  Law law_;
  std::vector<std::string_view> defects_;
  Outcome<double> previous_{{{1, 2, 3}, {0, 0, 0}}, {{0, 0, 0}, {3, 2, 1}}};  // stands for an earlier answer
  double previous_approach_ = -1;                                             // [m/s], times the length of the normal
  Vector previous_impulse_ = Vector::Zero();
  double tangential_restitution_ = 0;  // of this collision
  Vector contact_normal_ = Vector::Zero();
  unsigned contacts_ = 0;
  mutable std::optional<Matrix> formed_;  // the collision matrix of this solve
};

}  // namespace

Subject make_subject(std::string name, Law law, std::vector<std::string_view> defects) {
  Subject subject;
  subject.name = std::move(name);
  subject.law = law;
  subject.precision = Precision::binary64;
  subject.open = [law, defects = std::move(defects)]() -> Session {
    return [solver = Solver(law, defects)](std::span<const Collision> collisions) mutable {
      std::vector<Answer> answers;
      for (const Collision& collision : collisions) {
        answers.push_back(solver.answer(collision));
      }
      return answers;
    };
  };
  subject.shows_collision_matrix = law != Law::frictionless;
  return subject;
}

}  // namespace carom::mutants
