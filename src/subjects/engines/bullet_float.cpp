// SPDX-License-Identifier: BSL-1.0
// Bullet's float build as a program that speaks the protocol: carom-bullet-float [configured|as-shipped].
#include <iostream>
#include <string_view>
#include <type_traits>

#include <carom/subjects/engines/bullet_contact.hpp>
#include <carom/subjects/protocol/serve.hpp>

static_assert(std::is_same_v<btScalar, float>, "needs the float build of Bullet, bullet");

int main(int argc, char** argv) {
  const std::string_view settings = argc > 1 ? argv[1] : "configured";
  if (argc > 2 || (settings != "configured" && settings != "as-shipped")) {
    std::cerr << "carom-bullet-float [configured|as-shipped]\n";
    return 2;
  }
  std::ios::sync_with_stdio(false);
  carom::Subject subject;
  subject.name = "bullet-float";
  subject.version = std::to_string(btGetVersion() / 100) + '.' + std::to_string(btGetVersion() % 100);
  subject.model = carom::Model::frictionless;
  subject.precision = carom::Precision::binary32;
  subject.open = [is_configured = settings == "configured"] {
    namespace bullet = carom::subjects::bullet;
    return bullet::session_with(is_configured ? bullet::configured() : bullet::Settings{});
  };
  return carom::subjects::protocol::serve(subject, std::cin, std::cout);
}
