// SPDX-License-Identifier: BSL-1.0
#include <algorithm>
#include <cstdlib>
#include <ostream>
#include <stdexcept>
#include <string_view>

#include <carom/properties/conformance/statement.hpp>
#include <carom/properties/trial/trial.hpp>

namespace carom::conformance {
namespace {

using properties::Family;
using properties::Invariant;

bool judges_exactly(const Options& options) {
  const char* const given = std::getenv("CAROM_EXACT");
  if (given == nullptr) {
    return options.exact;
  }
  const std::string_view text(given);
  if (text != "0" && text != "1") {
    throw std::invalid_argument("CAROM_EXACT: expected 0 or 1, found " + std::string(text));
  }
  return text == "1";
}

std::vector<const Family*> families_of(const Options& options) {
  std::vector<const Family*> families;
  for (const std::string& name : options.families) {
    families.push_back(properties::family_named(name));
    if (families.back() == nullptr) {
      throw std::invalid_argument("Options::families: there is no family " + name);
    }
  }
  if (options.families.empty()) {
    for (const Family& family : properties::all_families()) {
      families.push_back(&family);
    }
  }
  return families;
}

void require_known_deviations(const Options& options) {
  for (const std::string& name : options.deviates) {
    try {
      (void)properties::deviation_from(name);
    } catch (const std::invalid_argument& error) {
      throw std::invalid_argument(std::string("Options::deviates: ") + error.what());
    }
  }
}

}  // namespace

properties::Claim Statement::claim() const { return {subject->law, yardstick, {invariant}, {}, {}, subject->effects}; }

std::vector<Statement> statements(const Subject& subject, const Options& options) {
  const auto shared = std::make_shared<const Subject>(subject);
  oracles::Yardstick yardstick;
  yardstick.limit_ulps = options.limit_ulps;
  yardstick.filtered = !judges_exactly(options);
  require_known_deviations(options);
  properties::require_valid(subject.effects, subject.law);
  Subject deviating = subject;
  deviating.deviates.insert(deviating.deviates.end(), options.deviates.begin(), options.deviates.end());
  properties::Claim claim = properties::claim_of(deviating, yardstick);
  std::vector<const Family*> families = families_of(options);
  if (std::none_of(claim.invariants.begin(), claim.invariants.end(),
                   [](const Invariant* invariant) { return invariant->name == "invalid_refused"; })) {
    std::erase(families, properties::family_named("invalid"));
  }
  std::vector<Statement> all;
  for (const Invariant* invariant : claim.invariants) {
    for (const Family* family : families) {
      if (!claim.is_made_in(*invariant, *family)) {
        continue;
      }
      all.push_back({shared, invariant, family, claim.yardstick});
    }
  }
  return all;
}

std::string name_of(const Statement& statement) {
  if (!statement.error.empty()) {
    return "options";
  }
  return std::string(statement.invariant->name) + "_in_" + std::string(statement.family->name);
}

void PrintTo(const Statement& statement, std::ostream* out) {
  if (!statement.error.empty()) {
    *out << statement.error;
    return;
  }
  *out << statement.invariant->name << " of " << statement.subject->name << " in " << statement.family->name;
}

}  // namespace carom::conformance
