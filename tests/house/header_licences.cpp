// SPDX-License-Identifier: BSL-1.0
#include "header_licences.hpp"

#include <cstddef>
#include <map>
#include <sstream>

namespace carom::header_licences {

std::vector<CompiledObject> objects_of(const std::string& listing) {
  std::vector<CompiledObject> objects;
  std::istringstream lines(listing);
  for (std::string line; std::getline(lines, line);) {
    const std::size_t begin = line.find_first_not_of(' ');
    const std::size_t colon = line.find(": #deps ");
    if (begin == 0 && colon != std::string::npos) {
      objects.push_back({line.substr(0, colon), {}});
    } else if (begin != 0 && begin != std::string::npos && !objects.empty()) {
      objects.back().sources.push_back(line.substr(begin));
    }
  }
  return objects;
}

std::string target_of(const std::string& object) {
  const std::string folder = "CMakeFiles/";
  const std::size_t begin = object.rfind(folder);
  const std::size_t end = object.find(".dir/", begin == std::string::npos ? 0 : begin);
  return begin == std::string::npos || end == std::string::npos
             ? std::string()
             : object.substr(begin + folder.size(), end - begin - folder.size());
}

bool is_of_cgal(const std::string& header) { return header.find("/CGAL/") != std::string::npos; }

std::string licence_offence(const std::string& text) {
  const std::string tag = "SPDX-License-Identifier:";
  bool has_tag = false;
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) {
    const std::size_t begin = line.find(tag);
    if (begin == std::string::npos) {
      continue;
    }
    has_tag = true;
    std::istringstream words(line.substr(begin + tag.size()));
    for (std::string word; words >> word;) {
      word.erase(0, word.find_first_not_of('('));
      if (word.starts_with("GPL") || word.starts_with("AGPL")) {
        return "is under " + word;
      }
    }
  }
  return has_tag ? "" : "names no licence";
}

std::vector<std::string> header_offences(const std::vector<CompiledObject>& objects,
                                         const std::set<std::string>& gpl_test_programs,
                                         const std::function<std::string(const std::string&)>& read) {
  std::map<std::string, std::string> includers;  // for each header of CGAL, the first object that includes it
  for (const CompiledObject& object : objects) {
    if (object.file.starts_with("tests/") && gpl_test_programs.contains(target_of(object.file))) {
      continue;
    }
    for (const std::string& source : object.sources) {
      if (is_of_cgal(source)) {
        includers.try_emplace(source, object.file);
      }
    }
  }
  std::vector<std::string> offences;
  for (const auto& [header, object] : includers) {
    if (const std::string why = licence_offence(read(header)); !why.empty()) {
      std::string& offence = offences.emplace_back(header);
      offence.append(" ").append(why).append(", and ").append(object).append(" includes it");
    }
  }
  return offences;
}

}  // namespace carom::header_licences
