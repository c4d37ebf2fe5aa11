// SPDX-License-Identifier: BSL-1.0
#include <cmath>

#include <box2d/box2d.h>
#include <fmt/format.h>

#include <carom/subjects/engines/advance.hpp>

namespace carom::subjects {
namespace {

using V = Vector3<double>;

b2Vec2 to_box2d(const V& v) { return {static_cast<float>(v.x()), static_cast<float>(v.y())}; }

/// Box2D mixes friction by the geometric mean, and restitution by the maximum. A half-space is a box of 200 m. Box2D
/// stops a bounce below its threshold of 1 m/s. Configured, the fixture's threshold is 0, and bodies do not sleep.
class World {
 public:
  World(const Stepping& stepping, bool configured) : stepping_(stepping), configured_(configured) {
    world_.SetContinuousPhysics(stepping.scene.is_continuous);
  }

  void add(const SteppedBody& one) {
    b2BodyDef definition;
    definition.type = one.is_fixed ? b2_staticBody : b2_dynamicBody;
    definition.position = to_box2d(one.state.position);
    definition.angle = static_cast<float>(2 * std::atan2(one.state.orientation[3], one.state.orientation[0]));
    definition.linearVelocity = to_box2d(one.state.velocity);
    definition.angularVelocity = static_cast<float>(one.state.angular_velocity.z());
    definition.allowSleep = !configured_;
    definition.bullet = stepping_.scene.is_continuous;
    b2CircleShape circle;
    b2PolygonShape polygon;
    b2FixtureDef fixture;
    with_shape(
        one.shape, [&](double radius) { circle.m_radius = static_cast<float>(radius); },
        [&](const V& half) { polygon.SetAsBox(static_cast<float>(half.x()), static_cast<float>(half.y())); },
        [&](const V& n) {
          definition.angle = static_cast<float>(std::atan2(n.y(), n.x()) - std::atan2(1.0, 0.0));
          definition.position = to_box2d(one.state.position - 100 * n);
          polygon.SetAsBox(100, 100);
        });
    fixture.shape = circle.m_radius > 0 ? static_cast<b2Shape*>(&circle) : &polygon;
    fixture.friction = static_cast<float>(stepping_.scene.friction);
    fixture.restitution = static_cast<float>(stepping_.scene.restitution);
    fixture.restitutionThreshold = configured_ ? 0 : fixture.restitutionThreshold;
    b2Body* const body = bodies_.emplace_back(world_.CreateBody(&definition));
    body->CreateFixture(&fixture);
    const b2MassData mass{static_cast<float>(one.mass), {0, 0}, static_cast<float>(one.principal_inertia.z())};
    body->SetMassData(&mass);  // of a fixed body, Box2D ignores it
  }

  void step() { world_.Step(static_cast<float>(stepping_.step), 8, 3); }  // the iterations of Box2D's manual

  [[nodiscard]] BodyState state(std::size_t i) const {
    const b2Body& body = *bodies_[i];
    const double half = body.GetAngle() / 2.0;
    return {{body.GetPosition().x, body.GetPosition().y, 0},
            {std::cos(half), 0, 0, std::sin(half)},
            {body.GetLinearVelocity().x, body.GetLinearVelocity().y, 0},
            {0, 0, body.GetAngularVelocity()}};
  }

 private:
  const Stepping& stepping_;
  bool configured_;
  b2World world_{to_box2d(stepping_.scene.gravity)};
  std::vector<b2Body*> bodies_;  // the world destroys them
};

}  // namespace

std::vector<Stepper> box2d_steppers() {
  std::string version = fmt::format("{}.{}.{}", b2_version.major, b2_version.minor, b2_version.revision);
  return both_settings<World>(
      {.name = "box2d", .version = std::move(version), .precision = Precision::binary32, .is_planar = true});
}

}  // namespace carom::subjects
