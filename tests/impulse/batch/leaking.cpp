// SPDX-License-Identifier: BSL-1.0
// What isolation.cmake is there to find: an inline function of the standard library compiled in this unit.
#include <algorithm>

namespace carom::impulse::avx2 {
int leaking(int x, int y) { return std::min(x, y); }
}  // namespace carom::impulse::avx2
