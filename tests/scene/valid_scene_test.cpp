// SPDX-License-Identifier: BSL-1.0
#include <cmath>
#include <limits>
#include <string>

#include <gtest/gtest.h>

#include <carom/scene/valid_scene.hpp>

namespace carom::scene {
namespace {

Scene scene_of_two(double distance) {
  Scene scene;
  scene.materials = {"steel"};
  scene.pairs = MaterialPairs(1);
  scene.spheres = {{.name = "left", .radius = 0.1}, {.name = "right", .radius = 0.2, .position = {distance, 0, 0}}};
  return scene;
}

std::string defect_of(const Scene& scene) {
  const std::optional<SceneDefect> defect = first_defect(scene);
  return defect ? describe(*defect) : "";
}

TEST(ValidScene, HasNoSpheresThatOverlapExactly) {
  // The exact sum of the radii lies between 0.3 and the double 0.1 + 0.2.
  EXPECT_EQ(defect_of(scene_of_two(0.1 + 0.2)), "");
  EXPECT_EQ(defect_of(scene_of_two(0.3)), "spheres[1]: sphere 1 (right) overlaps sphere 0 (left)");
}

TEST(ValidScene, MovesSpheresApartThatTouchInDecimals) {
  Scene scene = scene_of_two(1);
  scene.planes = {{.name = "wall", .normal = {1, 0, 0}, .point = {0, 0, 0}},
                  {.name = "slope", .normal = {0, 3, 4}, .point = {0, 0, -0.125}}};
  scene.spheres.clear();
  for (const double x : {0.1, 0.3, 0.5, 0.7, 0.9}) {
    scene.spheres.push_back({.name = "ball", .radius = 0.1, .position = {x, 0, 0}});
  }
  Scene apart = scene;
  ASSERT_NE(defect_of(scene), "");
  move_apart(apart);
  EXPECT_EQ(defect_of(apart), "");
  EXPECT_GT(apart.moved_apart.bodies, 0U);
  EXPECT_LE(apart.moved_apart.farthest, 0x1p-49);
  for (std::size_t i = 0; i < scene.spheres.size(); ++i) {
    EXPECT_LE((apart.spheres[i].position - scene.spheres[i].position).norm(), apart.moved_apart.farthest);
  }
  // An overlap that is more than rounding stays.
  scene.spheres = {apart.spheres[0], apart.spheres[1]};
  scene.spheres[1].position[0] -= 1e-14;
  const Vector3<double> position = scene.spheres[1].position;
  move_apart(scene);
  EXPECT_EQ(scene.spheres[1].position, position);
  EXPECT_NE(defect_of(scene), "");
}

TEST(ValidScene, HasNoSphereThatOverlapsAPlaneExactly) {
  Scene scene = scene_of_two(1);
  scene.planes = {{.name = "slope", .normal = {3, 0, 4}, .point = {0, 0, -0.1249}}};
  EXPECT_EQ(defect_of(scene),
            "spheres[0]: sphere 0 (left) overlaps plane 0 (slope), or is behind it; move one of them");
  scene.spheres[0].radius = 0.0999;
  EXPECT_EQ(defect_of(scene), "");
  // A touch is not an overlap.
  scene.planes[0].normal = {0, 0, 1};
  scene.planes[0].point = {0, 0, -0.2};
  EXPECT_EQ(defect_of(scene), "");
  scene.planes[0].point[2] = std::nextafter(-0.2, 0);
  EXPECT_EQ(defect_of(scene),
            "spheres[1]: sphere 1 (right) overlaps plane 0 (slope), or is behind it; move one of them");
}

TEST(ValidScene, HasMassesInTheRangeOfThePrecision) {
  Scene scene = scene_of_two(1);
  scene.spheres[0].density = 1e-40;
  EXPECT_EQ(defect_of(scene), "");
  scene.precision = Precision::binary32;
  EXPECT_NE(defect_of(scene).find("expected radius and density that give a mass from 1.17549e-38"), std::string::npos)
      << defect_of(scene);
}

TEST(ValidScene, HasNoMotionThatOverflows) {
  Scene scene = scene_of_two(1);
  for (Vector3<double>* vector : {&scene.spheres[0].velocity, &scene.spheres[0].angular_velocity, &scene.gravity}) {
    *vector = {8e307, 8e307, 8e307};
    EXPECT_NE(defect_of(scene).find("expected a motion of at most 2^100 m within the duration"), std::string::npos)
        << defect_of(scene);
    *vector = {1e25, 0, 0};
    EXPECT_EQ(defect_of(scene), "");
    *vector = {0, 0, 0};
  }
  scene.spheres[0].velocity = {1e25, 0, 0};
  scene.duration = 1e25;
  EXPECT_EQ(defect_of(scene).find("spheres[0].velocity: expected a motion"), 0U) << defect_of(scene);
}

TEST(ValidScene, HasNoDefectThatAFileCannotHave) {
  Scene scene = scene_of_two(1);
  scene.law = Law::any;
  EXPECT_EQ(defect_of(scene), "law: expected frictionless, reflection, sticking, rough or coulomb");
  scene = scene_of_two(1);
  scene.spheres[1].material = 1;
  EXPECT_EQ(defect_of(scene), "spheres[1].material: expected an index of a material");
  scene = scene_of_two(1);
  scene.spheres[1].velocity[2] = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(defect_of(scene), "spheres[1].velocity: expected finite numbers");
  scene = scene_of_two(1);
  scene.pairs = MaterialPairs(2);
  EXPECT_EQ(defect_of(scene), "pairs: expected pairs of as many materials as the scene has");
}

}  // namespace
}  // namespace carom::scene
