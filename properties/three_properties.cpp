// SPDX-License-Identifier: BSL-1.0
#include <algorithm>
#include <array>
#include <exception>
#include <utility>

#include <carom/collision/validate.hpp>
#include <carom/properties/diagnosis/known_case.hpp>
#include <carom/properties/diagnosis/plain_faults.hpp>
#include <carom/properties/diagnosis/where.hpp>
#include <carom/properties/draws/stream.hpp>
#include <carom/properties/gate/in_words.hpp>
#include <carom/properties/gate/trial.hpp>
#include <carom/properties/three_properties.hpp>

namespace carom::properties {

std::span<const Property> three_properties() {
  static const std::array all{
      Property{"non_penetrating_post_velocity",
               "Non-penetrating post-velocity",
               "After the impulse, the bodies do not approach at the contact: N·V⁺ ≥ 0.",
               {"non_penetration"}},
      Property{"positive_definiteness",
               "Positive definiteness of C",
               "The collision matrix C of a contact with a movable body is symmetric, and λI ⪯ C with λ = 1/m_A + "
               "1/m_B > 0. It is the matrix of the solve: C F = V⁺ − V⁻.",
               {"definite", "matrix_used"}},
      Property{"momentum_conservation",
               "Momentum conservation",
               "One body gains the linear momentum that the other loses. The change of each body's angular momentum is "
               "the moment of its impulse, so the angular momentum about every point is conserved.",
               {"linear_momentum", "angular_momentum"}}};
  return all;
}

namespace {

const Property& property_named(std::string_view name) {
  return *std::ranges::find(three_properties(), name, &Property::name);
}

/// The law `any` with the invariants for which `is_claimed` returns true.
template <class IsClaimed>
Claim claim_of(const PropertyOptions& options, Precision precision, const IsClaimed& is_claimed) {
  Claim claim;
  claim.yardstick = oracles::Yardstick::of(precision, limits_with(options.limit_ulps, options.digits));
  claim.within = domain_from(options.within);
  claim.effects = with_named_effects({}, options.effects);
  require_valid(claim.effects, claim.law);
  for (const Invariant& invariant : all_invariants()) {
    if (is_claimed(invariant)) {
      claim.invariants.push_back(&invariant);
    }
  }
  return claim;
}

Claim claim_of(const Property& property, const PropertyOptions& options, Precision precision) {
  return claim_of(options, precision, [&](const Invariant& invariant) {
    return std::ranges::find(property.invariants, invariant.name) != property.invariants.end();
  });
}

NamedVerdict outside(std::string why) { return {nullptr, {.status = Status::skipped, .detail = std::move(why)}}; }

/// The verdict of the first invariant that is violated. If none is, that of one that holds, if one does.
NamedVerdict verdict_on(const Claim& claim, const Collision& collision, const ReportedOutcome& answer) {
  if (const auto name = name_outside(claim.within, collision)) {
    return outside("the collision is outside of the domain, by its " + std::string(*name));
  }
  const JudgedCase judged_case(Case{collision}, claim.yardstick.filtered(), claim.effects);
  if (!judged_case.is_valid()) {
    return outside("the collision is not valid");
  }
  const Invariant* const first = claim.invariants.front();
  if (!oracles::is_finite(answer)) {
    return {first, {.status = Status::violated, .detail = "the answer contains infinities or NaN"}};
  }
  const Judgement judgement = judge_answer(judged_case, claim, lift(answer));
  if (judgement.unjudged) {
    return outside("not judged: " + std::string(in_words(*judgement.unjudged)));
  }
  NamedVerdict found = outside("no invariant applies");
  for (const NamedVerdict& named : judgement.verdicts) {
    if (named.verdict.status == Status::violated) {
      return named;
    }
    found = found.verdict.status == Status::holds ? found : named;
  }
  return found;
}

/// Collisions of the same bodies at the same contact, with other velocities. Numbers that are zero stay zero. In half
/// of the collisions, all velocities keep their directions.
std::vector<Collision> neighbours_of(const Collision& collision) {
  constexpr std::uint64_t count = 24;
  std::vector<Collision> all;
  for (std::uint64_t index = 0; index < count; ++index) {
    Stream stream = case_stream(1, "neighbours", index);
    const auto factor = [&] { return stream.between(0.5, 1.5); };
    const double of_all = factor();
    Collision& changed = all.emplace_back(collision);
    for (Body* body : {&changed.a, &changed.b}) {
      for (Vector3<double>* vector : {&body->velocity, &body->angular_velocity}) {
        for (double& x : *vector) {
          x *= index % 2 == 0 ? of_all : factor();
        }
      }
    }
  }
  return all;
}

bool are_same(const ReportedOutcome& first, const ReportedOutcome& again) {
  const auto& about = std::get<AboutSession>(invariant_named("memoryless")->about);
  return about.check(first, again, Sameness::of_bits).status == Status::holds;
}

/// The invariants of one outcome of any law, without those of the matrix.
bool is_of_outcome(const Invariant& invariant) {
  return std::holds_alternative<AboutOutcome>(invariant.about) && invariant.claimed_for(Law::any);
}

/// The answers that violate the property: this one, and those to its neighbours.
std::vector<ViolatedCase> violated_near(const detail::PropertyAnswer& answered, const Claim& claim,
                                        const detail::Ask& ask) {
  std::vector<ViolatedCase> violated{{0, Case{answered.collision}, answered.answer}};
  for (const Collision& neighbour : neighbours_of(answered.collision)) {
    if (!contains(claim.within, neighbour) || !validate(neighbour).empty()) {
      continue;  // the solver need not answer it
    }
    const ReportedOutcome answer = ask(neighbour);
    if (verdict_on(claim, neighbour, answer).verdict.status == Status::violated) {
      violated.push_back({violated.size(), Case{neighbour}, answer});
    }
  }
  return violated;
}

/// The faults that outcomes of finite numbers show.
std::vector<diagnosis::Fault> faults_of_outcomes(std::vector<ViolatedCase> violated, const Claim& claim,
                                                 const detail::PropertyAnswer& answered,
                                                 const PropertyOptions& options) {
  const auto outcome_of = [](const ViolatedCase& one) -> const ReportedOutcome& {
    return std::get<ReportedOutcome>(one.answer);
  };
  const Claim others = claim_of(options, answered.precision, is_of_outcome);
  const auto is_right_but_for_matrix = [&](const ViolatedCase& one) {
    return outcome_of(one).collision_matrix &&
           verdict_on(others, one.one.collision, outcome_of(one)).verdict.status != Status::violated;
  };
  if (claim.invariants.front()->is_of_matrix()) {
    const bool is_another =
        verdict_on(claim, answered.collision, answered.answer).invariant == invariant_named("matrix_used");
    const auto kind = is_another ? diagnosis::MatrixFault::another : diagnosis::MatrixFault::out_of_bounds;
    return std::ranges::all_of(violated, is_right_but_for_matrix) ? std::vector{diagnosis::fault_of_matrix(kind)}
                                                                  : std::vector<diagnosis::Fault>();
  }
  diagnosis::NarrowAnswers narrow;
  for (const ViolatedCase& one : violated) {
    narrow.add(one.one.collision,
               map_outcome<double>(outcome_of(one), [](long double x) { return static_cast<double>(x); }));
  }
  if (answered.precision != Precision::binary32 && narrow.are_binary32()) {
    return {narrow.fault(answered.precision)};
  }
  Subject subject;
  subject.effects = claim.effects;
  std::ranges::transform(violated, violated.begin(),
                         [&](const ViolatedCase& one) { return diagnosis::without_effects(one, subject); });
  return {diagnosis::fault_of(violated, claim.law)};
}

std::vector<diagnosis::Fault> faults_of(const detail::PropertyAnswer& answered, const PropertyOptions& options,
                                        const detail::Ask& ask) {
  if (!are_same(answered.answer, ask(answered.collision))) {
    return {diagnosis::fault_of_memory()};
  }
  const Claim claim = claim_of(property_named(answered.property), options, answered.precision);
  std::vector<ViolatedCase> violated = violated_near(answered, claim, ask);
  std::vector<diagnosis::Fault> faults;
  for (const diagnosis::FaultOfKind& one : diagnosis::faults_without_outcome(violated)) {
    faults.push_back(one.fault);
  }
  std::erase_if(violated,
                [](const ViolatedCase& one) { return properties::kind_of(one.answer) != AnswerKind::outcome; });
  if (violated.size() >= diagnosis::least_violated) {
    const std::vector<diagnosis::Fault> of_outcomes = faults_of_outcomes(std::move(violated), claim, answered, options);
    faults.insert(faults.end(), of_outcomes.begin(), of_outcomes.end());
  }
  return faults;
}

}  // namespace

namespace detail {

Ruling ruling(const PropertyAnswer& answered, const PropertyOptions& options) try {
  const Property& property = property_named(answered.property);
  const Claim claim = claim_of(property, options, answered.precision);
  const auto [invariant, verdict] = verdict_on(claim, answered.collision, answered.answer);
  if (verdict.status != Status::violated) {
    return {true, verdict.status == Status::holds, verdict.detail};
  }
  return {false, true,
          std::string(property.title) + ": " + std::string(invariant->name) + " is violated.\n" +
              violation_in_words(answered.collision, answered.answer, verdict)};
} catch (const oracles::JudgeError& error) {
  throw oracles::JudgeError(properties::in_words(error), error.collision());  // a property shows what() alone
}

std::string diagnosed(const PropertyAnswer& answered, const PropertyOptions& options, const Ask& ask) {
  constexpr std::size_t most_lines = 9;  // after the heading
  try {
    const std::vector<diagnosis::Fault> faults = faults_of(answered, options, ask);
    return faults.empty() ? ""
                          : "  The diagnosis, of this collision and of others with the same bodies:\n" +
                                diagnosis::in_words(faults, "    ", most_lines);
  } catch (const std::exception& error) {
    return std::string("  No diagnosis: ") + error.what() + '\n';
  }
}

}  // namespace detail

}  // namespace carom::properties
