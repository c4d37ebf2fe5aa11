// SPDX-License-Identifier: BSL-1.0
#include <algorithm>
#include <array>
#include <charconv>
#include <chrono>
#include <system_error>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <carom/collision/json/text.hpp>
#include <carom/properties/gate/declared_effects.hpp>
#include <carom/report/results/values_json.hpp>
#include <carom/report/results/words.hpp>

namespace carom::report {
namespace {

std::string budget_in_words(const Run& run) {
  return in_words(run.options.budget.value_or(std::chrono::nanoseconds(0)));
}

std::string in_tenths(const std::optional<double>& number) {
  return number ? fmt::format("{:.1f}", *number) : no_number;
}

struct Unit {
  std::string_view name;
  std::chrono::milliseconds length;
};

constexpr std::array units{Unit{"h", std::chrono::hours(1)}, Unit{"m", std::chrono::minutes(1)},
                           Unit{"s", std::chrono::seconds(1)}, Unit{"ms", std::chrono::milliseconds(1)}};

}  // namespace

std::string shown(const std::string& text) {
  constexpr std::size_t longest = 4000;
  return printable_line(text, longest);
}

std::string in_words(const Digits& digits) {
  return digits.p50 ? fmt::format("{} / {} / {}", in_tenths(digits.p50), in_tenths(digits.p99), in_tenths(digits.worst))
                    : no_number;
}

std::string limit_in_words(const oracles::Limits& limits) {
  return limits.digits ? fmt::format("{} digits", *limits.digits) : fmt::format("{} ulps", limits.limit_ulps);
}

std::string within_option(const properties::Domain& domain) {
  return domain.is_everything() ? "" : " --within " + properties::to_text(domain);
}

std::string extent_of(const Run& run) {
  const properties::GateOptions& options = run.options;
  const std::string extent =
      options.budget ? fmt::format("{} on {} families in turn", budget_in_words(run), options.families.size())
                     : fmt::format("{} cases of each of {} families", options.cases, options.families.size());
  const std::string shard = run.is_shard && options.shard.of > 1
                                ? fmt::format(", shard {} of {}", options.shard.number, options.shard.of)
                                : "";
  const std::string within = options.within.is_everything() ? "" : " within " + properties::to_text(options.within);
  return extent + within + shard + (options.fail_fast ? ", each subject to its first violation" : "");
}

std::string cases_judged(const Run& run, const properties::SubjectResult& result) {
  const auto& families = result.families;
  const auto fewest = std::min_element(families.begin(), families.end(),
                                       [](const auto& x, const auto& y) { return x.cases < y.cases; });
  return fmt::format("judged on {} cases in {}; the fewest cases are {} of {}", result.cases(), budget_in_words(run),
                     fewest->cases, run.options.families[static_cast<std::size_t>(fewest - families.begin())]->name);
}

std::string adjusted_sentences(const Run& run) {
  using properties::Adjustment;
  properties::Coverage all;
  for (const properties::Coverage& of_family : run.coverage) {
    all += of_family;
  }
  return fmt::format(
      "Families changed some cases after they drew them. They enlarged moments in {} cases, so that the contact lies "
      "on "
      "the body. They moved {} cases to the origin, so that parallel vectors are exactly parallel. They reversed {} "
      "separating cases. They replaced {} cases outside of the domain.",
      all.adjusted[Adjustment::moments_enlarged], all.adjusted[Adjustment::moved_to_origin],
      all.adjusted[Adjustment::reversed], all.adjusted[Adjustment::drawn_again]);
}

std::string verdict_in_words(const properties::SubjectResult& result) {
  const SubjectStatus status = status_of(result);
  return status == SubjectStatus::violated ? fmt::format("{} violated", result.witnesses.size())
                                           : std::string(name_of(status));
}

std::string worst_in_words(const Run& run, const properties::SubjectResult& result) {
  return determines_outcome(result.subject.law)
             ? fmt::format("{:.3g}", result.worst_backward_error(run.options).backward_error)
             : no_number;
}

std::string violated_of_judged(const properties::Count& count) {
  return fmt::format("{} of {}", count.violated, count.judged());
}

std::string violated_of_judged_cases(const properties::Count& count) {
  return violated_of_judged(count) + " judged cases";
}

namespace {

std::string in_percent(double share) { return fmt::format("{:.2g} %", 100 * share); }

std::string witness_in_words(const properties::EnergyGain& gain) {
  return fmt::format("case {} of {}", gain.index, gain.family->name);
}

std::string greatest_in_words(const properties::EnergyGains& gains) {
  const properties::EnergyGain& joules = *gains.greatest;
  if (!gains.greatest_share) {
    return fmt::format("at most {:.3g} J ({})", joules.joules, witness_in_words(joules));
  }
  const properties::EnergyGain& share = *gains.greatest_share;
  const bool is_one_case = share.family == joules.family && share.index == joules.index;
  return fmt::format("at most {:.3g} J{} and +{:.3g} % ({})", joules.joules,
                     is_one_case ? "" : " (" + witness_in_words(joules) + ")", 100 * share.share,
                     witness_in_words(share));
}

}  // namespace

std::string energy_in_words(const Run& run, std::size_t subject) {
  const properties::EnergyGains gains = run.results[subject].energy(run.options);
  if (gains.colliding == 0) {
    return "";
  }
  if (gains.gaining == 0) {
    return fmt::format("It gains energy in none of {} colliding contacts.", gains.colliding);
  }
  const std::string law = run.results[subject].subject.law == Law::any ? ""
                          : gains.by_law == 0                          ? "; the law gains in none of these"
                          : gains.by_law == gains.gaining
                              ? "; the law gains in all of these"
                              : fmt::format("; the law gains in {} of these {}", gains.by_law, gains.gaining);
  return fmt::format("It gains energy in {} of colliding contacts, {}{}.",
                     in_percent(static_cast<double>(gains.gaining) / static_cast<double>(gains.colliding)),
                     greatest_in_words(gains), law);
}

std::vector<std::string> ways_on(const Run& run, std::size_t subject) {
  std::vector<std::string> lines;
  for (const properties::WayOn& way : run.results[subject].ways_on) {
    const std::string what =
        way.within ? "sound within " + properties::to_text(*way.within)
                   : fmt::format("no violation if it declares {}: \"claims\":{} in the reply to start",
                                 properties::to_text(way.effects), Json<DeclaredEffects>::write(way.effects).dump());
    lines.push_back(fmt::format("{} ({} fresh cases)", what, way.cases));
  }
  return lines;
}

std::string listed(const std::vector<const properties::Invariant*>& invariants) { return listed(names_of(invariants)); }

std::string listed(const std::vector<std::string>& names) { return fmt::format("{}", fmt::join(names, ", ")); }

std::string summary_of(const Run& run) {
  const Overall overall = overall_of(run);
  const std::size_t counted = overall.subjects;
  const std::size_t sound = overall.sound;
  const std::size_t violated = overall.violating_subjects;
  const auto counting = [&](const auto& is_so) {
    std::size_t count = 0;
    for (std::size_t s = 0; s < run.results.size(); ++s) {
      count += run.counts[s] && is_so(run.results[s]) ? 1 : 0;
    }
    return count;
  };
  const std::size_t in_error = counting([](const auto& result) { return status_of(result) == SubjectStatus::error; });
  const std::size_t not_judged = counted - sound - violated - in_error;
  std::string text;
  if (counted == 0) {
    text = "No subject that counts was judged";
  } else if (sound == counted) {
    text = counted == 1 ? "The one subject that counts is sound"
                        : fmt::format("All {} subjects that count are sound", counted);
  } else if (counted == 1 && violated == 1) {
    text = "The one subject that counts violates an invariant";
  } else if (counted == 1 && not_judged == 1) {
    text = "The one subject that counts is not judged";
  } else if (counted == 1) {
    const bool is_judged = counting([](const auto& result) { return result.cases() > 0; }) > 0;
    text = fmt::format("The one subject that counts could not be judged {}", is_judged ? "to the end" : "at all");
  } else {
    text = fmt::format("Of {} subjects that count, {} {} sound, {} {} an invariant", counted, sound,
                       sound == 1 ? "is" : "are", violated, violated == 1 ? "violates" : "violate");
    text += not_judged == 0 ? "" : fmt::format(", {} {} not judged", not_judged, not_judged == 1 ? "is" : "are");
    text += in_error == 0 ? "" : fmt::format(", and {} could not be judged to the end", in_error);
  }
  const std::size_t kept = run.results.size() - counted;
  text += kept == 0 ? ""
                    : fmt::format("; {} more {} kept because {}", kept, kept == 1 ? "is" : "are",
                                  kept == 1 ? "it fails" : "they fail");
  text += run.absent.empty() ? "."
                             : fmt::format("; {} {} absent.", run.absent.size(), run.absent.size() == 1 ? "is" : "are");
  if (run.judge_error) {
    return "The judge failed. The results before: " + text;
  }
  return run.interrupted ? "The run was interrupted. The results so far: " + text : text;
}

std::optional<std::chrono::nanoseconds> duration_from(std::string_view text) {
  constexpr double shortest = 1e-3;        // [s]
  constexpr double longest = 1000 * 3600;  // [s]
  double number = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number, std::chars_format::fixed);
  if (error != std::errc()) {
    return std::nullopt;
  }
  const std::string_view name(end, static_cast<std::size_t>(text.data() + text.size() - end));
  for (const Unit& unit : units) {
    const double seconds = number * std::chrono::duration<double>(unit.length).count();
    if (name == unit.name && seconds >= shortest && seconds <= longest) {
      return std::chrono::duration_cast<std::chrono::nanoseconds>(std::chrono::duration<double>(seconds));
    }
  }
  return std::nullopt;
}

std::string in_words(std::chrono::nanoseconds duration) {
  const auto milliseconds = std::chrono::duration_cast<std::chrono::milliseconds>(duration);
  for (const Unit& unit : units) {
    if (milliseconds >= unit.length && milliseconds % unit.length == std::chrono::milliseconds::zero()) {
      return fmt::format("{} {}", milliseconds / unit.length, unit.name);
    }
  }
  return "0 ms";
}

}  // namespace carom::report
