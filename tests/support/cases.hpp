// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <bit>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <stdexcept>
#include <string_view>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include <carom/properties/cases/family.hpp>
#include <carom/properties/draws/relative_velocity.hpp>

/// The collisions of the tests. The seeds are fixed, so a failure is reproducible.
namespace carom::unit {

inline constexpr std::uint64_t seed = 20240607;

/// Precondition: the family exists.
[[nodiscard]] inline properties::Case case_of(std::string_view family, std::uint64_t index) {
  return properties::drawn_case(*properties::family_named(family), seed, index);
}

/// The first cases of each family of valid collisions, with the family's name. Throws std::logic_error if there is no
/// case.
[[nodiscard]] inline std::vector<std::pair<std::string_view, properties::Case>> valid_cases(std::uint64_t of_each) {
  std::vector<std::pair<std::string_view, properties::Case>> cases;
  for (const properties::Family& family : properties::all_families()) {
    for (std::uint64_t i = 0; i < of_each && family.is_valid; ++i) {
      cases.emplace_back(family.name, case_of(family.name, i));
    }
  }
  if (cases.empty()) {
    throw std::logic_error("no family has a valid case");
  }
  return cases;
}

/// The number of cases of a heavy test: `full` times the environment variable CAROM_EFFORT, rounded up, or `full` if
/// the variable is not set. CTest sets the variable for SAMPLED tests (tests/CMakeLists.txt).
[[nodiscard]] inline int effort(int full) {
  const char* const share = std::getenv("CAROM_EFFORT");
  return share == nullptr ? full : static_cast<int>(std::ceil(full * std::strtod(share, nullptr)));
}

/// Like valid_cases, with fewer cases of each family if the test is sampled.
[[nodiscard]] inline std::vector<std::pair<std::string_view, properties::Case>> sampled_cases(int of_each) {
  return valid_cases(static_cast<std::uint64_t>(effort(of_each)));
}

/// A ball of mass 1, radius 1 and three equal moments hits a fixed plane with velocity (−3, −4, 0), ε = 1/2. With
/// moments of 1/2 its collision matrix is diag(3, 1, 3).
[[nodiscard]] inline Collision ball_on_a_plane(double moment, double friction) {
  Collision c;
  c.a.principal_inertia.setConstant(moment);
  c.a.position = {0, 1, 0};
  c.a.velocity = {-3, -4, 0};
  c.b.immovable = true;
  c.restitution = 0.5;
  c.friction = friction;
  return c;
}

/// Under the law `coulomb`, this collision has three answers: one sticks and two slip (docs/findings/friction.md).
[[nodiscard]] inline Collision case_with_three_answers() {
  properties::Stream stream = properties::case_stream(1, "structured", 181);
  Collision c = properties::family_named("structured")->generate(stream).collision;
  c.friction = 5;
  return c;
}

/// k/8 with a random integer |k| ≤ most.
[[nodiscard]] inline double eighths(properties::Stream& stream, int most) { return stream.integer(-most, most) / 8.0; }

[[nodiscard]] inline Vector3<double> eighths3(properties::Stream& stream, int most) {
  const double x = eighths(stream, most);
  const double y = eighths(stream, most);
  const double z = eighths(stream, most);
  return {x, y, z};
}

/// A valid collision whose numbers are small multiples of 1/8, so zeros and equal numbers are frequent. A is movable,
/// and B usually is. The contact collides or, rarely, rests.
[[nodiscard]] inline Collision small_collision(properties::Stream& stream) {
  Collision c;
  for (Body* body : {&c.a, &c.b}) {
    body->mass = stream.integer(1, 32) / 8.0;
    for (int i = 0; i < 3; ++i) {
      body->principal_inertia[i] = stream.integer(1, 32) / 8.0;
    }
    for (int i = 0; i < 4; ++i) {
      body->orientation[i] = eighths(stream, 8);
    }
    if ((body->orientation.array() == 0).all()) {
      body->orientation[0] = 1;
    }
    body->position = eighths3(stream, 16);
    body->velocity = eighths3(stream, 16);
    body->angular_velocity = eighths3(stream, 16);
  }
  c.b.immovable = stream.chance(4);
  c.point = eighths3(stream, 16);
  c.normal = eighths3(stream, 8);
  if ((c.normal.array() == 0).all()) {
    c.normal[1] = 1;
  }
  c.restitution = stream.integer(0, 8) / 8.0;
  properties::make_approaching(c);  // without rounding, because the numbers have few bits
  return c;
}

[[nodiscard]] inline bool same_bits(double x, double y) {
  return std::bit_cast<std::uint64_t>(x) == std::bit_cast<std::uint64_t>(y);
}

/// Whether GoogleTest's filter and shard select a test of the current suite with this parameter's name. SetUpTestSuite
/// calls this function, to compute only the shared results that the selected tests need.
[[nodiscard]] inline bool is_selected(std::string_view parameter) {
  const testing::TestSuite& suite = *testing::UnitTest::GetInstance()->current_test_suite();
  for (int i = 0; i < suite.total_test_count(); ++i) {
    const testing::TestInfo& test = *suite.GetTestInfo(i);
    const std::string_view name = test.name();
    if (test.should_run() && name.substr(name.rfind('/') + 1) == parameter) {
      return true;
    }
  }
  return false;
}

}  // namespace carom::unit
