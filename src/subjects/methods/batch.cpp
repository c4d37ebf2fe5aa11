// SPDX-License-Identifier: BSL-1.0
#include <carom/impulse/batch/solve.hpp>
#include <carom/subjects/methods/method_groups.hpp>
#include <carom/subjects/methods/solver_method.hpp>

namespace carom::subjects {
namespace {

template <class S>
impulse::ContactBatch<S> batch_of(std::span<const Collision> collisions) {
  impulse::ContactBatch<S> batch(collisions.size());
  for (std::size_t i = 0; i < collisions.size(); ++i) {
    batch.set(i, impulse::make_contact<S>(collisions[i]));
  }
  return batch;
}

/// Answers the collisions of one call as one batch.
template <class S>
std::vector<Answer> answers_of(std::span<const Collision> collisions, Law law) {
  std::vector<Answer> answers(collisions.size());
  std::vector<std::size_t> valid;  // indices
  valid.reserve(collisions.size());
  for (std::size_t i = 0; i < collisions.size(); ++i) {
    const std::vector<InputError> errors = validate(collisions[i]);
    if (errors.empty()) {
      valid.push_back(i);
    } else {
      answers[i] = Refused{describe(errors)};
    }
  }
  impulse::ContactBatch<S> contacts(valid.size());
  for (std::size_t lane = 0; lane < valid.size(); ++lane) {
    contacts.set(lane, impulse::make_contact<S>(collisions[valid[lane]]));
  }
  impulse::OutcomeBatch<S> outcomes(valid.size());
  impulse::solve(contacts, law, outcomes);
  for (std::size_t lane = 0; lane < valid.size(); ++lane) {
    write_reported<S>(outcomes.at(lane), std::get<ReportedOutcome>(answers[valid[lane]]));
  }
  return answers;
}

template <class S>
Method batch_method(Law law) {
  Method method;
  Subject& subject = method.subject;
  subject.name = std::string(name_of(law)) + "-batch-" + std::string(scalar_type<S>.in_name);
  method.form = MethodForm::batch;
  method.scalar = scalar_type<S>;
  const std::string source(impulse::description_of(law).source);
  subject.summary =
      description_in_words(law) + (source.empty() ? "" : ", " + source) + ", in packs with one contact per lane";
  subject.law = law;
  subject.precision = precision_of<S>;
  subject.open = [law] {
    return [law](std::span<const Collision> collisions) { return answers_of<S>(collisions, law); };
  };
  method.prepare = [law](std::span<const Collision> collisions) -> Kernel {
    auto contacts = std::make_shared<const impulse::ContactBatch<S>>(batch_of<S>(collisions));
    auto outcomes = std::make_shared<impulse::OutcomeBatch<S>>(collisions.size());
    return [law, contacts, outcomes] { impulse::solve(*contacts, law, *outcomes); };
  };
  return method;
}

template <class S>
void add_batch_methods(std::vector<Method>& methods) {
  for (const Law law : laws_with_truth) {
    methods.push_back(batch_method<S>(law));
  }
}

}  // namespace

std::vector<Method> batch_methods() {
  std::vector<Method> methods;
  add_batch_methods<float>(methods);
  add_batch_methods<double>(methods);
  return methods;
}

}  // namespace carom::subjects
