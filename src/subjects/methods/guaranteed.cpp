// SPDX-License-Identifier: BSL-1.0
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
        {std::string(name_of(model)) + "-guaranteed", description_in_words(model) + ", the exact N·V⁺ never negative",
         model},
        [](const Collision& collision) {
          return Posed{collision, impulse::make_contact<double>(collision)};
        },
        [law](const Posed& posed) {
          return impulse::guaranteed(posed.collision, posed.contact, [&](const impulse::Contact<double>& contact) {
            return impulse::apply_impulse(contact, law(contact));
          });
        });
  });
  return method;
}

}  // namespace

std::vector<Method> guaranteed_methods() {
  std::vector<Method> methods;
  for (const Model model : models_with_truth) {
    methods.push_back(guaranteed_method(model));
  }
  return methods;
}

}  // namespace carom::subjects
