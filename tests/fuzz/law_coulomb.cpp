// SPDX-License-Identifier: GPL-3.0-or-later
#include "law.hpp"
#include "target.hpp"

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  carom::fuzz::judge_law({data, size}, carom::Model::coulomb);
  return 0;
}
