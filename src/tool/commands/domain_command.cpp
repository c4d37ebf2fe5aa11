// SPDX-License-Identifier: BSL-1.0
#include <algorithm>
#include <memory>
#include <optional>
#include <string>

#include <fmt/format.h>

#include <carom/collision/json/json.hpp>
#include <carom/properties/domains/draw_within.hpp>
#include <carom/properties/reach/reach.hpp>
#include <carom/properties/trial/in_words.hpp>
#include <carom/report/document/document.hpp>
#include <carom/report/model/answer_json.hpp>
#include <carom/report/model/domain_json.hpp>
#include <carom/report/model/version.hpp>
#include <carom/report/model/words.hpp>

#include "commands/commands.hpp"
#include "commands/options.hpp"
#include "io/interrupt.hpp"
#include "io/orphans.hpp"
#include "io/output_file.hpp"
#include "io/subject_argument.hpp"
#include "io/threads.hpp"
#include "io/usage_error.hpp"

namespace carom::tool {
namespace {

using nlohmann::json;
using properties::Face;
using properties::LimitedQuantity;
using properties::Witness;

struct DomainArguments {
  std::string subject;
  std::optional<properties::Domain> core;
  std::uint64_t seed = 1;
  std::uint64_t cases = 200;
  YardstickArguments judged;
  unsigned jobs = 0;   // 0: one for each core
  double timeout = 5;  // for each reply of a program [s]
  std::string out;     // a file for --within; empty for none
  std::string format = "text";
};

json domain_record(const properties::Domain& domain) { return report::Json<properties::Domain>::write(domain); }

json witness_record(const Witness& witness) {
  return {{"invariant", witness.invariant},
          {"family", witness.family},
          {"collision", collision_to_json(witness.shrunk.collision)},
          {"violation", report::shown(properties::in_words(witness.verdict))}};
}

json record_of(const Subject& subject, const properties::ReachOptions& options, const properties::Reach& reach) {
  json record{{"carom", report::version},
              {"subject", subject.name},
              {"seed", options.seed},
              {"yardstick", report::Json<oracles::Yardstick>::write(options.yardstick)},
              {"error", report::shown(reach.error)},
              {"core", domain_record(options.core)},
              {"faces", json::array()},
              {"domain", domain_record(reach.domain)},
              {"share", reach.share},
              {"cases", reach.cases}};
  if (reach.in_core) {
    record["in_core"] = witness_record(*reach.in_core);
  }
  for (const Face& face : reach.faces) {
    record["faces"].push_back({{"quantity", name_of(face.quantity)},
                               {"end", face.is_upper ? "most" : "least"},
                               {"value", face.end},
                               {"beyond", face.beyond ? witness_record(*face.beyond) : json()},
                               {"error", report::shown(face.error)}});
  }
  return record;
}

std::string witness_text(const Witness& witness) {
  return fmt::format("{}\n  {}\n", properties::in_words(witness.shrunk.collision, "  ").substr(2),
                     report::shown(properties::in_words(witness.verdict)));
}

report::Table table_of(const properties::Reach& reach) {
  report::Table table{"The ends of each range",
                      {{"quantity"}, {"end"}, {"holds to", true}, {"in the domain", true}, {"violated beyond"}},
                      {}};
  for (const Face& face : reach.faces) {
    const properties::Range& range = reach.domain.ranges[face.quantity];
    table.rows.push_back(
        {{std::string(name_of(face.quantity)), face.is_upper ? "most" : "least", fmt::format("{:.3g}", face.end),
          fmt::format("{:.3g}", face.is_upper ? range.most : range.least),
          face.beyond          ? face.beyond->invariant
          : face.error.empty() ? std::string("the search ends here")
                               : "error: " + report::shown(face.error)}});
  }
  return table;
}

std::string text_of(const Subject& subject, const properties::ReachOptions& options, const properties::Reach& reach) {
  std::string text = fmt::format("Carom {}: the domain of {}, seed {}, limit {}\nThe search starts from {}.\n\n",
                                 report::version, report::shown(subject.name), options.seed,
                                 report::limit_in_words(options.yardstick), to_text(options.core));
  if (!reach.error.empty()) {
    return text + fmt::format("The subject could not be judged there: {}\n", report::shown(reach.error));
  }
  if (reach.in_core) {
    return text + fmt::format(
                      "The subject violates {} there, so it has no domain around these values. Choose other "
                      "values by --core.\n\n  {}",
                      reach.in_core->invariant, witness_text(*reach.in_core));
  }
  text += report::in_text({table_of(reach)});
  text += fmt::format(
      "\n*holds to*: only this quantity leaves the core. *in the domain*: all quantities leave it together{}.\n\n"
      "{}\n\nNo violation in {} fresh cases of this domain. A defect that shows in fewer than 3 of "
      "so many cases can be missed.\n",
      reach.share < 1 ? fmt::format(", {:.0f} % of the way", 100 * reach.share) : "", to_text(reach.domain),
      reach.cases);
  for (const Face& face : reach.faces) {
    if (face.beyond) {
      text +=
          fmt::format("\n{} {} {:.3g}: violates {}\n  {}", name_of(face.quantity), face.is_upper ? "above" : "below",
                      face.end, face.beyond->invariant, witness_text(*face.beyond));
    }
  }
  return text;
}

int measure_domain(const DomainArguments& arguments) {
  const std::stop_token stop = stop_on_interrupt();
  const Orphanage orphanage;
  const Subject subject = subject_from_argument(arguments.subject, arguments.timeout, stop);
  if (!subject.absent.empty()) {
    throw UsageError(report::shown(fmt::format("{}: {}", subject.name, subject.absent)));
  }
  properties::ReachOptions options;
  options.seed = arguments.seed;
  options.yardstick = arguments.judged.yardstick();
  options.workers = threads(arguments.jobs);
  options.core = arguments.core.value_or(properties::default_core());
  options.cases_of_box = arguments.cases;
  options.cases_of_slab = std::max<std::uint64_t>(1, arguments.cases / 20);
  options.stop = stop;
  if (!has_cases_within(options.core, *properties::family_named("generic"), options.seed)) {
    throw UsageError(fmt::format("--core: no case of generic lies within {}; use wider ranges", to_text(options.core)));
  }
  const properties::Reach reach = measured_reach(subject, options);
  const bool is_known = reach.error.empty() && !reach.in_core;
  fmt::print("{}", arguments.format == "json"
                       ? record_of(subject, options, reach).dump(1, ' ', false, json::error_handler_t::replace) + '\n'
                       : text_of(subject, options, reach));
  if (is_known && !arguments.out.empty()) {
    write_file(arguments.out, domain_record(reach.domain).dump(1) + '\n');
  }
  return is_known ? exit_all_hold : reach.in_core ? exit_violated : exit_usage;
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
  add_domain_option(*command, "--core", arguments->core,
                    "The domain from which the search starts (default: sizes of 1 m, masses of 1 kg, speeds of 8 m/s)");
  add_seed(*command, arguments->seed, "Seed of the cases; the same seed gives the same domain");
  command
      ->add_option(
          "--cases", arguments->cases,
          "Number of fresh cases of each family in the domain; the weight of a family multiplies it. Each step "
          "of a search judges a twentieth of this number")
      ->check(CLI::Range(std::uint64_t{1}, std::uint64_t{1'000'000'000}))
      ->capture_default_str();
  command->add_option("--out", arguments->out, "File for --within, as JSON")->type_name("FILE");
  add_jobs(*command, arguments->jobs, "Number of threads");
  add_yardstick(*command, arguments->judged);
  add_timeout(*command, arguments->timeout);
  add_format(*command, arguments->format, {"text", "json"});
  command->callback([&chosen, arguments] { chosen = [arguments] { return measure_domain(*arguments); }; });
}

}  // namespace carom::tool
