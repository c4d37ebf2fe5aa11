// SPDX-License-Identifier: BSL-1.0
#include <vector>

#include <carom/collision/json/json.hpp>
#include <carom/collision/law.hpp>
#include <carom/properties/cases/domain.hpp>
#include <carom/properties/cases/family.hpp>
#include <carom/properties/features/feature.hpp>
#include <carom/properties/invariants/invariant.hpp>
#include <carom/report/results/lists.hpp>

namespace carom::report {
namespace {

using nlohmann::json;

json names_of(const std::vector<Law>& laws) {
  json names = json::array();
  for (const Law law : laws) {
    names.push_back(name_of(law));
  }
  return names;
}

}  // namespace

json invariants_list() {
  json list = json::array();
  for (const properties::Invariant& invariant : properties::all_invariants()) {
    list.push_back({{"name", invariant.name},
                    {"statement", invariant.statement},
                    {"formula", invariant.formula},
                    {"source", invariant.source},
                    {"domain", invariant.applies_to},
                    {"models", names_of(invariant.laws)},
                    {"proved_models", names_of(invariant.proved_laws())},
                    {"theorems", json::array()}});
    for (const properties::Theorem& theorem : invariant.proof.theorems) {
      list.back()["theorems"].push_back({{"name", theorem.name}, {"file", theorem.file}});
    }
  }
  return list;
}

json features_list() {
  json list = json::array();
  for (const properties::Feature& feature : properties::all_features()) {
    list.push_back({{"name", feature.name},
                    {"kind", name_of(feature.kind)},
                    {"statement", feature.statement},
                    {"why", feature.why}});
  }
  return list;
}

json families_list(std::uint64_t seed) {
  json list = json::array();
  for (const auto kind : {properties::all_families(), properties::families_beyond_domain()}) {
    for (const properties::Family& family : kind) {
      list.push_back({{"name", family.name},
                      {"summary", family.summary},
                      {"beyond_domain", family.is_beyond_domain()},
                      {"example", collision_to_json(properties::drawn_case(family, seed, 0).collision)}});
    }
  }
  return list;
}

json domains_list() {
  json list = json::array();
  for (const properties::NamedDomain& domain : properties::named_domains()) {
    list.push_back({{"name", domain.name}, {"summary", domain.summary}, {"ranges", domain.ranges}});
  }
  return list;
}

}  // namespace carom::report
