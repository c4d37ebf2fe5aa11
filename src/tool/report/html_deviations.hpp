// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <pugixml.hpp>

#include "report/records.hpp"

namespace carom::tool {

/// What each subject does not claim, and who said so; nothing where all claim everything.
void add_deviations(pugi::xml_node section, const GateRun& run);

}  // namespace carom::tool
