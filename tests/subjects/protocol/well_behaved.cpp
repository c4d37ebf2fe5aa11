// SPDX-License-Identifier: BSL-1.0
// Serves the built-in subject that the first argument names. The second argument may be `hex`, for hexadecimal numbers.
#include <iostream>
#include <string_view>

#include <carom/subjects/catalogue.hpp>
#include <carom/subjects/protocol/serve.hpp>

int main(int argc, char** argv) {
  std::ios::sync_with_stdio(false);
  const auto subject = carom::subjects::subject_named(argc > 1 ? argv[1] : "frictionless-double");
  using carom::subjects::protocol::Numbers;
  const Numbers numbers = argc > 2 && std::string_view(argv[2]) == "hex" ? Numbers::hex : Numbers::decimal;
  return subject ? carom::subjects::protocol::serve(*subject, std::cin, std::cout, numbers) : 2;
}
