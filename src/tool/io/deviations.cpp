// SPDX-License-Identifier: BSL-1.0
#include "io/deviations.hpp"

#include <algorithm>
#include <stdexcept>

#include <carom/properties/trial/deviation.hpp>
#include <carom/report/model/words.hpp>

#include "io/usage_error.hpp"

namespace carom::tool {
namespace {

void add_once(std::vector<std::string>& list, const std::string& text) {
  if (std::find(list.begin(), list.end(), text) == list.end()) {
    list.push_back(text);
  }
}

}  // namespace

std::vector<std::string> known_deviations(const std::vector<std::string>& texts) {
  std::vector<std::string> deviates;
  for (const std::string& text : texts) {
    try {
      (void)properties::deviation_from(text);
    } catch (const std::invalid_argument& error) {
      throw UsageError(report::shown(std::string("--deviates: ") + error.what()));
    }
    add_once(deviates, text);
  }
  return deviates;
}

void let_deviate(Subject& subject, const std::vector<std::string>& deviates) {
  for (const std::string& text : deviates) {
    add_once(subject.deviates, text);
  }
}

}  // namespace carom::tool
