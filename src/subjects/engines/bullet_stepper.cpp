// SPDX-License-Identifier: BSL-1.0
#include <cmath>
#include <memory>

#include <btBulletDynamicsCommon.h>

#include <carom/subjects/engines/advance.hpp>
#include <carom/subjects/engines/bullet_contact.hpp>

namespace carom::subjects {
namespace {

using bullet::to_bullet;

Vector3<double> vector_of(const btVector3& v) { return {v.x(), v.y(), v.z()}; }

/// Bullet multiplies the coefficients of the two bodies, so each body gets the root. Configured, the restitution has no
/// threshold, contacts begin at a distance of 0, bodies never sleep, and friction has two directions.
class World {
 public:
  World(const Stepping& stepping, bool configured) : step_(stepping.step) {
    const SteppedScene& scene = stepping.scene;
    world_.setGravity(to_bullet(scene.gravity));
    if (configured) {
      world_.getSolverInfo().m_restitutionVelocityThreshold = 0;
      world_.getSolverInfo().m_splitImpulsePenetrationThreshold = 0;
      world_.getSolverInfo().m_numIterations = 50;
      world_.getSolverInfo().m_solverMode |= SOLVER_USE_2_FRICTION_DIRECTIONS;
    }
    for (const SteppedBody& one : scene.bodies) {
      const auto* const sphere = std::get_if<SphereShape>(&one.shape);
      const auto* const box = std::get_if<BoxShape>(&one.shape);
      if (sphere != nullptr) {
        shapes_.push_back(std::make_unique<btSphereShape>(sphere->radius));
      } else if (box != nullptr) {
        shapes_.push_back(std::make_unique<btBoxShape>(to_bullet(box->lengths / 2)));
      } else {
        const Vector3<double> normal = unit(std::get<HalfSpaceShape>(one.shape).normal);
        shapes_.push_back(std::make_unique<btStaticPlaneShape>(to_bullet(normal), 0));
      }
      btRigidBody::btRigidBodyConstructionInfo info(one.is_fixed ? 0 : one.mass, nullptr, shapes_.back().get(),
                                                    to_bullet(one.principal_inertia));
      const Quaternion<double> q = unit(one.state.orientation);
      info.m_startWorldTransform.setRotation({q[1], q[2], q[3], q[0]});
      info.m_startWorldTransform.setOrigin(to_bullet(one.state.position));
      btRigidBody* const body = bodies_.emplace_back(std::make_unique<btRigidBody>(info)).get();
      body->setRestitution(std::sqrt(scene.restitution));
      body->setFriction(std::sqrt(scene.friction));
      body->setLinearVelocity(to_bullet(one.state.velocity));
      body->setAngularVelocity(to_bullet(one.state.angular_velocity));
      if (scene.is_continuous && !one.is_fixed) {
        const double least_extent = sphere != nullptr ? sphere->radius : box->lengths.minCoeff() / 2;
        body->setCcdMotionThreshold(least_extent / 10);
        body->setCcdSweptSphereRadius(least_extent * 0.9);
      }
      if (configured) {
        body->setActivationState(DISABLE_DEACTIVATION);
        body->setContactProcessingThreshold(0);
      }
      world_.addRigidBody(body);
    }
  }

  void step() { world_.stepSimulation(step_, 0); }

  [[nodiscard]] BodyState state(std::size_t i) const {
    const btRigidBody& body = *bodies_[i];
    const btQuaternion q = body.getWorldTransform().getRotation();
    return {vector_of(body.getWorldTransform().getOrigin()), Quaternion<double>(q.w(), q.x(), q.y(), q.z()),
            vector_of(body.getLinearVelocity()), vector_of(body.getAngularVelocity())};
  }

 private:
  double step_;
  std::vector<std::unique_ptr<btCollisionShape>> shapes_;
  std::vector<std::unique_ptr<btRigidBody>> bodies_;  // the world, which ends first, looks at them
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
