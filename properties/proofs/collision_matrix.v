(* SPDX-License-Identifier: BSL-1.0 *)

(** The collision matrix: V⁺ = V⁻ + K F, K is symmetric, and K ⪰ λI. Eliminations on K have no pivot below λ. Symbols:
    laws.v. *)

Require Import Carom.reals.
Local Open Scope R_scope.

Lemma of_spin_applied (b : body R) (p f : vector R) :
  applied (of_spin b p) f = cross (applied (inverse_inertia b) (cross (lever_arm b p) f)) (lever_arm b p).
Proof.
  unfold of_spin; rewrite !applied_product; generalize (lever_arm b p) (inverse_inertia b); by_ring.
Qed.

Lemma collision_matrix_applied (c : contact R) (f : vector R) :
  applied (collision_matrix c) f =
  sum (scaled (inverse_masses c) f)
      (sum (applied (of_spin (body_a c) (point c)) f) (applied (of_spin (body_b c) (point c)) f)).
Proof. unfold collision_matrix; rewrite !applied_matrix_sum, applied_uniform; reflexivity. Qed.

(** V⁺ = V⁻ + K F (Eberly's note, eq. 24). *)
Theorem velocity_change (c : contact R) (f : vector R) :
  relative_velocity (after c f) = sum (relative_velocity c) (applied (collision_matrix c) f).
Proof.
  rewrite collision_matrix_applied, !of_spin_applied.
  unfold relative_velocity, velocity_at, after, inverse_masses, pushed, lever_arm;
    cbn [body_a body_b point velocity spin centre inverse_mass inverse_inertia].
  generalize (difference (point c) (centre (body_a c))) (difference (point c) (centre (body_b c))).
  generalize (velocity (body_a c)) (velocity (body_b c)) (spin (body_a c)) (spin (body_b c)).
  generalize (inverse_inertia (body_a c)) (inverse_inertia (body_b c)) (inverse_mass (body_a c))
    (inverse_mass (body_b c)).
  by_ring.
Qed.

(** x·[r]ᵀJ⁻¹[r]x = (r × x)·J⁻¹(r × x). *)
Lemma of_spin_form (b : body R) (p v w : vector R) :
  dot v (applied (of_spin b p) w) =
  dot (cross (lever_arm b p) v) (applied (inverse_inertia b) (cross (lever_arm b p) w)).
Proof. rewrite of_spin_applied; generalize (lever_arm b p) (inverse_inertia b); by_ring. Qed.

(** v·Kw = λ v·w + Σ (r × v)·J⁻¹(r × w). *)
Lemma collision_matrix_form (c : contact R) (v w : vector R) :
  dot v (applied (collision_matrix c) w) =
  inverse_masses c * dot v w + (dot v (applied (of_spin (body_a c) (point c)) w) +
                                dot v (applied (of_spin (body_b c) (point c)) w)).
Proof. rewrite collision_matrix_applied, !dot_sum, dot_scaled; reflexivity. Qed.

Theorem collision_matrix_symmetric (c : contact R) : is_valid c -> symmetric (collision_matrix c).
Proof.
  intros [[symmetric_a _] [symmetric_b _]] v w.
  rewrite !collision_matrix_form, !of_spin_form, (dot_symmetric v w), symmetric_a, symmetric_b; reflexivity.
Qed.

(** K ⪰ λI. *)
Theorem definite (c : contact R) : is_valid c -> at_least (inverse_masses c) (collision_matrix c).
Proof.
  intros [[_ [semidefinite_a _]] [_ [semidefinite_b _]]] v.
  rewrite collision_matrix_form, !of_spin_form.
  pose proof (semidefinite_a (cross (lever_arm (body_a c) (point c)) v)).
  pose proof (semidefinite_b (cross (lever_arm (body_b c) (point c)) v)).
  unfold square; lra.
Qed.

Lemma semidefinite (c : contact R) : is_valid c -> positive_semidefinite (collision_matrix c).
Proof.
  intros valid v; pose proof (definite c valid v); pose proof (square_nonnegative v).
  pose proof (one_moves c valid); nra.
Qed.

Lemma positive_form (c : contact R) (v : vector R) :
  is_valid c -> v <> null -> 0 < dot v (applied (collision_matrix c) v).
Proof.
  intros valid not_null; pose proof (definite c valid v); pose proof (square_positive v not_null);
    pose proof (one_moves c valid); nra.
Qed.

(** The pivots of an elimination without exchanges (LDLᵀ): the second and third are Schur complements. *)
Definition first_pivot (m : matrix R) := x_of (row_x m).
Definition second_minor (m : matrix R) := x_of (row_x m) * y_of (row_y m) - y_of (row_x m) * x_of (row_y m).
Definition second_pivot (m : matrix R) := second_minor m / first_pivot m.
Definition third_pivot (m : matrix R) := determinant m / second_minor m.

Lemma entries_symmetric (m : matrix R) :
  symmetric m ->
  y_of (row_x m) = x_of (row_y m) /\ z_of (row_x m) = x_of (row_z m) /\ z_of (row_y m) = y_of (row_z m).
Proof.
  intros is_symmetric.
  pose proof (is_symmetric (vec 1 0 0) (vec 0 1 0)) as xy; pose proof (is_symmetric (vec 1 0 0) (vec 0 0 1)) as xz;
    pose proof (is_symmetric (vec 0 1 0) (vec 0 0 1)) as yz.
  clear is_symmetric; taken_apart; in_components; repeat split; lra.
Qed.

Lemma long (v : vector R) : y_of v = 1 \/ z_of v = 1 -> 1 <= square v.
Proof. destruct v as [x y z]; in_components; intros [-> | ->]; nra. Qed.

(** Each pivot is v·Mv for a vector v of length 1 or more. *)
Lemma second_pivot_form (m : matrix R) :
  symmetric m -> first_pivot m <> 0 ->
  let v := vec (- y_of (row_x m) / first_pivot m) 1 0 in dot v (applied m v) = second_pivot m.
Proof.
  intros is_symmetric not_zero; apply entries_symmetric in is_symmetric as (xy & _ & _).
  unfold second_pivot, second_minor, first_pivot in *; taken_apart; in_components; subst; field; auto.
Qed.

Lemma third_pivot_form (m : matrix R) :
  symmetric m -> second_minor m <> 0 ->
  let v := scaled (/ second_minor m) (cross (row_x m) (row_y m)) in dot v (applied m v) = third_pivot m /\ z_of v = 1.
Proof.
  intros is_symmetric not_zero; apply entries_symmetric in is_symmetric as (xy & xz & yz).
  unfold third_pivot, second_minor in *; taken_apart; in_components; subst; split; field; auto.
Qed.

Section Pivots.
  Variables (s : R) (m : matrix R).
  Hypotheses (positive : 0 < s) (is_symmetric : symmetric m) (bounded : at_least s m).

  Theorem first_pivot_bounded : s <= first_pivot m.
  Proof.
    pose proof (bounded (vec 1 0 0)) as form; unfold first_pivot; revert form; clear; destruct m as [[] [] []];
      in_components; lra.
  Qed.

  Theorem second_pivot_bounded : s <= second_pivot m.
  Proof.
    pose proof first_pivot_bounded as first.
    rewrite <- second_pivot_form by (auto; lra).
    eapply Rle_trans; [| apply bounded].
    pose proof (long (vec (- y_of (row_x m) / first_pivot m) 1 0) (or_introl eq_refl)); nra.
  Qed.

  Theorem second_minor_positive : 0 < second_minor m.
  Proof.
    pose proof first_pivot_bounded as first; pose proof second_pivot_bounded as second; unfold second_pivot in *.
    replace (second_minor m) with (second_minor m / first_pivot m * first_pivot m) by (field; lra); nra.
  Qed.

  Theorem third_pivot_bounded : s <= third_pivot m.
  Proof.
    pose proof second_minor_positive as minor.
    destruct (third_pivot_form m is_symmetric) as [<- last]; [lra |].
    eapply Rle_trans; [| apply bounded].
    pose proof (long _ (or_intror last)); nra.
  Qed.

  Theorem determinant_bounded : s * s * s <= determinant m.
  Proof.
    pose proof first_pivot_bounded as first; pose proof second_pivot_bounded as second;
      pose proof third_pivot_bounded as third; pose proof second_minor_positive.
    unfold third_pivot, second_pivot in *.
    replace (determinant m) with
      (first_pivot m * (second_minor m / first_pivot m) * (determinant m / second_minor m)) by (field; lra).
    set (p := second_minor m / first_pivot m) in *; set (q := determinant m / second_minor m) in *.
    assert (s * s <= first_pivot m * p) by nra; nra.
  Qed.
End Pivots.

(** det K ≥ λ³, so that K can be inverted. *)
Theorem collision_matrix_determinant (c : contact R) :
  is_valid c -> inverse_masses c * inverse_masses c * inverse_masses c <= determinant (collision_matrix c).
Proof.
  intros valid; apply determinant_bounded;
    [apply (one_moves c valid) | apply (collision_matrix_symmetric c valid) | apply (definite c valid)].
Qed.

Corollary collision_matrix_invertible (c : contact R) : is_valid c -> determinant (collision_matrix c) <> 0.
Proof.
  intros valid; pose proof (collision_matrix_determinant c valid); pose proof (one_moves c valid).
  assert (0 < inverse_masses c * inverse_masses c) by nra; nra.
Qed.

Corollary normal_compliance_positive (c : contact R) : is_valid c -> 0 < normal_compliance c.
Proof. intros valid; apply positive_form; auto; apply (has_normal c valid). Qed.
