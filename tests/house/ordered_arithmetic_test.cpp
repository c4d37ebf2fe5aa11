// SPDX-License-Identifier: BSL-1.0
#include <regex>
#include <string>

#include <gtest/gtest.h>

#include "layout.hpp"

/// Families and features draw the same numbers on every machine. So they use no sum of Eigen, because Eigen chooses the
/// order of the terms. They negate no vector by the minus sign of Eigen. They use only mathematical functions that
/// every machine computes alike.
namespace carom::layout {
namespace {

/// The first operation whose rounding the source does not determine; empty if there is none.
std::string unstated_rounding(const std::string& text) {
  static const std::regex operation(
      R"re(\.(dot|norm|squaredNorm|stableNorm|lpNorm|normalized|normalize|sum|prod|mean|trace|cross|inverse|determinant|solve|partialPivLu|ldlt|llt)(<[^>]*>)?\(|\.(minCoeff|maxCoeff)\(&|std::(pow|exp|exp2|expm1|log|log2|log10|log1p|sin|cos|tan|asin|acos|atan|atan2|sinh|cosh|tanh|cbrt|hypot|erf|tgamma|lgamma)\b|[=(,?:{] ?-[a-z_.]*(normal|velocity|orientation|position|point)\b(?!\[)|oracles::(turned|relative_velocity|point_velocity|apply_inertia))re");
  std::smatch match;
  return std::regex_search(text, match, operation) ? match.str() : std::string();
}

TEST(OrderedArithmetic, IsFoundLackingWherePlanted) {
  for (const char* text : {"x = u.dot(v);", "x = v.norm();", "x = v.squaredNorm();", "x = v.lpNorm<1>();",
                           "x = v.sum();", "w = u.cross(v);", "x = v.minCoeff(&place);", "y = std::pow(x, 3);",
                           "y = std::hypot(x, z);", "w = oracles::turned<double>(q, v);",
                           "f = k.partialPivLu().solve(v);", "b.orientation = -b.orientation;", "v = V(-c.normal);"}) {
    EXPECT_NE(unstated_rounding(text), "") << text;
  }
  for (const char* text :
       {"x = dot(u, v);", "x = std::sqrt(y);", "x = std::ldexp(std::round(y), 3);", "x = std::fma(a, b, c);",
        "x = v.maxCoeff();", "w = cross(u, v);", "v = negated(c.normal);", "x = -c.normal[2];"}) {
    EXPECT_EQ(unstated_rounding(text), "") << text;
  }
}

TEST(OrderedArithmetic, IsAllThatFamiliesAndFeaturesUse) {
  int read = 0;
  for (const SourceFile& file : source_files(CAROM_SOURCE_DIR)) {
    const bool draws = file.path.starts_with("properties/draws/") || file.path.starts_with("properties/families/") ||
                       file.path.starts_with("properties/features/");
    // The first file computes exactly, and the second only prints. So their order of terms changes no draw.
    const bool is_exact = file.path == "properties/families/polyhedron.cpp";
    const bool is_printed = file.path == "properties/features/quantities.cpp";
    if (draws && !is_exact && !is_printed) {
      ++read;
      EXPECT_EQ(unstated_rounding(file.text), "") << file.path;
    }
  }
  EXPECT_GT(read, 30);
}

}  // namespace
}  // namespace carom::layout
