// SPDX-License-Identifier: BSL-1.0
#include "same_cases.hpp"

#include <bit>
#include <cmath>
#include <limits>
#include <sstream>

#include <carom/properties/cases/body_pairs.hpp>
#include <carom/properties/cases/family.hpp>
#include <carom/properties/cases/sweep.hpp>
#include <carom/properties/features/coverage.hpp>
#include <carom/properties/features/feature.hpp>

namespace carom::properties {
namespace {

/// FNV-1a of 64 bits (G. Fowler, L. Noll, K. Vo), from the lowest byte of each word.
class Fnv1a {
 public:
  void add(std::uint64_t word) {
    for (int byte = 0; byte < 8; ++byte) {
      hash_ = (hash_ ^ ((word >> (8 * byte)) & 0xffU)) * 0x100000001b3U;
    }
  }
  /// Any NaN counts as the same number.
  void add(double number) {
    add(std::bit_cast<std::uint64_t>(std::isnan(number) ? std::numeric_limits<double>::quiet_NaN() : number));
  }
  void add(const Collision& collision) {
    add(std::uint64_t{(collision.a.immovable ? 1U : 0U) + (collision.b.immovable ? 2U : 0U)});
    for_each_number([&](const FieldPath&, const double& number) { add(number); }, collision);
  }
  [[nodiscard]] std::uint64_t value() const { return hash_; }

 private:
  std::uint64_t hash_ = 0xcbf29ce484222325U;
};

std::uint64_t of_family(const Family& family, std::uint64_t seed, std::uint64_t count) {
  Fnv1a hash;
  for (std::uint64_t i = 0; i < count; ++i) {
    const Case one = drawn_case(family, seed, i);
    hash.add(one.collision);
    hash.add(std::uint64_t{one.convex_uniform ? 1U : 0U});
  }
  return hash.value();
}

std::uint64_t of_sweep(const Sweep& sweep, std::uint64_t seed, std::uint64_t count) {
  Fnv1a hash;
  for (const double quantity : sweep.quantities()) {
    for (std::uint64_t i = 0; i < count; ++i) {
      Stream stream = case_stream(seed, sweep.name, i);
      hash.add(sweep.generate(stream, quantity));
    }
  }
  return hash.value();
}

std::uint64_t of_features(std::uint64_t seed, std::uint64_t count) {
  Fnv1a hash;
  for (const Feature& feature : all_features()) {
    for (std::uint64_t i = 0; i < count; ++i) {
      Stream stream = case_stream(seed, feature.name, i);
      Collision collision = general_bodies(stream).collision;
      feature.make(stream, collision);
      hash.add(collision);
      for (const std::uint16_t place : feature_places_of(collision)) {
        hash.add(std::uint64_t{place});
      }
    }
  }
  return hash.value();
}

}  // namespace

std::vector<Checksum> checksums(std::uint64_t seed, std::uint64_t count) {
  const std::uint64_t few = count / 20;
  std::vector<Checksum> all;
  for (const auto kind : {all_families(), families_beyond_domain()}) {
    for (const Family& family : kind) {
      all.push_back({std::string(family.name), of_family(family, seed, count)});
    }
  }
  for (const Sweep& sweep : all_sweeps()) {
    all.push_back({"sweep " + std::string(sweep.name), of_sweep(sweep, seed, few)});
  }
  all.push_back({"features", of_features(seed, few)});
  return all;
}

std::string line_of(const Checksum& checksum) {
  std::ostringstream line;
  line << checksum.name << ' ' << std::hex;
  line.width(16);
  line.fill('0');
  line << checksum.value;
  return line.str();
}

}  // namespace carom::properties
