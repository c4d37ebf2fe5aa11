// SPDX-License-Identifier: BSL-1.0
#include "merge/read_witness.hpp"

#include <cmath>
#include <cstdlib>
#include <string>
#include <vector>

#include <carom/collision/json/json.hpp>

namespace carom::tool::merge {
namespace {

using compare::Field;

/// A number as itself; as text what binary64 has not.
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

std::vector<double> numbers_from(const Field& field) {
  std::vector<double> numbers;
  for (const Field& element : field.elements()) {
    numbers.push_back(element.number());
  }
  return numbers;
}

}  // namespace

Answer answer_from(const Field& field) {
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

properties::Verdict verdict_from(const Field& field) {
  const Field status = field.at("status");
  if (status.text() != "violated") {
    status.fail("\"violated\"");
  }
  properties::Verdict verdict;
  verdict.status = properties::Status::violated;
  verdict.detail = field.at("detail").text();
  verdict.residual = field.at("residual").number();
  verdict.allowed = field.at("allowed").number();
  verdict.left = numbers_from(field.at("left"));
  verdict.right = numbers_from(field.at("right"));
  return verdict;
}

properties::Witness witness_from(const Field& record) {
  const auto collision = [&](const char* name) {
    const Field field = record.at(name);
    return collision_from_json(field.value(), field.place());
  };
  const bool convex_uniform = record.at("convex_uniform").flag();
  properties::Witness witness;
  witness.invariant = record.at("invariant").text();
  witness.family = record.at("family").text();
  witness.index = record.at("case").count();
  witness.original = {collision("drawn"), convex_uniform};
  witness.shrunk = {collision("collision"), convex_uniform};
  witness.verdict = verdict_from(record.at("verdict"));
  witness.answer = answer_from(record.at("outcome"));
  witness.verdict_as_found = verdict_from(record.at("drawn_verdict"));
  witness.answer_as_found = answer_from(record.at("drawn_outcome"));
  witness.is_reproduced = record.at("reproduced").flag();
  return witness;
}

}  // namespace carom::tool::merge
