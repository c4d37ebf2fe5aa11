// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <cstdint>
#include <cstdlib>
#include <optional>
#include <ostream>
#include <sstream>
#include <string>
#include <unordered_map>
#include <utility>
#include <vector>

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <carom/collision/validate.hpp>
#include <carom/properties/families/family.hpp>
#include <carom/properties/search/shrink.hpp>
#include <carom/properties/trial/in_words.hpp>

/// RapidCheck with the families as generators, and with a fixed seed inside GoogleTest.
namespace carom::properties {

/// How RapidCheck prints a case.
inline void showValue(const Case& one, std::ostream& out) { out << in_words(one.collision, ""); }

/// The cases of a family. RapidCheck supplies one integer, which with the family's name starts the stream, so that
/// families differ under one seed. A case shrinks as the gate's witnesses do, to small dyadic numbers; an invalid one
/// is as small as its family makes it.
[[nodiscard]] inline rc::Gen<Case> cases_of(const Family& family) {
  const auto shrinks = [](const Case& one) {
    std::vector<Case> simpler_cases;
    if (validate(one.collision).empty()) {
      for (const Collision& collision : simpler(one.collision)) {
        // A body with other numbers is not known to be convex.
        simpler_cases.push_back({collision, false});
      }
    }
    return rc::seq::fromContainer(std::move(simpler_cases));
  };
  return {[&family, shrinks](const rc::Random& random, int) {
    rc::Random source = random;
    Stream stream = case_stream(source.next(), family.name, 0);
    return rc::shrinkable::shrinkRecur(family.generate(stream), shrinks);
  }};
}

/// The seed of every property, unless the environment variable RC_PARAMS gives one, as in RC_PARAMS="seed=7".
inline constexpr std::uint64_t fixed_seed = 20240229;

[[nodiscard]] inline rc::detail::TestParams rapidcheck_parameters(int cases, bool shrinks = true) {
  rc::detail::Configuration defaults;
  defaults.testParams.seed = fixed_seed;
  defaults.testParams.maxSuccess = cases;
  defaults.testParams.disableShrinking = !shrinks;
  const char* const given = std::getenv("RC_PARAMS");
  return given == nullptr ? defaults.testParams : rc::detail::configFromString(given, defaults).testParams;
}

/// Reports nothing as it goes. RapidCheck's own listener would first load its configuration and print a seed that is
/// not the one in use.
class SilentListener : public rc::detail::TestListener {
 public:
  void onTestCaseFinished(const rc::detail::CaseDescription&) override {}
  void onShrinkTried(const rc::detail::CaseDescription&, bool) override {}
  void onTestFinished(const rc::detail::TestMetadata&, const rc::detail::TestResult&) override {}
};

/// What RapidCheck found against a property, the seed with it; nothing where it passed all cases.
template <class Property>
[[nodiscard]] std::optional<std::string> counterexample(const rc::detail::TestParams& parameters, Property&& property) {
  SilentListener listener;
  const auto result =
      rc::detail::checkTestable(std::forward<Property>(property), rc::detail::TestMetadata{}, parameters, listener,
                                std::unordered_map<std::string, rc::detail::Reproduce>{});
  if (result.template is<rc::detail::SuccessResult>()) {
    return std::nullopt;
  }
  std::ostringstream text;
  rc::detail::printResultMessage(result, text);
  text << "\nRC_PARAMS=\"seed=" << parameters.seed << "\"";
  return text.str();
}

/// Fails the GoogleTest where the property does not hold of so many cases.
template <class Property>
void check(int cases, Property&& property) {
  const auto found = counterexample(rapidcheck_parameters(cases), std::forward<Property>(property));
  if (found) {
    ADD_FAILURE() << *found;
  }
}

}  // namespace carom::properties
