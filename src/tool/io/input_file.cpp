// SPDX-License-Identifier: BSL-1.0
#include "io/input_file.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <carom/collision/json/json.hpp>
#include <carom/collision/json/text.hpp>
#include <carom/collision/validate.hpp>
#include <carom/properties/gate/by_name.hpp>
#include <carom/properties/invariants/invariant.hpp>
#include <carom/properties/plan/lint.hpp>

#include "io/usage_error.hpp"

namespace carom::tool {
namespace {

using nlohmann::json;

/// The longest message about a record [bytes]. A record may have megabytes.
constexpr std::size_t longest_complaint = 4000;

[[noreturn]] void fail(const std::string& place, const std::string& what) {
  throw UsageError(fmt::format("{}: {}", place, carom::printable_line(what, longest_complaint)));
}

json parsed(const std::string& text, const std::string& place) {
  try {
    return parse_json(text);
  } catch (const FormatError& error) {
    fail(place, error.what());
  }
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
      std::vector<std::string> known;
      for (const properties::Invariant& invariant : properties::all_invariants()) {
        known.emplace_back(invariant.name);
      }
      fail(place, fmt::format("/invariant: there is no invariant '{}'{}", facts.invariant,
                              properties::did_you_mean(facts.invariant, known)));
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
    if (subject.contains("model")) {
      const std::string model = text_field(subject.at("model"), "/subject/model", place);
      facts.law = law_named(model);
      if (!facts.law) {
        std::vector<std::string_view> known;
        for (const Law law : all_laws) {
          known.push_back(name_of(law));
        }
        fail(place,
             fmt::format("/subject/model: there is no law '{}'; expected one of {}", model, fmt::join(known, ", ")));
      }
    }
  }
  return facts;
}

/// The collision of a record that is itself a collision, without the field `class`.
Collision bare_collision(json record) {
  if (record.is_object()) {
    record.erase("class");
  }
  return collision_from_json(record);
}

ReadCollision read_record(const json& record, const std::string& place, OutOfRange out_of_range, OfWitness of_witness) {
  ReadCollision read{place, {}, std::nullopt};
  const bool is_wrapped = record.is_object() && record.contains("collision");
  const std::string field = of_witness == OfWitness::drawn ? "drawn" : "collision";
  if (of_witness == OfWitness::drawn && !(is_wrapped && record.contains(field))) {
    fail(place, "/drawn: is missing; only a witness of carom gate has this field, so use --drawn with a witness");
  }
  if (record.is_object() && record.contains("class")) {
    read.contact_class = text_field(record.at("class"), "/class", place);
  }
  try {
    read.one.collision = is_wrapped ? collision_from_json(record.at(field), '/' + field) : bare_collision(record);
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
  const bool may_be_invalid = is_kept || (read.witness && read.witness->is_of_invalid());
  const std::vector<InputError> errors = validate(read.one.collision);
  if (!errors.empty() && !may_be_invalid) {
    fail(place, describe(errors));
  }
  return read;
}

}  // namespace

bool WitnessFacts::is_of_invalid() const {
  const properties::Invariant* const known = properties::invariant_named(invariant);
  return known != nullptr && known->is_of_invalid();
}

void for_each_collision(JsonFile& file, OutOfRange out_of_range, const std::function<void(const ReadCollision&)>& visit,
                        OfWitness of_witness) {
  if (file.is_lines()) {
    while (const std::optional<JsonFile::Line> line = file.next_line()) {
      const std::string place = fmt::format("{}:{}", file.file(), line->number);
      visit(read_record(parsed(line->text, place), place, out_of_range, of_witness));
    }
    return;
  }
  if (file.whole().find_first_not_of(" \t\r\n") == std::string::npos) {
    fail(file.file(), "the file is empty; expected a collision");
  }
  const json whole = parsed(file.whole(), file.file());
  if (!whole.is_array()) {
    visit(read_record(whole, file.file(), out_of_range, of_witness));
    return;
  }
  if (whole.empty()) {
    fail(file.file(), "the array is empty; expected at least one collision");
  }
  for (std::size_t i = 0; i < whole.size(); ++i) {
    visit(read_record(whole[i], fmt::format("{}: element {}", file.file(), i), out_of_range, of_witness));
  }
}

}  // namespace carom::tool
