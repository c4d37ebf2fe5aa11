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
#include <carom/report/results/archive.hpp>

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

/// Throws FormatError that names the place.
WitnessFacts witness_facts(const report::Field& record) {
  WitnessFacts facts;
  if (const auto invariant = record.find("invariant")) {
    facts.invariant = invariant->text();
    if (properties::invariant_named(facts.invariant) == nullptr) {
      std::vector<std::string> known;
      for (const properties::Invariant& one : properties::all_invariants()) {
        known.emplace_back(one.name);
      }
      throw FormatError(invariant->place(), fmt::format("there is no invariant '{}'{}", facts.invariant,
                                                        properties::did_you_mean(facts.invariant, known)));
    }
  }
  if (const auto subject = record.find("subject")) {
    facts.subject = subject->at("name").text();
    if (const auto specification = subject->find("specification")) {
      facts.subject = specification->text();
    }
    if (const auto model = subject->find("model")) {
      facts.law = law_named(model->text());
      if (!facts.law) {
        std::vector<std::string_view> known;
        for (const Law law : all_laws) {
          known.push_back(name_of(law));
        }
        throw FormatError(model->place(), fmt::format("there is no law '{}'; expected one of {}", model->text(),
                                                      fmt::join(known, ", ")));
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
  try {
    const report::Field fields(record);
    if (const auto contact_class = record.is_object() ? fields.find("class") : std::nullopt) {
      read.contact_class = contact_class->text();
    }
    read.one.collision = is_wrapped ? collision_from_json(record.at(field), '/' + field) : bare_collision(record);
    if (is_wrapped && (record.contains("invariant") || record.contains("subject"))) {
      read.witness = witness_facts(fields);
    }
    if (const auto convex_uniform = is_wrapped ? fields.find("convex_uniform") : std::nullopt) {
      read.one.convex_uniform = convex_uniform->flag();
    }
  } catch (const FormatError& error) {
    fail(place, error.what());
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
