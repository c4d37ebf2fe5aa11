// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <cstddef>

#include <carom/impulse/batch/contact_arrays.hpp>

namespace carom::impulse {

/// Pointers to the beginnings of the arrays, in the order of for_each_array. Units of different instruction sets share
/// this type.
template <class S>
struct PackTask {
  const S* contacts[contact_number_count];
  S* outcomes[outcome_number_count];
  std::size_t count;
};

}  // namespace carom::impulse
