// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <pugixml.hpp>

#include "report/records.hpp"

/// What leads from a subject's violations to what may be wrong with it.
namespace carom::tool {

/// What is wrong with each subject that violates something: those that count, the others folded away.
void add_diagnoses(pugi::xml_node section, const GateRun& run);

/// Of each subject that counts and violates something: which invariants in which families, and with which features.
void add_violation_matrices(pugi::xml_node section, const GateRun& run);

}  // namespace carom::tool
