// SPDX-License-Identifier: BSL-1.0
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <iterator>
#include <limits>
#include <set>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include <carom/impulse/batch/solve.hpp>
#include <carom/impulse/laws.hpp>
#include <carom/impulse/numbers/pack.hpp>
#include <carom/properties/cases/family.hpp>

#include "support/cases.hpp"

/// Each available instruction set gives the same bits as the scalar solvers, for any alignment of the arrays and any
/// number of contacts.
namespace carom::impulse {
namespace {

/// Cases of every family in turn, so that neighbours in a pack (SIMD vector) differ.
template <class S>
std::vector<Contact<S>> mixed_contacts(std::size_t count) {
  const auto families = properties::all_families();
  std::vector<Contact<S>> contacts;
  for (std::uint64_t i = 0; contacts.size() < count; ++i) {
    const properties::Family& family = families[i % families.size()];
    if (family.is_valid) {
      contacts.push_back(make_contact<S>(unit::case_of(family.name, i).collision));
    }
  }
  return contacts;
}

template <class S>
ContactBatch<S> batch_of(const std::vector<Contact<S>>& contacts) {
  ContactBatch<S> batch(contacts.size());
  for (std::size_t i = 0; i < contacts.size(); ++i) {
    batch.set(i, contacts[i]);
  }
  return batch;
}

template <class S>
Outcome<S> solved_alone(const Contact<S>& contact, Law law) {
  Outcome<S> outcome;
  with_law(law, [&](const auto& solver) { outcome = apply_impulse(contact, solver(contact)); });
  return outcome;
}

/// Bitwise equality; all NaNs are equal.
template <class S>
bool same_bits(S x, S y) {
  return (x == y && std::signbit(x) == std::signbit(y)) || (std::isnan(x) && std::isnan(y));
}

template <class S>
bool same_bits(const Outcome<S>& x, const Outcome<S>& y) {
  for (const OutcomeVector k : all_outcome_vectors) {
    for (int i = 0; i < 3; ++i) {
      if (!same_bits((*vectors(x)[k])[i], (*vectors(y)[k])[i])) {
        return false;
      }
    }
  }
  return true;
}

std::vector<InstructionSet> available_instruction_sets() {
  std::vector<InstructionSet> available;
  std::ranges::copy_if(all_instruction_sets, std::back_inserter(available), is_available);
  return available;
}

template <class S>
class Batch : public testing::Test {};
using Scalars = testing::Types<float, double>;
TYPED_TEST_SUITE(Batch, Scalars);

TYPED_TEST(Batch, GivesTheBitsOfTheScalarSolvers) {
  using S = TypeParam;
  const auto contacts = mixed_contacts<S>(4801);
  ContactBatch<S> batch = batch_of(contacts);
  for (const InstructionSet set : available_instruction_sets()) {
    for (const Law law : laws_with_truth) {
      OutcomeBatch<S> outcomes(contacts.size());
      solve(batch, law, outcomes, set);
      std::size_t changed = 0;
      for (std::size_t i = 0; i < contacts.size(); ++i) {
        const Outcome<S> alone = solved_alone(contacts[i], law);
        ASSERT_TRUE(same_bits(outcomes.at(i), alone)) << name_of(set) << ' ' << name_of(law) << " contact " << i;
        changed += same_bits(alone, unchanged(contacts[i])) ? 0 : 1;
      }
      EXPECT_GT(changed, contacts.size() / 2);
    }
  }
}

/// Packs of spheres alone, of bodies that are not slender, and of others take different code. Zeros keep their signs.
TYPED_TEST(Batch, GivesASphereTheSameBitsBesideAnyNeighbour) {
  using S = TypeParam;
  const auto contacts_of = [](std::string_view family) {
    std::vector<Contact<S>> contacts;
    for (std::uint64_t i = 0; i < 64; ++i) {
      contacts.push_back(make_contact<S>(unit::case_of(family, i).collision));
      if (i % 2 == 0) {
        for (ContactBody<S>* body : {&contacts.back().a, &contacts.back().b}) {
          body->velocity[static_cast<Eigen::Index>(i / 2 % 3)] = -S(0);
          body->angular_velocity.setConstant(-S(0));
        }
      }
    }
    return contacts;
  };
  const auto spheres = contacts_of("collinear_spheres");
  constexpr std::size_t widest = 64 / sizeof(S);
  for (const auto& [family, run] : {std::pair{"generic", std::size_t{1}}, std::pair{"generic", widest},
                                    std::pair{"physical", std::size_t{1}}, std::pair{"needle_tip", std::size_t{1}}}) {
    const auto general = contacts_of(family);  // alternate with the spheres in runs
    std::vector<Contact<S>> contacts;
    for (std::size_t i = 0; i < 2 * spheres.size(); ++i) {
      const std::size_t k = i / (2 * run) * run + i % run;
      contacts.push_back(i / run % 2 == 0 ? spheres[k] : general[k]);
    }
    const ContactBatch<S> batch = batch_of(contacts);
    for (const InstructionSet set : available_instruction_sets()) {
      for (const Law law : laws_with_truth) {
        OutcomeBatch<S> outcomes(batch.size());
        solve(batch, law, outcomes, set);
        for (std::size_t i = 0; i < batch.size(); ++i) {
          ASSERT_TRUE(same_bits(outcomes.at(i), solved_alone(contacts[i], law)))
              << name_of(set) << ' ' << name_of(law) << ' ' << family << " contact " << i << " in runs of " << run;
        }
      }
    }
  }
}

/// Arrays of `length` numbers from index `offset` on, between guards. A solver must not change the guards.
template <class S>
struct Guarded {
  static constexpr S guard = S(12345);

  Guarded(std::size_t arrays, std::size_t length_of_each, std::size_t begin)
      : memory(arrays, std::vector<S>(length_of_each + begin + 32, guard)), length(length_of_each), offset(begin) {}

  std::span<S> operator[](std::size_t k) { return std::span<S>(memory[k]).subspan(offset, length); }
  [[nodiscard]] bool guards_stand() const {
    for (const std::vector<S>& array : memory) {
      for (std::size_t i = 0; i < array.size(); ++i) {
        if ((i < offset || i >= offset + length) && array[i] != guard) {
          return false;
        }
      }
    }
    return true;
  }

  std::vector<std::vector<S>> memory;
  std::size_t length;
  std::size_t offset;
};

TYPED_TEST(Batch, AcceptsEveryLengthAndAlignment) {
  using S = TypeParam;
  constexpr std::size_t widest = 64 / sizeof(S);
  const auto contacts = mixed_contacts<S>(2 * widest + 1);
  for (const InstructionSet set : available_instruction_sets()) {
    for (const Law law : laws_with_truth) {
      for (std::size_t length = 0; length <= contacts.size(); ++length) {
        for (const std::size_t offset : {0U, 1U, 3U, 8U}) {
          Guarded<S> in(contact_number_count, length, offset);
          Guarded<S> out(outcome_number_count, length, offset + 1);
          for (std::size_t i = 0; i < length; ++i) {
            write_contact(contacts[i], [&](std::size_t k, const S& number) { in[k][i] = number; });
          }
          const auto arrays = detail::arrays_over<ContactArrays<S>>(in);
          solve(read_only(arrays), law, detail::arrays_over<OutcomeArrays<S>>(out), set);
          for (std::size_t i = 0; i < length; ++i) {
            const auto outcome = outcome_of<S>([&](std::size_t k) { return out[k][i]; });
            ASSERT_TRUE(same_bits(outcome, solved_alone(contacts[i], law)))
                << name_of(set) << " length " << length << " offset " << offset << " contact " << i;
          }
          ASSERT_TRUE(in.guards_stand() && out.guards_stand()) << name_of(set) << " length " << length;
        }
      }
    }
  }
}

TYPED_TEST(Batch, MayReplaceTheVelocitiesThatItReads) {
  using S = TypeParam;
  const auto contacts = mixed_contacts<S>(101);
  for (const InstructionSet set : available_instruction_sets()) {
    for (const Law law : laws_with_truth) {
      ContactBatch<S> batch = batch_of(contacts);
      const ContactArrays<S> arrays = batch.arrays();
      solve(read_only(arrays), law,
            {{arrays.a.velocity, arrays.a.angular_velocity}, {arrays.b.velocity, arrays.b.angular_velocity}}, set);
      for (std::size_t i = 0; i < contacts.size(); ++i) {
        ASSERT_TRUE(same_bits(unchanged(batch.at(i)), solved_alone(contacts[i], law))) << name_of(set) << ' ' << i;
      }
    }
  }
}

/// Like the scalar solver, a pack must keep a pivot that is NaN.
TYPED_TEST(Batch, BoundsEachNumberFromBelowAsTheScalarDoes) {
  using S = TypeParam;
  constexpr S nan = std::numeric_limits<S>::quiet_NaN();
  constexpr S infinity = std::numeric_limits<S>::infinity();
  for (const S least : {S(0), S(1), infinity, nan}) {
    for (const S number : {S(-1), S(-0.0), S(0), S(0.5), S(1), S(2), -infinity, infinity, nan}) {
      const S scalar = at_least(least, number);
      const Pack<S> pack = at_least(Pack<S>(least), Pack<S>(number));
      EXPECT_TRUE(same_bits<S>(scalar, pack[0])) << least << ' ' << number;
      EXPECT_TRUE(same_bits<S>(scalar, number < least ? least : number)) << least << ' ' << number;
    }
  }
}

TEST(ContactBatch, BeginsEachArrayAtACacheLine) {
  for (const std::size_t size : {1U, 7U, 64U, 1000U}) {
    ContactBatch<float> batch(size);
    ContactArrays<float> arrays = batch.arrays();
    for_each_array(arrays, [&](const std::span<float>& array) {
      EXPECT_EQ(array.size(), size);
      EXPECT_EQ(reinterpret_cast<std::uintptr_t>(array.data()) % 64, 0U);
    });
  }
}

/// A solver uses the numbers of a contact and of its outcome together. So the addresses of these numbers modulo a page
/// lie in different cache lines.
TEST(ContactBatch, KeepsApartWithinPagesWhatIsReadAndWrittenTogether) {
  constexpr std::uintptr_t page = 4096;
  for (const std::size_t size : {1U, 64U, 256U, 1000U, 4096U}) {
    ContactBatch<double> contacts(size);
    OutcomeBatch<double> outcomes(size);
    std::set<std::uintptr_t> lines;
    for (std::size_t k = 0; k < contact_number_count; ++k) {
      lines.insert(reinterpret_cast<std::uintptr_t>(std::as_const(contacts).begin_of(k)) % page / 64);
    }
    for (std::size_t k = 0; k < outcome_number_count; ++k) {
      lines.insert(reinterpret_cast<std::uintptr_t>(outcomes.begin_of(k)) % page / 64);
    }
    EXPECT_EQ(lines.size(), contact_number_count + outcome_number_count) << size;
  }
}

TEST(ContactBatch, IsNotSolvedForAnotherSizeALawWithoutSolverOrAnAbsentInstructionSet) {
  ContactBatch<double> contacts(3);
  OutcomeBatch<double> outcomes(3);
  OutcomeBatch<double> shorter(2);
  EXPECT_THROW(solve(contacts, Law::any, outcomes), std::invalid_argument);
  EXPECT_THROW(solve(contacts, Law::reflection, shorter), std::invalid_argument);
  EXPECT_THROW(solve(std::as_const(contacts).arrays(), Law::reflection, shorter.arrays()), std::invalid_argument);
  for (const InstructionSet set : all_instruction_sets) {
    if (!is_available(set)) {
      EXPECT_THROW(solve(contacts, Law::reflection, outcomes, set), std::invalid_argument) << name_of(set);
    }
  }
  EXPECT_TRUE(is_available(InstructionSet::baseline));
  EXPECT_TRUE(is_available(best_instruction_set()));
}

}  // namespace
}  // namespace carom::impulse
