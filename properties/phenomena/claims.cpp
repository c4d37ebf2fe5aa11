// SPDX-License-Identifier: BSL-1.0
#include <algorithm>
#include <cmath>
#include <iterator>
#include <locale>
#include <sstream>
#include <stdexcept>

#include <fmt/format.h>

#include <carom/collision/expects.hpp>
#include <carom/properties/gate/by_name.hpp>
#include <carom/properties/phenomena/claims.hpp>

namespace carom::properties {
namespace {

/// Reads a number > 0 from "0.5" or "1/60". 0 if the text is no such number.
double positive_number(const std::string& text) {
  std::istringstream in(text);
  in.imbue(std::locale::classic());
  double x = 0;
  in >> std::noskipws >> x;
  if (!in.eof() && in.peek() == '/') {
    double divisor = 0;
    in.get();
    in >> divisor;
    x /= divisor;
  }
  return in && in.eof() && x > 0 && std::isfinite(x) ? x : 0;
}

/// Two ways to write one step may differ by a rounding or two.
bool is_step(double step, double other) { return std::abs(step - other) <= 0x1p-40 * step; }

}  // namespace

std::optional<double> step_from(const std::string& text) {
  const double step = positive_number(text);
  return step >= least_step && step <= greatest_step ? std::optional(step) : std::nullopt;
}

TimeClaim time_claim_from(std::string_view text) {
  std::istringstream in{std::string(text)};
  const std::vector<std::string> words{std::istream_iterator<std::string>(in), {}};
  const bool has_form =
      words.size() == 6 && words[1] == "within" && words[2].back() == '%' && words[3] == "at" && words[5] == "s";
  const double percent = has_form ? positive_number(words[2].substr(0, words[2].size() - 1)) : 0;
  const std::optional<double> step = has_form ? step_from(words[4]) : std::nullopt;
  if (percent == 0 || !step) {
    throw std::invalid_argument(
        fmt::format("the claim '{}' is not written as 'bounce within 5% at 1/60 s', with a step from {} to {} s", text,
                    least_step, greatest_step));
  }
  const std::vector<std::string> names = phenomenon_names();
  if (std::find(names.begin(), names.end(), words[0]) == names.end()) {
    throw std::invalid_argument(
        fmt::format("the claim '{}' names no phenomenon{}", text, did_you_mean(words[0], names)));
  }
  return {words[0], percent / 100, *step};
}

ClaimVerdict verdict_of(const TimeClaim& claim, const Measurement& measurement) {
  CAROM_EXPECTS(claim.phenomenon == measurement.phenomenon);
  for (const Unanswered& unanswered : measurement.unanswered) {
    if (std::any_of(unanswered.steps.begin(), unanswered.steps.end(),
                    [&](double step) { return is_step(claim.step, step); })) {
      return {false, 0, "a run has no answer: " + unanswered.why};
    }
  }
  ClaimVerdict verdict{true, 0, "the step was not measured"};
  bool is_measured = false;
  for (const MeasuredReading& reading : measurement.readings) {
    for (const Rung& rung : reading.rungs) {
      if (is_step(claim.step, rung.step)) {
        is_measured = true;
        if (rung.greatest > verdict.greatest) {
          verdict.greatest = rung.greatest;
          verdict.why = fmt::format("{} is off by {:.2g}%", reading.what, 100 * rung.greatest);
        }
      }
    }
  }
  const bool is_kept = is_measured && verdict.greatest <= claim.within;
  return {is_kept, verdict.greatest, is_kept ? "" : verdict.why};
}

}  // namespace carom::properties
