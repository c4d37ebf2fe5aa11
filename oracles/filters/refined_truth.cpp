// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>

#include <carom/oracles/filters/refined_truth.hpp>
#include <carom/oracles/models/models.hpp>

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
  for (const OutcomeVector k : all_outcome_vectors) {
    *into[k] =
        *vectors(units[0])[k] * impulse[0] + *vectors(units[1])[k] * impulse[1] + *vectors(units[2])[k] * impulse[2];
  }
  return answer;
}

Truth<Enclosure> refined_truth(const Collision& collision, const BasicCollision<Enclosure>& enclosed,
                               const BasicCollision<Approximation>& approximate, Model model,
                               const ApproximateResponse& approximate_response) {
  const auto middle = [](const auto& x) { return x.middle(); };
  const Vector3<Enclosure> wanted = wanted_change(enclosed, model);
  const Matrix3<double> matrix = approximate_response.matrix.unaryExpr(middle);
  const Vector3<double> first = impulse_for<double>(collision, model, wanted.unaryExpr(middle), &matrix);
  return with_law(model, [&]<class Law>(Law) -> Truth<Enclosure> {
    const Vector3<Enclosure> impulse = Law::permitted(enclosed, first);
    const Outcome<Enclosure> answer = response<Enclosure>(enclosed, impulse);
    const Vector3<Enclosure> rest =
        Law::asked_for(enclosed.normal, wanted - relative_velocity<Enclosure>(enclosed, answer));
    const Vector3<Approximation> second = Law::template impulse_for<Approximation>(
        approximate, rest.unaryExpr(&approximation_of), &approximate_response.matrix);
    const Outcome<Enclosure> correction = map_outcome<Enclosure>(approximate_response(second), &enclosure_of);
    return {impulse + second.unaryExpr(&enclosure_of), sum(sum(unchanged(enclosed), answer), correction)};
  });
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
