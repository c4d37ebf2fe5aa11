// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>

#include <Eigen/Geometry>

#include <carom/properties/scenes/ledger.hpp>

namespace carom::properties {
namespace {

using scene::Arc;
using scene::Phase;
using Wide = Vector3<long double>;

Wide wide(const Vector3<double>& v) { return v.cast<long double>(); }

Wide wide_velocity_at(const Arc& arc, double time) {
  return wide(arc.path.velocity) + (static_cast<long double>(time) - arc.path.start) * wide(arc.path.acceleration);
}
Wide wide_position_at(const Arc& arc, double time) {
  const long double s = static_cast<long double>(time) - arc.path.start;
  return wide(arc.path.position) + s * (wide(arc.path.velocity) + s / 2 * wide(arc.path.acceleration));
}
Wide spin_at(const Arc& arc, double time) {
  return wide(arc.turning.angular_velocity) +
         (static_cast<long double>(time) - arc.path.start) * wide(arc.turning.angular_acceleration);
}

/// What a law makes of the energy of two spheres, or of one and a plane. The normal part is (ε² − 1)(N·V)²/(2 λ), λ the
/// sum of the inverse masses; tangentially K is λ + R_A²/I_A + R_B²/I_B, and an impulse −j against the slip of speed t
/// does −j t + K j²/2: j = t/K where it sticks, at most (1 + e_t) t/K and μ times the normal impulse under `rough`, e_t
/// = 0 under `coulomb` (mathematics of spheres: docs/guide/laws.md).
long double energy_of_impact(Model law, const Collision& collision) {
  const Wide n = wide(collision.normal).normalized();
  const auto arm = [&](const Body& body) -> Wide { return -wide(body.position); };
  const auto point_velocity = [&](const Body& body) -> Wide {
    return wide(body.velocity) + wide(body.angular_velocity).cross(arm(body));
  };
  long double inverse_mass = 0;
  long double tangential = 0;
  for (const Body* body : {&collision.a, &collision.b}) {
    if (!body->immovable) {
      inverse_mass += 1 / static_cast<long double>(body->mass);
      tangential += arm(*body).squaredNorm() / body->principal_inertia[0];
    }
  }
  tangential += inverse_mass;
  const Wide velocity = point_velocity(collision.a) - point_velocity(collision.b);
  const long double approach = n.dot(wide(collision.a.velocity) - wide(collision.b.velocity));
  if (approach >= 0) {
    return 0;
  }
  const long double restitution = collision.restitution;
  const long double normal_energy = (restitution * restitution - 1) * approach * approach / (2 * inverse_mass);
  const long double normal_impulse = -(1 + restitution) * approach / inverse_mass;
  const long double slip = (velocity - n * n.dot(velocity)).norm();
  long double friction_impulse = 0;
  switch (law) {
    case Model::frictionless:
    case Model::reflection:
    case Model::any:
      break;
    case Model::sticking:
      friction_impulse = slip / tangential;
      break;
    case Model::rough:
      friction_impulse = std::min((1 + static_cast<long double>(collision.tangential_restitution)) * slip / tangential,
                                  collision.friction * normal_impulse);
      break;
    case Model::coulomb:
      friction_impulse = std::min(slip / tangential, collision.friction * normal_impulse);
      break;
  }
  return normal_energy - friction_impulse * slip + tangential * friction_impulse * friction_impulse / 2;
}

/// ∫ |f + g s| ds over [0, span] for a speed f ≥ 0 that falls to no less than 0, but for rounding.
long double distance(long double speed, long double loss, long double span) {
  return speed * span - loss * span * span / 2;
}

}  // namespace

std::string_view name_of(Cause cause) {
  switch (cause) {
    case Cause::impacts:
      return "impacts of spheres";
    case Cause::plane_impacts:
      return "impacts with planes";
    case Cause::slow_contacts:
      return "slow contacts";
    case Cause::sliding:
      return "sliding";
    case Cause::rolling:
      return "rolling";
    case Cause::spinning:
      return "spinning";
    case Cause::rounding:
      break;
  }
  return "rounding";
}

void Account::add(long double amount) {
  const long double next = sum_ + amount;
  compensation_ += std::abs(sum_) >= std::abs(amount) ? (sum_ - next) + amount : (amount - next) + sum_;
  sum_ = next;
}

Ledger::Ledger(const scene::Simulation& simulation)
    : scene_(&simulation.scene()), gravity_(wide(simulation.scene().gravity)), initial_momentum_(Wide::Zero()) {
  for (std::size_t plane = 0; plane < scene_->planes.size(); ++plane) {
    levels_.push_back(simulation.level(plane).value_or(scene::Level{2, 1, 0}));
  }
  for (std::size_t sphere = 0; sphere < simulation.size(); ++sphere) {
    held_.push_back({simulation.mass(sphere), simulation.moment(sphere), {}});
    const Arc arc = simulation.arc(sphere);
    const Energies energies = energies_of(arc, arc.path.start, sphere);
    held_.back().energies = energies;
    translation_.add(energies.translation);
    rotation_.add(energies.rotation);
    potential_.add(energies.potential);
    initial_momentum_ += held_.back().mass * wide(arc.path.velocity);
  }
  initial_ = present();
  for (const Held& held : held_) {
    heights_ += std::abs(held.energies.potential);
  }
  scale_ = initial_.translation + initial_.rotation + heights_;
}

Energies Ledger::present() const { return {translation_.sum(), rotation_.sum(), potential_.sum()}; }

Vector3<long double> Ledger::sum_of(const Momentum& momentum) {
  return {momentum[0].sum(), momentum[1].sum(), momentum[2].sum()};
}

void Ledger::add(Momentum& account, const Vector3<long double>& amount) {
  for (int axis = 0; axis < 3; ++axis) {
    account[static_cast<std::size_t>(axis)].add(amount[axis]);
  }
}

void Ledger::round_energy(long double amount) {
  energy_[Cause::rounding].add(amount);
  rounding_.add(std::abs(amount));
}

Energies Ledger::energies_of(const Arc& arc, double time, std::size_t sphere) const {
  const Held& held = held_[sphere];
  return {held.mass * wide_velocity_at(arc, time).squaredNorm() / 2, held.moment * spin_at(arc, time).squaredNorm() / 2,
          -held.mass * gravity_.dot(wide_position_at(arc, time))};
}

void Ledger::follow(const Arc& arc, double end, std::size_t sphere) {
  const Held& held = held_[sphere];
  const long double span = static_cast<long double>(end) - arc.path.start;
  const Energies before = energies_of(arc, arc.path.start, sphere);
  const Energies after = energies_of(arc, end, sphere);
  const long double work =
      held.mass * gravity_.dot(span * (wide(arc.path.velocity) + span / 2 * wide(arc.path.acceleration)));
  gravity_work_.add(work);
  long double by_causes = 0;
  const auto book = [&](Cause cause, long double amount) {
    energy_[cause].add(amount);
    by_causes += amount;
  };
  const Phase phase = arc.turning.phase;
  if (phase != Phase::flying) {
    const scene::Level& level = levels_[arc.turning.plane];
    Wide n = Wide::Zero();
    n[level.axis] = level.up;
    const scene::MaterialPair& pair =
        scene_->pairs.of(scene_->spheres[sphere].material, scene_->planes[arc.turning.plane].material);
    const long double g = level.gravity;
    const long double radius = arc.path.radius;
    const Wide v = wide(arc.path.velocity);
    const Wide w = wide(arc.turning.angular_velocity);
    const bool decelerates = !arc.path.acceleration.isZero(0);
    if (phase == Phase::sliding && decelerates) {
      const long double friction = pair.friction * g;
      book(Cause::sliding, -held.mass * friction * distance((v - radius * w.cross(n)).norm(), 3.5L * friction, span));
    } else if (phase == Phase::rolling && decelerates) {
      const long double resistance = pair.rolling_resistance * g;
      book(Cause::rolling, -1.4L * held.mass * resistance * distance(v.norm(), resistance, span));
    }
    if (arc.turning.angular_acceleration[level.axis] != 0) {
      const long double loss = 2.5L * pair.spinning_resistance * g / radius;
      book(Cause::spinning, -held.moment * loss * distance(std::abs(w[level.axis]), loss, span));
    }
  }
  round_energy((after.translation + after.rotation) - (before.translation + before.rotation) - work - by_causes);
  round_energy(after.potential - before.potential + work);
  translation_.add(after.translation - before.translation);
  rotation_.add(after.rotation - before.rotation);
  potential_.add(after.potential - before.potential);
  add(gravity_impulse_, held.mass * span * gravity_);
  add(plane_impulse_, held.mass * span * (wide(arc.path.acceleration) - gravity_));
}

void Ledger::record(const scene::Event& event) {
  long double gained = 0;
  Wide momentum = Wide::Zero();
  Wide angular = Wide::Zero();
  long double angular_size = 0;
  const auto change = [&](const scene::Change& one) {
    const Held& held = held_[one.sphere];
    follow(one.before, event.time, one.sphere);
    const Energies before = energies_of(one.before, event.time, one.sphere);
    const Energies after = energies_of(one.after, event.time, one.sphere);
    gained += (after.translation + after.rotation) - (before.translation + before.rotation);
    round_energy(after.potential - before.potential);
    translation_.add(after.translation - before.translation);
    rotation_.add(after.rotation - before.rotation);
    potential_.add(after.potential - before.potential);
    const Wide v = wide_velocity_at(one.before, event.time);
    const Wide v_after = wide(one.after.path.velocity);
    momentum += held.mass * (v_after - v);
    angular +=
        held.mass * (wide(one.after.path.position).cross(v_after) - wide_position_at(one.before, event.time).cross(v)) +
        held.moment * (wide(one.after.turning.angular_velocity) - spin_at(one.before, event.time));
    angular_size += held.mass * wide_position_at(one.before, event.time).norm() * v.norm();
  };
  change(event.a);
  if (event.b) {
    change(*event.b);
  }
  long double by_law = 0;
  if (event.has_impulse) {
    by_law = energy_of_impact(scene_->law, event.collision);
    energy_[event.b ? Cause::impacts : Cause::plane_impacts].add(by_law);
  }
  if (event.was_slow) {
    // Elastic by the law, the speeds along the normal are then raised from one to the other.
    const Wide n = wide(event.collision.normal).normalized();
    const auto speed = [&](const auto& a, const auto& b) { return n.dot(wide(a) - wide(b)); };
    const long double before = speed(event.outcome.a.velocity, event.outcome.b.velocity);
    const Vector3<double> still = Vector3<double>::Zero();
    const long double after = speed(event.a.after.path.velocity, event.b ? event.b->after.path.velocity : still);
    long double inverse_mass = 1 / held_[event.a.sphere].mass;
    inverse_mass += event.b ? 1 / held_[event.b->sphere].mass : 0;
    const long double pushed = (after * after - before * before) / (2 * inverse_mass);
    energy_[Cause::slow_contacts].add(pushed);
    by_law += pushed;
  }
  round_energy(gained - by_law);
  if (event.kind == scene::EventKind::impact) {
    add(momentum_rounding_, momentum);
    angular_rounding_.add(angular.norm());
    angular_scale_ = std::max(angular_scale_, angular_size);
  } else {
    add(plane_impulse_, momentum);
  }
  scale_ = std::max(scale_, translation_.sum() + rotation_.sum() + heights_);
}

void Ledger::close(const scene::Simulation& simulation) {
  for (std::size_t sphere = 0; sphere < simulation.size(); ++sphere) {
    const Arc arc = simulation.arc(sphere);
    follow(arc, simulation.time(), sphere);
  }
}

}  // namespace carom::properties
