// SPDX-License-Identifier: BSL-1.0
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <string>
#include <variant>
#include <vector>

#include <Eigen/Geometry>
#include <fmt/format.h>

#include <carom/collision/expects.hpp>
#include <carom/properties/scenes/body_track.hpp>
#include <carom/properties/scenes/history.hpp>
#include <carom/properties/scenes/validity.hpp>
#include <carom/scene/polyhedra/rigid_body.hpp>

namespace carom::properties {
namespace {

using Real = long double;
using Wide = WideVector;
using scene::Arc;

/// The time between two looks, times a body's angular speed at the first look, is at most this [rad]. A look computes
/// the gap of two bodies, or of a body and a plane, at one time.
constexpr Real largest_turn = 0.25;
constexpr int most_halvings = 40;
/// The check misses no overlap deeper than this, relative to the lesser radius of the bodies, unless it reaches
/// `most_halvings`.
constexpr Real allowed_unseen = 0x1p-30L;
/// The permitted jump of an orientation at a joint of arcs [rad]. It exceeds the error of an orientation at the end of
/// an arc, 2⁻⁴⁰ (`longest_turn` in free_flight.hpp).
constexpr Real allowed_turn = 0x1p-38L;
/// The permitted jump of a position at a joint of arcs, relative to the terms of the parabola x + s (v + s a/2) of
/// `scene::Path`. The position is rounded eight times.
constexpr Real allowed_jump = 0x1p-48L;
/// The largest gap between bodies at an impact, relative to the lesser radius.
constexpr Real widest_contact = 0x1p-29L;
/// If a velocity changes by more than this share, the change is not rounding of free flight: something struck the body.
constexpr Real least_change = 0x1p-36L;
/// The error of a gap, relative to its terms. It covers some hundred roundings of long double, and the rounding of the
/// vertices to double.
constexpr Real gap_error = 0x1p-46L;

/// A direction along which the check computes the gap between A and B. `of` is the way to construct the direction:
///
/// - `face_of_a`, `face_of_b`: the normal of face `first` of A or of B
/// - `edges`: the cross product of A's edge direction `first` and B's edge direction `second`
/// - `centres`: the line through the centres of two balls
/// - `vertex`: the line through a ball's centre and vertex `first` of a polyhedron
/// - `edge`: the perpendicular from a ball's centre to the line through edge `first` of a polyhedron
struct Axis {
  enum class Of : std::uint8_t { face_of_a, face_of_b, edges, centres, vertex, edge };
  Of of = Of::centres;
  std::size_t first = 0;
  std::size_t second = 0;
  Real sign = 1;  // chosen so that the direction points from B to A
};

/// A half-space: its unit normal, and the distance of its plane from the origin along the normal [m].
struct Ground {
  Wide normal;
  Real offset;
};

/// The gap, or −∞ if it is not finite, for example because of a NaN. A gap of −∞ excludes no overlap.
Real known(Real gap) { return std::isfinite(gap) ? gap : -std::numeric_limits<Real>::infinity(); }

class PolyhedraChecker {
 public:
  PolyhedraChecker(const scene::Scene& scene, const History& history, const Stops& stops)
      : scene_(scene), history_(history), stops_(stops) {
    for (std::size_t i = 0; i < body_count(scene); ++i) {
      const bool is_ball = is_sphere(scene, i);
      const auto body = [&]() -> scene::RigidBody {
        if (is_ball) {
          return rigid_body(scene.spheres[i]);
        }
        return std::get<scene::RigidBody>(rigid_body(polyhedron_of(scene, i)));
      }();
      tracks_.emplace_back(body, is_ball, history.arcs()[i], history.orientations()[i]);
    }
    for (const scene::Plane& plane : scene.planes) {
      const Wide normal = wide(plane.normal).normalized();
      grounds_.push_back({normal, normal.dot(wide(plane.point))});
    }
  }

  [[nodiscard]] Validity check() {
    for (std::size_t i = 0; i < tracks_.size(); ++i) {
      check_order(i);
    }
    if (found_.count > 0) {
      // The other checks need arcs in order, because a body has no position before an arc begins.
      return std::move(found_);
    }
    for (std::size_t i = 0; i < tracks_.size(); ++i) {
      check_joints(i);
      for (std::size_t k = 0; k < i; ++k) {
        check_pair(k, i);
      }
      for (std::size_t plane = 0; plane < grounds_.size(); ++plane) {
        check_plane(i, plane);
      }
    }
    return std::move(found_);
  }

 private:
  /// The poses of A and B at one time, with the largest gap between them and the direction of this gap.
  struct Look {
    Real time;
    Pose a, b;
    Axis axis;
    Real gap;
  };

  void report(std::size_t body, std::string other, Real begin, Real end, std::string what) {
    ++found_.count;
    if (found_.invalid.size() < most_shown) {
      found_.invalid.push_back(
          {body, std::move(other), static_cast<double>(begin), static_cast<double>(end), std::move(what)});
    }
  }

  [[nodiscard]] double end_of(std::size_t body, std::size_t arc) const {
    const std::vector<Arc>& arcs = tracks_[body].arcs();
    return arc + 1 < arcs.size() ? arcs[arc + 1].path.start : history_.end();
  }

  void check_order(std::size_t body) {
    const std::vector<Arc>& arcs = tracks_[body].arcs();
    for (std::size_t k = 1; k < arcs.size(); ++k) {
      const double start = arcs[k].path.start;
      const double before = arcs[k - 1].path.start;
      if (!(start >= before)) {
        report(body, "itself", before, start, "a path begins before the preceding path");
      }
    }
  }

  void check_joints(std::size_t body) {
    BodyTrack& track = tracks_[body];
    for (std::size_t k = 1; k < track.arcs().size() && goes_on(); ++k) {
      ++found_.joints;
      const scene::Path& path = track.arcs()[k].path;
      const scene::Path& before = track.arcs()[k - 1].path;
      const Pose pose = track.pose(k - 1, path.start);
      const auto jump = static_cast<double>((wide(path.position) - pose.centre).cwiseAbs().maxCoeff());
      found_.largest_jump = std::max(found_.largest_jump, jump);
      const Real s = static_cast<Real>(path.start) - before.start;
      const Real terms = wide(before.position).norm() + wide(path.position).norm() +
                         s * (wide(before.velocity).norm() + s / 2 * wide(before.acceleration).norm());
      if (!(jump <= allowed_jump * terms)) {
        report(body, "itself", before.start, path.start, fmt::format("its path jumps by {:.3g} m", jump));
      }
      const Wide spin = wide(track.arcs()[k].turning.angular_velocity);
      const auto is_changed = [](const Wide& from, const Wide& to, Real size) {
        return !((to - from).norm() <= least_change * size);
      };
      const Real speed = wide(before.velocity).norm() + s * wide(before.acceleration).norm();
      if ((is_changed(pose.velocity, wide(path.velocity), speed) ||
           is_changed(pose.angular_velocity, spin, pose.angular_velocity.norm())) &&
          !touches_something(body, k)) {
        report(body, "itself", path.start, path.start, "it is struck although nothing touches it");
      }
      if (!track.is_ball()) {
        const Real turn = (wide_rotation(track.orientation(k)) - pose.axes).norm() / std::sqrt(Real(2));
        if (!(turn <= allowed_turn)) {
          report(body, "itself", before.start, path.start,
                 fmt::format("its orientation jumps by {} rad", static_cast<double>(turn)));
        }
      }
    }
  }

  /// Whether the body touches a plane at the start of an arc, or touches a body that is struck at the same time.
  [[nodiscard]] bool touches_something(std::size_t body, std::size_t arc) {
    const double time = tracks_[body].arcs()[arc].path.start;
    const Pose pose = tracks_[body].pose(arc, time);
    const Real radius = tracks_[body].radius();
    for (const Ground& ground : grounds_) {
      if (height(body, ground, pose) <= widest_contact * radius) {
        return true;
      }
    }
    for (std::size_t other = 0; other < tracks_.size(); ++other) {
      const std::vector<Arc>& arcs = tracks_[other].arcs();
      const auto at = std::lower_bound(arcs.begin() + 1, arcs.end(), time,
                                       [](const Arc& one, double t) { return one.path.start < t; });
      if (other == body || at == arcs.end() || at->path.start != time) {
        continue;
      }
      const auto its_arc = static_cast<std::size_t>(at - arcs.begin());
      const auto [low, high] = std::minmax(body, other);
      const Look both = look(low, low == body ? arc : its_arc, high, high == body ? arc : its_arc, time);
      if (both.gap <= widest_contact * std::min(radius, tracks_[other].radius())) {
        return true;
      }
    }
    return false;
  }

  [[nodiscard]] Wide direction(std::size_t i, std::size_t k, const Axis& axis, const Pose& a, const Pose& b) const {
    switch (axis.of) {
      case Axis::Of::face_of_a:
        return axis.sign * (a.axes * tracks_[i].face_normals()[axis.first]);
      case Axis::Of::face_of_b:
        return axis.sign * (b.axes * tracks_[k].face_normals()[axis.first]);
      case Axis::Of::edges: {
        const Wide across = (a.axes * tracks_[i].edge_directions()[axis.first])
                                .cross(b.axes * tracks_[k].edge_directions()[axis.second]);
        const Real length = across.norm();
        return length > 0x1p-30L ? Wide(across * (axis.sign / length)) : Wide(Wide::Zero());
      }
      case Axis::Of::centres:
        return (a.centre - b.centre).normalized();
      case Axis::Of::vertex:
      case Axis::Of::edge:
        break;
    }
    // The direction points from B to A. One of them is the ball, and the other is the polyhedron with the point `from`.
    const bool is_a_ball = tracks_[i].is_ball();
    const Pose& polyhedron = is_a_ball ? b : a;
    const Wide ball = is_a_ball ? a.centre - b.centre : b.centre - a.centre;
    Wide from = polyhedron.vertices[axis.first];
    if (axis.of == Axis::Of::edge) {
      const auto& edge = tracks_[is_a_ball ? k : i].edges()[axis.first];
      const Wide& begin = polyhedron.vertices[edge[0]];
      const Wide along = polyhedron.vertices[edge[1]] - begin;
      from = begin + along * ((ball - begin).dot(along) / along.squaredNorm());
    }
    return (is_a_ball ? Wide(ball - from) : Wide(from - ball)).normalized();
  }

  [[nodiscard]] Real gap_along(std::size_t i, std::size_t k, const Wide& n, const Pose& a, const Pose& b) const {
    Real low = std::numeric_limits<Real>::infinity();
    for (const Wide& vertex : a.vertices) {
      low = std::min(low, n.dot(vertex));
    }
    Real high = -std::numeric_limits<Real>::infinity();
    for (const Wide& vertex : b.vertices) {
      high = std::max(high, n.dot(vertex));
    }
    return known(n.dot(a.centre - b.centre) + low - high - tracks_[i].margin() - tracks_[k].margin());
  }

  [[nodiscard]] Look look(std::size_t i, std::size_t arc_i, std::size_t k, std::size_t arc_k, Real time) {
    ++found_.pairs;
    Look best{
        time, tracks_[i].pose(arc_i, time), tracks_[k].pose(arc_k, time), {}, -std::numeric_limits<Real>::infinity()};
    const auto consider = [&](Axis axis) {
      Wide n = direction(i, k, axis, best.a, best.b);
      if (n.isZero(0)) {
        return;
      }
      if (n.dot(best.a.centre - best.b.centre) < 0 && axis.of <= Axis::Of::edges) {
        axis.sign = -1;
        n = -n;
      }
      const Real gap = gap_along(i, k, n, best.a, best.b);
      if (gap > best.gap) {
        best.gap = gap;
        best.axis = axis;
      }
    };
    const BodyTrack& a = tracks_[i];
    const BodyTrack& b = tracks_[k];
    if (a.is_ball() && b.is_ball()) {
      consider({});
      return best;
    }
    for (std::size_t f = 0; f < a.face_normals().size(); ++f) {
      consider({Axis::Of::face_of_a, f});
    }
    for (std::size_t f = 0; f < b.face_normals().size(); ++f) {
      consider({Axis::Of::face_of_b, f});
    }
    if (a.is_ball() || b.is_ball()) {
      const BodyTrack& polyhedron = a.is_ball() ? b : a;
      for (std::size_t v = 0; v < polyhedron.vertex_count(); ++v) {
        consider({Axis::Of::vertex, v});
      }
      for (std::size_t e = 0; e < polyhedron.edges().size(); ++e) {
        consider({Axis::Of::edge, e});
      }
      return best;
    }
    for (std::size_t e = 0; e < a.edge_directions().size(); ++e) {
      for (std::size_t f = 0; f < b.edge_directions().size(); ++f) {
        consider({Axis::Of::edges, e, f});
      }
    }
    return best;
  }

  /// A lower bound, from one look to the next, of the gap along a direction n. This direction turns from n₁ to n₂ at a
  /// constant rate Ω, so ‖n'‖ = Ω and ‖n''‖ = Ω². Primes are derivatives by time, in axes that do not turn. x is the
  /// position of a vertex of A relative to a vertex of B. r is the radius of a body, and ω its angular velocity. The
  /// gap is the least n·x, minus the margins. The size of (n·x)'' = n·x'' + 2 n'·x' + n''·x is at most the sum of these
  /// parts:
  ///
  /// - 2 r ‖ω‖² for each body: r ‖ω‖² for the centripetal acceleration, and r ‖ω'‖ with ‖ω'‖ ≤ ‖ω‖²
  /// - the relative acceleration of the centres
  /// - 2 Ω ‖x'‖ + Ω² ‖x‖
  ///
  /// Precondition: the time between the looks, times ‖ω‖ of each body at the first look, is at most largest_turn. So
  /// ‖ω‖ grows by a factor of at most 4/3.
  [[nodiscard]] Real least_gap(std::size_t i, std::size_t k, const Axis& axis, const Look& first, const Look& second,
                               const Wide& acceleration) const {
    const Wide n1 = direction(i, k, axis, first.a, first.b);
    const Wide n2 = direction(i, k, axis, second.a, second.b);
    const Real cosine = n1.dot(n2);
    if (!(cosine > 0.9L)) {
      return -std::numeric_limits<Real>::infinity();
    }
    const Real span = second.time - first.time;
    const Real turning = std::asin(std::min(Real(1), n1.cross(n2).norm())) / span;
    const Real rate_a = first.a.rate * 4 / 3;
    const Real rate_b = first.b.rate * 4 / 3;
    const Real radius_a = tracks_[i].radius();
    const Real radius_b = tracks_[k].radius();
    const Real centre_speed = (first.a.velocity - first.b.velocity).norm() + span * acceleration.norm();
    const Real speed = centre_speed + radius_a * rate_a + radius_b * rate_b;
    const Real arm = (first.a.centre - first.b.centre).norm() + span * centre_speed + radius_a + radius_b;
    const Real curvature = 2 * (radius_a * rate_a * rate_a + radius_b * rate_b * rate_b) + acceleration.norm() +
                           2 * turning * speed + turning * turning * arm;
    return std::min(gap_along(i, k, n1, first.a, first.b), gap_along(i, k, n2, second.a, second.b)) -
           curvature * span * span / 8;
  }

  void check_between(std::size_t i, std::size_t arc_i, std::size_t k, std::size_t arc_k, const Look& first,
                     const Look& second, int halvings) {
    const Real size = (first.a.centre - first.b.centre).norm() + tracks_[i].radius() + tracks_[k].radius() +
                      first.a.centre.norm() + first.b.centre.norm();
    const Real error = gap_error * size;
    for (const Look* one : {&first, &second}) {
      if (!(one->gap >= -error)) {
        report(i, kind_and_number(scene_, k), one->time, one->time,
               fmt::format("they overlap by {:.3g} m", static_cast<double>(-one->gap)));
        return;
      }
    }
    const Real span = second.time - first.time;
    Real lowest = -std::numeric_limits<Real>::infinity();
    if (span * std::max(first.a.rate, first.b.rate) <= largest_turn) {
      const Wide acceleration =
          wide(tracks_[i].arcs()[arc_i].path.acceleration) - wide(tracks_[k].arcs()[arc_k].path.acceleration);
      lowest = std::max(least_gap(i, k, first.axis, first, second, acceleration),
                        least_gap(i, k, second.axis, first, second, acceleration));
    }
    settle(lowest, std::min(tracks_[i].radius(), tracks_[k].radius()), halvings, [&] {
      const Look middle = look(i, arc_i, k, arc_k, first.time + span / 2);
      check_between(i, arc_i, k, arc_k, first, middle, halvings + 1);
      check_between(i, arc_i, k, arc_k, middle, second, halvings + 1);
    });
  }

  [[nodiscard]] bool goes_on() {
    found_.is_complete = found_.is_complete && !stops_();
    return found_.is_complete;
  }

  template <class Halve>
  void settle(Real lowest, Real radius, int halvings, const Halve& halve) {
    if (lowest >= 0 || !goes_on()) {
      return;
    }
    if (lowest >= -allowed_unseen * radius || halvings == most_halvings) {
      found_.unseen = std::max(found_.unseen, static_cast<double>(-lowest));
      return;
    }
    halve();
  }

  void check_pair(std::size_t i, std::size_t k) {
    const std::vector<Arc>& of_i = tracks_[i].arcs();
    const std::vector<Arc>& of_k = tracks_[k].arcs();
    std::size_t arc_i = 0;
    std::size_t arc_k = 0;
    for (double begin = history_.begin(); goes_on();) {
      const double end = std::min(end_of(i, arc_i), end_of(k, arc_k));
      if (begin < end && may_meet(of_i[arc_i].path, of_k[arc_k].path, begin, end)) {
        const Look first = look(i, arc_i, k, arc_k, begin);
        const Look second = look(i, arc_i, k, arc_k, end);
        check_between(i, arc_i, k, arc_k, first, second, 0);
      }
      begin = std::max(begin, end);
      if (arc_i + 1 < of_i.size() && of_i[arc_i + 1].path.start <= end) {
        ++arc_i;
      } else if (arc_k + 1 < of_k.size() && of_k[arc_k + 1].path.start <= end) {
        ++arc_k;
      } else {
        return;
      }
    }
  }

  /// Whether the bounding balls of two bodies may overlap between these times. A moves on a parabola relative to B.
  [[nodiscard]] static bool may_meet(const scene::Path& a, const scene::Path& b, double begin, double end) {
    const auto at = [](const scene::Path& path, double time) -> Wide {
      const Real s = static_cast<Real>(time) - path.start;
      return wide(path.position) + s * (wide(path.velocity) + s / 2 * wide(path.acceleration));
    };
    const Wide first = at(a, begin) - at(b, begin);
    const Wide way = (at(a, end) - at(b, end)) - first;
    const Real span = static_cast<Real>(end) - begin;
    const Real bulge = (wide(a.acceleration) - wide(b.acceleration)).norm() * span * span / 8;
    const Real share = way.isZero(0) ? Real(0) : std::clamp(-first.dot(way) / way.squaredNorm(), Real(0), Real(1));
    const Real radii = (static_cast<Real>(a.radius) + b.radius) * (1 + gap_error);
    // Negated, so that a NaN gives true.
    return !((first + share * way).norm() > radii + bulge + gap_error * (at(a, begin).norm() + at(b, begin).norm()));
  }

  [[nodiscard]] Real height(std::size_t body, const Ground& ground, const Pose& pose) const {
    Real low = std::numeric_limits<Real>::infinity();
    for (const Wide& vertex : pose.vertices) {
      low = std::min(low, ground.normal.dot(vertex));
    }
    return known(ground.normal.dot(pose.centre) + low - tracks_[body].margin() - ground.offset);
  }

  void check_plane(std::size_t body, std::size_t plane) {
    const Ground& ground = grounds_[plane];
    const std::vector<Arc>& arcs = tracks_[body].arcs();
    for (std::size_t arc = 0; arc < arcs.size() && goes_on(); ++arc) {
      const double begin = std::max(history_.begin(), arcs[arc].path.start);
      const double end = end_of(body, arc);
      if (begin < end) {
        const Pose first = tracks_[body].pose(arc, begin);
        const Pose second = tracks_[body].pose(arc, end);
        const Real lowest = std::min(ground.normal.dot(first.centre), ground.normal.dot(second.centre)) - ground.offset;
        const Real span = static_cast<Real>(end) - begin;
        // A parabola that bends away from the plane may be lowest between its ends.
        const Real bulge = std::max(Real(0), ground.normal.dot(wide(arcs[arc].path.acceleration))) * span * span / 8;
        if (!(lowest - bulge > tracks_[body].radius() * (1 + gap_error))) {
          check_plane_between(body, arc, plane, begin, first, end, second, 0);
        }
      }
    }
  }

  void check_plane_between(std::size_t body, std::size_t arc, std::size_t plane, Real begin, const Pose& first,
                           Real end, const Pose& second, int halvings) {
    ++found_.planes;
    const Ground& ground = grounds_[plane];
    const Real radius = tracks_[body].radius();
    const Real error = gap_error * (radius + first.centre.norm() + std::abs(ground.offset));
    const Real lower = std::min(height(body, ground, first), height(body, ground, second));
    if (!(lower >= -error)) {
      report(body, fmt::format("plane {}", plane), begin, end,
             fmt::format("it is {:.3g} m behind it", static_cast<double>(-lower)));
      return;
    }
    const Real span = end - begin;
    Real lowest = -std::numeric_limits<Real>::infinity();
    if (span * first.rate <= largest_turn) {
      const Real rate = first.rate * 4 / 3;
      const Real against = std::abs(ground.normal.dot(wide(tracks_[body].arcs()[arc].path.acceleration)));
      lowest = lower - (2 * radius * rate * rate + against) * span * span / 8;
    }
    settle(lowest, radius, halvings, [&] {
      const Real middle = begin + span / 2;
      const Pose between = tracks_[body].pose(arc, middle);
      check_plane_between(body, arc, plane, begin, first, middle, between, halvings + 1);
      check_plane_between(body, arc, plane, middle, between, end, second, halvings + 1);
    });
  }

  static constexpr std::size_t most_shown = 100;

  const scene::Scene& scene_;
  const History& history_;
  const Stops& stops_;
  std::vector<BodyTrack> tracks_;
  std::vector<Ground> grounds_;
  Validity found_;
};

}  // namespace

Validity check_polyhedra(const scene::Scene& scene, const History& history, const Stops& stops) {
  CAROM_EXPECTS(!scene.polyhedra.empty());
  return PolyhedraChecker(scene, history, stops).check();
}

}  // namespace carom::properties
