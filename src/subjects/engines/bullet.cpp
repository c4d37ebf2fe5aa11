// SPDX-License-Identifier: BSL-1.0
#include <memory>
#include <type_traits>

#include <BulletCollision/NarrowPhaseCollision/btPersistentManifold.h>
#include <BulletDynamics/ConstraintSolver/btSequentialImpulseConstraintSolver.h>
#include <BulletDynamics/Dynamics/btRigidBody.h>

#include <carom/subjects/engines/claims.hpp>
#include <carom/subjects/engines/engines.hpp>
#include <carom/subjects/engines/unit.hpp>
#include <carom/subjects/session.hpp>

namespace carom::subjects {
namespace {

static_assert(std::is_same_v<btScalar, double>, "needs the double build of Bullet, bullet-float64");

btVector3 to_bullet(const Vector3<double>& v) { return {v.x(), v.y(), v.z()}; }

Vector3<long double> from_bullet(const btVector3& v) { return {v.x(), v.y(), v.z()}; }

/// As shipped.
struct Settings {
  btContactSolverInfo solver;  // step 1/60 s
  bool gyroscopic = true;
};

/// ERP, split impulse and warm start need no change: a new contact of depth 0 leaves them nothing to act on.
Settings configured() {
  Settings settings;
  settings.solver.m_restitutionVelocityThreshold = 0;
  settings.gyroscopic = false;
  return settings;
}

/// An immovable body is a kinematic one: unlike a static body it may have a velocity, which enters the contact.
btRigidBody make_body(const Body& body, const Settings& settings) {
  btRigidBody::btRigidBodyConstructionInfo info(body.immovable ? 0 : body.mass, nullptr, nullptr);
  info.m_startWorldTransform.setOrigin(to_bullet(body.position));
  if (!body.immovable) {
    info.m_localInertia = to_bullet(body.principal_inertia);
    const Quaternion<double> q = unit(body.orientation);
    info.m_startWorldTransform.setRotation({q[1], q[2], q[3], q[0]});
  }
  btRigidBody made(info);
  if (body.immovable) {
    made.setCollisionFlags(btCollisionObject::CF_KINEMATIC_OBJECT);
  }
  if (!settings.gyroscopic) {
    made.setFlags(0);
  }
  made.setLinearVelocity(to_bullet(body.velocity));
  made.setAngularVelocity(to_bullet(body.angular_velocity));
  return made;
}

/// Depth 0, for the protocol has none. Friction 0, for the model has none.
btManifoldPoint make_contact(const Collision& collision) {
  const btVector3 local(0, 0, 0);  // the point in the frame of a body, which the solver does not read
  btManifoldPoint contact(local, local, to_bullet(unit(collision.normal)), 0);
  contact.m_positionWorldOnA = contact.m_positionWorldOnB = to_bullet(collision.point);
  contact.m_combinedRestitution = collision.restitution;
  return contact;
}

BodyVelocity<long double> velocity_of(const btRigidBody& body) {
  return {from_bullet(body.getLinearVelocity()), from_bullet(body.getAngularVelocity())};
}

Answer solve(const Collision& collision, const Settings& settings, btSequentialImpulseConstraintSolver& solver) {
  btRigidBody a = make_body(collision.a, settings);
  btRigidBody b = make_body(collision.b, settings);
  a.setWorldArrayIndex(0);  // a build with BT_THREADSAFE tells kinematic bodies apart by it
  b.setWorldArrayIndex(1);
  btPersistentManifold manifold(&a, &b, 0, 0, 0);
  manifold.addManifoldPoint(make_contact(collision));
  btCollisionObject* bodies[] = {&a, &b};
  btPersistentManifold* manifolds[] = {&manifold};
  solver.solveGroup(bodies, 2, manifolds, 1, nullptr, 0, settings.solver, nullptr, nullptr);
  return ReportedOutcome{velocity_of(a), velocity_of(b)};
}

Session session_with(const Settings& settings) {
  return session_of([settings, solver = std::make_shared<btSequentialImpulseConstraintSolver>()](
                        const Collision& collision) { return solve(collision, settings, *solver); });
}

}  // namespace

std::vector<Subject> bullet_subjects() {
  std::vector<Subject> subjects = bullet_claims();
  subjects[0].open = [] { return session_with(configured()); };
  subjects[1].open = [] { return session_with({}); };
  return subjects;
}

}  // namespace carom::subjects
