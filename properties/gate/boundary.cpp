// SPDX-License-Identifier: BSL-1.0
#include <algorithm>
#include <utility>

#include <carom/properties/gate/boundary.hpp>

namespace carom::properties {

void keep_if_least(std::optional<Boundary>& kept, const std::optional<Boundary>& other) {
  const auto place = [](const Boundary& boundary) { return std::pair(boundary.quantity, boundary.index); };
  if (other && (!kept || place(*other) < place(*kept))) {
    kept = other;
  }
}

std::optional<Boundary> boundary_by(const Family& family, std::uint64_t index, const Collision& collision,
                                    const Judgement& judgement) {
  const auto violated =
      std::find_if(judgement.verdicts.begin(), judgement.verdicts.end(),
                   [](const NamedVerdict& named) { return named.verdict.status == Status::violated; });
  if (!family.is_beyond_domain() || violated == judgement.verdicts.end()) {
    return std::nullopt;
  }
  return Boundary{family.beyond.of(collision), index, violated->invariant};
}

}  // namespace carom::properties
