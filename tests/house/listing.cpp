// SPDX-License-Identifier: BSL-1.0
#include <iostream>

#include <carom/collision/validate.hpp>
#include <carom/properties/families/family.hpp>
#include <carom/properties/features/feature.hpp>
#include <carom/properties/gate/schedule.hpp>
#include <carom/properties/invariants/invariant.hpp>

/// Lists the catalogues of the judge, one row per line, for adding_test.py. A family is listed if it can draw a case.
int main() {
  using namespace carom::properties;
  GateOptions options;
  options.cases = 1;
  for (const Family& family : all_families()) {
    options.families.push_back(&family);
  }
  Schedule schedule(options);
  while (const auto task = schedule.next()) {
    const Family& family = *options.families[task->family];
    if (task->first == 0 && carom::validate(drawn_case(family, 1, 0).collision).empty() == family.is_valid) {
      std::cout << "family " << family.name << '\n';
    }
  }
  for (const Invariant& invariant : all_invariants()) {
    std::cout << "invariant " << invariant.name << '\n';
  }
  for (const Feature& feature : all_features()) {
    std::cout << "feature " << feature.name << '\n';
  }
}
