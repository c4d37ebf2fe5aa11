// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include <carom/collision/vector.hpp>
#include <carom/properties/scenes/history.hpp>
#include <carom/scene/arc.hpp>
#include <carom/scene/polyhedra/rigid_body.hpp>

namespace carom::properties {

/// A body's position and motion at one time, in world axes.
struct Pose {
  WideVector centre;
  WideVector velocity;
  Matrix3<long double> axes;
  WideVector angular_velocity;       // [rad/s]
  long double rate = 0;              // angular speed of the vertices, ‖ω‖; 0 for a ball [rad/s]
  std::vector<WideVector> vertices;  // relative to the centre
};

/// A body's shape and its whole motion. The rotation does not come from the simulation. E. Fehlberg's Runge–Kutta
/// method of order 8 integrates the rotation in long double from each arc's start. Steps of 1/20 rad have errors below
/// 10⁻¹⁶ each. Arcs and orientations must outlive the track.
class BodyTrack {
 public:
  BodyTrack(const scene::RigidBody& body, bool is_ball, const std::vector<scene::Arc>& arcs,
            const std::vector<Quaternion<double>>& orientations);

  [[nodiscard]] bool is_ball() const { return is_ball_; }
  [[nodiscard]] long double margin() const { return margin_; }  // a ball's radius; 0 for a polyhedron [m]
  /// An upper bound of the distance of the body's points from its centre [m].
  [[nodiscard]] long double radius() const { return radius_; }
  [[nodiscard]] const std::vector<scene::Arc>& arcs() const { return *arcs_; }
  [[nodiscard]] const Quaternion<double>& orientation(std::size_t arc) const { return (*orientations_)[arc]; }
  // In body axes. Of parallel directions, only the first is listed.
  [[nodiscard]] const std::vector<WideVector>& face_normals() const { return face_normals_; }
  [[nodiscard]] const std::vector<WideVector>& edge_directions() const { return edge_directions_; }
  [[nodiscard]] const std::vector<std::array<std::size_t, 2>>& edges() const { return edges_; }
  [[nodiscard]] std::size_t vertex_count() const { return vertices_.size(); }

  /// The pose at a time [s] on the arc of this index. Precondition: the time is not before the arc's start.
  [[nodiscard]] Pose pose(std::size_t arc, long double time);

 private:
  /// The orientation (w, x, y, z), then the angular velocity in body axes.
  using TurningState = std::array<long double, 7>;

  [[nodiscard]] TurningState beginning(std::size_t arc) const;
  [[nodiscard]] TurningState stepped(TurningState state, long double step) const;
  [[nodiscard]] TurningState turned(std::size_t arc, long double elapsed);

  std::vector<WideVector> vertices_, face_normals_, edge_directions_;
  std::vector<std::array<std::size_t, 2>> edges_;
  WideVector inertia_;
  long double margin_, radius_;
  bool is_ball_;
  const std::vector<scene::Arc>* arcs_;
  const std::vector<Quaternion<double>>* orientations_;
  std::size_t known_arc_ = 0;
  std::vector<TurningState> known_;  // states at the ends of steps, from the arc's start
};

}  // namespace carom::properties
