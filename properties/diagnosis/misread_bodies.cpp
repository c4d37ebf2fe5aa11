// SPDX-License-Identifier: BSL-1.0
#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>

#include <carom/oracles/laws/kinematics.hpp>
#include <carom/properties/diagnosis/hypothesis.hpp>
#include <carom/properties/diagnosis/precision.hpp>

namespace carom::properties::diagnosis {
namespace {

/// A way to misread a body in the computation of the impulse, in the application of the impulse, or in both steps.
struct Misreading {
  const char* as_if;  // `{}` stands for one or both bodies
  const char* look_at;
  bool of_mechanics;  // whether both steps read it: mass, moments, orientation, lever arm
  void (*change)(Body& body, const Body& other, const Collision& collision);
  bool of_one_body_alone = false;  // misreading both bodies would change nothing
  bool is_squared = false;         // the collision matrix shows nothing of it
};

constexpr double practically_infinite = 0x1p100;

/// Moments with which the body practically cannot rotate: all terms r²/I are far below 1/m.
Vector3<double> infinite_moments(const Body& body, const Vector3<double>& point) {
  const double at_arm = body.mass * (point - body.position).squaredNorm();
  return practically_infinite * body.principal_inertia.cwiseMax(at_arm);
}

Vector3<double> turned_by(const Quaternion<double>& q, const Vector3<double>& v) {
  return oracles::turned<double>(q, v);
}

const char* const arms = "the lever arm r = P − X";
const char* const frames =
    "the frame of the inertia tensor: turn the lever arm and the impulse into the body's axes, divide each component "
    "of r × F by its moment, and turn the result back";
const char* const moments = "the code that reads the moments of inertia, and their order";
const char* const spin_terms = "the term w × r in the velocity of the contact point";

const std::array misreadings{
    Misreading{"{} could not rotate", "1/I: set to zero, or the rotational part of K is missing", true,
               [](Body& b, const Body&, const Collision& c) { b.principal_inertia = infinite_moments(b, c.point); }},
    Misreading{"the lever arm of {} began at the world's origin", arms, true,
               [](Body& b, const Body&, const Collision&) { b.position.setZero(); }},
    Misreading{"the lever arm of {} were that of the other body", arms, true,
               [](Body& b, const Body& other, const Collision&) { b.position = other.position; }},
    Misreading{"the lever arm of {} were zero, with the contact at the centre of mass", arms, true,
               [](Body& b, const Body&, const Collision& c) { b.position = c.point; }},
    Misreading{"the lever arm of {} lay on the line of the centres, with its right length", arms, true,
               [](Body& b, const Body& other, const Collision& c) {
                 const double length = (c.point - b.position).stableNorm();
                 b.position = c.point - length * (other.position - b.position).stableNormalized();
               }},
    Misreading{"the lever arm of {} had the length 1, without the radius", arms, true,
               [](Body& b, const Body&, const Collision& c) {
                 b.position = c.point - (c.point - b.position).stableNormalized();
               }},
    Misreading{"the lever arm of {} had the other sign", arms, true,
               [](Body& b, const Body&, const Collision& c) { b.position = 2 * c.point - b.position; }, false, true},
    Misreading{"the lever arm of {} were rotated into the body's frame", frames, true,
               [](Body& b, const Body&, const Collision& c) {
                 b.position = c.point - turned_by(oracles::conjugate(b.orientation), c.point - b.position);
               }},
    Misreading{"the orientation of {} were the identity", frames, true,
               [](Body& b, const Body&, const Collision&) {
                 b.orientation = {1, 0, 0, 0};
               }},
    Misreading{"the orientation of {} were inverted, with Rᵀ in place of R", frames, true,
               [](Body& b, const Body&, const Collision&) { b.orientation = oracles::conjugate(b.orientation); }},
    Misreading{"the quaternion of {} were read in the order x, y, z, w",
               "the order of the quaternion's components: w first", true,
               [](Body& b, const Body&, const Collision&) {
                 const Quaternion<double> q = b.orientation;
                 b.orientation = {q[3], q[0], q[1], q[2]};
               }},
    Misreading{
        "the quaternion of {} were read in the order z, y, x, w", "the order of the quaternion's components: w first",
        true,
        [](Body& b, const Body&, const Collision&) { b.orientation = Quaternion<double>(b.orientation.reverse()); }},
    Misreading{"the quaternion of {} lost the sign of its w",
               "the sign of the quaternion: −q has the signs of all four numbers", true,
               [](Body& b, const Body&, const Collision&) { b.orientation[0] = std::abs(b.orientation[0]); }},
    // Without the division by q·q, q v q* multiplies a vector by q·q. J⁻¹ turns twice: into the body frame and back.
    Misreading{"the quaternion of {} were not divided by its length", "the orientation: normalise the quaternion", true,
               [](Body& b, const Body&, const Collision&) {
                 const double squared_length = b.orientation.squaredNorm();
                 b.principal_inertia /= squared_length * squared_length;
               }},
    Misreading{
        "each moment of {} were the mean of the three", moments, true,
        [](Body& b, const Body&, const Collision&) { b.principal_inertia.setConstant(b.principal_inertia.mean()); }},
    Misreading{"the moments of {} were all equal if two of them are", moments, true,
               [](Body& b, const Body&, const Collision&) {
                 Vector3<double>& moments_of_b = b.principal_inertia;
                 for (int i = 0; i < 3; ++i) {
                   if (moments_of_b[i] == moments_of_b[(i + 1) % 3]) {
                     moments_of_b.setConstant(moments_of_b[i]);
                     return;
                   }
                 }
               }},
    Misreading{"each moment of {} were the greatest one", moments, true,
               [](Body& b, const Body&, const Collision&) {
                 b.principal_inertia.setConstant(b.principal_inertia.maxCoeff());
               }},
    Misreading{"each moment of {} were the first one", moments, true,
               [](Body& b, const Body&, const Collision&) { b.principal_inertia.setConstant(b.principal_inertia[0]); }},
    Misreading{"each moment of {} were 1", moments, true,
               [](Body& b, const Body&, const Collision&) { b.principal_inertia.setOnes(); }},
    Misreading{"the moments of {} were sorted", moments, true,
               [](Body& b, const Body&, const Collision&) {
                 std::sort(b.principal_inertia.begin(), b.principal_inertia.end());
               }},
    Misreading{
        "the first two moments of {} were swapped", moments, true,
        [](Body& b, const Body&, const Collision&) { std::swap(b.principal_inertia[0], b.principal_inertia[1]); }},
    Misreading{
        "the last two moments of {} were swapped", moments, true,
        [](Body& b, const Body&, const Collision&) { std::swap(b.principal_inertia[1], b.principal_inertia[2]); }},
    Misreading{
        "the first and the last moment of {} were swapped", moments, true,
        [](Body& b, const Body&, const Collision&) { std::swap(b.principal_inertia[0], b.principal_inertia[2]); }},
    Misreading{"the moments of {} were in the order y, z, x", moments, true,
               [](Body& b, const Body&, const Collision&) {
                 const Vector3<double> given = b.principal_inertia;
                 b.principal_inertia = {given[1], given[2], given[0]};
               }},
    Misreading{"the moments of {} were in the order z, x, y", moments, true,
               [](Body& b, const Body&, const Collision&) {
                 const Vector3<double> given = b.principal_inertia;
                 b.principal_inertia = {given[2], given[0], given[1]};
               }},
    Misreading{"{} had the lever arm, the moments and the orientation of the other body",
               "the body whose terms are read", true,
               [](Body& b, const Body& other, const Collision& c) {
                 b.position = other.position;
                 b.principal_inertia = other.immovable ? infinite_moments(b, c.point) : other.principal_inertia;
                 b.orientation = other.immovable ? b.orientation : other.orientation;
               }},
    Misreading{"the moments of {} were divided by their mass", moments, true,
               [](Body& b, const Body&, const Collision&) { b.principal_inertia /= b.mass; }},
    Misreading{"the moments of {} were those of the other body", moments, true,
               [](Body& b, const Body& other, const Collision&) { b.principal_inertia = other.principal_inertia; }},
    Misreading{
        "the moments of {} were inverted, with I in place of 1/I", "I in place of 1/I", true,
        [](Body& b, const Body&, const Collision&) { b.principal_inertia = b.principal_inertia.cwiseInverse(); }},
    Misreading{"the mass of {} were that of the other body", "the body whose mass is read", true,
               [](Body& b, const Body& other, const Collision&) {
                 b.mass = other.immovable ? practically_infinite * b.mass : other.mass;
               }},
    Misreading{"the mass of {} were 1", "the mass: it is missing", true,
               [](Body& b, const Body&, const Collision&) { b.mass = 1; }},
    Misreading{"the mass of {} were replaced by its inverse", "m in place of 1/m", true,
               [](Body& b, const Body&, const Collision&) { b.mass = 1 / b.mass; }},
    Misreading{"{} were immovable", "the test for immovable bodies: mass thresholds, sleeping bodies, flags", true,
               [](Body& b, const Body&, const Collision& c) {
                 b.mass *= practically_infinite;
                 b.principal_inertia = infinite_moments(b, c.point);
               },
               true},
    Misreading{"{} had no velocity before", "the relative velocity: the v of this body is missing", false,
               [](Body& b, const Body&, const Collision&) { b.velocity.setZero(); }},
    Misreading{"{} had no spin before", spin_terms, false,
               [](Body& b, const Body&, const Collision&) { b.angular_velocity.setZero(); }},
    Misreading{"{} had neither velocity nor spin before", "the relative velocity: this body is missing", false,
               [](Body& b, const Body&, const Collision&) {
                 b.velocity.setZero();
                 b.angular_velocity.setZero();
               }},
    Misreading{"{}, when immovable, had no velocity", "a driven wall: its velocity is missing in V⁻", false,
               [](Body& b, const Body&, const Collision&) {
                 if (b.immovable) {
                   b.velocity.setZero();
                 }
               }},
    Misreading{"{}, when immovable, had no spin", "a driven wall: its spin is missing in V⁻", false,
               [](Body& b, const Body&, const Collision&) {
                 if (b.immovable) {
                   b.angular_velocity.setZero();
                 }
               }},
    Misreading{"{}, when immovable, had neither velocity nor spin", "a driven wall: its motion is missing in V⁻", false,
               [](Body& b, const Body&, const Collision&) {
                 if (b.immovable) {
                   b.velocity.setZero();
                   b.angular_velocity.setZero();
                 }
               }},
    Misreading{"the spin of {} were crossed with the other body's lever arm in V⁻",
               "the term w × r: r and w must belong to the same body", false,
               [](Body& b, const Body& other, const Collision&) {
                 b.velocity += b.angular_velocity.cross(b.position - other.position);
               }},
    Misreading{"the spin of {} in V⁻ were that of the other body",
               "the term w × r: r and w must belong to the same body", false,
               [](Body& b, const Body& other, const Collision&) { b.angular_velocity = other.angular_velocity; }},
    Misreading{"the spin of {} in V⁻ had the other sign", "the order of w × r", false,
               [](Body& b, const Body&, const Collision&) { b.angular_velocity = -b.angular_velocity; }},
    Misreading{"the velocity of {} in V⁻ had the other sign", "V = V_A − V_B", false,
               [](Body& b, const Body&, const Collision&) { b.velocity = -b.velocity; }},
    Misreading{"the spin of {} were in the body's frame", "the frame of the angular velocity: world coordinates", false,
               [](Body& b, const Body&, const Collision&) {
                 b.angular_velocity = turned_by(b.orientation, b.angular_velocity);
               }},
    Misreading{"the spin of {} were rotated into the body's frame",
               "the frame of the angular velocity: world coordinates", false,
               [](Body& b, const Body&, const Collision&) {
                 b.angular_velocity = turned_by(oracles::conjugate(b.orientation), b.angular_velocity);
               }},
    Misreading{"the x component of the lever arm of {} were 0", arms, true,
               [](Body& b, const Body&, const Collision& c) { b.position[0] = c.point[0]; }},
    Misreading{"the x component of the spin of {} in V⁻ were 0", spin_terms, false,
               [](Body& b, const Body&, const Collision&) { b.angular_velocity[0] = 0; }},
    Misreading{"the y component of the lever arm of {} were 0", arms, true,
               [](Body& b, const Body&, const Collision& c) { b.position[1] = c.point[1]; }},
    Misreading{"the y component of the spin of {} in V⁻ were 0", spin_terms, false,
               [](Body& b, const Body&, const Collision&) { b.angular_velocity[1] = 0; }},
    Misreading{"the z component of the lever arm of {} were 0", arms, true,
               [](Body& b, const Body&, const Collision& c) { b.position[2] = c.point[2]; }},
    Misreading{"the z component of the spin of {} in V⁻ were 0", spin_terms, false,
               [](Body& b, const Body&, const Collision&) { b.angular_velocity[2] = 0; }},
};

struct Who {
  const char* name;
  bool a;
  bool b;
};
constexpr std::array whom{Who{"both bodies", true, true}, Who{"A", true, false}, Who{"B", false, true}};

void misread(Collision& collision, const Misreading& misreading, const Who& who) {
  const Collision given = collision;
  const auto change = [&](bool is_meant, Body& body, const Body& other) {
    // Of an immovable body, a solver reads the motion and the lever arm.
    const bool is_read = !body.immovable || !misreading.of_mechanics || misreading.look_at == arms;
    if (is_meant && is_read) {
      misreading.change(body, other, given);
    }
  };
  change(who.a, collision.a, given.b);
  change(who.b, collision.b, given.a);
}

std::string filled(const std::string& text, const char* name) {
  std::string result = text;
  result.replace(result.find("{}"), 2, name);
  return result;
}

/// R, with the axes of the body as columns.
Matrix3<Wide> axes_of(const BasicBody<Wide>& body) {
  Matrix3<Wide> axes;
  for (int i = 0; i < 3; ++i) {
    axes.col(i) = oracles::turned<Wide>(body.orientation, Vector3<Wide>::Unit(i));
  }
  return axes;
}

Matrix3<Wide> moments_of(const BasicBody<Wide>& body) { return body.principal_inertia.asDiagonal(); }
Matrix3<Wide> inverse_moments_of(const BasicBody<Wide>& body) {
  return body.principal_inertia.cwiseInverse().asDiagonal();
}

/// I + 2w [u] + 2 [u]² of the quaternion (w, u), which is R only if its length is 1.
Matrix3<Wide> axes_of_unit_quaternion(const BasicBody<Wide>& body) {
  const Wide w = body.orientation[0];
  const Vector3<Wide> u = body.orientation.tail<3>();
  Matrix3<Wide> axes;
  for (int i = 0; i < 3; ++i) {
    const Vector3<Wide> axis = Vector3<Wide>::Unit(i);
    axes.col(i) = axis + 2 * w * u.cross(axis) + 2 * u.cross(u.cross(axis));
  }
  return axes;
}

Matrix3<Wide> inverse_by_unit_quaternion(const BasicBody<Wide>& b) {
  return axes_of_unit_quaternion(b) * inverse_moments_of(b) * axes_of_unit_quaternion(b).transpose();
}

/// The same in a solver that does not turn the tensor of a sphere.
Matrix3<Wide> inverse_by_unit_quaternion_but_of_spheres(const BasicBody<Wide>& b) {
  return b.principal_inertia.minCoeff() == b.principal_inertia.maxCoeff() ? inverse_inertia(b)
                                                                          : inverse_by_unit_quaternion(b);
}

/// Wrong formulas of J⁻¹ = R diag(1/I) Rᵀ, which both steps use.
std::vector<Hypothesis> misread_inertia() {
  const char* const one_side = "the inverse inertia in world axes: R diag(1/I) Rᵀ";
  const char* const inverted = "I in place of 1/I; the inverse inertia in world axes is R diag(1/I) Rᵀ";
  struct Formula {
    const char* as_if;
    const char* look_at;
    InverseInertia inverse;
    InverseInertia another = nullptr;
  };
  const std::array formulas{
      Formula{"J⁻¹ of {} were R diag(1/I)", one_side,
              [](const BasicBody<Wide>& b) -> Matrix3<Wide> { return axes_of(b) * inverse_moments_of(b); }},
      Formula{"J⁻¹ of {} were diag(1/I) R", one_side,
              [](const BasicBody<Wide>& b) -> Matrix3<Wide> { return inverse_moments_of(b) * axes_of(b); }},
      Formula{"J⁻¹ of {} were diag(1/I) Rᵀ", one_side,
              [](const BasicBody<Wide>& b) -> Matrix3<Wide> { return inverse_moments_of(b) * axes_of(b).transpose(); }},
      Formula{"the matrix R of {} were I + 2w [q] + 2 [q]² of a quaternion whose length is not 1",
              "the orientation: normalise the quaternion", inverse_by_unit_quaternion,
              inverse_by_unit_quaternion_but_of_spheres},
      Formula{"J⁻¹ of {} were R diag(I), with I in place of 1/I", inverted,
              [](const BasicBody<Wide>& b) -> Matrix3<Wide> { return axes_of(b) * moments_of(b); }},
      Formula{"J⁻¹ of {} were diag(I) R, with I in place of 1/I", inverted,
              [](const BasicBody<Wide>& b) -> Matrix3<Wide> { return moments_of(b) * axes_of(b); }}};
  std::vector<Hypothesis> all;
  for (const Formula& formula : formulas) {
    for (const Who& who : whom) {
      Hypothesis& hypothesis = all.emplace_back(Hypothesis{filled(formula.as_if, who.name), formula.look_at, {}});
      for (const InverseInertia inverse : {formula.inverse, formula.another}) {
        if (inverse != nullptr) {
          hypothesis.mistakes.push_back(with_steps([inverse, who](Steps& steps, const KnownCase&) {
            steps.matrix.inverse_of_a = who.a ? inverse : steps.matrix.inverse_of_a;
            steps.matrix.inverse_of_b = who.b ? inverse : steps.matrix.inverse_of_b;
            steps.has_right_impulse = false;
          }));
        }
      }
    }
  }
  return all;
}

/// The velocity and the normal in the body's frame, and the lever arm and the spin in the world's. The second mistake
/// also leaves J⁻¹ out of the change of spin.
std::vector<Hypothesis> mixed_frames() {
  std::vector<Hypothesis> all;
  for (const Who& who : whom) {
    const auto mixed = [who](bool has_inertia) {
      return [who, has_inertia](Steps& steps, const KnownCase&) {
        steps.has_right_impulse = false;
        for (const bool is_a : {true, false}) {
          Body& body = is_a ? steps.computed_from.a : steps.computed_from.b;
          Body& struck = is_a ? steps.applied_to.a : steps.applied_to.b;
          if (!(is_a ? who.a : who.b) || body.immovable) {
            continue;
          }
          // In the world's frame, the solver turns the lever arm and the spin the other way.
          body.position =
              steps.computed_from.point - turned_by(body.orientation, steps.computed_from.point - body.position);
          body.angular_velocity = turned_by(body.orientation, body.angular_velocity);
          (is_a ? steps.has_turned_torque_of_a : steps.has_turned_torque_of_b) = true;
          if (has_inertia) {
            continue;
          }
          struck.principal_inertia.setOnes();
        }
      };
    };
    all.push_back(
        {filled("the velocity and the normal were turned into the frame of {}, but not the lever arm and the spin",
                who.name),
         "the frames of v, w, r and N: all in the world's or all in the body's; J⁻¹ in the change of spin",
         {with_steps(mixed(true)), with_steps(mixed(false))}});
  }
  return all;
}

}  // namespace

std::vector<Hypothesis> misread_bodies() {
  using enum Use;
  static const std::vector<Use> uses_of_motion{computation};
  static const std::vector<Use> uses_of_mechanics{everywhere, computation, application};
  static const std::vector<Use> uses_of_arms{everywhere, computation, application, velocity, matrix};
  std::vector<Hypothesis> all;
  for (const Misreading& misreading : misreadings) {
    const bool is_of_arm = misreading.look_at == arms;
    for (const Use use : is_of_arm ? uses_of_arms : (misreading.of_mechanics ? uses_of_mechanics : uses_of_motion)) {
      if (use == matrix && misreading.is_squared) {
        continue;
      }
      const char* const where = misreading.of_mechanics ? words_of(use) : "";
      const bool is_applied = use == everywhere || use == application;
      Hypothesis of_any{filled(misreading.as_if, "one body or both") + where, misreading.look_at, {}, is_applied};
      of_any.is_choice = true;
      for (const Who& who : whom) {
        if (!(who.a && who.b && misreading.of_one_body_alone)) {
          const Mistake mistake = misread_in(use, [&misreading, who](Collision& c) { misread(c, misreading, who); });
          all.push_back({filled(misreading.as_if, who.name) + where, misreading.look_at, {mistake}, is_applied});
          of_any.mistakes.push_back(mistake);
        }
      }
      all.push_back(std::move(of_any));
    }
  }
  for (const auto part : {misread_inertia, mixed_frames}) {
    std::ranges::move(part(), std::back_inserter(all));
  }
  return all;
}

}  // namespace carom::properties::diagnosis
