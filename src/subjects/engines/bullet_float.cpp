// SPDX-License-Identifier: BSL-1.0
// Bullet's float build as a program that speaks the protocol:
//   carom-bullet-float configured|as-shipped frictionless|coulomb
#include <iostream>
#include <string>
#include <type_traits>
#include <vector>

#include <carom/subjects/engines/bullet_contact.hpp>
#include <carom/subjects/engines/claims.hpp>
#include <carom/subjects/protocol/serve.hpp>

static_assert(std::is_same_v<btScalar, float>, "needs the float build of Bullet, bullet");

namespace {

int serve(const carom::subjects::EngineSetting& setting) {
  namespace bullet = carom::subjects::bullet;
  std::ios::sync_with_stdio(false);
  carom::Subject subject;
  subject.name = "bullet-float";
  subject.version = bullet::version();
  subject.law = setting.law;
  subject.precision = carom::Precision::binary32;
  subject.effects = setting.configured ? carom::DeclaredEffects{} : carom::subjects::bullet_as_shipped();
  subject.open = [&setting] { return bullet::session_with(bullet::settings_of(setting)); };
  return carom::subjects::protocol::serve(subject, std::cin, std::cout);
}

}  // namespace

int main(int argc, char** argv) {
  const std::vector<std::string> words(argv + 1, argv + argc);
  for (const carom::subjects::EngineSetting& setting : carom::subjects::engine_settings) {
    if (words == setting.words()) {
      return serve(setting);
    }
  }
  std::cerr << "carom-bullet-float configured|as-shipped frictionless|coulomb\n";
  return 2;
}
