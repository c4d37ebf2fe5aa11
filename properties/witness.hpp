// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include <carom/properties/gate.hpp>

/// Violations that can be replayed.
namespace carom::properties {

/// The worst violation of the invariant, as it was found. Precondition: the subject violated it.
[[nodiscard]] Witness found_witness(const SubjectResult& result, const GateOptions& options,
                                    const std::string& invariant);

/// The same on the simplest collision that can be found, worked out in exact arithmetic, the truth certified. Throws
/// what the subject's session throws.
[[nodiscard]] Witness shrunk_witness(const Subject& subject, const Claim& claim, Witness witness);

}  // namespace carom::properties
