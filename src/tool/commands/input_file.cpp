// SPDX-License-Identifier: GPL-3.0-or-later
#include "commands/input_file.hpp"

#include <filesystem>
#include <fstream>
#include <iterator>
#include <sstream>

#include <fmt/format.h>

#include <carom/collision/json/json.hpp>
#include <carom/collision/validate.hpp>
#include <carom/properties/invariants/invariant.hpp>
#include <carom/properties/plan/lint.hpp>

#include "commands/commands.hpp"

namespace carom::tool {
namespace {

using nlohmann::json;

json parsed(const std::string& text, const std::string& place) {
  try {
    return parse_json(text);
  } catch (const FormatError& error) {
    throw UsageError(fmt::format("{}: {}", place, error.what()));
  }
}

[[noreturn]] void fail(const std::string& place, const std::string& what) {
  throw UsageError(fmt::format("{}: {}", place, what));
}

std::string text_field(const json& record, const char* name, const std::string& place) {
  if (!record.is_string()) {
    fail(place, fmt::format("{}: expected a string, found {}", name, record.dump()));
  }
  return record.get<std::string>();
}

std::optional<WitnessFacts> witness_facts(const json& record, const std::string& place) {
  if (!record.contains("invariant") && !record.contains("subject")) {
    return std::nullopt;
  }
  WitnessFacts facts;
  if (record.contains("invariant")) {
    facts.invariant = text_field(record.at("invariant"), "/invariant", place);
    if (properties::invariant_named(facts.invariant) == nullptr) {
      fail(place, fmt::format("/invariant: there is no invariant '{}'", facts.invariant));
    }
  }
  if (record.contains("subject")) {
    const json& subject = record.at("subject");
    if (!subject.is_object() || !subject.contains("name")) {
      fail(place, "/subject: expected an object with a name, found " + subject.dump());
    }
    facts.subject = text_field(subject.at("name"), "/subject/name", place);
    if (subject.contains("specification")) {
      facts.subject = text_field(subject.at("specification"), "/subject/specification", place);
    }
  }
  return facts;
}

/// The collision that stands by itself, its class beside its fields.
Collision bare_collision(json record) {
  if (record.is_object()) {
    record.erase("class");
  }
  return collision_from_json(record);
}

ReadCollision read_record(const json& record, const std::string& place, OutOfRange out_of_range) {
  ReadCollision read{place, {}, std::nullopt};
  const bool is_wrapped = record.is_object() && record.contains("collision");
  if (record.is_object() && record.contains("class")) {
    read.contact_class = text_field(record.at("class"), "/class", place);
  }
  try {
    read.one.collision =
        is_wrapped ? collision_from_json(record.at("collision"), "/collision") : bare_collision(record);
  } catch (const FormatError& error) {
    fail(place, error.what());
  }
  if (is_wrapped) {
    read.witness = witness_facts(record, place);
    if (record.contains("convex_uniform")) {
      const json& convex_uniform = record.at("convex_uniform");
      if (!convex_uniform.is_boolean()) {
        fail(place, "/convex_uniform: expected true or false, found " + convex_uniform.dump());
      }
      read.one.convex_uniform = convex_uniform.get<bool>();
    }
  }
  const bool is_kept = out_of_range == OutOfRange::kept && properties::plan::is_out_of_range(read.one.collision);
  const bool may_be_invalid = is_kept || (read.witness && read.witness->invariant == "invalid_refused");
  const std::vector<Defect> defects = validate(read.one.collision);
  if (!defects.empty() && !may_be_invalid) {
    fail(place, describe(defects));
  }
  return read;
}

bool is_blank(const std::string& line) { return line.find_first_not_of(" \t\r") == std::string::npos; }

/// JSON Lines where the first of several lines is a whole JSON text by itself.
bool is_json_lines(const std::string& text) {
  const std::size_t start = text.find_first_not_of(" \t\r\n");
  const std::size_t end = text.find('\n', start);
  return end != std::string::npos && text.find_first_not_of(" \t\r\n", end) != std::string::npos &&
         json::accept(text.substr(start, end - start));
}

}  // namespace

std::string content_of_file(const std::string& file) {
  if (!std::filesystem::exists(file)) {
    throw UsageError(fmt::format("{}: there is no such file", file));
  }
  if (std::filesystem::is_directory(file)) {
    throw UsageError(fmt::format("{}: is a directory, expected a file", file));
  }
  std::ifstream stream(file, std::ios::binary);
  if (!stream) {
    throw UsageError(fmt::format("{}: cannot be read", file));
  }
  return {std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()};
}

std::vector<ReadCollision> read_collisions(const std::string& file, OutOfRange out_of_range) {
  return collisions_of(content_of_file(file), file, out_of_range);
}

std::vector<ReadCollision> collisions_of(const std::string& text, const std::string& file, OutOfRange out_of_range) {
  std::vector<ReadCollision> read;
  if (is_blank(text) || text.find_first_not_of(" \t\r\n") == std::string::npos) {
    fail(file, "is empty; expected a collision");
  }
  if (is_json_lines(text)) {
    std::istringstream lines(text);
    std::string line;
    for (std::size_t number = 1; std::getline(lines, line); ++number) {
      if (!is_blank(line)) {
        const std::string place = fmt::format("{}:{}", file, number);
        read.push_back(read_record(parsed(line, place), place, out_of_range));
      }
    }
    return read;
  }
  const json whole = parsed(text, file);
  if (whole.is_array()) {
    for (std::size_t i = 0; i < whole.size(); ++i) {
      read.push_back(read_record(whole[i], fmt::format("{}: element {}", file, i), out_of_range));
    }
    if (read.empty()) {
      fail(file, "holds no collision");
    }
    return read;
  }
  read.push_back(read_record(whole, file, out_of_range));
  return read;
}

}  // namespace carom::tool
