// SPDX-License-Identifier: BSL-1.0
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

#include <Eigen/Geometry>
#include <gmpxx.h>

#include <carom/collision/expects.hpp>
#include <carom/scene/polyhedra/rigid_body.hpp>

namespace carom::scene {
namespace {

using impulse::DoubleDouble;

DoubleDouble absolute(const DoubleDouble& x) { return x < DoubleDouble(0) ? -x : x; }

[[maybe_unused]] double greatest_size(const Matrix3<DoubleDouble>& matrix) {
  return matrix.cast<double>().cwiseAbs().maxCoeff();
}

/// The tangent t, |t| ≤ 1, of the rotation that makes the off-diagonal number zero: t² + 2 t θ − 1 = 0, with θ as below
/// (G. Golub, C. Van Loan, "Matrix Computations", §8.5.2).
DoubleDouble tangent_of_rotation(const DoubleDouble& on_p, const DoubleDouble& on_q, const DoubleDouble& off) {
  const DoubleDouble theta = (on_q - on_p) / (DoubleDouble(2) * off);
  if (std::abs(theta.high()) > 0x1p200) {  // the square could overflow
    return DoubleDouble(1) / (DoubleDouble(2) * theta);
  }
  const DoubleDouble t = DoubleDouble(1) / (absolute(theta) + sqrt(theta * theta + DoubleDouble(1)));
  return theta < DoubleDouble(0) ? -t : t;
}

void rotate(PrincipalAxes& result, Matrix3<DoubleDouble>& j, int p, int q) {
  const DoubleDouble t = tangent_of_rotation(j(p, p), j(q, q), j(p, q));
  const DoubleDouble cosine = DoubleDouble(1) / sqrt(t * t + DoubleDouble(1));
  const DoubleDouble sine = t * cosine;
  const int r = 3 - p - q;
  const DoubleDouble moved = t * j(p, q);
  j(p, p) -= moved;
  j(q, q) += moved;
  j(p, q) = j(q, p) = DoubleDouble(0);
  const DoubleDouble rp = j(r, p);
  const DoubleDouble rq = j(r, q);
  j(r, p) = j(p, r) = cosine * rp - sine * rq;
  j(r, q) = j(q, r) = sine * rp + cosine * rq;
  for (int i = 0; i < 3; ++i) {
    const DoubleDouble ip = result.axes(i, p);
    const DoubleDouble iq = result.axes(i, q);
    result.axes(i, p) = cosine * ip - sine * iq;
    result.axes(i, q) = sine * ip + cosine * iq;
  }
}

/// The quaternion of a rotation matrix, whose columns are a right-handed frame. The component of greatest size is
/// positive, and each component is accurate to an ulp of 1.
Quaternion<double> quaternion_of(const Matrix3<DoubleDouble>& r) {
  // Row i of `candidates` is 4 qᵢ times the quaternion q (K. Shoemake, "Quaternions", 1994).
  const DoubleDouble one(1);
  const std::array<std::array<DoubleDouble, 4>, 4> candidates{{
      {one + r(0, 0) + r(1, 1) + r(2, 2), r(2, 1) - r(1, 2), r(0, 2) - r(2, 0), r(1, 0) - r(0, 1)},
      {r(2, 1) - r(1, 2), one + r(0, 0) - r(1, 1) - r(2, 2), r(0, 1) + r(1, 0), r(0, 2) + r(2, 0)},
      {r(0, 2) - r(2, 0), r(0, 1) + r(1, 0), one - r(0, 0) + r(1, 1) - r(2, 2), r(1, 2) + r(2, 1)},
      {r(1, 0) - r(0, 1), r(0, 2) + r(2, 0), r(1, 2) + r(2, 1), one - r(0, 0) - r(1, 1) + r(2, 2)},
  }};
  std::size_t best = 0;
  for (std::size_t i = 1; i < 4; ++i) {
    if (candidates[i][i] > candidates[best][best]) {
      best = i;
    }
  }
  DoubleDouble squared_length(0);
  for (const DoubleDouble& number : candidates[best]) {
    squared_length += number * number;
  }
  const DoubleDouble length = sqrt(squared_length);
  Quaternion<double> quaternion;
  for (int i = 0; i < 4; ++i) {
    quaternion[i] = (candidates[best][static_cast<std::size_t>(i)] / length).high();
  }
  return quaternion;
}

}  // namespace

PrincipalAxes principal_axes(Matrix3<DoubleDouble> inertia) {
  CAROM_EXPECTS(inertia == inertia.transpose(), inertia);
  CAROM_EXPECTS(0x1p-100 <= greatest_size(inertia) && greatest_size(inertia) <= 0x1p+100, greatest_size(inertia));
  PrincipalAxes result;
  for (int i = 0; i < 3; ++i) {
    for (int k = 0; k < 3; ++k) {
      result.axes(i, k) = DoubleDouble(i == k ? 1 : 0);
    }
  }
  constexpr int most_sweeps = 12;  // five suffice
  for (int sweep = 0; sweep < most_sweeps; ++sweep) {
    bool rotated = false;
    for (const auto& [p, q] : {std::pair{0, 1}, std::pair{0, 2}, std::pair{1, 2}}) {
      const double off = std::abs(inertia(p, q).high());
      const double least = std::min(inertia(p, p).high(), inertia(q, q).high());
      if (off > 0x1p-105 * least) {
        rotate(result, inertia, p, q);
        rotated = true;
      }
    }
    if (!rotated) {
      break;
    }
  }
  result.moments = {inertia(0, 0), inertia(1, 1), inertia(2, 2)};
  return result;
}

namespace {

using Triple = std::array<mpq_class, 3>;

std::size_t at(int i) { return static_cast<std::size_t>(i); }

/// The double nearest to a number, with ties to an even last digit. For a number outside the range of normal doubles,
/// the result is outside that range, too, or zero.
double nearest(const mpq_class& number) {
  const double toward_zero = number.get_d();  // GMP truncates
  if (toward_zero == 0 || !std::isfinite(toward_zero)) {
    return toward_zero;
  }
  const double away = std::nextafter(toward_zero, std::copysign(std::numeric_limits<double>::infinity(), toward_zero));
  if (!std::isfinite(away)) {
    return away;
  }
  const mpq_class middle = (mpq_class(toward_zero) + mpq_class(away)) / 2;
  const int side = cmp(abs(number), abs(middle));
  if (side != 0) {
    return side < 0 ? toward_zero : away;
  }
  int exponent = 0;
  const double digits = std::ldexp(std::frexp(toward_zero, &exponent), std::numeric_limits<double>::digits);
  return std::fmod(digits, 2) == 0 ? toward_zero : away;
}

DoubleDouble nearest_double_double(const mpq_class& number) {
  const double high = nearest(number);
  return DoubleDouble::of_parts(high, nearest(number - mpq_class(high)));
}

/// 6 ∫1, 24 ∫x and 120 ∫x xᵀ over a polyhedron, about its first vertex.
struct Integrals {
  mpq_class volume;
  Triple first;
  std::array<Triple, 3> second;
};

void add_tetrahedron(Integrals& integrals, const Triple& a, const Triple& b, const Triple& c) {
  const mpq_class determinant =
      a[0] * (b[1] * c[2] - b[2] * c[1]) + a[1] * (b[2] * c[0] - b[0] * c[2]) + a[2] * (b[0] * c[1] - b[1] * c[0]);
  const Triple sum{a[0] + b[0] + c[0], a[1] + b[1] + c[1], a[2] + b[2] + c[2]};
  integrals.volume += determinant;
  for (std::size_t i = 0; i < 3; ++i) {
    integrals.first[i] += determinant * sum[i];
    for (std::size_t k = i; k < 3; ++k) {
      integrals.second[i][k] += determinant * (a[i] * a[k] + b[i] * b[k] + c[i] * c[k] + sum[i] * sum[k]);
    }
  }
}

Triple lifted_difference(const Vector3<double>& left, const Vector3<double>& right) {
  Triple result;
  for (int i = 0; i < 3; ++i) {
    result[at(i)] = mpq_class(left[i]) - mpq_class(right[i]);
  }
  return result;
}

Integrals integrals_of(const std::vector<Triple>& points, const std::vector<std::vector<std::size_t>>& faces) {
  Integrals integrals;
  for (const std::vector<std::size_t>& face : faces) {
    for (std::size_t i = 2; i < face.size(); ++i) {
      add_tetrahedron(integrals, points[face[0]], points[face[i - 1]], points[face[i]]);
    }
  }
  return integrals;
}

struct ExactProperties {
  mpq_class volume;
  Triple centre;
  std::array<Triple, 3> inertia;  // about the centre of mass
};

ExactProperties exact_properties(const Integrals& integrals, const mpq_class& density) {
  ExactProperties exact;
  exact.volume = integrals.volume / 6;
  for (std::size_t i = 0; i < 3; ++i) {
    exact.centre[i] = integrals.first[i] / (4 * integrals.volume);
  }
  std::array<Triple, 3> second;  // about the centre of mass
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t k = i; k < 3; ++k) {
      second[i][k] = integrals.second[i][k] / 120 - exact.volume * exact.centre[i] * exact.centre[k];
      second[k][i] = second[i][k];
    }
  }
  const mpq_class trace = second[0][0] + second[1][1] + second[2][2];
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t k = 0; k < 3; ++k) {
      exact.inertia[i][k] = density * ((i == k ? trace : mpq_class(0)) - second[i][k]);
    }
  }
  return exact;
}

mpq_class times_power_of_two(const mpq_class& number, int exponent) {
  mpq_class result;
  if (exponent >= 0) {
    mpq_mul_2exp(result.get_mpq_t(), number.get_mpq_t(), static_cast<mp_bitcnt_t>(exponent));
  } else {
    mpq_div_2exp(result.get_mpq_t(), number.get_mpq_t(), static_cast<mp_bitcnt_t>(-exponent));
  }
  return result;
}

bool is_in_range(double positive) { return std::isnormal(positive) && positive > 0; }

std::optional<ShapeDefect> defect_of(const MassProperties& properties) {
  if (is_in_range(properties.volume) && is_in_range(properties.mass) && properties.inertia.allFinite() &&
      std::all_of(properties.principal_inertia.begin(), properties.principal_inertia.end(), is_in_range)) {
    return std::nullopt;
  }
  return ShapeDefect{"its volume, mass or moments of inertia overflow or underflow binary64"};
}

std::optional<ShapeDefect> defect_of_density(double density) {
  if (std::isfinite(density) && density > 0) {
    return std::nullopt;
  }
  return ShapeDefect{"the density is not a positive finite number"};
}

Eigen::Quaterniond unit(const Quaternion<double>& q) {
  const Quaternion<double> scaled = q / q.cwiseAbs().maxCoeff();
  const Quaternion<double> u = scaled / scaled.norm();
  return {u[0], u[1], u[2], u[3]};
}

}  // namespace

std::variant<PolyhedralBody, ShapeDefect> polyhedral_body(const ConvexPolyhedron& polyhedron, double density) {
  if (const std::optional<ShapeDefect> defect = defect_of_density(density)) {
    return *defect;
  }
  const Vector3<double>& origin = polyhedron.vertices.front();
  std::vector<Triple> points;
  for (const Vector3<double>& vertex : polyhedron.vertices) {
    points.push_back(lifted_difference(vertex, origin));
  }
  const ExactProperties exact = exact_properties(integrals_of(points, polyhedron.faces), mpq_class(density));

  PolyhedralBody body;
  MassProperties& properties = body.properties;
  properties.volume = nearest(exact.volume);
  properties.mass = nearest(exact.volume * density);
  mpq_class trace;
  for (int i = 0; i < 3; ++i) {
    properties.centre[i] = nearest(exact.centre[at(i)] + mpq_class(origin[i]));
    trace += exact.inertia[at(i)][at(i)];
    for (int k = 0; k < 3; ++k) {
      properties.inertia(i, k) = nearest(exact.inertia[at(i)][at(k)]);
    }
  }
  const double size = nearest(trace);
  if (!is_in_range(size)) {
    return ShapeDefect{"its moments of inertia overflow or underflow binary64"};
  }
  // Scaling by a power of two makes the search for axes independent of the body's size.
  int exponent = 0;
  std::frexp(size, &exponent);
  Matrix3<DoubleDouble> scaled;
  for (int i = 0; i < 3; ++i) {
    for (int k = 0; k < 3; ++k) {
      scaled(i, k) = nearest_double_double(times_power_of_two(exact.inertia[at(i)][at(k)], -exponent));
    }
  }
  const PrincipalAxes principal = principal_axes(scaled);
  properties.orientation = quaternion_of(principal.axes);
  for (int i = 0; i < 3; ++i) {
    properties.principal_inertia[i] = std::ldexp(principal.moments[i].high(), exponent);
  }

  body.shape = polyhedron;
  for (std::size_t v = 0; v < points.size(); ++v) {
    std::array<DoubleDouble, 3> from_centre;
    for (std::size_t i = 0; i < 3; ++i) {
      from_centre[i] = nearest_double_double(points[v][i] - exact.centre[i]);
    }
    for (int i = 0; i < 3; ++i) {
      DoubleDouble sum(0);
      for (int k = 0; k < 3; ++k) {
        sum += principal.axes(k, i) * from_centre[at(k)];
      }
      body.shape.vertices[v][i] = sum.high();
    }
    body.radius = std::max(body.radius, body.shape.vertices[v].norm());
  }
  // No square overflows. A norm of three squares is accurate to 4 ulps.
  body.radius *= 1 + 0x1p-50;
  if (const std::optional<ShapeDefect> defect = defect_of(properties)) {
    return *defect;
  }
  return body;
}

std::variant<MassProperties, ShapeDefect> sphere_mass_properties(double radius, double density) {
  if (const std::optional<ShapeDefect> defect = defect_of_density(density)) {
    return *defect;
  }
  if (!std::isfinite(radius) || radius <= 0) {
    return ShapeDefect{"the radius is not a positive finite number"};
  }
  // `pi` has a relative error of 2⁻¹⁰⁷.
  const DoubleDouble pi = DoubleDouble::of_parts(0x1.921fb54442d18p+1, 0x1.1a62633145c07p-53);
  const DoubleDouble squared = DoubleDouble(radius) * DoubleDouble(radius);
  const DoubleDouble volume = DoubleDouble(4) * pi * squared * DoubleDouble(radius) / DoubleDouble(3);
  const DoubleDouble mass = volume * DoubleDouble(density);
  const DoubleDouble moment = DoubleDouble(2) * mass * squared / DoubleDouble(5);
  MassProperties properties;
  properties.volume = volume.high();
  properties.mass = mass.high();
  properties.principal_inertia.setConstant(moment.high());
  properties.inertia = properties.principal_inertia.asDiagonal();
  properties.orientation = {1, 0, 0, 0};
  if (const std::optional<ShapeDefect> defect = defect_of(properties)) {
    return *defect;
  }
  return properties;
}

std::variant<RigidBody, ShapeDefect> rigid_body(const Polyhedron& polyhedron) {
  CAROM_EXPECTS(
      polyhedron.position.allFinite() && polyhedron.velocity.allFinite() && polyhedron.angular_velocity.allFinite(),
      polyhedron.position, polyhedron.velocity, polyhedron.angular_velocity);
  CAROM_EXPECTS(polyhedron.orientation.allFinite() && !polyhedron.orientation.isZero(0), polyhedron.orientation);
  const auto hull = convex_polyhedron(polyhedron.vertices);
  if (const auto* defect = std::get_if<ShapeDefect>(&hull)) {
    return *defect;
  }
  const auto moved = polyhedral_body(std::get<ConvexPolyhedron>(hull), polyhedron.density);
  if (const auto* defect = std::get_if<ShapeDefect>(&moved)) {
    return *defect;
  }
  const auto& body = std::get<PolyhedralBody>(moved);
  const Eigen::Quaterniond own = unit(polyhedron.orientation);
  const Eigen::Quaterniond axes = (own * unit(body.properties.orientation)).normalized();
  RigidBody result;
  result.shape = convex_shape(body);
  result.mass = body.properties.mass;
  result.principal_inertia = body.properties.principal_inertia;
  result.position = polyhedron.position + own * body.properties.centre;
  result.orientation = {axes.w(), axes.x(), axes.y(), axes.z()};
  result.velocity = polyhedron.velocity;
  result.angular_velocity = polyhedron.angular_velocity;
  return result;
}

RigidBody rigid_body(const Sphere& sphere) {
  RigidBody result;
  result.shape = ball_shape(sphere.radius);
  const auto properties = sphere_mass_properties(sphere.radius, sphere.density);
  if (const auto* known = std::get_if<MassProperties>(&properties)) {
    result.mass = known->mass;
    result.principal_inertia = known->principal_inertia;
  }
  result.position = sphere.position;
  result.velocity = sphere.velocity;
  result.angular_velocity = sphere.angular_velocity;
  return result;
}

}  // namespace carom::scene
