// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <memory>
#include <new>
#include <stdexcept>
#include <string>
#include <utility>

#include <carom/collision/collision.hpp>

namespace carom::oracles {

/// A fault of the judge on a collision. It is no verdict on a subject (solver under test), and ends a run.
class JudgeError : public std::logic_error {
 public:
  JudgeError(const std::string& what, Collision collision)
      : std::logic_error(what), collision_(std::make_shared<const Collision>(std::move(collision))) {}

  [[nodiscard]] const Collision& collision() const { return *collision_; }

 private:
  std::shared_ptr<const Collision> collision_;  // shared, so that copying the exception cannot throw
};

/// judge(), which calls no subject. Any exception but a lack of memory is a fault of the judge, and names the
/// collision.
template <class Judge>
auto on_collision(const Collision& collision, const Judge& judge) {
  try {
    return judge();
  } catch (const JudgeError&) {
    throw;
  } catch (const std::bad_alloc&) {
    throw;
  } catch (const std::exception& error) {
    throw JudgeError(error.what(), collision);
  }
}

}  // namespace carom::oracles
