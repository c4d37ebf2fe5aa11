// SPDX-License-Identifier: BSL-1.0
#include <cstdlib>
#include <filesystem>
#include <string>

#include <carom/subjects/engines/claims.hpp>
#include <carom/subjects/engines/engines.hpp>
#include <carom/subjects/protocol/command_line.hpp>

namespace carom::subjects {
namespace {

namespace fs = std::filesystem;

/// Where this program stands; empty where the system does not tell.
fs::path program_directory() {
  std::error_code none;
  return fs::read_symlink("/proc/self/exe", none).parent_path();
}

/// The first of these that is there; empty where none is.
fs::path first_existing(const std::vector<fs::path>& candidates) {
  std::error_code none;
  for (const fs::path& candidate : candidates) {
    if (fs::exists(candidate, none)) {
      return candidate;
    }
  }
  return {};
}

std::string specification(const std::vector<std::string>& words) {
  std::string text;
  for (const std::string& word : words) {
    text += text.empty() ? std::string(protocol::exec_prefix) : " ";
    text += protocol::quoted(word);
  }
  return text;
}

/// The installed tree's folder of adapters for Node, or the source tree's.
fs::path npm_directory() { return first_existing({program_directory() / "../share/carom/npm", CAROM_NPM_DIRECTORY}); }

/// Sets what starts each of an engine's subjects: `program`, followed by the words of its setting. `why_absent` is
/// empty where the engine is installed.
std::vector<Subject> started_by(std::vector<Subject> claims, const std::vector<std::string>& program,
                                const std::string& why_absent) {
  for (std::size_t i = 0; i < claims.size(); ++i) {
    std::vector<std::string> words = program;
    const std::vector<std::string> setting = engine_settings[i].words();
    words.insert(words.end(), setting.begin(), setting.end());
    claims[i].specification = specification(words);
    claims[i].absent = why_absent;
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
  const fs::path directory = npm_directory();
  const bool installed = !directory.empty() && !first_existing({directory / "node_modules" / engine.package}).empty();
  return started_by(engine_claims({engine.name, engine.package, engine.configured, engine.friction}, engine.precision),
                    {"node", (directory / (engine.name + ".mjs")).lexically_normal().string()},
                    installed ? "" : engine.package + " is not installed: bash src/bootstrap.sh engines");
}

std::vector<Subject> bullet_float() {
  const fs::path program = first_existing({program_directory() / "carom-bullet-float"});
  return started_by(
      engine_claims({"bullet-float", "Bullet's float build",
                     "restitution threshold 0, no gyroscopic torque; drops contacts of bodies of more than about "
                     "1.5e7 kg",
                     "friction along the slip before the impulse"},
                    Precision::binary32),
      {program.lexically_normal().string()},
      program.empty() ? "libbullet-dev was not found when this program was built" : "");
}

}  // namespace

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
                   "no contact softness, no damping, no force limit; its restitution leaves out the spins",
                   "friction is in a square that does not know the pressure"},
        NodeEngine{"physx", "physx-js-webidl", Precision::binary32,
                   "bounce threshold 0, no damping, speed limits out of reach",
                   "friction is in a square along the motion of the centres"},
        NodeEngine{"oimo", "oimophysics", Precision::binary64,
                   "bounce threshold 0, speed limits out of reach; bodies of small moments do not turn",
                   "friction is weighted by the contact's mobility"},
        NodeEngine{"mujoco", "@mujoco/mujoco", Precision::binary64,
                   "step 2^-100 s, the hardest contact that it has; soft beyond 1e11 kg",
                   "what slips bounces faster"}}) {
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
