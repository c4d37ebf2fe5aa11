(* SPDX-License-Identifier: BSL-1.0 *)

(** K ⪯ 16 λI, so the condition number of K is at most 16 for all masses. This holds for bodies whose second moments S
    dominate the lever arm r: rrᵀ ⪯ 15 S. star_shaped.v proves rrᵀ ⪯ 15 S for uniform star-shaped bodies. With rrᵀ ⪯ k
    S, K ⪯ (1 + k) λI. *)

Require Import Carom.reals Carom.collision_matrix.
Local Open Scope R_scope.

Definition trace (m : matrix R) := x_of (row_x m) + y_of (row_y m) + z_of (row_z m).

(** tr(M) I - M. *)
Definition trace_without (m : matrix R) :=
  rows (difference (vec (trace m) 0 0) (row_x m))
       (difference (vec 0 (trace m) 0) (row_y m))
       (difference (vec 0 0 (trace m)) (row_z m)).

(** J = m (tr(S) I - S) for a body of this mass. S is the mean of xxᵀ about the centre. *)
Definition inertia (mass : R) (s : matrix R) := product (uniform mass) (trace_without s).

(** rrᵀ ⪯ k S, as an inequality of forms. *)
Definition dominates_by (k : R) (s : matrix R) (r : vector R) :=
  forall v, dot r v * dot r v <= k * dot v (applied s v).
Definition dominates := dominates_by 15.

(** The body is movable, and its inverse inertia is the inverse of the J of these moments. *)
Record has_moments (b : body R) (mass : R) (s : matrix R) : Prop := {
  positive_mass : 0 < mass;
  inverse_of_mass : inverse_mass b = 1 / mass;
  inverse_of_inertia : forall v, applied (inertia mass s) (applied (inverse_inertia b) v) = v
}.

Lemma applied_inertia (mass : R) (s : matrix R) (v : vector R) :
  applied (inertia mass s) v = scaled mass (difference (scaled (trace s) v) (applied s v)).
Proof. unfold inertia, trace_without, trace; by_ring. Qed.

Lemma inertia_form (mass : R) (s : matrix R) (z : vector R) :
  dot z (applied (inertia mass s) z) = mass * (trace s * square z - dot z (applied s z)).
Proof. rewrite applied_inertia; unfold trace; by_ring. Qed.

(** tr(M) |z|² - z·Mz = Σ (e × z)·M(e × z), summed over the three axes e. *)
Lemma trace_without_form (m : matrix R) (z : vector R) :
  let turned e := cross e z in
  trace m * square z - dot z (applied m z) =
  dot (turned (vec 1 0 0)) (applied m (turned (vec 1 0 0))) +
  dot (turned (vec 0 1 0)) (applied m (turned (vec 0 1 0))) +
  dot (turned (vec 0 0 1)) (applied m (turned (vec 0 0 1))).
Proof. unfold trace; by_ring. Qed.

(** Hence tr(M) I - M ⪰ 0 if M ⪰ 0. *)
Lemma trace_without_semidefinite (m : matrix R) (z : vector R) :
  positive_semidefinite m -> 0 <= trace m * square z - dot z (applied m z).
Proof.
  intros semidefinite; rewrite trace_without_form; cbv zeta beta.
  pose proof (semidefinite (cross (vec 1 0 0) z)); pose proof (semidefinite (cross (vec 0 1 0) z));
    pose proof (semidefinite (cross (vec 0 0 1) z)); lra.
Qed.

Lemma dominates_semidefinite (k : R) (s : matrix R) (r : vector R) :
  0 < k -> dominates_by k s r -> positive_semidefinite s.
Proof. intros positive dominated v; pose proof (dominated v); assert (0 <= dot r v * dot r v) by nra; nra. Qed.

(** |r × z|², as a sum over the three axes e. *)
Lemma square_cross_by_axes (r z : vector R) :
  square (cross r z) =
  dot r (cross (vec 1 0 0) z) * dot r (cross (vec 1 0 0) z) +
  dot r (cross (vec 0 1 0) z) * dot r (cross (vec 0 1 0) z) +
  dot r (cross (vec 0 0 1) z) * dot r (cross (vec 0 0 1) z).
Proof. by_ring. Qed.

(** J ⪰ (m/k) [r]ᵀ[r]. *)
Lemma inertia_bounded (k mass : R) (s : matrix R) (r z : vector R) :
  0 <= mass -> dominates_by k s r -> mass * square (cross r z) <= k * dot z (applied (inertia mass s) z).
Proof.
  intros positive dominated; rewrite inertia_form, trace_without_form, square_cross_by_axes; cbv zeta beta.
  pose proof (dominated (cross (vec 1 0 0) z)) as x; pose proof (dominated (cross (vec 0 1 0) z)) as y;
    pose proof (dominated (cross (vec 0 0 1) z)) as z'.
  revert x y z'; generalize (dot r (cross (vec 1 0 0) z)) (dot r (cross (vec 0 1 0) z))
    (dot r (cross (vec 0 0 1) z)) (dot (cross (vec 1 0 0) z) (applied s (cross (vec 1 0 0) z)))
    (dot (cross (vec 0 1 0) z) (applied s (cross (vec 0 1 0) z)))
    (dot (cross (vec 0 0 1) z) (applied s (cross (vec 0 0 1) z))).
  intros a b c d e f first second third.
  replace (k * (mass * (d + e + f))) with (mass * (k * d + k * e + k * f)) by ring.
  apply Rmult_le_compat_l; lra.
Qed.

(** [r]ᵀJ⁻¹[r] ⪯ (k/m) I. *)
Lemma of_spin_bounded (k mass : R) (s : matrix R) (b : body R) (p x : vector R) :
  0 <= k -> has_moments b mass s -> dominates_by k s (lever_arm b p) ->
  dot x (applied (of_spin b p) x) <= k * inverse_mass b * square x.
Proof.
  intros not_negative [positive -> inverse] dominated; rewrite of_spin_form.
  set (y := cross (lever_arm b p) x); set (z := applied (inverse_inertia b) y).
  pose proof (inertia_bounded k mass s (lever_arm b p) z (Rlt_le _ _ positive) dominated) as bounded.
  replace (applied (inertia mass s) z) with y in bounded by (symmetry; apply inverse).
  pose proof (dot_at_most (cross (lever_arm b p) z) x) as schwarz.
  replace (dot (cross (lever_arm b p) z) x) with (- dot y z) in schwarz
    by (unfold y; generalize (lever_arm b p); by_ring).
  rewrite (dot_symmetric z y) in bounded.
  pose proof (square_nonnegative x) as long; pose proof (square_nonnegative (cross (lever_arm b p) z)) as turned.
  revert bounded schwarz long turned; generalize (dot y z) (square (cross (lever_arm b p) z)) (square x).
  intros e t q bounded schwarz long turned.
  assert (mass * (e * e) <= k * e * q) as squared by nra.
  replace (k * (1 / mass) * q) with (k * q / mass) by (field; lra).
  assert (0 <= k * q) by nra.
  assert (mass * e <= k * q) as least by (destruct (Rle_lt_dec e 0); nra).
  apply (Rmult_le_reg_l mass); auto; replace (mass * (k * q / mass)) with (k * q) by (field; lra); auto.
Qed.

(** The body is immovable, or its moments dominate the lever arm to the point. *)
Definition is_dominated (k : R) (b : body R) (p : vector R) :=
  is_immovable b \/ exists mass s, has_moments b mass s /\ dominates_by k s (lever_arm b p).

Lemma dominated_of_spin (k : R) (b : body R) (p x : vector R) :
  0 <= k -> is_dominated k b p -> dot x (applied (of_spin b p) x) <= k * inverse_mass b * square x.
Proof.
  intros not_negative [[-> no_inertia] | (mass & s & moments & dominated)].
  - rewrite of_spin_form, no_inertia, applied_zero_matrix.
    replace (dot _ null) with 0 by (generalize (cross (lever_arm b p) x); by_ring); lra.
  - apply (of_spin_bounded k mass s); auto.
Qed.

(** K ⪯ (1 + k) λI. *)
Theorem well_conditioned_by (k : R) (c : contact R) :
  0 <= k -> is_dominated k (body_a c) (point c) -> is_dominated k (body_b c) (point c) ->
  at_most ((1 + k) * inverse_masses c) (collision_matrix c).
Proof.
  intros not_negative dominated_a dominated_b x; rewrite collision_matrix_form.
  pose proof (dominated_of_spin k (body_a c) (point c) x not_negative dominated_a).
  pose proof (dominated_of_spin k (body_b c) (point c) x not_negative dominated_b).
  unfold inverse_masses; reals; fold (square x); lra.
Qed.

(** u·Ku ≤ (1 + k) v·Kv, for vectors u and v of one length. *)
Theorem condition_number_by (k : R) (c : contact R) (u v : vector R) :
  0 <= k -> is_valid c -> is_dominated k (body_a c) (point c) -> is_dominated k (body_b c) (point c) ->
  square u = square v ->
  dot u (applied (collision_matrix c) u) <= (1 + k) * dot v (applied (collision_matrix c) v).
Proof.
  intros not_negative valid dominated_a dominated_b as_long.
  pose proof (well_conditioned_by k c not_negative dominated_a dominated_b u) as above.
  pose proof (definite c valid v) as below; rewrite as_long in above.
  apply (Rmult_le_compat_l (1 + k)) in below; lra.
Qed.

(** K ⪯ 16 λI. *)
Theorem well_conditioned (c : contact R) :
  is_valid c -> is_dominated 15 (body_a c) (point c) -> is_dominated 15 (body_b c) (point c) ->
  at_most (16 * inverse_masses c) (collision_matrix c).
Proof.
  intros _ dominated_a dominated_b; replace 16 with (1 + 15) by lra; apply well_conditioned_by; auto; lra.
Qed.

Theorem condition_number (c : contact R) (u v : vector R) :
  is_valid c -> is_dominated 15 (body_a c) (point c) -> is_dominated 15 (body_b c) (point c) ->
  square u = square v ->
  dot u (applied (collision_matrix c) u) <= 16 * dot v (applied (collision_matrix c) v).
Proof. replace 16 with (1 + 15) by lra; intros; apply condition_number_by; auto; lra. Qed.
