// SPDX-License-Identifier: BSL-1.0
#include <span>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include <carom/impulse/collision_matrix.hpp>
#include <carom/impulse/frictionless.hpp>
#include <carom/impulse/reflection.hpp>
#include <carom/properties/kit/subject.hpp>

namespace carom::conformance {
namespace {

Answer answer_of(const Subject& subject, const Collision& collision) {
  Session session = subject.open();
  return session(std::span(&collision, 1)).at(0);
}

/// A ball hits a resting ball along y at 1 m/s.
Collision along_y() {
  Collision collision;
  collision.a.position = {0, 1, 0};
  collision.a.velocity = {0, -1, 0};
  collision.b.position = {0, -1, 0};
  return collision;
}

template <class S>
Outcome<S> of_contact(const impulse::Contact<S>& contact) {
  return impulse::frictionless(contact);
}

Outcome<float> of_collision(const Collision& collision) {
  return impulse::frictionless(impulse::make_contact<float>(collision));
}

TEST(CallableSubject, TakesContactsOfEachScalarAndCollisions) {
  const std::vector<Subject> subjects{
      subject("float", Law::frictionless, of_contact<float>),
      subject("double", Law::frictionless, of_contact<double>),
      subject("long double", Law::frictionless, of_contact<long double>),
      subject("collision", Law::frictionless, of_collision),
      subject<double>("any", Law::frictionless, [](const auto& contact) { return impulse::frictionless(contact); }),
  };
  const std::vector<Precision> precisions{Precision::binary32, Precision::binary64, Precision::extended,
                                          Precision::binary32, Precision::binary64};
  for (std::size_t i = 0; i < subjects.size(); ++i) {
    SCOPED_TRACE(subjects[i].name);
    EXPECT_EQ(subjects[i].precision, precisions[i]);
    EXPECT_EQ(subjects[i].law, Law::frictionless);
    const Answer answer = answer_of(subjects[i], along_y());
    ASSERT_TRUE(std::holds_alternative<ReportedOutcome>(answer));
    EXPECT_EQ(std::get<ReportedOutcome>(answer).b.velocity[1], -1);
  }
}

TEST(CallableSubject, MayShowItsCollisionMatrix) {
  const auto shown = [](const auto& contact) -> SolvedOutcome<float> {
    const auto see = impulse::collision_matrix(contact);
    return {impulse::reflection(contact), see};
  };
  const std::vector<Subject> showing{
      subject("", Law::reflection, [=](const impulse::Contact<float>& contact) { return shown(contact); }),
      subject("", Law::reflection,
              [=](const Collision& collision) { return shown(impulse::make_contact<float>(collision)); })};
  for (const Subject& one : showing) {
    EXPECT_TRUE(one.shows_collision_matrix);
    EXPECT_EQ(one.precision, Precision::binary32);
    const auto outcome = std::get<ReportedOutcome>(answer_of(one, along_y()));
    ASSERT_TRUE(outcome.collision_matrix);
    EXPECT_EQ(outcome.collision_matrix->diagonal(), (Vector3<long double>{4, 2, 4}));
  }
  EXPECT_FALSE(subject("", Law::frictionless, of_contact<float>).shows_collision_matrix);
  EXPECT_FALSE(subject("", Law::frictionless, of_collision).shows_collision_matrix);
}

TEST(CallableSubject, IsJudgedInThePrecisionThatIsGiven) {
  const Subject rounded = subject(
      "", Law::any, [](const Collision& collision) { return unchanged(collision); }, Precision::binary32);
  EXPECT_EQ(rounded.precision, Precision::binary32);
}

TEST(CallableSubject, DoesNotSeeInvalidCollisions) {
  int calls = 0;
  const Subject counting = subject("", Law::any, [&calls](const Collision& collision) {
    ++calls;
    return unchanged(collision);
  });
  Collision invalid;
  invalid.a.mass = -1;
  EXPECT_TRUE(std::holds_alternative<Refused>(answer_of(counting, invalid)));
  EXPECT_EQ(calls, 0);
  EXPECT_EQ(counting.deviates, std::vector<std::string>{"invalid_refused"});
  EXPECT_TRUE(std::holds_alternative<ReportedOutcome>(answer_of(counting, along_y())));
  EXPECT_EQ(calls, 1);
}

TEST(CallableSubject, IsCopiedForEachSession) {
  const Subject counting = subject("", Law::any, [calls = 0](const Collision& collision) mutable {
    Outcome<double> outcome = unchanged(collision);
    outcome.a.velocity[0] = ++calls;
    return outcome;
  });
  for (int session = 0; session < 2; ++session) {
    EXPECT_EQ(std::get<ReportedOutcome>(answer_of(counting, along_y())).a.velocity[0], 1);
  }
}

}  // namespace
}  // namespace carom::conformance
