// SPDX-License-Identifier: BSL-1.0
#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include <fmt/format.h>

#include "drawn_defects.hpp"

namespace carom::mutants {
namespace {

using Vector = Vector3<double>;
using Matrix = Matrix3<double>;
using ContactBody = impulse::ContactBody<double>;
using Contact = impulse::Contact<double>;

constexpr std::array body_fields{&Collision::a, &Collision::b};

bool are_movable(const Collision& c) { return !c.a.immovable && !c.b.immovable; }

bool is_sphere(const Vector& inverse_moments) {
  return inverse_moments[0] == inverse_moments[1] && inverse_moments[1] == inverse_moments[2];
}

// Masses, moments, coefficients.

DrawnDefect mass_multiplied(Random& random) {
  const double c = random.factor();
  const Which which = drawn_bodies(random);
  DrawnDefect defect{.words = fmt::format("the mass of {} is multiplied by {}", which.words, c),
                     .named_by = fmt::format("mass & %times & {}", which.part)};
  change_data(defect, which, random.one_of<unsigned>({everywhere, in_matrix, in_application}),
              [c](ContactBody& body, const Body&) { body.inverse_mass /= c; });
  if (defect.change.uses == in_application) {
    defect.named_by += fmt::format(" | velocity & %times & {} & !relative", which.part);
  }
  return defect;
}

DrawnDefect moments_multiplied(Random& random) {
  const double c = random.factor();
  const Which which = drawn_bodies(random);
  DrawnDefect defect{.words = fmt::format("the moments of {} are multiplied by {}", which.words, c),
                     .named_by = fmt::format("moments & %times & {0} | inertia & %times & {0}", which.part)};
  change_data(defect, which, random.one_of<unsigned>({everywhere, in_matrix, in_application}),
              [c](ContactBody& body, const Body&) { body.inertia.inverse_moments /= c; });
  if (defect.change.uses == in_application) {
    defect.named_by += fmt::format(" | spin & %times & {0} | torque & %times & {0}", which.part);
  }
  if (defect.change.uses == in_matrix) {
    defect.named_by += fmt::format(" | angular term & %times & {}", which.part);
  }
  return defect;
}

DrawnDefect moments_inverted(Random& random) {
  const Which which = drawn_bodies(random);
  DrawnDefect defect{.words = fmt::format("the moments of {} are used in place of their inverses", which.words),
                     .named_by = fmt::format("moments & inverse & {0} | I in place of 1/I & {0}", which.part)};
  change_data(defect, which, random.one_of<unsigned>({everywhere, in_matrix, in_application}),
              [](ContactBody& body, const Body&) {
                body.inertia.inverse_moments =
                    body.inertia.inverse_moments.unaryExpr([](double x) { return x > 0 ? 1 / x : x; });
              });
  return defect;
}

DrawnDefect moments_of_sphere(Random& random) {
  const int kind = static_cast<int>(random.below(3));
  constexpr std::array words{"the mean moment", "the greatest moment", "the first moment"};
  constexpr std::array shorts{"mean", "greatest", "first"};
  const Which which = drawn_bodies(random);
  DrawnDefect defect{
      .words = fmt::format("{} stands for all moments of {}", words[static_cast<std::size_t>(kind)], which.words),
      .named_by = fmt::format("moment & equal & {0} | sphere & {0} | moment & {1} & {0}", which.part,
                              shorts[static_cast<std::size_t>(kind)])};
  defect.change.read = [kind, which](Collision& c) {
    for (const auto field : body_fields) {
      if (field == &Collision::a ? which.a : which.b) {
        Vector& moments = (c.*field).principal_inertia;
        moments.setConstant(kind == 0 ? moments.sum() / 3 : (kind == 1 ? moments.maxCoeff() : moments[0]));
      }
    }
  };
  return defect;
}

DrawnDefect moments_permuted(Random& random) {
  struct Order {
    std::array<int, 3> of;
    const char* named_by;
  };
  const auto order = random.one_of<Order>({{{1, 0, 2}, "first two moments & %swapped"},
                                           {{0, 2, 1}, "last two moments & %swapped"},
                                           {{2, 1, 0}, "first and the last moment & %swapped"},
                                           {{1, 2, 0}, "moments & order y, z, x"},
                                           {{2, 0, 1}, "moments & order z, x, y"}});
  const Which which = drawn_bodies(random);
  DrawnDefect defect{.words = fmt::format("the moments of {} are taken in the order {}{}{}", which.words, order.of[0],
                                          order.of[1], order.of[2]),
                     .named_by = fmt::format("{} & {}", order.named_by, which.part)};
  change_data(defect, which, random.one_of<unsigned>({everywhere, in_matrix, in_application}),
              [order = order.of](ContactBody& body, const Body&) {
                const Vector given = body.inertia.inverse_moments;
                body.inertia.inverse_moments = {given[order[0]], given[order[1]], given[order[2]]};
              });
  return defect;
}

DrawnDefect data_swapped(Random& random) {
  const int kind = static_cast<int>(random.below(3));
  constexpr std::array words{"masses", "inertia tensors", "lever arms"};
  constexpr std::array names{"mass & %swapped", "moments & %swapped | inertia & %swapped | moments & other",
                             "lever arm & %swapped | lever arm & other"};
  DrawnDefect defect{.words = fmt::format("the {} of A and B are exchanged", words[static_cast<std::size_t>(kind)]),
                     .named_by = names[static_cast<std::size_t>(kind)]};
  const unsigned uses = random.one_of<unsigned>({everywhere, in_matrix, in_application});
  change_data(defect, no_body, uses, {});
  defect.change.data = [kind](Contact& contact, const Collision& read) {
    if (!are_movable(read)) {
      return;
    }
    if (kind == 0) {
      std::swap(contact.a.inverse_mass, contact.b.inverse_mass);
    } else if (kind == 1) {
      std::swap(contact.a.inertia, contact.b.inertia);
    } else {
      std::swap(contact.a.lever_arm, contact.b.lever_arm);
    }
  };
  return defect;
}

DrawnDefect immovable_has_mass(Random& random) {
  const double mass = random.log_between(1, 1e4);
  DrawnDefect defect{.words = fmt::format("an immovable body has a mass of {} kg", mass),
                     .named_by = "immovable & changes | immovable & mass"};
  defect.change.read = [mass](Collision& c) {
    for (const auto field : body_fields) {
      Body& body = c.*field;
      if (body.immovable) {
        body.immovable = false;
        body.mass = mass;
        body.principal_inertia.setConstant(mass);
        body.orientation = {1, 0, 0, 0};
      }
    }
  };
  return defect;
}

DrawnDefect coefficient_replaced(Random& random) {
  const int kind = static_cast<int>(random.below(3));
  const double c = random.between(0.05, 0.95);
  constexpr std::array words{"ε is {}", "ε is at most {}", "ε is multiplied by {}"};
  constexpr std::array names{"ε were | ε & constant | ε & replaced", "ε & %limit | ε were", "ε & %times"};
  DrawnDefect defect{.words = fmt::format(fmt::runtime(words[static_cast<std::size_t>(kind)]), c),
                     .named_by = names[static_cast<std::size_t>(kind)]};
  if (kind < 2) {
    defect.limit = c;
  }
  defect.change.read = [kind, c](Collision& collision) {
    double& e = collision.restitution;
    e = kind == 0 ? c : (kind == 1 ? std::min(e, c) : e * c);
  };
  return defect;
}

DrawnDefect restitution_squared(Random& random) {
  const bool is_root = random.below(2) == 0;
  DrawnDefect defect{.words = is_root ? "√ε stands for ε" : "ε² stands for ε",
                     .named_by = is_root ? "ε & root | √ε" : "ε & square | ε²"};
  defect.change.read = [is_root](Collision& c) {
    c.restitution = is_root ? std::sqrt(c.restitution) : c.restitution * c.restitution;
  };
  return defect;
}

DrawnDefect friction_replaced(Random& random) {
  const int kind = static_cast<int>(random.below(4));
  const double c = random.factor();
  constexpr std::array words{"μ is {}", "μ is at most {}", "μ is multiplied by {}", "μ² stands for μ"};
  constexpr std::array names{"μ were | μ & constant | μ & replaced", "μ & %limit", "μ & %times", "μ & square | μ²"};
  DrawnDefect defect{.words = fmt::format(fmt::runtime(words[static_cast<std::size_t>(kind)]), c),
                     .named_by = names[static_cast<std::size_t>(kind)]};
  if (kind < 2) {
    defect.limit = c;
  }
  defect.change.read = [kind, c](Collision& collision) {
    double& mu = collision.friction;
    const std::array changed{c, std::min(mu, c), mu * c, mu * mu};
    mu = std::isfinite(changed[static_cast<std::size_t>(kind)]) ? changed[static_cast<std::size_t>(kind)] : mu;
  };
  return defect;
}

DrawnDefect tangential_restitution_changed(Random& random) {
  const double c = random.one_of({-1.0, 0.0, random.between(0.1, 0.8)});
  const char* names = c < 0 ? "e_t & %sign | tangential restitution & %sign"
                            : (c > 0 ? "e_t & %times | tangential restitution & %times"
                                     : "e_t & %none | tangential restitution & %none");
  DrawnDefect defect{.words = fmt::format("e_t is multiplied by {}", c), .named_by = names};
  defect.change.read = [c](Collision& collision) { collision.tangential_restitution *= c; };
  return defect;
}

// Orientation.

DrawnDefect orientation_ignored(Random& random) {
  const Which which = drawn_bodies(random);
  return orientation_ignored_in(which, random.one_of<unsigned>({everywhere, in_matrix, in_application}));
}

DrawnDefect orientation_transposed(Random& random) {
  const Which which = drawn_bodies(random);
  DrawnDefect defect{.words = fmt::format("the rotation of {} is transposed", which.words),
                     .named_by = fmt::format("orientation & inverted & {0} | orientation & transposed & {0} | "
                                             "orientation & inverse & {0} | Rᵀ & {0}",
                                             which.part)};
  change_data(defect, which, random.one_of<unsigned>({everywhere, in_matrix, in_application}),
              [](ContactBody& body, const Body&) { body.inertia.axes.transposeInPlace(); });
  return defect;
}

DrawnDefect quaternion_order(Random& random) {
  const Which which = drawn_bodies(random);
  const bool is_reversed = random.below(2) == 0;
  DrawnDefect defect{.words = fmt::format("the quaternion of {} is read as {}", which.words,
                                          is_reversed ? "z, y, x, w" : "x, y, z, w"),
                     .named_by = fmt::format("quaternion & order & {}", which.part)};
  defect.change.read = [which, is_reversed](Collision& c) {
    for (const auto field : body_fields) {
      if (field == &Collision::a ? which.a : which.b) {
        Quaternion<double>& q = (c.*field).orientation;
        q = is_reversed ? Quaternion<double>(q[3], q[2], q[1], q[0]) : Quaternion<double>(q[3], q[0], q[1], q[2]);
      }
    }
  };
  return defect;
}

DrawnDefect quaternion_not_normalised(Random& random) {
  const Which which = drawn_bodies(random);
  DrawnDefect defect{
      .words = fmt::format("the quaternion of {} is taken to be of unit length", which.words),
      .named_by = fmt::format("quaternion & length & {0} | quaternion & normalised & {0} | quaternion & unit & {0}",
                              which.part)};
  change_data(defect, which, everywhere, [](ContactBody& body, const Body& read) {
    if (!read.immovable && !is_sphere(body.inertia.inverse_moments)) {
      const Quaternion<double>& q = read.orientation;
      const double squared_length = q.squaredNorm();
      // R = I + 2 (w [q] + [q]²)
      body.inertia.axes = Matrix::Identity() + (body.inertia.axes - Matrix::Identity()) * squared_length;
    }
  });
  return defect;
}

// Lever arms, the contact point and the normal.

DrawnDefect lever_arm_multiplied(Random& random) {
  const double c = random.below(3) == 0 ? -1 : random.factor();
  const Which which = drawn_bodies(random);
  DrawnDefect defect{.words = fmt::format("the lever arm of {} is multiplied by {}", which.words, c),
                     .named_by = fmt::format("lever arm & {} & {}", c < 0 ? "%sign" : "%times", which.part)};
  const unsigned uses = c < 0 ? random.one_of<unsigned>({everywhere, in_impulse, in_application})
                              : random.one_of<unsigned>({everywhere, in_velocity, in_matrix, in_application});
  change_data(defect, which, uses, [c](ContactBody& body, const Body&) { body.lever_arm *= c; });
  if (uses == in_application) {
    defect.named_by +=
        fmt::format(" | spin & {0} & {1} & !relative | torque & {0} & {1}", c < 0 ? "%sign" : "%times", which.part);
  }
  if (uses == in_matrix) {  // the square of the factor
    defect.named_by += fmt::format(" | angular term & %times & {}", which.part);
  }
  if (uses == in_velocity || (uses == in_impulse && c < 0)) {
    defect.named_by += fmt::format(" | spin & {} & {} & !changed", c < 0 ? "%sign" : "%times", which.part);
  }
  return defect;
}

DrawnDefect lever_arm_of_another_place(Random& random) {
  const int kind = static_cast<int>(random.below(3));
  constexpr std::array words{"from the world's origin", "from the centre of the other body", "as zero"};
  const Which which = drawn_bodies(random);
  const std::array names{fmt::format("lever arm & origin & {}", which.part),
                         fmt::format("lever arm & other body & {0} | lever arm & %swapped & {0}", which.part),
                         fmt::format("lever arm & %none & {0} | lever arm & centre of mass & {0}", which.part)};
  DrawnDefect defect{
      .words = fmt::format("the lever arm of {} is taken {}", which.words, words[static_cast<std::size_t>(kind)]),
      .named_by = names[static_cast<std::size_t>(kind)]};
  const unsigned uses = random.one_of<unsigned>({everywhere, in_velocity, in_matrix, in_impulse, in_application});
  change_data(defect, no_body, uses, {});
  defect.change.data = [which, kind](Contact& contact, const Collision& read) {
    const auto wrong = [&](const Body& other) -> Vector {
      return kind == 2 ? Vector(Vector::Zero()) : (kind == 1 ? Vector(read.point - other.position) : read.point);
    };
    contact.a.lever_arm = which.a ? wrong(read.b) : contact.a.lever_arm;
    contact.b.lever_arm = which.b ? wrong(read.a) : contact.b.lever_arm;
  };
  if (kind == 2 && uses == in_velocity) {
    defect.named_by += fmt::format(" | spin & %none & {}", which.part);
  }
  if (kind == 2 && (uses == in_matrix || uses == in_application)) {
    defect.named_by += fmt::format(" | rotate & {0} | turn & {0} | spin & %none & {0}", which.part);
  }
  return defect;
}

DrawnDefect short_lever_arm_as_zero(Random& random) {
  const double least = random.log_between(0.01, 0.3);
  DrawnDefect defect{.words = fmt::format("a lever arm shorter than {} m is taken for zero", least),
                     .named_by = "lever arm & %none | lever arm & centre of mass",
                     .limit = least};
  change_data(defect, all_bodies, everywhere, [least](ContactBody& body, const Body&) {
    if (body.lever_arm.norm() < least) {
      body.lever_arm.setZero();
    }
  });
  return defect;
}

DrawnDefect point_elsewhere(Random& random) {
  const int kind = static_cast<int>(random.below(3));
  const double d = random.log_between(1e-4, 0.1);
  const std::array words{fmt::format("the contact point is moved by {} m along the normal", d),
                         fmt::format("the contact point is moved by {} m along x", d),
                         std::string("the contact point is midway between the centres")};
  DrawnDefect defect{.words = words[static_cast<std::size_t>(kind)],
                     .named_by = kind < 2 ? "contact point & moved | contact point & displaced | contact point & off | "
                                            "contact point & away"
                                          : "contact point & mid | contact point & centres"};
  defect.change.read = [kind, d](Collision& c) {
    const Vector n = impulse::without_extreme_length<double>(c.normal);
    if (kind == 0) {
      c.point += n * (d / n.norm());
    } else if (kind == 1) {
      c.point[0] += d;
    } else {
      c.point = c.a.position / 2 + c.b.position / 2;
    }
  };
  return defect;
}

DrawnDefect normal_replaced(Random& random) {
  const int kind = static_cast<int>(random.below(3));
  constexpr std::array words{"points the other way", "joins the centres", "is the nearest axis"};
  constexpr std::array names{"normal & %sign | test for approach & %sign | separating & solved",
                             "normal & centres | normal & from B's centre to A's centre",
                             "normal & axis | normal & axes"};
  DrawnDefect defect{.words = fmt::format("the normal {}", words[static_cast<std::size_t>(kind)]),
                     .named_by = names[static_cast<std::size_t>(kind)]};
  defect.change.read = [kind](Collision& c) {
    const Vector between = c.a.position - c.b.position;
    if (kind == 0) {
      c.normal = -c.normal;
    } else if (kind == 1) {
      c.normal = between.stableNorm() > 0 && between.allFinite() ? between : c.normal;
    } else {
      int axis = 0;
      const double largest = c.normal.cwiseAbs().maxCoeff(&axis);
      c.normal = Vector(Vector::Unit(axis) * std::copysign(largest, c.normal[axis]));
    }
  };
  return defect;
}

DrawnDefect read_in_float(Random& random) {
  const int kind = static_cast<int>(random.below(3));
  constexpr std::array words{"positions and the contact point", "velocities and spins", "the normal and coefficients"};
  DrawnDefect defect{.words = fmt::format("{} are read in float", words[static_cast<std::size_t>(kind)]),
                     .named_by = "%float"};
  defect.change.read = [kind](Collision& c) {
    const auto in_float = [](auto&... vectors) {
      const auto round = [](Vector& v) {
        const Vector rounded = v.cast<float>().cast<double>();
        v = rounded.allFinite() ? rounded : v;
      };
      (round(vectors), ...);
    };
    if (kind == 0) {
      in_float(c.point, c.a.position, c.b.position);
    } else if (kind == 1) {
      in_float(c.a.velocity, c.b.velocity, c.a.angular_velocity, c.b.angular_velocity);
    } else {
      const Vector normal = c.normal.cast<float>().cast<double>();
      c.normal = normal.isZero(0) || !normal.allFinite() ? c.normal : normal;
      c.restitution = static_cast<double>(static_cast<float>(c.restitution));
    }
  };
  return defect;
}

// Limits of data.

DrawnDefect heavy_as_immovable(Random& random) {
  const double ratio = random.log_between(5, 1000);
  DrawnDefect defect{.words = fmt::format("a body {} times as heavy as the other is immovable", ratio),
                     .named_by = "heavier & immovable | heavy & immovable",
                     .limit = ratio};
  defect.change.read = [ratio](Collision& c) {
    if (are_movable(c)) {
      c.a.immovable = c.a.mass >= ratio * c.b.mass;
      c.b.immovable = c.b.mass >= ratio * c.a.mass;
    }
  };
  return defect;
}

DrawnDefect mass_ratio_capped(Random& random) {
  const double ratio = random.log_between(5, 1000);
  DrawnDefect defect{.words = fmt::format("the heavier mass is at most {} times the other", ratio),
                     .named_by = "mass & %limit & larger | mass & %limit & heavier | mass & ratio",
                     .limit = ratio};
  change_data(defect, no_body, random.one_of<unsigned>({everywhere, in_matrix}), {});
  defect.change.data = [ratio](Contact& contact, const Collision& read) {
    if (are_movable(read)) {
      double& a = contact.a.inverse_mass;
      double& b = contact.b.inverse_mass;
      a = std::max(a, b / ratio);
      b = std::max(b, a / ratio);
    }
  };
  return defect;
}

DrawnDefect moments_at_least(Random& random) {
  const double least = random.log_between(1e-4, 1);
  DrawnDefect defect{.words = fmt::format("each moment is at least {} kg m²", least),
                     .named_by = "moments & at least | moments & %limit | moments & raised",
                     .limit = least};
  change_data(defect, all_bodies, everywhere, [least](ContactBody& body, const Body&) {
    body.inertia.inverse_moments = body.inertia.inverse_moments.cwiseMin(1 / least);
  });
  return defect;
}

constexpr std::array kinds{
    DefectKind{"mass_multiplied", drawn_laws, mass_multiplied},
    DefectKind{"moments_multiplied", drawn_laws, moments_multiplied},
    DefectKind{"moments_inverted", drawn_laws, moments_inverted},
    DefectKind{"moments_of_sphere", drawn_laws, moments_of_sphere},
    DefectKind{"moments_permuted", drawn_laws, moments_permuted},
    DefectKind{"data_swapped", drawn_laws, data_swapped},
    DefectKind{"immovable_has_mass", drawn_laws, immovable_has_mass},
    DefectKind{"coefficient_replaced", drawn_laws, coefficient_replaced},
    DefectKind{"restitution_squared", drawn_laws, restitution_squared},
    DefectKind{"friction_replaced", laws_with_friction, friction_replaced},
    DefectKind{"tangential_restitution_changed", std::span(laws_with_friction).first(1),
               tangential_restitution_changed},
    DefectKind{"orientation_ignored", drawn_laws, orientation_ignored},
    DefectKind{"orientation_transposed", drawn_laws, orientation_transposed},
    DefectKind{"quaternion_order", drawn_laws, quaternion_order},
    DefectKind{"quaternion_not_normalised", drawn_laws, quaternion_not_normalised},
    DefectKind{"lever_arm_multiplied", drawn_laws, lever_arm_multiplied},
    DefectKind{"lever_arm_of_another_place", drawn_laws, lever_arm_of_another_place},
    DefectKind{"short_lever_arm_as_zero", drawn_laws, short_lever_arm_as_zero},
    DefectKind{"point_elsewhere", drawn_laws, point_elsewhere},
    DefectKind{"normal_replaced", drawn_laws, normal_replaced},
    DefectKind{"read_in_float", drawn_laws, read_in_float},
    DefectKind{"heavy_as_immovable", drawn_laws, heavy_as_immovable},
    DefectKind{"mass_ratio_capped", drawn_laws, mass_ratio_capped},
    DefectKind{"moments_at_least", drawn_laws, moments_at_least},
};

}  // namespace

DrawnDefect orientation_ignored_in(const Which& which, unsigned uses) {
  DrawnDefect defect{
      .words = fmt::format("the orientation of {} is taken for the identity", which.words),
      .named_by = fmt::format("orientation & identity & {0} | orientation & %none & {0} | orientation & never & {0}",
                              which.part)};
  change_data(defect, which, uses, [](ContactBody& body, const Body& read) {
    if (!read.immovable) {
      body.inertia.axes = Matrix::Identity();
    }
  });
  return defect;
}

std::span<const DefectKind> kinds_of_data() { return kinds; }

}  // namespace carom::mutants
