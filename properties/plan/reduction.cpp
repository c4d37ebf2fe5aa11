// SPDX-License-Identifier: BSL-1.0
#include <stdexcept>
#include <string>

#include <carom/collision/expects.hpp>
#include <carom/oracles/laws/mechanics.hpp>
#include <carom/properties/plan/reduction.hpp>

namespace carom::properties::plan {
namespace {

using oracles::ExactCase;
using oracles::Rational;

bool are_parallel(const Vector3<Rational>& x, const Vector3<Rational>& y) {
  const Vector3<Rational> product = x.cross(y);
  return product[0] == 0 && product[1] == 0 && product[2] == 0;
}

Vector3<Rational> k_times_normal(const ExactCase& c) { return c.collision_matrix() * c.exact().normal; }

bool ends_without_slip(const ExactCase& c, Law law) {
  return are_parallel(c.exact().normal, oracles::relative_velocity<Rational>(c.exact(), c.truth(law).outcome));
}

/// If V⁻ is parallel to K N, the impulse that stops the approach also stops the contact point.
bool stops_with_the_approach(const ExactCase& c) {
  const Vector3<Rational> before = oracles::relative_velocity<Rational>(c.exact(), unchanged(c.exact()));
  return are_parallel(k_times_normal(c), before);
}

bool may_stick(const ExactCase& c) {
  const Vector3<Rational>& n = c.exact().normal;
  const Vector3<Rational>& impulse = c.truth(Law::sticking).impulse;
  const Vector3<Rational> across = n.cross(impulse);
  const Rational most = c.exact().friction * n.dot(impulse);
  return most >= 0 && across.dot(across) <= most * most;
}

bool is_isotropic_across_normal(const ExactCase& c) {
  const Vector3<Rational>& n = c.exact().normal;
  const Matrix3<Rational>& k = c.collision_matrix();
  if (!is_normal_eigenvector(c)) {
    return false;
  }
  const int i = n[0] == 0 && n[1] == 0 ? 1 : 2;  // exchanges two components that are not both zero
  Vector3<Rational> first{Rational(0), Rational(0), Rational(0)};
  first[0] = i == 2 ? -n[1] : n[2];
  first[i == 2 ? 1 : 2] = i == 2 ? n[0] : -n[0];
  if (first[0] == 0 && first[1] == 0 && first[2] == 0) {
    first = {Rational(1), Rational(0), Rational(0)};
  }
  const Vector3<Rational> second = n.cross(first);
  const Vector3<Rational> of_first = k * first;
  const Vector3<Rational> of_second = k * second;
  return second.dot(of_first) == 0 &&
         first.dot(of_first) * second.dot(second) == second.dot(of_second) * first.dot(first);
}

std::optional<Reduction> where(bool holds, Reduction reduction) {
  return holds ? std::optional<Reduction>(reduction) : std::nullopt;
}

std::optional<Reduction> to_frictionless(const ExactCase& c, Law law) {
  switch (law) {
    case Law::reflection:
      return where(is_normal_eigenvector(c), Reduction::eigenvector);
    case Law::sticking:
      return where(ends_without_slip(c, Law::frictionless), Reduction::no_slip);
    case Law::rough:
      if (c.exact().friction == 0) {
        return Reduction::no_friction;
      }
      if (c.exact().tangential_restitution == -1) {
        return Reduction::no_share;
      }
      return where(stops_with_the_approach(c), Reduction::no_slip);
    case Law::coulomb:
      if (c.exact().friction == 0) {
        return Reduction::no_friction;
      }
      return where(ends_without_slip(c, Law::frictionless), Reduction::no_slip);
    case Law::frictionless:
    case Law::any:
      break;
  }
  return std::nullopt;
}

/// P_I stops the approach, and P_II stops the contact point. Inside the friction cone, `rough` with e_t = 0 has the
/// impulse P_II + ε P_I. `sticking` has P_II + ε (−(N·V⁻)/(N·N) K⁻¹N). Both impulses are equal if ε = 0 or if N is an
/// eigenvector of K.
std::optional<Reduction> to_sticking(const ExactCase& c, Law law) {
  if (law == Law::coulomb) {
    return where(may_stick(c), Reduction::sticks);
  }
  const bool is_alike = c.exact().tangential_restitution == 0 && c.branch(Law::rough) == oracles::Branch::inside_cone &&
                        (c.exact().restitution == 0 || is_normal_eigenvector(c));
  return where(is_alike, Reduction::sticks);
}

}  // namespace

std::string_view in_words(Reduction reduction) {
  constexpr EnumArray<Reduction, std::string_view, all_reductions.size()> words{
      "it is the requested law",
      "the contact does not collide",
      "N is an eigenvector of K",
      "μ = 0",
      "e_t = −1",
      "the frictionless outcome has no slip",
      "the contact sticks, inside the friction cone",
      "K is the same in all directions across N, and e_t = 0"};
  return words[reduction];
}

std::span<const Law> lesser_laws(Law law) {
  static constexpr std::array of_frictionless{Law::frictionless};
  static constexpr std::array of_reflection{Law::frictionless, Law::reflection};
  static constexpr std::array of_sticking{Law::frictionless, Law::sticking};
  static constexpr std::array of_rough{Law::frictionless, Law::sticking, Law::rough};
  static constexpr std::array of_coulomb{Law::frictionless, Law::sticking, Law::rough, Law::coulomb};
  switch (law) {
    case Law::frictionless:
      return of_frictionless;
    case Law::reflection:
      return of_reflection;
    case Law::sticking:
      return of_sticking;
    case Law::rough:
      return of_rough;
    case Law::coulomb:
      return of_coulomb;
    case Law::any:
      break;
  }
  return {};
}

bool is_normal_eigenvector(const ExactCase& exact_case) {
  CAROM_EXPECTS(has_movable_body(exact_case.collision()));
  return are_parallel(exact_case.exact().normal, k_times_normal(exact_case));
}

std::optional<Reduction> reduction(const ExactCase& exact_case, Law law, Law lesser) {
  if (law == lesser) {
    return Reduction::same_law;
  }
  if (exact_case.state() != oracles::ContactState::colliding) {
    return Reduction::untouched;
  }
  switch (lesser) {
    case Law::frictionless:
      return to_frictionless(exact_case, law);
    case Law::sticking:
      return to_sticking(exact_case, law);
    case Law::rough:
      return where(exact_case.exact().tangential_restitution == 0 && is_isotropic_across_normal(exact_case),
                   Reduction::isotropic);
    case Law::reflection:
    case Law::coulomb:
    case Law::any:
      break;
  }
  throw std::logic_error(std::string(name_of(lesser)) + " is not a lesser law of " + std::string(name_of(law)));
}

}  // namespace carom::properties::plan
