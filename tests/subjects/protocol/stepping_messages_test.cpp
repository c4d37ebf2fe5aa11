// SPDX-License-Identifier: BSL-1.0
#include <limits>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

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

TEST(RunRequest, HasTheFieldsOfTheProtocol) {
  EXPECT_EQ(nlohmann::json::parse(run_request(7, ball_on_floor())), nlohmann::json::parse(R"({
    "cmd":"run", "id":7, "step":0.016666666666666666, "steps":7, "report":[0,3,7],
    "scene":{"gravity":[0,0,-9.81], "restitution":0.5, "friction":0.3, "continuous":true, "bodies":[
      {"half_space":[0,0,2], "fixed":true, "position":[0,0,0]},
      {"sphere":0.1, "mass":2, "principal_inertia":[0.008,0.008,0.008], "position":[0,0.1,1.1],
       "orientation":[1,0,0,0], "velocity":[1,0,-3], "angular_velocity":[0,0,0]},
      {"box":[1,2,3], "mass":5, "principal_inertia":[1,2,2.5], "position":[0,0,0],
       "orientation":[0.5,0.5,-0.5,0.5], "velocity":[0,0,0], "angular_velocity":[0,0,0]}]}})"));
}

TEST(RunRequest, ThatContinuesHasNoScene) {
  EXPECT_EQ(continue_request(8, ball_on_floor()),
            "{\"cmd\":\"run\",\"id\":8,\"report\":[0,3,7],\"step\":0.016666666666666666,\"steps\":7}\n");
  EXPECT_EQ(state_request(9, "save"), "{\"cmd\":\"save\",\"id\":9}\n");
  EXPECT_FALSE(state_reply_from(R"({"id":9})", 9));
  EXPECT_EQ(state_reply_from(R"({"id":9,"error":"no room"})", 9).value().why, "no room");
  EXPECT_THROW(static_cast<void>(state_reply_from(R"({"id":8})", 9)), FormatError);
}

/// A reply to the request 7 for a ball that is reported once.
std::string states_reply(const std::string& id, const std::string& states,
                         const std::string& rest = R"(,"seconds":0.25)") {
  return R"({"id":)" + id + R"(,"states":)" + states + rest + '}';
}

const std::string ball_state =
    R"({"position":[1,2,3],"orientation":[1,0,0,0],"velocity":[0,0,"inf"],"angular_velocity":[0,5,0]})";

Stepping ball_reported_once() {
  Stepping stepping = ball_on_floor();
  stepping.scene.bodies = {stepping.scene.bodies[1]};
  stepping.report = {3};
  return stepping;
}

TEST(RunReply, HasStatesAndSeconds) {
  const SteppingAnswer read = run_reply_from(states_reply("7", "[[" + ball_state + "]]"), 7, ball_reported_once());
  const auto& states = std::get<SteppedStates>(read);
  EXPECT_EQ(states.seconds, 0.25);
  EXPECT_EQ(states.states.at(0).at(0).position, Vector3<double>(1, 2, 3));
  EXPECT_EQ(states.states[0][0].velocity[2], std::numeric_limits<double>::infinity());
  EXPECT_EQ(std::get<Skipped>(run_reply_from(R"({"id":7,"skipped":"no box"})", 7, ball_on_floor())).why, "no box");
  EXPECT_EQ(std::get<Refused>(run_reply_from(R"({"id":7,"error":"full"})", 7, ball_on_floor())).why, "full");
}

TEST(RunReply, ThatDoesNotFitTheRequestNamesThePlace) {
  const std::vector<std::pair<std::string, std::string>> errors{
      {states_reply("8", "[[" + ball_state + "]]"), "/id: expected 7, found 8"},
      {states_reply("7", "[]"), "/states: expected the states after 1 numbers of steps"},
      {states_reply("7", "[[]]"), "/states/0: expected the states of 1 bodies"},
      {states_reply("7", "[[" + ball_state + "]]", ""), "/seconds: is missing"},
      {states_reply("7", "[[" + ball_state + "]]", R"(,"seconds":-1)"),
       "/seconds: expected a finite number of at least 0"},
      {states_reply("7", R"([[{"position":[0,0]}]])"), "/states/0/0/position: expected an array of 3 numbers"},
      {R"({"id":7,"states":[],"skipped":"both"})", "exactly one of states, skipped, error"},
      {"{}", "/id: is missing"}};
  for (const auto& error : errors) {
    const auto read = [&] { static_cast<void>(run_reply_from(error.first, 7, ball_reported_once())); };
    unit::expect_in(unit::message_of<FormatError>(read), {error.second});
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
