// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <string>

#include <carom/collision/subject.hpp>

#include "defect.hpp"

namespace carom::mutants {

/// One solver for the laws, in binary64, with one planted defect. With Defect::none it is sound.
[[nodiscard]] Subject make_subject(std::string name, Law law, Defect defect);

}  // namespace carom::mutants
