// SPDX-License-Identifier: BSL-1.0
#include <type_traits>

#include <carom/subjects/engines.hpp>
#include <carom/subjects/engines/bullet_contact.hpp>
#include <carom/subjects/engines/claims.hpp>

namespace carom::subjects {

static_assert(std::is_same_v<btScalar, double>, "needs the double build of Bullet, bullet-float64");

std::vector<Subject> bullet_subjects() {
  std::vector<Subject> subjects = bullet_claims();
  for (std::size_t i = 0; i < subjects.size(); ++i) {
    subjects[i].version = bullet::version();
    subjects[i].open = [settings = bullet::settings_of(engine_settings[i])] { return bullet::session_with(settings); };
  }
  return subjects;
}

}  // namespace carom::subjects
