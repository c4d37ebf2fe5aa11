// SPDX-License-Identifier: BSL-1.0
#include <algorithm>
#include <stdexcept>
#include <string>

#include <gtest/gtest.h>

#include <carom/properties/gate/by_name.hpp>
#include <carom/properties/gate/trial.hpp>

#include "support/expect_in.hpp"
#include "support/message_of.hpp"

namespace carom::properties {
namespace {

TEST(NearestName, IsTheOneOfFewestEdits) {
  const std::vector<std::string> names{"generic", "elastic", "inelastic", "head_on"};
  EXPECT_EQ(nearest_name("genric", names), "generic");
  EXPECT_EQ(nearest_name("genericc", names), "generic");
  EXPECT_EQ(nearest_name("head_no", names), "head_on") << "two letters swapped";
  EXPECT_EQ(nearest_name("ielastic", names), "elastic") << "the first of two at the same distance";
  EXPECT_EQ(nearest_name("elastic", names), "elastic");
  EXPECT_EQ(nearest_name("gexyric", names), "generic");
}

TEST(NearestName, IsNoneWhereNothingIsNear) {
  EXPECT_EQ(nearest_name("gxyzric", {"generic"}), std::nullopt);
  EXPECT_EQ(nearest_name("ab", {"cd", "b"}), std::nullopt) << "of short words anything could be made";
  EXPECT_EQ(nearest_name("", {""}), "");
  EXPECT_EQ(nearest_name("word", {}), std::nullopt);
  EXPECT_EQ(did_you_mean("word", {"wrod"}), "; did you mean 'wrod'?");
  EXPECT_EQ(did_you_mean("word", {}), "");
}

TEST(Deviation, IsOfAnInvariantEverywhereOrInOneFamily) {
  const Deviation everywhere = deviation_from("energy");
  EXPECT_EQ(everywhere.invariant, invariant_named("energy"));
  EXPECT_EQ(everywhere.family, nullptr);
  const Deviation in_one = deviation_from("energy@head_on");
  EXPECT_EQ(in_one.invariant, invariant_named("energy"));
  EXPECT_EQ(in_one.family, family_named("head_on"));
}

TEST(Deviation, OfNothingKnownThrowsAndNamesTheNearest) {
  const auto said_of = [](const char* text) {
    return unit::message_of<std::invalid_argument>([&] { return deviation_from(text); });
  };
  unit::expect_in(said_of("enrgy"), {"did you mean 'energy'?"});
  unit::expect_in(said_of("energy@headon"), {"did you mean 'head_on'?"});
  for (const char* text : {"", "@", "energy@", "@head_on", "energy@head_on@head_on", " energy"}) {
    EXPECT_FALSE(said_of(text).empty()) << text;
  }
}

TEST(Deviation, LeavesAClaimEverywhereElse) {
  Subject subject;
  subject.law = Law::frictionless;
  subject.deviates = {"energy@head_on", "push", "no_such", "energy@no_such"};
  const Claim claim = claim_of(subject, {});
  const Invariant& energy = *invariant_named("energy");
  EXPECT_NE(std::find(claim.invariants.begin(), claim.invariants.end(), &energy), claim.invariants.end());
  EXPECT_EQ(std::find(claim.invariants.begin(), claim.invariants.end(), invariant_named("push")),
            claim.invariants.end());
  EXPECT_FALSE(claim.is_made_in(energy, *family_named("head_on")));
  EXPECT_TRUE(claim.is_made_in(energy, *family_named("near_head_on")));
  EXPECT_TRUE(claim.is_made_in(*invariant_named("restitution"), *family_named("head_on")));
}

}  // namespace
}  // namespace carom::properties
