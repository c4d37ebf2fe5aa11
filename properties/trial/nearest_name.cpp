// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cstddef>
#include <limits>
#include <numeric>

#include <carom/properties/trial/nearest_name.hpp>

namespace carom::properties {
namespace {

/// Levenshtein's distance.
std::size_t distance(std::string_view x, std::string_view y) {
  std::vector<std::size_t> row(y.size() + 1);  // of what of x was read, to each beginning of y
  std::iota(row.begin(), row.end(), std::size_t{0});
  for (const char letter : x) {
    std::size_t diagonal = row[0]++;
    for (std::size_t j = 0; j < y.size(); ++j) {
      const std::size_t replaced = diagonal + (letter == y[j] ? 0 : 1);
      diagonal = row[j + 1];
      row[j + 1] = std::min({replaced, row[j] + 1, row[j + 1] + 1});
    }
  }
  return row.back();
}

}  // namespace

std::string nearest_name(std::string_view word, const std::vector<std::string>& names) {
  std::string nearest;
  std::size_t least = std::numeric_limits<std::size_t>::max();
  for (const std::string& name : names) {
    if (const std::size_t apart = distance(word, name); apart < least) {
      least = apart;
      nearest = name;
    }
  }
  return nearest;
}

}  // namespace carom::properties
