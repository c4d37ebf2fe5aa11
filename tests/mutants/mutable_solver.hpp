// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <string>

#include <carom/collision/subject.hpp>

#include "defect.hpp"

namespace carom::mutants {

/// One solver text for the models `frictionless` and `reflection`, in binary64, with one defect planted. With
/// Defect::none it is sound: what a mutant fails, it fails by its defect.
[[nodiscard]] Subject make_subject(std::string name, Model model, Defect defect);

}  // namespace carom::mutants
