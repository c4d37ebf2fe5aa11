// SPDX-License-Identifier: BSL-1.0
#include <algorithm>
#include <memory>
#include <optional>
#include <string>
#include <utility>

#include <fmt/format.h>

#include <carom/collision/precision.hpp>
#include <carom/properties/cases/draw_within.hpp>
#include <carom/properties/widest_domain/widest_domain.hpp>
#include <carom/report/pages/pages.hpp>
#include <carom/report/results/values_json.hpp>
#include <carom/report/results/words.hpp>

#include "commands/commands.hpp"
#include "commands/options.hpp"
#include "io/interrupt.hpp"
#include "io/output.hpp"
#include "io/threads.hpp"
#include "io/usage_error.hpp"

namespace carom::tool {
namespace {

using nlohmann::json;

struct DomainArguments {
  std::string subject;
  std::optional<properties::Domain> core;
  std::uint64_t seed = 1;
  std::uint64_t cases = 200;
  LimitArguments judged;
  unsigned jobs = 0;    // 0: one for each core
  double timeout = 5;   // for each reply of a program [s]
  std::string out;      // a file for --within; empty for none
  std::string picture;  // an SVG file; empty for none
  std::string beside = "games";
  std::vector<std::string> deviates = {};  // "invariant" or "invariant@family"
  std::string format = "text";
};

/// The default limit in ulps, if it permits less rounding than the digits that are asked for.
std::optional<oracles::Limits> stricter_than(const oracles::Limits& limits, Precision precision) {
  oracles::Limits in_ulps = limits;
  in_ulps.digits.reset();
  const bool is_stricter =
      oracles::Yardstick::of(precision, in_ulps).allowance() < oracles::Yardstick::of(precision, limits).allowance();
  return limits.digits && is_stricter ? std::optional(in_ulps) : std::nullopt;
}

/// The given core. Kinds alone, or those that the subject declares if no core is given, get the default ranges.
properties::Domain core_of(const DomainArguments& arguments, const Subject& subject) {
  properties::Domain core = properties::default_core();
  core.kinds = (arguments.core ? *arguments.core : declared_domain({subject})).kinds;
  properties::Domain kinds_alone;
  kinds_alone.kinds = core.kinds;
  const bool has_ranges = arguments.core && (is_any(core.kinds) || *arguments.core != kinds_alone);
  return has_ranges ? *arguments.core : core;
}

properties::WidestDomainOptions options_of(const DomainArguments& arguments, const Subject& subject,
                                           const std::stop_token& stop) {
  properties::WidestDomainOptions options;
  options.seed = arguments.seed;
  options.limits = arguments.judged.limits();
  options.stricter = stricter_than(options.limits, subject.precision);
  options.workers = threads(arguments.jobs);
  options.core = core_of(arguments, subject);
  options.cases_of_box = arguments.cases;
  options.cases_of_slab = std::max<std::uint64_t>(1, arguments.cases / 20);
  options.stop = stop;
  if (!has_cases_within(options.core, *properties::family_named("generic"), options.seed)) {
    throw UsageError(fmt::format("--core: no case of generic lies within {}; use wider ranges", to_text(options.core)));
  }
  return options;
}

int measure_domain(const DomainArguments& arguments) {
  const std::vector<std::string> deviates = known_deviations(arguments.deviates);
  const properties::Domain beside = domain_from_argument("--beside", arguments.beside);
  const std::stop_token stop = stop_on_interrupt();
  Subject subject = subject_from_argument(arguments.subject, arguments.timeout, stop);
  if (!subject.absent.empty()) {
    throw UsageError(report::shown(fmt::format("{}: {}", subject.name, subject.absent)));
  }
  let_deviate(subject, deviates);
  for (const auto& [option, file] : {std::pair("--out", &arguments.out), std::pair("--picture", &arguments.picture)}) {
    if (!file->empty()) {
      require_writable(option, *file);  // fails now rather than after minutes
    }
  }
  report::MeasuredDomain measured{subject.name, deviates, options_of(arguments, subject, stop), {}, subject.effects};
  measured.widest = measured_widest_domain(subject, measured.options);
  fmt::print("{}", arguments.format == "json"
                       ? widest_domain_record(measured).dump(1, ' ', false, json::error_handler_t::replace) + '\n'
                       : widest_domain_text(measured));
  if (!measured.is_known()) {
    return measured.widest.ends.in_core ? exit_violated : exit_usage;
  }
  if (!arguments.out.empty()) {
    write_file(arguments.out, report::Json<properties::Domain>::write(measured.widest.domain).dump(1) + '\n');
  }
  if (!arguments.picture.empty()) {
    write_file(arguments.picture, widest_domain_svg(measured, beside, arguments.beside));
  }
  return exit_all_hold;
}

}  // namespace

void add_domain(CLI::App& app, Chosen& chosen) {
  const auto arguments = std::make_shared<DomainArguments>();
  CLI::App* command = app.add_subcommand(
      "domain",
      "Measure the widest domain in which a subject holds; exit status 0 measured, 1 the subject violates an invariant "
      "where the search starts, 2 usage or environment error");
  command
      ->add_option("SUBJECT", arguments->subject,
                   "A built-in name, or 'exec:PROGRAM ARG…' for a program that implements the protocol")
      ->required();
  add_domain_option(
      *command, "--core", arguments->core,
      "The domain from which the search starts (default: sizes of 1 m, masses of 1 kg, speeds of 8 m/s, and the "
      "kinds that a program declares). Its kinds stay");
  add_seed(*command, arguments->seed, "Seed of the cases; the same seed gives the same domain");
  command
      ->add_option(
          "--cases", arguments->cases,
          "Number of fresh cases of each family in the domain; the weight of a family multiplies it. Each step "
          "of a search judges a twentieth of this number")
      ->check(CLI::Range(std::uint64_t{1}, std::uint64_t{1'000'000'000}))
      ->capture_default_str();
  command->add_option("--out", arguments->out, "File for --within, as JSON")->type_name("FILE");
  command
      ->add_option(
          "--picture", arguments->picture,
          "SVG picture with a bar for each quantity. With --digits, the bars also show where the subject holds "
          "to the default limit in ulps")
      ->type_name("FILE");
  command->add_option("--beside", arguments->beside, "Domain whose ranges the picture shows beside the bars")
      ->type_name("DOMAIN")
      ->capture_default_str();
  add_deviates(*command, arguments->deviates, "The output lists them");
  add_jobs(*command, arguments->jobs, "Number of threads");
  add_limits(*command, arguments->judged);
  add_timeout(*command, arguments->timeout);
  add_format(*command, arguments->format, {"text", "json"});
  command->callback([&chosen, arguments] { chosen = [arguments] { return measure_domain(*arguments); }; });
}

}  // namespace carom::tool
