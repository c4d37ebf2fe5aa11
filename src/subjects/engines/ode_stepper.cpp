// SPDX-License-Identifier: BSL-1.0
#include <algorithm>
#include <array>

#include <carom/subjects/engines/advance.hpp>
#include <carom/subjects/engines/ode_handles.hpp>

namespace carom::subjects {
namespace {

using Space = std::unique_ptr<dxSpace, ode::Destroy<dSpaceDestroy>>;
using Joints = std::unique_ptr<dxJointGroup, ode::Destroy<dJointGroupDestroy>>;
using Numbers = Eigen::Map<const Vector3<double>>;

/// ODE has no materials: each contact gets the coefficients of the scene. Configured, contacts are hard (CFM 0), and μ
/// limits the ratio of the friction impulse to the normal impulse.
class World {
 public:
  World(const Stepping& stepping, bool configured)
      : scene_(stepping.scene), step_(stepping.step), configured_(configured) {
    dWorldSetStepThreadingImplementation(world_.get(), dThreadingImplementationGetFunctions(threading_.get()),
                                         threading_.get());
    dWorldSetGravity(world_.get(), scene_.gravity.x(), scene_.gravity.y(), scene_.gravity.z());
    dWorldSetCFM(world_.get(), configured ? 0 : dWorldGetCFM(world_.get()));
    std::for_each(scene_.bodies.begin(), scene_.bodies.end(), [&](const SteppedBody& one) { add(one); });
  }

  void step() try {
    dSpaceCollide(space_.get(), this, &World::collide);
    dWorldStep(world_.get(), step_);
    dJointGroupEmpty(joints_.get());
  } catch (const ode::AssertionFailed&) {
    static_cast<void>(threading_.release());
    throw;
  }

  [[nodiscard]] BodyState state(std::size_t i) const {
    const dBodyID body = bodies_[i];
    return {Numbers(dBodyGetPosition(body)), Eigen::Map<const Quaternion<double>>(dBodyGetQuaternion(body)),
            Numbers(dBodyGetLinearVel(body)), Numbers(dBodyGetAngularVel(body))};
  }

 private:
  void add(const SteppedBody& one) {
    const Vector3<double>& at = one.state.position;
    dBodyID& body = bodies_.emplace_back(nullptr);
    dGeomID geometry = nullptr;
    if (const auto* const sphere = std::get_if<SphereShape>(&one.shape)) {
      geometry = dCreateSphere(space_.get(), sphere->radius);
    } else if (const auto* const box = std::get_if<BoxShape>(&one.shape)) {
      geometry = dCreateBox(space_.get(), box->lengths.x(), box->lengths.y(), box->lengths.z());
    } else {
      const Vector3<double> n = unit(std::get<HalfSpaceShape>(one.shape).normal);
      dCreatePlane(space_.get(), n.x(), n.y(), n.z(), n.dot(at));
      return;
    }
    body = dBodyCreate(world_.get());  // the world destroys it
    dMass mass;
    const Vector3<double>& moments = one.principal_inertia;
    dMassSetParameters(&mass, one.mass, 0, 0, 0, moments.x(), moments.y(), moments.z(), 0, 0, 0);
    dBodySetMass(body, &mass);
    dBodySetQuaternion(body, unit(one.state.orientation).data());
    const auto set = [&](auto setter, const Vector3<double>& v) { setter(body, v.x(), v.y(), v.z()); };
    set(dBodySetPosition, at);
    set(dBodySetLinearVel, one.state.velocity);
    set(dBodySetAngularVel, one.state.angular_velocity);
    dGeomSetBody(geometry, body);
    if (one.is_fixed) {
      dBodySetKinematic(body);
    }
  }

  static void collide(void* data, dGeomID a, dGeomID b) {
    const World& self = *static_cast<const World*>(data);
    std::array<dContact, 8> contacts{};
    const int count = dCollide(a, b, static_cast<int>(contacts.size()), &contacts[0].geom, sizeof(dContact));
    for (std::size_t i = 0; i < static_cast<std::size_t>(count); ++i) {
      dSurfaceParameters& surface = contacts[i].surface;
      surface.mode = dContactBounce | (self.configured_ ? dContactApprox1 : 0);
      surface.mu = self.scene_.friction;
      surface.bounce = self.scene_.restitution;
      dJointAttach(dJointCreateContact(self.world_.get(), self.joints_.get(), &contacts[i]), dGeomGetBody(a),
                   dGeomGetBody(b));
    }
  }

  const SteppedScene& scene_;
  double step_;
  bool configured_;
  ode::Threading threading_ = ode::own_threading();
  ode::World world_{dWorldCreate()};
  Space space_{dSimpleSpaceCreate(nullptr)};
  Joints joints_{dJointGroupCreate(0)};
  std::vector<dBodyID> bodies_;
};

}  // namespace

std::vector<Stepper> ode_steppers() {
  return both_settings<World>({.name = "ode", .version = dODE_VERSION, .cannot = {"continuous"}});
}

}  // namespace carom::subjects
