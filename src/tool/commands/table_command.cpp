// SPDX-License-Identifier: BSL-1.0
#include <algorithm>
#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <carom/collision/json/json.hpp>
#include <carom/collision/model.hpp>
#include <carom/subjects/protocol/text.hpp>

#include "commands/commands.hpp"
#include "commands/report_file.hpp"

namespace carom::tool {
namespace {

using nlohmann::json;

constexpr std::size_t longest_cell = 4000;

/// Without what would end a cell, begin a tag, or do something to a terminal.
std::string cell(const std::string& text) {
  std::string escaped;
  for (const char letter : subjects::protocol::printable_line(text, longest_cell)) {
    switch (letter) {
      case '|':
        escaped += "\\|";
        break;
      case '<':
        escaped += "&lt;";
        break;
      default:
        escaped += letter;
    }
  }
  return escaped;
}

/// A number, or how JSON has one that is not finite.
std::string number_cell(const json& number, const char* format) {
  return fmt::format(fmt::runtime(format), number_from_json(number, "a number"));
}

/// Of a law that determines no outcome there is none.
std::string worst_cell(const json& subject) {
  const std::optional<Model> model = model_named(subject.at("model").get<std::string>());
  if (!model || !determines_outcome(*model)) {
    return "–";
  }
  return number_cell(subject.at("worst_backward_error").at("ulps"), "{:.2g}");
}

std::string digits_cell(const json& digits) {
  if (digits.at("p50").is_null()) {
    return "–";
  }
  const auto text = [&](const char* name) { return number_cell(digits.at(name), "{:.1f}"); };
  return text("p50") + " / " + text("p99") + " / " + text("worst");
}

std::string list(const std::vector<std::string>& words) {
  std::string text;
  for (const std::string& word : words) {
    text += (text.empty() ? "" : ", ") + word;
  }
  return text.empty() ? "–" : text;
}

/// "family (violated cases)", those first in which most are.
std::string families_cell(const json& families) {
  std::vector<std::pair<std::uint64_t, std::string>> violated;
  for (const json& family : families) {
    if (family.at("violated") > 0) {
      violated.emplace_back(family.at("violated").get<std::uint64_t>(), family.at("family").get<std::string>());
    }
  }
  std::stable_sort(violated.begin(), violated.end(), [](const auto& x, const auto& y) { return x.first > y.first; });
  if (!violated.empty() && (violated.size() == families.size() || violated.size() > 8)) {
    return fmt::format("{} of {}, most in {} ({})", violated.size(), families.size(), violated[0].second,
                       violated[0].first);
  }
  std::vector<std::string> words;
  for (const auto& [count, name] : violated) {
    words.push_back(fmt::format("{} ({})", name, count));
  }
  return list(words);
}

std::string row(const json& subject) {
  const std::string name = cell(subject.at("name"));
  if (subject.at("status") == "absent") {
    return fmt::format("| {} | absent: {} | | | | | | |\n", name, cell(subject.at("error")));
  }
  std::vector<std::string> invariants;
  for (const json& violation : subject.at("violations")) {
    invariants.push_back(violation.at("invariant"));
  }
  const auto text = [&](const char* field) { return cell(subject.at(field).get<std::string>()); };
  return fmt::format(
      "| {} {} | {}, {} | {} | {} | {} | {} | {} | {} |\n", name, cell(subject.value("version", "")), text("precision"),
      text("model"), text("status"), worst_cell(subject), digits_cell(subject.at("digits")), cell(list(invariants)),
      cell(families_cell(subject.at("families"))), number_cell(subject.at("nanoseconds_per_solve"), "{:.0f}"));
}

}  // namespace

int table(const std::string& file) {
  const json report = report_from(file);
  try {
    const json& cases = report.at("cases_of_each_family");  // null where a budget decided
    std::string text = fmt::format(
        "| subject | precision, model | verdict | worst backward error [ulps] | digits p50 / p99 / worst "
        "| invariants violated | in families{} | ns/solve |\n"
        "| --- | --- | --- | --- | --- | --- | --- | --- |\n",
        cases.is_null() ? "" : fmt::format(" (cases of {})", cases.get<std::uint64_t>()));
    for (const json& subject : report.at("subjects")) {
      text += row(subject);
    }
    fmt::print("{}", text);
  } catch (const json::exception& error) {
    throw UsageError(fmt::format("{}: is not a report.json of carom gate: {}", file, error.what()));
  } catch (const FormatError& error) {
    throw UsageError(fmt::format("{}: is not a report.json of carom gate: {}", file, error.what()));
  }
  return exit_all_hold;
}

}  // namespace carom::tool
