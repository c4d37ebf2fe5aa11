// SPDX-License-Identifier: BSL-1.0
#include <algorithm>
#include <array>
#include <chrono>
#include <functional>
#include <limits>
#include <set>

#include <fmt/format.h>

#include <carom/properties/cases/draw_within.hpp>
#include <carom/properties/gate/in_words.hpp>
#include <carom/report/results/findings.hpp>
#include <carom/report/results/run_json.hpp>
#include <carom/report/results/values_json.hpp>
#include <carom/report/results/version.hpp>
#include <carom/report/results/words.hpp>

namespace carom::report {

using nlohmann::json;
using properties::FamilyResult;
using properties::ViolatedCase;
using DigitsHistogram = properties::Histogram<properties::DigitsScale>;

template <>
struct Json<unsigned> {
  static json write(unsigned value) { return value; }
  static unsigned read(const Field& field) {
    constexpr std::uint64_t most = 1U << 20U;
    if (field.count() > most) {
      field.fail("a number of threads");
    }
    return static_cast<unsigned>(field.count());
  }
};

/// Reads the name of one enumerator of `all`.
template <class E, std::size_t count>
E named(const Field& field, const std::array<E, count>& all, const char* what) {
  const auto found = std::find_if(all.begin(), all.end(), [&](E one) { return name_of(one) == field.text(); });
  if (found == all.end()) {
    field.fail(what);
  }
  return *found;
}

template <>
struct Json<Law> {
  static json write(Law law) { return name_of(law); }
  static Law read(const Field& field) { return named(field, all_laws, "the name of a law"); }
};

template <>
struct Json<Precision> {
  static json write(Precision precision) { return name_of(precision); }
  static Precision read(const Field& field) {
    return named(field, std::array{Precision::binary32, Precision::binary64, Precision::extended},
                 "the name of a precision");
  }
};

template <>
struct Json<SubjectStatus> {
  static json write(SubjectStatus status) { return name_of(status); }
  static SubjectStatus read(const Field& field) {
    return named(field, all_subject_statuses, "the status of a subject");
  }
};

template <>
struct Json<Collision> {
  static json write(const Collision& collision) { return collision_to_json(collision); }
  static Collision read(const Field& field) { return collision_from_json(field.value(), field.place()); }
};

template <>
struct Json<oracles::JudgeError> {
  static json write(const oracles::JudgeError& error) {
    return {{"what", error.what()}, {"collision", collision_to_json(error.collision())}};
  }
  static oracles::JudgeError read(const Field& field) {
    return {field.at("what").text(), Json<Collision>::read(field.at("collision"))};
  }
};

template <>
struct Json<DigitsHistogram> {
  static json write(const DigitsHistogram& digits) {
    json bins = json::array();
    for (std::size_t bin = 0; bin < digits.counts().size(); ++bin) {
      if (digits.counts()[bin] > 0) {
        bins.push_back({bin, digits.counts()[bin]});
      }
    }
    return {{"smallest", number_to_json(digits.smallest())},
            {"largest", number_to_json(digits.largest())},
            {"bins", std::move(bins)}};
  }
  static DigitsHistogram read(const Field& record) {
    std::vector<std::uint64_t> counts;
    for (const Field& pair : record.at("bins").elements()) {
      const std::vector<Field> numbers = pair.elements();
      if (numbers.size() != 2 || numbers[0].count() >= properties::DigitsScale::bins) {
        pair.fail("a bin and its count");
      }
      counts.resize(std::max<std::size_t>(counts.size(), numbers[0].count() + 1));
      counts[numbers[0].count()] = numbers[1].count();
    }
    const double smallest = record.at("smallest").number();
    const double largest = record.at("largest").number();
    if (!counts.empty() && !(smallest <= largest)) {
      record.fail("a smallest number that is not greater than the largest");
    }
    return DigitsHistogram::restored(std::move(counts), smallest, largest);
  }
};

template <class A>
void fields(A& archive, Is<Environment> auto& environment) {
  archive("date", environment.date);
  archive("compiler", environment.compiler);
  archive("compiler_flags", environment.compiler_flags);
  archive("build_type", environment.build_type);
  archive("operating_system", environment.operating_system);
  archive("kernel", environment.kernel);
  archive("processor", environment.processor);
  archive("processor_threads", environment.processor_threads);
}

template <class A>
void fields(A& archive, Is<properties::Coverage> auto& coverage) {
  archive("cases", coverage.cases);
  archive("colliding", coverage.colliding);
  archive("resting", coverage.resting);
  archive("separating", coverage.separating);
  archive("inert", coverage.inert);
  archive("invalid", coverage.invalid);
  archive("one_immovable", coverage.one_immovable);
  archive("spheres", coverage.spheres);
  archive("head_on", coverage.head_on);
  archive("inelastic", coverage.inelastic);
  archive("elastic", coverage.elastic);
  archive("adjusted", coverage.adjusted);
}

template <class A>
void fields(A& archive, Is<properties::diagnosis::FaultWitness> auto& witness) {
  archive("family", witness.family);
  archive("case", witness.index);
  archive("invariant", witness.invariant);
}

template <class A>
void fields(A& archive, Is<properties::diagnosis::Fault> auto& fault) {
  archive("what", fault.what);
  archive("where", fault.where);
  archive("look_at", fault.look_at);
  archive("cases", fault.cases);
  archive.unless_default("witness", fault.witness);
}

template <class A>
void fields(A& archive, Is<properties::diagnosis::Diagnosis> auto& diagnosis) {
  archive("telling", diagnosis.telling);
  archive("violated", diagnosis.violated);
  archive("telling_in", diagnosis.telling_in);
  archive("faults", diagnosis.faults);
}

template <class A>
void fields(A& archive, Is<Digits> auto& digits) {
  archive("p50", digits.p50);
  archive("p99", digits.p99);
  archive("worst", digits.worst);
}

template <class A>
void fields(A& archive, Is<properties::Count> auto& count) {
  archive("holds", count.holds);
  archive("violated", count.violated);
  archive("skipped", count.skipped);
}

template <class A>
void fields(A& archive, Is<properties::EnergyGain> auto& gain) {
  archive("joules", gain.joules);
  archive("share", gain.share);
  archive.unless_default("family", gain.family);
  archive("case", gain.index);
}

template <class A>
void fields(A& archive, Is<properties::EnergyGains> auto& gains) {
  archive("colliding", gains.colliding);
  archive("gaining", gains.gaining);
  archive("by_law", gains.by_law);
  archive.unless_default("greatest", gains.greatest);
  archive.unless_default("greatest_share", gains.greatest_share);
  if constexpr (A::reads) {
    if (gains.gaining > 0 && !gains.greatest) {
      archive.record.fail("the greatest gain");
    }
  }
}

template <class A>
void fields(A& archive, Is<properties::WayOn> auto& way) {
  archive.unless_default("within", way.within);
  archive.unless_default("claims", way.effects);
  archive("cases", way.cases);
}

template <class A>
void fields(A& archive, Is<properties::Boundary> auto& boundary) {
  archive("quantity", boundary.quantity);
  archive("case", boundary.index);
  archive("invariant", boundary.invariant);
}

template <class A>
void fields(A& archive, Is<properties::Witness> auto& witness) {
  archive("invariant", witness.invariant);
  archive("family", witness.family);
  archive("case", witness.index);
  archive("convex_uniform", witness.shrunk.convex_uniform);
  archive("collision", witness.shrunk.collision);
  archive("drawn", witness.original.collision);
  archive("outcome", witness.answer);
  archive("verdict", witness.verdict);
  archive("drawn_outcome", witness.answer_as_found);
  archive("drawn_verdict", witness.verdict_as_found);
  archive("reproduced", witness.is_reproduced);
  archive.unless_default("not_shrunk", witness.not_shrunk);
}

template <class A>
void subject_fields(A& archive, Is<Subject> auto& subject) {
  archive("name", subject.name);
  archive("summary", subject.summary);
  archive("model", subject.law);
  archive("precision", subject.precision);
  archive("expected_to_pass", subject.expected_to_pass);
  archive("deviates", subject.deviates);
  archive.unless_default("claims", subject.effects);
  archive("shows_collision_matrix", subject.shows_collision_matrix);
  archive.unless_default("specification", subject.specification);
  archive.unless_default("version", subject.version);
}

inline void require_new(std::set<std::string>& names, const Field& name) {
  if (!names.insert(name.line()).second) {
    throw FormatError(name.place(), fmt::format("'{}' occurs twice; expected different names", name.line()));
  }
}

void require_family_at(const Field& record, std::string_view family) {
  if (const Field name = record.at("family"); name.text() != family) {
    name.fail(fmt::format("the family \"{}\" at this position", family));
  }
}

template <class A>
void family_fields(A& archive, const properties::Family& family, Is<FamilyResult> auto& result) {
  if constexpr (A::reads) {
    require_family_at(archive.record, family.name);
  } else {
    archive("family", &family);
  }
  archive("cases", result.cases);
  archive("skipped", result.skipped);
  archive("not_judged", result.unjudged);
  archive.unless_default("decided_by", result.decided_by);
  archive("violated", result.violated);
  if constexpr (A::reads) {
    std::vector<std::uint64_t> parts{result.skipped, result.violated};
    parts.insert(parts.end(), result.unjudged.begin(), result.unjudged.end());
    std::uint64_t rest = result.cases;
    for (const std::uint64_t part : parts) {
      if (part > rest) {
        archive.record.at("cases").fail("at least the sum of the skipped, not judged and violated cases");
      }
      rest -= part;
    }
  }
}

template <class A>
void posed_fields(A& archive, const properties::Family& family, Is<FamilyResult> auto& result) {
  family_fields(archive, family, result);
  archive("worst_backward_error_ulps", result.worst_backward_error);
  archive.unless_default("energy", result.energy);
  archive("invariants", result.counts);
  if constexpr (!A::reads) {
    for (const auto& [invariant, worst] : result.worst) {
      archive.record["invariants"][std::string(invariant->name)]["worst_case"] = worst.index;
    }
  }
}

template <class A>
void beyond_domain_fields(A& archive, const properties::Family& family, Is<FamilyResult> auto& result) {
  family_fields(archive, family, result);
  archive("boundary", result.boundary);
}

/// A list of a subject's results, one for each of `families`. There may be fewer results for families beyond the domain
/// that solvers claim.
template <class Families, class Results, class OfOne>
void results_field(Writer& archive, const char* name, const Families& families, const Results& results,
                   const OfOne& of_one) {
  json list = json::array();
  for (std::size_t f = 0; f < results.size(); ++f) {
    Writer writer;
    of_one(writer, *families[f], results[f]);
    list.push_back(std::move(writer.record));
  }
  archive.record[name] = std::move(list);
}

template <class Families, class Results, class OfOne>
void results_field(Reader& archive, const char* name, const Families& families, Results& results, const OfOne& of_one) {
  const std::vector<Field> list = archive.record.at(name).elements();
  if (list.size() > families.size()) {
    archive.record.at(name).fail(fmt::format("{} families", families.size()));
  }
  for (const Field& element : list) {
    const std::size_t f = results.size();
    Reader reader(element);
    of_one(reader, *families[f], results.emplace_back());
  }
}

/// A violated invariant: the number of cases that violate it, and its witness. The witness is a separate file.
json violation_record(const properties::Witness& witness, const properties::SubjectResult& result) {
  return {{"invariant", witness.invariant->name},
          {"count", result.count(*witness.invariant).violated},
          {"family", witness.family->name},
          {"case", witness.index},
          {"witness", witness_path("", result.subject, *witness.invariant)}};
}

/// The fields that only a judged subject has, except those that follow from others.
template <class A>
void judged_fields(A& archive, const Run& run, Is<properties::SubjectResult> auto& result) {
  archive("nanoseconds_per_solve", result.nanoseconds_per_solve);
  results_field(archive, "families", run.options.families, result.families,
                [](auto& each, const auto& family, auto& of_family) { posed_fields(each, family, of_family); });
  bool has_beyond_domain = !result.beyond_domain.empty();
  if constexpr (A::reads) {
    has_beyond_domain = archive.record.find("beyond_domain").has_value();
  }
  if (has_beyond_domain) {
    results_field(
        archive, "beyond_domain", run.options.beyond_domain, result.beyond_domain,
        [](auto& each, const auto& family, auto& of_family) { beyond_domain_fields(each, family, of_family); });
  }
  archive.unless_default("error_beyond_domain", result.error_beyond_domain);
}

void add_derived_fields(Writer& archive, const Run& run, std::size_t s) {
  const properties::SubjectResult& result = run.results[s];
  const auto worst = result.worst_backward_error(run.options);
  archive.record["worst_backward_error"] = {{"ulps", number_to_json(worst.backward_error)},
                                            {"family", worst.family == nullptr ? "" : worst.family->name}};
  archive("digits", digits_of(result));
  archive("cases", result.cases());
  archive("skipped", result.skipped());
  archive("not_judged", result.unjudged());
  archive.unless_default("never_judged", never_judged(run, result));
  archive.record["violations"] = json::array();
  for (const properties::Witness& witness : result.witnesses) {
    archive.record["violations"].push_back(violation_record(witness, result));
  }
  const properties::diagnosis::Diagnosis& diagnosis = run.diagnoses[s];
  if (diagnosis.telling != nullptr) {
    archive("diagnosis", diagnosis);
  }
  archive.unless_default("no_diagnosis", diagnosis.missing);
  archive.unless_default("energy", result.energy(run.options));
  archive.unless_default("ways_on", result.ways_on);
}

/// The fields that every subject has, including an absent one.
template <class A>
void standing_fields(A& archive, Is<Subject> auto& subject, auto&& counts, auto&& status, auto&& error) {
  subject_fields(archive, subject);
  if constexpr (!A::reads) {
    archive("not_claimed", properties::not_claimed_without_matrix(subject));
  }
  archive("counts", counts);
  archive("status", status);
  archive("error", error);
}

void subjects_field(Writer& archive, const Run& run) {
  json list = json::array();
  for (std::size_t s = 0; s < run.results.size(); ++s) {
    const properties::SubjectResult& result = run.results[s];
    Writer writer;
    standing_fields(writer, result.subject, bool{run.counts[s]}, status_of(result), why_not_judged(result));
    judged_fields(writer, run, result);
    add_derived_fields(writer, run, s);
    list.push_back(std::move(writer.record));
  }
  for (const Subject& subject : run.absent) {
    Writer writer;
    standing_fields(writer, subject, false, SubjectStatus::absent, subject.absent);
    list.push_back(std::move(writer.record));
  }
  archive.record["subjects"] = std::move(list);
}

void subjects_field(Reader& archive, Run& run) {
  std::set<std::string> names;
  for (const Field& record : archive.record.at("subjects").elements()) {
    require_new(names, record.at("name"));
    Reader reader(record);
    properties::SubjectResult result;
    bool counts = false;
    SubjectStatus status{};
    std::string error;
    standing_fields(reader, result.subject, counts, status, error);
    if (status == SubjectStatus::absent) {
      run.absent.push_back(std::move(result.subject));
      run.absent.back().absent = error;
      continue;
    }
    // A subject with a violation may also have ended early.
    (status == SubjectStatus::not_judged ? result.not_judged : result.error) = error;
    judged_fields(reader, run, result);
    if (result.families.size() != run.options.families.size()) {
      record.at("families").fail(fmt::format("{} families", run.options.families.size()));
    }
    for (const Field& violation : record.at("violations").elements()) {
      properties::Witness& witness = result.witnesses.emplace_back();
      witness.invariant = Json<const properties::Invariant*>::read(violation.at("invariant"));
      witness.family = Json<const properties::Family*>::read(violation.at("family"));
      witness.index = violation.at("case").count();
    }
    run.counts.push_back(counts);
    run.results.push_back(std::move(result));
  }
  run.diagnoses.resize(run.results.size());
}

/// The data that only merged_run needs. For each subject it has the histogram of correct digits, and the findings
/// (findings.hpp) of each family in which the subject skips a case or violates an invariant.
json shard_record(const Run& run) {
  json record{{"number", run.options.shard.number},
              {"of", run.options.shard.of},
              {"pairs", run.features.pairs()},
              {"digits", json::array()},
              {"findings", json::array()}};
  for (const properties::SubjectResult& result : run.results) {
    record["digits"].push_back(Json<DigitsHistogram>::write(result.digits));
    json findings = json::object();
    for (std::size_t f = 0; f < result.families.size(); ++f) {
      if (!result.families[f].worst.empty() || !result.families[f].skipped_cases.empty()) {
        findings[std::string(run.options.families[f]->name)] = findings_record(result.families[f]);
      }
    }
    record["findings"].push_back(std::move(findings));
  }
  return record;
}

properties::Shard shard_number_from(const Field& record) {
  const properties::Shard shard{record.at("number").count(), record.at("of").count()};
  if (shard.number < 1 || shard.number > shard.of) {
    record.at("number").fail("a number from 1 to the number of shards");
  }
  return shard;
}

/// Reads all data of the subject in the shard, except its counts.
void read_shard_of_subject(const Field& shard, std::size_t s, const properties::GateOptions& options,
                           properties::SubjectResult& result) {
  const auto of_subject = [&](const char* name) {
    const std::vector<Field> list = shard.at(name).elements();
    if (list.size() <= s) {
      shard.at(name).fail("one element for each judged subject");
    }
    return list[s];
  };
  result.digits = Json<DigitsHistogram>::read(of_subject("digits"));
  const Field findings = of_subject("findings");
  for (std::size_t f = 0; f < result.families.size(); ++f) {
    const properties::Family& family = *options.families[f];
    FamilyResult& of_family = result.families[f];
    of_family.sampled = properties::sampled_of(family);
    const auto& counts = of_family.counts;
    const bool is_violated =
        std::any_of(counts.begin(), counts.end(), [](const auto& of_name) { return of_name.second.violated > 0; });
    if (is_violated || findings.find(std::string(family.name))) {
      read_findings(
          findings.at(std::string(family.name)), options.cases * static_cast<std::uint64_t>(family.weight),
          [&](std::uint64_t number) {
            return properties::drawn_case_within(options.within, family, options.seed, number);
          },
          of_family);
    }
  }
}

void families_fields(Writer& archive, const Run& run) {
  json& families = archive.record["families"] = json::array();
  for (std::size_t f = 0; f < run.options.families.size(); ++f) {
    const properties::Family& family = *run.options.families[f];
    families.push_back({{"name", family.name},
                        {"summary", family.summary},
                        {"coverage", Json<properties::Coverage>::write(run.coverage[f])}});
  }
  for (const properties::Family* family : run.options.beyond_domain) {
    archive.record["beyond_domain"].push_back(
        {{"name", family->name}, {"summary", family->summary}, {"quantity", family->beyond.name}});
  }
}

void families_fields(Reader& archive, Run& run) {
  std::set<std::string> names;
  for (const Field& family : archive.record.at("families").elements()) {
    require_new(names, family.at("name"));
    run.options.families.push_back(Json<const properties::Family*>::read(family.at("name")));
    run.coverage.push_back(Json<properties::Coverage>::read(family.at("coverage")));
  }
  if (const std::optional<Field> list = archive.record.find("beyond_domain")) {
    for (const Field& family : list->elements()) {
      run.options.beyond_domain.push_back(Json<const properties::Family*>::read(family.at("name")));
      if (!run.options.beyond_domain.back()->is_beyond_domain()) {
        family.at("name").fail("the name of a family beyond the claimed domain");
      }
    }
  }
}

void features_field(Writer& archive, const Run& run) {
  json cases = json::object();
  for (std::size_t i = 0; i < properties::all_features().size(); ++i) {
    cases[std::string(properties::all_features()[i].name)] = run.features.count(i);
  }
  archive.record["features"] = {{"met_pairs", run.features.met_pairs()}, {"cases", std::move(cases)}};
}

void features_field(Reader& archive, Run& run) {
  const Field features = archive.record.at("features");
  const Field pairs = archive.record.at("shard").at("pairs");
  std::vector<std::uint64_t> counts;
  for (const properties::Feature& feature : properties::all_features()) {
    counts.push_back(features.at("cases").at(std::string(feature.name)).count());
  }
  std::optional<properties::FeatureCoverage> coverage =
      properties::FeatureCoverage::reported(std::move(counts), pairs.text());
  if (!coverage) {
    pairs.fail("hexadecimal digits, one for four pairs of features");
  }
  run.features = *std::move(coverage);
}

/// The fields that are in every report, and that a shard is read from.
template <class A>
void run_fields(A& archive, Is<Run> auto& run) {
  auto& options = run.options;
  archive("carom", run.carom);
  archive("environment", run.environment);
  archive("seed", options.seed);
  archive("cases_of_each_family", options.cases);
  archive.unless_default("within", options.within);
  archive.unless_default("without_case", run.without_case);
  archive("yardstick", options.limits);
  archive.unless_default("relations_every", options.relations_every);
  archive.unless_default("deviates", run.deviates);
  archive("interrupted", run.interrupted);
  archive.unless_default("judge_error", run.judge_error);
  families_fields(archive, run);
  features_field(archive, run);
  subjects_field(archive, run);
}

json environment_record(const Environment& environment) { return Json<Environment>::write(environment); }

json report_record(const Run& run) {
  Writer archive;
  run_fields(archive, run);
  if (run.options.budget) {
    archive.record["cases_of_each_family"] = nullptr;
    archive("budget_seconds", std::chrono::duration<double>(*run.options.budget).count());
  }
  archive.unless_default("fail_fast", run.options.fail_fast);
  archive("exit_status", static_cast<std::uint64_t>(run.exit_status()));
  if (run.is_shard) {
    archive.record["shard"] = shard_record(run);
  }
  if (run.baseline) {
    archive.record["baseline"] = baseline_record(*run.baseline);
  }
  return std::move(archive.record);
}

RecordedSubject recorded_subject(const Field& record, const std::vector<std::string>& families) {
  const auto texts = [](const Field& list) {
    std::vector<std::string> lines;
    for (const Field& text : list.elements()) {
      lines.push_back(text.line());
    }
    return lines;
  };
  RecordedSubject subject;
  subject.name = record.at("name").line();
  if (const std::optional<Field> specification = record.find("specification")) {
    subject.specification = specification->line();
  }
  subject.counts = record.at("counts").flag();
  if (const std::optional<Field> effects = record.find("claims")) {
    subject.effects = properties::to_text(Json<DeclaredEffects>::read(*effects));
  }
  if (const std::optional<Field> not_claimed = record.find("not_claimed")) {
    subject.not_claimed = texts(*not_claimed);
  }
  subject.status = Json<SubjectStatus>::read(record.at("status"));
  subject.error = record.at("error").line();
  subject.deviates = texts(record.at("deviates"));
  if (subject.status == SubjectStatus::absent) {
    return subject;
  }
  for (const Field& family : record.at("families").elements()) {
    if (subject.families.size() == families.size()) {
      record.at("families").fail(fmt::format("{} families", families.size()));
    }
    const std::string& name = families[subject.families.size()];
    require_family_at(family, name);
    subject.families.push_back({name, {}});
    for (const auto& [invariant, count] : family.at("invariants").members()) {
      subject.families.back().counts[shown(invariant)] = {count.at("holds").count(), count.at("violated").count(), 0};
    }
  }
  for (const Field& violation : record.at("violations").elements()) {
    subject.violated.push_back(violation.at("invariant").line());
  }
  return subject;
}

/// The settings in words, with which the numbers of two reports are comparable.
void read_settings(const Field& record, RecordedRun& run) {
  const auto has = [&](const char* name) {
    const std::optional<Field> flag = record.find(name);
    return flag && flag->flag();
  };
  const std::optional<Field> budget = record.find("budget_seconds");
  const std::optional<Field> within = record.find("within");
  const std::optional<Field> every = record.find("relations_every");
  const auto limits = Json<oracles::Limits>::read(record.at("yardstick"));
  run.cases = budget              ? fmt::format("as many as possible in {} s", budget->number())
              : run.heading.cases ? std::to_string(*run.heading.cases)
                                  : "unknown";
  run.domain = to_text(within ? Json<properties::Domain>::read(*within) : properties::Domain());
  run.yardstick = limit_in_words(limits) + (limits.filtered ? "" : ", only in exact arithmetic");
  run.relations_every = every && every->count() > 0 ? std::to_string(every->count()) : "default";
  run.ended_early = record.at("interrupted").flag() ? "interrupted"
                    : has("fail_fast")              ? "after the first violation of each subject"
                                                    : "no";
  run.shard = "the whole run";
  if (const std::optional<Field> field = record.find("shard")) {
    const properties::Shard shard = shard_number_from(*field);
    run.shard = fmt::format("{}/{}", shard.number, shard.of);
  }
}

RecordedRun recorded_run(const json& json_record, const std::string& file) {
  const Field record(json_record);
  RecordedRun run;
  std::set<std::string> names;
  for (const Field& family : record.at("families").elements()) {
    require_new(names, family.at("name"));
    run.families.push_back(family.at("name").line());
  }
  run.heading = {shown(file), record.at("carom").line(), record.at("environment").at("date").line(),
                 record.at("seed").count(),
                 Json<std::optional<std::uint64_t>>::read(record.at("cases_of_each_family"))};
  read_settings(record, run);
  names.clear();
  for (const Field& subject : record.at("subjects").elements()) {
    require_new(names, subject.at("name"));
    run.subjects.push_back(recorded_subject(subject, run.families));
  }
  std::stable_partition(run.subjects.begin(), run.subjects.end(),
                        [](const RecordedSubject& subject) { return subject.status != SubjectStatus::absent; });
  return run;
}

ReadShard shard_from(const json& json_record, const std::string& file) {
  const Field record(json_record);
  if (record.at("carom").text() != version) {
    record.at("carom").fail(fmt::format("\"{}\", the version of this program", version));
  }
  if (record.at("interrupted").flag()) {
    record.at("interrupted").fail("a run that was not interrupted");
  }
  if (!record.find("shard")) {
    throw FormatError(
        "/shard", "is missing: this report is not of a shard; merge needs reports of `carom gate --shard I/N --out`");
  }
  ReadShard shard{file, {}};
  Run& run = shard.run;
  run.is_shard = true;
  run.options.shard = shard_number_from(record.at("shard"));
  Reader reader(record);
  run_fields(reader, run);
  for (std::size_t s = 0; s < run.results.size(); ++s) {
    read_shard_of_subject(record.at("shard"), s, run.options, run.results[s]);
  }
  return shard;
}

json witness_record(const properties::Witness& witness, const Subject& subject, const properties::GateOptions& options,
                    const std::string& witness_file) {
  json record = Json<properties::Witness>::write(witness);
  Writer of_subject;
  subject_fields(of_subject, subject);
  of_subject("not_claimed", properties::not_claimed_without_matrix(subject));
  record["subject"] = std::move(of_subject.record);
  record["statement"] = witness.invariant->statement;
  record["formula"] = witness.invariant->formula;
  record["seed"] = options.seed;
  record["yardstick"] = Json<oracles::Limits>::write(options.limits);
  record["replay"] = replay_command(witness_file, subject, options);
  const properties::JudgedCase judged_case(witness.shrunk, true, subject.effects);
  if (!judged_case.is_valid()) {
    return record;
  }
  const std::string why_missing = properties::why_failed([&] {
    for (const Law law : laws_with_truth) {
      if (subject.law == law || subject.law == Law::any) {
        record["truth"][std::string(name_of(law))] = truth_record(judged_case.exact(), law);
      }
    }
    if (subject.law == Law::coulomb) {
      record["answers"]["coulomb"] = answers_record(oracles::coulomb_answers(judged_case.exact()));
    }
  });
  if (!why_missing.empty()) {
    record["truth_missing"] = why_missing;
  }
  return record;
}

properties::Witness witness_from(const json& record, const properties::Invariant& invariant) {
  properties::Witness witness = Json<properties::Witness>::read(Field(record));
  if (witness.invariant != &invariant) {
    throw FormatError("/invariant", fmt::format("expected \"{}\"", invariant.name));
  }
  witness.original.convex_uniform = witness.shrunk.convex_uniform;
  return witness;
}

}  // namespace carom::report
