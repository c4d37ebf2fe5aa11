// SPDX-License-Identifier: BSL-1.0
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <tuple>
#include <unordered_map>
#include <utility>

#include <fmt/format.h>

#include <carom/oracles/exact/rational.hpp>
#include <carom/properties/scenes/validity.hpp>

namespace carom::properties {
namespace {

using oracles::Rational;
using scene::Arc;
using scene::Path;

constexpr std::size_t most_shown = 100;

/// An arc through more cells than this is checked against all others.
constexpr long double most_cells = 10'000;

/// A part of an arc that stays within a few cells of a grid.
struct Piece {
  std::uint32_t sphere;
  const Path* path;
  double begin, end;
  std::array<std::int64_t, 3> least, greatest;  // the range of cells that its sphere touches
};

long double coordinate(const Path& path, int axis, double time) {
  const long double s = static_cast<long double>(time) - path.start;
  return path.position[axis] + s * (path.velocity[axis] + s * path.acceleration[axis] / 2);
}

long double speed(const Path& path, int axis, double time) {
  return path.velocity[axis] + (static_cast<long double>(time) - path.start) * path.acceleration[axis];
}

template <std::size_t N>
using Bernstein = std::array<Rational, N>;

/// Bernstein coefficients, from the power coefficients of a polynomial of s on [0, span].
template <std::size_t N>
Bernstein<N> bernstein(std::array<Rational, N> power, const Rational& span) {
  Rational scale(1);
  for (Rational& coefficient : power) {
    coefficient *= scale;
    scale *= span;
  }
  const auto choose = [](std::size_t n, std::size_t k) {
    int result = 1;
    for (std::size_t i = 0; i < k; ++i) {
      result = result * static_cast<int>(n - i) / static_cast<int>(i + 1);
    }
    return result;
  };
  Bernstein<N> result;
  for (std::size_t j = 0; j < N; ++j) {
    result[j] = Rational(0);
    for (std::size_t k = 0; k <= j; ++k) {
      result[j] += Rational(choose(j, k), choose(N - 1, k)) * power[k];
    }
  }
  return result;
}

/// If false, the polynomial may still be nowhere negative: one that touches 0 inside may use up all halvings.
template <std::size_t N>
bool is_nowhere_negative(const Bernstein<N>& b, int halvings_left = 64) {
  if (std::all_of(b.begin(), b.end(), [](const Rational& x) { return x >= 0; })) {
    return true;
  }
  if (b.front() < 0 || b.back() < 0 || halvings_left == 0) {
    return false;
  }
  Bernstein<N> row = b;
  Bernstein<N> first;
  Bernstein<N> second;
  for (std::size_t level = 0; level < N; ++level) {
    first[level] = row[0];
    second[N - 1 - level] = row[N - 1 - level];
    for (std::size_t k = 0; k + level + 1 < N; ++k) {
      row[k] = (row[k] + row[k + 1]) / Rational(2);
    }
  }
  return is_nowhere_negative(first, halvings_left - 1) && is_nowhere_negative(second, halvings_left - 1);
}

std::array<Rational, 3> powers(const Path& path, int axis, double begin) {
  const Rational delay = Rational(begin) - Rational(path.start);
  const Rational half = Rational(path.acceleration[axis]) / Rational(2);
  const Rational velocity(path.velocity[axis]);
  return {Rational(path.position[axis]) + velocity * delay + half * delay * delay,
          velocity + Rational(2) * half * delay, half};
}

/// Tests both ends, and the vertex of the parabola if it lies between them.
bool is_nowhere_negative(const std::array<Rational, 3>& c, const Rational& span) {
  if (c[0] < 0 || c[0] + span * (c[1] + span * c[2]) < 0) {
    return false;
  }
  const bool turns_inside = c[2] > 0 && c[1] < 0 && -c[1] < Rational(2) * c[2] * span;
  return !turns_inside || Rational(4) * c[0] * c[2] >= c[1] * c[1];
}

bool are_exactly_apart(const Path& a, const Path& b, double begin, double end) {
  const Rational radii = Rational(a.radius) + Rational(b.radius);
  std::array<Rational, 5> gap{-radii * radii, 0, 0, 0, 0};
  for (int axis = 0; axis < 3; ++axis) {
    std::array<Rational, 3> d = powers(a, axis, begin);
    const std::array<Rational, 3> of_b = powers(b, axis, begin);
    for (std::size_t k = 0; k < 3; ++k) {
      d[k] -= of_b[k];
    }
    for (std::size_t j = 0; j < 3; ++j) {
      for (std::size_t k = 0; k < 3; ++k) {
        gap[j + k] += d[j] * d[k];
      }
    }
  }
  const Rational span = Rational(end) - Rational(begin);
  return gap[3] == 0 && gap[4] == 0 ? is_nowhere_negative({gap[0], gap[1], gap[2]}, span)
                                    : is_nowhere_negative(bernstein(gap, span));
}

/// Whether the spheres are so far apart that they cannot meet. A relative margin of 10⁻⁹ covers rounding, because the
/// test requires coordinates below 10⁸ times the distance.
bool are_far_apart(const Path& a, const Path& b, double begin, double end) {
  long double square = 0;
  long double travel = 0;
  long double size = 0;
  const long double span = static_cast<long double>(end) - begin;
  for (int axis = 0; axis < 3; ++axis) {
    const long double x = coordinate(a, axis, begin);
    const long double y = coordinate(b, axis, begin);
    square += (x - y) * (x - y);
    travel += std::abs(speed(a, axis, begin) - speed(b, axis, begin)) * span +
              std::abs(static_cast<long double>(a.acceleration[axis]) - b.acceleration[axis]) * span * span / 2;
    size += std::abs(x) + std::abs(y);
  }
  const long double distance = std::sqrt(square);
  return size < 1e8L * distance &&
         distance * (1 - 1e-9L) > (static_cast<long double>(a.radius) + b.radius + travel) * (1 + 1e-9L);
}

/// Whether the spheres are surely apart. Halves intervals that are too long to decide.
bool are_surely_apart(const Path& a, const Path& b, double begin, double end, int halvings_left = 6) {
  if (are_far_apart(a, b, begin, end)) {
    return true;
  }
  const double middle = begin + (end - begin) / 2;
  return halvings_left > 0 && begin < middle && middle < end &&
         are_surely_apart(a, b, begin, middle, halvings_left - 1) &&
         are_surely_apart(a, b, middle, end, halvings_left - 1);
}

/// Decides exactly whether the sphere stays above the plane: N·x − N·p ≥ R |N|, with the plane's normal N and point p.
bool is_above(const scene::Plane& plane, const Path& path, double begin, double end) {
  std::array<Rational, 3> height{0, 0, 0};
  Rational square(0);
  for (int axis = 0; axis < 3; ++axis) {
    const Rational n(plane.normal[axis]);
    const std::array<Rational, 3> x = powers(path, axis, begin);
    for (std::size_t k = 0; k < 3; ++k) {
      height[k] += n * x[k];
    }
    height[0] -= n * Rational(plane.point[axis]);
    square += n * n;
  }
  const Rational span = Rational(end) - Rational(begin);
  if (!is_nowhere_negative(height, span)) {
    return false;
  }
  std::array<Rational, 5> over{-square * Rational(path.radius) * Rational(path.radius), 0, 0, 0, 0};
  for (std::size_t j = 0; j < 3; ++j) {
    for (std::size_t k = 0; k < 3; ++k) {
      over[j + k] += height[j] * height[k];
    }
  }
  return is_nowhere_negative(bernstein(over, span));
}

/// Whether the sphere is surely above the plane. A relative margin of 10⁻⁹ covers rounding.
bool is_far_above(const scene::Plane& plane, const Path& path, double begin, double end) {
  long double height = 0;
  long double fall = 0;
  long double size = 0;
  long double square = 0;
  const long double span = static_cast<long double>(end) - begin;
  for (int axis = 0; axis < 3; ++axis) {
    const long double n = plane.normal[axis];
    height += n * (coordinate(path, axis, begin) - plane.point[axis]);
    fall += std::abs(n) * (std::abs(speed(path, axis, begin)) * span +
                           std::abs(static_cast<long double>(path.acceleration[axis])) * span * span / 2);
    size += std::abs(n) * (std::abs(coordinate(path, axis, begin)) + std::abs(plane.point[axis]));
    square += n * n;
  }
  return size < 1e8L * height && height * (1 - 1e-9L) > (path.radius * std::sqrt(square) + fall) * (1 + 1e-9L);
}

class Checker {
 public:
  Checker(const scene::Scene& scene, const History& history, const Stops& stops)
      : scene_(scene), history_(history), stops_(stops) {
    double radius = 0;
    for (const scene::Sphere& sphere : scene.spheres) {
      radius = std::max(radius, sphere.radius);
    }
    cell_ = 2.5 * radius;
  }

  Validity check() {
    for (std::size_t sphere = 0; sphere < history_.arcs().size(); ++sphere) {
      follow(static_cast<std::uint32_t>(sphere), history_.arcs()[sphere]);
    }
    check_far_arcs();
    check_pairs();
    return std::move(found_);
  }

 private:
  void report(std::size_t sphere, std::string other, double begin, double end, std::string what) {
    ++found_.count;
    if (found_.invalid.size() < most_shown) {
      found_.invalid.push_back({sphere, std::move(other), begin, end, std::move(what)});
    }
  }

  void follow(std::uint32_t sphere, const std::vector<Arc>& arcs) {
    for (std::size_t k = 0; k < arcs.size() && goes_on(); ++k) {
      const double begin = std::max(arcs[k].path.start, history_.begin());
      const double end = k + 1 < arcs.size() ? arcs[k + 1].path.start : history_.end();
      if (arcs[k].path.radius != scene_.spheres[sphere].radius) {
        report(sphere, "itself", begin, end, "the radius differs from the sphere's radius");
      }
      if (!(begin <= end)) {
        report(sphere, "itself", begin, end, "an arc ends before it begins");
        continue;
      }
      if (k + 1 < arcs.size()) {
        join(sphere, arcs[k].path, arcs[k + 1].path);
      }
      check_planes(sphere, arcs[k].path, begin, end);
      cut(sphere, arcs[k].path, begin, end);
    }
  }

  void join(std::uint32_t sphere, const Path& before, const Path& after) {
    ++found_.joints;
    long double jump = 0;
    long double size = 0;
    for (int axis = 0; axis < 3; ++axis) {
      jump = std::max(jump, std::abs(after.position[axis] - coordinate(before, axis, after.start)));
      size = std::max<long double>(size, std::abs(after.position[axis]));
    }
    found_.largest_jump = std::max(found_.largest_jump, static_cast<double>(jump));
    if (jump > 8 * std::numeric_limits<double>::epsilon() * size) {
      report(sphere, "itself", after.start, after.start,
             fmt::format("its path jumps by {:.3g} m", static_cast<double>(jump)));
    }
  }

  void check_planes(std::uint32_t sphere, const Path& path, double begin, double end) {
    for (std::size_t plane = 0; plane < scene_.planes.size(); ++plane) {
      ++found_.planes;
      if (!is_far_above(scene_.planes[plane], path, begin, end) && !is_above(scene_.planes[plane], path, begin, end)) {
        report(sphere, fmt::format("plane {}", plane), begin, end, "it is not above the plane during the whole time");
      }
    }
  }

  /// Cuts an arc into pieces that travel at most one cell. An arc that travels through too many cells stays whole.
  void cut(std::uint32_t sphere, const Path& path, double begin, double end) {
    long double travel = 0;
    const long double span = static_cast<long double>(end) - begin;
    for (int axis = 0; axis < 3; ++axis) {
      travel = std::max(travel, std::max(std::abs(speed(path, axis, begin)), std::abs(speed(path, axis, end))) * span);
    }
    if (!(travel < most_cells * cell_)) {
      far_.push_back({sphere, &path, begin, end, {}, {}});
      return;
    }
    const auto count = static_cast<std::size_t>(std::ceil(travel / cell_) + 1);
    double from = begin;
    for (std::size_t k = 1; k <= count; ++k) {
      const double to =
          k == count ? end : begin + static_cast<double>(span) * static_cast<double>(k) / static_cast<double>(count);
      add({sphere, &path, from, to, {}, {}});
      from = to;
    }
  }

  void add(Piece piece) {
    for (int axis = 0; axis < 3; ++axis) {
      const long double x = coordinate(*piece.path, axis, piece.begin);
      const long double y = coordinate(*piece.path, axis, piece.end);
      const long double span = static_cast<long double>(piece.end) - piece.begin;
      // A parabola leaves the range of its ends by at most |acceleration| span²/8.
      const long double bulge = std::abs(static_cast<long double>(piece.path->acceleration[axis])) * span * span / 8;
      const long double reach = (piece.path->radius + bulge) * (1 + 1e-9L);
      const auto k = static_cast<std::size_t>(axis);
      piece.least[k] = static_cast<std::int64_t>(std::floor((std::min(x, y) - reach) / cell_));
      piece.greatest[k] = static_cast<std::int64_t>(std::floor((std::max(x, y) + reach) / cell_));
    }
    pieces_.push_back(piece);
  }

  /// Checks each arc that travels far against everything.
  void check_far_arcs() {
    for (std::size_t k = 0; k < far_.size(); ++k) {
      for (std::size_t other = 0; other < pieces_.size() + k && goes_on(); ++other) {
        const Piece& piece = other < k ? far_[other] : pieces_[other - k];
        if (piece.sphere != far_[k].sphere && piece.begin <= far_[k].end && far_[k].begin <= piece.end) {
          check_pair(far_[k], piece);
        }
      }
    }
  }

  [[nodiscard]] bool goes_on() {
    found_.is_complete = found_.is_complete && !stops_();
    return found_.is_complete;
  }

  void check_pairs() {
    struct Hash {
      std::size_t operator()(const std::array<std::int64_t, 3>& cell) const {
        return static_cast<std::size_t>(cell[0] * 73856093 ^ cell[1] * 19349663 ^ cell[2] * 83492791);
      }
    };
    std::unordered_map<std::array<std::int64_t, 3>, std::vector<std::uint32_t>, Hash> cells;
    std::sort(pieces_.begin(), pieces_.end(), [](const Piece& x, const Piece& y) { return x.begin < y.begin; });
    for (std::uint32_t k = 0; k < pieces_.size() && goes_on(); ++k) {
      const Piece& piece = pieces_[k];
      for (auto x = piece.least[0]; x <= piece.greatest[0]; ++x) {
        for (auto y = piece.least[1]; y <= piece.greatest[1]; ++y) {
          for (auto z = piece.least[2]; z <= piece.greatest[2]; ++z) {
            std::vector<std::uint32_t>& present = cells[{x, y, z}];
            std::erase_if(present, [&](std::uint32_t other) { return pieces_[other].end < piece.begin; });
            for (const std::uint32_t other : present) {
              if (pieces_[other].sphere != piece.sphere && is_first_common_cell(piece, pieces_[other], {x, y, z})) {
                check_pair(pieces_[other], piece);
              }
            }
            present.push_back(k);
          }
        }
      }
    }
  }

  static bool is_first_common_cell(const Piece& a, const Piece& b, const std::array<std::int64_t, 3>& cell) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      if (cell[axis] != std::max(a.least[axis], b.least[axis])) {
        return false;
      }
    }
    return true;
  }

  void check_pair(const Piece& a, const Piece& b) {
    const double begin = std::max(a.begin, b.begin);
    const double end = std::min(a.end, b.end);
    if (begin == end && history_.begin() < history_.end()) {
      return;  // one piece ends here, and the next piece is checked from here on
    }
    ++found_.pairs;
    if (are_surely_apart(*a.path, *b.path, begin, end)) {
      return;
    }
    ++found_.exact_pairs;
    if (!are_exactly_apart(*a.path, *b.path, begin, end)) {
      report(a.sphere, fmt::format("sphere {}", b.sphere), begin, end, "overlap");
    }
  }

  const scene::Scene& scene_;
  const History& history_;
  const Stops& stops_;
  double cell_ = 1;
  std::vector<Piece> pieces_;
  std::vector<Piece> far_;
  Validity found_;
};

}  // namespace

void Validity::add(const Validity& other) {
  count += other.count;
  for (const Invalidity& one : other.invalid) {
    if (invalid.size() < most_shown) {
      invalid.push_back(one);
    }
  }
  pairs += other.pairs;
  exact_pairs += other.exact_pairs;
  planes += other.planes;
  joints += other.joints;
  largest_jump = std::max(largest_jump, other.largest_jump);
  unseen = std::max(unseen, other.unseen);
  is_complete = is_complete && other.is_complete;
}

Validity check_validity(const scene::Scene& scene, const History& history, const Stops& stops) {
  return scene.polyhedra.empty() ? Checker(scene, history, stops).check() : check_polyhedra(scene, history, stops);
}

}  // namespace carom::properties
