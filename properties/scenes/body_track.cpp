// SPDX-License-Identifier: BSL-1.0
#include <algorithm>
#include <limits>

#include <boost/numeric/odeint/stepper/runge_kutta_fehlberg78.hpp>

#include <carom/properties/scenes/body_track.hpp>

namespace carom::properties {
namespace {

using Real = long double;
using Wide = WideVector;

constexpr Real step_angle = 0.05L;  // [rad]

Quaternion<Real> orientation_in(const std::array<Real, 7>& state) { return {state[0], state[1], state[2], state[3]}; }

Wide rate_in(const std::array<Real, 7>& state) { return {state[4], state[5], state[6]}; }

}  // namespace

BodyTrack::BodyTrack(const scene::RigidBody& body, bool is_ball, const std::vector<scene::Arc>& arcs,
                     const std::vector<Quaternion<double>>& orientations)
    : inertia_(wide(body.principal_inertia)),
      margin_(body.shape.margin),
      radius_(body.radius()),
      is_ball_(is_ball),
      arcs_(&arcs),
      orientations_(&orientations) {
  const scene::ConvexPolyhedron& core = body.shape.core;
  for (const Vector3<double>& vertex : core.vertices) {
    vertices_.push_back(wide(vertex));
  }
  const auto add_if_new = [](std::vector<Wide>& list, const Wide& direction) {
    const auto is_same = [&](const Wide& other) { return other.cross(direction).norm() < 0x1p-40L; };
    if (std::none_of(list.begin(), list.end(), is_same)) {
      list.push_back(direction);
    }
  };
  for (const std::array<std::size_t, 2>& edge : core.edges) {
    edges_.push_back(edge);
    add_if_new(edge_directions_, (vertices_[edge[1]] - vertices_[edge[0]]).normalized());
  }
  for (const std::vector<std::size_t>& face : core.faces) {
    // Newell's normal uses all corners.
    Wide normal = Wide::Zero();
    for (std::size_t k = 0; k < face.size(); ++k) {
      normal += vertices_[face[k]].cross(vertices_[face[(k + 1) % face.size()]]);
    }
    add_if_new(face_normals_, normal.normalized());
  }
}

Pose BodyTrack::pose(std::size_t arc, Real time) {
  const scene::Path& path = (*arcs_)[arc].path;
  const Real s = time - path.start;
  Pose pose;
  pose.centre = wide(path.position) + s * (wide(path.velocity) + s / 2 * wide(path.acceleration));
  pose.velocity = wide(path.velocity) + s * wide(path.acceleration);
  if (is_ball_) {
    pose.axes.setIdentity();
    pose.angular_velocity = wide((*arcs_)[arc].turning.angular_velocity);
    pose.rate = 0;
    pose.vertices = {Wide::Zero()};
    return pose;
  }
  const TurningState state = turned(arc, s);
  pose.axes = wide_rotation(orientation_in(state));
  pose.angular_velocity = pose.axes * rate_in(state);
  pose.rate = rate_in(state).norm();
  for (const Wide& vertex : vertices_) {
    pose.vertices.push_back(pose.axes * vertex);
  }
  return pose;
}

BodyTrack::TurningState BodyTrack::beginning(std::size_t arc) const {
  const Quaternion<double>& q = (*orientations_)[arc];
  TurningState state{q[0], q[1], q[2], q[3], 0, 0, 0};
  const Wide rate = wide_rotation(orientation_in(state)).transpose() * wide((*arcs_)[arc].turning.angular_velocity);
  state[4] = rate[0];
  state[5] = rate[1];
  state[6] = rate[2];
  return state;
}

/// Integrates Euler's equations and q' = ½ q ω over one step.
BodyTrack::TurningState BodyTrack::stepped(TurningState state, Real step) const {
  if (step == 0) {
    return state;
  }
  const auto equations = [this](const TurningState& x, TurningState& change, Real) {
    const Real w = x[0];
    const Wide v(x[1], x[2], x[3]);
    const Wide rate = rate_in(x);
    const Wide turning = (w * rate + v.cross(rate)) / 2;
    const Wide spin = inertia_.cwiseProduct(rate).cross(rate).cwiseQuotient(inertia_);
    change = {-v.dot(rate) / 2, turning[0], turning[1], turning[2], spin[0], spin[1], spin[2]};
  };
  boost::numeric::odeint::runge_kutta_fehlberg78<TurningState, Real> method;
  method.do_step(equations, state, Real(0), step);
  return state;
}

BodyTrack::TurningState BodyTrack::turned(std::size_t arc, Real elapsed) {
  if (arc != known_arc_ || known_.empty()) {
    known_arc_ = arc;
    known_ = {beginning(arc)};
  }
  const Real rate = rate_in(known_[0]).norm();
  if (rate == 0) {
    return known_[0];
  }
  const Real step = step_angle / rate;
  // The simulation renews arcs every few radians. A much longer rotation, or a NaN, has no known state.
  constexpr Real most_steps = 0x1p20;
  if (!(elapsed <= most_steps * step)) {
    TurningState unknown;
    unknown.fill(std::numeric_limits<Real>::quiet_NaN());
    return unknown;
  }
  const auto whole = static_cast<std::size_t>(elapsed / step);
  while (known_.size() <= whole) {
    known_.push_back(stepped(known_.back(), step));
  }
  return stepped(known_[whole], elapsed - static_cast<Real>(whole) * step);
}

}  // namespace carom::properties
