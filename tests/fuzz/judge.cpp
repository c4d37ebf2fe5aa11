// SPDX-License-Identifier: BSL-1.0
// The first byte selects the yardstick. The second byte selects whether numbers keep all digits, and whether the target
// judges relations. Then the case follows, and then the claim and answers of a made-up solver.
#include <cmath>
#include <span>

#include <carom/collision/json/json.hpp>

#include "agreement.hpp"
#include "case_bytes.hpp"
#include "made_up_answers.hpp"
#include "target.hpp"
#include "wild.hpp"

namespace carom::fuzz {
namespace {

/// Whether all finite numbers are 0 or from 2⁻¹⁰⁰ to 2¹⁰⁰ in size. On other numbers, rational arithmetic takes seconds.
bool is_quick_to_judge(const Collision& collision) {
  constexpr double largest = 0x1p+100;
  bool quick = true;
  for_each_number(
      [&](const FieldPath&, const double& number) {
        const double size = std::abs(number);
        quick = quick && (!std::isfinite(size) || size == 0 || (size <= largest && size >= 1 / largest));
      },
      collision);
  return quick;
}

void compare_judges(Bytes bytes) {
  Input input(bytes);
  equality::Agreement agreement;
  agreement.cases = input.byte();  // selects how the yardstick is drawn
  const std::uint8_t choices = input.byte();
  properties::Case one = case_from(input).one;
  if (!is_quick_to_judge(one.collision)) {
    return;
  }
  equality::Examined examined(made_up_subject(input));
  // Judging is slow with all digits, or with relations. So one input in four keeps all digits, and one in four has
  // relations.
  if (choices % 4 != 0) {
    properties::Stream stream = input.stream();
    one = equality::shortened(one, stream);
  }
  const auto relations = choices / 4 % 4 == 0 ? equality::Relations::judged : equality::Relations::left_out;
  equality::compare_judges(one, std::span(&examined, 1), relations, "the judges differ", agreement);
  if (!agreement.differences.empty()) {
    fail(agreement.differences + collision_to_json(one.collision).dump());
  }
}

}  // namespace
}  // namespace carom::fuzz

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  carom::fuzz::compare_judges({data, size});
  return 0;
}
