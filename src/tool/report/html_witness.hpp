// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <filesystem>

#include <pugixml.hpp>

#include "report/records.hpp"

namespace carom::tool {

/// Appends every witness, subject by subject, those that count first. `out_directory` is where the reports are written.
void add_witnesses(pugi::xml_node section, const GateRun& run, const std::filesystem::path& out_directory);

}  // namespace carom::tool
