// SPDX-License-Identifier: BSL-1.0
#include <cstdio>
#include <cstdlib>
#include <sstream>
#include <string>

#include "planted_together.hpp"

namespace {

using namespace carom::mutants;

/// The defects of "NAME+NAME".
Together named(const std::vector<KnownDefect>& known, const std::string& names) {
  Together together;
  std::istringstream from(names);
  for (std::string name; std::getline(from, name, '+');) {
    for (const KnownDefect& defect : known) {
      if (defect.mutant->name == name) {
        together.push_back(&defect);
      }
    }
  }
  return together;
}

std::vector<Together> drawn(const std::vector<KnownDefect>& known, std::uint64_t seed) {
  const std::vector<const KnownDefect*> frequent = frequent_defects(known);
  std::printf("%zu of %zu known defects violate at least 1 %% of the cases\n", frequent.size(), known.size());
  std::vector<Together> all = drawn_together(frequent, 2, 30, seed);
  for (Together& triple : drawn_together(frequent, 3, 10, seed)) {
    all.push_back(std::move(triple));
  }
  return all;
}

}  // namespace

/// Prints what the gate says of solvers with several known defects: "planted_together NAME+NAME…", or thirty pairs and
/// ten triples that the seed in the first argument draws.
int main(int argc, char** argv) {
  const std::vector<KnownDefect> known = known_defects();
  std::vector<Together> all;
  for (int i = 1; i < argc; ++i) {
    const std::string argument = argv[i];
    if (argument.find_first_not_of("0123456789") != std::string::npos) {
      all.push_back(named(known, argument));
    }
  }
  if (all.empty()) {
    all = drawn(known, argc > 1 ? std::strtoull(argv[1], nullptr, 10) : 1);
  }
  int sets[4] = {};
  int complete[4] = {};
  for (const Told& told : told_of(all)) {
    const std::size_t size = told.planted.size();
    const bool is_complete = told.named.size() == size;
    ++sets[size];
    complete[size] += is_complete ? 1 : 0;
    std::printf("%s %s; named: %s\n", is_complete ? "+" : "-", names_of(told.planted).c_str(),
                names_of(told.named).c_str());
    const std::size_t what = told.lines.find("what is wrong");
    std::printf("%s\n", what == std::string::npos ? "nothing" : told.lines.substr(what).c_str());
  }
  std::printf("%d of %d pairs and %d of %d triples have all their defects named\n", complete[2], sets[2], complete[3],
              sets[3]);
}
