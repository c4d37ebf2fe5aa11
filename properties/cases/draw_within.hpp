// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <cstdint>
#include <optional>

#include <carom/properties/cases/domain.hpp>
#include <carom/properties/cases/family.hpp>

/// Draws cases of a family into a domain. If a case lies outside of the kinds, `put_into` changes it. If it lies
/// outside of the ranges, its masses, sizes and speeds are multiplied until it lies inside. The factors are powers of
/// two if the range permits this. So most vectors that are zero, parallel or along an axis keep these properties. A
/// case that cannot be changed is drawn again.
namespace carom::properties {

/// Changes a case so that the domain contains it, and returns whether it does. Leaves the quantity `keeps` as it is. An
/// invalid case, or a case within the domain, stays as it is and takes nothing from the stream.
[[nodiscard]] bool fit_into(const Domain& domain, std::optional<LimitedQuantity> keeps, Stream& stream, Case& one);

/// Draws a case of the family into the domain, and returns whether it fits. The bodies are put into the kinds of the
/// domain before the family gives them what it is about. A case that does not fit stays as it was drawn.
[[nodiscard]] bool draw_into(const Domain& domain, const Family& family, Stream& stream, Case& one);

/// A case of the family within the domain. None if 64 draws in a row do not fit.
[[nodiscard]] std::optional<Case> drawn_within(const Domain& domain, const Family& family, Stream& stream);

/// The family's case with the number `index` within the domain; `drawn_case` if the domain is everything. If 64 draws
/// of the family do not fit, the case is one of `generic` within the domain. If there is none either, it is the first
/// case of the family that fits. Throws std::invalid_argument unless `has_cases_within` holds.
[[nodiscard]] Case drawn_case_within(const Domain& domain, const Family& family, std::uint64_t seed,
                                     std::uint64_t index);

/// Whether a draw of the family with one of the first eight numbers fits into the domain.
[[nodiscard]] bool has_cases_within(const Domain& domain, const Family& family, std::uint64_t seed);

}  // namespace carom::properties
