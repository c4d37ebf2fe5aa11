// SPDX-License-Identifier: BSL-1.0
#include <algorithm>
#include <cstdint>
#include <optional>
#include <random>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <carom/collision/json/json.hpp>
#include <carom/collision/json/record.hpp>
#include <carom/oracles/judge/coulomb_answers.hpp>
#include <carom/oracles/judge/exact_case.hpp>
#include <carom/properties/records/digits.hpp>
#include <carom/properties/records/judged_record.hpp>

#include "support/message_of.hpp"

namespace carom::properties::records {
namespace {

using nlohmann::json;

/// Collisions of ordinary bodies, whose numbers are about 1.
class Collisions {
 public:
  Collision next() {
    Collision c;
    for (Body* body : {&c.a, &c.b}) {
      body->mass = between(1, 3);
      body->principal_inertia = moments_of_box(body->mass, {between(0.5, 1.5), between(0.5, 1.5), between(0.5, 1.5)});
      for (int i = 0; i < 4; ++i) {
        body->orientation[i] = between(0.2, 1);
      }
      body->position = vector(1);
      body->velocity = vector(3);
      body->angular_velocity = vector(2);
    }
    c.point = vector(1);
    c.normal = vector(1);
    c.restitution = between(0, 1);
    c.friction = between(0.05, 1);
    c.tangential_restitution = between(-0.9, 0.9);
    if (c.normal.dot(oracles::relative_velocity<double>(c, unchanged(c))) > 0) {
      c.normal = -c.normal;
    }
    return c;
  }

 private:
  double between(double low, double high) {
    return low + (high - low) * static_cast<double>(random_() >> 11) * 0x1p-53;
  }
  Vector3<double> vector(double size) { return {between(-size, size), between(-size, size), between(-size, size)}; }

  std::mt19937_64 random_{7};
};

Outcome<double> answer_by(Law law, const Collision& collision) {
  const oracles::ExactCase exact_case(collision);
  if (determines_outcome(law)) {
    return exact_case.nearest_truth(law);
  }
  return map_outcome<double>(oracles::coulomb_answers(exact_case).front().truth.outcome,
                             [](const oracles::Rational& x) { return oracles::nearest_double(x); });
}

/// The collision and the outcome as JSON text, with `decimals` decimals, or with 17 digits if it is negative.
/// Positions, points and normals may have their own count of decimals.
std::string written(const Collision& collision, const Outcome<double>& after, int decimals,
                    std::optional<int> of_places = std::nullopt) {
  const auto number_with = [](double x, int count) {
    return count < 0 ? fmt::format("{:.17g}", x) : fmt::format("{:.{}f}", x, count);
  };
  const auto vector_with = [&](const auto& v, int count) {
    std::string text;
    for (Eigen::Index i = 0; i < v.size(); ++i) {
      text += (i > 0 ? "," : "[") + number_with(v[i], count);
    }
    return text + ']';
  };
  const auto number = [&](double x) { return number_with(x, decimals); };
  const auto vector = [&](const auto& v) { return vector_with(v, decimals); };
  const auto place = [&](const auto& v) { return vector_with(v, of_places.value_or(decimals)); };
  const auto body = [&](const Body& b) {
    return fmt::format(
        R"({{"mass":{},"principal_inertia":{},"orientation":{},"position":{},"velocity":{},"angular_velocity":{}}})",
        number(b.mass), vector(b.principal_inertia), vector(b.orientation), place(b.position), vector(b.velocity),
        vector(b.angular_velocity));
  };
  const auto motion = [&](const BodyVelocity<double>& m) {
    return fmt::format(R"({{"velocity":{},"angular_velocity":{}}})", vector(m.velocity), vector(m.angular_velocity));
  };
  return fmt::format(
      R"({{"a":{},"b":{},"point":{},"normal":{},"restitution":{},"friction":{},"tangential_restitution":{},"after":{{"a":{},"b":{}}}}})",
      body(collision.a), body(collision.b), place(collision.point), place(collision.normal),
      number(collision.restitution), number(collision.friction), number(collision.tangential_restitution),
      motion(after.a), motion(after.b));
}

Resolution resolution_of(const std::vector<std::string>& texts) {
  DigitsReader reader;
  for (const std::string& text : texts) {
    reader.add(parse_spelled(text));
  }
  return reader.resolution(std::nullopt);
}

JudgedRecord judged_text(const std::string& text, const Resolution& resolution, Law law) {
  return judged(record_from_json(parse_json(text)), resolution, law, false);
}

struct Answered {
  Collision collision;
  Outcome<double> right;
  Outcome<double> wrong;  // with one wrong component
};

std::vector<Answered> answered_by(Law law) {
  const std::size_t count = law == Law::coulomb ? 8 : 24;  // the exact answers of `coulomb` take long
  Collisions collisions;
  std::vector<Answered> all;
  for (std::size_t i = 0; i < count; ++i) {
    const Collision collision = collisions.next();
    const Outcome<double> right = answer_by(law == Law::any ? Law::rough : law, collision);
    Outcome<double> wrong = right;
    (*vectors(wrong)[all_outcome_vectors.at(i % 4)])[static_cast<Eigen::Index>(i % 3)] += 0.1;
    all.push_back({collision, right, wrong});
  }
  return all;
}

TEST(Records, OfARightSolverHoldAndAWrongComponentIsSeenForEachLawAndCountOfDigits) {
  for (const Law law : all_laws) {
    const std::vector<Answered> all = answered_by(law);
    for (const int decimals : {4, 6, -1}) {
      SCOPED_TRACE(fmt::format("{} with {} decimals", name_of(law), decimals));
      std::vector<std::string> right;
      for (const Answered& one : all) {
        right.push_back(written(one.collision, one.right, decimals));
      }
      const Resolution resolution = resolution_of(right);
      EXPECT_EQ(resolution.form, decimals < 0 ? Resolution::Form::exact : Resolution::Form::decimals);
      for (std::size_t i = 0; i < all.size(); ++i) {
        const JudgedRecord judged = judged_text(right[i], resolution, law);
        EXPECT_EQ(judged.satisfied[law], std::optional(true))
            << right[i] << (judged.broken.empty() ? "" : judged.broken[0].words);
        const std::string wrong = written(all[i].collision, all[i].wrong, decimals);
        EXPECT_EQ(judged_text(wrong, resolution, law).satisfied[law], std::optional(false)) << wrong;
      }
    }
  }
}

TEST(Records, OfARightSolverHoldIfPlacesAndNormalsHaveFewerDecimals) {
  std::vector<std::string> right;
  const std::vector<Answered> all = answered_by(Law::frictionless);
  for (const Answered& one : all) {
    right.push_back(written(one.collision, one.right, 6, 3));
  }
  const Resolution resolution = resolution_of(right);
  EXPECT_EQ(resolution.in_words(),
            "6 decimals (3 of position, 3 of point, 3 of normal), read off the numbers (--digits N sets it)");
  for (std::size_t i = 0; i < all.size(); ++i) {
    const JudgedRecord judged = judged_text(right[i], resolution, Law::frictionless);
    EXPECT_TRUE(judged.broken.empty()) << right[i] << judged.broken[0].words;
    const std::string wrong = written(all[i].collision, all[i].wrong, 6, 3);
    EXPECT_FALSE(judged_text(wrong, resolution, Law::frictionless).broken.empty()) << wrong;
  }
}

TEST(Records, NeedEachCoefficientOfTheLawRough) {
  const Answered one = answered_by(Law::rough).front();
  const json record = parse_json(written(one.collision, one.right, -1));
  EXPECT_EQ(judged_text(record.dump(), Resolution{}, Law::rough).satisfied[Law::rough], std::optional(true));
  for (const char* const coefficient : {"restitution", "friction", "tangential_restitution"}) {
    json lacking = record;
    lacking.erase(coefficient);
    EXPECT_EQ(judged_text(lacking.dump(), Resolution{}, Law::rough).satisfied[Law::rough], std::nullopt) << coefficient;
  }
}

TEST(Records, ImplyTheCoefficientsOfTheirLaw) {
  Collisions collisions;
  int with_friction = 0;
  for (int i = 0; i < 12; ++i) {
    const Collision collision = collisions.next();
    const Outcome<double> after = answer_by(Law::coulomb, collision);
    const std::string text = written(collision, after, -1);
    const Implied implied = judged_text(text, resolution_of({text}), Law::any).implied;
    ASSERT_TRUE(implied.restitution);
    EXPECT_NEAR(*implied.restitution, collision.restitution, 1e-9);
    if (implied.friction) {
      EXPECT_NEAR(*implied.friction, collision.friction, 1e-9);
      ++with_friction;
    }
  }
  EXPECT_GT(with_friction, 3);
}

TEST(Digits, AreReadOffTheVelocitiesAfter) {
  const auto form_of = [](const std::vector<std::string>& numbers) {
    std::vector<std::string> texts;
    for (const std::string& number : numbers) {
      texts.push_back(R"({"after":{"a":{"velocity":[)" + number + "]}}}");
    }
    return resolution_of(texts).in_words();
  };
  EXPECT_EQ(form_of({"1.2500", "-0.0012", "113.5000", "0"}).substr(0, 10), "4 decimals");
  // Not every number is as long as the longest.
  EXPECT_EQ(form_of({"1.25", "-0.0012", "113.5", "2"}).substr(0, 10), "4 decimals");
  EXPECT_EQ(form_of({"1.23457", "123.457", "0.00123457", "1.2e-05"}).substr(0, 20), "6 significant digits");
  EXPECT_EQ(form_of({"-1.6", "2", "0.5"}), "exact to rounding in binary64, read off the numbers (--digits N sets it)");
  // Many numbers are exact, as few are. Half a unit of a whole number would be 0.5 m/s.
  for (const char* const number : {"9", "123456", "123.0", "-1.6"}) {
    EXPECT_EQ(form_of(std::vector<std::string>(12, number)).substr(0, 29), "exact to rounding in binary64") << number;
  }
  EXPECT_EQ(form_of(std::vector<std::string>(12, "12.6")).substr(0, 9), "1 decimal");
  EXPECT_NE(form_of({"0.30000000000000004", "0.10000000000000001"}).find("binary64"), std::string::npos);
  EXPECT_NE(form_of({"0.10000000149011612", "0.3"}).find("binary32"), std::string::npos);
}

TEST(Digits, AreReadOffNoUnknownField) {
  const std::string unknown = "1.2341000000000002";
  const std::string after = R"("after":{"a":{"velocity":[1.2345,0.9876,-0.1233]})";
  EXPECT_EQ(resolution_of({'{' + after + R"(,"relative_velocity":)" + unknown + R"(},"after.a.velocity":)" + unknown +
                           R"(,"camera":{"mass":)" + unknown + "}}"})
                .in_words()
                .substr(0, 10),
            "4 decimals");
  for (const char* const path : {"after.velocity", "camera.mass", "mass", "a.point", "velocity"}) {
    EXPECT_EQ(recorded_field(path), std::nullopt) << path;
  }
  EXPECT_EQ(recorded_field("b.mass"), std::optional(RecordedField::mass));
  EXPECT_EQ(recorded_field("normal"), std::optional(RecordedField::normal));
  EXPECT_EQ(recorded_field("after.b.angular_velocity"), std::optional(RecordedField::after));
}

TEST(Digits, OfAVectorAreItsOwnIfItLooksRounded) {
  const auto words_with = [](const std::string& normal) {
    const Resolution resolution =
        resolution_of({R"({"normal":[)" + normal + R"(],"after":{"a":{"velocity":[1.234567,0.987654,-0.123321]}}})"});
    return resolution.in_words().substr(0, resolution.in_words().find(", read"));
  };
  EXPECT_EQ(words_with("0.707,-0.707,0"), "6 decimals (3 of normal)");
  for (const char* const chosen : {"0.6,0.8,0", "0,1.000,0", "0.125,0.25,1", "1,2,3"}) {
    EXPECT_EQ(words_with(chosen), "6 decimals") << chosen;
  }
}

TEST(Digits, OfBinary32NumbersPermitTheRoundingOfBinary32) {
  // printf("%f") of a float writes more decimals than the float has.
  const auto precision_of = [](const std::string& number) {
    return resolution_of({R"({"after":{"a":{"velocity":[)" + number + "]}}}"}).precision;
  };
  EXPECT_EQ(precision_of(fmt::format("{:.6f}", static_cast<double>(1234.5678F))), Precision::binary32);
  EXPECT_EQ(precision_of("1234.567801"), Precision::binary64);
}

TEST(RecordJson, ComputesTheMomentsOfSolidShapes) {
  const std::string motion = R"("position":[0,0,0],"velocity":[0,0,0],"angular_velocity":[0,0,0])";
  const std::string text = R"({"a":{"mass":2.5,"sphere":0.2,)" + motion + R"(},"b":{"mass":3,"box":[0.1,0.2,0.7],)" +
                           motion + R"(},"point":[0,0,0],"normal":[0,1,0],"after":{"a":{"velocity":[0,0,0],)" +
                           R"("angular_velocity":[0,0,0]},"b":{"velocity":[0,0,0],"angular_velocity":[0,0,0]}}})";
  const Record record = record_from_json(parse_json(text));
  EXPECT_EQ(record.collision.a.principal_inertia, moments_of_sphere(2.5, 0.2));
  EXPECT_NEAR(record.collision.a.principal_inertia[1], 0.04, 1e-16);
  EXPECT_EQ(record.collision.b.principal_inertia, moments_of_box(3, {0.1, 0.2, 0.7}));
  EXPECT_NEAR(record.collision.b.principal_inertia[0], 0.1325, 1e-15);
  EXPECT_NEAR(record.collision.b.principal_inertia[2], 0.0125, 1e-15);
  EXPECT_FALSE(record.has_restitution);
}

std::string complaint_about(const json& record) {
  return unit::message_of<FormatError>([&] { (void)record_from_json(record); });
}

TEST(RecordJson, NamesTheFieldThatGivesNoMoments) {
  const std::string motion = R"("position":[0,0,0],"velocity":[0,0,0],"angular_velocity":[0,0,0])";
  const json record = parse_json(
      R"({"a":{"mass":2,)" + motion + R"(},"b":{"immovable":true,"mass":0,"orientation":0,)" + motion +
      R"(},"point":[0,0,0],"normal":[0,1,0],"after":{"a":{"velocity":[0,0,0],"angular_velocity":[0,0,0]}}})");
  const auto with = [&](const json& fields) {
    json changed = record;
    changed["a"].update(fields);
    return changed;
  };
  EXPECT_EQ(record_from_json(with({{"sphere", 0.5}})).others.dump(), "{}") << "an immovable body needs no mass";
  EXPECT_EQ(complaint_about(with({{"sphere", -0.5}})), "a.sphere: expected a finite length greater than 0, found -0.5");
  EXPECT_EQ(complaint_about(with({{"sphere", "nan"}})),
            "a.sphere: expected a finite length greater than 0, found \"nan\"");
  EXPECT_EQ(complaint_about(with({{"sphere", 1e200}})),
            "a.sphere: gives moments of inertia beyond the range of binary64");
  EXPECT_EQ(complaint_about(with({{"box", {1, -2, 3}}})),
            "a.box.y: expected a finite length greater than 0, found -2.0");
  EXPECT_EQ(complaint_about(with({{"sphere", 0.5}, {"principal_inertia", {1, 1, 1}}})),
            "a.principal_inertia: contradicts \"sphere\"; keep one of them");
  EXPECT_EQ(complaint_about(3), "expected an object, found 3");
}

TEST(RecordJson, OfAPlaneHasTwoCoordinatesInEachVector) {
  const std::string text =
      R"({"a":{"mass":2,"moment":0.5,"position":[0,1],"velocity":[1,-2],"angular_velocity":3},)"
      R"("b":{"immovable":true,"position":[0,0],"velocity":[0,0],"angular_velocity":0},"point":[0.5,0],"normal":[0,1],)"
      R"("restitution":0.5,"frame":17,"after":{"a":{"velocity":[1,1],"angular_velocity":4}}})";
  const Record record = record_from_json(parse_json(text));
  EXPECT_EQ(record.collision.a.velocity, Vector3<double>(1, -2, 0));
  EXPECT_EQ(record.after.a.angular_velocity, Vector3<double>(0, 0, 4));
  EXPECT_EQ(record.collision.a.principal_inertia, Vector3<double>::Constant(0.5));
  EXPECT_EQ(record.others.dump(), R"({"frame":17})");
  json box = parse_json(text);
  box["a"].erase("moment");
  box["a"]["box"] = {1, 2};
  const Collision flat = record_from_json(box).collision;
  box["a"]["box"] = {1, 2, 3};
  EXPECT_EQ(record_from_json(box).collision.a.principal_inertia, flat.a.principal_inertia);
  json disc = parse_json(text);
  disc["a"].erase("moment");
  disc["a"]["disc"] = 3;
  EXPECT_EQ(record_from_json(disc).collision.a.principal_inertia, Vector3<double>::Constant(9));  // m R² / 2
  json other = parse_json(text);
  other["a"]["velocity"] = {1, -2, 0};
  other["after"]["a"]["velocity"] = {1, 1, 0};
  // One vector with three coordinates: then each must have three.
  EXPECT_EQ(unit::message_of<FormatError>([&] { (void)record_from_json(other); }),
            "a.principal_inertia: is missing; add this field; only a planar record has \"moment\" or \"disc\", and "
            "a.velocity has three coordinates (docs/guide/check.md)");
  other["a"]["principal_inertia"] = {1, 1, 1};
  EXPECT_EQ(unit::message_of<FormatError>([&] { (void)record_from_json(other); }),
            "a.position: expected an array of 3 numbers, as a.velocity has; a planar record has 2 in each vector, and "
            "one number as angular_velocity");
  json lacking = parse_json(text);
  lacking["after"]["a"]["velocity"] = {1, nullptr};
  EXPECT_EQ(unit::message_of<FormatError>([&] { (void)record_from_json(lacking); }),
            "after.a.velocity.y: expected a number, found null");
}

}  // namespace
}  // namespace carom::properties::records
