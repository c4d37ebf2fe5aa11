// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <carom/scene/exact_time.hpp>
#include <carom/scene/motion.hpp>

namespace carom::scene {

/// Where a path is at a time, rounded to double, each coordinate the way that `away` points along it, and to nearest
/// where that is 0. So two spheres that are rounded away from each other are no nearer than their paths say.
[[nodiscard]] Vector3<double> rounded_away(const Path& path, double time, const Vector3<double>& away);

/// Whether two spheres overlap at a time, exactly: by bounds, and exactly where those do not decide, which is counted.
[[nodiscard]] bool overlap(const Path& a, const Path& b, double time, unsigned long long& undecided);
[[nodiscard]] bool overlap(const Path& sphere, const Reach& plane, double time, unsigned long long& undecided);

/// The same position, moved by some ulps of its coordinates: the k-th of all moves, the least first. Calls with k from
/// 0 to `moves` − 1; the 0th is the position itself.
inline constexpr int moves = 7 * 7 * 7;
[[nodiscard]] Vector3<double> moved_by_ulps(const Vector3<double>& position, int k);

}  // namespace carom::scene
