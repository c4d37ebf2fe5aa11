// SPDX-License-Identifier: BSL-1.0
#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <iterator>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <carom/collision/validate.hpp>
#include <carom/oracles/judge/exact_case.hpp>
#include <carom/properties/gate/shrink.hpp>
#include <carom/properties/three_properties.hpp>
#include <carom/rapidcheck.hpp>

#include "consumer/my_solver.hpp"
#include "support/cases.hpp"

namespace carom {
namespace {

using properties::Case;
using properties::ChosenCase;
using properties::Family;

std::vector<const Family*> each_family() {
  std::vector<const Family*> all = properties::pointers_to(properties::all_families());
  std::ranges::copy(properties::pointers_to(properties::families_beyond_domain()), std::back_inserter(all));
  return all;
}

std::vector<std::uint64_t> bits_of(const Collision& collision) {
  std::vector<std::uint64_t> bits{collision.a.immovable ? 1U : 0U, collision.b.immovable ? 1U : 0U};
  for_each_number([&](const FieldPath&, const double& number) { bits.push_back(std::bit_cast<std::uint64_t>(number)); },
                  collision);
  return bits;
}

/// The case that the gate draws if its random words make these choices.
Case drawn_by_words(const Family& family, const std::vector<properties::Choice>& choices) {
  std::vector<std::uint64_t> words;
  for (const auto& [question, answer] : choices) {
    if (!question.is_of_plainness) {
      words.push_back(question.count == properties::fractions ? answer << 11U : answer);
    }
  }
  std::size_t next = 0;
  properties::Stream stream([&] { return words.at(next++); });
  Case drawn = family.generate(stream);
  EXPECT_EQ(next, words.size());
  return drawn;
}

/// The case with the same choices, but without plain numbers (Stream::plainly).
ChosenCase without_plainness(const Family& family, ChosenCase chosen) {
  const auto is_plain = [](const properties::Choice& choice) {
    return choice.question.is_of_plainness && choice.answer == 1;
  };
  // Other numbers may lead to other choices, which may be plain again. So the loop repeats.
  while (std::any_of(chosen.choices.begin(), chosen.choices.end(), is_plain)) {
    for (properties::Choice& choice : chosen.choices) {
      choice.answer = is_plain(choice) ? 0 : choice.answer;
    }
    chosen = properties::replayed_case(family.generate, chosen.choices);
  }
  return chosen;
}

class EachFamily : public testing::TestWithParam<const Family*> {};

/// The family can draw each simpler case. If the case has no plain numbers, the gate can draw it, too.
TEST_P(EachFamily, ShrinksToWhatItCouldDraw) {
  const Family& family = *GetParam();
  rc::Random random(1);
  int shrunk = 0;
  const int sizes = unit::effort(20);
  for (int i = 1; i <= sizes; ++i) {
    const int size = i * 100 / sizes;
    ChosenCase chosen = properties::chosen_case(
        family.generate, [&] { return random.next(); }, size);
    while (true) {
      properties::SimplerCases simpler(family.generate, chosen, random.next() % 1000);
      std::optional<ChosenCase> next = simpler.next();
      if (!next) {
        break;
      }
      ASSERT_LT(properties::complexity(next->one.collision), properties::complexity(chosen.one.collision));
      chosen = *std::move(next);
      ++shrunk;
      for (const auto& [question, answer] : chosen.choices) {
        ASSERT_LT(answer, question.count);
      }
      const ChosenCase gates = without_plainness(family, chosen);
      ASSERT_EQ(bits_of(drawn_by_words(family, gates.choices).collision), bits_of(gates.one.collision));
    }
  }
  EXPECT_GT(shrunk, sizes);
}

TEST_P(EachFamily, DrawsTheCasesOfTheGateAtFullSize) {
  rc::Random random(2);
  for (int i = 0; i < 20; ++i) {
    const ChosenCase chosen = properties::chosen_case(
        GetParam()->generate, [&] { return random.next(); }, 50 + i);
    EXPECT_EQ(bits_of(drawn_by_words(*GetParam(), chosen.choices).collision), bits_of(chosen.one.collision));
  }
}

INSTANTIATE_TEST_SUITE_P(Of, EachFamily, testing::ValuesIn(each_family()),
                         [](const auto& test) { return std::string(test.param->name); });

/// Visits values of a generator at sizes from 1 to 100. From each value, follows the chain of first simpler values.
template <class Visit>
void visit_shrunk(const rc::Gen<Collision>& generator, int values, Visit visit) {
  rc::Random random(3);
  for (int i = 0; i < values; ++i) {
    rc::Shrinkable<Collision> at = generator(random.split(), 1 + i * 99 / values);
    visit(at.value());
    for (auto shrinks = at.shrinks(); auto next = shrinks.next(); shrinks = at.shrinks()) {
      at = *next;
      visit(at.value());
    }
  }
}

TEST(Shrinking, KeepsWhatFamiliesPromise) {
  using Promise = bool (*)(const Collision&);
  const std::map<std::string_view, Promise> promises{
      {"collinear_spheres", [](const Collision& c) { return oracles::ExactCase(c).is_collinear(); }},
      {"spin_alone", [](const Collision& c) { return oracles::ExactCase(c).is_collinear(); }},
      {"resting", [](const Collision& c) { return oracles::ExactCase(c).state() == oracles::ContactState::resting; }},
      {"inelastic", [](const Collision& c) { return c.restitution == 0; }},
      {"elastic", [](const Collision& c) { return c.restitution == 1; }},
      {"immovable_a", [](const Collision& c) { return c.a.immovable && !c.b.immovable; }},
      {"immovable_b", [](const Collision& c) { return c.b.immovable && !c.a.immovable; }},
      {"both_immovable", [](const Collision& c) { return c.a.immovable && c.b.immovable; }},
      {"zero_lever", [](const Collision& c) { return c.point == c.a.position || c.point == c.b.position; }},
      {"no_friction", [](const Collision& c) { return c.friction == 0; }},
      {"great_friction", [](const Collision& c) { return c.friction >= 1; }},
      {"long_normal", [](const Collision& c) { return (c.normal.array() != 0).any(); }},
      {"invalid", [](const Collision& c) { return !validate(c).empty(); }},
      {"head_on", [](const Collision& c) {
         const Vector3<double> v = properties::relative_velocity(c);
         return c.normal.dot(v) < 0 && c.normal.cross(v).norm() <= 1e-6 * c.normal.norm() * v.norm();
       }}};
  for (const auto& [name, promise] : promises) {
    int seen = 0;
    visit_shrunk(gen::family(name), 20, [&, promise = promise](const Collision& c) {
      ++seen;
      ASSERT_TRUE(promise(c)) << rc::toString(c);
    });
    EXPECT_GT(seen, 50) << name;
  }
}

TEST(Generators, AreOneForEachFamilyByItsName) {
  std::vector<std::string_view> names;
#define CAROM_NAME(NAME) names.push_back(#NAME);
  CAROM_GEN_FAMILIES(CAROM_NAME)
#undef CAROM_NAME
  std::vector<std::string_view> expected;
  for (const Family* family : each_family()) {
    expected.push_back(family->name);
  }
  EXPECT_EQ(names, expected);
  const rc::Random random(4);
  EXPECT_EQ(bits_of(gen::near_head_on()(random).value()), bits_of(gen::family("near_head_on")(random).value()));
  EXPECT_THROW((void)gen::family("nearly_head_on"), std::invalid_argument);
  EXPECT_THROW((void)gen::with_feature("a.nothing"), std::invalid_argument);
}

long numbers_of(const Collision& collision) {
  const std::vector<std::uint64_t> bits = bits_of(collision);
  return static_cast<long>(bits.size()) - std::count(bits.begin(), bits.end(), 0U);
}

TEST(Generators, GiveSimpleCollisionsAtSmallSizes) {
  std::array<long, 3> complexities{};
  const std::array sizes{2, 20, 100};
  for (std::size_t i = 0; i < sizes.size(); ++i) {
    rc::Random random(5);
    for (int n = 0; n < 100; ++n) {
      complexities[i] += properties::complexity(gen::generic()(random.split(), sizes[i]).value());
    }
  }
  // At size 2, only one choice in 25 is free, so most numbers are plain.
  EXPECT_LT(complexities[0], complexities[2] / 8);
  EXPECT_LT(complexities[0], complexities[1]);
  EXPECT_LT(complexities[1], complexities[2]);
  // At size 0, eleven numbers are not zero: two masses, six moments, two of the orientations, one of the normal.
  EXPECT_EQ(numbers_of(gen::generic()(rc::Random(6), 0).value()), 11);
}

RC_GTEST_PROP(Generators, DrawValidCollisionsByDefault, (const Collision& collision)) {
  RC_ASSERT(validate(collision).empty());
}

RC_GTEST_PROP(Generators, MakeContactsApproach, ()) {
  const auto collision = *gen::approaching(gen::any_family());
  RC_ASSERT(properties::is_approaching(collision));
}

RC_GTEST_PROP(Generators, PutOtherBodiesIntoAContact, ()) {
  const auto collision = *gen::with_bodies(gen::head_on(), gen::wall(), gen::body());
  RC_ASSERT(collision.a.immovable);
  RC_ASSERT(!collision.b.immovable);
  RC_ASSERT(collision.a.position == collision.point);
}

RC_GTEST_PROP(Generators, PutBallsOnOneLine, ()) {
  RC_ASSERT(oracles::ExactCase(*gen::between_spheres()).is_collinear());
}

RC_GTEST_PROP(Generators, ComposeWithThoseOfRapidCheck, ()) {
  const auto heavy = rc::gen::map(gen::collinear_spheres(), [](Collision collision) {
    collision.a.mass *= 8;
    return collision;
  });
  const auto of_balls = rc::gen::suchThat(heavy, [](const Collision& collision) { return !collision.a.immovable; });
  const auto [restitution, collision] = *rc::gen::pair(rc::gen::element(0.0, 0.5, 1.0), of_balls);
  RC_ASSERT(!collision.a.immovable);
  RC_ASSERT(restitution <= 1);
}

TEST(Within, ShrinksInTheDomain) {
  for (const char* text : {"size=0.25:8,mass=2:64,speed=0.5:16,restitution=0.25:0.5", "bodies=spheres,plane=xy"}) {
    const properties::Domain domain = properties::domain_from(text);
    int seen = 0;
    for (const auto& generator : {gen::any_family(), gen::collinear_spheres(), gen::structured()}) {
      visit_shrunk(gen::within(domain, generator), 10, [&](const Collision& collision) {
        ++seen;
        ASSERT_EQ(properties::name_outside(domain, collision), std::nullopt);
        ASSERT_EQ(describe(validate(collision)), "");
      });
    }
    EXPECT_GT(seen, 100) << text;
  }
}

TEST(Features, AreGivenByName) {
  for (const properties::Feature& feature : properties::all_features()) {
    int seen = 0;
    visit_shrunk(gen::with_feature(feature.name), unit::effort(2), [&](const Collision& collision) {
      ++seen;
      ASSERT_TRUE(feature.is_present(collision)) << feature.name;
    });
    EXPECT_GT(seen, 0) << feature.name;
  }
}

Outcome<double> without_rotation(const Collision& collision) { return textbook(collision, true); }

bool fails(const Collision& collision) {
  return !properties::non_penetrating_post_velocity(without_rotation, collision);
}

/// Repeatedly takes the first simpler value that fails, as RapidCheck does.
Collision shrunk(rc::Shrinkable<Collision> failing) {
  auto shrinks = failing.shrinks();
  while (auto next = shrinks.next()) {
    if (fails(next->value())) {
      failing = *next;
      shrinks = failing.shrinks();
    }
  }
  return failing.value();
}

/// The count of numbers that are neither 0 nor a default of `Body`. An orientation (w, 0, 0, 0) counts as a default.
int numbers_to_write(const Collision& collision) {
  int count = 0;
  for_each_number(
      [&](const FieldPath& path, const double& number) {
        const bool is_unit = (number == 1 && (path.field == "mass" || path.field == "principal_inertia")) ||
                             (path.field == "orientation" && path.component == 0);
        count += number == 0 || is_unit ? 0 : 1;
      },
      collision);
  return count;
}

/// The solver is wrong if a spin w moves one body towards the other. This needs only one nonzero component of each of
/// N, r and w.
constexpr int most_numbers = 3;

TEST(StrangersSolver, IsShrunkToACollisionThatFitsOnPaper) {
  int found = 0;
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    rc::Random random(seed);
    for (int size = 0; size <= 100; ++size) {
      const rc::Shrinkable<Collision> drawn = gen::any_family()(random.split(), size);
      if (fails(drawn.value())) {
        const Collision simple = shrunk(drawn);
        ++found;
        EXPECT_LE(numbers_to_write(simple), most_numbers) << rc::toString(simple);
        for_each_number(
            [&](const FieldPath& path, const double& number) {
              EXPECT_LE(std::abs(number), 8) << path.text() << rc::toString(simple);
              EXPECT_EQ(number * 64, std::round(number * 64)) << path.text() << rc::toString(simple);
            },
            simple);
        break;
      }
    }
  }
  EXPECT_EQ(found, 20);
}

}  // namespace
}  // namespace carom
