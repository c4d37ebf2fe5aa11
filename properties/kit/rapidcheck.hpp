// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <ostream>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>

#include <rapidcheck.h>

#include <carom/properties/cases/body_pairs.hpp>
#include <carom/properties/cases/draw_within.hpp>
#include <carom/properties/draws/relative_velocity.hpp>
#include <carom/properties/features/feature.hpp>
#include <carom/properties/gate/shrink.hpp>

/// Collisions for RapidCheck: rc::Arbitrary<carom::Collision>, and a generator for each family. Small sizes give simple
/// collisions; from size 50 on, a generator gives the family's whole distribution. Collisions shrink to numbers with
/// few binary digits. Each step of shrinking is a collision that the generator can draw.
namespace carom {

namespace properties {
// Declared here, because trial/in_words.hpp includes exact arithmetic, which a user need not compile.
[[nodiscard]] std::string in_words(const Collision& collision, const std::string& indent);
}  // namespace properties

inline void showValue(const Collision& collision, std::ostream& out) {
  out << '\n' << properties::in_words(collision, "  ");
}

namespace gen {

/// The cases that `draw` makes from random choices. RapidCheck shrinks the choices.
[[nodiscard]] inline rc::Gen<properties::Case> cases(properties::Draw draw) {
  struct Shrinks {
    static rc::Shrinkable<properties::Case> of(const properties::Draw& draw, properties::ChosenCase chosen,
                                               std::size_t first) {
      auto one = [case_of_it = chosen.one] { return case_of_it; };
      return rc::shrinkable::lambda(std::move(one), [=] {
        // Begins at the change that succeeded last, because the changes before it failed, and seldom succeed later.
        return rc::Seq<rc::Shrinkable<properties::Case>>(
            [draw, simpler = properties::SimplerCases(draw, chosen,
                                                      first)]() mutable -> rc::Maybe<rc::Shrinkable<properties::Case>> {
              auto next = simpler.next();
              if (!next) {
                return rc::Nothing;
              }
              return of(draw, *std::move(next), simpler.place());
            });
      });
    }
  };
  return [draw = std::move(draw)](rc::Random random, int size) {
    return Shrinks::of(draw,
                       properties::chosen_case(
                           draw, [&] { return random.next(); }, size),
                       0);
  };
}

[[nodiscard]] inline rc::Gen<Collision> collisions(properties::Draw draw) {
  return rc::gen::map(cases(std::move(draw)), [](const properties::Case& one) { return one.collision; });
}

/// The collisions of the family with this name (`carom families` lists the names). Throws std::invalid_argument if no
/// family has this name.
[[nodiscard]] inline rc::Gen<Collision> family(std::string_view name) {
  const properties::Family* const found = properties::family_named(name);
  if (found == nullptr) {
    throw std::invalid_argument("carom::gen::family: there is no family " + std::string(name));
  }
  return collisions(found->generate);
}

/// Valid collisions of random families (`case_of_any_family`).
[[nodiscard]] inline rc::Gen<Collision> any_family() { return collisions(properties::case_of_any_family); }

// Defines a generator for each family, such as carom::gen::near_head_on().
#define CAROM_GEN_FAMILIES(F)       \
  F(structured)                     \
  F(generic)                        \
  F(physical)                       \
  F(near_special)                   \
  F(head_on)                        \
  F(near_head_on)                   \
  F(collinear_spheres)              \
  F(near_collinear)                 \
  F(grazing)                        \
  F(resting)                        \
  F(separating)                     \
  F(inelastic)                      \
  F(elastic)                        \
  F(mass_ratio)                     \
  F(mass_scale)                     \
  F(immovable_a)                    \
  F(immovable_b)                    \
  F(driven_wall)                    \
  F(both_immovable)                 \
  F(zero_lever)                     \
  F(far_from_origin)                \
  F(common_velocity)                \
  F(fast_spin)                      \
  F(long_normal)                    \
  F(long_quaternion)                \
  F(slow)                           \
  F(sticking)                       \
  F(sliding)                        \
  F(on_the_cone)                    \
  F(stick_or_slip)                  \
  F(no_friction)                    \
  F(great_friction)                 \
  F(spin_alone)                     \
  F(special_tangential_restitution) \
  F(chung_ooi)                      \
  F(invalid)                        \
  F(far_contacts)                   \
  F(impossible_moments)             \
  F(needle_tip)
#define CAROM_GEN_FAMILY(NAME) \
  [[nodiscard]] inline rc::Gen<Collision> NAME() { return family(#NAME); }
CAROM_GEN_FAMILIES(CAROM_GEN_FAMILY)
#undef CAROM_GEN_FAMILY

/// Two balls that touch. The centres and the contact are exactly on one line along the normal.
[[nodiscard]] inline rc::Gen<Collision> between_spheres() { return collisions(properties::touching_spheres); }

/// The generator's collisions with a negative rounded N·V⁻. If the bodies separate, all motion is reversed first.
[[nodiscard]] inline rc::Gen<Collision> approaching(rc::Gen<Collision> generator) {
  auto reversed = rc::gen::map(std::move(generator), [](Collision collision) {
    properties::reverse_if_separating(collision);
    return collision;
  });
  return rc::gen::suchThat(std::move(reversed), properties::is_approaching);
}

/// Bodies of any inertia and motion, at positions relative to the contact point.
[[nodiscard]] inline rc::Gen<Body> body() {
  return rc::gen::map(collisions(properties::general_bodies), [](Collision collision) {
    collision.a.position -= collision.point;
    return collision.a;
  });
}

[[nodiscard]] inline rc::Gen<Body> wall() { return rc::gen::just(Body{.immovable = true}); }

/// The generator's collisions, with the bodies replaced by `a` and `b`. The positions of `a` and `b` are relative to
/// the contact point.
[[nodiscard]] inline rc::Gen<Collision> with_bodies(rc::Gen<Collision> generator, rc::Gen<Body> a, rc::Gen<Body> b) {
  return rc::gen::apply(
      [](Collision collision, const Body& of_a, const Body& of_b) {
        collision.a = of_a;
        collision.b = of_b;
        collision.a.position += collision.point;
        collision.b.position += collision.point;
        return collision;
      },
      std::move(generator), std::move(a), std::move(b));
}

/// The generator's collisions, changed to lie in the domain (`properties::domain_from` reads one from a text). Drops
/// collisions that cannot lie there. Invalid collisions stay as they are.
[[nodiscard]] inline rc::Gen<Collision> within(const properties::Domain& domain,
                                               rc::Gen<Collision> generator = any_family()) {
  auto fitted = rc::gen::mapcat(std::move(generator), [domain](const Collision& collision) {
    return collisions([=](properties::Stream& stream) {
      properties::Case one{collision};
      return properties::fit_into(domain, {}, stream, one) ? one : properties::Case{collision};
    });
  });
  return rc::gen::suchThat(std::move(fitted),
                           [domain](const Collision& collision) { return properties::contains(domain, collision); });
}

/// The generator's collisions, changed to have this feature (`carom features` lists the names). Drops collisions that
/// cannot have the feature. Throws std::invalid_argument if no feature has this name.
[[nodiscard]] inline rc::Gen<Collision> with_feature(std::string_view name, rc::Gen<Collision> generator = generic()) {
  const properties::Feature* const feature = properties::feature_named(name);
  if (feature == nullptr) {
    throw std::invalid_argument("carom::gen::with_feature: there is no feature " + std::string(name));
  }
  auto made = rc::gen::mapcat(std::move(generator), [feature](const Collision& collision) {
    return collisions([=](properties::Stream& stream) {
      properties::Case one{collision};
      feature->make(stream, one.collision);
      return one;
    });
  });
  return rc::gen::suchThat(std::move(made), feature->is_present);
}

}  // namespace gen
}  // namespace carom

template <>
struct rc::Arbitrary<carom::Collision> {
  static Gen<carom::Collision> arbitrary() { return carom::gen::any_family(); }
};
