// SPDX-License-Identifier: BSL-1.0
#include "planted_engine.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <memory>
#include <tuple>
#include <utility>

#include <Eigen/Geometry>

namespace carom::phenomena_tests {
namespace {

using V = Vector3<double>;
using M = Matrix3<double>;

constexpr double touching = 1e-7;  // [m]: the gap that rounding may open between bodies at rest

Eigen::Quaterniond turn_of(const Quaternion<double>& q) { return {q[0], q[1], q[2], q[3]}; }

struct Body {
  SteppedBody posed;
  double inverse_mass = posed.is_fixed ? 0 : 1 / posed.mass;
  V inverse_inertia = posed.is_fixed ? V(0, 0, 0) : V(posed.principal_inertia.cwiseInverse());

  [[nodiscard]] M axes() const { return turn_of(posed.state.orientation).normalized().toRotationMatrix(); }
  [[nodiscard]] V arm(const V& point) const { return point - posed.state.position; }
  [[nodiscard]] V over_inertia(const V& x) const {
    const M to_world = axes();
    return to_world * inverse_inertia.cwiseProduct(to_world.transpose() * x);
  }
  [[nodiscard]] V at_point(const V& point) const {
    return posed.state.velocity + posed.state.angular_velocity.cross(arm(point));
  }
  void push(const V& point, const V& impulse, bool turns) {
    posed.state.velocity += inverse_mass * impulse;
    if (turns) {
      posed.state.angular_velocity += over_inertia(arm(point).cross(impulse));
    }
  }
  /// The velocity along n at the point that a unit impulse along n gives.
  [[nodiscard]] double mobility(const V& point, const V& n) const {
    return inverse_mass + over_inertia(arm(point).cross(n)).cross(arm(point)).dot(n);
  }
};

struct Guess {
  double normal_impulse = 0;
  V friction{0, 0, 0};
};
using Key = std::tuple<std::size_t, std::size_t, int>;
using Guesses = std::map<Key, Guess>;

struct Contact {
  Key key;
  Body* a;  // the normal points from b to a
  Body* b;
  V point;
  V normal;
  double gap;
  double target = 0;  // the least normal velocity after the impulse
  bool bounces = false;
  Guess impulse = {};

  [[nodiscard]] V velocity() const { return a->at_point(point) - b->at_point(point); }
  [[nodiscard]] double mobility(const V& n) const { return a->mobility(point, n) + b->mobility(point, n); }
  void push(const V& along, bool turns) {
    a->push(point, along, turns);
    b->push(point, -along, turns);
  }
};

class World {
 public:
  World(const SteppedScene& scene, Defect defect, Guesses& guesses)
      : scene_(scene), defect_(defect), guesses_(guesses) {
    for (const SteppedBody& posed : scene.bodies) {
      bodies_.push_back({posed});
    }
  }

  void step(double h) {
    std::vector<Contact> contacts = found(h);
    if (is(Defect::contacts_a_step_late)) {
      std::swap(contacts, last_);
    }
    if (!is(Defect::restitution_after_gravity)) {
      aim(contacts, h);
    }
    for (Body& body : bodies_) {
      body.posed.state.velocity += body.posed.is_fixed ? V(0, 0, 0) : V(h * scene_.gravity);
    }
    if (is(Defect::restitution_after_gravity)) {
      aim(contacts, h);
    }
    solve(contacts);
    for (Body& body : bodies_) {
      if (!body.posed.is_fixed) {
        advance(body, h);
      }
    }
  }

  [[nodiscard]] std::vector<BodyState> states() const {
    std::vector<BodyState> all;
    for (const Body& body : bodies_) {
      all.push_back(body.posed.state);
    }
    return all;
  }

 private:
  [[nodiscard]] bool is(Defect defect) const { return defect_ == defect; }

  /// The contacts, in an order that does not depend on the order of the bodies.
  std::vector<Contact> found(double h) {
    const auto rank = [&](std::size_t i) {
      const V& x = bodies_[i].posed.state.position;
      return std::tuple(bodies_[i].posed.shape.index(), x[0], x[1], x[2]);
    };
    std::vector<Contact> all;
    for (std::size_t i = 0; i < bodies_.size(); ++i) {
      for (std::size_t j = 0; j < bodies_.size(); ++j) {
        const bool is_movable = !bodies_[i].posed.is_fixed || !bodies_[j].posed.is_fixed;
        if (i != j && is_movable && rank(i) < rank(j)) {
          find(i, j, h, all);
        }
      }
    }
    if (!is(Defect::insertion_order)) {
      std::stable_sort(all.begin(), all.end(), [](const Contact& x, const Contact& y) {
        return std::tuple(x.point[0], x.point[1], x.point[2]) < std::tuple(y.point[0], y.point[1], y.point[2]);
      });
    }
    return all;
  }

  /// The contacts of a sphere with what is after it in `Shape`, or of a box with a half-space.
  void find(std::size_t i, std::size_t j, double h, std::vector<Contact>& all) {
    Body& one = bodies_[i];
    Body& other = bodies_[j];
    const std::size_t first = all.size();
    const double speed = (one.posed.state.velocity - other.posed.state.velocity).norm();
    const double reach = is(Defect::speculative_contacts) ? h * speed : touching;
    const auto add = [&](const V& point, const V& normal, double gap) {
      if (gap < reach) {
        all.push_back({{i, j, static_cast<int>(all.size() - first)}, &one, &other, point, normal, gap});
      }
    };
    const V between = other.arm(one.posed.state.position);
    const auto* const sphere = std::get_if<SphereShape>(&one.posed.shape);
    if (const auto* const ground = std::get_if<HalfSpaceShape>(&other.posed.shape)) {
      const V& n = ground->normal;
      if (sphere != nullptr) {
        add(one.posed.state.position - sphere->radius * n, n, n.dot(between) - sphere->radius);
        return;
      }
      for (unsigned k = 0; k < 8; ++k) {
        const V signs{k & 1U ? 0.5 : -0.5, k & 2U ? 0.5 : -0.5, k & 4U ? 0.5 : -0.5};
        const V corner = one.axes() * std::get<BoxShape>(one.posed.shape).lengths.cwiseProduct(signs);
        add(one.posed.state.position + corner, n, n.dot(between + corner));
      }
      if (is(Defect::one_contact_point) && all.size() > first) {
        all.erase(all.begin() + static_cast<std::ptrdiff_t>(first) + 1, all.end());
      }
    } else if (sphere != nullptr) {
      V nearest{0, 0, 0};  // in the other: the centre of a sphere, or a point of a box
      double radius = sphere->radius;
      if (const auto* const box = std::get_if<BoxShape>(&other.posed.shape)) {
        nearest =
            other.axes() * (other.axes().transpose() * between).cwiseMin(box->lengths / 2).cwiseMax(-box->lengths / 2);
      } else {
        radius += std::get<SphereShape>(other.posed.shape).radius;
      }
      const V out = between - nearest;
      add(one.posed.state.position - sphere->radius * out.normalized(), out.normalized(), out.norm() - radius);
    }
  }

  void aim(std::vector<Contact>& contacts, double h) const {
    for (Contact& contact : contacts) {
      const double approach = contact.normal.dot(contact.velocity());
      contact.bounces = approach < (is(Defect::restitution_threshold) ? -0.5 : 0) && scene_.restitution > 0;
      contact.target = contact.bounces ? -scene_.restitution * approach : 0;
      if (is(Defect::pushed_out_with_velocity) && contact.gap < 0) {
        contact.target -= 0.2 * contact.gap / h;
      }
      if (contact.gap > touching) {  // speculative
        contact.target = -contact.gap / h;
      }
    }
  }

  void solve(std::vector<Contact>& contacts) {
    for (Contact& contact : contacts) {
      contact.impulse = guesses_[contact.key];
      contact.push(contact.impulse.normal_impulse * contact.normal, true);
      contact.push(contact.impulse.friction, turns(contact));
    }
    double change = 1;
    const std::size_t rounds = 50 + 20000 / (contacts.size() + 1);
    for (std::size_t round = 0; round < rounds && change > 1e-9; ++round) {
      change = 0;
      for (Contact& contact : contacts) {
        change = std::max({change, push_apart(contact), rub(contact)});
      }
    }
    for (const Contact& contact : contacts) {
      guesses_[contact.key] = contact.impulse;
    }
  }

  /// Returns the change of velocity.
  static double push_apart(Contact& contact) {
    const double mobility = contact.mobility(contact.normal);
    const double lacking = contact.target - contact.normal.dot(contact.velocity());
    const double before = contact.impulse.normal_impulse;
    contact.impulse.normal_impulse = std::max(0.0, before + lacking / mobility);
    contact.push((contact.impulse.normal_impulse - before) * contact.normal, true);
    return std::abs(contact.impulse.normal_impulse - before) * mobility;
  }

  double rub(Contact& contact) const {
    V slip = contact.velocity();
    slip -= contact.normal * contact.normal.dot(slip);
    if (is(Defect::friction_of_one_axis)) {
      slip = {slip[0], 0, 0};
    }
    if (scene_.friction == 0 || slip.norm() < 1e-300) {
      return 0;
    }
    const double mobility = contact.mobility(slip.normalized());
    const V before = contact.impulse.friction;
    V& friction = contact.impulse.friction;
    friction -= slip / mobility;
    const double most =
        scene_.friction * (is(Defect::friction_an_impulse_a_step) ? scene_.gravity.norm() * contact.a->posed.mass
                                                                  : contact.impulse.normal_impulse);
    if (!is(Defect::friction_beyond_the_cone) && friction.norm() > most) {
      friction *= most / friction.norm();
    }
    contact.push(friction - before, turns(contact));
    return (friction - before).norm() * mobility;
  }

  [[nodiscard]] bool turns(const Contact& contact) const {
    return !is(Defect::bounce_without_spin) || !contact.bounces;
  }

  void advance(Body& body, double h) const {
    BodyState& state = body.posed.state;
    V& w = state.angular_velocity;
    const double kept = is(Defect::damping) ? 1 - 0.1 * h : 1;
    state.velocity *= kept;
    w *= kept;
    const V momentum = body.axes() * body.posed.principal_inertia.cwiseProduct(body.axes().transpose() * w);
    if (is(Defect::explicit_gyroscopic_term)) {
      w -= h * body.over_inertia(w.cross(momentum));
    }
    state.position += h * state.velocity;
    const Eigen::AngleAxisd turn(w.norm() * h, w.norm() > 0 ? V(w.normalized()) : V(1, 0, 0));
    const Eigen::Quaterniond turned = (turn * turn_of(state.orientation)).normalized();
    state.orientation = {turned.w(), turned.x(), turned.y(), turned.z()};
    if (!is(Defect::no_gyroscopic_term) && !is(Defect::explicit_gyroscopic_term)) {
      w = body.over_inertia(momentum);
    }
    if (is(Defect::binary32_state)) {
      state = {state.position.cast<float>().cast<double>(), state.orientation.cast<float>().cast<double>(),
               state.velocity.cast<float>().cast<double>(), w.cast<float>().cast<double>()};
    }
  }

  const SteppedScene& scene_;
  Defect defect_;
  Guesses& guesses_;
  std::vector<Body> bodies_;
  std::vector<Contact> last_;
};

}  // namespace

Stepper planted_engine(Defect defect) {
  Stepper stepper;
  stepper.name = "planted";
  stepper.cannot = {"continuous"};
  stepper.open = [defect] {
    const auto guesses = std::make_shared<Guesses>();
    return [defect, guesses](const Stepping& stepping) -> SteppingAnswer {
      if (defect != Defect::surviving_warm_starts) {
        guesses->clear();
      }
      World world(stepping.scene, defect, *guesses);
      SteppedStates answer;
      for (std::uint64_t k = 1; k <= steps_of(stepping); ++k) {
        world.step(stepping.step);
        if (std::binary_search(stepping.report.begin(), stepping.report.end(), k)) {
          answer.states.push_back(world.states());
        }
      }
      return answer;
    };
  };
  return stepper;
}

}  // namespace carom::phenomena_tests
