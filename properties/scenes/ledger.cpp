// SPDX-License-Identifier: BSL-1.0
#include <algorithm>
#include <cmath>

#include <carom/properties/scenes/history.hpp>
#include <carom/properties/scenes/ledger.hpp>

namespace carom::properties {
namespace {

using scene::Arc;
using scene::Phase;
using Wide = WideVector;

// The bounds of rounding. On the scenes that ship and in the tests, no entry is above an eighth of its bound, and of
// each kind of entry one is above a three-hundredth.

/// The unit roundoffs of the stored states and of the ledger.
constexpr long double of_double = 0x1p-53L;
constexpr long double of_long_double = 0x1p-64L;

/// A sum of a few terms in long double has at most this number of roundings of its largest term.
constexpr long double roundings_of_ledger = 32;

/// A position at an event is rounded up to eight times, or is moved by 4.5 ulps at most (scene/placing.hpp). An ulp is
/// at most two unit roundoffs.
constexpr long double roundings_of_position = 16;

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

/// The energy that a law adds to two spheres, or to a sphere and a plane [J]. Let λ be the sum of the inverse masses.
/// With a unit normal N, the normal part of the energy is (ε² − 1)(N·V)²/(2 λ). Along the slip, K is the number λ +
/// R_A²/I_A + R_B²/I_B, with radii R and moments I. An impulse j against the slip of speed t does the work −j t + K
/// j²/2. Under `sticking`, j = t/K. Under `rough`, j is the lesser of (1 + e_t) t/K and μ times the normal impulse.
/// Under `coulomb`, j is the same with e_t = 0 (docs/guide/scenes.md, "Which law").
long double energy_of_impact(Law law, const Collision& collision) {
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
    case Law::frictionless:
    case Law::reflection:
    case Law::any:
      break;
    case Law::sticking:
      friction_impulse = slip / tangential;
      break;
    case Law::rough:
      friction_impulse = std::min((1 + static_cast<long double>(collision.tangential_restitution)) * slip / tangential,
                                  collision.friction * normal_impulse);
      break;
    case Law::coulomb:
      friction_impulse = std::min(slip / tangential, collision.friction * normal_impulse);
      break;
  }
  return normal_energy - friction_impulse * slip + tangential * friction_impulse * friction_impulse / 2;
}

/// The energy that an impulse, F on A and −F on B, adds to two bodies [J]: F·V + ½ F·K F. Here K F = F/m_A + F/m_B +
/// (J_A⁻¹ (r_A × F)) × r_A + (J_B⁻¹ (r_B × F)) × r_B, so F·K F is a sum of squares.
long double work_of_impulse(const Collision& collision, const Wide& impulse) {
  long double work = 0;
  for (const Body* body : {&collision.a, &collision.b}) {
    const Wide on_body = body == &collision.a ? impulse : Wide(-impulse);
    const Wide arm = wide(collision.point) - wide(body->position);
    const Wide torque = arm.cross(on_body);
    work += on_body.dot(wide(body->velocity)) + torque.dot(wide(body->angular_velocity));
    if (!body->immovable) {
      const Wide along_axes = wide_rotation(body->orientation).transpose() * torque;
      work += on_body.squaredNorm() / (2 * static_cast<long double>(body->mass)) +
              along_axes.cwiseAbs2().cwiseQuotient(wide(body->principal_inertia)).sum() / 2;
    }
  }
  return work;
}

/// The impulse on A. It comes from the lighter body, whose velocity shows more of its digits.
Wide impulse_of(const Collision& collision, const Outcome<double>& outcome) {
  const auto change = [](const Body& body, const BodyVelocity<double>& after) -> Wide {
    return static_cast<long double>(body.mass) * (wide(after.velocity) - wide(body.velocity));
  };
  const bool is_b_lighter = !collision.b.immovable && collision.b.mass < collision.a.mass;
  return is_b_lighter ? Wide(-change(collision.b, outcome.b)) : change(collision.a, outcome.a);
}

/// The distance [m] over a span of time, with a speed and its change in a second [m/s²].
long double distance(long double speed, long double change, long double span) {
  return speed * span + change * span * span / 2;
}

/// An upper bound of the speed of a body's points on an arc [m/s], if its angular speed is at most `rate` [rad/s].
long double greatest_speed(const Arc& arc, long double span, long double rate) {
  return wide(arc.path.velocity).norm() + span * wide(arc.path.acceleration).norm() +
         arc.path.radius * (rate + span * wide(arc.turning.angular_acceleration).norm());
}

/// The work of the resistances on an arc of a sphere on a plane, for a unit mass [J/kg]. Sliding friction and rolling
/// resistance act along −d, with the fixed direction d that the acceleration shows.
std::array<std::pair<Cause, long double>, 3> work_of_resistance(const scene::Scene& scene, const Arc& arc,
                                                                long double span, std::size_t body) {
  const scene::Plane& plane = scene.planes[arc.turning.plane];
  const scene::MaterialPair& pair = scene.pairs.of(material_of(scene, body), plane.material);
  const Wide n = wide(plane.normal).normalized();
  const long double pressing = -n.dot(wide(scene.gravity));
  const Wide along = wide(scene.gravity) + pressing * n;
  const long double radius = arc.path.radius;
  const Wide v = wide(arc.path.velocity);
  const Wide a = wide(arc.path.acceleration);
  const Wide w = wide(arc.turning.angular_velocity);
  const long double friction = pair.friction * pressing;
  const long double resistance = pair.rolling_resistance * pressing;
  const long double loss = 2.5L * pair.spinning_resistance * pressing / radius;
  long double sliding = 0;
  long double rolling = 0;
  long double spinning = 0;
  if (arc.turning.phase == Phase::sliding && friction > 0) {
    const Wide d = (along - a).normalized();
    sliding = -friction * distance(d.dot(v - radius * w.cross(n)), d.dot(along) - 3.5L * friction, span);
  } else if (arc.turning.phase == Phase::rolling && resistance > 0) {
    const Wide d = (5 * along / 7 - a).normalized();
    rolling = -1.4L * resistance * distance(d.dot(v), d.dot(a), span);
  }
  if (std::abs(n.dot(wide(arc.turning.angular_acceleration))) > loss / 2) {
    spinning = -0.4L * radius * radius * loss * distance(std::abs(n.dot(w)), -loss, span);
  }
  return {{{Cause::sliding, sliding}, {Cause::rolling, rolling}, {Cause::spinning, spinning}}};
}

/// A bound of the rounding of the kinetic energy on an arc [J]. With the greatest speed V, the terms are at most m V².
/// A sphere that flies follows its parabola exactly, so only the ledger rounds. On a plane, the stored accelerations
/// have up to 16 roundings of their own size, as has the direction in which gravity does its work. The rotation of
/// a polyhedron is rounded in steps of an eighth of a radian.
long double rounding_of_motion(const Arc& arc, long double span, long double mass, bool turns_freely, long double rate,
                               const Wide& gravity) {
  const long double speed = greatest_speed(arc, span, rate);
  const long double rim = arc.path.radius * rate;
  long double bound = roundings_of_ledger * of_long_double * mass * speed * speed;
  if (arc.turning.phase != Phase::flying) {
    const Wide way = span * (wide(arc.path.velocity).cwiseAbs() + span / 2 * wide(arc.path.acceleration).cwiseAbs());
    bound += 16 * of_double * mass * (speed * speed + gravity.cwiseAbs().dot(way));
  } else if (turns_freely) {
    bound += 16 * (1 + rate * span) * of_double * mass * rim * rim;
  }
  return bound;
}

/// A bound of the rounding of the kinetic energy of one body at an event, in unit roundoffs [J]. V is the sum of the
/// greatest speeds before and after the event. The outcome of a law has at most 16 roundings of terms of the size V,
/// and an energy is at most m V². The mass of an impact is less than that of each body, so the terms of its impulse
/// are bounded by the sum over both bodies. The time t at which a phase ends is rounded, too. So the speed at this time
/// is wrong by up to 2 u t times its rate of change, with the unit roundoff u.
long double roundings_of_change(const scene::Event& event, const scene::Change& change, long double mass,
                                long double rate_before, long double rate_after) {
  const long double span = static_cast<long double>(event.time) - change.before.path.start;
  const long double speed =
      greatest_speed(change.before, span, rate_before) + greatest_speed(change.after, 0, rate_after);
  long double roundings = 16 * mass * speed * speed;
  if (event.kind == scene::EventKind::phase) {
    const Wide acceleration = wide(change.before.path.acceleration);
    const Wide turning = wide(change.before.turning.angular_acceleration);
    roundings += 2 * mass * speed * event.time * (acceleration.norm() + change.before.path.radius * turning.norm());
  }
  return roundings;
}

}  // namespace

std::string_view name_of(Cause cause) {
  switch (cause) {
    case Cause::impacts:
      return "impacts of bodies";
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

Ledger::Ledger(const scene::SceneState& state)
    : scene_(state.scene), gravity_(wide(state.scene->gravity)), initial_momentum_(Wide::Zero()) {
  for (std::size_t i = 0; i < state.bodies.size(); ++i) {
    const scene::BodyState& body = state.bodies[i];
    bodies_.push_back({body.mass, wide(body.principal_inertia), !is_sphere(*scene_, i), body.orientation_at_start, {}});
    const Spin spin{body.orientation_at_start, wide(body.arc.turning.angular_velocity)};
    const Energies energies = energies_of(body.arc, body.arc.path.start, i, spin);
    bodies_.back().energies = energies;
    translation_.add(energies.translation);
    rotation_.add(energies.rotation);
    potential_.add(energies.potential);
    initial_momentum_ += bodies_.back().mass * wide(body.arc.path.velocity);
  }
  initial_ = present();
  for (const BookedBody& booked : bodies_) {
    heights_ += std::abs(booked.energies.potential);
  }
  scale_ = first_scale_ = initial_.translation + initial_.rotation + heights_;
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

void Ledger::round_energy(long double amount, long double bound) {
  energy_[Cause::rounding].add(amount);
  rounding_.add(std::abs(amount));
  bounds_.add(bound);
  if (amount != 0) {
    const auto share = static_cast<double>(std::abs(amount) / bound);
    worst_rounding_ = share <= worst_rounding_ ? worst_rounding_ : std::isnan(share) ? scene::never : share;
  }
}

Vector3<long double> Ledger::spin_momentum(std::size_t body, const Spin& spin) const {
  const BookedBody& booked = bodies_[body];
  if (!booked.is_polyhedron) {
    return booked.principal_inertia[0] * spin.rate;
  }
  const Matrix3<long double> axes = wide_rotation(spin.orientation);
  return axes * booked.principal_inertia.cwiseProduct(axes.transpose() * spin.rate);
}

Energies Ledger::energies_of(const Arc& arc, double time, std::size_t body, const Spin& spin) const {
  const BookedBody& booked = bodies_[body];
  return {booked.mass * wide_velocity_at(arc, time).squaredNorm() / 2, spin_momentum(body, spin).dot(spin.rate) / 2,
          -booked.mass * gravity_.dot(wide_position_at(arc, time))};
}

long double Ledger::size_of_heights(const Arc& arc, long double span, std::size_t body) const {
  const Wide terms = wide(arc.path.position).cwiseAbs() +
                     span * (wide(arc.path.velocity).cwiseAbs() + span / 2 * wide(arc.path.acceleration).cwiseAbs());
  return bodies_[body].mass * gravity_.cwiseAbs().dot(terms);
}

void Ledger::follow(const Arc& arc, double end, std::size_t body, const Spin& at_end) {
  const BookedBody& booked = bodies_[body];
  const long double span = static_cast<long double>(end) - arc.path.start;
  const Spin at_start{booked.orientation, wide(arc.turning.angular_velocity)};
  const Energies before = energies_of(arc, arc.path.start, body, at_start);
  const Energies after = energies_of(arc, end, body, at_end);
  const long double work =
      booked.mass * gravity_.dot(span * (wide(arc.path.velocity) + span / 2 * wide(arc.path.acceleration)));
  gravity_work_.add(work);
  long double by_causes = 0;
  if (arc.turning.phase != Phase::flying && scene::has_friction(scene_->law)) {
    for (const auto& [cause, amount] : work_of_resistance(*scene_, arc, span, body)) {
      energy_[cause].add(booked.mass * amount);
      by_causes += booked.mass * amount;
    }
  }
  const long double heights = roundings_of_ledger * of_long_double * size_of_heights(arc, span, body);
  round_energy((after.translation + after.rotation) - (before.translation + before.rotation) - work - by_causes,
               heights + rounding_of_motion(arc, span, booked.mass, booked.is_polyhedron,
                                            std::max(at_start.rate.norm(), at_end.rate.norm()), gravity_));
  round_energy(after.potential - before.potential + work, heights);
  translation_.add(after.translation - before.translation);
  rotation_.add(after.rotation - before.rotation);
  potential_.add(after.potential - before.potential);
  add(gravity_impulse_, booked.mass * span * gravity_);
  add(plane_impulse_, booked.mass * span * (wide(arc.path.acceleration) - gravity_));
}

void Ledger::record(const scene::Event& event) {
  long double gained = 0;
  Wide momentum = Wide::Zero();
  Wide angular = Wide::Zero();
  long double angular_size = 0;
  long double roundings = 0;
  const auto change = [&](const scene::Change& one) {
    BookedBody& booked = bodies_[one.body];
    const Wide rate = booked.is_polyhedron ? wide(one.angular_velocity_before) : spin_at(one.before, event.time);
    const Spin spin{one.orientation, rate};
    const Spin spin_after{one.orientation, wide(one.after.turning.angular_velocity)};
    follow(one.before, event.time, one.body, spin);
    const Energies before = energies_of(one.before, event.time, one.body, spin);
    const Energies after = energies_of(one.after, event.time, one.body, spin_after);
    booked.orientation = one.orientation;
    gained += (after.translation + after.rotation) - (before.translation + before.rotation);
    const long double span = static_cast<long double>(event.time) - one.before.path.start;
    round_energy(after.potential - before.potential,
                 roundings_of_position * of_double * size_of_heights(one.before, span, one.body));
    roundings += roundings_of_change(event, one, booked.mass, rate.norm(), spin_after.rate.norm());
    translation_.add(after.translation - before.translation);
    rotation_.add(after.rotation - before.rotation);
    potential_.add(after.potential - before.potential);
    const Wide v = wide_velocity_at(one.before, event.time);
    const Wide v_after = wide(one.after.path.velocity);
    momentum += booked.mass * (v_after - v);
    angular += booked.mass *
                   (wide(one.after.path.position).cross(v_after) - wide_position_at(one.before, event.time).cross(v)) +
               spin_momentum(one.body, spin_after) - spin_momentum(one.body, spin);
    angular_size += booked.mass * wide_position_at(one.before, event.time).norm() * v.norm();
  };
  change(event.a);
  if (event.b) {
    change(*event.b);
  }
  long double by_law = 0;
  const bool has_polyhedron = bodies_[event.a.body].is_polyhedron || (event.b && bodies_[event.b->body].is_polyhedron);
  if (event.has_impulse) {
    by_law = has_polyhedron ? work_of_impulse(event.collision, impulse_of(event.collision, event.outcome))
                            : energy_of_impact(scene_->law, event.collision);
    energy_[event.b ? Cause::impacts : Cause::plane_impacts].add(by_law);
  }
  if (event.was_slow) {
    const long double pushed = has_polyhedron ? work_of_sending_apart(event) : work_of_raised_speed(event);
    energy_[Cause::slow_contacts].add(pushed);
    by_law += pushed;
  }
  round_energy(gained - by_law,
               roundings * std::max(of_double, static_cast<long double>(unit_roundoff(scene_->precision))));
  if (event.kind == scene::EventKind::impact || event.kind == scene::EventKind::renewal) {
    add(momentum_rounding_, momentum);
    angular_rounding_.add(angular.norm());
    angular_scale_ = std::max(angular_scale_, angular_size);
  } else {
    add(plane_impulse_, momentum);
  }
  scale_ = std::max(scale_, translation_.sum() + rotation_.sum() + heights_);
}

long double Ledger::work_of_sending_apart(const scene::Event& event) const {
  Outcome<double> apart = event.outcome;
  apart.a.velocity = event.a.after.path.velocity;
  if (event.b) {
    apart.b.velocity = event.b->after.path.velocity;
  }
  const Collision before = with_velocities(event.collision, event.outcome);
  return work_of_impulse(before, impulse_of(before, apart));
}

long double Ledger::work_of_raised_speed(const scene::Event& event) const {
  const Wide n = wide(event.collision.normal).normalized();
  const auto speed = [&](const auto& a, const auto& b) { return n.dot(wide(a) - wide(b)); };
  const Vector3<double> still = Vector3<double>::Zero();
  const Vector3<double>& of_b = event.b ? event.b->after.path.velocity : still;
  const long double before = speed(event.outcome.a.velocity, event.outcome.b.velocity);
  const long double after = speed(event.a.after.path.velocity, of_b);
  long double inverse_mass = 1 / bodies_[event.a.body].mass;
  inverse_mass += event.b ? 1 / bodies_[event.b->body].mass : 0;
  return (after * after - before * before) / (2 * inverse_mass);
}

void Ledger::close(const scene::SceneState& state) {
  for (std::size_t i = 0; i < state.bodies.size(); ++i) {
    const scene::BodyState& body = state.bodies[i];
    follow(body.arc, state.time, i, {body.orientation, wide(body.angular_velocity)});
  }
}

}  // namespace carom::properties
