// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <span>
#include <string_view>
#include <vector>

#include <carom/collision/collision.hpp>
#include <carom/properties/draws/stream.hpp>

namespace carom::properties {

/// Colliding contacts with one quantity set to 10^k, for k from `first_exponent` to `last_exponent`. A sweep shows the
/// value from which on a method violates an invariant.
struct Sweep {
  std::string_view name;
  std::string_view quantity;  // the label of an axis
  std::string_view summary;
  int first_exponent;  // of the easy end
  int last_exponent;   // of the hard end; may be the smaller exponent
  Collision (*draw)(Stream&, double quantity);

  /// 10^k, from the easy end to the hard end.
  [[nodiscard]] std::vector<double> quantities() const;

  /// A collision at this quantity, with friction from `set_friction`.
  [[nodiscard]] Collision generate(Stream& stream, double at_quantity) const;
};

[[nodiscard]] std::span<const Sweep> all_sweeps();

}  // namespace carom::properties
