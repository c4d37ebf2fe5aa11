// SPDX-License-Identifier: BSL-1.0
#include "law.hpp"
#include "target.hpp"

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  carom::fuzz::judge_law({data, size}, carom::Law::reflection);
  return 0;
}
