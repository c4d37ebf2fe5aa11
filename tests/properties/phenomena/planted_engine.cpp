// SPDX-License-Identifier: BSL-1.0
#include "planted_engine.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <tuple>
#include <utility>
#include <vector>

#include <Eigen/Geometry>

namespace carom::phenomena_tests {
namespace {

using V = Vector3<double>;
using Key = std::tuple<std::ptrdiff_t, std::ptrdiff_t, unsigned>;  // the bodies, and the corner of a box

constexpr double touching = 1e-7;  // [m]: the gap that rounding may open between bodies at rest

Eigen::Quaterniond turn_of(const Quaternion<double>& q) { return {q[0], q[1], q[2], q[3]}; }

Matrix3<double> axes(const SteppedBody& body) {
  return turn_of(body.state.orientation).normalized().toRotationMatrix();
}

V over_inertia(const SteppedBody& body, const V& x) {
  const Matrix3<double> to_world = axes(body);
  return to_world * (to_world.transpose() * x).cwiseQuotient(body.principal_inertia);
}

struct Contact {
  Key key;
  SteppedBody* a;  // the normal points from b to a
  SteppedBody* b;
  V point;
  V normal;
  double target = 0;  // the least normal velocity after the impulse
  bool turns = true;
  V impulse{0, 0, 0};

  [[nodiscard]] V arm(const SteppedBody* body) const { return point - body->state.position; }
  [[nodiscard]] V velocity() const {
    return a->state.velocity + a->state.angular_velocity.cross(arm(a)) - b->state.velocity -
           b->state.angular_velocity.cross(arm(b));
  }
  /// The velocity along n that a unit impulse along n gives.
  [[nodiscard]] double mobility(const V& n) const {
    const V of_a = arm(a).cross(n);
    const V of_b = arm(b).cross(n);
    return 1 / a->mass + 1 / b->mass + of_a.dot(over_inertia(*a, of_a)) + of_b.dot(over_inertia(*b, of_b));
  }
  void push(const V& more) {
    impulse += more;
    a->state.velocity += more / a->mass;
    b->state.velocity -= more / b->mass;
    if (turns) {
      a->state.angular_velocity += over_inertia(*a, arm(a).cross(more));
      b->state.angular_velocity -= over_inertia(*b, arm(b).cross(more));
    }
  }
};

struct World {
  SteppedScene scene;  // a fixed body has an infinite mass
  Defect defect;
  std::map<Key, V>& guesses;
  std::vector<Contact> last = {};

  [[nodiscard]] bool is(Defect one) const { return defect == one; }

  void step(double h) {
    std::vector<Contact> contacts = found(h);
    if (is(Defect::contacts_a_step_late)) {
      std::swap(contacts, last);
    }
    for (SteppedBody& body : scene.bodies) {
      body.state.velocity += body.is_fixed ? V(0, 0, 0) : V(h * scene.gravity);
    }
    solve(contacts);
    for (SteppedBody& body : scene.bodies) {
      if (!body.is_fixed) {
        advance(body, h);
      }
    }
  }

  /// The contacts, in an order that does not depend on the order of the bodies.
  std::vector<Contact> found(double h) {
    const auto rank = [&](const SteppedBody* body) {
      const V at = is(Defect::insertion_order) ? V(0, 0, 0) : body->state.position;
      return std::tuple(body->shape.index(), at[0], at[1], at[2]);
    };
    std::vector<SteppedBody*> order;
    for (SteppedBody& body : scene.bodies) {
      order.push_back(&body);
    }
    std::stable_sort(order.begin(), order.end(),
                     [&](const SteppedBody* x, const SteppedBody* y) { return rank(x) < rank(y); });
    std::vector<Contact> all;
    for (auto a = order.begin(); a != order.end(); ++a) {
      std::for_each(a + 1, order.end(), [&](SteppedBody* b) { find(**a, *b, h, all); });
    }
    return all;
  }

  /// The contacts of a sphere with another sphere, a box or a half-space, or of a box with a half-space.
  void find(SteppedBody& one, SteppedBody& other, double h, std::vector<Contact>& all) const {
    const double speed = (one.state.velocity - other.state.velocity).norm();
    const V between = one.state.position - other.state.position;
    const auto add = [&](const V& arm, const V& normal, double gap, unsigned corner = 0) {
      if (gap < (is(Defect::speculative_contacts) ? h * speed : touching)) {
        const Key key{&one - scene.bodies.data(), &other - scene.bodies.data(), corner};
        all.push_back({key, &one, &other, one.state.position + arm, normal});
        aim(all.back(), gap, h);
      }
    };
    const auto* const ground = std::get_if<HalfSpaceShape>(&other.shape);
    if (const auto* const sphere = std::get_if<SphereShape>(&one.shape)) {
      V out = ground != nullptr ? ground->normal : between;  // from the nearest point
      double distance = ground != nullptr ? out.dot(between) : between.norm();
      if (const auto* const box = std::get_if<BoxShape>(&other.shape)) {
        const V half = box->lengths / 2;
        out -= axes(other) * (axes(other).transpose() * between).cwiseMin(half).cwiseMax(-half);
        distance = out.norm();
      } else if (const auto* const ball = std::get_if<SphereShape>(&other.shape)) {
        distance -= ball->radius;
      }
      add(-sphere->radius * out.normalized(), out.normalized(), distance - sphere->radius);
    } else if (ground != nullptr) {
      const std::size_t first = all.size();
      for (unsigned k = 0; k < 8 && !(is(Defect::one_contact_point) && all.size() > first); ++k) {
        const V signs{k & 1U ? 0.5 : -0.5, k & 2U ? 0.5 : -0.5, k & 4U ? 0.5 : -0.5};
        const V corner = axes(one) * std::get<BoxShape>(one.shape).lengths.cwiseProduct(signs);
        add(corner, ground->normal, ground->normal.dot(between + corner), k);
      }
    }
  }

  void aim(Contact& contact, double gap, double h) const {
    const bool has_gravity = is(Defect::restitution_after_gravity) && contact.b->is_fixed;
    const double approach = contact.normal.dot(contact.velocity() + (has_gravity ? h : 0) * scene.gravity);
    const bool bounces = approach < (is(Defect::restitution_threshold) ? -0.5 : 0) && scene.restitution > 0;
    contact.turns = !bounces || !is(Defect::bounce_without_spin);
    contact.target = gap > touching ? -gap / h : bounces ? -scene.restitution * approach : 0;
    if (is(Defect::pushed_out_with_velocity) && gap < 0) {
      contact.target -= 0.2 * gap / h;
    }
  }

  void solve(std::vector<Contact>& contacts) const {
    for (Contact& contact : contacts) {
      contact.push(guesses.try_emplace(contact.key, 0, 0, 0).first->second);
    }
    double change = 1;
    const std::size_t rounds = 50 + 20000 / (contacts.size() + 1);
    for (std::size_t round = 0; round < rounds && change > 1e-9; ++round) {
      change = 0;
      for (Contact& contact : contacts) {
        change = std::max(change, settle(contact));
      }
    }
    for (const Contact& contact : contacts) {
      guesses[contact.key] = contact.impulse;
    }
  }

  /// Pushes the bodies apart, and rubs them. Returns the greatest change of velocity.
  double settle(Contact& contact) const {
    const V& n = contact.normal;
    const double lacking = contact.target - n.dot(contact.velocity());
    const double push = std::max(-n.dot(contact.impulse), lacking / contact.mobility(n));
    const double change = std::abs(push) * contact.mobility(n);
    contact.push(push * n);
    V slip = contact.velocity() - n * n.dot(contact.velocity());
    if (is(Defect::friction_of_one_axis)) {
      slip = {slip[0], 0, 0};
    }
    if (scene.friction == 0 || slip.norm() < 1e-300) {
      return change;
    }
    const double mobility = contact.mobility(slip.normalized());
    const bool is_force = is(Defect::friction_an_impulse_a_step);
    const double most = scene.friction * (is_force ? scene.gravity.norm() * contact.a->mass : n.dot(contact.impulse));
    const V before = contact.impulse - n * n.dot(contact.impulse);
    V after = before - slip / mobility;
    if (!is(Defect::friction_beyond_the_cone) && after.norm() > most) {
      after *= most / after.norm();
    }
    contact.push(after - before);
    return std::max(change, (after - before).norm() * mobility);
  }

  void advance(SteppedBody& body, double h) const {
    BodyState& state = body.state;
    V& w = state.angular_velocity;
    const double kept = is(Defect::damping) ? 1 - 0.1 * h : 1;
    state.velocity *= kept;
    w *= kept;
    const V momentum = axes(body) * body.principal_inertia.cwiseProduct(axes(body).transpose() * w);
    if (is(Defect::explicit_gyroscopic_term)) {
      w -= h * over_inertia(body, w.cross(momentum));
    }
    state.position += h * state.velocity;
    const Eigen::AngleAxisd turn(w.norm() * h, w.norm() > 0 ? V(w.normalized()) : V(1, 0, 0));
    const Eigen::Quaterniond turned = (turn * turn_of(state.orientation)).normalized();
    state.orientation = {turned.w(), turned.x(), turned.y(), turned.z()};
    if (!is(Defect::no_gyroscopic_term) && !is(Defect::explicit_gyroscopic_term)) {
      w = over_inertia(body, momentum);
    }
    if (is(Defect::binary32_state)) {
      state = {state.position.cast<float>().cast<double>(), state.orientation.cast<float>().cast<double>(),
               state.velocity.cast<float>().cast<double>(), w.cast<float>().cast<double>()};
    }
  }
};

}  // namespace

Stepper planted_engine(Defect defect) {
  Stepper stepper{"planted"};
  stepper.cannot = {"continuous"};
  stepper.open = [defect] {
    return [defect, guesses = std::map<Key, V>()](const Stepping& stepping) mutable -> SteppingAnswer {
      if (defect != Defect::surviving_warm_starts) {
        guesses.clear();
      }
      World world{stepping.scene, defect, guesses};
      for (SteppedBody& body : world.scene.bodies) {
        if (body.is_fixed) {
          body.mass = std::numeric_limits<double>::infinity();
          body.principal_inertia.setConstant(body.mass);
        }
      }
      SteppedStates answer;
      for (std::uint64_t k = 1; k <= steps_of(stepping); ++k) {
        world.step(stepping.step);
        if (std::binary_search(stepping.report.begin(), stepping.report.end(), k)) {
          std::vector<BodyState>& states = answer.states.emplace_back();
          for (const SteppedBody& body : world.scene.bodies) {
            states.push_back(body.state);
          }
        }
      }
      return answer;
    };
  };
  return stepper;
}

}  // namespace carom::phenomena_tests
