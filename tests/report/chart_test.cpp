// SPDX-License-Identifier: BSL-1.0
#include <array>
#include <cmath>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include <carom/report/pictures/diagrams.hpp>
#include <carom/report/pictures/measurement.hpp>
#include <carom/report/pictures/plot.hpp>

#include "support/expect_in.hpp"

namespace carom::report {
namespace {

MethodMeasurement method(const std::string& name, double nanoseconds, const std::vector<double>& digits) {
  ExactnessBuilder builder;
  for (const double of_case : digits) {
    builder.add(0, of_case, true);
  }
  return {name,
          {},
          Law::frictionless,
          Precision::binary64,
          {{"family", builder.built(), {nanoseconds, nanoseconds, nanoseconds}}}};
}

TEST(Quantile, IsTheValueOfTheNearestRank) {
  const std::vector<double> values{1, 2, 3, 4};
  EXPECT_EQ(quantile(values, 0), 1);
  EXPECT_EQ(quantile(values, 0.5), 2);
  EXPECT_EQ(quantile(values, 0.51), 3);
  EXPECT_EQ(quantile(values, 1), 4);
}

TEST(Exactness, HasTheFewestDigitsAndTheGreatestBackwardErrorAsItsWorst) {
  ExactnessBuilder builder;
  for (const double digits : {15.0, 3.0, 16.0}) {
    builder.add(16 - digits, digits, digits > 5);
  }
  const Exactness exactness = builder.built();
  EXPECT_EQ(exactness.cases, 3);
  EXPECT_EQ(exactness.failures, 1);
  EXPECT_EQ(exactness.digits.median, 15);
  EXPECT_EQ(exactness.digits.worst, 3);
  EXPECT_EQ(exactness.backward_error.median, 1);
  EXPECT_EQ(exactness.backward_error.worst, 13);
}

TEST(ParetoLine, HasEveryMethodThatNoOtherBeatsInBothTimeAndDigits) {
  constexpr std::array nanoseconds{5.0, 10.0, 10.0, 20.0, 1.0, 30.0};
  constexpr std::array digits{6.0, 15.0, 14.0, 15.0, 20.0, 19.0};
  constexpr std::array sound{true, true, true, true, false, true};
  const auto line = pareto(
      nanoseconds.size(), [&](std::size_t i) { return nanoseconds[i]; }, [&](std::size_t i) { return digits[i]; },
      [&](std::size_t i) { return sound[i]; });
  EXPECT_EQ(line, (std::vector<std::size_t>{0, 1, 5}));
}

TEST(Deadline, CountsTheBestMethodThatIsDoneByThen) {
  const std::vector<MethodMeasurement> methods{method("quick", 2, {6, 6, 12, 12}), method("worse", 3, {6, 6, 6, 12}),
                                               method("slow", 9, {15, 15, 15, 3})};
  const auto steps = deadline_steps(methods, 9);
  ASSERT_EQ(steps.size(), 2);
  EXPECT_EQ(steps[0].method, "quick");
  EXPECT_EQ(steps[0].share, 0.5);
  EXPECT_EQ(steps[1].method, "slow");
  EXPECT_EQ(steps[1].nanoseconds, 9);
  EXPECT_EQ(steps[1].share, 0.75);
  EXPECT_TRUE(deadline_steps(methods, 18).empty());
}

TEST(Axis, MayRiseOrFallAndMovesValuesOutsideToItsEnd) {
  const Axis falling{1, 1e-4, true, 100, 500};
  EXPECT_EQ(falling.pixel_of(1), 100);
  EXPECT_EQ(falling.pixel_of(1e-4), 500);
  EXPECT_DOUBLE_EQ(falling.pixel_of(1e-2), 300);
  EXPECT_EQ(falling.pixel_of(1e-9), 500) << "moved to the end";
  const std::string tics = power_tics(falling, 'x');
  unit::expect_in(tics, {"\"10⁻⁴\" 1e-4", "\"10⁰\" 1e0"});
}

TEST(Labels, DoNotCoverEachOtherAndStayNearTheirPlace) {
  constexpr double letter = 15;
  const Panel panel{{0, 1, false, 0, 1000}, {0, 1, false, 0, 1000}};
  std::vector<Label> labels;
  std::vector<Pixel> positions;
  for (int i = 0; i < 12; ++i) {  // marks that nearly coincide
    positions.push_back({500 + 3.0 * i, 500});
    labels.push_back({std::to_string(i + 1), positions.back(), "#000000"});
  }
  place_labels(labels, positions, letter, panel);
  for (std::size_t i = 0; i < labels.size(); ++i) {
    EXPECT_LT(std::hypot(labels[i].at.x - labels[i].names.x, labels[i].at.y - labels[i].names.y), 5 * letter);
    for (std::size_t j = 0; j < i; ++j) {
      const bool apart = std::abs(labels[i].at.x - labels[j].at.x) >= 0.6 * letter ||
                         std::abs(labels[i].at.y - labels[j].at.y) >= 0.9 * letter;
      EXPECT_TRUE(apart) << labels[i].text << " covers " << labels[j].text;
    }
  }
}

TEST(NamesInAColumn, AreMovedApart) {
  std::vector<double> heights{100, 99, 60, 12, 3};
  spread(heights, 10, 5);
  EXPECT_EQ(heights, (std::vector<double>{100, 90, 60, 15, 5}));
}

TEST(ReadableShade, IsNoDarkerThanItMustBe) {
  EXPECT_EQ(readable(blue), blue);
  EXPECT_EQ(readable(black), black);
  EXPECT_EQ(readable("#ffffff"), "#757575");
}

TEST(TextForGnuplot, IsQuotedAndStartsNoCommand) {
  EXPECT_EQ(gnuplot_text("a\"b\\c"), "\"a\\\"b\\\\c\"");
  EXPECT_EQ(gnuplot_text("`touch x`\nsystem"), "\"'touch x' system\"");
}

}  // namespace
}  // namespace carom::report
