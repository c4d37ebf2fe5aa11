// SPDX-License-Identifier: BSL-1.0
#include <cmath>
#include <deque>
#include <memory>

#include <btBulletDynamicsCommon.h>

#include <carom/subjects/engines/advance.hpp>
#include <carom/subjects/engines/bullet_contact.hpp>

namespace carom::subjects {
namespace {

using bullet::to_bullet;
using V = Vector3<double>;

/// Bullet multiplies the coefficients of the two bodies, so each body gets the root. Configured, the restitution has no
/// threshold, contacts begin at a distance of 0, bodies never sleep, and friction has two directions.
class World {
 public:
  World(const Stepping& stepping, bool configured) : stepping_(stepping), configured_(configured) {
    world_.setGravity(to_bullet(stepping.scene.gravity));
    if (configured) {
      world_.getSolverInfo().m_restitutionVelocityThreshold = 0;
      world_.getSolverInfo().m_splitImpulsePenetrationThreshold = 0;
      world_.getSolverInfo().m_numIterations = 50;
      world_.getSolverInfo().m_solverMode |= SOLVER_USE_2_FRICTION_DIRECTIONS;
    }
  }

  void add(const SteppedBody& one) {
    btCollisionShape* const shape = with_shape(
        one.shape, [&](double radius) { return shapes_.emplace_back(std::make_unique<btSphereShape>(radius)).get(); },
        [&](const V& half) { return shapes_.emplace_back(std::make_unique<btBoxShape>(to_bullet(half))).get(); },
        [&](const V& n) { return shapes_.emplace_back(std::make_unique<btStaticPlaneShape>(to_bullet(n), 0)).get(); });
    btRigidBody& body =
        bodies_.emplace_back(bullet::body_of(one, one.state, unit(one.state.orientation), one.is_fixed, shape));
    body.setRestitution(std::sqrt(stepping_.scene.restitution));
    body.setFriction(std::sqrt(stepping_.scene.friction));
    if (stepping_.scene.is_continuous && !one.is_fixed) {
      const auto* const box = std::get_if<BoxShape>(&one.shape);
      const double least_extent = box ? box->lengths.minCoeff() / 2 : std::get<SphereShape>(one.shape).radius;
      body.setCcdMotionThreshold(least_extent / 10);
      body.setCcdSweptSphereRadius(least_extent * 0.9);
    }
    body.setActivationState(configured_ ? DISABLE_DEACTIVATION : ACTIVE_TAG);
    body.setContactProcessingThreshold(configured_ ? 0 : BT_LARGE_FLOAT);
    world_.addRigidBody(&body);
  }

  void step() { world_.stepSimulation(stepping_.step, 0); }

  [[nodiscard]] BodyState state(std::size_t i) const {
    const btRigidBody& body = bodies_[i];
    const btQuaternion q = body.getWorldTransform().getRotation();
    return {bullet::from_bullet<double>(body.getWorldTransform().getOrigin()),
            Quaternion<double>(q.w(), q.x(), q.y(), q.z()), bullet::from_bullet<double>(body.getLinearVelocity()),
            bullet::from_bullet<double>(body.getAngularVelocity())};
  }

 private:
  const Stepping& stepping_;
  bool configured_;
  std::vector<std::unique_ptr<btCollisionShape>> shapes_;
  std::deque<btRigidBody> bodies_;  // the world, which ends first, looks at them
  btDefaultCollisionConfiguration configuration_;
  btCollisionDispatcher dispatcher_{&configuration_};
  btDbvtBroadphase broadphase_;
  btSequentialImpulseConstraintSolver solver_;
  btDiscreteDynamicsWorld world_{&dispatcher_, &broadphase_, &solver_, &configuration_};
};

}  // namespace

std::vector<Stepper> bullet_steppers() {
  return both_settings<World>({.name = "bullet", .version = bullet::version()});
}

}  // namespace carom::subjects
