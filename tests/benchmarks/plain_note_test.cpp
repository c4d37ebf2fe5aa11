// SPDX-License-Identifier: BSL-1.0
#include "plain_note.hpp"

#include <algorithm>
#include <limits>
#include <vector>

#include <gtest/gtest.h>

#include <carom/oracles/judge/accuracy.hpp>
#include <carom/properties/cases/body_pairs.hpp>

#include "support/cases.hpp"

/// The judge accepts the plain solver with two exceptions (docs/findings/note.md). The solver loses the angular
/// momentum of slender bodies, and its basis fails on nearly head-on impacts.
namespace carom::benchmarks {
namespace {

Outcome<double> solved(const Collision& collision, Law law) {
  const plain::RigidBody a = plain::rigid_body(collision.a);
  const plain::RigidBody b = plain::rigid_body(collision.b);
  const plain::Contact contact = plain::contact(collision, a, b);
  return plain::outcome(law == Law::frictionless ? plain::solve_frictionless(contact)
                                                 : plain::solve_reflection(contact));
}

bool is_allowed(const Collision& collision, Law law, const Outcome<double>& outcome) {
  const auto yardstick = oracles::Yardstick::of(Precision::binary64);
  const oracles::Accuracy accuracy = oracles::accuracy(
      oracles::ExactCase(collision), law,
      oracles::LiftedOutcome(map_outcome<long double>(outcome, [](double x) -> long double { return x; })), yardstick);
  return accuracy.is_decided && std::ranges::all_of(accuracy.allowed, [](bool allowed) { return allowed; });
}

std::size_t allowed_of(std::string_view family, std::uint64_t cases, Law law) {
  std::size_t allowed = 0;
  for (std::uint64_t i = 0; i < cases; ++i) {
    const Collision collision = unit::case_of(family, i).collision;
    allowed += is_allowed(collision, law, solved(collision, law)) ? 1 : 0;
  }
  return allowed;
}

TEST(PlainNote, IsRightOnBodiesThatAreNotSlender) {
  for (std::uint64_t i = 0; i < 500; ++i) {
    properties::Stream stream = properties::stream_from(i);
    const Collision collision = properties::general_bodies(stream).collision;
    for (const Law law : {Law::frictionless, Law::reflection}) {
      EXPECT_TRUE(is_allowed(collision, law, solved(collision, law))) << i;
    }
  }
  EXPECT_EQ(allowed_of("separating", 50, Law::reflection), 50U);
}

TEST(PlainNote, FailsNearlyHeadOn) {
  EXPECT_EQ(allowed_of("near_head_on", 180, Law::frictionless), 180U);
  EXPECT_LT(allowed_of("near_head_on", 180, Law::reflection), 90U);
}

}  // namespace
}  // namespace carom::benchmarks
