// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <cstddef>
#include <vector>

#include <Eigen/Geometry>

#include <carom/collision/expects.hpp>
#include <carom/collision/vector.hpp>
#include <carom/scene/event.hpp>

namespace carom::properties {

/// A vector in long double. Its unit roundoff is 2⁻¹¹ of that of double, in which scenes are stored.
using WideVector = Vector3<long double>;

[[nodiscard]] inline WideVector wide(const Vector3<double>& v) { return v.cast<long double>(); }

/// The rotation from body axes to world axes. Precondition: the quaternion is not zero.
template <class S>
[[nodiscard]] Matrix3<long double> wide_rotation(const Quaternion<S>& q) {
  CAROM_EXPECTS(!q.isZero(0), q);
  return Eigen::Quaternion<long double>(q[0], q[1], q[2], q[3]).normalized().toRotationMatrix();
}

/// The motion of each body over a span of time. A checker knows nothing else of a run.
class History {
 public:
  explicit History(const scene::SceneState& state)
      : begin_(state.time), end_(state.time), first_polyhedron_(state.scene->spheres.size()) {
    for (const scene::BodyState& body : state.bodies) {
      arcs_.push_back({body.arc});
      orientations_.emplace_back();
      if (arcs_.size() > first_polyhedron_) {
        orientations_.back().push_back(body.orientation_at_start);
      }
    }
  }

  void record(const scene::Event& event) {
    end_ = event.time;
    record(event.a);
    if (event.b) {
      record(*event.b);
    }
  }

  /// Ends the history at this time [s], after the last event.
  void end_at(double time) { end_ = time; }

  [[nodiscard]] double begin() const { return begin_; }
  [[nodiscard]] double end() const { return end_; }
  /// The arcs of each body, in order of time. An arc lasts from its start to the start of the next arc, or to `end`.
  /// The first arc applies from `begin`.
  [[nodiscard]] const std::vector<std::vector<scene::Arc>>& arcs() const { return arcs_; }
  /// The orientation of each polyhedron at the start of each arc, from body axes to world axes. Empty for spheres.
  [[nodiscard]] const std::vector<std::vector<Quaternion<double>>>& orientations() const { return orientations_; }

 private:
  void record(const scene::Change& change) {
    arcs_[change.body].push_back(change.after);
    if (change.body >= first_polyhedron_) {
      orientations_[change.body].push_back(change.orientation);
    }
  }

  double begin_, end_;
  std::size_t first_polyhedron_;
  std::vector<std::vector<scene::Arc>> arcs_;
  std::vector<std::vector<Quaternion<double>>> orientations_;
};

}  // namespace carom::properties
