// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <array>
#include <limits>

#include <carom/properties/invariants/checks.hpp>

namespace carom::properties {
namespace {

const std::vector<Model> every_model{Model::frictionless, Model::reflection, Model::any};
const std::vector<Model> with_truth{Model::frictionless, Model::reflection};

// `finite` and `invalid_refused` speak of the answer itself, not of an outcome: Trial::judge decides them.
const std::array invariants{
    Invariant{"finite", "A valid collision is answered, with finite numbers.",
              R"(x \text{ valid} \Rightarrow y(x) \in \mathbb{R}^{12})", "protocol; failure cases 12, 25, 28 to 30, 34",
              "valid collisions", every_model, nullptr},
    Invariant{"invalid_refused", "An invalid collision is refused, not answered.",
              R"(x \text{ invalid} \Rightarrow \text{no } y(x))", "protocol; failure cases 12, 22, 28",
              "invalid collisions", every_model, nullptr},
    Invariant{
        "backward_error", "The outcome is exact for inputs within the limit of those at hand.",
        R"(\eta = \max_k \frac{\lVert \hat y_k - y_k \rVert}{u \left(\sum_j \lVert \partial y_k / \partial x_j \rVert\, |x_j| + \lVert y_k^- \rVert\right)} \le \eta_{\max})",
        "mixed forward-backward error, N. Higham, Accuracy and Stability of Numerical Algorithms, §1.5; y is exact",
        "valid collisions", with_truth, check_backward_error},
    Invariant{"linear_momentum", "What A gains in linear momentum, B loses.",
              R"(m_A (v_A^+ - v_A^-) = -m_B (v_B^+ - v_B^-))", "note eq. 23", "two movable bodies", every_model,
              check_linear_momentum},
    Invariant{
        "angular_momentum",
        "Each movable body turns by the moment of the impulse that it received; the total about any point is kept.",
        R"(J (w^+ - w^-) = r \times m (v^+ - v^-))", "note eq. 11, 23", "a movable body", every_model,
        check_angular_momentum},
    Invariant{"restitution", "The normal velocity is reversed and multiplied by ε.",
              R"(N \cdot V^+ = -\varepsilon\, N \cdot V^-)", "note eq. 17", "colliding contacts", every_model,
              check_restitution},
    Invariant{"non_penetration", "After the impulse the bodies do not approach.", R"(N \cdot V^+ \ge 0)",
              "note §1, after eq. 4", "a movable body", every_model, check_non_penetration},
    Invariant{"push", "The impulse pushes the bodies apart, it never pulls.", R"(N \cdot F \ge 0)",
              "note eq. 18, with C positive definite", "a movable body", every_model, check_push},
    Invariant{"separating_untouched", "A contact that is not colliding keeps its velocities.",
              R"(N \cdot V^- \ge 0 \Rightarrow y = (v_A^-, w_A^-, v_B^-, w_B^-))", "note §1, after eq. 2",
              "separating and resting contacts, and two immovable bodies", every_model, check_separating_untouched},
    Invariant{"immovable_untouched", "A body of infinite mass keeps its velocity.",
              R"(1/m = 0 \Rightarrow v^+ = v^-,\ w^+ = w^-)", "protocol; failure cases 26, 27", "an immovable body",
              every_model, check_immovable_untouched},
    Invariant{"frictionless_direction",
              "The impulse is along the normal.",
              R"(N \times F = 0)",
              "note eq. 10",
              "a movable body",
              {Model::frictionless},
              check_frictionless_direction},
    Invariant{"reflection_plane",
              "The tangential relative velocity of the contact point is kept.",
              R"(N \times V^+ = N \times V^-)",
              "note eq. 20, 21",
              "a movable body",
              {Model::reflection},
              check_reflection_plane},
    Invariant{"energy",
              "The kinetic energy grows by no more than the work of a driven wall.",
              R"(E^+ - E^- \le W,\quad E = \tfrac12 m v^2 + \tfrac12 w^\top J w)",
              "ΔE = −(1−ε²)(N·V⁻)²/(2 NᵀKN) for the frictionless law; reflection can create energy, so it is not "
              "claimed there",
              "a movable body",
              {Model::frictionless},
              check_energy},
    Invariant{"definite", "The collision matrix is positive definite, with the margin λ.",
              R"(\lambda I \preceq C,\quad \lambda = 1/m_A + 1/m_B)",
              "note eq. 27, with QᵀJ⁻¹Q positive semidefinite; the exact C, and the one that a subject shows",
              "a movable body", every_model, check_definite},
    Invariant{"well_conditioned", "For convex uniform bodies touched inside, the condition number of C is at most 16.",
              R"(C \preceq 16\, \lambda I)",
              "R. Kannan, L. Lovász, M. Simonovits, Discrete Comput. Geom. 13 (1995), Thm 4.1, with n = 3",
              "bodies known to be convex and uniform", every_model, check_well_conditioned},
    Invariant{"collinear_spin", "Where both lever arms are along the normal, as for spheres, no body changes its spin.",
              R"(r_A \times N = r_B \times N = 0 \Rightarrow w_A^+ = w_A^-,\ w_B^+ = w_B^-)", "note eq. 19",
              "colliding contacts with both lever arms exactly along the normal", with_truth, check_collinear_spin},
    Invariant{"swap", "Naming the bodies the other way round changes nothing.", R"(y(B, A, -N) = (y_B, y_A)(A, B, N))",
              "Newton's third law; failure case 19", "valid collisions", with_truth, check_swap, ask_swap},
    Invariant{"galilean", "A common velocity is only added.", R"(y(v_A + c, v_B + c) = y(v_A, v_B) + c)",
              "Galilean invariance", "valid collisions, velocities rounded to a grid so that the sum is exact",
              with_truth, check_galilean, ask_galilean},
    Invariant{"translation", "The place of the origin does not matter.", R"(y(X + t, P + t) = y(X, P))",
              "homogeneity of space", "valid collisions, places rounded to a grid so that the sum is exact", with_truth,
              check_translation, ask_translation},
    Invariant{"rotation", "Turned by 90°, the outcome is turned by 90°.", R"(y(T x) = T y(x))", "isotropy of space",
              "valid collisions, turned about z and about x", with_truth, check_rotation, ask_rotation},
    Invariant{"reflection_symmetry", "The mirror image of a collision has the mirror image as its outcome.",
              R"(y(M x) = M y(x))", "parity; angular velocities are axial vectors",
              "valid collisions, mirrored in x = 0", with_truth, check_reflection_symmetry, ask_reflection_symmetry},
    Invariant{"unit_scaling", "The units of mass, length and time do not matter.",
              R"(y(2^a \mathrm{kg}, 2^b \mathrm{m}, 2^c \mathrm{s}) = y(\mathrm{kg}, \mathrm{m}, \mathrm{s}))",
              "dimensional analysis; failure cases 21, 31", "valid collisions", with_truth, check_unit_scaling,
              ask_unit_scaling},
    Invariant{"homogeneous", "Three times the velocities give three times the outcome.", R"(y(k V) = k\, y(V),\ k = 3)",
              "the laws are linear in the velocities; failure cases 21, 38",
              "valid collisions, velocities rounded to 50 bits", with_truth, check_homogeneous, ask_homogeneous},
    Invariant{
        "continuous", "A small tangential velocity changes the outcome little: as v_t → 0 it becomes the head-on one.",
        R"(y(v_n, v_t) - (v_n, v_t) = y(v_n, 0) - (v_n, 0),\ v_t = 2^{-30} v_n)",
        "the laws depend on N·V⁻ alone; failure cases 3, 4",
        "the bodies of valid collisions, meeting head-on without spin", with_truth, check_continuous, ask_continuous},
    Invariant{"repeat", "A second impulse on the outcome does nothing.",
              R"(\varepsilon > 0 \Rightarrow y(x \text{ with } y(x)) = y(x))", "note eq. 17",
              "colliding contacts with ε > 0", with_truth, check_repeat, nullptr, ask_repeat},
};

}  // namespace

double Verdict::severity() const {
  if (status != Status::violated) {
    return 0;
  }
  return residual > 0 && allowed > 0 ? residual / allowed : std::numeric_limits<double>::infinity();
}

bool Invariant::claimed_for(Model model) const {
  return std::find(models.begin(), models.end(), model) != models.end();
}

std::span<const Invariant> all_invariants() { return invariants; }

const Invariant* invariant_named(std::string_view name) {
  for (const Invariant& invariant : invariants) {
    if (invariant.name == name) {
      return &invariant;
    }
  }
  return nullptr;
}

ExactAnswer lift(const Answer& answer) {
  ExactAnswer lifted{NotFinite{}};
  lift(answer, lifted);
  return lifted;
}

void lift(const Answer& answer, ExactAnswer& into) {
  if (const auto* outcome = std::get_if<ReportedOutcome>(&answer)) {
    if (!into.emplace<oracles::LiftedOutcome>(*outcome).is_moderate() && !oracles::is_finite(*outcome)) {
      into = NotFinite{};
    }
  } else if (const auto* skipped = std::get_if<Skipped>(&answer)) {
    into = *skipped;
  } else {
    into = std::get<Refused>(answer);
  }
}

}  // namespace carom::properties
