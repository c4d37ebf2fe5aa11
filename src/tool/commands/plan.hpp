// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <stop_token>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include <carom/collision/law.hpp>
#include <carom/properties/plan/plan.hpp>

#include "commands/commands.hpp"

/// The parts of the command `plan`.
namespace carom::tool {
namespace plan {

struct RecordedContacts {
  std::vector<properties::plan::ClassedCollision> contacts;
  std::optional<Law> law;  // of a scene
};

/// Runs the scene in a text and returns its impacts. `file` is for messages.
using ContactsOfScene =
    std::function<RecordedContacts(const std::string& text, const std::string& file, const std::stop_token& stop)>;

/// A plan is certified on fewer than twice this number of impacts of a scene. If a scene has more impacts, only every
/// n-th impact is used.
inline constexpr std::size_t most_contacts_of_scene = 10'000;

/// Runs the scene. Returns its law, and its impacts, classed by bodies and materials. Throws UsageError
/// that names the file, the place, the field, and what was expected, or that the user stopped.
[[nodiscard]] RecordedContacts contacts_of_scene(const std::string& text, const std::string& file,
                                                 const std::stop_token& stop);

/// The built-in methods as candidates, without those whose tangent basis fails near head-on collisions.
[[nodiscard]] std::vector<properties::plan::Candidate> candidates();

/// The header that declares a built-in method: "carom/impulse/frictionless.hpp". Throws std::logic_error if no method
/// has this name.
[[nodiscard]] std::string header_of(const std::string& method);

/// Times built-in methods by Google Benchmark. Each time is the median of `repetitions` repetitions in random order. If
/// there are fewer contacts than `contacts_timed`, the contacts are repeated. The clock throws std::logic_error if a
/// candidate is not a built-in method. Precondition: repetitions > 0.
[[nodiscard]] properties::plan::Clock clock_of(int repetitions);

/// A plan, and the input that it was made from.
struct PlanRun {
  std::string file;
  properties::plan::Demand demand;
  properties::plan::Plan plan;
  int repetitions = 0;  // of each timing; 0 if nothing was timed

  /// 0 if a candidate serves every contact, otherwise 1.
  [[nodiscard]] int exit_status() const;
};

/// The record of docs/reference/schemas/plan.schema.json.
[[nodiscard]] nlohmann::json plan_record(const PlanRun& run);

/// The plan for a terminal. It lists the candidates that serve each class and all contacts, with their headers. It also
/// lists the candidates that do not serve all contacts, with the reasons, and the findings of the lint.
[[nodiscard]] std::string plan_text(const PlanRun& run);

}  // namespace plan

/// The command `plan`. If `contacts_of_scene` is empty, the command refuses scenes.
void add_plan_with(CLI::App& app, Chosen& chosen, plan::ContactsOfScene contacts_of_scene);

}  // namespace carom::tool
