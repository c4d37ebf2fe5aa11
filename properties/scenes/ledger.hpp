// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <array>
#include <cstddef>
#include <string_view>
#include <vector>

#include <carom/collision/enum_array.hpp>
#include <carom/collision/vector.hpp>
#include <carom/scene/scene_state.hpp>
#include <carom/scene/simulation.hpp>

namespace carom::properties {

/// What changes the mechanical energy of a scene, or only its form.
enum class Cause {
  impacts,        // of two bodies, by their law
  plane_impacts,  // with planes, by their law
  slow_contacts,  // sent off at the least speed that is followed
  sliding,        // friction on level planes
  rolling,        // rolling resistance
  spinning,       // resistance to spin about a plane's normal
  rounding,       // of everything that was stored
};
inline constexpr std::array all_causes{Cause::impacts, Cause::plane_impacts, Cause::slow_contacts, Cause::sliding,
                                       Cause::rolling, Cause::spinning,      Cause::rounding};
static_assert(counts_from_zero_to(all_causes, Cause::rounding));

[[nodiscard]] std::string_view name_of(Cause cause);

/// A sum that keeps what each addition rounds away (A. Neumaier, "Rundungsfehleranalyse einiger Verfahren zur Summation
/// endlicher Summen", ZAMM 54, 1974), in the widest format.
class Account {
 public:
  void add(long double amount);
  [[nodiscard]] long double sum() const { return sum_ + compensation_; }

 private:
  long double sum_ = 0;
  long double compensation_ = 0;
};

/// Mechanical energy and momentum, now.
struct Energies {
  long double translation = 0;  // [J]
  long double rotation = 0;     // [J]
  long double potential = 0;    // −m g·x [J]
  [[nodiscard]] long double total() const { return translation + rotation + potential; }
};

/// The account of a scene: each joule and each newton second has its cause. What a cause amounts to comes from the
/// law's closed form for spheres and from the phase's; where an impact is of a polyhedron, from the impulse F that the
/// outcome has given A, as F·V + ½ F·K F; never from the difference of two energies. What the states differ by beyond
/// that is rounding, a cause of its own. All in long double: an entry of its own rounds by 2⁻¹¹ of what
/// rounding a state to double does.
class Ledger {
 public:
  /// Begins with a state; the scene that it refers to stays.
  explicit Ledger(const scene::SceneState& state);

  void record(const scene::Event& event);
  /// Everything moves on until then, undisturbed. Call it once, at last.
  void close(const scene::SceneState& state);

  [[nodiscard]] long double energy(Cause cause) const { return energy_[cause].sum(); }
  /// Σ |rounding| of the single entries: what the sum would be, did no two of them cancel.
  [[nodiscard]] long double rounding_without_signs() const { return rounding_.sum(); }
  /// Work of gravity so far: potential turned into kinetic energy.
  [[nodiscard]] long double gravity_work() const { return gravity_work_.sum(); }
  [[nodiscard]] const Energies& initial() const { return initial_; }
  /// As the states have it; of spheres that no event has touched, as of their last one.
  [[nodiscard]] Energies present() const;
  /// What rounding is measured by: the greatest kinetic energy so far, and Σ m |g·x| of where the spheres began, since
  /// an ulp of a place is an ulp of that.
  [[nodiscard]] long double scale() const { return scale_; }
  /// Momentum [N s]: initial, and by cause: what gravity, the planes (their impacts and their reaction on what lies on
  /// them) and rounding have given.
  [[nodiscard]] Vector3<long double> initial_momentum() const { return initial_momentum_; }
  [[nodiscard]] Vector3<long double> gravity_impulse() const { return sum_of(gravity_impulse_); }
  [[nodiscard]] Vector3<long double> plane_impulse() const { return sum_of(plane_impulse_); }
  [[nodiscard]] Vector3<long double> momentum_rounding() const { return sum_of(momentum_rounding_); }
  /// Σ ‖Δ(x × m v + I w)‖ of impacts of two spheres, about the origin, which the laws keep; and the same beside
  /// Σ m ‖x‖ ‖v‖ of the impacts.
  [[nodiscard]] long double angular_momentum_rounding() const { return angular_rounding_.sum(); }
  [[nodiscard]] long double angular_momentum_scale() const { return angular_scale_; }

 private:
  using Momentum = std::array<Account, 3>;
  struct Held {
    long double mass;
    Vector3<long double> principal_inertia;
    bool is_polyhedron;
    Quaternion<double> orientation;  // at the start of its arc
    Energies energies;
  };
  /// How a body turns at a time.
  struct Spin {
    Quaternion<double> orientation;
    Vector3<long double> rate;  // world
  };

  [[nodiscard]] static Vector3<long double> sum_of(const Momentum& momentum);
  static void add(Momentum& account, const Vector3<long double>& amount);
  void follow(const scene::Arc& arc, double end, std::size_t body, const Spin& at_end);
  void round_energy(long double amount);
  /// Of a slow contact: along the normal the bodies are sent apart faster than the law says, or at all.
  [[nodiscard]] long double work_of_sending_apart(const scene::Event& event) const;
  /// The same of spheres, from the speeds along the normal alone.
  [[nodiscard]] long double work_of_raised_speed(const scene::Event& event) const;
  [[nodiscard]] Vector3<long double> spin_momentum(std::size_t body, const Spin& spin) const;
  [[nodiscard]] Energies energies_of(const scene::Arc& arc, double time, std::size_t body, const Spin& spin) const;

  const scene::Scene* scene_;
  Vector3<long double> gravity_;
  std::vector<Held> held_;
  std::vector<scene::Level> levels_;  // of each plane; gravity 0 where it is not level
  Energies initial_;
  Account translation_, rotation_, potential_;
  EnumArray<Cause, Account, all_causes.size()> energy_;
  Account gravity_work_, rounding_, angular_rounding_;
  long double scale_ = 0;
  long double heights_ = 0;
  long double angular_scale_ = 0;
  Vector3<long double> initial_momentum_;
  Momentum gravity_impulse_, plane_impulse_, momentum_rounding_;
};

}  // namespace carom::properties
