// SPDX-License-Identifier: BSL-1.0
#include <cstdlib>
#include <filesystem>
#include <string>
#include <string_view>
#include <system_error>
#include <utility>
#include <vector>

#include <unistd.h>

#include <carom/collision/json/text.hpp>
#include <carom/subjects/engines.hpp>
#include <carom/subjects/engines/claims.hpp>
#include <carom/subjects/steppers.hpp>

namespace carom::subjects {

std::filesystem::path program_directory() {
  std::error_code none;
  return std::filesystem::read_symlink("/proc/self/exe", none).parent_path();
}

namespace {

/// The environment variable that names a folder with the adapters and the packages that they import.
constexpr const char* adapters_variable = "CAROM_ENGINES";

struct Adapters {
  std::filesystem::path directory;  // empty if there is none
  bool is_chosen = false;           // by the environment variable
};

namespace fs = std::filesystem;

bool is_there(const fs::path& path) {
  std::error_code none;
  return fs::exists(path, none);
}

bool is_on_path(const std::string& program) {
  const char* const path = std::getenv("PATH");
  std::string_view rest = path == nullptr ? std::string_view() : path;
  while (!rest.empty()) {
    const std::size_t colon = rest.find(':');
    const fs::path candidate = fs::path(rest.substr(0, colon)) / program;
    if (access(candidate.c_str(), X_OK) == 0) {
      return true;
    }
    rest = colon == std::string_view::npos ? std::string_view() : rest.substr(colon + 1);
  }
  return false;
}

/// The command that installs the packages of the folder, or of a copy if the folder is not writable.
std::string how_to_install(const fs::path& directory) {
  const std::string quoted = carom::quoted(directory.string());
  if (access(directory.c_str(), W_OK) == 0) {
    return "npm ci --prefix " + quoted;
  }
  return "cp -r " + quoted + " ~/carom-engines && npm ci --prefix ~/carom-engines && export " + adapters_variable +
         "=~/carom-engines";
}

/// The folder that the environment variable names; otherwise the nearest `share/carom/npm` above this program.
Adapters find_adapters() {
  if (const char* const chosen = std::getenv(adapters_variable); chosen != nullptr && *chosen != '\0') {
    return {fs::absolute(chosen).lexically_normal(), true};
  }
  for (fs::path folder = program_directory(); !folder.empty(); folder = folder.parent_path()) {
    const fs::path candidate = folder / "share" / "carom" / "npm";
    if (is_there(candidate)) {
      std::error_code none;
      const fs::path real = fs::canonical(candidate, none);
      return {real.empty() ? candidate : real, false};
    }
    if (folder == folder.root_path()) {
      break;
    }
  }
  return {};
}

/// Why this adapter of an npm package cannot run, and the command that helps; empty if it can run.
std::string why_absent(const Adapters& adapters, const std::string& adapter, const std::string& package) {
  if (adapters.directory.empty()) {
    return std::string("no folder above this program contains share/carom/npm with the adapters; set ") +
           adapters_variable + " to such a folder";
  }
  if (!is_there(adapters.directory / adapter)) {
    return (adapters.directory / adapter).string() + " does not exist" +
           (adapters.is_chosen ? std::string("; check ") + adapters_variable : "");
  }
  if (!is_there(adapters.directory / "node_modules" / package)) {
    return package + " is not installed: " + how_to_install(adapters.directory);
  }
  return is_on_path("node") ? "" : "node is not on PATH: install nodejs";
}

std::string specification(const std::vector<std::string>& words) {
  std::string text;
  for (const std::string& word : words) {
    text += text.empty() ? std::string(protocol::exec_prefix) : " ";
    text += carom::quoted(word);
  }
  return text;
}

/// Sets the command that starts each of an engine's subjects: `program`, followed by the words of its setting.
/// `absence` says why the engine is not installed; it may be empty.
std::vector<Subject> started_by(std::vector<Subject> claims, const std::vector<std::string>& program,
                                const std::string& absence) {
  for (std::size_t i = 0; i < claims.size(); ++i) {
    std::vector<std::string> words = program;
    const std::vector<std::string> setting = engine_settings[i].words();
    words.insert(words.end(), setting.begin(), setting.end());
    claims[i].specification = specification(words);
    claims[i].absent = absence;
  }
  return claims;
}

struct NodeEngine {
  std::string name;  // also of its adapter
  std::string package;
  Precision precision;
  std::string configured;
  std::string friction;
};

std::vector<Subject> node_engine(const NodeEngine& engine) {
  const Adapters adapters = find_adapters();
  const std::string adapter = engine.name + ".mjs";
  return started_by(engine_claims({engine.name, engine.package, engine.configured, engine.friction}, engine.precision),
                    {"node", (adapters.directory / adapter).string()}, why_absent(adapters, adapter, engine.package));
}

std::vector<Subject> bullet_float() {
  const std::filesystem::path program = program_directory() / "carom-bullet-float";
  std::error_code none;
  return started_by(
      engine_claims({"bullet-float", "Bullet's float build",
                     "restitution threshold 0, no gyroscopic torque; ignores contacts of bodies above about 1.5e7 kg",
                     "friction along the slip before the impulse", bullet_as_shipped()},
                    Precision::binary32),
      {program.string()},
      std::filesystem::exists(program, none)
          ? ""
          : program.string() + " does not exist: libbullet-dev was not found when this program was built");
}

}  // namespace

std::vector<Stepper> npm_steppers() {
  const Adapters adapters = find_adapters();
  std::vector<Stepper> steppers;
  for (const auto& [name, package] :
       {std::pair("rapier", "@dimforge/rapier3d-compat"), std::pair("jolt", "jolt-physics"),
        std::pair("cannon", "cannon-es"), std::pair("physx", "physx-js-webidl"), std::pair("oimo", "oimophysics"),
        std::pair("mujoco", "@mujoco/mujoco"), std::pair("planck", "planck")}) {
    const std::string adapter = std::string("time/") + name + ".mjs";
    for (const bool configured : {true, false}) {
      Stepper stepper{configured ? name : std::string(name) + "-as-shipped"};
      stepper.specification =
          specification({"node", (adapters.directory / adapter).string(), configured ? "configured" : "as-shipped"});
      stepper.absent = why_absent(adapters, adapter, package);
      steppers.push_back(std::move(stepper));
    }
  }
  return steppers;
}

std::vector<Subject> protocol_engines() {
  std::vector<Subject> engines = bullet_float();
  for (const NodeEngine& engine :
       {NodeEngine{"rapier", "@dimforge/rapier3d-compat", Precision::binary32,
                   "step 1e-16 s, no contact softness, speed limits out of reach",
                   "friction is limited by the impulse without restitution"},
        NodeEngine{
            "jolt", "jolt-physics", Precision::binary32,
            "restitution threshold 0, no damping, speed limits out of reach; rounds the normal of resting contacts",
            "friction is weighted along two axes of the world"},
        NodeEngine{"cannon", "cannon-es", Precision::binary64,
                   "no contact softness, no damping, no force limit; its restitution ignores the spins",
                   "friction is limited to a square that does not depend on the pressure"},
        NodeEngine{"physx", "physx-js-webidl", Precision::binary32,
                   "bounce threshold 0, no damping, speed limits out of reach",
                   "friction is limited to a square along the motion of the centres"},
        NodeEngine{"oimo", "oimophysics", Precision::binary64,
                   "bounce threshold 0, speed limits out of reach; bodies with small moments do not rotate",
                   "friction is weighted by the contact's mobility"},
        NodeEngine{"mujoco", "@mujoco/mujoco", Precision::binary64,
                   "step 2^-100 s, the hardest available contact; soft above 1e11 kg",
                   "bodies that slip bounce faster"}}) {
    const std::vector<Subject> claims = node_engine(engine);
    engines.insert(engines.end(), claims.begin(), claims.end());
  }
  return engines;
}

Subject started(const Subject& subject, const protocol::ExecOptions& options) {
  if (subject.specification.empty() || !subject.absent.empty()) {
    return subject;
  }
  Subject result = protocol::exec_subject(subject.specification, options);
  result.name = subject.name;
  result.summary = subject.summary;
  result.expected_to_pass = subject.expected_to_pass;
  return result;
}

}  // namespace carom::subjects
