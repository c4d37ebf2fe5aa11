// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <cstddef>
#include <string>

#include <nlohmann/json.hpp>
#include <pugixml.hpp>

#include <carom/collision/subject.hpp>
#include <carom/properties/gate/trial.hpp>

/// One collision with its exact outcome, step by step, and the verdicts on a subject's answer.
namespace carom::report {

struct ReplayedCase {
  Answer answer;
  properties::Judgement judgement;
  std::size_t spellings = 0;           // the number of spellings (spelling.hpp) that a program got; otherwise 0
  std::size_t violated_spellings = 0;  // of these, those with a violation
  std::string spelt = {};              // the collision in the spelling of the answer
};

[[nodiscard]] bool is_violated(const properties::Judgement& judgement);

struct CaseToShow {
  std::string place;  // where the collision comes from
  const properties::Case& one;
  Law law;                          // the exact outcome is the one under this law, or under each law for `any`
  bool is_filtered = true;          // whether faster filters judge before exact arithmetic
  std::string why_not_judged = {};  // empty if nobody asked for a judgement
  /// The subject that answered; all null if there is none.
  struct Judged {
    const Subject* subject = nullptr;
    const oracles::Yardstick* yardstick = nullptr;
    const ReplayedCase* replayed = nullptr;
  } judged = {};
};

struct ShownCase {
  nlohmann::json record;
  std::string text;  // not yet safe to print: it quotes the subject
};

[[nodiscard]] ShownCase shown_case(const CaseToShow& to_show);

/// Appends a figure of the contact: before the impulse, as the subject answered, and exactly under the law `claimed`.
/// `anchor` is unique in its page. `title` names the contact.
void add_case_drawing(pugi::xml_node section, const properties::JudgedCase& judged_case, const Answer& answer,
                      Law claimed, const std::string& anchor, const std::string& title);

}  // namespace carom::report
