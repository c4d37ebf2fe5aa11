// SPDX-License-Identifier: BSL-1.0
#include <cmath>
#include <functional>
#include <limits>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include <carom/scene/polyhedra/polyhedron_simulation.hpp>
#include <carom/scene/polyhedra/valid_polyhedra.hpp>

#include "bodies.hpp"
#include "scene/scenes.hpp"

namespace carom::scene {
namespace {

using carom::unit::add_plane;
using carom::unit::add_polyhedron;
using carom::unit::add_sphere;
using carom::unit::centred_box;
using unit::Vector;

Scene three() {
  Scene scene = carom::unit::empty_scene(Law::frictionless, {1, 0, 0, 0, 0}, 1);
  add_plane(scene, {0, 0, 2}, {0, 0, -1});
  add_polyhedron(scene, centred_box({1, 1, 1}), {0, 0, 0});
  add_polyhedron(scene, centred_box({1, 1, 1}), {2, 0, 0});
  add_sphere(scene, 0.25, {0, 2, 0}, {0, 0, 0});
  return scene;
}

std::string defect_of(const Scene& scene) {
  const std::optional<SceneDefect> defect = first_polyhedron_defect(scene);
  return defect ? describe(*defect) : "";
}

TEST(ValidPolyhedra, AreNamedWithTheFieldThatIsWrong) {
  ASSERT_EQ(defect_of(three()), "") << "else everything is refused";
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const std::vector<std::pair<std::string, std::function<void(Scene&)>>> changes{
      {"polyhedra[1].density: expected a number greater than 0", [](Scene& s) { s.polyhedra[1].density = 0; }},
      {"polyhedra[1].density: expected a number greater than 0", [nan](Scene& s) { s.polyhedra[1].density = nan; }},
      {"polyhedra[0].density: expected a number greater than 0", [](Scene& s) { s.polyhedra[0].density = never; }},
      {"polyhedra[0].material: expected an index of a material", [](Scene& s) { s.polyhedra[0].material = 1; }},
      {"polyhedra[0].position: expected finite numbers", [nan](Scene& s) { s.polyhedra[0].position.y() = nan; }},
      {"polyhedra[1].velocity: expected finite numbers", [](Scene& s) { s.polyhedra[1].velocity.z() = -never; }},
      {"polyhedra[0].angular_velocity: expected finite numbers",
       [nan](Scene& s) { s.polyhedra[0].angular_velocity.x() = nan; }},
      {"polyhedra[0].orientation: expected four finite numbers w, x, y, z that are not all 0",
       [](Scene& s) {
         s.polyhedra[0].orientation = {0, 0, 0, 0};
       }},
      {"polyhedra[0].orientation: expected four finite numbers w, x, y, z that are not all 0",
       [nan](Scene& s) { s.polyhedra[0].orientation[3] = nan; }},
      {"polyhedra[1].vertices: a polyhedron needs at least 4 vertices, not 3",
       [](Scene& s) { s.polyhedra[1].vertices.resize(3); }},
  };
  for (const auto& [expected, change] : changes) {
    Scene scene = three();
    change(scene);
    EXPECT_EQ(defect_of(scene), expected);
  }
}

TEST(ValidPolyhedra, HaveMassesInTheRangeOfThePrecision) {
  Scene scene = three();
  scene.polyhedra[0].density = 1e-40;
  EXPECT_EQ(defect_of(scene), "");
  scene.precision = Precision::binary32;
  EXPECT_EQ(defect_of(scene),
            "polyhedra[0]: expected vertices and density that give mass and moments of inertia from 1.17549e-38 to "
            "3.40282e+38, not 1e-40");
  scene.polyhedra[0].density = 1e39;
  EXPECT_NE(defect_of(scene).find("to 3.40282e+38, not 1e+39"), std::string::npos) << defect_of(scene);
  scene.precision = Precision::extended;
  EXPECT_EQ(defect_of(scene), "");
}

TEST(ValidPolyhedra, RotateByAMillionRadiansAtMost) {
  Scene scene = three();
  scene.polyhedra[0].angular_velocity = Vector(0, 0, 1e6 / scene.duration) * (1 + 1e-12);
  EXPECT_EQ(defect_of(scene),
            "polyhedra[0].angular_velocity: expected a body that rotates by at most 1e+06 rad within the duration");
  scene.polyhedra[0].angular_velocity = {1e160, 1e300, 0};
  EXPECT_NE(defect_of(scene), "");
  scene.polyhedra[0].angular_velocity = Vector(0, 0, 1e6 / scene.duration) * (1 - 1e-12);
  EXPECT_EQ(defect_of(scene), "");
  const double least = 1e-308;
  const double greatest = 1e308;
  for (const double length : {least, greatest}) {
    scene.polyhedra[0].orientation = Quaternion<double>::Constant(length);
    EXPECT_EQ(defect_of(scene), "") << length;
    const auto body = std::get<RigidBody>(rigid_body(scene.polyhedra[0]));
    EXPECT_NEAR(body.orientation.norm(), 1, 1e-15);
  }
}

TEST(ValidPolyhedra, HaveCentresWithin4096RadiiOfTheOrigin) {
  Scene scene = three();
  scene.planes.clear();
  const double radius = std::sqrt(0.75);
  scene.polyhedra[0].position.x() = -4096 * radius * (1 + 1e-12);
  EXPECT_EQ(
      defect_of(scene),
      "polyhedra[0]: expected a centre of mass within 4096 radii of the origin, found the distance 3547.24 and the "
      "radius 0.866025");
  scene.polyhedra[0].position.x() = -4096 * radius * (1 - 1e-12);
  EXPECT_EQ(defect_of(scene), "");
}

TEST(ValidPolyhedra, MayNotTouchAPlaneOrABody) {
  struct Case {
    std::string begins;
    std::function<void(Scene&)> touch;
    std::function<void(Scene&)> part;  // moves the bodies apart by a billionth of a radius, after `touch`
  };
  const std::vector<Case> cases{
      {"polyhedra[0]: polyhedron 0 (body 0) may overlap plane 0 (plane 0): 0 m is the computed gap, with a rounding "
       "error of up to ",
       [](Scene& s) { s.planes[0].point.z() = -0.5; }, [](Scene& s) { s.planes[0].point.z() -= 1e-9; }},
      {"polyhedra[1]: polyhedron 1 (body 1) may overlap polyhedron 0 (body 0): 0 m is ",
       [](Scene& s) { s.polyhedra[1].position.x() = 1; }, [](Scene& s) { s.polyhedra[1].position.x() += 1e-9; }},
      {"polyhedra[0]: polyhedron 0 (body 0) may overlap sphere 0 (ball 0): 0 m is ",
       [](Scene& s) { s.spheres[0].position.y() = 0.75; }, [](Scene& s) { s.spheres[0].position.y() += 1e-9; }},
      // Behind the plane.
      {"polyhedra[0]: polyhedron 0 (body 0) may overlap plane 0 (plane 0): -7.5 m is ",
       [](Scene& s) {
         s.planes[0].point.z() = 7;
         s.spheres.clear();
       },
       [](Scene& s) { s.planes[0].point.z() = -0.5 - 1e-9; }},
      // One within the other.
      {"polyhedra[1]: polyhedron 1 (body 1) may overlap polyhedron 0 (body 0): -1 m is ",
       [](Scene& s) { s.polyhedra[1].position = s.polyhedra[0].position; },
       [](Scene& s) { s.polyhedra[1].position.z() = 1 + 1e-9; }},
  };
  for (const Case& one : cases) {
    Scene scene = three();
    one.touch(scene);
    EXPECT_TRUE(defect_of(scene).starts_with(one.begins)) << defect_of(scene);
    one.part(scene);
    EXPECT_EQ(defect_of(scene), "") << one.begins;
    EXPECT_NO_THROW(PolyhedronSimulation{scene}) << one.begins;
  }
}

/// In a scene with polyhedra, spheres must also be certain to be apart.
TEST(ValidPolyhedra, MayNotBeWithSpheresThatTouch) {
  Scene scene = three();
  add_sphere(scene, 0.25, {0, 2.5, 0}, {0, 0, 0});
  EXPECT_FALSE(first_defect(scene)) << "to touch is not to overlap";
  EXPECT_TRUE(defect_of(scene).starts_with(
      "spheres[1]: sphere 1 (ball 1) may overlap sphere 0 (ball 0): 0 m is the computed gap"))
      << defect_of(scene);
  scene.spheres[1].position = {0, 4, -0.75};
  EXPECT_FALSE(first_defect(scene));
  EXPECT_TRUE(defect_of(scene).starts_with("spheres[1]: sphere 1 (ball 1) may overlap plane 0 (plane 0): "))
      << defect_of(scene);
  scene.spheres[1].position.z() = 0;
  EXPECT_EQ(defect_of(scene), "");
  EXPECT_NO_THROW(PolyhedronSimulation{scene});
  scene.polyhedra.clear();
  scene.spheres[1].position = {0, 2.5, 0};
  EXPECT_EQ(defect_of(scene), "");
}

TEST(ValidPolyhedra, AreNotSoughtInASceneOfSpheres) {
  Scene scene = three();
  scene.polyhedra.clear();
  scene.spheres[0].radius = -1;
  EXPECT_EQ(defect_of(scene), "");
}

}  // namespace
}  // namespace carom::scene
