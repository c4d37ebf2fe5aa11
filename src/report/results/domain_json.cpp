// SPDX-License-Identifier: BSL-1.0
#include <stdexcept>

#include <carom/report/results/domain_json.hpp>

namespace carom::report {

using nlohmann::json;

json Json<properties::Domain>::write(const properties::Domain& domain) {
  json record = json::object();
  for (const properties::LimitedQuantity quantity : properties::all_limited_quantities) {
    const properties::Range& range = domain.ranges[quantity];
    const properties::Range whole = properties::whole_range(quantity);
    if (range != whole) {
      record[std::string(name_of(quantity))] = {range.least == whole.least ? json() : json(range.least),
                                                range.most == whole.most ? json() : json(range.most)};
    }
  }
  return record;
}

properties::Domain Json<properties::Domain>::read(const Field& field) {
  properties::Domain domain;
  for (const auto& [name, of_quantity] : field.members()) {
    const std::optional<properties::LimitedQuantity> quantity = properties::quantity_named(name);
    if (!quantity) {
      of_quantity.fail("no field of this name, because no quantity has it");
    }
    const std::vector<Field> ends = of_quantity.elements();
    if (ends.size() != 2) {
      of_quantity.fail("two numbers, the least and the greatest value; null for no limit");
    }
    try {
      properties::set_range(domain, *quantity, ends[0].optional_number(), ends[1].optional_number());
    } catch (const std::invalid_argument& error) {
      throw FormatError(of_quantity.place(), error.what());
    }
  }
  return domain;
}

}  // namespace carom::report
