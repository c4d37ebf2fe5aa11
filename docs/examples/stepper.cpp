// SPDX-License-Identifier: BSL-1.0
// An engine that steps and speaks the protocol: spheres on half-spaces, without friction. Symplectic Euler.
//   g++ -std=c++20 -O2 docs/examples/stepper.cpp -o stepper && carom time exec:./stepper
#include <array>
#include <chrono>
#include <iostream>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

using nlohmann::json;
using Vector = std::array<double, 3>;

double dot(const Vector& x, const Vector& y) { return x[0] * y[0] + x[1] * y[1] + x[2] * y[2]; }

void add(Vector& x, double factor, const Vector& y) {
  for (int i = 0; i < 3; ++i) x[i] += factor * y[i];
}

struct World {
  Vector gravity;
  double restitution;
  json bodies;  // their records, with the present state

  void step(double h) {
    for (json& ball : bodies) {
      if (!ball.contains("sphere")) continue;
      Vector position = ball["position"], velocity = ball["velocity"];
      add(velocity, h, gravity);
      for (const json& wall : bodies) {
        if (!wall.contains("half_space")) continue;
        const Vector n = wall["half_space"];  // of length 1
        const double gap = dot(n, position) - dot(n, wall["position"]) - ball["sphere"].get<double>();
        if (gap <= 0 && dot(n, velocity) < 0) add(velocity, -(1 + restitution) * dot(n, velocity), n);
      }
      add(position, h, velocity);
      ball["position"] = position;
      ball["velocity"] = velocity;
    }
  }

  json states() const {
    json all = json::array();
    for (const json& body : bodies) {
      const json still{0, 0, 0};
      all.push_back({{"position", body["position"]},
                     {"orientation", {1, 0, 0, 0}},
                     {"velocity", body.value("velocity", still)},
                     {"angular_velocity", still}});
    }
    return all;
  }
};

json answer(const json& request) {
  const json& scene = request.at("scene");
  World world{scene.at("gravity"), scene.at("restitution"), scene.at("bodies")};
  json states = json::array();
  std::chrono::duration<double> seconds{0};
  for (int done = 0; const int after : request.at("report")) {
    const auto start = std::chrono::steady_clock::now();
    for (; done < after; ++done) world.step(request.at("step"));
    seconds += std::chrono::steady_clock::now() - start;
    states.push_back(world.states());
  }
  return {{"id", request["id"]}, {"states", states}, {"seconds", seconds.count()}};
}

int main() {
  for (std::string line; std::getline(std::cin, line);) {
    const json request = json::parse(line);
    if (request["cmd"] == "stop") break;
    const json introduction = json::parse(
        R"({"protocol": 1, "name": "example", "version": "1", "precision": "binary64", "model": "frictionless",
            "time": true, "cannot": ["box", "friction", "continuous"]})");
    std::cout << (request["cmd"] == "start" ? introduction : answer(request)).dump() << std::endl;
  }
}
