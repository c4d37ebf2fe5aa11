// SPDX-License-Identifier: BSL-1.0
#include <algorithm>
#include <cstdlib>
#include <stdexcept>
#include <string>
#include <vector>

#include <fmt/format.h>

#include <carom/report/results/values_json.hpp>

namespace carom::report {
namespace {

using nlohmann::json;
using properties::Status;
using properties::Verdict;

template <class S, class Convert>
json velocities_record(const Outcome<S>& outcome, const Convert& convert) {
  const auto vector = [&](const Vector3<S>& v) { return json::array({convert(v[0]), convert(v[1]), convert(v[2])}); };
  const auto body = [&](const BodyVelocity<S>& motion) {
    return json{{"velocity", vector(motion.velocity)}, {"angular_velocity", vector(motion.angular_velocity)}};
  };
  return {{"a", body(outcome.a)}, {"b", body(outcome.b)}};
}

json outcome_record(const ReportedOutcome& outcome) {
  const auto number_record = [](long double number) -> json {
    const auto rounded = static_cast<double>(number);
    const bool is_binary64 = static_cast<long double>(rounded) == number || number != number;
    return is_binary64 ? number_to_json(rounded) : json(fmt::format("{:.21g}", number));
  };
  json record = velocities_record<long double>(outcome, number_record);
  if (outcome.collision_matrix) {
    for (int i = 0; i < 3; ++i) {
      json row = json::array();
      for (int j = 0; j < 3; ++j) {
        row.push_back(number_record((*outcome.collision_matrix)(i, j)));
      }
      record["C"].push_back(std::move(row));
    }
  }
  return record;
}

/// Reads a number, or a string for a number that binary64 cannot represent.
long double wide_number(const Field& field) {
  if (!field.value().is_string()) {
    return static_cast<long double>(field.number());
  }
  const std::string text = field.text();
  char* end = nullptr;
  const long double number = std::strtold(text.c_str(), &end);
  if (text.empty() || end != text.c_str() + text.size()) {
    field.fail("a number");
  }
  return number;
}

Vector3<long double> vector_from(const Field& field) {
  const std::vector<Field> numbers = field.elements();
  if (numbers.size() != 3) {
    field.fail("three numbers");
  }
  return {wide_number(numbers[0]), wide_number(numbers[1]), wide_number(numbers[2])};
}

BodyVelocity<long double> motion_from(const Field& field) {
  return {vector_from(field.at("velocity")), vector_from(field.at("angular_velocity"))};
}

Matrix3<long double> matrix_from(const Field& field) {
  const std::vector<Field> rows = field.elements();
  if (rows.size() != 3) {
    field.fail("three rows");
  }
  Matrix3<long double> matrix;
  for (std::size_t i = 0; i < 3; ++i) {
    matrix.row(static_cast<Eigen::Index>(i)) = vector_from(rows[i]);
  }
  return matrix;
}

template <class A>
void violation_fields(A& archive, Is<Verdict> auto& verdict) {
  archive("detail", verdict.detail);
  archive("left", verdict.left);
  archive("right", verdict.right);
  archive("residual", verdict.residual);
  archive("allowed", verdict.allowed);
}

/// A field for each effect that has another value than 0.
template <class Values>
json record_of(const Values& values) {
  json record = json::object();
  for (const DeclaredEffect effect : all_declared_effects) {
    if (values[effect] != 0) {
      record[std::string(name_of(effect))] = values[effect];
    }
  }
  return record;
}

/// The effect with this name. Throws FormatError at `place`.
DeclaredEffect known_effect(const std::string& name, const Field& place) {
  const std::optional<DeclaredEffect> effect = declared_effect_named(name);
  if (!effect) {
    place.fail("no field of this name, because it is not an effect that a subject can declare");
  }
  return *effect;
}

}  // namespace

const properties::Invariant& invariant_at(const std::string& name, const Field& place) {
  const properties::Invariant* invariant = properties::invariant_named(name);
  if (invariant == nullptr) {
    place.fail("the name of an invariant");
  }
  return *invariant;
}

const properties::Family* Json<const properties::Family*>::read(const Field& field) {
  const properties::Family* family = properties::family_named(field.text());
  if (family == nullptr) {
    field.fail("the name of a family");
  }
  return family;
}

json Json<Answer>::write(const Answer& answer) {
  if (const auto* outcome = std::get_if<ReportedOutcome>(&answer)) {
    return outcome_record(*outcome);
  }
  if (const auto* refused = std::get_if<Refused>(&answer)) {
    return {{"refused", refused->why}};
  }
  if (const auto* failed = std::get_if<Failed>(&answer)) {
    return {{"failed", failed->why}, {"said", failed->said}};
  }
  return {{"skipped", std::get<Skipped>(answer).why}};
}

Answer Json<Answer>::read(const Field& field) {
  if (const auto refused = field.find("refused")) {
    return Refused{refused->text()};
  }
  if (const auto skipped = field.find("skipped")) {
    return Skipped{skipped->text()};
  }
  if (const auto failed = field.find("failed")) {
    return Failed{failed->text(), field.at("said").text()};
  }
  ReportedOutcome outcome(motion_from(field.at("a")), motion_from(field.at("b")));
  if (const auto matrix = field.find("C")) {
    outcome.collision_matrix = matrix_from(*matrix);
  }
  return outcome;
}

json Json<Verdict>::write(const Verdict& verdict) {
  switch (verdict.status) {
    case Status::holds:
      return {{"status", "holds"}};
    case Status::skipped:
      return {{"status", "skipped"}, {"detail", verdict.detail}};
    case Status::violated:
      break;
  }
  Writer writer;
  writer("status", std::string("violated"));
  violation_fields(writer, verdict);
  return std::move(writer.record);
}

Verdict Json<Verdict>::read(const Field& field) {
  const Field status = field.at("status");
  if (status.text() != "violated") {
    status.fail("\"violated\"");
  }
  Verdict verdict;
  verdict.status = Status::violated;
  Reader reader(field);
  violation_fields(reader, verdict);
  verdict.kind = verdict.left.empty() ? properties::kind_of_detail(verdict.detail) : verdict.kind;
  return verdict;
}

json Json<oracles::Limits>::write(const oracles::Limits& limits) {
  json record{{"limit_ulps", limits.limit_ulps}};
  if (limits.digits) {
    record["digits"] = *limits.digits;
  }
  if (!limits.filtered) {
    record["exact"] = true;
  }
  return record;
}

oracles::Limits Json<oracles::Limits>::read(const Field& record) {
  oracles::Limits limits;
  limits.limit_ulps = record.at("limit_ulps").number();
  if (const std::optional<Field> digits = record.find("digits")) {
    constexpr std::uint64_t most = 18;
    if (digits->count() < 1 || digits->count() > most) {
      digits->fail("a number from 1 to 18");
    }
    limits.digits = static_cast<int>(digits->count());
  }
  const std::optional<Field> exact = record.find("exact");
  limits.filtered = !(exact && exact->flag());
  return limits;
}

namespace {

template <class T>
json velocities_and_impulse(const oracles::Truth<T>& truth) {
  json record = velocities_record(truth.outcome, [](const T& x) { return oracles::to_text(x); });
  record["impulse"] = json::array();
  for (int i = 0; i < 3; ++i) {
    record["impulse"].push_back(oracles::to_text(truth.impulse[i]));
  }
  return record;
}

template <class T>
json nearest_record(const Outcome<T>& outcome) {
  return velocities_record(outcome, [](const T& x) { return number_to_json(oracles::nearest_double(x)); });
}

}  // namespace

json truth_record(const oracles::ExactCase& exact_case, Law law) {
  return exact_case.with_truth(law, exact_case.state(), []<class T>(const oracles::Truth<T>& truth) {
    json record = velocities_and_impulse(truth);
    record["nearest"] = nearest_record(truth.outcome);
    return record;
  });
}

json answers_record(std::span<const oracles::CoulombAnswer> answers) {
  json record = json::array();
  for (const oracles::CoulombAnswer& answer : answers) {
    json of_answer = answer.is_exact() ? velocities_and_impulse(answer.truth) : json::object();
    of_answer["kind"] = name_of(answer.kind);
    of_answer["exact"] = answer.is_exact();
    of_answer["nearest"] = nearest_record(answer.truth.outcome);
    record.push_back(std::move(of_answer));
  }
  return record;
}

json Json<properties::Domain>::write(const properties::Domain& domain) {
  json record = json::object();
  for (const properties::LimitedQuantity quantity : properties::all_limited_quantities) {
    const properties::Range& range = domain.ranges[quantity];
    const properties::Range whole = properties::whole_range(quantity);
    if (range != whole) {
      record[std::string(name_of(quantity))] = {range.least == whole.least ? json() : json(range.least),
                                                range.most == whole.most ? json() : json(range.most)};
    }
  }
  for (const auto& [name, value] : texts_of(domain.kinds)) {
    record[std::string(name)] = value;
  }
  return record;
}

properties::Domain Json<properties::Domain>::read(const Field& field) {
  properties::Domain domain;
  for (const auto& [name, of_quantity] : field.members()) {
    const std::optional<properties::LimitedQuantity> quantity = properties::quantity_named(name);
    const bool is_kind = std::ranges::count(properties::kind_names(), name) > 0;
    if (!quantity && !is_kind) {
      of_quantity.fail("no field of this name, because no quantity or kind has it");
    }
    try {
      if (is_kind) {
        properties::set_kind(domain.kinds, name, of_quantity.text());
        continue;
      }
      const std::vector<Field> ends = of_quantity.elements();
      if (ends.size() != 2) {
        of_quantity.fail("two numbers, the least and the greatest value; null for no limit");
      }
      properties::set_range(domain, *quantity, ends[0].optional_number(), ends[1].optional_number());
    } catch (const std::invalid_argument& error) {
      throw FormatError(of_quantity.place(), error.what());
    }
  }
  return domain;
}

json Json<DeclaredEffects>::write(const DeclaredEffects& effects) { return record_of(effects); }

DeclaredEffects Json<DeclaredEffects>::read(const Field& field) {
  DeclaredEffects effects;
  for (const auto& [name, size] : field.members()) {
    const DeclaredEffect effect = known_effect(name, size);
    if (!is_valid_size(effect, size.number())) {
      size.fail(unit_of(effect).empty() ? "a number above 0 and below 1" : "a positive number");
    }
    effects[effect] = size.number();
  }
  return effects;
}

json Json<properties::EffectCounts>::write(const properties::EffectCounts& counts) { return record_of(counts); }

properties::EffectCounts Json<properties::EffectCounts>::read(const Field& field) {
  properties::EffectCounts counts{};
  for (const auto& [name, count] : field.members()) {
    counts[known_effect(name, count)] = count.count();
  }
  return counts;
}

}  // namespace carom::report
