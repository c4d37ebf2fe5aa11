// SPDX-License-Identifier: BSL-1.0
#include <limits>
#include <stdexcept>
#include <string>

#include <gtest/gtest.h>

#include <carom/collision/json/json.hpp>

#include "support/cases.hpp"
#include "support/message_of.hpp"

namespace carom {
namespace {

using nlohmann::json;

Collision through_text(const Collision& collision) {
  return collision_from_json(json::parse(collision_to_json(collision).dump()));
}

/// Any NaN equals any other NaN.
void expect_same(const Collision& left, const Collision& right, const std::string& what) {
  EXPECT_EQ(left.a.immovable, right.a.immovable) << what;
  EXPECT_EQ(left.b.immovable, right.b.immovable) << what;
  for_each_number(
      [&](const FieldPath& path, const double& x, const double& y) {
        EXPECT_TRUE(unit::same_bits(x, y) || (std::isnan(x) && std::isnan(y)))
            << what << ": " << path.text() << ": " << x << " became " << y;
      },
      left, right);
}

TEST(CollisionJson, RoundTripsEveryFamilyBitForBit) {
  for (const properties::Family& family : properties::all_families()) {
    for (std::uint64_t i = 0; i < 200; ++i) {
      const Collision collision = unit::case_of(family.name, i).collision;
      expect_same(collision, through_text(collision), std::string(family.name) + " " + std::to_string(i));
    }
  }
}

TEST(CollisionJson, RoundTripsTheEndsOfBinary64) {
  using Limits = std::numeric_limits<double>;
  for (const double x :
       {Limits::max(), Limits::min(), Limits::denorm_min(), -Limits::denorm_min(), -0.0, 0.1, 1e23, 9007199254740993.0,
        0x1.fffffffffffffp-1023, Limits::infinity(), -Limits::infinity(), Limits::quiet_NaN()}) {
    Collision collision;
    collision.a.velocity = {x, 1, -x};
    collision.restitution = x;
    expect_same(collision, through_text(collision), std::to_string(x));
  }
}

TEST(CollisionJson, WritesNaNAndInfinitiesAsStrings) {
  using Limits = std::numeric_limits<double>;
  EXPECT_EQ(number_to_json(Limits::quiet_NaN()), "nan");
  EXPECT_EQ(number_to_json(Limits::infinity()), "inf");
  EXPECT_EQ(number_to_json(-Limits::infinity()), "-inf");
  EXPECT_EQ(number_to_json(0.5), 0.5);
  EXPECT_TRUE(std::isnan(number_from_json("nan", "")));
  EXPECT_EQ(number_from_json("inf", ""), Limits::infinity());
  EXPECT_EQ(number_from_json("-inf", ""), -Limits::infinity());
  EXPECT_EQ(number_from_json(7, ""), 7.0);
}

TEST(CollisionJson, OmitsTheFieldsThatTheProtocolOmits) {
  Collision collision;
  collision.b.immovable = true;
  const json written = collision_to_json(collision);
  EXPECT_FALSE(written.contains("friction"));
  EXPECT_FALSE(written.contains("tangential_restitution"));
  EXPECT_FALSE(written.at("a").contains("immovable"));
  EXPECT_EQ(written.at("b").at("immovable"), true);
  for (const char* field : {"mass", "principal_inertia", "orientation"}) {
    EXPECT_TRUE(written.at("a").contains(field)) << field;
    EXPECT_FALSE(written.at("b").contains(field)) << field;
  }
  collision.friction = 0.25;
  collision.tangential_restitution = -0.5;
  EXPECT_EQ(collision_to_json(collision).at("friction"), 0.25);
  EXPECT_EQ(collision_to_json(collision).at("tangential_restitution"), -0.5);
}

json example() {
  return json::parse(R"({
    "a":{"mass":2.0,"principal_inertia":[0.8,0.7,0.5],"orientation":[1,0,0,0],
         "position":[0,1,0],"velocity":[0.3,-2,0],"angular_velocity":[0,0,1]},
    "b":{"immovable":true,"position":[0,0,0],"velocity":[0,0,0],"angular_velocity":[0,0,0]},
    "point":[0,0.25,0],"normal":[0,1,0],"restitution":0.5,"friction":0.0})");
}

TEST(CollisionJson, ReadsTheExampleOfTheProtocol) {
  const Collision c = collision_from_json(example());
  EXPECT_FALSE(c.a.immovable);
  EXPECT_EQ(c.a.mass, 2.0);
  EXPECT_EQ(c.a.principal_inertia, (Vector3<double>{0.8, 0.7, 0.5}));
  EXPECT_EQ(c.a.velocity, (Vector3<double>{0.3, -2, 0}));
  EXPECT_TRUE(c.b.immovable);
  EXPECT_EQ(c.point, (Vector3<double>{0, 0.25, 0}));
  EXPECT_EQ(c.restitution, 0.5);
}

TEST(CollisionJson, TakesTheDefaultsOfOptionalFields) {
  json record = example();
  record.at("a").erase("orientation");
  record.erase("friction");
  const Collision c = collision_from_json(record);
  EXPECT_EQ(c.a.orientation, (Quaternion<double>{1, 0, 0, 0}));
  EXPECT_EQ(c.friction, 0);
  EXPECT_EQ(c.tangential_restitution, 0);
}

/// The error message for the example after this change; "" if there is no error.
template <class Change>
std::string error_of(const Change& change, const std::string& place = {}) {
  json record = example();
  change(record);
  return unit::message_of<FormatError>([&] { return collision_from_json(record, place); });
}

TEST(CollisionJson, NamesAMissingField) {
  for (const char* field :
       {"/a/mass", "/a/principal_inertia", "/a/position", "/a/velocity", "/a/angular_velocity", "/b/position",
        "/b/velocity", "/b/angular_velocity", "/a", "/b", "/point", "/normal", "/restitution"}) {
    const json::json_pointer pointer(field);
    EXPECT_EQ(error_of([&](json& r) { r.at(pointer.parent_pointer()).erase(pointer.back()); }),
              std::string(field) + ": is missing; add this field");
  }
}

TEST(CollisionJson, NamesAFieldThatIsUnknownOrOfAnotherForm) {
  struct Row {
    const char* pointer;
    json value;
    const char* error;
  };
  for (const auto& [pointer, value, error] : std::vector<Row>{
           {"/resitution", 1,
            "/resitution: unknown field; expected one of a, b, point, normal, restitution, friction, "
            "tangential_restitution"},
           {"/a/spin", 1,
            "/a/spin: unknown field; expected one of immovable, mass, principal_inertia, orientation, position, "
            "velocity, angular_velocity"},
           {"/b/mass", 1, "/b/mass: unknown field; expected one of immovable, position, velocity, angular_velocity"},
           {"/a/mass", true, "/a/mass: expected a number, found true"},
           {"/a/mass", "2", "/a/mass: expected a number, found \"2\""},
           {"/a/mass", nullptr, "/a/mass: expected a number, found null"},
           {"/friction", json::array(), "/friction: expected a number, found []"},
           {"/normal/1", "up", "/normal/1: expected a number, found \"up\""},
           {"/point", 3, "/point: expected an array of 3 numbers, found 3"},
           {"/normal", {0, 1}, "/normal: expected an array of 3 numbers, found [0,1]"},
           {"/a/orientation", {1, 0, 0}, "/a/orientation: expected an array of 4 numbers, found [1,0,0]"},
           {"", 3, "/: expected an object, found 3"},
           {"/a", {1, 2}, "/a: expected an object, found [1,2]"},
           {"/b/immovable", 1, "/b/immovable: expected true or false, found 1"}}) {
    EXPECT_EQ(error_of([&, to = json::json_pointer(pointer), v = &value](json& record) { record[to] = *v; }), error);
  }
}

TEST(CollisionJson, PutsTheGivenPlaceBeforeItsOwn) {
  EXPECT_EQ(error_of([](json& r) { r.erase("normal"); }, "/cases/3"), "/cases/3/normal: is missing; add this field");
}

TEST(CollisionJson, ShortensALongValueInItsErrors) {
  const std::string error = error_of([](json& r) { r["a"]["mass"] = std::string(1000, 'x'); });
  EXPECT_LT(error.size(), 120U);
  EXPECT_EQ(error.substr(0, 40), "/a/mass: expected a number, found \"xxxxx");
}

TEST(CollisionJson, DoesNotValidateTheNumbers) {
  EXPECT_EQ(error_of([](json& r) { r["a"]["mass"] = -1; }), "");
  EXPECT_EQ(error_of([](json& r) { r["normal"] = {"nan", "inf", "-inf"}; }), "");
}

TEST(ParseJson, ReadsWhatTheLibraryReads) {
  for (const char* text :
       {"{}", "[]", "null", "true", "\"text\"", "-3", "18446744073709551615", "0.1", "-0.0", "5e-324", "1E+5",
        R"({"a":[1,{"b":[[],{},"c\u00e4",2.5]},null],"d":{"e":{"f":false}},"g":[[1,2],[3,[4]]]})",
        R"( [ {"x" : 1 , "y" : [ ] } , "z" ] )"}) {
    EXPECT_EQ(parse_json(text), json::parse(text)) << text;
    EXPECT_EQ(parse_json(text).type(), json::parse(text).type()) << text;
  }
}

TEST(ParseJson, RefusesTextsThatAreAmbiguousOrNoJson) {
  for (const auto& [text, says] : std::vector<std::pair<std::string, std::string>>{
           {R"({"a":1,"b":{"a":1},"a":2})", "the field \"a\" occurs twice"},
           {R"([{"a":{"b":1,"b":1}}])", "the field \"b\" occurs twice"},
           {std::string(65, '[') + std::string(65, ']'), "expected at most 64 nested levels"},
           {"1e999", "overflows binary64"},
           {"[1,]", "not JSON"},
           {"[1] 2", "not JSON"},
           {"", "not JSON"},
           {std::string("1\0", 2), "zero byte"}}) {
    const std::string message = unit::message_of<FormatError>([&text = text] { return parse_json(text); });
    EXPECT_NE(message.find(says), std::string::npos) << text << ": " << message;
  }
  EXPECT_NO_THROW((void)parse_json(std::string(64, '[') + std::string(64, ']')));
}

TEST(DomainJson, RoundTripsTheDomainOfASubject) {
  for (const char* text :
       {"mass_ratio=:100.0,size=0.125:1000000.0", "restitution=0.5:0.5", "bodies=solid_spheres,plane=xy", ""}) {
    EXPECT_EQ(domain_from_json(domain_to_json(text)), text);
  }
  EXPECT_EQ(domain_from_json(domain_to_json("restitution=0.5")), "restitution=0.5:0.5");
  EXPECT_EQ(domain_from_json(domain_to_json("everything")), "");
  EXPECT_THROW((void)domain_to_json("games"), std::invalid_argument);
}

}  // namespace
}  // namespace carom
