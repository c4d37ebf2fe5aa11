// SPDX-License-Identifier: BSL-1.0
#undef CAROM_CHECK_PRECONDITIONS
#define CAROM_CHECK_PRECONDITIONS 0

#include <carom/collision/expects.hpp>

namespace carom::unit {

int evaluations_of_an_unchecked_precondition() {
  int evaluations = 0;
  const auto is_false = [&] { return ++evaluations == 0; };
  CAROM_EXPECTS(is_false(), is_false());
  return evaluations;
}

}  // namespace carom::unit
