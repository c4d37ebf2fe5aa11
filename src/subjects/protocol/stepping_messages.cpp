// SPDX-License-Identifier: BSL-1.0
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
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

constexpr std::size_t longest_text = 100;          // bytes
constexpr std::uint64_t most_steps = 100'000'000;  // of one run, so that a typing error does not run for a day

std::string text(Reader& reader, const char* name, std::size_t longest) {
  const json& value = reader.required(name);
  if (!value.is_string()) {
    throw FormatError(reader.at(name), "expected a string" + carom::detail::found(value));
  }
  return printable_line(value.get<std::string>(), longest);
}

bool flag(Reader& reader, const char* name) {
  if (!reader.has(name)) {
    return false;
  }
  const json& value = reader.required(name);
  if (!value.is_boolean()) {
    throw FormatError(reader.at(name), "expected true or false" + carom::detail::found(value));
  }
  return value.get<bool>();
}

std::vector<std::string> texts(Reader& reader, const char* name) {
  std::vector<std::string> all;
  if (!reader.has(name)) {
    return all;
  }
  const json& values = reader.required(name);
  const bool are_texts =
      values.is_array() && std::all_of(values.begin(), values.end(), [](const json& one) { return one.is_string(); });
  if (!are_texts) {
    throw FormatError(reader.at(name), "expected an array of strings" + carom::detail::found(values));
  }
  for (const json& one : values) {
    all.push_back(printable_line(one.get<std::string>(), longest_text));
  }
  return all;
}

std::uint64_t count(const json& value, const std::string& place) {
  if (!value.is_number_unsigned() || value.get<std::uint64_t>() > most_steps) {
    throw FormatError(place,
                      fmt::format("expected a whole number from 0 to {}", most_steps) + carom::detail::found(value));
  }
  return value.get<std::uint64_t>();
}

double number_above(Reader& reader, const char* name, double least) {
  double number = 0;
  reader.number(name, number);
  if (!(std::isfinite(number) && number > least)) {
    throw FormatError(reader.at(name), fmt::format("expected a number above {}, found {}", least, number));
  }
  return number;
}

double number_from(Reader& reader, const char* name, double least, double most) {
  double number = 0;
  reader.number(name, number);
  if (!(number >= least && number <= most)) {
    throw FormatError(reader.at(name), fmt::format("expected a number from {} to {}, found {}", least, most, number));
  }
  return number;
}

template <class Vector>
void finite_numbers(Reader& reader, const char* name, Vector& into) {
  reader.numbers(name, into);
  if (!into.allFinite()) {
    throw FormatError(reader.at(name), "expected finite numbers");
  }
}

Vector3<double> positive_numbers(Reader& reader, const char* name) {
  Vector3<double> numbers;
  finite_numbers(reader, name, numbers);
  if (!(numbers.array() > 0).all()) {
    throw FormatError(reader.at(name), "expected numbers above 0");
  }
  return numbers;
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
  if (reader.required("id") != id) {
    throw FormatError("/id", fmt::format("expected {}", id) + carom::detail::found(reply.at("id")));
  }
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

Shape shape_of(Reader& reader, const std::string& place) {
  const bool is_sphere = reader.has("sphere");
  const bool is_box = reader.has("box");
  const bool is_half_space = reader.has("half_space");
  if ((is_sphere ? 1 : 0) + (is_box ? 1 : 0) + (is_half_space ? 1 : 0) != 1) {
    throw FormatError(place, "expected exactly one of sphere, box, half_space");
  }
  if (is_sphere) {
    return SphereShape{number_above(reader, "sphere", 0)};
  }
  if (is_box) {
    return BoxShape{positive_numbers(reader, "box")};
  }
  HalfSpaceShape half_space;
  finite_numbers(reader, "half_space", half_space.normal);
  if (half_space.normal.isZero(0)) {
    throw FormatError(reader.at("half_space"), "expected a normal of nonzero length");
  }
  return half_space;
}

SteppedBody body_from(const json& record, const std::string& place) {
  Reader reader(record, place);
  SteppedBody one{shape_of(reader, place)};
  one.is_fixed = flag(reader, "fixed");
  const bool is_half_space = std::holds_alternative<HalfSpaceShape>(one.shape);
  if (is_half_space && !one.is_fixed) {
    throw FormatError(place, "a half-space is fixed; add \"fixed\": true");
  }
  finite_numbers(reader, "position", one.state.position);
  if (!one.is_fixed || reader.has("orientation")) {
    finite_numbers(reader, "orientation", one.state.orientation);
    if (one.state.orientation.isZero(0)) {
      throw FormatError(reader.at("orientation"), "expected a quaternion of nonzero length");
    }
  }
  if (!one.is_fixed) {
    one.mass = number_above(reader, "mass", 0);
    one.principal_inertia = positive_numbers(reader, "principal_inertia");
    finite_numbers(reader, "velocity", one.state.velocity);
    finite_numbers(reader, "angular_velocity", one.state.angular_velocity);
  }
  reader.reject_others();
  return one;
}

SteppedScene scene_from(const json& record) {
  Reader reader(record, "/scene");
  SteppedScene scene;
  finite_numbers(reader, "gravity", scene.gravity);
  scene.restitution = number_from(reader, "restitution", 0, 1);
  scene.friction = number_from(reader, "friction", 0, std::numeric_limits<double>::max());
  scene.is_continuous = flag(reader, "continuous");
  const json& bodies = reader.required("bodies");
  if (!bodies.is_array() || bodies.empty()) {
    throw FormatError("/scene/bodies", "expected an array of bodies" + carom::detail::found(bodies));
  }
  for (const json& body : bodies) {
    scene.bodies.push_back(body_from(body, fmt::format("/scene/bodies/{}", scene.bodies.size())));
  }
  reader.reject_others();
  return scene;
}

std::vector<BodyState> states_from(const json& values, const std::string& place, std::size_t bodies) {
  if (!values.is_array() || values.size() != bodies) {
    throw FormatError(place, fmt::format("expected the states of {} bodies", bodies) + carom::detail::found(values));
  }
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
  if (reader.required("protocol") != version) {
    throw FormatError("/protocol", fmt::format("expected {}", version) + carom::detail::found(reply.at("protocol")));
  }
  if (!flag(reader, "time")) {
    throw FormatError("/time", "is missing or false: the program does not answer `run`");
  }
  Stepper stepper;
  stepper.name = text(reader, "name", longest_text);
  if (stepper.name.empty()) {
    throw FormatError("/name", "is empty; expected a name");
  }
  stepper.version = reader.has("version") ? text(reader, "version", longest_text) : "";
  stepper.precision = precision_named(text(reader, "precision", longest_text));
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

RunRequest run_request_from(std::string_view line) {
  const json record = parse_json(line);
  Reader reader(record, "");
  RunRequest request{};
  (void)reader.has("cmd");
  request.id = count(reader.required("id"), "/id");
  request.stepping.step = number_above(reader, "step", 0);
  const std::uint64_t steps = count(reader.required("steps"), "/steps");
  const json& report = reader.required("report");
  if (!report.is_array() || report.empty()) {
    throw FormatError("/report", "expected an array of numbers of steps" + carom::detail::found(report));
  }
  for (const json& after : report) {
    const std::string place = fmt::format("/report/{}", request.stepping.report.size());
    const std::uint64_t number = count(after, place);
    if (number > steps || (!request.stepping.report.empty() && number <= request.stepping.report.back())) {
      throw FormatError(
          place, "expected ascending numbers of steps, each once and at most `steps`" + carom::detail::found(after));
    }
    request.stepping.report.push_back(number);
  }
  request.stepping.scene = scene_from(reader.required("scene"));
  reader.reject_others();
  return request;
}

std::string run_reply(std::uint64_t id, const SteppingAnswer& answer) {
  if (const auto* const skipped = std::get_if<Skipped>(&answer)) {
    return json{{"id", id}, {"skipped", skipped->why}}.dump() + '\n';
  }
  if (const auto* const states = std::get_if<SteppedStates>(&answer)) {
    json all = json::array();
    for (const std::vector<BodyState>& of_bodies : states->states) {
      json bodies = json::array();
      for (const BodyState& state : of_bodies) {
        add_state(bodies.emplace_back(json::object()), state);
      }
      all.push_back(std::move(bodies));
    }
    return json{{"id", id}, {"states", std::move(all)}, {"seconds", states->seconds}}.dump() + '\n';
  }
  const auto* const refused = std::get_if<Refused>(&answer);
  return json{{"id", id}, {"error", refused != nullptr ? refused->why : std::get<Failed>(answer).why}}.dump() + '\n';
}

SteppingAnswer run_reply_from(std::string_view line, std::uint64_t id, const Stepping& stepping) {
  const json reply = parse_json(line);
  Reader reader = reader_of_reply(reply, id);
  const bool is_skipped = reader.has("skipped");
  const bool is_refused = reader.has("error");
  if ((is_skipped ? 1 : 0) + (is_refused ? 1 : 0) + (reader.has("states") ? 1 : 0) != 1) {
    throw FormatError("expected exactly one of: states, skipped, error");
  }
  if (is_skipped) {
    return Skipped{text(reader, "skipped", longest_reason)};
  }
  if (is_refused) {
    return Refused{text(reader, "error", longest_reason)};
  }
  const json& states = reader.required("states");
  if (!states.is_array() || states.size() != stepping.report.size()) {
    throw FormatError("/states", fmt::format("expected the states after {} numbers of steps", stepping.report.size()) +
                                     carom::detail::found(states));
  }
  SteppedStates answer;
  for (const json& one : states) {
    answer.states.push_back(
        states_from(one, fmt::format("/states/{}", answer.states.size()), stepping.scene.bodies.size()));
  }
  answer.seconds = number_from(reader, "seconds", 0, std::numeric_limits<double>::max());
  return answer;
}

}  // namespace carom::subjects::protocol
