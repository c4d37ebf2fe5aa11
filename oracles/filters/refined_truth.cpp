// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>
#include <cstddef>

#include <carom/oracles/filters/refined_truth.hpp>

namespace carom::oracles {

Approximation approximation_of(const Enclosure& x) {
  return (Approximation(x.middle()) + Approximation(x.lower_part())).widened_by(x.radius());
}

Enclosure enclosure_of(const Approximation& x) { return Enclosure(x.middle()).widened_by(x.radius()); }

ApproximateResponse::ApproximateResponse(const BasicCollision<Approximation>& collision)
    : units(unit_responses(collision)), matrix(response_matrix<Approximation>(collision, units)) {}

Outcome<Approximation> ApproximateResponse::operator()(const Vector3<Approximation>& impulse) const {
  Outcome<Approximation> answer;
  const auto into = vectors(answer);
  for (std::size_t k = 0; k < into.size(); ++k) {
    *into[k] =
        *vectors(units[0])[k] * impulse[0] + *vectors(units[1])[k] * impulse[1] + *vectors(units[2])[k] * impulse[2];
  }
  return answer;
}

Truth<Enclosure> refined_truth(const Collision& collision, const BasicCollision<Enclosure>& enclosed,
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

bool is_bounded(const Truth<Enclosure>& truth) {
  bool bounded = true;
  for (const Vector3<Enclosure>* vector : vectors(truth.outcome)) {
    for (int i = 0; i < 3; ++i) {
      bounded = bounded && std::isfinite((*vector)[i].radius());
    }
  }
  return bounded;
}

}  // namespace carom::oracles
