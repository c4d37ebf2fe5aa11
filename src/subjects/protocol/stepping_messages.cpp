// SPDX-License-Identifier: BSL-1.0
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

#include <fmt/format.h>
#include <fmt/ranges.h>

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

std::uint64_t count(const json& value, const std::string& place) {
  require(value.is_number_unsigned() && value.get<std::uint64_t>() <= most_steps, place,
          fmt::format("a whole number from 0 to {}", most_steps), value);
  return value.get<std::uint64_t>();
}

double positive_number(Reader& reader, const char* name) {
  double number = 0;
  reader.number(name, number);
  require(std::isfinite(number) && number > 0, reader.at(name), "a number above 0", reader.required(name));
  return number;
}

double number_up_to(Reader& reader, const char* name, double most) {
  double number = 0;
  reader.number(name, number);
  require(number >= 0 && number <= most, reader.at(name), fmt::format("a number from 0 to {}", most),
          reader.required(name));
  return number;
}

template <class Vector>
void finite_numbers(Reader& reader, const char* name, Vector& into) {
  reader.numbers(name, into);
  require(into.allFinite(), reader.at(name), "finite numbers", reader.required(name));
}

Vector3<double> positive_numbers(Reader& reader, const char* name) {
  Vector3<double> numbers;
  finite_numbers(reader, name, numbers);
  require((numbers.array() > 0).all(), reader.at(name), "numbers above 0", reader.required(name));
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

/// The only one of these fields that the object has.
std::string_view only_of(Reader& reader, const std::string& place, const std::array<const char*, 3>& names) {
  const auto has = [&](const char* name) { return reader.has(name); };
  if (std::count_if(names.begin(), names.end(), has) != 1) {
    throw FormatError(place, fmt::format("expected exactly one of {}", fmt::join(names, ", ")));
  }
  return *std::find_if(names.begin(), names.end(), has);
}

Shape shape_of(Reader& reader, const std::string& place) {
  const std::string_view kind = only_of(reader, place, {"sphere", "box", "half_space"});
  if (kind == "sphere") {
    return SphereShape{positive_number(reader, "sphere")};
  }
  if (kind == "box") {
    return BoxShape{positive_numbers(reader, "box")};
  }
  HalfSpaceShape half_space;
  finite_numbers(reader, "half_space", half_space.normal);
  require(!half_space.normal.isZero(0), reader.at("half_space"), "a normal of nonzero length",
          reader.required("half_space"));
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
    require(!one.state.orientation.isZero(0), reader.at("orientation"), "a quaternion of nonzero length",
            reader.required("orientation"));
  }
  if (!one.is_fixed) {
    one.mass = positive_number(reader, "mass");
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
  scene.restitution = number_up_to(reader, "restitution", 1);
  scene.friction = number_up_to(reader, "friction", std::numeric_limits<double>::max());
  scene.is_continuous = flag(reader, "continuous");
  const json& bodies = reader.required("bodies");
  require(bodies.is_array() && !bodies.empty(), "/scene/bodies", "an array of bodies", bodies);
  for (const json& body : bodies) {
    scene.bodies.push_back(body_from(body, fmt::format("/scene/bodies/{}", scene.bodies.size())));
  }
  reader.reject_others();
  return scene;
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

RunRequest run_request_from(std::string_view line) {
  const json record = parse_json(line);
  Reader reader(record, "");
  RunRequest request{};
  (void)reader.has("cmd");
  request.id = count(reader.required("id"), "/id");
  request.stepping.step = positive_number(reader, "step");
  const std::uint64_t steps = count(reader.required("steps"), "/steps");
  const json& report = reader.required("report");
  require(report.is_array() && !report.empty(), "/report", "an array of numbers of steps", report);
  std::vector<std::uint64_t>& numbers = request.stepping.report;
  for (const json& after : report) {
    const std::string place = fmt::format("/report/{}", numbers.size());
    const std::uint64_t number = count(after, place);
    require(number <= steps && (numbers.empty() || number > numbers.back()), place,
            "ascending numbers of steps, each once and at most `steps`", after);
    numbers.push_back(number);
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
  const std::string_view kind = only_of(reader, "reply", {"states", "skipped", "error"});
  if (kind == "skipped") {
    return Skipped{text(reader, "skipped", longest_reason)};
  }
  if (kind == "error") {
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
  answer.seconds = number_up_to(reader, "seconds", std::numeric_limits<double>::max());
  return answer;
}

}  // namespace carom::subjects::protocol
