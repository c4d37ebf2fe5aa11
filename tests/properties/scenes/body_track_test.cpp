// SPDX-License-Identifier: BSL-1.0
#include <cmath>
#include <numbers>
#include <variant>
#include <vector>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include <carom/properties/scenes/body_track.hpp>
#include <carom/scene/polyhedra/free_rotation.hpp>

#include "properties/scenes/runs.hpp"

namespace carom::properties::tracks {
namespace {

using Real = long double;

/// A rotating body on a parabola, from t = 3 s on.
struct Turning {
  explicit Turning(const Vector3<double>& edges, const Vector3<double>& angular_velocity,
                   const Quaternion<double>& orientation = {1, 0, 0, 0}) {
    scene::Polyhedron polyhedron;
    polyhedron.vertices = unit::centred_box(edges);
    polyhedron.orientation = orientation;
    body = std::get<scene::RigidBody>(rigid_body(polyhedron));
    scene::Arc arc;
    arc.path.start = 3;
    arc.path.position = {1, 2, 3};
    arc.path.velocity = {0.5, -0.25, 8};
    arc.path.acceleration = {0, 0, -2};
    arc.turning.angular_velocity = angular_velocity;
    arcs = {arc};
    orientations = {body.orientation};
  }

  [[nodiscard]] BodyTrack track() const { return {body, false, arcs, orientations}; }

  scene::RigidBody body;
  std::vector<scene::Arc> arcs;
  std::vector<Quaternion<double>> orientations;
};

const std::vector<std::pair<Vector3<double>, Vector3<double>>> bodies{
    {{1, 1, 1}, {3, 0, 4}},
    {{1, 2, 3}, {3, 0.001, 4}},
    // This body rotates about its intermediate axis, so it flips over again and again.
    {{1, 2, 3}, {0.001, 5, 0}},
    {{0.01, 0.02, 1}, {3, 2, 3}},
};

TEST(BodyTrack, TurnsAsTheRotationPathOfTheSimulation) {
  for (const auto& [edges, rate] : bodies) {
    SCOPED_TRACE(testing::PrintToString(edges.transpose()));
    const Turning turning(edges, rate, {0.5, -1, 0.25, 2});
    BodyTrack track = turning.track();
    const double duration = 100 / rate.norm();
    const scene::RotationPath path(turning.body.principal_inertia,
                                   scene::rotation_state(turning.body.orientation, rate), duration);
    for (const double share : {0.0, 1e-6, 0.01, 0.3, 0.29, 0.77, 1.0}) {
      const double elapsed = share * duration;
      const scene::BoundedRotation expected = path.at(elapsed);
      const Pose pose = track.pose(0, Real(3) + elapsed);
      const Real apart = (pose.axes - wide_rotation(Quaternion<Real>(expected.state.orientation.cast<Real>()))).norm() /
                         std::sqrt(2.0L);
      // The limit is the error bound of the path plus that of the track. The track takes 2000 steps through 100 rad,
      // and each step has an error of 10⁻¹⁶ rad. If φ is the rotation after a step, its error grows by the factor 1 +
      // φ. On average, φ is 50 rad.
      EXPECT_LE(apart, expected.angle_error + 2000 * 1e-16L * (1 + 50)) << share;
      EXPECT_LE(apart, 1e-11L) << share;  // errors of different steps partly cancel
      EXPECT_NEAR(static_cast<double>(pose.rate), expected.state.body_rate.norm(), 1e-11) << share;
    }
  }
}

TEST(BodyTrack, GivesTheSamePosesInAnyOrderOfTimes) {
  const Turning turning({1, 2, 3}, {3, 0.5, 4});
  BodyTrack forward = turning.track();
  BodyTrack backward = turning.track();
  std::vector<Matrix3<Real>> axes;
  for (int k = 0; k <= 10; ++k) {
    axes.push_back(forward.pose(0, 3 + 0.5L * k).axes);
  }
  for (int k = 10; k >= 0; --k) {
    const Pose pose = backward.pose(0, 3 + 0.5L * k);
    EXPECT_EQ(pose.axes, axes[static_cast<std::size_t>(k)]);
    const Real s = 0.5L * k;
    EXPECT_LE((pose.centre - WideVector(1 + s / 2, 2 - s / 4, 3 + 8 * s - s * s)).norm(), 1e-17L);
    EXPECT_LE((pose.velocity - WideVector(0.5L, -0.25L, 8 - 2 * s)).norm(), 1e-17L);
    ASSERT_EQ(pose.vertices.size(), 8U);
    EXPECT_NEAR(static_cast<double>(pose.vertices[0].norm()), std::sqrt(3.5), 1e-15);
  }
}

/// A body without angular velocity keeps its axes. A ball's track keeps its axes at any angular velocity.
TEST(BodyTrack, KeepsTheAxesOfABodyAtRestAndOfABall) {
  const Quaternion<double> orientation(std::sqrt(0.5), 0, 0, std::sqrt(0.5));
  Turning turning({1, 1, 1}, {0, 0, 0}, orientation);
  BodyTrack track = turning.track();
  EXPECT_EQ(track.pose(0, 1e9L).axes, track.pose(0, 3).axes);
  EXPECT_EQ(track.pose(0, 4).rate, 0);
  EXPECT_EQ(track.face_normals().size(), 3U);
  EXPECT_EQ(track.edge_directions().size(), 3U);
  EXPECT_EQ(track.edges().size(), 12U);
  scene::Sphere sphere;
  sphere.radius = 0.5;
  const scene::RigidBody ball = scene::rigid_body(sphere);
  turning.arcs[0].turning.angular_velocity = {1, 2, 3};
  BodyTrack of_ball(ball, true, turning.arcs, turning.orientations);
  EXPECT_EQ(of_ball.margin(), 0.5L);
  EXPECT_EQ(of_ball.radius(), 0.5L);
  EXPECT_EQ(of_ball.pose(0, 5).vertices.size(), 1U);
  EXPECT_EQ(of_ball.pose(0, 5).rate, 0);
}

}  // namespace
}  // namespace carom::properties::tracks
