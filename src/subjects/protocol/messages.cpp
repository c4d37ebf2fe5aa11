// SPDX-License-Identifier: BSL-1.0
#include <array>
#include <cmath>
#include <cstdlib>
#include <optional>

#include <fmt/format.h>

#include <carom/collision/expects.hpp>
#include <carom/collision/json/json.hpp>
#include <carom/collision/json/text.hpp>
#include <carom/collision/validate.hpp>
#include <carom/impulse/normal_velocity.hpp>
#include <carom/subjects/protocol/messages.hpp>
#include <carom/subjects/protocol/spelling.hpp>

namespace carom::subjects::protocol {
namespace {

using nlohmann::json;

constexpr std::size_t longest_name = 100;  // bytes

template <class Json>
const Json& required(const Json& object, const char* name) {
  if (!object.is_object()) {
    throw FormatError("expected an object");
  }
  const auto found = object.find(name);
  if (found == object.end()) {
    throw FormatError(std::string("/") + name, "is missing; add this field");
  }
  return *found;
}

template <class Json>
std::string text_of(const Json& value, const std::string& place, std::size_t longest) {
  if (!value.is_string()) {
    throw FormatError(place, "expected a string");
  }
  return printable_line(value.template get<std::string>(), longest);
}

template <class Json>
std::string required_text(const Json& object, const char* name, std::size_t longest) {
  return text_of(required(object, name), std::string("/") + name, longest);
}

Law law_claimed(const std::string& name) {
  if (const std::optional<Law> law = law_named(name)) {
    return *law;
  }
  throw FormatError("/model", "expected frictionless, reflection, sticking, rough, coulomb or any, found " + name);
}

void require_version(const json& introduction) {
  const json& protocol = required(introduction, "protocol");
  if (protocol != version) {
    throw FormatError("/protocol",
                      fmt::format("expected {}, found {}", version, printable(protocol.dump(), longest_name)));
  }
}

/// The shortest text that a reader of this precision parses as exactly this number.
std::string in_digits(long double number, Precision precision) {
  const auto rounded = static_cast<double>(number);
  if (!std::isfinite(number)) {
    return number_to_json(rounded).dump();
  }
  const std::string text = fmt::format("{}", rounded);
  const bool is_exact = precision != Precision::extended || std::strtold(text.c_str(), nullptr) == number;
  return is_exact ? text : fmt::format("{:.21g}", number);
}

std::string vector_text(const Vector3<long double>& v, Precision precision) {
  return fmt::format("[{},{},{}]", in_digits(v[0], precision), in_digits(v[1], precision), in_digits(v[2], precision));
}

std::string motion_text(const BodyVelocity<long double>& motion, Precision precision) {
  return fmt::format(R"({{"velocity":{},"angular_velocity":{}}})", vector_text(motion.velocity, precision),
                     vector_text(motion.angular_velocity, precision));
}

/// The field C, with a comma before it; empty if there is no matrix.
std::string matrix_text(const std::optional<Matrix3<long double>>& matrix, Precision precision) {
  if (!matrix) {
    return {};
  }
  const auto row = [&](int i) { return vector_text(matrix->row(i), precision); };
  return fmt::format(",\"C\":[{},{},{}]", row(0), row(1), row(2));
}

DeclaredEffects effects_from(const json& claims) {
  if (!claims.is_object()) {
    throw FormatError("/claims", "expected an object");
  }
  DeclaredEffects effects;
  for (const auto& [name, size] : claims.items()) {
    const std::string place = "/claims/" + printable_line(name, longest_name);
    const std::optional<DeclaredEffect> effect = declared_effect_named(name);
    if (!effect) {
      std::string known;
      for (const DeclaredEffect one : all_declared_effects) {
        known += fmt::format("{}{}", known.empty() ? "" : ", ", name_of(one));
      }
      throw FormatError(place, "is not an effect that a subject can declare; expected one of " + known);
    }
    if (!size.is_number() || !is_valid_size(*effect, size.get<double>())) {
      throw FormatError(
          place, fmt::format("expected a positive number{}, found {}", unit_of(*effect).empty() ? " below 1" : "",
                             printable(size.dump(), longest_name)));
    }
    effects[*effect] = size.get<double>();
  }
  return effects;
}

Numbers numbers_from(const json& form, Precision precision) {
  if (form == "decimal") {
    return Numbers::decimal;
  }
  if (form != "hex") {
    throw FormatError("/numbers", "expected decimal or hex, found " + printable(form.dump(), longest_name));
  }
  if (precision == Precision::extended) {
    throw FormatError("/numbers", "hex has the bits of binary64, but the precision is extended; expected decimal");
  }
  return Numbers::hex;
}

}  // namespace

Precision precision_named(const std::string& name) {
  for (const Precision precision : {Precision::binary32, Precision::binary64, Precision::extended}) {
    if (name_of(precision) == name) {
      return precision;
    }
  }
  throw FormatError("/precision", "expected binary32, binary64 or extended, found " + name);
}

void introduce(Subject& subject, const Introduction& introduction) {
  subject.name = introduction.name;
  subject.version = introduction.version;
  subject.law = introduction.law;
  subject.precision = introduction.precision;
  subject.deviates = introduction.deviates;
  subject.domain = introduction.domain;
  subject.effects = introduction.effects;
  subject.shows_collision_matrix = introduction.matrix;
}

std::string start_request() { return json{{"cmd", "start"}, {"protocol", version}}.dump() + '\n'; }

std::string solve_request(std::uint64_t id, const Collision& collision, unsigned spelling) {
  CAROM_EXPECTS(spelling < spelling_count, spelling);
  constexpr std::array<const char*, spelling_count> orders{
      R"({{"cmd":"solve","id":{id},"collision":{collision}}})",
      R"({{"id":{id},"cmd":"solve","collision":{collision}}})",
      R"({{"collision":{collision},"id":{id},"cmd":"solve"}})",
      R"({{ "cmd": "solve", "collision": {collision}, "id": {id} }})"};
  return fmt::format(fmt::runtime(orders.at(spelling)), fmt::arg("id", id),
                     fmt::arg("collision", spelt(collision, spelling))) +
         '\n';
}

std::string stop_request() { return json{{"cmd", "stop"}}.dump() + '\n'; }

Introduction introduction_from(std::string_view line) {
  const json reply = parse_json(line);
  require_version(reply);
  Introduction introduction;
  introduction.name = required_text(reply, "name", longest_name);
  if (introduction.name.empty()) {
    throw FormatError("/name", "is empty; expected a name");
  }
  if (reply.contains("version")) {
    introduction.version = required_text(reply, "version", longest_name);
  }
  introduction.precision = precision_named(required_text(reply, "precision", longest_name));
  introduction.law = law_claimed(required_text(reply, "model", longest_name));
  if (reply.contains("deviates")) {
    const json& deviates = reply.at("deviates");
    if (!deviates.is_array()) {
      throw FormatError("/deviates", "expected an array of names of invariants");
    }
    for (const json& name : deviates) {
      introduction.deviates.push_back(text_of(name, "/deviates", longest_name));
    }
  }
  if (reply.contains("domain")) {
    introduction.domain = domain_from_json(reply.at("domain"), "/domain");
  }
  if (reply.contains("claims")) {
    introduction.effects = effects_from(reply.at("claims"));
  }
  if (reply.contains("matrix")) {
    const json& matrix = reply.at("matrix");
    if (!matrix.is_boolean()) {
      throw FormatError("/matrix", "expected true or false, found " + printable(matrix.dump(), longest_name));
    }
    introduction.matrix = matrix.get<bool>();
  }
  if (reply.contains("numbers")) {
    introduction.numbers = numbers_from(reply.at("numbers"), introduction.precision);
  }
  return introduction;
}

Answer answer_from(std::string_view line, std::uint64_t id, Precision precision, bool shows_matrix) {
  const auto reply = parse_reply(line, precision);
  const WideJson& reply_id = required(reply, "id");
  if (!reply_id.is_number_integer() || reply_id != id) {
    throw FormatError("/id", fmt::format("expected {}, found {}", id, printable(json(reply_id).dump(), longest_name)));
  }
  const bool is_outcome = reply.contains("a") || reply.contains("b");
  const bool is_skipped = reply.contains("skipped");
  const bool is_refused = reply.contains("error");
  if ((is_outcome ? 1 : 0) + (is_skipped ? 1 : 0) + (is_refused ? 1 : 0) != 1) {
    throw FormatError("expected exactly one of: the outcome a and b, skipped, error");
  }
  if (is_skipped) {
    return Skipped{required_text(reply, "skipped", longest_reason)};
  }
  if (is_refused) {
    return Refused{required_text(reply, "error", longest_reason)};
  }
  const auto in_precision = [&](long double number) {
    return precision == Precision::extended ? number : static_cast<long double>(static_cast<double>(number));
  };
  ReportedOutcome outcome = map_outcome<long double>(outcome_from_json(reply), in_precision);
  if (shows_matrix && reply.contains("C")) {
    outcome.collision_matrix = collision_matrix_from_json(reply).unaryExpr(in_precision);
  }
  return outcome;
}

bool owes_matrix(const Collision& collision, const Outcome<long double>& outcome, Precision precision) {
  const auto computed = [&](auto number) {
    return precision == Precision::binary32 ? static_cast<long double>(static_cast<float>(number))
                                            : static_cast<long double>(number);
  };
  const bool can_move = !(collision.a.immovable && collision.b.immovable);
  const Outcome<double> before = unchanged(collision);
  bool is_changed = false;
  for (const OutcomeVector k : all_outcome_vectors) {
    for (int i = 0; i < 3; ++i) {
      is_changed = is_changed || computed((*vectors(outcome)[k])[i]) != computed((*vectors(before)[k])[i]);
    }
  }
  return can_move && is_changed && validate(collision).empty() && impulse::normal_velocity_sign(collision, before) < 0;
}

std::string introduction_reply(const Introduction& introduction) {
  json reply{{"protocol", version},
             {"name", introduction.name},
             {"version", introduction.version},
             {"precision", name_of(introduction.precision)},
             {"model", name_of(introduction.law)},
             {"deviates", introduction.deviates}};
  if (introduction.matrix) {
    reply["matrix"] = true;
  }
  if (introduction.numbers == Numbers::hex) {
    reply["numbers"] = "hex";
  }
  if (!introduction.domain.empty()) {
    reply["domain"] = domain_to_json(introduction.domain);
  }
  for (const DeclaredEffect effect : all_declared_effects) {
    if (introduction.effects[effect] != 0) {
      reply["claims"][std::string(name_of(effect))] = introduction.effects[effect];
    }
  }
  return reply.dump() + '\n';
}

std::string answer_reply(std::uint64_t id, const Answer& answer, Precision precision) {
  if (const auto* outcome = std::get_if<ReportedOutcome>(&answer)) {
    return fmt::format("{{\"id\":{},\"a\":{},\"b\":{}{}}}\n", id, motion_text(outcome->a, precision),
                       motion_text(outcome->b, precision), matrix_text(outcome->collision_matrix, precision));
  }
  if (const auto* skipped = std::get_if<Skipped>(&answer)) {
    return json{{"id", id}, {"skipped", skipped->why}}.dump() + '\n';
  }
  const auto* refused = std::get_if<Refused>(&answer);
  return json{{"id", id}, {"error", refused != nullptr ? refused->why : std::get<Failed>(answer).why}}.dump() + '\n';
}

}  // namespace carom::subjects::protocol
