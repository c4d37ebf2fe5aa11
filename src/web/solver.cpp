// SPDX-License-Identifier: BSL-1.0
#include <cstdlib>
#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

#include <emscripten/emscripten.h>
#include <nlohmann/json.hpp>

#include <carom/collision/doubles.hpp>
#include <carom/collision/json/text.hpp>
#include <carom/collision/validate.hpp>
#include <carom/subjects/protocol/messages.hpp>
#include <carom/web/solver.hpp>

// Each function returns text in memory that the caller frees; empty for success.
EM_JS(char*, carom_open, (), { return Module.newText(Module.caromOpen()); });
EM_JS(char*, carom_close, (), { return Module.newText(Module.caromClose()); });
EM_JS(char*, carom_solve, (const double* collisions, int count, double* answers),
      { return Module.newText(Module.caromSolve(collisions, count, answers)); });
EM_JS(char*, carom_text, (int answer), { return Module.newText(Module.caromText(answer)); });
EM_JS(void, carom_progress, (double done, double all), {
  if (Module.caromProgress) {
    Module.caromProgress(done, all);
  }
});

namespace carom::web {
namespace {

constexpr std::size_t longest_text = 2000;  // bytes, as in the replies of programs

// An answer: its kind, the outcome, 1 if there is a matrix, the matrix.
constexpr std::size_t place_of_matrix = 1 + doubles_of_an_outcome;
constexpr std::size_t doubles_of_an_answer = place_of_matrix + 1 + doubles_of_a_matrix;

std::string taken(char* text) {
  const std::unique_ptr<char, void (*)(void*)> owned(text, std::free);
  return owned.get();
}

std::string text_of_answer(std::size_t place) {
  return printable_line(taken(carom_text(static_cast<int>(place))), longest_text);
}

Answer answer_from(const double* numbers, std::size_t place) {
  if (numbers[0] == 1) {
    return Refused{text_of_answer(place)};
  }
  if (numbers[0] == 2) {
    return Skipped{text_of_answer(place)};
  }
  ReportedOutcome outcome(
      outcome_of<long double>(std::span<const double, doubles_of_an_outcome>(numbers + 1, doubles_of_an_outcome)));
  if (numbers[place_of_matrix] == 1) {
    outcome.collision_matrix = matrix_of<long double>(
        std::span<const double, doubles_of_a_matrix>(numbers + place_of_matrix + 1, doubles_of_a_matrix));
  }
  return outcome;
}

/// The reason why the answer is none, although it has the right form; empty if it is one.
std::string why_no_answer(const Subject& subject, const Collision& collision, const Answer& answer) {
  const auto* outcome = std::get_if<ReportedOutcome>(&answer);
  const bool lacks_matrix = subject.shows_collision_matrix && outcome != nullptr && !outcome->collision_matrix &&
                            subjects::protocol::owes_matrix(collision, *outcome, subject.precision);
  return lacks_matrix ? "returned an invalid outcome: /C: is missing, but the contact collides and `matrix` is true"
                      : "";
}

class Solver {
 public:
  explicit Solver(const Subject& subject) : subject_(subject) {
    if (const std::string why = taken(carom_open()); !why.empty()) {
      throw std::runtime_error(printable(why, longest_text));
    }
  }

  [[nodiscard]] std::vector<Answer> solve(std::span<const Collision> collisions) {
    std::vector<double> requests;
    requests.reserve(collisions.size() * doubles_of_a_collision);
    for (const Collision& collision : collisions) {
      const auto doubles = doubles_of(collision);
      requests.insert(requests.end(), doubles.begin(), doubles.end());
    }
    std::vector<double> numbers(collisions.size() * doubles_of_an_answer);
    const std::string failure =
        taken(carom_solve(requests.data(), static_cast<int>(collisions.size()), numbers.data()));
    std::size_t answered = collisions.size();
    std::string why;
    if (!failure.empty()) {
      const nlohmann::json record = nlohmann::json::parse(failure);
      answered = record.at("answered").get<std::size_t>();
      why = record.at("failure").get<std::string>();
    }
    std::vector<Answer> answers;
    for (std::size_t i = 0; i < answered && i < collisions.size(); ++i) {
      Answer answer = answer_from(numbers.data() + i * doubles_of_an_answer, i);
      if (const std::string wrong = why_no_answer(subject_, collisions[i], answer); !wrong.empty()) {
        why = wrong;
        break;
      }
      answers.push_back(std::move(answer));
    }
    if (answers.size() < collisions.size()) {
      const std::string shown = printable(why, longest_text);
      const std::size_t line_end = shown.find('\n');
      throw SessionFailure(
          "solve: " + shown, answers,
          {shown.substr(0, line_end), line_end == std::string::npos ? "" : shown.substr(line_end + 1)});
    }
    return answers;
  }

  static void close() {
    if (const std::string why = taken(carom_close()); !why.empty()) {
      throw std::runtime_error(printable(why, longest_text));
    }
  }

 private:
  Subject subject_;
};

}  // namespace

Session open_solver(const Subject& subject) {
  const auto solver = std::make_shared<Solver>(subject);
  return {[solver](std::span<const Collision> collisions) { return solver->solve(collisions); },
          [] { Solver::close(); }};
}

void report_progress(std::uint64_t done, std::uint64_t all) {
  carom_progress(static_cast<double>(done), static_cast<double>(all));
}

}  // namespace carom::web
