(* SPDX-License-Identifier: BSL-1.0 *)

(** Two bodies that touch at a point, and the laws of their impact. World frame, SI units. The impulse F acts on A at
    the point of contact, and -F acts on B. Symbols: normal N, restitution ε, friction μ, tangential restitution e_t,
    inertia J, lever arm r. Source: D. Eberly, Computing Impulse Forces for Colliding Contact, here without square
    roots. Source of rough and its cone: A. Chatterjee, A. Ruina, J. Appl. Mech. 65 (1998). *)

Require Import Bool Carom.operations Carom.vectors.

(** If the body is immovable, both inverses are 0. *)
Record body (T : Type) := a_body {
  inverse_mass : T;
  inverse_inertia : matrix T;
  centre : vector T;
  velocity : vector T;
  spin : vector T
}.
Arguments a_body {T}.
Arguments inverse_mass {T}.
Arguments inverse_inertia {T}.
Arguments centre {T}.
Arguments velocity {T}.
Arguments spin {T}.

Record contact (T : Type) := a_contact {
  body_a : body T;
  body_b : body T;
  point : vector T;
  normal : vector T;  (* on B, towards A; of any length except 0 *)
  restitution : T;
  friction : T;
  tangential_restitution : T
}.
Arguments a_contact {T}.
Arguments body_a {T}.
Arguments body_b {T}.
Arguments point {T}.
Arguments normal {T}.
Arguments restitution {T}.
Arguments friction {T}.
Arguments tangential_restitution {T}.

Section Laws.
  Context {T : Type} {of_T : operations T}.
  Local Open Scope number_scope.

  Definition lever_arm (b : body T) (p : vector T) := difference p (centre b).
  Definition velocity_at (b : body T) (p : vector T) := sum (velocity b) (cross (spin b) (lever_arm b p)).

  (** V, the velocity of the material point of A relative to that of B. *)
  Definition relative_velocity (c : contact T) :=
    difference (velocity_at (body_a c) (point c)) (velocity_at (body_b c) (point c)).
  Definition approach (c : contact T) := dot (normal c) (relative_velocity c).

  (** λ = 1/m_A + 1/m_B. *)
  Definition inverse_masses (c : contact T) := inverse_mass (body_a c) + inverse_mass (body_b c).

  (** [r]ᵀ J⁻¹ [r], the term of the collision matrix from the rotation of a body. *)
  Definition of_spin (b : body T) (p : vector T) :=
    let r := cross_matrix (lever_arm b p) in
    product (transposed r) (product (inverse_inertia b) r).

  (** K = λI + [r_A]ᵀJ_A⁻¹[r_A] + [r_B]ᵀJ_B⁻¹[r_B]. *)
  Definition collision_matrix (c : contact T) :=
    matrix_sum (uniform (inverse_masses c))
               (matrix_sum (of_spin (body_a c) (point c)) (of_spin (body_b c) (point c))).

  (** N·K N. *)
  Definition normal_compliance (c : contact T) := dot (normal c) (applied (collision_matrix c) (normal c)).

  Definition frictionless_impulse (c : contact T) :=
    scaled (- ((1 + restitution c) * approach c) / normal_compliance c) (normal c).

  Definition reflection_impulse (c : contact T) :=
    scaled (- ((1 + restitution c) * approach c) / dot (normal c) (normal c))
           (solved (collision_matrix c) (normal c)).

  Definition sticking_impulse (c : contact T) :=
    negated (solved (collision_matrix c)
                    (sum (relative_velocity c)
                         (scaled (restitution c * approach c / dot (normal c) (normal c)) (normal c)))).

  (** P_I stops the approach, P_II stops the point of contact, and D = P_II - P_I. *)
  Definition stops_approach (c : contact T) := scaled (- approach c / normal_compliance c) (normal c).
  Definition stops_point (c : contact T) := negated (solved (collision_matrix c) (relative_velocity c)).
  Definition from_one_to_other (c : contact T) := difference (stops_point c) (stops_approach c).

  (** The impulse of rough with the factor κ of friction: F = (1+ε) P_I + κ D. *)
  Definition rough_with (c : contact T) (kappa : T) :=
    sum (scaled (1 + restitution c) (stops_approach c)) (scaled kappa (from_one_to_other c)).
  Definition squared (x : T) := x * x.
  Definition square (v : vector T) := dot v v.

  (** ‖N × F‖ ≤ μ N·F, decided without a root. *)
  Definition in_cone (c : contact T) (f : vector T) : bool :=
    let push := dot (normal c) f in
    negb (less push 0) && negb (less (squared (friction c * push)) (square (cross (normal c) f))).

  Definition sticks_in_cone (c : contact T) : bool :=
    in_cone c (rough_with c (1 + tangential_restitution c)).

  (** s = ‖N × D‖². *)
  Definition radicand (c : contact T) := square (cross (normal c) (from_one_to_other c)).

  (** The κ with F on the surface of the cone, μ (1+ε) N·P_I / (√s - μ N·D), as the pair (p, q) with κ = p + q √s. If s
      = (μ N·D)², the divisor is -2 μ N·D, and q is 0. *)
  Definition on_the_cone (c : contact T) :=
    let push := friction c * (1 + restitution c) * dot (normal c) (stops_approach c) in
    let d := friction c * dot (normal c) (from_one_to_other c) in
    let rest := radicand c - squared d in
    if less rest 0 || less 0 rest then (push / rest * d, push / rest) else (push / - (d + d), 0).

  (** The κ of rough, as the pair (p, q) with κ = p + q √s. Inside the cone, q is 0. *)
  Definition rough_kappa (c : contact T) :=
    if sticks_in_cone c then (1 + tangential_restitution c, 0) else on_the_cone c.

  (** The impulse of rough is the first vector plus √s times the second. *)
  Definition rough_impulses (c : contact T) :=
    let (p, q) := rough_kappa c in (rough_with c p, scaled q (from_one_to_other c)).

  (** The body after an impulse f at p. *)
  Definition pushed (b : body T) (p f : vector T) :=
    a_body (inverse_mass b) (inverse_inertia b) (centre b)
           (sum (velocity b) (scaled (inverse_mass b) f))
           (sum (spin b) (applied (inverse_inertia b) (cross (lever_arm b p) f))).

  Definition after (c : contact T) (f : vector T) :=
    a_contact (pushed (body_a c) (point c) f) (pushed (body_b c) (point c) (negated f))
              (point c) (normal c) (restitution c) (friction c) (tangential_restitution c).

  (** A body can move, and N·V⁻ < 0. *)
  Definition is_colliding (c : contact T) : bool := less 0 (inverse_masses c) && less (approach c) 0.

  Definition resolved (law : contact T -> vector T) (c : contact T) :=
    if is_colliding c then after c (law c) else c.
End Laws.
