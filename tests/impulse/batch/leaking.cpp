// SPDX-License-Identifier: BSL-1.0
// isolation.cmake must report std::min, an inline function of the standard library.
#include <algorithm>

namespace carom::impulse::avx2 {
int leaking(int x, int y) { return std::min(x, y); }
}  // namespace carom::impulse::avx2
