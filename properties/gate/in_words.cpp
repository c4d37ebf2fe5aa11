// SPDX-License-Identifier: BSL-1.0
#include <cmath>
#include <utility>

#include <fmt/format.h>

#include <carom/collision/json/json.hpp>
#include <carom/properties/gate/in_words.hpp>

namespace carom::properties {
namespace {

std::string body_in_words(const Body& body) {
  const std::string motion = fmt::format("at {}, velocity {}, angular velocity {}", in_words(body.position),
                                         in_words(body.velocity), in_words(body.angular_velocity));
  if (body.immovable) {
    return "immovable, " + motion;
  }
  const Quaternion<double>& q = body.orientation;
  return fmt::format("mass {}, principal inertia {}, orientation ({}, {}, {}, {}), {}", in_words(body.mass),
                     in_words(body.principal_inertia), in_words(q[0]), in_words(q[1]), in_words(q[2]), in_words(q[3]),
                     motion);
}

}  // namespace

std::string in_words(double number) { return std::isnan(number) ? "nan" : fmt::format("{}", number); }

std::string in_words(long double number) {
  const auto rounded = static_cast<double>(number);
  const bool is_binary64 = static_cast<long double>(rounded) == number || std::isnan(number);
  return is_binary64 ? in_words(rounded) : fmt::format("{:.21g}", number);
}

std::string in_words(const std::vector<double>& numbers) {
  std::string text;
  for (const double number : numbers) {
    text += (text.empty() ? "" : ", ") + in_words(number);
  }
  return numbers.size() == 1 ? text : '(' + text + ')';
}

namespace {

template <class T>
std::string short_or_rounded(const T& number) {
  constexpr std::size_t longest = 24;
  const std::string exact = oracles::to_text(number);
  return exact.size() <= longest ? exact : "≈" + in_words(oracles::nearest_double(number));
}

}  // namespace

std::string in_words(const oracles::Rational& number) { return short_or_rounded(number); }

std::string in_words(const oracles::Radical& number) { return short_or_rounded(number); }

std::string in_words(const Collision& c, const std::string& indent) {
  std::string text = fmt::format("{0}A: {1}\n{0}B: {2}\n{0}contact point {3}, normal {4}, restitution {5}\n", indent,
                                 body_in_words(c.a), body_in_words(c.b), in_words(c.point), in_words(c.normal),
                                 in_words(c.restitution));
  if (c.friction != 0 || c.tangential_restitution != 0) {
    text += fmt::format("{}friction {}, tangential restitution {}\n", indent, in_words(c.friction),
                        in_words(c.tangential_restitution));
  }
  return text;
}

std::string in_words(const ReportedOutcome& outcome, const std::string& indent) {
  std::string text;
  for (const auto& [name, motion] : {std::pair{'A', outcome.a}, std::pair{'B', outcome.b}}) {
    text += fmt::format("{}{}: velocity {}, angular velocity {}\n", indent, name, in_words(motion.velocity),
                        in_words(motion.angular_velocity));
  }
  if (outcome.collision_matrix) {
    const auto row = [&](int i) { return in_words(Vector3<long double>(outcome.collision_matrix->row(i))); };
    text += fmt::format("{}C: {}, {}, {}\n", indent, row(0), row(1), row(2));
  }
  return text;
}

std::string in_words(const Verdict& violated) {
  if (violated.left.empty()) {
    return violated.detail;
  }
  return fmt::format("{}: {} and {}, apart by {:.3g}, allowed {:.3g}", violated.detail, in_words(violated.left),
                     in_words(violated.right), violated.residual, violated.allowed);
}

std::string in_words(const oracles::JudgeError& error) {
  return fmt::format(
      "the judge failed on this collision, and no subject is at fault: {}\n{}  for `carom replay FILE`: {}\n",
      error.what(), in_words(error.collision(), "  "), collision_to_json(error.collision()).dump());
}

std::string why_failed(const std::function<void()>& work) {
  try {
    work();
    return {};
  } catch (const std::bad_alloc&) {
    throw;
  } catch (const std::exception& error) {
    return error.what();
  }
}

std::string indented(const std::string& text, const std::string& by) {
  std::string result;
  for (const char letter : text) {
    result += letter;
    result += letter == '\n' ? by : "";
  }
  return result;
}

std::string folded(const std::string& text, std::size_t width) {
  std::string result;
  std::size_t begin = 0;        // of the current line in the result
  std::size_t after_comma = 0;  // the place after the last comma; at most `begin` if the line has none
  for (const char letter : text) {
    if (result.size() - begin >= width && after_comma > begin && letter != '\n') {
      result.insert(after_comma, 1, '\n');
      begin = after_comma + 1;
    }
    result += letter;
    after_comma = letter == ',' ? result.size() : after_comma;
    begin = letter == '\n' ? result.size() : begin;
  }
  return result;
}

std::string violation_in_words(const Collision& collision, const Answer& answer, const Verdict& violated) {
  const auto* const failed = std::get_if<Failed>(&answer);
  if (failed != nullptr && failed->said.starts_with("request: ")) {
    // The request states the collision, as the subject read it.
    constexpr std::size_t width = 116;
    return fmt::format("    {}\n  {}\n", indented(folded(failed->said, width), "    "), in_words(violated));
  }
  std::string text = in_words(collision, "    ");
  if (const auto* outcome = std::get_if<ReportedOutcome>(&answer)) {
    text += "  answered\n" + in_words(*outcome, "    ");
  } else if (failed != nullptr && !failed->said.empty()) {
    text += "    " + indented(failed->said, "    ") + '\n';
  } else if (const auto* refused = std::get_if<Refused>(&answer)) {
    text += "  refused: " + refused->why + '\n';
  }
  return text + "  " + in_words(violated) + '\n';
}

}  // namespace carom::properties
