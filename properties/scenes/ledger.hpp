// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <string_view>
#include <vector>

#include <carom/collision/enum_array.hpp>
#include <carom/collision/vector.hpp>
#include <carom/scene/event.hpp>

namespace carom::properties {

/// A cause that changes a scene's mechanical energy.
enum class Cause {
  impacts,        // impacts of two bodies, by the law
  plane_impacts,  // impacts with planes, by the law
  slow_contacts,  // the run itself sends bodies apart at the least speed that it follows
  sliding,        // friction on planes
  rolling,        // rolling resistance
  spinning,       // resistance to spin about a plane's normal
  rounding,       // rounding of the stored states
};
inline constexpr std::array all_causes{Cause::impacts, Cause::plane_impacts, Cause::slow_contacts, Cause::sliding,
                                       Cause::rolling, Cause::spinning,      Cause::rounding};
static_assert(counts_from_zero_to(all_causes, Cause::rounding));

[[nodiscard]] std::string_view name_of(Cause cause);

/// A compensated sum in long double (A. Neumaier, "Rundungsfehleranalyse einiger Verfahren zur Summation endlicher
/// Summen", ZAMM 54, 1974).
class Account {
 public:
  void add(long double amount);
  [[nodiscard]] long double sum() const { return sum_ + compensation_; }

 private:
  long double sum_ = 0;
  long double compensation_ = 0;
};

struct Energies {
  long double translation = 0;  // [J]
  long double rotation = 0;     // [J]
  long double potential = 0;    // −m g·x [J]
  [[nodiscard]] long double total() const { return translation + rotation + potential; }
};

/// The account of a scene's energy and momenta by cause. The energy of a cause comes from the closed form of the law or
/// of the phase, never from the difference of two energies. For an impact of a polyhedron, the energy is F·V⁻ + ½ F·K
/// F, with F the outcome's impulse on A. The ledger books the rest of each change as rounding. All numbers are long
/// double, so the ledger's own rounding is 2⁻¹¹ of the rounding of a state to double.
///
/// Each entry of rounding has its own bound, from the numbers of its event or arc (ledger.cpp). The ledger closes if
/// each entry is within its bound, however many events there are.
class Ledger {
 public:
  /// The scene that the state refers to must outlive the ledger.
  explicit Ledger(const scene::SceneState& state);

  void record(const scene::Event& event);
  /// Follows all bodies up to the state's time. Call it once, after the last event.
  void close(const scene::SceneState& state);

  [[nodiscard]] long double energy(Cause cause) const { return energy_[cause].sum(); }
  /// Σ |rounding| over the entries [J].
  [[nodiscard]] long double rounding_without_signs() const { return rounding_.sum(); }
  /// The potential energy that gravity turned into kinetic energy [J].
  [[nodiscard]] long double gravity_work() const { return gravity_work_.sum(); }
  [[nodiscard]] const Energies& initial() const { return initial_; }
  /// The energies at each body's last recorded event, or at the beginning if the body had none.
  [[nodiscard]] Energies present() const;
  /// The reference for rounding [J]: the greatest kinetic energy so far, plus Σ m |g·x| of the initial positions.
  [[nodiscard]] long double scale() const { return scale_; }
  /// The energy that the run itself added, by slow contacts, relative to the scale at the beginning.
  [[nodiscard]] double added() const {
    const long double energy = energy_[Cause::slow_contacts].sum();
    return energy > 0 ? static_cast<double>(energy / first_scale_) : 0;
  }
  /// The rounding of the energy, and the sum of the bounds of all entries, both relative to the scale.
  [[nodiscard]] double relative_rounding() const { return relative(std::abs(energy(Cause::rounding))); }
  [[nodiscard]] double rounding_limit() const { return relative(bounds_.sum()); }
  /// The greatest |rounding| of an entry, in units of its bound; infinite if the rounding is not a number.
  [[nodiscard]] double worst_rounding() const { return worst_rounding_; }
  [[nodiscard]] bool is_closed() const { return worst_rounding_ <= 1; }
  /// Momentum [N s]: initial, and by cause. Planes act by impacts, and by their reaction on bodies that lie on them.
  [[nodiscard]] Vector3<long double> initial_momentum() const { return initial_momentum_; }
  [[nodiscard]] Vector3<long double> gravity_impulse() const { return sum_of(gravity_impulse_); }
  [[nodiscard]] Vector3<long double> plane_impulse() const { return sum_of(plane_impulse_); }
  [[nodiscard]] Vector3<long double> momentum_rounding() const { return sum_of(momentum_rounding_); }
  /// Σ ‖Δ(x × m v + I w)‖ about the origin [N m s], over impacts of two bodies and renewals. The laws keep this
  /// momentum, so the sum is rounding. `angular_momentum_scale` is the greatest Σ m ‖x‖ ‖v‖ at one event.
  [[nodiscard]] long double angular_momentum_rounding() const { return angular_rounding_.sum(); }
  [[nodiscard]] long double angular_momentum_scale() const { return angular_scale_; }

 private:
  using Momentum = std::array<Account, 3>;
  struct BookedBody {
    long double mass;
    Vector3<long double> principal_inertia;
    bool is_polyhedron;
    Quaternion<double> orientation;  // at the start of its current arc
    Energies energies;
  };
  struct Spin {
    Quaternion<double> orientation;
    Vector3<long double> rate;  // world
  };

  [[nodiscard]] static Vector3<long double> sum_of(const Momentum& momentum);
  static void add(Momentum& account, const Vector3<long double>& amount);
  void follow(const scene::Arc& arc, double end, std::size_t body, const Spin& at_end);
  [[nodiscard]] double relative(long double energy) const {
    return scale_ > 0 ? static_cast<double>(energy / scale_) : 0;
  }
  /// Books rounding [J] with its bound [J].
  void round_energy(long double amount, long double bound);
  /// The work that sends the bodies of a slow contact apart along the normal, beyond the law's outcome [J].
  [[nodiscard]] long double work_of_sending_apart(const scene::Event& event) const;
  /// `work_of_sending_apart` of spheres, from the speeds along the normal [J].
  [[nodiscard]] long double work_of_raised_speed(const scene::Event& event) const;
  [[nodiscard]] Vector3<long double> spin_momentum(std::size_t body, const Spin& spin) const;
  [[nodiscard]] Energies energies_of(const scene::Arc& arc, double time, std::size_t body, const Spin& spin) const;
  /// m Σ |g_k| (|x_k| + |v_k| s + |a_k| s²/2), the size of the terms of the potential energy on an arc [J].
  [[nodiscard]] long double size_of_heights(const scene::Arc& arc, long double span, std::size_t body) const;

  const scene::Scene* scene_;
  Vector3<long double> gravity_;
  std::vector<BookedBody> bodies_;
  Energies initial_;
  Account translation_, rotation_, potential_;
  EnumArray<Cause, Account, all_causes.size()> energy_;
  Account gravity_work_, rounding_, bounds_, angular_rounding_;
  double worst_rounding_ = 0;
  long double scale_ = 0;
  long double first_scale_ = 0;
  long double heights_ = 0;
  long double angular_scale_ = 0;
  Vector3<long double> initial_momentum_;
  Momentum gravity_impulse_, plane_impulse_, momentum_rounding_;
};

}  // namespace carom::properties
