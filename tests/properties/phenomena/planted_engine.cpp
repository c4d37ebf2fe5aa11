// SPDX-License-Identifier: BSL-1.0
#include "planted_engine.hpp"

#include <algorithm>
#include <iterator>
#include <map>
#include <tuple>
#include <utility>
#include <vector>

#include <Eigen/Geometry>

#include <carom/impulse/collision_matrix.hpp>
#include <carom/impulse/world_inertia.hpp>

namespace carom::phenomena_tests {
namespace {

using V = Vector3<double>;
constexpr double touching = 1e-7;                // [m]: the gap that rounding may open between bodies at rest
enum : std::size_t { sphere, box, half_space };  // the indices of shapes. A sphere is a point with a margin.
double margin_of(const Shape& shape) { return shape.index() == sphere ? std::get<sphere>(shape).radius : 0; }
V half_of(const Shape& shape) { return shape.index() == box ? V(std::get<box>(shape).lengths / 2) : V(0, 0, 0); }

/// The normal of a body towards a point with a margin, and the gap between them.
std::pair<V, double> way_to(const V& point, double margin, const SteppedBody& body) {
  V out = point - body.state.position;
  const Matrix3<double> axes = impulse::rotation_matrix(body.state.orientation);
  out -= axes * (axes.transpose() * out).cwiseMin(half_of(body.shape)).cwiseMax(-half_of(body.shape));
  const V normal = body.shape.index() == half_space ? std::get<half_space>(body.shape).normal : V(out.normalized());
  return {normal, normal.dot(out) - margin_of(body.shape) - margin};
}

struct Touch {
  BodyState *a, *b;                  // the normal points from b to a
  impulse::Contact<double> contact;  // at the beginning of the step
  double target;                     // the least normal velocity after the impulse
  V* impulse;                        // on a, in this step
  void push(const V& more) const {
    *impulse += more;
    a->velocity += contact.a.inverse_mass * more;
    b->velocity -= contact.b.inverse_mass * more;
    a->angular_velocity += impulse::angular_response(contact.a.inertia, contact.a.lever_arm, more);
    b->angular_velocity -= impulse::angular_response(contact.b.inertia, contact.b.lever_arm, more);
  }

  /// Pushes the bodies apart, and rubs them. Returns the change of their relative velocity.
  [[nodiscard]] double settle(const SteppedScene& scene, const Defects& with) const {
    const V& n = contact.normal;
    const V velocity = a->velocity + a->angular_velocity.cross(contact.a.lever_arm) - b->velocity -
                       b->angular_velocity.cross(contact.b.lever_arm);
    const double mobility =
        impulse::collision_matrix(contact).trace() / 2;  // over half of each eigenvalue, to converge
    const V wanted = *impulse + (target * n - velocity) / mobility;
    const double pressure = std::max(0.0, n.dot(wanted));
    const V rubbing = (wanted - n * n.dot(wanted)).cwiseProduct(with.friction_axes);
    const double force = with.friction_an_impulse_a_step ? scene.gravity.norm() / contact.a.inverse_mass : pressure;
    const double share = with.friction_beyond_the_cone ? 1 : std::min(1.0, scene.friction * force / rubbing.norm());
    const V more = pressure * n + share * rubbing - *impulse;
    push(more);
    return more.norm() * mobility;
  }
};

struct Engine {
  Defects with;
  SteppedScene scene = {};
  double h = 0;                                                                     // the step [s]
  std::map<std::tuple<std::ptrdiff_t, std::ptrdiff_t, unsigned>, V> impulses = {};  // of two bodies at a corner
  std::vector<Touch> last = {};
  SteppingAnswer operator()(const Stepping& stepping) {
    *this = {with, stepping.scene, stepping.step, with.surviving_warm_starts ? impulses : decltype(impulses)()};
    SteppedStates answer;
    for (std::uint64_t done = 0; const std::uint64_t steps : stepping.report) {
      for (; done < steps; ++done) {
        const std::vector<Touch> touches = with.contacts_a_step_late ? std::exchange(last, found()) : found();
        std::ranges::for_each(scene.bodies, [&](auto& x) { x.state.velocity += (x.is_fixed ? 0 : h) * scene.gravity; });
        std::ranges::for_each(touches, [](const Touch& x) { x.push(std::exchange(*x.impulse, V(0, 0, 0))); });
        const auto is_pushed = [&](const Touch& x) { return x.settle(scene, with) > 1e-13; };  // rounding of 1 km/s
        for (int left = 500; left > 0 && std::ranges::count_if(touches, is_pushed) > 0; --left) {
        }
        std::ranges::for_each(scene.bodies, [&](SteppedBody& x) { advance(x); });
      }
      std::ranges::transform(scene.bodies, std::back_inserter(answer.states.emplace_back()), &SteppedBody::state);
    }
    return answer;
  }

  /// The contacts, in an order that does not depend on the order of the bodies.
  std::vector<Touch> found() {
    std::multimap<std::tuple<std::size_t, double, double, double>, SteppedBody*> order;
    for (SteppedBody& body : scene.bodies) {
      const V at = with.insertion_order ? V(0, 0, 0) : body.state.position;
      order.emplace(std::tuple(body.shape.index(), at[0], at[1], at[2]), &body);
    }
    std::vector<Touch> touches;
    for (auto a = order.begin(); a != order.end(); ++a) {
      std::for_each(std::next(a), order.end(), [&](const auto& b) { find(*a->second, *b.second, touches); });
    }
    return touches;
  }

  void find(SteppedBody& a, SteppedBody& b, std::vector<Touch>& touches) {
    const unsigned points = a.shape.index() == sphere ? 1 : a.shape.index() == b.shape.index() ? 0 : with.corners;
    for (unsigned k = 0; k < points; ++k) {
      const V corner = half_of(a.shape).cwiseProduct(V(k & 1U ? 1 : -1, k & 2U ? 1 : -1, k & 4U ? 1 : -1));
      const V point = a.state.position + impulse::rotation_matrix(a.state.orientation) * corner;
      const auto [normal, gap] = way_to(point, margin_of(a.shape), b);
      if (gap < touching + with.speculation && !normal.isZero()) {
        const V surface = point - margin_of(a.shape) * normal;
        const auto at = [&](const SteppedBody& body) {
          const auto& [x, q, v, w] = body.state;
          const V moments = body.principal_inertia / with.torque;
          return impulse::make_contact_body<double>(Body{body.is_fixed, body.mass, moments, q, x, v, w}, surface);
        };
        const impulse::Contact<double> contact{at(a), at(b), normal, 0, 0, 0};
        const double gained = with.restitution_after_gravity && b.is_fixed ? h * scene.gravity.dot(normal) : 0;
        const double approach = -impulse::normal_velocity(contact) - gained;
        const double rebound = approach > with.restitution_threshold ? scene.restitution * approach : 0;
        const double target = gap > touching ? -gap / h : rebound - with.push_out * std::min(gap, 0.0) / h;
        V& impulse = impulses.try_emplace({&a - &scene.bodies[0], &b - &scene.bodies[0], k}, 0, 0, 0).first->second;
        touches.push_back({&a.state, &b.state, contact, target, &impulse});
      }
    }
  }

  void advance(SteppedBody& body) const {
    auto& [x, q, v, w] = body.state;
    v *= 1 - with.damping * h;
    w *= 1 - with.damping * h;
    x += h * v;
    const Matrix3<double> axes = impulse::rotation_matrix(q);
    const V momentum = axes * body.principal_inertia.cwiseProduct(axes.transpose() * w);
    const Eigen::Quaterniond turned(Eigen::AngleAxisd(w.norm() * h, w.normalized()) * axes);
    q = {turned.w(), turned.x(), turned.y(), turned.z()};
    const Matrix3<double> inverse = impulse::world_inverse_inertia(body.principal_inertia, q);
    const V explicitly = w - h * inverse * w.cross(momentum);
    w = with.no_gyroscopic_term ? w : with.explicit_gyroscopic_term ? explicitly : V(inverse * momentum);
    const auto rounded = [](const auto& z) { return z.template cast<float>().template cast<double>().eval(); };
    body.state = with.binary32_state ? BodyState{rounded(x), rounded(q), rounded(v), rounded(w)} : body.state;
  }
};

}  // namespace

Stepper planted_engine(const Defects& defects) {
  return {.name = "planted", .cannot = {"continuous"}, .open = [defects] { return Engine{defects}; }};
}

}  // namespace carom::phenomena_tests
