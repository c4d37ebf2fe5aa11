// SPDX-License-Identifier: BSL-1.0
#include "known_values.hpp"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <sstream>

#include <fmt/format.h>
#include <gtest/gtest.h>

namespace carom::unit {
namespace {

/// Reads lines such as "name: 1 2.5 inf".
std::vector<KnownLine> read(const std::string& file) {
  std::vector<KnownLine> lines;
  std::ifstream stream(file);
  for (std::string text; std::getline(stream, text);) {
    const std::size_t colon = text.find(':');
    KnownLine line{text.substr(0, colon), {}};
    std::istringstream numbers(colon == std::string::npos ? "" : text.substr(colon + 1));
    for (std::string number; numbers >> number;) {
      line.numbers.push_back(std::stod(number));
    }
    lines.push_back(std::move(line));
  }
  return lines;
}

std::string text_of(const KnownLine& line) {
  std::string text = line.name + ":";
  for (const double number : line.numbers) {
    text += fmt::format(" {:.7g}", number);
  }
  return text;
}

bool agree(double x, double y) {
  constexpr double five_digits = 1e-5;
  return x == y || (std::isnan(x) && std::isnan(y)) ||
         std::abs(x - y) <= five_digits * std::max(std::abs(x), std::abs(y));
}

bool agree(const KnownLine& x, const KnownLine& y) {
  return x.name == y.name && std::equal(x.numbers.begin(), x.numbers.end(), y.numbers.begin(), y.numbers.end(),
                                        [](double a, double b) { return agree(a, b); });
}

}  // namespace

void expect_known_lines(const std::string& file, const std::vector<KnownLine>& lines) {
  const std::vector<KnownLine> known = read(file);
  if (std::equal(known.begin(), known.end(), lines.begin(), lines.end(),
                 [](const KnownLine& x, const KnownLine& y) { return agree(x, y); })) {
    return;
  }
  const std::string now = testing::TempDir() + std::filesystem::path(file).filename().string();
  std::ofstream stream(now);
  for (const KnownLine& line : lines) {
    stream << text_of(line) << '\n';
  }
  for (std::size_t i = 0; i < std::min(known.size(), lines.size()); ++i) {
    EXPECT_TRUE(agree(known[i], lines[i])) << text_of(known[i]) << "\nis now\n" << text_of(lines[i]);
  }
  ADD_FAILURE() << known.size() << " lines in " << file << "; " << lines.size() << " now, in " << now;
}

}  // namespace carom::unit
