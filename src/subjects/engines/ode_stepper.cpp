// SPDX-License-Identifier: BSL-1.0
#include <carom/subjects/engines/advance.hpp>
#include <carom/subjects/engines/ode_handles.hpp>

namespace carom::subjects {
namespace {

using V = Vector3<double>;

/// ODE has no materials: each contact gets the coefficients of the scene. Configured, contacts are hard (CFM 0), and μ
/// limits the ratio of the friction impulse to the normal impulse.
class World {
 public:
  World(const Stepping& stepping, bool configured) : stepping_(stepping), configured_(configured) {
    const V& gravity = stepping.scene.gravity;
    dWorldSetGravity(world_.get(), gravity.x(), gravity.y(), gravity.z());
    dWorldSetCFM(world_.get(), configured ? 0 : dWorldGetCFM(world_.get()));
  }

  void add(const SteppedBody& one) {
    const dGeomID geometry = with_shape(
        one.shape, [&](double radius) { return dCreateSphere(space_.get(), radius); },
        [&](const V& half) { return dCreateBox(space_.get(), 2 * half.x(), 2 * half.y(), 2 * half.z()); },
        [&](const V& n) { return dCreatePlane(space_.get(), n.x(), n.y(), n.z(), n.dot(one.state.position)); });
    const bool is_plane = std::holds_alternative<HalfSpaceShape>(one.shape);
    const dBodyID body = bodies_.emplace_back(is_plane ? nullptr : dBodyCreate(world_.get()));
    if (is_plane) {
      return;
    }
    ode::set_mass(body, one, one.state.orientation);
    ode::set_motion(body, one.state);
    dGeomSetBody(geometry, body);
    if (one.is_fixed) {
      dBodySetKinematic(body);
    }
  }

  void step() {
    dSpaceCollide(space_.get(), this, &World::collide);
    ode::step(world_, stepping_.step, threading_);
    dJointGroupEmpty(joints_.get());
  }

  [[nodiscard]] BodyState state(std::size_t i) const {
    const dBodyID body = bodies_[i];
    return {ode::from_ode(dBodyGetPosition(body)), Eigen::Map<const Quaternion<double>>(dBodyGetQuaternion(body)),
            ode::from_ode(dBodyGetLinearVel(body)), ode::from_ode(dBodyGetAngularVel(body))};
  }

 private:
  static void collide(void* data, dGeomID a, dGeomID b) {
    const World& self = *static_cast<const World*>(data);
    dContact contacts[8] = {};
    const int count = dCollide(a, b, 8, &contacts[0].geom, sizeof(dContact));
    for (int i = 0; i < count; ++i) {
      contacts[i].surface.mode = dContactBounce | (self.configured_ ? dContactApprox1 : 0);
      contacts[i].surface.mu = self.stepping_.scene.friction;
      contacts[i].surface.bounce = self.stepping_.scene.restitution;
      dJointAttach(dJointCreateContact(self.world_.get(), self.joints_.get(), &contacts[i]), dGeomGetBody(a),
                   dGeomGetBody(b));
    }
  }

  const Stepping& stepping_;
  bool configured_;
  ode::Threading threading_ = ode::own_threading();
  ode::World world_ = ode::world_with(threading_);
  ode::Space space_{dSimpleSpaceCreate(nullptr)};
  ode::Joints joints_{dJointGroupCreate(0)};
  std::vector<dBodyID> bodies_;  // the world destroys them
};

}  // namespace

std::vector<Stepper> ode_steppers() {
  return both_settings<World>({.name = "ode", .version = dODE_VERSION, .cannot = {"continuous"}});
}

}  // namespace carom::subjects
