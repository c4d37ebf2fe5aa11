// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <array>
#include <string_view>

#include <carom/collision/enum_array.hpp>

namespace carom::report {

/// The state of a subject after a run.
enum class SubjectStatus {
  sound,
  violated,    // it violates an invariant
  error,       // it was not judged to the end, and violates none
  not_judged,  // it got too few cases
  absent,      // it is not installed
};
inline constexpr std::array all_subject_statuses{SubjectStatus::sound, SubjectStatus::violated, SubjectStatus::error,
                                                 SubjectStatus::not_judged, SubjectStatus::absent};
static_assert(counts_from_zero_to(all_subject_statuses, SubjectStatus::absent));

[[nodiscard]] constexpr std::string_view name_of(SubjectStatus status) {
  constexpr EnumArray<SubjectStatus, std::string_view, all_subject_statuses.size()> names{"sound", "violated", "error",
                                                                                          "not judged", "absent"};
  return names[status];
}

}  // namespace carom::report
