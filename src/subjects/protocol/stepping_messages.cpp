// SPDX-License-Identifier: BSL-1.0
#include <cmath>
#include <utility>

#include <fmt/format.h>

#include <carom/collision/json/json.hpp>
#include <carom/collision/json/object_reader.hpp>
#include <carom/collision/json/text.hpp>
#include <carom/subjects/protocol/messages.hpp>
#include <carom/subjects/protocol/stepping_messages.hpp>

namespace carom::subjects::protocol {
namespace {

using nlohmann::json;
using Reader = carom::detail::ObjectReader<json>;

constexpr std::size_t longest_text = 100;  // bytes

/// Throws FormatError if the value is not right. The error shows the value.
void require(bool is_right, const std::string& place, const std::string& expected, const json& value) {
  if (!is_right) {
    throw FormatError(place, "expected " + expected + carom::detail::found(value));
  }
}

std::string text(const json& value, const std::string& place, std::size_t longest = longest_text) {
  require(value.is_string(), place, "a string", value);
  return printable_line(value.get<std::string>(), longest);
}

std::string text(Reader& reader, const char* name, std::size_t longest = longest_text) {
  return text(reader.required(name), reader.at(name), longest);
}

bool flag(Reader& reader, const char* name) {
  if (!reader.has(name)) {
    return false;
  }
  const json& value = reader.required(name);
  require(value.is_boolean(), reader.at(name), "true or false", value);
  return value.get<bool>();
}

std::vector<std::string> texts(Reader& reader, const char* name) {
  std::vector<std::string> all;
  if (reader.has(name)) {
    const json& values = reader.required(name);
    require(values.is_array(), reader.at(name), "an array of strings", values);
    for (const json& one : values) {
      all.push_back(text(one, fmt::format("{}/{}", reader.at(name), all.size())));
    }
  }
  return all;
}

json numbers(const auto& vector) {
  json array = json::array();
  for (Eigen::Index i = 0; i < vector.size(); ++i) {
    array.push_back(number_to_json(vector[i]));
  }
  return array;
}

void add_state(json& body, const BodyState& state) {
  body["position"] = numbers(state.position);
  body["orientation"] = numbers(state.orientation);
  body["velocity"] = numbers(state.velocity);
  body["angular_velocity"] = numbers(state.angular_velocity);
}

BodyState state_of(Reader& reader) {
  BodyState state;
  reader.numbers("position", state.position);
  reader.numbers("orientation", state.orientation);
  reader.numbers("velocity", state.velocity);
  reader.numbers("angular_velocity", state.angular_velocity);
  return state;
}

json request_without_scene(std::uint64_t id, const Stepping& stepping) {
  return {
      {"cmd", "run"}, {"id", id}, {"step", stepping.step}, {"steps", steps_of(stepping)}, {"report", stepping.report}};
}

Reader reader_of_reply(const json& reply, std::uint64_t id) {
  Reader reader(reply, "");
  const json& found = reader.required("id");
  require(found == id, "/id", std::to_string(id), found);
  return reader;
}

json body_record(const SteppedBody& one) {
  json body = json::object();
  if (const auto* const sphere = std::get_if<SphereShape>(&one.shape)) {
    body["sphere"] = sphere->radius;
  } else if (const auto* const box = std::get_if<BoxShape>(&one.shape)) {
    body["box"] = numbers(box->lengths);
  } else {
    body["half_space"] = numbers(std::get<HalfSpaceShape>(one.shape).normal);
  }
  if (one.is_fixed) {
    body["fixed"] = true;
    body["position"] = numbers(one.state.position);
    if (!std::holds_alternative<HalfSpaceShape>(one.shape)) {
      body["orientation"] = numbers(one.state.orientation);
    }
    return body;
  }
  body["mass"] = one.mass;
  body["principal_inertia"] = numbers(one.principal_inertia);
  add_state(body, one.state);
  return body;
}

std::vector<BodyState> states_from(const json& values, const std::string& place, std::size_t bodies) {
  require(values.is_array() && values.size() == bodies, place, fmt::format("the states of {} bodies", bodies), values);
  std::vector<BodyState> states;
  for (const json& value : values) {
    Reader reader(value, fmt::format("{}/{}", place, states.size()));
    states.push_back(state_of(reader));
  }
  return states;
}

}  // namespace

Stepper stepper_from(std::string_view line) {
  const json reply = parse_json(line);
  Reader reader(reply, "");
  const json& protocol = reader.required("protocol");
  require(protocol == version, "/protocol", std::to_string(version), protocol);
  if (!flag(reader, "time")) {
    throw FormatError("/time", "is missing or false: the program does not answer `run`");
  }
  Stepper stepper;
  stepper.name = text(reader, "name");
  if (stepper.name.empty()) {
    throw FormatError("/name", "is empty; expected a name");
  }
  stepper.version = reader.has("version") ? text(reader, "version") : "";
  stepper.precision = precision_named(text(reader, "precision"));
  stepper.is_planar = flag(reader, "planar");
  stepper.restores = flag(reader, "restores");
  stepper.cannot = texts(reader, "cannot");
  stepper.claims = texts(reader, "time_claims");
  return stepper;
}

std::string run_request(std::uint64_t id, const Stepping& stepping) {
  const SteppedScene& scene = stepping.scene;
  json bodies = json::array();
  for (const SteppedBody& body : scene.bodies) {
    bodies.push_back(body_record(body));
  }
  json request = request_without_scene(id, stepping);
  request["scene"] = {{"gravity", numbers(scene.gravity)},
                      {"restitution", scene.restitution},
                      {"friction", scene.friction},
                      {"continuous", scene.is_continuous},
                      {"bodies", std::move(bodies)}};
  return request.dump() + '\n';
}

std::string continue_request(std::uint64_t id, const Stepping& stepping) {
  return request_without_scene(id, stepping).dump() + '\n';
}

std::string state_request(std::uint64_t id, std::string_view command) {
  return json{{"cmd", command}, {"id", id}}.dump() + '\n';
}

std::optional<Refused> state_reply_from(std::string_view line, std::uint64_t id) {
  const json reply = parse_json(line);
  Reader reader = reader_of_reply(reply, id);
  return reader.has("error") ? std::optional(Refused{text(reader, "error", longest_reason)}) : std::nullopt;
}

SteppingAnswer run_reply_from(std::string_view line, std::uint64_t id, const Stepping& stepping) {
  const json reply = parse_json(line);
  Reader reader = reader_of_reply(reply, id);
  const bool is_skipped = reader.has("skipped");
  const bool is_refused = reader.has("error");
  if (is_skipped + is_refused + reader.has("states") != 1) {
    throw FormatError("reply", "expected exactly one of states, skipped, error");
  }
  if (is_skipped) {
    return Skipped{text(reader, "skipped", longest_reason)};
  }
  if (is_refused) {
    return Refused{text(reader, "error", longest_reason)};
  }
  const json& states = reader.required("states");
  require(states.is_array() && states.size() == stepping.report.size(), "/states",
          fmt::format("the states after {} numbers of steps", stepping.report.size()), states);
  SteppedStates answer;
  for (const json& one : states) {
    answer.states.push_back(
        states_from(one, fmt::format("/states/{}", answer.states.size()), stepping.scene.bodies.size()));
  }
  reader.number("seconds", answer.seconds);
  require(answer.seconds >= 0 && std::isfinite(answer.seconds), "/seconds", "a finite number of at least 0",
          reader.required("seconds"));
  return answer;
}

}  // namespace carom::subjects::protocol
