// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <memory>
#include <span>
#include <stdexcept>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <carom/collision/doubles.hpp>
#include <carom/collision/json/json.hpp>
#include <carom/collision/subject.hpp>
#include <carom/properties/cases/family.hpp>
#include <carom/properties/gate/gate.hpp>

/// The answers of a subject in the order of its questions, as bytes. So two builds of the judge can judge the same
/// answers, although compilers round a solver differently.
namespace carom::web_tests {

class ByteWriter {
 public:
  template <class T>
  void operator()(const T& value) {
    bytes_.append(reinterpret_cast<const char*>(&value), sizeof value);
  }
  void text(const std::string& text) {
    (*this)(static_cast<unsigned>(text.size()));
    bytes_ += text;
  }
  [[nodiscard]] const std::string& bytes() const { return bytes_; }

 private:
  std::string bytes_;
};

class ByteReader {
 public:
  explicit ByteReader(const std::string& bytes) : bytes_(&bytes) {}
  template <class T>
  void operator()(T& value) {
    std::memcpy(&value, taken(sizeof value), sizeof value);
  }
  [[nodiscard]] std::string text() {
    unsigned size = 0;
    (*this)(size);
    return {taken(size), size};
  }
  [[nodiscard]] bool is_at_end() const { return at_ == bytes_->size(); }

 private:
  const char* taken(std::size_t size) {
    if (bytes_->size() - at_ < size) {
      throw std::runtime_error("the judge asks more questions than were recorded");
    }
    at_ += size;
    return bytes_->data() + at_ - size;
  }

  const std::string* bytes_;
  std::size_t at_ = 0;
};

/// FNV-1a of the bits of the collision's numbers.
inline std::uint64_t hash_of(const Collision& collision) {
  std::uint64_t hash = 0xcbf29ce484222325;
  for (const double number : doubles_of(collision)) {
    std::uint64_t bits = 0;
    std::memcpy(&bits, &number, sizeof bits);
    hash = (hash ^ bits) * 0x100000001b3;
  }
  return hash;
}

enum class AnswerKind : char { outcome, refused, skipped, failed };

inline void write(ByteWriter& write, const Collision& collision, const Answer& answer) {
  write(hash_of(collision));
  write(static_cast<AnswerKind>(answer.index() == 0 ? 0 : answer.index() == 1 ? 2 : answer.index() == 2 ? 1 : 3));
  if (const auto* outcome = std::get_if<ReportedOutcome>(&answer)) {
    write(doubles_of(static_cast<const Outcome<long double>&>(*outcome)));
    write(outcome->collision_matrix.has_value());
    if (outcome->collision_matrix) {
      write(doubles_of(*outcome->collision_matrix));
    }
  } else if (const auto* refused = std::get_if<Refused>(&answer)) {
    write.text(refused->why);
  } else if (const auto* skipped = std::get_if<Skipped>(&answer)) {
    write.text(skipped->why);
  } else {
    write.text(std::get<Failed>(answer).why);
  }
}

/// Throws std::runtime_error if the recorded question was another one.
inline Answer read(ByteReader& read, const Collision& collision) {
  std::uint64_t asked = 0;
  read(asked);
  if (asked != hash_of(collision)) {
    throw std::runtime_error("the judge asks another question than the one that was recorded");
  }
  AnswerKind kind{};
  read(kind);
  switch (kind) {
    case AnswerKind::refused:
      return Refused{read.text()};
    case AnswerKind::skipped:
      return Skipped{read.text()};
    case AnswerKind::failed:
      return Failed{read.text()};
    case AnswerKind::outcome:
      break;
  }
  std::array<double, doubles_of_an_outcome> velocities{};
  read(velocities);
  ReportedOutcome outcome(outcome_of<long double>(velocities));
  bool has_matrix = false;
  read(has_matrix);
  if (has_matrix) {
    std::array<double, doubles_of_a_matrix> matrix{};
    read(matrix);
    outcome.collision_matrix = matrix_of<long double>(matrix);
  }
  return outcome;
}

/// The subject, which also writes its answers. `writer` outlives the subject.
[[nodiscard]] inline Subject recording(Subject subject, ByteWriter& writer) {
  subject.open = [open = subject.open, &writer] {
    auto session = std::make_shared<Session>(open());
    return Session(
        [session, &writer](std::span<const Collision> collisions) {
          std::vector<Answer> answers = (*session)(collisions);
          for (std::size_t i = 0; i < answers.size(); ++i) {
            write(writer, collisions[i], answers[i]);
          }
          return answers;
        },
        [session] { session->close(); });
  };
  return subject;
}

/// The subject, with recorded answers in place of its own. `reader` outlives the subject.
[[nodiscard]] inline Subject replaying(Subject subject, ByteReader& reader) {
  subject.open = [&reader] {
    return Session([&reader](std::span<const Collision> collisions) {
      std::vector<Answer> answers;
      for (const Collision& collision : collisions) {
        answers.push_back(read(reader, collision));
      }
      return answers;
    });
  };
  return subject;
}

inline nlohmann::json family_record(const properties::FamilyResult& result) {
  nlohmann::json record = {{"cases", result.cases}, {"worst", fmt::format("{:.3g}", result.worst_backward_error)}};
  for (const auto& [invariant, count] : result.counts) {
    record["counts"][std::string(invariant->name)] = {count.holds, count.violated, count.skipped};
  }
  return record;
}

/// The verdicts on the first cases of every family: the status, the counts of each family, the witnesses, and figures
/// of three digits.
inline nlohmann::json verdicts_on(const Subject& subject, std::uint64_t cases) {
  properties::GateOptions options;
  options.cases = cases;
  options.relations_every = 1;
  options.families = properties::pointers_to(properties::all_families());
  const properties::SubjectResult result = properties::run_gate({subject}, options).results[0];
  nlohmann::json record = {{"subject", subject.name},
                           {"error", result.error},
                           {"not_judged", result.not_judged},
                           {"sound", result.is_sound()},
                           {"witnesses", nlohmann::json::object()}};
  for (std::size_t f = 0; f < result.families.size(); ++f) {
    record["families"][std::string(options.families[f]->name)] = family_record(result.families[f]);
  }
  for (const properties::Witness& witness : result.witnesses) {
    record["witnesses"][std::string(witness.invariant->name)] = {
        {"family", witness.family->name},
        {"case", witness.index},
        {"collision", collision_to_json(witness.shrunk.collision)},
        {"residual", fmt::format("{:.3g}", witness.verdict.residual)},
        {"allowed", fmt::format("{:.3g}", witness.verdict.allowed)}};
  }
  if (const auto digits = result.digits_at_least(0.5)) {
    record["digits"] = fmt::format("{:.3g}", *digits);
  }
  return record;
}

}  // namespace carom::web_tests
