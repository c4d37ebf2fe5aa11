// SPDX-License-Identifier: BSL-1.0
// Serves the built-in subject that the first argument names.
#include <iostream>

#include <carom/subjects/catalogue.hpp>
#include <carom/subjects/protocol/serve.hpp>

int main(int argc, char** argv) {
  std::ios::sync_with_stdio(false);
  const auto subject = carom::subjects::subject_named(argc > 1 ? argv[1] : "frictionless-double");
  return subject ? carom::subjects::protocol::serve(*subject, std::cin, std::cout) : 2;
}
