// SPDX-License-Identifier: BSL-1.0
#include "io/domain_argument.hpp"

#include <stdexcept>

#include <fmt/format.h>

#include <carom/collision/json/json.hpp>
#include <carom/report/model/domain_json.hpp>
#include <carom/report/model/words.hpp>

#include "io/json_file.hpp"
#include "io/usage_error.hpp"

namespace carom::tool {
namespace {

properties::Domain domain_from_file(const std::string& option, const std::string& file) {
  try {
    const nlohmann::json record = parse_json(content_of_file(file));
    return report::Json<properties::Domain>::read(report::Field(record));
  } catch (const FormatError& error) {
    throw UsageError(report::shown(fmt::format("{}: {}: {}", option, file, error.what())));
  } catch (const UsageError& error) {
    throw UsageError(fmt::format("{}: {}, or choose games, robotics, granular or everything", option, error.what()));
  }
}

}  // namespace

properties::Domain domain_from_argument(const std::string& option, const std::string& text) {
  if (!properties::domain_named(text) && text.find('=') == std::string::npos && !text.starts_with('{')) {
    return domain_from_file(option, text);
  }
  try {
    return properties::domain_from(text);
  } catch (const std::invalid_argument& error) {
    throw UsageError(report::shown(option + ": " + error.what()));
  }
}

properties::Domain declared_domain(const std::vector<Subject>& subjects) {
  const Subject* first = nullptr;
  properties::Domain declared;
  for (const Subject& subject : subjects) {
    try {
      const properties::Domain domain = properties::domain_from(subject.domain);
      if (first != nullptr && domain != declared) {
        throw UsageError(report::shown(fmt::format(
            "{} declares the domain {}, and {} declares {}; judge them one at a time, or choose a domain by --within",
            first->name, to_text(declared), subject.name, to_text(domain))));
      }
      declared = domain;
      first = &subject;
    } catch (const std::invalid_argument& error) {
      throw UsageError(
          report::shown(fmt::format("{}: the domain in the reply to start: {}", subject.name, error.what())));
    }
  }
  return declared;
}

}  // namespace carom::tool
