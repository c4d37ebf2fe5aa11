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

struct NodeEngine {
  std::string name;  // also of its adapter
  std::string package;
  Precision precision;
  std::string configured;
};

std::vector<Subject> node_engine(const NodeEngine& engine) {
  std::vector<Subject> claims = engine_claims(engine.name, engine.package + ": " + engine.configured,
                                              engine.package + ": the engine's defaults, step 1/60 s");
  const fs::path directory = npm_directory();
  const bool installed = !directory.empty() && !first_existing({directory / "node_modules" / engine.package}).empty();
  const char* settings = "configured";
  for (Subject& claim : claims) {
    claim.precision = engine.precision;
    claim.specification =
        specification({"node", (directory / (engine.name + ".mjs")).lexically_normal().string(), settings});
    settings = "as-shipped";
    if (!installed) {
      claim.absent = engine.package + " is not installed: bash src/bootstrap.sh engines";
    }
  }
  return claims;
}

std::vector<Subject> bullet_float() {
  std::vector<Subject> claims =
      engine_claims("bullet-float", "Bullet's float build: restitution threshold 0, no gyroscopic torque",
                    "Bullet's float build: the engine's defaults, step 1/60 s");
  const fs::path program = first_existing({program_directory() / "carom-bullet-float"});
  claims[0].summary += "; drops contacts of bodies of more than about 1.5e7 kg";
  const char* settings = "configured";
  for (Subject& claim : claims) {
    claim.precision = Precision::binary32;
    claim.specification = specification({program.lexically_normal().string(), settings});
    settings = "as-shipped";
    if (program.empty()) {
      claim.absent = "libbullet-dev was not found when this program was built";
    }
  }
  return claims;
}

}  // namespace

std::vector<Subject> protocol_engines() {
  std::vector<Subject> engines = bullet_float();
  for (const NodeEngine& engine :
       {NodeEngine{"rapier", "@dimforge/rapier3d-compat", Precision::binary32,
                   "step 1e-16 s, no contact softness, speed limits out of reach"},
        NodeEngine{
            "jolt", "jolt-physics", Precision::binary32,
            "restitution threshold 0, no damping, speed limits out of reach; rounds the normal of resting contacts"},
        NodeEngine{"cannon", "cannon-es", Precision::binary64,
                   "no contact softness, no damping, no force limit; its restitution leaves out the spins"}}) {
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
