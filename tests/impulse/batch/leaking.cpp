// SPDX-License-Identifier: BSL-1.0
// isolation.cmake must find this: an inline function of the standard library compiled in this unit.
#include <algorithm>

namespace carom::impulse::avx2 {
int leaking(int x, int y) { return std::min(x, y); }
}  // namespace carom::impulse::avx2
