// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <string>
#include <vector>

#include <carom/collision/subject.hpp>

#include "defect.hpp"

namespace carom::mutants {

/// One solver for the laws, in binary64, with the planted defects. With none it is sound.
[[nodiscard]] Subject make_subject(std::string name, Law law, std::vector<Defect> defects);

}  // namespace carom::mutants
