// SPDX-License-Identifier: BSL-1.0
#include <cmath>
#include <optional>
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

/// A method with a median and a worst backward error [ulps].
MethodMeasurement with_errors(const std::string& name, double nanoseconds, double median, double worst,
                              Precision precision = Precision::binary64) {
  ExactnessBuilder builder;
  for (const double error : {median, median, worst}) {
    builder.add(error, 10, error <= 32);
  }
  MethodMeasurement result = method(name, nanoseconds, {});
  result.precision = precision;
  result.families.front().exactness = builder.built();
  return result;
}

std::vector<std::string> names_of(const std::vector<MethodMeasurement>& methods) {
  std::vector<std::string> names;
  for (const MethodMeasurement& each : methods) {
    names.push_back(each.name);
  }
  return names;
}

TEST(MethodsToDraw, AreNeitherDominatedNorTheSameToTheEye) {
  std::vector<MethodMeasurement> methods{with_errors("first", 100, 0.1, 3),
                                         with_errors("the same", 95, 0.2, 1.1),
                                         with_errors("hardly better", 200, 0.1, 2),
                                         with_errors("slow and precise", 900, 0.1, 0.5),
                                         with_errors("quick and wrong", 80, 1, 1e9),
                                         with_errors("float", 101, 0.1, 3, Precision::binary32),
                                         with_errors("batch", 20, 0.1, 3)};
  methods.back().is_batch = true;
  EXPECT_EQ(names_of(methods_to_draw(methods)),
            (std::vector<std::string>{"batch", "quick and wrong", "first", "slow and precise"}));
}

TEST(MethodsToDraw, AreAtMostTwelve) {
  std::vector<MethodMeasurement> methods;
  for (int i = 0; i < 20; ++i) {
    methods.push_back(with_errors(std::to_string(i), 10 * std::pow(1.2, i), 1e-20, std::pow(10, -i)));
  }
  EXPECT_EQ(methods_to_draw(methods).size(), 12U);
  EXPECT_EQ(names_of(methods_to_draw(methods)).front(), "0");
}

TEST(WorkPrecision, NamesItsMethodsAtTheirMarksAndDrawsALineToTheMedian) {
  const std::vector<MethodMeasurement> methods{with_errors("fails", 100, 0.5, HUGE_VAL),
                                               with_errors("holds", 200, 0.125, 4)};
  const std::string script = work_precision(methods, 32).script();
  unit::expect_in(script,
                  {"set label \"fails\"", "set label \"holds\"", "\"not finite\"", "200 0.125 200 4",
                   "set label \"32 ulps of binary64\"", "from graph 0,first 32 to graph 1,first 32", "2 of 2 methods"});
}

/// A line of a sweep over 1, 10, 100, … with these worst errors [ulps]. No value stands for a point in which one ulp of
/// the inputs explains every error.
SweepLine line(const std::string& name, const std::vector<std::optional<double>>& errors,
               Precision precision = Precision::binary64) {
  SweepLine result{name, Law::frictionless, precision, {}, {}};
  for (std::size_t i = 0; i < errors.size(); ++i) {
    ExactnessBuilder builder;
    builder.add(errors[i].value_or(0.01), errors[i] ? 5 : -3, errors[i].value_or(0) <= 32);
    result.quantity.push_back(std::pow(10, i));
    result.exactness.push_back(builder.built());
  }
  return result;
}

TEST(LinesToDraw, StandForThoseThatLookTheSameAndForThoseThatStayBelowTheLimit) {
  const SweepMeasurement sweep{"sweep",
                               "x",
                               "summary",
                               {line("stays", {1, 1, 1}), line("stays higher", {1, 2, 1}), line("fails", {1, 1e3, 1e6}),
                                line("looks the same", {2, 2e3, 1e6}), line("fails later", {1, 1, 1e6}),
                                line("float", {1, 1e3, 1e6}, Precision::binary32)}};
  std::vector<std::string> drawn;
  for (const DrawnLine& each : lines_to_draw(sweep, Law::frictionless)) {
    drawn.push_back(each.line->method + " " + std::to_string(each.alike));
  }
  EXPECT_EQ(drawn, (std::vector<std::string>{"fails 1", "fails later 0", "float 0", "stays higher 1"}));
}

TEST(LinesToDraw, AreAtMostEight) {
  SweepMeasurement sweep{"sweep", "x", "summary", {line("stays", {1, 1})}};
  for (int i = 2; i < 22; ++i) {
    sweep.lines.push_back(line(std::to_string(i), {1, std::pow(10, i)}));
  }
  EXPECT_EQ(lines_to_draw(sweep, Law::frictionless).size(), 8U);
  unit::expect_in(stability_map(sweep, Law::frictionless, 32).script(), {"13 more methods are in the table"});
}

TEST(StabilityMap, BreaksALineWhereErrorsShowNothingAndHasTheRangeOfItsData) {
  const SweepMeasurement sweep{"sweep", "x", "summary", {line("gap", {1, 1e3, {}, 2e3, {}})}};
  EXPECT_FALSE(sweep.lines.front().exactness[2].shows_method());
  const std::string script = stability_map(sweep, Law::frictionless, 32).script();
  unit::expect_in(script, {"1 1 \n10 1000 \n\n1000 2000 \n\nEND", "set yrange [1:10000]"});
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

TEST(Labels, CoverNeitherEachOtherNorAMark) {
  constexpr double letter = 15;
  const Panel panel{{0, 1, false, 0, 1000}, {0, 1, false, 0, 1000}};
  std::vector<Label> labels;
  std::vector<Pixel> positions;
  for (int i = 0; i < 12; ++i) {  // marks that nearly coincide
    positions.push_back({500 + 3.0 * i, 500});
    labels.push_back({"method-number-" + std::to_string(i + 1), positions.back(), "#000000"});
  }
  place_labels(labels, positions, letter, panel);
  const auto half_width = [](const Label& label) {
    return letter_width * letter * static_cast<double>(label.text.size()) / 2;
  };
  for (std::size_t i = 0; i < labels.size(); ++i) {
    for (const Pixel& mark : positions) {
      EXPECT_TRUE(std::abs(labels[i].at.x - mark.x) >= half_width(labels[i]) ||
                  std::abs(labels[i].at.y - mark.y) >= letter / 2)
          << labels[i].text << " covers a mark";
    }
    for (std::size_t j = 0; j < i; ++j) {
      const bool apart = std::abs(labels[i].at.x - labels[j].at.x) >= half_width(labels[i]) + half_width(labels[j]) ||
                         std::abs(labels[i].at.y - labels[j].at.y) >= letter;
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
