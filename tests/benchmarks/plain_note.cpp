// SPDX-License-Identifier: BSL-1.0
#include "plain_note.hpp"

#include <cmath>

namespace carom::benchmarks::plain {
namespace {

Vector operator+(const Vector& u, const Vector& v) { return {u.x + v.x, u.y + v.y, u.z + v.z}; }
Vector operator-(const Vector& u, const Vector& v) { return {u.x - v.x, u.y - v.y, u.z - v.z}; }
Vector operator*(double s, const Vector& v) { return {s * v.x, s * v.y, s * v.z}; }
Vector operator/(const Vector& v, double s) { return {v.x / s, v.y / s, v.z / s}; }
double dot(const Vector& u, const Vector& v) { return u.x * v.x + u.y * v.y + u.z * v.z; }
Vector cross(const Vector& u, const Vector& v) {
  return {u.y * v.z - u.z * v.y, u.z * v.x - u.x * v.z, u.x * v.y - u.y * v.x};
}
double length(const Vector& v) { return std::sqrt(dot(v, v)); }

Matrix operator+(const Matrix& m, const Matrix& n) {
  return {{m.rows[0] + n.rows[0], m.rows[1] + n.rows[1], m.rows[2] + n.rows[2]}};
}
Vector operator*(const Matrix& m, const Vector& v) { return {dot(m.rows[0], v), dot(m.rows[1], v), dot(m.rows[2], v)}; }
Matrix transpose(const Matrix& m) {
  const auto& [u, v, w] = m.rows;
  return {{Vector{u.x, v.x, w.x}, Vector{u.y, v.y, w.y}, Vector{u.z, v.z, w.z}}};
}
Matrix diagonal(const Vector& v) { return {{Vector{v.x, 0, 0}, Vector{0, v.y, 0}, Vector{0, 0, v.z}}}; }
Matrix product(const Matrix& m, const Matrix& n) {
  const Matrix columns = transpose(n);
  return transpose({{m * columns.rows[0], m * columns.rows[1], m * columns.rows[2]}});
}
/// adj(M) / det(M).
Matrix inverse(const Matrix& m) {
  const auto& [u, v, w] = m.rows;
  const Vector vw = cross(v, w);
  const double s = 1 / dot(u, vw);
  return transpose({{s * vw, s * cross(w, u), s * cross(u, v)}});
}

Matrix rotation(const Quaternion<double>& quaternion) {
  const Quaternion<double> q = quaternion / std::sqrt(quaternion.squaredNorm());
  const double w = q[0];
  const double x = q[1];
  const double y = q[2];
  const double z = q[3];
  return {{Vector{1 - 2 * (y * y + z * z), 2 * (x * y - w * z), 2 * (x * z + w * y)},
           Vector{2 * (x * y + w * z), 1 - 2 * (x * x + z * z), 2 * (y * z - w * x)},
           Vector{2 * (x * z - w * y), 2 * (y * z + w * x), 1 - 2 * (x * x + y * y)}}};
}

Vector plain(const Vector3<double>& v) { return {v[0], v[1], v[2]}; }
Vector3<double> shared(const Vector& v) { return {v.x, v.y, v.z}; }

Motion motion_of(const RigidBody& body, const Vector& momentum, const Vector& angular_momentum) {
  return {momentum, angular_momentum, body.inverse_mass * momentum, body.inverse_inertia * angular_momentum};
}

Vector velocity_at(const RigidBody& body, const Vector& lever_arm) {
  return body.motion.velocity + cross(body.motion.angular_velocity, lever_arm);
}

Motion pushed(const RigidBody& body, const Vector& lever_arm, const Vector& impulse) {
  return motion_of(body, body.motion.momentum + impulse, body.motion.angular_momentum + cross(lever_arm, impulse));
}

Motions pushed(const Contact& contact, const Vector& impulse) {
  return {pushed(*contact.a, contact.point - contact.a->position, impulse),
          pushed(*contact.b, contact.point - contact.b->position, -1 * impulse)};
}

/// Qᵀ J⁻¹ Q with the columns q₀ = r × N, q₁ = r × T0, q₂ = r × T1 of Q (note eq. 26 to 28).
Matrix angular_part(const RigidBody& body, const Vector& lever_arm, const Vector& n, const Vector& t0,
                    const Vector& t1) {
  const Vector q0 = cross(lever_arm, n);
  const Vector q1 = cross(lever_arm, t0);
  const Vector q2 = cross(lever_arm, t1);
  const Vector s0 = body.inverse_inertia * q0;
  const Vector s1 = body.inverse_inertia * q1;
  const Vector s2 = body.inverse_inertia * q2;
  const double c01 = dot(q0, s1);
  const double c02 = dot(q0, s2);
  const double c12 = dot(q1, s2);
  return {{Vector{dot(q0, s0), c01, c02}, Vector{c01, dot(q1, s1), c12}, Vector{c02, c12, dot(q2, s2)}}};
}

}  // namespace

RigidBody rigid_body(const Body& body) {
  RigidBody result{0, 0, diagonal({0, 0, 0}), plain(body.position), {}};
  if (!body.immovable) {
    const Matrix axes = rotation(body.orientation);
    const Vector inertia = plain(body.principal_inertia);
    result.mass = body.mass;
    result.inverse_mass = 1 / body.mass;
    result.inverse_inertia =
        product(axes, product(diagonal({1 / inertia.x, 1 / inertia.y, 1 / inertia.z}), transpose(axes)));
    const Vector angular_momentum = axes * (diagonal(inertia) * (transpose(axes) * plain(body.angular_velocity)));
    result.motion = motion_of(result, body.mass * plain(body.velocity), angular_momentum);
  }
  return result;
}

Contact contact(const Collision& collision, const RigidBody& a, const RigidBody& b) {
  const Vector normal = plain(collision.normal);
  return {&a, &b, plain(collision.point), normal / length(normal), collision.restitution};
}

Motions solve_frictionless(const Contact& contact) {
  const RigidBody& a = *contact.a;
  const RigidBody& b = *contact.b;
  const Vector& n = contact.normal;
  const Vector r_a = contact.point - a.position;
  const Vector r_b = contact.point - b.position;
  const double normal_velocity = dot(n, velocity_at(a, r_a) - velocity_at(b, r_b));
  if (normal_velocity >= 0) {
    return {a.motion, b.motion};
  }
  const Vector r_a_n = cross(r_a, n);
  const Vector r_b_n = cross(r_b, n);
  const double f =
      -(1 + contact.restitution) * normal_velocity /
      (a.inverse_mass + b.inverse_mass + dot(r_a_n, a.inverse_inertia * r_a_n) + dot(r_b_n, b.inverse_inertia * r_b_n));
  return pushed(contact, f * n);
}

Motions solve_reflection(const Contact& contact) {
  const RigidBody& a = *contact.a;
  const RigidBody& b = *contact.b;
  const Vector& n = contact.normal;
  const Vector r_a = contact.point - a.position;
  const Vector r_b = contact.point - b.position;
  const Vector relative_velocity = velocity_at(a, r_a) - velocity_at(b, r_b);
  const double normal_velocity = dot(n, relative_velocity);
  if (normal_velocity >= 0) {
    return {a.motion, b.motion};
  }
  const Vector tangential = relative_velocity - normal_velocity * n;
  const double slip = length(tangential);
  if (slip == 0) {
    return solve_frictionless(contact);
  }
  const Vector t0 = tangential / slip;
  const Vector t1 = cross(n, t0);
  const double inverse_mass = a.inverse_mass + b.inverse_mass;
  const Matrix c = diagonal({inverse_mass, inverse_mass, inverse_mass}) +
                   (angular_part(a, r_a, n, t0, t1) + angular_part(b, r_b, n, t0, t1));
  const Vector f = inverse(c) * Vector{-(1 + contact.restitution) * normal_velocity, 0, 0};
  return pushed(contact, f.x * n + f.y * t0 + f.z * t1);
}

Outcome<double> outcome(const Motions& motions) {
  const auto velocities = [](const Motion& motion) {
    return BodyVelocity<double>{shared(motion.velocity), shared(motion.angular_velocity)};
  };
  return {velocities(motions.a), velocities(motions.b)};
}

}  // namespace carom::benchmarks::plain
