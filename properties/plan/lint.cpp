// SPDX-License-Identifier: BSL-1.0
#include <algorithm>
#include <array>
#include <utility>

#include <fmt/format.h>

#include <carom/collision/expects.hpp>
#include <carom/collision/validate.hpp>
#include <carom/oracles/judge/exact_case.hpp>
#include <carom/oracles/laws/kinematics.hpp>
#include <carom/oracles/laws/mechanics.hpp>
#include <carom/properties/gate/in_words.hpp>
#include <carom/properties/plan/lint.hpp>

namespace carom::properties::plan {
namespace {

using oracles::Rational;

class Linter {
 public:
  explicit Linter(const ClassedCollision& contact) : contact_(contact), exact_(oracles::lift(contact.collision)) {}

  void coefficients() {
    const Collision& c = contact_.collision;
    // An invalid collision here is out of range, so only its coefficients have errors.
    for (const InputError& error : validate(c)) {
      add(Lint::coefficient, Severity::warning, error.field,
          "expected " + error.expected + "; no law is defined for this value, so the plan ignores the contact");
    }
    if (c.friction > friction_noted) {
      add(Lint::coefficient, Severity::note, "friction",
          fmt::format("μ = {} is larger than the measured values of solids; check the coefficient",
                      in_words(c.friction)));
    }
  }

  void lengths() {
    if (!contact_.is_normal_derived) {
      length(Lint::normal_length, "normal", "normal", exact_.normal.dot(exact_.normal));
    }
    for (const auto& [body, name] : bodies()) {
      if (!body->immovable) {
        length(Lint::quaternion_length, name + ".orientation", "quaternion", body->orientation.dot(body->orientation));
      }
    }
  }

  void moments() {
    for (const auto& [body, name] : bodies()) {
      if (body->immovable) {
        continue;
      }
      const Vector3<Rational>& moments = body->principal_inertia;
      for (int i = 0; i < 3; ++i) {
        const Rational others = moments[(i + 1) % 3] + moments[(i + 2) % 3];
        if (moments[i] > others * (Rational(1) + Rational(moments_noted))) {
          const bool is_rounding = moments[i] <= others * (Rational(1) + Rational(moments_warned));
          add(Lint::moments, is_rounding ? Severity::note : Severity::warning,
              fmt::format("{}.principal_inertia[{}]", name, i),
              fmt::format("{} is more than {}, the sum of the other two moments: {}",
                          in_words(oracles::to_double(moments[i])), in_words(oracles::to_double(others)),
                          is_rounding ? "the values fit a flat body that is rounded to binary32"
                                      : "no body has such moments; correct them"));
        }
      }
    }
  }

  void condition() {
    CAROM_EXPECTS(validate(contact_.collision).empty(), describe(validate(contact_.collision)));
    const Collision& c = contact_.collision;
    const Rational inverse_mass = oracles::inverse_mass(exact_);
    if (inverse_mass == 0) {
      return;
    }
    std::string of_bodies;  // the bodies whose share of K is too great; not empty if K is too great
    for (const auto& [body, name] : bodies()) {
      Collision alone = c;
      (name == "a" ? alone.b : alone.a).immovable = true;
      // K of this body alone: λI + [r]ᵀ J⁻¹ [r] with λ = 1/m.
      if (!body->immovable && !oracles::ExactCase(alone).is_bounded_by(Rational(largest_condition) / body->mass)) {
        of_bodies += (of_bodies.empty() ? "" : ", ") + name;
      }
    }
    if (!oracles::ExactCase(c).is_bounded_by(Rational(largest_condition) * inverse_mass)) {
      add(Lint::condition, Severity::warning, of_bodies,
          fmt::format("K exceeds {} (1/m_A + 1/m_B): this is impossible for uniform bodies that are star-shaped from "
                      "the contact point, "
                      "such as convex bodies; check the moments of inertia and the lever arm",
                      largest_condition));
    } else if (!of_bodies.empty()) {
      add(Lint::lever_arm, Severity::warning, of_bodies,
          fmt::format("[r]ᵀ J⁻¹ [r] exceeds {}/m: the contact point is too far from the centre of mass for these "
                      "moments; check the moments and the positions",
                      largest_condition - 1));
    }
  }

  /// A convex body, and its centre of mass, lie on one side of the plane through P across N.
  void centre_of_mass() {
    for (const auto& [body, name] : bodies()) {
      if (body->immovable) {
        continue;
      }
      const Vector3<Rational>& normal = exact_.normal;
      const Rational height = Rational(name == "a" ? -1 : 1) * oracles::lever_arm(*body, exact_.point).dot(normal);
      if (height >= 0) {
        continue;
      }
      // The rounding of r·N is relative to these terms, (|P_i| + |X_i|) |N_i|.
      Rational terms(0);
      for (int i = 0; i < 3; ++i) {
        terms += (abs(exact_.point[i]) + abs(body->position[i])) * abs(normal[i]);
      }
      const bool is_rounding = -height <= Rational(centre_of_mass_warned) * terms;
      add(Lint::centre_of_mass, is_rounding ? Severity::note : Severity::warning, name + ".position",
          fmt::format("the centre of mass lies {}on the other body's side of the contact plane; this is impossible for "
                      "a convex body, so check the direction of the normal",
                      is_rounding ? "by a rounding error " : ""));
    }
  }

  void mass_ratio() {
    if (exact_.a.immovable || exact_.b.immovable) {
      return;
    }
    const auto& [lighter, heavier] = std::minmax(exact_.a.mass, exact_.b.mass);
    const Rational ratio = heavier / lighter;
    if (ratio > Rational(mass_ratio_noted)) {
      add(Lint::mass_ratio, ratio > Rational(mass_ratio_warned) ? Severity::warning : Severity::note,
          exact_.a.mass < exact_.b.mass ? "b.mass" : "a.mass",
          fmt::format(
              "the mass is {:.3g} times the other mass; a solver of many simultaneous contacts converges slowly",
              oracles::to_double(ratio)));
    }
  }

  [[nodiscard]] std::vector<LintFinding> take() { return std::move(findings_); }

 private:
  using NamedBody = std::pair<const BasicBody<Rational>*, std::string>;
  [[nodiscard]] std::array<NamedBody, 2> bodies() const {
    return {NamedBody{&exact_.a, "a"}, NamedBody{&exact_.b, "b"}};
  }

  void length(Lint lint, const std::string& field, const char* what, const Rational& squared) {
    const auto is_within = [&](double bound) {
      const Rational low = Rational(1) - Rational(bound);
      const Rational high = Rational(1) + Rational(bound);
      return squared >= low * low && squared <= high * high;
    };
    if (!is_within(length_noted)) {
      const oracles::RootBelow length = oracles::root_below(squared);
      add(lint, is_within(length_warned) ? Severity::note : Severity::warning, field,
          fmt::format("the {} has length {:.9g}; Carom uses only its direction, but a solver that assumes length 1 "
                      "gives a wrong result",
                      what, oracles::to_double(length.root)));
    }
  }

  void add(Lint lint, Severity severity, std::string field, std::string text) {
    findings_.push_back({lint, severity, contact_.place, std::move(field), std::move(text)});
  }

  const ClassedCollision& contact_;
  BasicCollision<Rational> exact_;
  std::vector<LintFinding> findings_;
};

}  // namespace

bool is_out_of_range(const Collision& collision) {
  const std::vector<InputError> errors = validate(collision);
  return !errors.empty() && std::ranges::all_of(errors, [](const InputError& error) {
    const bool is_coefficient =
        error.field == "restitution" || error.field == "friction" || error.field == "tangential_restitution";
    return is_coefficient && error.expected != "a finite number";
  });
}

std::vector<LintFinding> findings_of(const ClassedCollision& contact) {
  CAROM_EXPECTS(validate(contact.collision).empty() || is_out_of_range(contact.collision),
                describe(validate(contact.collision)));
  Linter linter(contact);
  linter.coefficients();
  linter.lengths();
  linter.moments();
  linter.centre_of_mass();
  if (validate(contact.collision).empty()) {
    linter.condition();
  }
  linter.mass_ratio();
  return linter.take();
}

}  // namespace carom::properties::plan
