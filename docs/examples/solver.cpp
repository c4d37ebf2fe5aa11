// SPDX-License-Identifier: BSL-1.0
// A C++ solver as a program that speaks Carom's line protocol. carom::protocol reads and writes the lines.
#include <iostream>

#include <carom/impulse/contact.hpp>
#include <carom/subjects/protocol/serve.hpp>
#include <carom/subjects/session.hpp>

namespace {

using carom::Vector3;
using carom::impulse::ContactBody;

Vector3<double> velocity_at_contact(const ContactBody<double>& body) {
  return body.velocity + body.angular_velocity.cross(body.lever_arm);
}

carom::BodyVelocity<double> pushed(const ContactBody<double>& body, const Vector3<double>& impulse) {
  return {body.velocity + body.inverse_mass * impulse,
          body.angular_velocity + angular_response(body.inertia, body.lever_arm, impulse)};
}

/// The part of one body in N·K N, with K the collision matrix [1/kg]. Precondition: N has length 1.
double inverse_effective_mass(const ContactBody<double>& body, const Vector3<double>& normal) {
  return body.inverse_mass + angular_part_along(body.inertia, body.lever_arm, normal);
}

/// The solver under test. Replace it with yours.
carom::Outcome<double> respond(const carom::impulse::Contact<double>& contact) {
  const Vector3<double> normal = contact.normal.normalized();
  const double approach = normal.dot(velocity_at_contact(contact.a) - velocity_at_contact(contact.b));
  const double inertness = inverse_effective_mass(contact.a, normal) + inverse_effective_mass(contact.b, normal);
  const bool acts = approach < 0 && inertness > 0;
  const Vector3<double> impulse = normal * (acts ? -(1 + contact.restitution) * approach / inertness : 0.0);
  return {pushed(contact.a, impulse), pushed(contact.b, -impulse)};
}

}  // namespace

int main() {
  std::ios::sync_with_stdio(false);
  carom::Subject subject;
  subject.name = "example-cpp";
  subject.law = carom::Law::frictionless;
  subject.open = [] {
    return carom::subjects::session_of([](const carom::Collision& collision) -> carom::Answer {
      return carom::map_outcome<long double>(respond(carom::impulse::make_contact<double>(collision)),
                                             [](double x) { return x; });
    });
  };
  return carom::subjects::protocol::serve(subject, std::cin, std::cout);
}
