// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <memory>
#include <string>

#include <BulletCollision/NarrowPhaseCollision/btPersistentManifold.h>
#include <BulletDynamics/ConstraintSolver/btSequentialImpulseConstraintSolver.h>
#include <BulletDynamics/Dynamics/btRigidBody.h>

#include <carom/subjects/engines/claims.hpp>
#include <carom/subjects/session.hpp>

/// Poses a collision to Bullet, in the precision of btScalar (set by BT_USE_DOUBLE_PRECISION). A program can contain
/// only one build of Bullet.
namespace carom::subjects::bullet {

inline std::string version() {
  return std::to_string(btGetVersion() / 100) + '.' + std::to_string(btGetVersion() % 100);
}

inline btVector3 to_bullet(const Vector3<double>& v) {
  return {static_cast<btScalar>(v.x()), static_cast<btScalar>(v.y()), static_cast<btScalar>(v.z())};
}

template <class Real = long double>
Vector3<Real> from_bullet(const btVector3& v) {
  return {v.x(), v.y(), v.z()};
}

struct Settings {
  btContactSolverInfo solver;  // defaults of the engine, step 1/60 s
  bool gyroscopic = true;
  bool friction = false;
};

/// ERP, split impulse and warm start have no effect on a new contact of depth 0. As shipped, the solver makes ten
/// iterations, with one direction of friction.
inline Settings settings_of(const EngineSetting& setting) {
  Settings settings;
  settings.friction = setting.law == Law::coulomb;
  if (setting.configured) {
    settings.solver.m_restitutionVelocityThreshold = 0;
    settings.gyroscopic = false;
    if (settings.friction) {
      settings.solver.m_solverMode |= SOLVER_USE_2_FRICTION_DIRECTIONS;
      settings.solver.m_numIterations = 200;
    }
  }
  return settings;
}

/// `Facts` is a `Body` or a `SteppedBody`, and `State` a `Body` or a `BodyState`. The orientation has unit length.
template <class Facts, class State>
btRigidBody body_of(const Facts& facts, const State& state, const Quaternion<double>& orientation, bool is_immovable,
                    btCollisionShape* shape) {
  btRigidBody::btRigidBodyConstructionInfo info(static_cast<btScalar>(is_immovable ? 0 : facts.mass), nullptr, shape);
  info.m_startWorldTransform.setOrigin(to_bullet(state.position));
  const auto scalar = [&](int i) { return static_cast<btScalar>(orientation[i]); };
  info.m_startWorldTransform.setRotation({scalar(1), scalar(2), scalar(3), scalar(0)});
  if (!is_immovable) {
    info.m_localInertia = to_bullet(facts.principal_inertia);
  }
  btRigidBody made(info);
  made.setLinearVelocity(to_bullet(state.velocity));
  made.setAngularVelocity(to_bullet(state.angular_velocity));
  return made;
}

/// An immovable body is kinematic, so that its velocity enters the contact.
inline btRigidBody make_body(const Body& body, const Settings& settings) {
  const Quaternion<double> orientation = body.immovable ? Quaternion<double>(1, 0, 0, 0) : unit(body.orientation);
  btRigidBody made = body_of(body, body, orientation, body.immovable, nullptr);
  if (body.immovable) {
    made.setCollisionFlags(btCollisionObject::CF_KINEMATIC_OBJECT);
  }
  if (!settings.gyroscopic) {
    made.setFlags(0);
  }
  return made;
}

/// The contact has depth 0, because a Collision has no depth.
inline btManifoldPoint make_contact(const Collision& collision, const Settings& settings) {
  const btVector3 local(0, 0, 0);  // the contact point in body axes, which the solver does not read
  btManifoldPoint contact(local, local, to_bullet(unit(collision.normal)), 0);
  contact.m_positionWorldOnA = contact.m_positionWorldOnB = to_bullet(collision.point);
  contact.m_combinedRestitution = static_cast<btScalar>(collision.restitution);
  contact.m_combinedFriction = settings.friction ? static_cast<btScalar>(collision.friction) : 0;
  return contact;
}

inline BodyVelocity<long double> velocity_of(const btRigidBody& body) {
  return {from_bullet(body.getLinearVelocity()), from_bullet(body.getAngularVelocity())};
}

inline Answer solve(const Collision& collision, const Settings& settings, btSequentialImpulseConstraintSolver& solver) {
  btRigidBody a = make_body(collision.a, settings);
  btRigidBody b = make_body(collision.b, settings);
  a.setWorldArrayIndex(0);  // a build with BT_THREADSAFE identifies kinematic bodies by this index
  b.setWorldArrayIndex(1);
  btPersistentManifold manifold(&a, &b, 0, 0, 0);
  manifold.addManifoldPoint(make_contact(collision, settings));
  btCollisionObject* bodies[] = {&a, &b};
  btPersistentManifold* manifolds[] = {&manifold};
  solver.solveGroup(bodies, 2, manifolds, 1, nullptr, 0, settings.solver, nullptr, nullptr);
  return ReportedOutcome{velocity_of(a), velocity_of(b)};
}

inline Session session_with(const Settings& settings) {
  return session_of([settings, solver = std::make_shared<btSequentialImpulseConstraintSolver>()](
                        const Collision& collision) { return solve(collision, settings, *solver); });
}

}  // namespace carom::subjects::bullet
