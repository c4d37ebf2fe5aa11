// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <carom/oracles/approximation.hpp>
#include <carom/oracles/enclosure.hpp>
#include <carom/oracles/truth.hpp>

namespace carom::oracles {

/// The number as an approximation, with what it is not known to.
[[nodiscard]] inline Approximation approximation_of(const Enclosure& x) {
  return (Approximation(x.middle()) + Approximation(x.lower_part())).widened_by(x.radius());
}

[[nodiscard]] inline Enclosure enclosure_of(const Approximation& x) {
  return Enclosure(x.middle()).widened_by(x.radius());
}

/// How a collision answers to impulses, approximately.
struct ApproximateResponse {
  explicit ApproximateResponse(const BasicCollision<Approximation>& collision)
      : units(unit_responses(collision)), matrix(response_matrix<Approximation>(collision, units)) {}

  /// The change of all velocities, by superposition.
  [[nodiscard]] Outcome<Approximation> operator()(const Vector3<Approximation>& impulse) const {
    Outcome<Approximation> answer;
    const auto into = vectors(answer);
    for (std::size_t k = 0; k < into.size(); ++k) {
      *into[k] =
          *vectors(units[0])[k] * impulse[0] + *vectors(units[1])[k] * impulse[1] + *vectors(units[2])[k] * impulse[2];
    }
    return answer;
  }

  std::array<Outcome<Approximation>, 3> units;
  Matrix3<Approximation> matrix;
};

/// The law's answer to a contact that collides, to about 100 bits, at a small part of the cost: one step of iterative
/// refinement (J. Wilkinson), with bounds. Any impulse F̂ that the law permits leaves the change ΔV − K F̂ to be made up
/// for; F is F̂ and the impulse for that, exactly, so that F̂ needs no bound, and the second impulse, smaller by the
/// precision of binary64, no more than that of approximations. Preconditions: as of impulse_for.
[[nodiscard]] inline Truth<Enclosure> refined_truth(const Collision& collision,
                                                    const BasicCollision<Enclosure>& enclosed,
                                                    const BasicCollision<Approximation>& approximate, Model model,
                                                    const ApproximateResponse& approximate_response) {
  const auto middle = [](const auto& x) { return x.middle(); };
  const auto exactly = [](double x) { return Enclosure(x); };
  const Vector3<Enclosure> wanted = wanted_change(enclosed);
  const Matrix3<double> matrix = approximate_response.matrix.unaryExpr(middle);
  const Vector3<double> first = impulse_for<double>(collision, model, wanted.unaryExpr(middle), &matrix);
  const Vector3<Enclosure>& n = enclosed.normal;
  // Of the frictionless law along the normal, exactly.
  const Vector3<Enclosure> impulse =
      model == Model::frictionless
          ? Vector3<Enclosure>(n * exactly(collision.normal.dot(first) / collision.normal.squaredNorm()))
          : Vector3<Enclosure>(first.unaryExpr(exactly));
  const Outcome<Enclosure> answer = response<Enclosure>(enclosed, impulse);
  Vector3<Enclosure> rest = wanted - relative_velocity<Enclosure>(enclosed, answer);
  if (model == Model::frictionless) {
    // What is along the normal is small, the rest is not and is not asked for.
    rest = n * Enclosure(n.dot(rest) / n.dot(n));
  }
  const Vector3<Approximation> second =
      impulse_for<Approximation>(approximate, model, rest.unaryExpr(&approximation_of), &approximate_response.matrix);
  const Outcome<Enclosure> correction = map_outcome<Enclosure>(approximate_response(second), &enclosure_of);
  return {impulse + second.unaryExpr(&enclosure_of), sum(sum(unchanged(enclosed), answer), correction)};
}

/// Whether every number has a bound.
[[nodiscard]] inline bool is_bounded(const Truth<Enclosure>& truth) {
  bool bounded = true;
  for (const Vector3<Enclosure>* vector : vectors(truth.outcome)) {
    for (int i = 0; i < 3; ++i) {
      bounded = bounded && std::isfinite((*vector)[i].radius());
    }
  }
  return bounded;
}

}  // namespace carom::oracles
