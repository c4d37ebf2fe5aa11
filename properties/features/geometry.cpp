// SPDX-License-Identifier: BSL-1.0
#include <cmath>

#include <carom/collision/expects.hpp>
#include <carom/properties/draws/vectors.hpp>
#include <carom/properties/features/geometry.hpp>

namespace carom::properties::features {
namespace {

/// Whether a b = c d exactly, except for underflow. std::fma gives the rounding error of each product.
bool same_product(double a, double b, double c, double d) {
  const double left = a * b;
  const double right = c * d;
  return left == right && std::fma(a, b, -left) == std::fma(c, d, -right);
}

/// Whether x − y = difference exactly. The rounding error of a sum is a floating-point number (O. Møller, BIT 5, 1965).
bool is_difference(double x, double y, double difference) {
  const double computed = x - y;
  const double of_y = computed - x;
  return computed == difference && (x - (computed - of_y)) - (y + of_y) == 0;
}

}  // namespace

bool are_parallel(const Vector3<double>& u, const Vector3<double>& v) {
  return !is_zero(u) && !is_zero(v) && same_product(u[1], v[2], u[2], v[1]) && same_product(u[2], v[0], u[0], v[2]) &&
         same_product(u[0], v[1], u[1], v[0]);
}

bool has_ties(const Vector3<double>& v) {
  const Vector3<double> size = v.cwiseAbs();
  return (size[0] == size[1] && size[0] != 0) || (size[1] == size[2] && size[1] != 0) ||
         (size[2] == size[0] && size[2] != 0);
}

Vector3<double> with_few_bits(const Vector3<double>& v) {
  return v.unaryExpr([](double x) { return rounded_to_bits(x, 8); });
}

double size_of(const Vector3<double>& v) {
  if (is_zero(v)) {
    return 1;
  }
  int exponent = 0;
  std::frexp(length(v), &exponent);
  return std::ldexp(1.0, exponent - 1);
}

Vector3<double> turned_along(const Vector3<double>& v, const Vector3<double>& direction) {
  return direction * (size_of(v) / size_of(direction));
}

Vector3<double> turned_across(Stream& stream, const Vector3<double>& v, const Vector3<double>& direction) {
  const int kept = stream.integer(0, 2);  // this component becomes zero
  const int next = (kept + 1) % 3;
  const int last = (kept + 2) % 3;
  Vector3<double> across = Vector3<double>::Zero();
  if (direction[next] == 0 && direction[last] == 0) {
    across[next] = 1;
  } else {
    across[next] = -direction[last];
    across[last] = direction[next];
  }
  return turned_along(v, stream.chance(2) ? across : negated(across));
}

void put_in_plane(Stream& stream, Vector3<double>& v) {
  const int zero = stream.integer(0, 2);
  for (int i = 0; i < 3; ++i) {
    v[i] = i == zero ? 0 : (v[i] == 0 ? size_of(v) : v[i]);
  }
}

void scale_mass(Body& body, double by) {
  body.mass *= by;
  body.principal_inertia *= by;
}

void set_mass(Body& body, double mass) {
  body.principal_inertia *= mass / body.mass;
  body.mass = mass;
}

double radius_of_gyration(const Body& body) {
  return body.immovable ? 0 : std::sqrt(sum(body.principal_inertia) / 2 / body.mass);
}

double least_radius_of_gyration(const Collision& collision) {
  const double of_a = radius_of_gyration(collision.a);
  const double of_b = radius_of_gyration(collision.b);
  return of_a == 0 || of_b == 0 ? std::max(of_a, of_b) : std::min(of_a, of_b);
}

double overreach(const Collision& collision, const Body& body) {
  if (body.immovable) {
    return 0;
  }
  const Vector3<double> r = turned(conjugate(body.orientation), lever_arm(collision, body));
  double greatest = 0;
  for (int i = 0; i < 3; ++i) {
    const double y = r[(i + 1) % 3];
    const double z = r[(i + 2) % 3];
    greatest = std::max(greatest, (y * y + z * z) * body.mass / (4 * body.principal_inertia[i]));
  }
  return std::sqrt(greatest);
}

Vector3<double> long_axis(const Body& body) {
  CAROM_EXPECTS(!body.immovable);
  return turned(body.orientation, Vector3<double>::Unit(place_of_least(body.principal_inertia)));
}

void set_lever_arm(Collision& collision, Body& body, const Vector3<double>& r) { body.position = collision.point - r; }

bool is_exact_lever_arm(const Collision& collision, const Body& body) {
  const Vector3<double> r = lever_arm(collision, body);
  bool exact = true;
  for (int i = 0; i < 3; ++i) {
    exact = exact && is_difference(collision.point[i], body.position[i], r[i]);
  }
  return exact;
}

void move_point_to_origin(Collision& collision) {
  const Vector3<double> of_a = lever_arm(collision, collision.a);
  const Vector3<double> of_b = lever_arm(collision, collision.b);
  collision.point.setZero();
  collision.a.position = negated(of_a);
  collision.b.position = negated(of_b);
}

void set_exact_lever_arm(Collision& collision, Body& body, const Vector3<double>& r) {
  set_lever_arm(collision, body, r);
  if (lever_arm(collision, body) == r && is_exact_lever_arm(collision, body)) {
    return;
  }
  Body& other = &body == &collision.a ? collision.b : collision.a;
  const Vector3<double> of_other = lever_arm(collision, other);
  collision.point = with_few_bits(collision.point);
  set_lever_arm(collision, body, r);
  set_lever_arm(collision, other, of_other);
  if (!(lever_arm(collision, body) == r && is_exact_lever_arm(collision, body) &&
        is_exact_lever_arm(collision, other))) {
    collision.point.setZero();
    body.position = negated(r);
    other.position = negated(of_other);
  }
}

void spin_along_lever_arm(const Collision& collision, Body& body) {
  if (!is_zero(body.angular_velocity) && !is_zero(lever_arm(collision, body))) {
    body.angular_velocity = turned_along(body.angular_velocity, lever_arm(collision, body));
  }
}

void make_movable(Stream& stream, const Collision& collision, Body& body) {
  if (!body.immovable) {
    return;
  }
  const double size = size_of(lever_arm(collision, body));
  body.immovable = false;
  body.mass = 1 + stream.unit();
  for (int i = 0; i < 3; ++i) {
    body.principal_inertia[i] = body.mass * size * size * (1 + stream.unit());
  }
  body.orientation = stream.quaternion();
}

void make_both_movable(Stream& stream, Collision& collision) {
  make_movable(stream, collision, collision.a);
  make_movable(stream, collision, collision.b);
}

}  // namespace carom::properties::features
