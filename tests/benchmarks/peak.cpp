// SPDX-License-Identifier: BSL-1.0
// The build compiles this file once for each instruction set, named by CAROM_INSTRUCTION_SET.
#include <experimental/simd>

namespace carom::benchmarks::CAROM_INSTRUCTION_SET {

[[gnu::flatten]] std::size_t multiply_and_add(double* sink) {
  using Pack = std::experimental::native_simd<double>;
  // The steps of a chain depend on each other. Twelve chains fill two pipelines with a latency of four cycles, and
  // leave registers for `factor` and `addend`.
  constexpr std::size_t chains = 12;
  constexpr std::size_t rounds = 1000;
  Pack x[chains];
  for (std::size_t k = 0; k < chains; ++k) {
    x[k] = Pack(1.0 + static_cast<double>(k));
  }
  const Pack factor = sink[0];  // read at run time, unknown to the compiler
  const Pack addend = sink[1];
  for (std::size_t i = 0; i < rounds; ++i) {
#pragma GCC unroll 12
    for (std::size_t k = 0; k < chains; ++k) {
      x[k] = x[k] * factor + addend;
    }
  }
  Pack sum = x[0];
  for (std::size_t k = 1; k < chains; ++k) {
    sum += x[k];
  }
  sink[2] = sum[0];
  return 2 * Pack::size() * chains * rounds;
}

}  // namespace carom::benchmarks::CAROM_INSTRUCTION_SET
