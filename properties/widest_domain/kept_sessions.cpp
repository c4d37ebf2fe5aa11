// SPDX-License-Identifier: BSL-1.0
#include <cstddef>
#include <memory>
#include <utility>
#include <vector>

#include <carom/properties/widest_domain/kept_sessions.hpp>

namespace carom::properties {

KeptSessions::KeptSessions(const Subject& subject)
    : subject_(subject), open_(subject.open), idle_(std::make_shared<std::deque<std::shared_ptr<Kept>>>()) {
  subject_.open = [this] { return take(); };
}

Session KeptSessions::take() {
  constexpr std::size_t most_idle = 2;
  std::shared_ptr<Kept> kept;
  if (idle_->size() < most_idle) {
    kept = std::make_shared<Kept>(Kept{open_()});
  } else {
    kept = std::move(idle_->front());
    idle_->pop_front();
  }
  return {[kept](std::span<const Collision> collisions) {
            try {
              return kept->session(collisions);
            } catch (...) {
              kept->has_failed = true;
              throw;
            }
          },
          [kept, idle = idle_] {
            if (!kept->has_failed) {
              idle->push_back(kept);
            }
          }};
}

}  // namespace carom::properties
