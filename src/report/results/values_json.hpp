// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>

#include <carom/collision/declared_effects.hpp>
#include <carom/collision/enum_array.hpp>
#include <carom/oracles/judge/coulomb_answers.hpp>
#include <carom/properties/cases/domain.hpp>
#include <carom/properties/gate/declared_effects.hpp>
#include <carom/properties/gate/gate_report.hpp>
#include <carom/report/results/archive.hpp>

/// Answers, truths, verdicts, domains and declared effects as JSON.
namespace carom::report {

/// An outcome is written as numbers. A number that binary64 cannot represent is a string with 21 digits. Any other
/// answer is {"refused": why}, {"skipped": why} or {"failed": why, "said": …}.
template <>
struct Json<Answer> {
  static nlohmann::json write(const Answer& answer);
  static Answer read(const Field& field);
};

/// "holds", "violated" or "skipped". A violation has both sides of the formula. `read` takes only violations.
template <>
struct Json<properties::Verdict> {
  static nlohmann::json write(const properties::Verdict& verdict);
  static properties::Verdict read(const Field& field);
};

template <>
struct Json<oracles::Limits> {
  static nlohmann::json write(const oracles::Limits& limits);
  static oracles::Limits read(const Field& field);
};

/// A count for each enumerator, by its name.
template <class Enum, std::size_t count>
struct Json<EnumArray<Enum, std::uint64_t, count>> {
  using Counts = EnumArray<Enum, std::uint64_t, count>;

  static nlohmann::json write(const Counts& counts) {
    nlohmann::json record = nlohmann::json::object();
    for (std::size_t i = 0; i < count; ++i) {
      record[std::string(name_of(static_cast<Enum>(i)))] = counts.values[i];
    }
    return record;
  }
  static Counts read(const Field& field) {
    Counts counts{};
    for (std::size_t i = 0; i < count; ++i) {
      counts.values[i] = field.at(std::string(name_of(static_cast<Enum>(i)))).count();
    }
    return counts;
  }
};

/// Throws FormatError at the place if there is no such invariant.
[[nodiscard]] const properties::Invariant& invariant_at(const std::string& name, const Field& place);

/// An invariant or a family is written as its name.
template <>
struct Json<const properties::Invariant*> {
  static nlohmann::json write(const properties::Invariant* invariant) { return invariant->name; }
  static const properties::Invariant* read(const Field& field) { return &invariant_at(field.text(), field); }
};
template <>
struct Json<const properties::Family*> {
  static nlohmann::json write(const properties::Family* family) { return family->name; }
  static const properties::Family* read(const Field& field);
};

template <class T>
struct Json<properties::PerInvariant<T>> {
  static nlohmann::json write(const properties::PerInvariant<T>& values) {
    nlohmann::json record = nlohmann::json::object();
    for (const auto& [invariant, value] : values) {
      record[std::string(invariant->name)] = Json<T>::write(value);
    }
    return record;
  }
  static properties::PerInvariant<T> read(const Field& field) {
    properties::PerInvariant<T> values;
    for (const auto& [name, value] : field.members()) {
      values.emplace(&invariant_at(name, value), Json<T>::read(value));
    }
    return values;
  }
};

/// The exact outcome under one law: velocities and impulse as strings "p/q", and the velocities as binary64 under
/// `nearest`.
[[nodiscard]] nlohmann::json truth_record(const oracles::ExactCase& exact_case, Law law);

/// All answers of the law `coulomb`: the kind of each, whether it is exact, and its velocities as binary64 under
/// `nearest`. An exact answer also has the other fields of truth_record.
[[nodiscard]] nlohmann::json answers_record(std::span<const oracles::CoulombAnswer> answers);

/// {"size": [0.1, 10], "mass_ratio": [null, 100], "plane": "xy"}: the least and the greatest value of each limited
/// quantity, with null for an end without a limit, and the limited kinds. `read` throws FormatError that names the
/// place.
template <>
struct Json<properties::Domain> {
  static nlohmann::json write(const properties::Domain& domain);
  static properties::Domain read(const Field& field);
};

/// {"restitution_threshold": 0.5}: the size of each declared effect. `read` throws FormatError that names the place.
template <>
struct Json<DeclaredEffects> {
  static nlohmann::json write(const DeclaredEffects& effects);
  static DeclaredEffects read(const Field& field);
};

/// {"restitution_threshold": 12}: the number of cases that each effect decides, if it is not 0.
template <>
struct Json<properties::EffectCounts> {
  static nlohmann::json write(const properties::EffectCounts& counts);
  static properties::EffectCounts read(const Field& field);
};

}  // namespace carom::report
