// SPDX-License-Identifier: BSL-1.0
#include <charconv>
#include <cmath>
#include <stdexcept>

#include <fmt/format.h>

#include <carom/collision/json/json.hpp>
#include <carom/collision/json/object_reader.hpp>
#include <carom/properties/gate/by_name.hpp>
#include <carom/subjects/protocol/messages.hpp>
#include <carom/web/request.hpp>
#include <carom/web/solver.hpp>

namespace carom::web {
namespace {

using nlohmann::json;

std::string text_at(const json& value, const std::string& place) {
  if (!value.is_string()) {
    throw FormatError(place, "expected a string" + detail::found(value));
  }
  return value.get<std::string>();
}

std::vector<std::string> texts_at(const json& value, const std::string& place) {
  if (!value.is_array()) {
    throw FormatError(place, "expected an array of strings" + detail::found(value));
  }
  std::vector<std::string> texts;
  for (const json& text : value) {
    texts.push_back(text_at(text, place));
  }
  return texts;
}

/// The domain with this name, or with these ranges. Throws std::invalid_argument that begins with `place`.
properties::Domain domain_given(const std::string& place, const std::string& text) {
  if (const std::optional<properties::Domain> named = properties::domain_named(text)) {
    return *named;
  }
  std::vector<std::string> names;
  for (const properties::NamedDomain& named : properties::named_domains()) {
    names.emplace_back(named.name);
  }
  const bool is_name = text.find('=') == std::string::npos;
  try {
    return properties::domain_from(text);
  } catch (const std::invalid_argument& error) {
    throw std::invalid_argument(fmt::format(
        "{}: {}{}", place, error.what(),
        is_name ? fmt::format(", or {}{}", fmt::join(names, ", "), properties::did_you_mean(text, names)) : ""));
  }
}

Subject subject_from(json record) {
  Subject subject;
  std::string domain;
  if (record.is_object() && record.contains("domain") && record.at("domain").is_string()) {
    domain = properties::to_text(domain_given("domain", record.at("domain").get<std::string>()));
    record.erase("domain");
  }
  const subjects::protocol::Introduction introduction = subjects::protocol::introduction_from(record.dump());
  subjects::protocol::introduce(subject, introduction);
  if (subject.precision == Precision::extended) {
    throw FormatError("/precision", "expected binary32 or binary64; JavaScript's numbers are no wider");
  }
  if (!domain.empty()) {
    subject.domain = domain;
  }
  if (record.contains("specification")) {
    subject.specification = text_at(record.at("specification"), "/specification");
  }
  subject.open = [subject] { return open_solver(subject); };
  return subject;
}

oracles::Limits limits_from(detail::ObjectReader<json>& options) {
  constexpr int most_digits = 18;
  oracles::Limits limits;
  options.optional_number("limit_ulps", limits.limit_ulps);
  if (!(limits.limit_ulps > 0 && std::isfinite(limits.limit_ulps))) {
    throw FormatError(options.at("limit_ulps"), "expected a positive number");
  }
  if (options.has("digits")) {
    const std::uint64_t digits = count_from(options.required("digits"), options.at("digits"));
    if (digits < 1 || digits > most_digits) {
      throw FormatError(options.at("digits"), fmt::format("expected a whole number from 1 to {}", most_digits));
    }
    limits.digits = static_cast<int>(digits);
  }
  if (options.has("exact")) {
    limits.filtered = !options.required("exact").get<bool>();
  }
  return limits;
}

report::Environment environment_from(const json& record) {
  detail::ObjectReader<json> reader(record, "/environment");
  report::Environment environment;
  environment.compiler = "emscripten, clang " __clang_version__;
  environment.build_type = "WebAssembly";
  const auto text = [&](const char* name, std::string& into) {
    if (reader.has(name)) {
      into = text_at(reader.required(name), reader.at(name));
    }
  };
  text("date", environment.date);
  text("operating_system", environment.operating_system);
  text("kernel", environment.kernel);
  text("processor", environment.processor);
  if (reader.has("processor_threads")) {
    environment.processor_threads =
        static_cast<unsigned>(count_from(reader.required("processor_threads"), reader.at("processor_threads")));
  }
  reader.reject_others();
  return environment;
}

std::uint64_t count_at(detail::ObjectReader<json>& options, const char* name, std::uint64_t least,
                       std::uint64_t otherwise) {
  if (!options.has(name)) {
    return otherwise;
  }
  constexpr std::uint64_t most = 1'000'000'000;
  const std::uint64_t count = count_from(options.required(name), options.at(name));
  if (count < least || count > most) {
    throw FormatError(options.at(name), fmt::format("expected a whole number from {} to {}", least, most));
  }
  return count;
}

}  // namespace

std::uint64_t count_from(const json& value, const std::string& place) {
  if (value.is_number_unsigned()) {
    return value.get<std::uint64_t>();
  }
  if (value.is_string()) {
    const auto& text = value.get_ref<const std::string&>();
    std::uint64_t count = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), count);
    if (error == std::errc() && end == text.data() + text.size()) {
      return count;
    }
  }
  throw FormatError(place, "expected an integer from 0 to 2^64 - 1" + detail::found(value));
}

properties::Domain domain_of(const json& request) {
  return request.contains("within") ? domain_given("within", request.at("within").get<std::string>())
                                    : properties::Domain();
}

Request request_from(const json& record) {
  Request request;
  request.subject = subject_from(record.at("subject"));
  const json none = json::object();
  const json& given = record.contains("options") ? record.at("options") : none;
  detail::ObjectReader<json> options(given, "");
  properties::GateOptions& into = request.options;
  into.seed = options.has("seed") ? count_from(options.required("seed"), options.at("seed")) : 1;
  into.cases = count_at(options, "cases", 1, into.cases);
  into.relations_every = count_at(options, "relations_every", 1, 1);
  into.limits = limits_from(options);
  into.within = options.has("within")
                    ? domain_given("within", text_at(options.required("within"), options.at("within")))
                    : properties::domain_from(request.subject.domain);
  if (options.has("families")) {
    request.families = texts_at(options.required("families"), options.at("families"));
  }
  if (options.has("deviates")) {
    request.deviates = texts_at(options.required("deviates"), options.at("deviates"));
  }
  for (const std::string& text : request.deviates) {
    (void)properties::deviation_from(text);
    request.subject.deviates.push_back(text);
  }
  request.environment = environment_from(options.has("environment") ? options.required("environment") : none);
  if (options.has("out")) {
    request.out = text_at(options.required("out"), options.at("out"));
  }
  options.reject_others();
  into.progress = report_progress;
  return request;
}

Request run_request_from(const json& record) {
  Request request = request_from(record);
  properties::PosedFamilies posed =
      properties::posed_families(request.families, request.options.within, request.options.seed);
  request.options.families = std::move(posed.families);
  request.options.beyond_domain = std::move(posed.beyond_domain);
  request.without_case = std::move(posed.without_case);
  return request;
}

}  // namespace carom::web
