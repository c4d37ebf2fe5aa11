// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <functional>
#include <set>
#include <string>
#include <vector>

/// The licences of CGAL's headers. Some are under the LGPL, others under the GPL. Code under BSL-1.0 may include only
/// headers under the LGPL.
namespace carom::header_licences {

struct CompiledObject {
  std::string file;                  // relative to the build directory
  std::vector<std::string> sources;  // the compiled file and every file that it includes
};

/// The objects that `ninja -t deps` lists.
[[nodiscard]] std::vector<CompiledObject> objects_of(const std::string& listing);

/// "carom_rational" of "oracles/CMakeFiles/carom_rational.dir/exact/rational.cpp.o".
[[nodiscard]] std::string target_of(const std::string& object);

[[nodiscard]] bool is_of_cgal(const std::string& header);

/// The reason why code under BSL-1.0 must not include a header with this text: a GPL tag, or no tag. Empty if there is
/// no reason.
[[nodiscard]] std::string licence_offence(const std::string& text);

/// One line for each included header of CGAL with an offence. `read` returns the text of a header. The targets below
/// tests/ named in `gpl_test_programs` may include any header.
[[nodiscard]] std::vector<std::string> header_offences(const std::vector<CompiledObject>& objects,
                                                       const std::set<std::string>& gpl_test_programs,
                                                       const std::function<std::string(const std::string&)>& read);

}  // namespace carom::header_licences
