// SPDX-License-Identifier: BSL-1.0
#include "planted_engine.hpp"

#include <algorithm>
#include <array>
#include <chrono>
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

struct Body {
  SteppedBody posed;
  M axes = M::Identity();  // from body axes to world axes
  double inverse_mass = 0;
  V inverse_inertia{0, 0, 0};

  [[nodiscard]] V at_point(const V& point) const {
    return posed.state.velocity + posed.state.angular_velocity.cross(point - posed.state.position);
  }
  [[nodiscard]] V over_inertia(const V& x) const { return axes * inverse_inertia.cwiseProduct(axes.transpose() * x); }
  [[nodiscard]] V half() const { return std::get<BoxShape>(posed.shape).lengths / 2; }

  void push(const V& point, const V& impulse, bool turns) {
    posed.state.velocity += inverse_mass * impulse;
    if (turns) {
      posed.state.angular_velocity += over_inertia((point - posed.state.position).cross(impulse));
    }
  }
  /// The velocity along n at the point that a unit impulse along n gives.
  [[nodiscard]] double mobility(const V& point, const V& n) const {
    const V arm = point - posed.state.position;
    return inverse_mass + over_inertia(arm.cross(n)).cross(arm).dot(n);
  }
};

using Key = std::tuple<std::size_t, std::size_t, int>;

struct Contact {
  Key key;
  Body* a;  // the normal points from b to a
  Body* b;
  V point;
  V normal;
  double gap;
  double target = 0;  // the least normal velocity after the impulse
  bool bounces = false;
  double normal_impulse = 0;
  V friction{0, 0, 0};

  [[nodiscard]] V velocity() const { return a->at_point(point) - b->at_point(point); }
  void push(const V& impulse, bool turns) {
    a->push(point, impulse, turns);
    b->push(point, -impulse, turns);
  }
  [[nodiscard]] double mobility(const V& n) const { return a->mobility(point, n) + b->mobility(point, n); }
};

M axes_of(const Quaternion<double>& q) {
  return Eigen::Quaterniond(q[0], q[1], q[2], q[3]).normalized().toRotationMatrix();
}

std::array<V, 8> corners(const Body& box) {
  std::array<V, 8> all;
  for (unsigned i = 0; i < 8; ++i) {
    const V signs{i & 1U ? 1.0 : -1.0, i & 2U ? 1.0 : -1.0, i & 4U ? 1.0 : -1.0};
    all[i] = box.posed.state.position + box.axes * box.half().cwiseProduct(signs);
  }
  return all;
}

class World {
 public:
  World(const SteppedScene& scene, Defect defect, std::map<Key, std::pair<double, V>>& guesses)
      : scene_(scene), defect_(defect), guesses_(guesses) {
    for (const SteppedBody& posed : scene.bodies) {
      Body body{posed, axes_of(posed.state.orientation), 0, {0, 0, 0}};
      if (!posed.is_fixed) {
        body.inverse_mass = 1 / posed.mass;
        body.inverse_inertia = posed.principal_inertia.cwiseInverse();
      }
      bodies_.push_back(body);
    }
  }

  void step(double h) {
    std::vector<Contact> contacts = found(h);
    if (defect_ == Defect::contacts_a_step_late) {
      std::swap(contacts, last_);
    }
    if (defect_ != Defect::restitution_after_gravity) {
      aim(contacts, h);
    }
    each_movable([&](Body& body) { body.posed.state.velocity += h * scene_.gravity; });
    if (defect_ == Defect::restitution_after_gravity) {
      aim(contacts, h);
    }
    solve(contacts);
    each_movable([&](Body& body) { advance(body, h); });
  }

  [[nodiscard]] std::vector<BodyState> states() const {
    std::vector<BodyState> all;
    std::transform(bodies_.begin(), bodies_.end(), std::back_inserter(all),
                   [](const Body& body) { return body.posed.state; });
    return all;
  }

 private:
  template <class F>
  void each_movable(F f) {
    for (Body& body : bodies_) {
      if (!body.posed.is_fixed) {
        f(body);
      }
    }
  }

  /// The contacts, in an order that does not depend on the order of the bodies.
  std::vector<Contact> found(double h) {
    std::vector<Contact> all;
    for (std::size_t i = 0; i < bodies_.size(); ++i) {
      for (std::size_t j = i + 1; j < bodies_.size(); ++j) {
        if (bodies_[i].posed.is_fixed && bodies_[j].posed.is_fixed) {
          continue;
        }
        const auto place = [&](std::size_t k) {
          const V& x = bodies_[k].posed.state.position;
          return std::tuple(std::holds_alternative<HalfSpaceShape>(bodies_[k].posed.shape),
                            std::holds_alternative<BoxShape>(bodies_[k].posed.shape), x[0], x[1], x[2]);
        };
        const bool in_order = place(i) < place(j);
        find(in_order ? i : j, in_order ? j : i, h, all);
      }
    }
    if (defect_ != Defect::insertion_order) {
      std::stable_sort(all.begin(), all.end(), [](const Contact& x, const Contact& y) {
        return std::tuple(x.point[0], x.point[1], x.point[2]) < std::tuple(y.point[0], y.point[1], y.point[2]);
      });
    }
    return all;
  }

  /// The contacts of two bodies. A sphere stands before a box, and a box before a half-space.
  void find(std::size_t a, std::size_t b, double h, std::vector<Contact>& all) {
    const std::size_t first = all.size();
    const double reach = defect_ == Defect::speculative_contacts
                             ? h * (bodies_[a].posed.state.velocity - bodies_[b].posed.state.velocity).norm()
                             : touching;
    const auto add = [&](int feature, const V& point, const V& normal, double gap) {
      if (gap < reach) {
        all.push_back({{a, b, feature}, &bodies_[a], &bodies_[b], point, normal, gap});
      }
    };
    const Body& one = bodies_[a];
    const Body& other = bodies_[b];
    const V& place = one.posed.state.position;
    const auto* sphere = std::get_if<SphereShape>(&one.posed.shape);
    if (const auto* half_space = std::get_if<HalfSpaceShape>(&other.posed.shape)) {
      const auto gap = [&](const V& x) { return half_space->normal.dot(x - other.posed.state.position); };
      if (sphere != nullptr) {
        add(0, place - sphere->radius * half_space->normal, half_space->normal, gap(place) - sphere->radius);
      } else {
        const auto all_corners = corners(one);
        for (std::size_t i = 0; i < 8; ++i) {
          add(static_cast<int>(i), all_corners[i], half_space->normal, gap(all_corners[i]));
        }
      }
    } else if (const auto* second = std::get_if<SphereShape>(&other.posed.shape)) {
      const V between = place - other.posed.state.position;
      add(0, place - sphere->radius * between.normalized(), between.normalized(),
          between.norm() - sphere->radius - second->radius);
    } else if (sphere != nullptr) {
      const V in_box = other.axes.transpose() * (place - other.posed.state.position);
      const V nearest = in_box.cwiseMin(other.half()).cwiseMax(-other.half());
      V out = in_box - nearest;
      Eigen::Index k = 0;
      double gap = out.norm() - sphere->radius;
      if (out.norm() == 0) {  // the centre is in the box
        const double depth = (other.half() - in_box.cwiseAbs()).minCoeff(&k);
        out[k] = std::copysign(1.0, in_box[k]);
        gap = -depth - sphere->radius;
      }
      add(0, other.posed.state.position + other.axes * nearest, other.axes * out.normalized(), gap);
    } else {
      find_corners(one, other, add);
    }
    if (defect_ == Defect::one_contact_point && all.size() > first) {
      const auto deepest = std::min_element(all.begin() + static_cast<std::ptrdiff_t>(first), all.end(),
                                            [](const Contact& x, const Contact& y) { return x.gap < y.gap; });
      all[first] = *deepest;
      all.erase(all.begin() + static_cast<std::ptrdiff_t>(first) + 1, all.end());
    }
  }

  /// The corners of a box in the other, with the face normal along which the boxes overlap least.
  template <class Add>
  static void find_corners(const Body& one, const Body& other, Add add) {
    const V between = one.posed.state.position - other.posed.state.position;
    V normal{0, 0, 0};
    double least = 1e9;
    for (const M* axes : {&one.axes, &other.axes}) {
      for (Eigen::Index k = 0; k < 3; ++k) {
        const V axis = axes->col(k);
        const double extent = (one.axes.transpose() * axis).cwiseAbs().dot(one.half()) +
                              (other.axes.transpose() * axis).cwiseAbs().dot(other.half());
        const double overlap = extent - std::abs(axis.dot(between));
        if (overlap < least - touching) {
          least = overlap;
          normal = axis.dot(between) < 0 ? V(-axis) : axis;
        }
      }
    }
    if (least < -touching) {
      return;
    }
    int feature = 0;
    bool has_contact = false;
    for (const auto& [box, around, sign] : {std::tuple(&one, &other, 1.0), std::tuple(&other, &one, -1.0)}) {
      const double face = (around->axes.transpose() * normal).cwiseAbs().dot(around->half());
      for (const V& corner : corners(*box)) {
        const V out = corner - around->posed.state.position;
        const V in_box = (around->axes.transpose() * out).cwiseAbs();
        if (sign < 0 && has_contact) {
          return;  // the corners of the other box would say the same again
        }
        ++feature;
        if ((in_box.array() <= around->half().array() + touching).all()) {
          has_contact = true;
          add(feature, corner, normal, sign * normal.dot(out) - face);
        }
      }
    }
  }

  void aim(std::vector<Contact>& contacts, double h) const {
    for (Contact& contact : contacts) {
      const double approach = contact.normal.dot(contact.velocity());
      const double least = defect_ == Defect::restitution_threshold ? 0.5 : 0;
      contact.bounces = approach < -least && scene_.restitution > 0;
      contact.target = contact.bounces ? -scene_.restitution * approach : 0;
      if (defect_ == Defect::pushed_out_with_velocity && contact.gap < 0) {
        contact.target -= 0.2 * contact.gap / h;
      }
      if (contact.gap > touching) {  // speculative
        contact.target = -contact.gap / h;
      }
    }
  }

  void solve(std::vector<Contact>& contacts) {
    for (Contact& contact : contacts) {
      if (const auto guess = guesses_.find(contact.key); guess != guesses_.end()) {
        std::tie(contact.normal_impulse, contact.friction) = guess->second;
        contact.push(contact.normal_impulse * contact.normal, true);
        contact.push(contact.friction, turns(contact));
      }
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
      guesses_[contact.key] = {contact.normal_impulse, contact.friction};
    }
  }

  /// Returns the change of velocity.
  static double push_apart(Contact& contact) {
    const double mobility = contact.mobility(contact.normal);
    const double before = contact.normal_impulse;
    const double lacking = contact.target - contact.normal.dot(contact.velocity());
    contact.normal_impulse = std::max(0.0, before + lacking / mobility);
    contact.push((contact.normal_impulse - before) * contact.normal, true);
    return std::abs(contact.normal_impulse - before) * mobility;
  }

  double rub(Contact& contact) const {
    V slip = contact.velocity();
    slip -= contact.normal * contact.normal.dot(slip);
    if (defect_ == Defect::friction_of_one_axis) {
      slip = {slip[0], 0, 0};
    }
    if (scene_.friction == 0 || slip.norm() < 1e-300) {
      return 0;
    }
    const double mobility = contact.mobility(slip.normalized());
    const V before = contact.friction;
    contact.friction -= slip / mobility;
    double most = scene_.friction * contact.normal_impulse;
    if (defect_ == Defect::friction_an_impulse_a_step) {
      most = scene_.friction * scene_.gravity.norm() * contact.a->posed.mass;
    }
    if (defect_ != Defect::friction_beyond_the_cone && contact.friction.norm() > most) {
      contact.friction *= most / contact.friction.norm();
    }
    const V change = contact.friction - before;
    contact.push(change, turns(contact));
    return change.norm() * mobility;
  }

  [[nodiscard]] bool turns(const Contact& contact) const {
    return defect_ != Defect::bounce_without_spin || !contact.bounces;
  }

  void advance(Body& body, double h) const {
    BodyState& state = body.posed.state;
    V& w = state.angular_velocity;
    if (defect_ == Defect::damping) {
      state.velocity *= 1 - 0.1 * h;
      w *= 1 - 0.1 * h;
    }
    const auto momentum = [&] {
      return V(body.axes * body.posed.principal_inertia.cwiseProduct(body.axes.transpose() * w));
    };
    const V before = momentum();
    if (defect_ == Defect::explicit_gyroscopic_term) {
      w -= h * body.over_inertia(w.cross(before));
    }
    state.position += h * state.velocity;
    const double half_angle = w.norm() * h / 2;
    const V turn = w.norm() > 0 ? V(std::sin(half_angle) * w.normalized()) : V(0, 0, 0);
    const Eigen::Quaterniond q(state.orientation[0], state.orientation[1], state.orientation[2], state.orientation[3]);
    const Eigen::Quaterniond turned =
        (Eigen::Quaterniond(std::cos(half_angle), turn[0], turn[1], turn[2]) * q).normalized();
    state.orientation = {turned.w(), turned.x(), turned.y(), turned.z()};
    body.axes = axes_of(state.orientation);
    if (defect_ != Defect::no_gyroscopic_term && defect_ != Defect::explicit_gyroscopic_term) {
      w = body.over_inertia(before);  // the angular momentum stays
    }
    if (defect_ == Defect::binary32_state) {
      state = {state.position.cast<float>().cast<double>(), state.orientation.cast<float>().cast<double>(),
               state.velocity.cast<float>().cast<double>(), w.cast<float>().cast<double>()};
    }
  }

  const SteppedScene& scene_;
  Defect defect_;
  std::map<Key, std::pair<double, V>>& guesses_;
  std::vector<Body> bodies_;
  std::vector<Contact> last_;
};

}  // namespace

Stepper planted_engine(Defect defect) {
  Stepper stepper;
  stepper.name = "planted";
  stepper.cannot = {"continuous"};
  stepper.open = [defect] {
    const auto guesses = std::make_shared<std::map<Key, std::pair<double, V>>>();
    return [defect, guesses](const Stepping& stepping) -> SteppingAnswer {
      if (defect != Defect::surviving_warm_starts) {
        guesses->clear();
      }
      World world(stepping.scene, defect, *guesses);
      SteppedStates answer;
      const auto start = std::chrono::steady_clock::now();
      for (std::uint64_t k = 1; k <= steps_of(stepping); ++k) {
        world.step(stepping.step);
        if (std::binary_search(stepping.report.begin(), stepping.report.end(), k)) {
          answer.states.push_back(world.states());
        }
      }
      answer.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
      return answer;
    };
  };
  return stepper;
}

}  // namespace carom::phenomena_tests
