// SPDX-License-Identifier: BSL-1.0
#include <algorithm>
#include <string>
#include <thread>

#include <gtest/gtest.h>

#include "detection_report.hpp"
#include "leaves_truth.hpp"
#include "support/cases.hpp"

namespace carom::mutants {
namespace {

Collision general_collision() {
  for (std::uint64_t index = 0;; ++index) {
    Collision collision = unit::case_of("physical", index).collision;
    const bool is_general = !collision.a.immovable && !collision.b.immovable && collision.restitution > 0;
    if (is_general && oracles::ExactCase(collision).approach() == oracles::Approach::colliding) {
      return collision;
    }
  }
}

class Damages : public testing::TestWithParam<Damage> {};

TEST_P(Damages, ChangeTheOutcomeOfAGeneralCollision) {
  const Collision collision = general_collision();
  const oracles::ExactCase read(as_read(collision));
  for (const Law law : laws_with_truth) {
    const Solution sound = solved(law, collision);
    EXPECT_TRUE(differ(damaged(GetParam(), sound, {}), sound.outcome)) << name_of(law);
    EXPECT_FALSE(leaves_truth(GetParam(), read, law)) << name_of(law);
  }
}

INSTANTIATE_TEST_SUITE_P(Each, Damages, testing::ValuesIn(all_damages),
                         [](const auto& test) { return std::string(name_of(test.param)); });

/// Spheres of unit mass, head-on along x. A does not spin; B spins about x.
TEST(LeavesTruth, SaysWhatNoJudgeCanSee) {
  Collision spheres;
  spheres.normal = {-1, 0, 0};
  spheres.a.position = {-1, 0, 0};
  spheres.b.position = {1, 0, 0};
  spheres.a.velocity = {1, 0, 0};
  spheres.b.angular_velocity = {1, 0, 0};
  const oracles::ExactCase read(as_read(spheres));
  for (const Damage damage : {Damage::torque_of_a_dropped, Damage::turning_left_out_of_k}) {
    EXPECT_TRUE(leaves_truth(damage, read, Law::frictionless)) << name_of(damage);
  }
  for (const Damage damage : {Damage::restitution_ignored, Damage::nothing_happens, Damage::reaction_dropped,
                              Damage::sign_of_impulse_component, Damage::spin_along_normal_lost}) {
    EXPECT_FALSE(leaves_truth(damage, read, Law::frictionless)) << name_of(damage);
  }
}

TEST(Detection, KillsWhatCanBeSeenOfSingleFeaturesAndNearlyAllOfPairs) {
  DetectionOptions options;
  options.jobs = std::max(1U, std::thread::hardware_concurrency());
  const Detection detection = detect(options);
  EXPECT_EQ(detection.sound_rejected(), 0U);
  const auto& [singles, pairs] = scores_of(detection);
  EXPECT_EQ(singles.no_case_judged, 0U);
  for (const Law law : detection.laws()) {
    for (const Damage damage : all_damages) {
      const auto& [single, pair] = scores_of(detection, law, damage);
      // `impulse_off` changes each outcome vector by 10⁻⁹ of its change Δy. The judge permits 32 u S, with the
      // sensitivity S and the unit roundoff u. So the damage may stay within rounding if S > 3·10⁵ ‖Δy‖.
      const bool is_slight = damage == Damage::impulse_off;
      EXPECT_GE(single.percent(), is_slight ? 99 : 100) << name_of(law) << ' ' << name_of(damage);
      EXPECT_GE(pair.percent(), is_slight ? 98.5 : 99) << name_of(law) << ' ' << name_of(damage);
    }
  }
  // No judge can find a mutant if its feature makes the damage harmless, as ε = 0 does if the damage ignores ε.
  EXPECT_GT(pairs.visible(), 100 * pairs.leaves_truth);
}

}  // namespace
}  // namespace carom::mutants
