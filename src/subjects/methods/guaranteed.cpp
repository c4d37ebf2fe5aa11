// SPDX-License-Identifier: BSL-1.0
#include <utility>

#include <carom/impulse/guaranteed.hpp>
#include <carom/impulse/laws.hpp>
#include <carom/subjects/methods/groups.hpp>
#include <carom/subjects/methods/solver_method.hpp>

namespace carom::subjects {
namespace {

struct Posed {
  Collision collision;
  impulse::Contact<double> contact;
};

Method guaranteed_method(Model model) {
  Method method;
  impulse::with_law(model, [&](const auto& law) {
    method = method_of<double>(
        {std::string(name_of(model)) + "-guaranteed",
         description_in_words(model) + "; the exact N·V⁺ is never negative", model, model != Model::frictionless},
        [](const Collision& collision) {
          return Posed{collision, impulse::make_contact<double>(collision)};
        },
        [law](const Posed& posed, const auto& see) {
          const auto seen_law = [&](const impulse::Contact<double>& contact, const auto&... approach) {
            if constexpr (sizeof...(approach) == 0) {
              return law(contact, impulse::normal_velocity(contact), see);
            } else {
              return law(contact, approach..., see);
            }
          };
          return impulse::guaranteed(posed.collision, posed.contact, seen_law);
        });
  });
  method.form = MethodForm::guaranteed;
  return method;
}

}  // namespace

std::vector<Method> guaranteed_methods() {
  std::vector<Method> methods;
  for (const Model model : models_with_truth) {
    Method method = guaranteed_method(model);
    methods.push_back(
        model == Model::sticking
            ? expected_to_fail(
                  std::move(method),
                  "removing the last ulp of approach loses small momenta, in about one of 10⁴ cases of `structured`")
            : std::move(method));
  }
  return methods;
}

}  // namespace carom::subjects
