// SPDX-License-Identifier: BSL-1.0
#include <algorithm>
#include <cstdlib>
#include <stdexcept>
#include <string_view>
#include <utility>

#include <carom/properties/cases/draw_within.hpp>
#include <carom/properties/gate/by_name.hpp>
#include <carom/properties/gate/trial.hpp>
#include <carom/properties/kit/statement.hpp>

namespace carom::conformance {
namespace {

using properties::Family;
using properties::Invariant;

/// The seed of the draws that decide whether a domain has cases.
constexpr std::uint64_t seed = 1;

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

/// Calls `read`, and puts the place before the message of its std::invalid_argument.
template <class Read>
auto read_at(const char* place, const Read& read) {
  try {
    return read();
  } catch (const std::invalid_argument& error) {
    throw std::invalid_argument(std::string(place) + ": " + error.what());
  }
}

properties::Domain domain_of(const Subject& subject, const Options& options) {
  return options.within.empty() ? read_at("Subject::domain", [&] { return properties::domain_from(subject.domain); })
                                : read_at("Options::within", [&] { return properties::domain_from(options.within); });
}

std::vector<const Family*> families_of(const Options& options, const properties::Domain& within) {
  const auto has_cases = [&](const Family& family) {
    return within.is_everything() || properties::has_cases_within(within, family, seed);
  };
  std::vector<const Family*> families;
  for (const std::string& name : options.families) {
    families.push_back(&properties::require_family("Options::families", name));
    if (!has_cases(*families.back())) {
      throw std::invalid_argument("Options::families: no case of " + name + " lies within " + to_text(within));
    }
  }
  if (options.families.empty()) {
    families = pointers_to(properties::all_families());
    std::erase_if(families, [&](const Family* family) { return !has_cases(*family); });
  }
  return families;
}

Subject with_options(Subject subject, const Options& options) {
  for (const std::string& name : options.deviates) {
    read_at("Options::deviates", [&] { return properties::deviation_from(name); });
    subject.deviates.push_back(name);
  }
  read_at("Options::effects", [&] {
    subject.effects = properties::with_named_effects(subject.effects, options.effects);
    properties::require_valid(subject.effects, subject.law);
  });
  return subject;
}

}  // namespace

properties::Claim Statement::claim() const {
  return {suite->subject.law, suite->yardstick, {invariant}, {}, suite->within, suite->subject.effects};
}

std::vector<Statement> statements(const Subject& subject, const Options& options) {
  oracles::Limits limits =
      read_at("Options", [&] { return properties::limits_with(options.limit_ulps, options.digits); });
  limits.filtered = !judges_exactly(options);
  const Subject claiming = with_options(subject, options);
  const properties::Claim claim = properties::claim_of(claiming, limits);
  const properties::Domain within = domain_of(subject, options);
  std::vector<const Family*> families = families_of(options, within);
  if (std::none_of(claim.invariants.begin(), claim.invariants.end(),
                   [](const Invariant* invariant) { return invariant->is_of_invalid(); })) {
    std::erase(families, properties::family_named("invalid"));
  }
  const auto suite = std::make_shared<Suite>(Suite{claiming, within, claim.yardstick, families});
  std::vector<Statement> all;
  for (const Invariant* invariant : claim.invariants) {
    for (const Family* family : families) {
      if (claim.is_made_in(*invariant, *family) && invariant->can_be_judged_in(within.kinds)) {
        all.push_back({suite, invariant, family});
      }
    }
  }
  return all;
}

properties::Draw draw_of(const Statement& statement) {
  const Family& family = *statement.family;
  if (statement.suite->within.is_everything()) {
    return family.generate;
  }
  return [within = statement.suite->within, &family](properties::Stream& stream) {
    const std::optional<properties::Case> drawn = properties::drawn_within(within, family, stream);
    return drawn ? *drawn : family.generate(stream);
  };
}

std::string name_of(const Statement& statement) {
  return std::string(statement.invariant->name) + "_in_" + std::string(statement.family->name);
}

std::string in_words(const Statement& statement) {
  return std::string(statement.invariant->name) + " of " + statement.suite->subject.name + " in " +
         std::string(statement.family->name);
}

}  // namespace carom::conformance
