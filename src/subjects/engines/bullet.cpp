// SPDX-License-Identifier: BSL-1.0
#include <type_traits>

#include <carom/subjects/engines/bullet_contact.hpp>
#include <carom/subjects/engines/claims.hpp>
#include <carom/subjects/engines/engines.hpp>

namespace carom::subjects {

static_assert(std::is_same_v<btScalar, double>, "needs the double build of Bullet, bullet-float64");

std::vector<Subject> bullet_subjects() {
  std::vector<Subject> subjects = bullet_claims();
  for (Subject& subject : subjects) {
    subject.version = std::to_string(btGetVersion() / 100) + '.' + std::to_string(btGetVersion() % 100);
  }
  subjects[0].open = [] { return bullet::session_with(bullet::configured()); };
  subjects[1].open = [] { return bullet::session_with({}); };
  return subjects;
}

}  // namespace carom::subjects
