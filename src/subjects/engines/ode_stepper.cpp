// SPDX-License-Identifier: BSL-1.0
#include <array>
#include <string>
#include <utility>
#include <vector>

#include <carom/subjects/engines/advance.hpp>
#include <carom/subjects/engines/claims.hpp>
#include <carom/subjects/engines/ode_handles.hpp>
#include <carom/subjects/steppers.hpp>

namespace carom::subjects {
namespace {

using Space = std::unique_ptr<dxSpace, ode::Destroy<dSpaceDestroy>>;
using Joints = std::unique_ptr<dxJointGroup, ode::Destroy<dJointGroupDestroy>>;

/// ODE has no materials: each contact gets the coefficients of the scene. Configured, contacts are hard (CFM 0), and μ
/// limits the ratio of the friction impulse to the normal impulse.
class World {
 public:
  World(const Stepping& stepping, bool configured, dThreadingImplementationID threading)
      : stepping_(stepping), configured_(configured) {
    dWorldSetStepThreadingImplementation(world_.get(), dThreadingImplementationGetFunctions(threading), threading);
    const Vector3<double>& gravity = stepping.scene.gravity;
    dWorldSetGravity(world_.get(), gravity.x(), gravity.y(), gravity.z());
    if (configured) {
      dWorldSetCFM(world_.get(), 0);
    }
    for (const SteppedBody& one : stepping.scene.bodies) {
      add(one);
    }
  }

  void step() {
    dSpaceCollide(space_.get(), this, &World::collide);
    dWorldStep(world_.get(), stepping_.step);
    dJointGroupEmpty(joints_.get());
  }

  [[nodiscard]] BodyState state(std::size_t i) const {
    const dBodyID body = bodies_[i];
    using Numbers = Eigen::Map<const Vector3<double>>;
    return {Numbers(dBodyGetPosition(body)), Eigen::Map<const Quaternion<double>>(dBodyGetQuaternion(body)),
            Numbers(dBodyGetLinearVel(body)), Numbers(dBodyGetAngularVel(body))};
  }

 private:
  void add(const SteppedBody& one) {
    const Vector3<double>& at = one.state.position;
    dGeomID geometry = nullptr;
    if (const auto* const sphere = std::get_if<SphereShape>(&one.shape)) {
      geometry = dCreateSphere(space_.get(), sphere->radius);
    } else if (const auto* const box = std::get_if<BoxShape>(&one.shape)) {
      geometry = dCreateBox(space_.get(), box->lengths.x(), box->lengths.y(), box->lengths.z());
    } else {
      const Vector3<double> n = unit(std::get<HalfSpaceShape>(one.shape).normal);
      dCreatePlane(space_.get(), n.x(), n.y(), n.z(), n.dot(at));
      bodies_.push_back(nullptr);
      return;
    }
    const Quaternion<double> q = unit(one.state.orientation);
    if (one.is_fixed) {
      dGeomSetPosition(geometry, at.x(), at.y(), at.z());
      dGeomSetQuaternion(geometry, q.data());
      bodies_.push_back(nullptr);
      return;
    }
    const dBodyID body = dBodyCreate(world_.get());  // the world destroys it
    dMass mass;
    dMassSetParameters(&mass, one.mass, 0, 0, 0, one.principal_inertia.x(), one.principal_inertia.y(),
                       one.principal_inertia.z(), 0, 0, 0);
    dBodySetMass(body, &mass);
    dBodySetQuaternion(body, q.data());
    dBodySetPosition(body, at.x(), at.y(), at.z());
    dBodySetLinearVel(body, one.state.velocity.x(), one.state.velocity.y(), one.state.velocity.z());
    dBodySetAngularVel(body, one.state.angular_velocity.x(), one.state.angular_velocity.y(),
                       one.state.angular_velocity.z());
    dGeomSetBody(geometry, body);
    bodies_.push_back(body);
  }

  static void collide(void* data, dGeomID a, dGeomID b) {
    const World& self = *static_cast<const World*>(data);
    std::array<dContact, 8> contacts{};
    const int count = dCollide(a, b, static_cast<int>(contacts.size()), &contacts[0].geom, sizeof(dContact));
    for (int i = 0; i < count; ++i) {
      dSurfaceParameters& surface = contacts[static_cast<std::size_t>(i)].surface;
      surface.mode = dContactBounce | (self.configured_ ? dContactApprox1 : 0);
      surface.mu = self.stepping_.scene.friction;
      surface.bounce = self.stepping_.scene.restitution;
      dJointAttach(dJointCreateContact(self.world_.get(), self.joints_.get(), &contacts[static_cast<std::size_t>(i)]),
                   dGeomGetBody(a), dGeomGetBody(b));
    }
  }

  const Stepping& stepping_;
  bool configured_;
  ode::World world_{dWorldCreate()};
  Space space_{dSimpleSpaceCreate(nullptr)};
  Joints joints_{dJointGroupCreate(0)};
  std::vector<dBodyID> bodies_;
};

SteppingAnswer stepped(const Stepping& stepping, bool configured) {
  ode::enter_thread();
  ode::Threading threading(dThreadingAllocateSelfThreadedImplementation());
  try {
    return advanced(stepping, [&] { return World(stepping, configured, threading.get()); });
  } catch (const ode::AssertionFailed& failure) {
    static_cast<void>(threading.release());  // ODE does not permit freeing it in the middle of a step
    return Failed{std::string("ODE: ") + failure.what()};
  }
}

}  // namespace

std::vector<Stepper> ode_steppers() {
  Stepper facts{"ode"};
  facts.version = dODE_VERSION;
  facts.cannot = {"continuous"};
  return both_settings(facts, stepped);
}

}  // namespace carom::subjects
