// SPDX-License-Identifier: BSL-1.0
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include <carom/collision/json/json.hpp>
#include <carom/subjects/protocol/stepping_messages.hpp>

#include "support/expect_in.hpp"
#include "support/message_of.hpp"

namespace carom::subjects::protocol {
namespace {

Stepping ball_on_floor() {
  Stepping stepping;
  stepping.step = 1.0 / 60;
  stepping.report = {0, 3, 7};
  stepping.scene.gravity = {0, 0, -9.81};
  stepping.scene.restitution = 0.5;
  stepping.scene.friction = 0.3;
  stepping.scene.is_continuous = true;
  SteppedBody floor{HalfSpaceShape{{0, 0, 2}}, true};
  SteppedBody ball{SphereShape{0.1}, false, 2, {0.008, 0.008, 0.008}};
  ball.state.position = {0, 0.1, 1.1};
  ball.state.velocity = {1, 0, -3};
  SteppedBody box{BoxShape{{1, 2, 3}}, false, 5, {1, 2, 2.5}};
  box.state.orientation = {0.5, 0.5, -0.5, 0.5};
  stepping.scene.bodies = {floor, ball, box};
  return stepping;
}

TEST(RunRequest, IsReadAsItWasWritten) {
  const Stepping posed = ball_on_floor();
  const std::string line = run_request(7, posed);
  const RunRequest read = run_request_from(line);
  EXPECT_EQ(read.id, 7U);
  EXPECT_EQ(run_request(7, read.stepping), line);
  EXPECT_EQ(read.stepping.report, posed.report);
  EXPECT_EQ(std::get<BoxShape>(read.stepping.scene.bodies[2].shape).lengths, Vector3<double>(1, 2, 3));
  EXPECT_TRUE(read.stepping.scene.is_continuous);
}

TEST(RunRequest, ThatContinuesHasNoScene) {
  EXPECT_EQ(continue_request(8, ball_on_floor()),
            "{\"cmd\":\"run\",\"id\":8,\"report\":[0,3,7],\"step\":0.016666666666666666,\"steps\":7}\n");
  EXPECT_EQ(state_request(9, "save"), "{\"cmd\":\"save\",\"id\":9}\n");
  EXPECT_FALSE(state_reply_from(R"({"id":9})", 9));
  EXPECT_EQ(state_reply_from(R"({"id":9,"error":"no room"})", 9).value().why, "no room");
  EXPECT_THROW(static_cast<void>(state_reply_from(R"({"id":8})", 9)), FormatError);
}

TEST(RunRequest, WithAnErrorNamesThePlace) {
  const std::string right = run_request(7, ball_on_floor());
  const std::vector<std::pair<std::pair<std::string, std::string>, std::string>> errors{
      {{"\"step\":0.01", "\"step\":-0.01"}, "/step: expected a number above 0"},
      {{"[0,3,7]", "[0,7,3]"}, "/report/2: expected ascending"},
      {{"[0,3,7]", "[0,3,3]"}, "/report/2: expected ascending"},
      {{"[0,3,7]", "[]"}, "/report: expected an array"},
      {{"\"restitution\":0.5", "\"restitution\":1.5"}, "/scene/restitution: expected a number from 0 to 1"},
      {{"\"sphere\":0.1", "\"sphere\":0"}, "/scene/bodies/1/sphere: expected a number above 0"},
      {{"\"box\":[1.0,2.0,3.0]", "\"box\":[1.0,2.0]"}, "/scene/bodies/2/box: expected an array of 3 numbers"},
      {{"\"mass\":2.0", "\"weight\":2.0"}, "/scene/bodies/1/mass: is missing"},
      {{"\"fixed\":true,", ""}, "/scene/bodies/0: a half-space is fixed"}};
  for (const auto& [change, message] : errors) {
    std::string line = right;
    const std::size_t at = line.find(change.first);
    ASSERT_NE(at, std::string::npos) << change.first << " in " << line;
    line.replace(at, change.first.size(), change.second);
    unit::expect_in(unit::message_of<FormatError>([&] { static_cast<void>(run_request_from(line)); }), {message});
  }
}

SteppedStates states_of(const Stepping& stepping) {
  std::vector<BodyState> states;
  for (const SteppedBody& body : stepping.scene.bodies) {
    states.push_back(body.state);
  }
  return {std::vector(stepping.report.size(), states), 0.25};
}

TEST(RunReply, IsReadAsItWasWritten) {
  const Stepping posed = ball_on_floor();
  const std::string line = run_reply(7, states_of(posed));
  const SteppingAnswer read = run_reply_from(line, 7, posed);
  ASSERT_TRUE(std::holds_alternative<SteppedStates>(read));
  EXPECT_EQ(run_reply(7, read), line);
  EXPECT_EQ(std::get<SteppedStates>(read).seconds, 0.25);
}

TEST(RunReply, ThatDoesNotFitTheRequestIsAnError) {
  const Stepping posed = ball_on_floor();
  SteppedStates few = states_of(posed);
  few.states.pop_back();
  SteppedStates bodiless = states_of(posed);
  bodiless.states[1].pop_back();
  for (const std::string& line : {run_reply(8, states_of(posed)), run_reply(7, few), run_reply(7, bodiless),
                                  std::string(R"({"id":7,"states":[],"skipped":"both"})"), std::string("{}")}) {
    EXPECT_THROW(static_cast<void>(run_reply_from(line, 7, posed)), FormatError) << line;
  }
}

TEST(StepperIntroduction, HasWhatTheProgramSays) {
  const Stepper stepper = stepper_from(
      R"({"protocol":1,"name":"mine","precision":"binary32","time":true,"planar":true,"cannot":["box"],"time_claims":["x"]})");
  EXPECT_EQ(stepper.name, "mine");
  EXPECT_EQ(stepper.precision, Precision::binary32);
  EXPECT_TRUE(stepper.is_planar);
  EXPECT_EQ(stepper.cannot, std::vector<std::string>{"box"});
  EXPECT_EQ(stepper.claims, std::vector<std::string>{"x"});
  EXPECT_THROW(static_cast<void>(stepper_from(R"({"protocol":1,"name":"mine","precision":"binary32"})")), FormatError);
}

}  // namespace
}  // namespace carom::subjects::protocol
