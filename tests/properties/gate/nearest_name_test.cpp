// SPDX-License-Identifier: BSL-1.0

#include <gtest/gtest.h>

#include <carom/properties/gate/by_name.hpp>

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

}  // namespace
}  // namespace carom::properties
