// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <carom/scene/arc.hpp>
#include <carom/scene/exact_time.hpp>

namespace carom::scene {

/// The position of a path at a time. Each coordinate is rounded up if that of `away` is positive, down if negative, and
/// to nearest if 0. So two spheres rounded away from each other are no nearer than on their paths.
[[nodiscard]] Vector3<double> rounded_away(const Path& path, double time, const Vector3<double>& away);

/// Decides exactly whether two spheres, or a sphere and a plane, overlap at a time. Adds 1 to `undecided` if the
/// decision needs exact arithmetic.
[[nodiscard]] bool overlap(const Path& a, const Path& b, double time, unsigned long long& undecided);
[[nodiscard]] bool overlap(const Path& sphere, const Reach& plane, double time, unsigned long long& undecided);

/// A position with each coordinate moved by at most 3 ulps. The moves k from 0 to `moves` − 1 are in order of length,
/// and move 0 changes nothing.
inline constexpr int moves = 7 * 7 * 7;
[[nodiscard]] Vector3<double> moved_by_ulps(const Vector3<double>& position, int k);

}  // namespace carom::scene
