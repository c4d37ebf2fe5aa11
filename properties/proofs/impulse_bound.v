(* SPDX-License-Identifier: BSL-1.0 *)

(** Each law bounds its impulse by the velocity before it: λ‖F‖ ≤ k ‖V⁻‖, with a factor k for each law. The factor
    1 + max(ε, e_t) is large enough for each of the five laws. The proofs find a vector W with ‖W‖ ≤ k ‖V⁻‖ and
    F·K F ≤ F·W. Then λ F·F ≤ F·W, because K ⪰ λI. Symbols: laws.v. *)

Require Import Carom.reals Carom.collision_matrix Carom.laws_of_impulse Carom.energy Carom.friction Carom.similarity
  Carom.every_law.
Local Open Scope R_scope.

(** 1 + max(ε, e_t). *)
Definition largest_factor (c : contact R) := 1 + Rmax (restitution c) (tangential_restitution c).

(** The identity of Binet and Cauchy. *)
Lemma dot_cross (u v w : vector R) : dot (cross u v) (cross u w) = square u * dot v w - dot u v * dot u w.
Proof. by_ring. Qed.

Section Bounds.
  Variable c : contact R.
  Hypothesis valid : is_valid c.

  Local Notation K := (collision_matrix c).
  Local Notation N := (normal c).
  Local Notation V := (relative_velocity c).
  Local Notation lambda := (inverse_masses c).
  Local Notation epsilon := (restitution c).

  Lemma normal_square_positive : 0 < square N.
  Proof. apply square_positive, (has_normal c valid). Qed.

  (** λ‖F‖ ≤ ‖W‖ if F·K F ≤ F·W. *)
  Lemma bounded_by (f w : vector R) :
    dot f (applied K f) <= dot f w -> squared lambda * square f <= square w.
  Proof.
    intros form; pose proof (definite c valid f) as is_definite; pose proof (one_moves c valid) as positive.
    pose proof (dot_at_most f w) as schwarz; pose proof (square_nonnegative f) as of_f; unfold squared; reals.
    pose proof (square_nonnegative w) as of_w; destruct of_f as [of_f | <-]; [| lra].
    apply (Rmult_le_reg_l (square f)); auto.
    assert (lambda * square f * (lambda * square f) <= dot f w * dot f w) by (apply Rmult_le_compat; nra); lra.
  Qed.

  (** -(1+ε) V_N⁻, the change of velocity along N. *)
  Local Notation rebound := (scaled (- ((1 + epsilon) * approach c) / dot N N) N).

  Lemma bounded_by_rebound (f : vector R) :
    dot f (applied K f) <= dot f rebound ->
    squared lambda * square f * square N <= squared ((1 + epsilon) * approach c).
  Proof.
    intros form; apply bounded_by in form; pose proof normal_square_positive as positive.
    replace (squared ((1 + epsilon) * approach c)) with (square rebound * square N); [nra |].
    unfold square in *; rewrite dot_scaled, dot_scaled_left; unfold squared; reals; field; lra.
  Qed.

  (** λ‖F‖ ‖N‖ ≤ (1+ε) |N·V⁻|. *)
  Theorem impulse_bound_of_frictionless :
    squared lambda * square (frictionless_impulse c) * square N <= squared ((1 + epsilon) * approach c).
  Proof.
    apply bounded_by_rebound; unfold frictionless_impulse; apply Req_le.
    rewrite applied_scaled, !dot_scaled, !dot_scaled_left; fold (normal_compliance c); reals; field.
    pose proof (normal_compliance_positive c valid); pose proof normal_square_positive; unfold square in *; lra.
  Qed.

  (** λ‖F‖ ‖N‖ ≤ (1+ε) |N·V⁻|. *)
  Theorem impulse_bound_of_reflection :
    squared lambda * square (reflection_impulse c) * square N <= squared ((1 + epsilon) * approach c).
  Proof. apply bounded_by_rebound; rewrite reflection_changes by auto; apply Rle_refl. Qed.

  (** -V_T⁻ - (1+ε) V_N⁻, the change of velocity by sticking. *)
  Local Notation stop := (negated (sum V (scaled (epsilon * approach c / dot N N) N))).

  (** (N·V⁻)² ≤ (N·N) (V⁻·V⁻). *)
  Lemma approach_at_most : squared (approach c) <= square N * square V.
  Proof. apply dot_at_most. Qed.

  Lemma bounded_by_stop (f : vector R) :
    dot f (applied K f) <= dot f stop -> squared lambda * square f <= squared (1 + epsilon) * square V.
  Proof.
    intros form; eapply Rle_trans; [apply bounded_by, form |].
    pose proof normal_square_positive as positive; pose proof approach_at_most as schwarz.
    pose proof (restitution_in_range c valid); apply (Rmult_le_reg_l (square N)); auto.
    replace (square N * square stop) with
      (square N * square V + (2 * epsilon + epsilon * epsilon) * squared (approach c)).
    - assert (0 <= 2 * epsilon + epsilon * epsilon) by nra; unfold squared at 2; reals; nra.
    - unfold square in *; rewrite dot_negated, dot_negated_left, !dot_sum, !dot_sum_left, !dot_scaled, !dot_scaled_left,
        (dot_symmetric V N); fold (approach c); unfold squared; reals; field; lra.
  Qed.

  (** λ‖F‖ ≤ (1+ε) ‖V⁻‖. *)
  Theorem impulse_bound_of_sticking :
    squared lambda * square (sticking_impulse c) <= squared (1 + epsilon) * square V.
  Proof. apply bounded_by_stop; rewrite sticking_changes by auto; apply Rle_refl. Qed.

  (** λ‖F‖ ≤ (1+ε) ‖V⁻‖ if N·V⁺ = -ε N·V⁻ and F_T·V_T⁺ ≤ 0. *)
  Theorem impulse_bound_of_opposed_friction (f : vector R) :
    approach (after c f) = - epsilon * approach c ->
    dot (cross N f) (cross N (relative_velocity (after c f))) <= 0 ->
    squared lambda * square f <= squared (1 + epsilon) * square V.
  Proof.
    intros obeys opposed; apply bounded_by_stop; pose proof normal_square_positive as positive.
    replace (applied K f) with (difference (relative_velocity (after c f)) V)
      by (rewrite velocity_change; generalize V (applied K f); clear; by_ring).
    rewrite dot_cross in opposed; change N with (normal (after c f)) in opposed at 3.
    fold (approach (after c f)) in opposed; rewrite obeys, (dot_symmetric N f) in opposed.
    rewrite dot_difference, dot_negated, dot_sum, dot_scaled; apply (Rmult_le_reg_l (square N)); auto.
    unfold square in *; reals; replace (dot N N * - _) with
      (- (dot N N * dot f V) + dot f N * (- epsilon * approach c)) by (field; lra); lra.
  Qed.

  (** λ‖F‖ ≤ (1+ε) ‖V⁻‖. *)
  Theorem impulse_bound_of_coulomb (f : vector R) :
    is_coulomb c f -> squared lambda * square f <= squared (1 + epsilon) * square V.
  Proof.
    intros [obeys cone friction_is]; apply impulse_bound_of_opposed_friction; auto.
    apply in_cone_true in cone as [pushes _]; pose proof (friction_in_range c valid) as rough.
    cbv zeta in friction_is; revert friction_is.
    generalize (cross N f) (cross N (relative_velocity (after c f))); intros along slip [-> | slides].
    - rewrite dot_null; apply Rle_refl.
    - destruct (square_nonnegative slip) as [moves | rests].
      + apply (f_equal (dot slip)) in slides; rewrite !dot_scaled, (dot_symmetric slip along) in slides.
        fold (square slip) in slides; pose proof (sqrt_lt_R0 _ moves).
        assert (0 <= friction c * dot N f) by (apply Rmult_le_pos; auto); nra.
      + rewrite (square_zero slip), dot_null by auto; apply Rle_refl.
  Qed.

  Lemma impulse_bound_of_rough_with (kappa k : R) :
    0 <= kappa <= k -> 1 + epsilon <= k -> squared lambda * square (rough_with c kappa) <= squared k * square V.
  Proof.
    intros in_range at_most; replace (squared k * square V) with (square (scaled (- k) V))
      by (unfold square, squared; rewrite dot_scaled, dot_scaled_left; reals; ring).
    apply bounded_by; pose proof (stops_approach_is_conjugate c valid) as conjugate.
    pose proof (collision_matrix_symmetric c valid (from_one_to_other c) (stops_approach c)) as is_symmetric.
    pose proof (semidefinite c valid (stops_approach c)) as of_first.
    pose proof (semidefinite c valid (from_one_to_other c)) as of_d.
    pose proof (restitution_in_range c valid) as bounce; rewrite (velocity_in_parts c valid); unfold rough_with.
    rewrite !applied_sum, !applied_scaled, dot_scaled, dot_negated, !dot_sum, !dot_sum_left, !dot_scaled,
      !dot_scaled_left, is_symmetric, conjugate; reals; revert of_first of_d.
    generalize (dot (stops_approach c) (applied K (stops_approach c)))
      (dot (from_one_to_other c) (applied K (from_one_to_other c))); intros first d of_first of_d.
    assert (0 <= (1 + epsilon) * (k - (1 + epsilon)) * first) by (apply Rmult_le_pos; nra).
    assert (0 <= kappa * (k - kappa) * d) by (apply Rmult_le_pos; nra); lra.
  Qed.

  Lemma at_most_largest_factor : 1 + epsilon <= largest_factor c /\ 1 + tangential_restitution c <= largest_factor c.
  Proof.
    unfold largest_factor; pose proof (Rmax_l epsilon (tangential_restitution c));
      pose proof (Rmax_r epsilon (tangential_restitution c)); lra.
  Qed.

  (** λ‖F‖ ≤ (1 + max(ε, e_t)) ‖V⁻‖. *)
  Theorem impulse_bound_of_rough :
    approach c < 0 -> squared lambda * square (rough_impulse c) <= squared (largest_factor c) * square V.
  Proof.
    intros colliding; rewrite rough_impulse_is; pose proof (kappa_in_range c valid colliding).
    pose proof at_most_largest_factor; apply impulse_bound_of_rough_with; lra.
  Qed.

  Lemma bounded_by_largest_factor (f : vector R) :
    squared lambda * square f <= squared (1 + epsilon) * square V ->
    squared lambda * square f <= squared (largest_factor c) * square V.
  Proof.
    intros bound; eapply Rle_trans; [apply bound |]; apply Rmult_le_compat_r; [apply square_nonnegative |].
    pose proof at_most_largest_factor; pose proof (restitution_in_range c valid); unfold squared; reals; nra.
  Qed.

  Lemma bounded_by_approach (f : vector R) :
    squared lambda * square f * square N <= squared ((1 + epsilon) * approach c) ->
    squared lambda * square f <= squared (1 + epsilon) * square V.
  Proof.
    intros bound; pose proof approach_at_most as schwarz; apply (Rmult_le_reg_r (square N));
      [apply normal_square_positive |].
    pose proof (Rle_0_sqr (1 + epsilon)) as factor; change (0 <= squared (1 + epsilon)) in factor.
    replace (squared ((1 + epsilon) * approach c)) with (squared (1 + epsilon) * squared (approach c)) in bound
      by (unfold squared; reals; ring); nra.
  Qed.

  (** λ‖F‖ ≤ (1 + max(ε, e_t)) ‖V⁻‖. *)
  Theorem impulse_bound_of_every_law (f : vector R) :
    is_answer c f -> squared lambda * square f <= squared (largest_factor c) * square V.
  Proof.
    intros [| [] colliding | f' colliding is_of_coulomb].
    - replace (square null) with 0 by by_ring; rewrite Rmult_0_r.
      apply Rmult_le_pos; [apply Rle_0_sqr | apply square_nonnegative].
    - apply bounded_by_largest_factor, bounded_by_approach, impulse_bound_of_frictionless.
    - apply bounded_by_largest_factor, bounded_by_approach, impulse_bound_of_reflection.
    - apply bounded_by_largest_factor, impulse_bound_of_sticking.
    - apply impulse_bound_of_rough, is_colliding_true; auto.
    - apply bounded_by_largest_factor, impulse_bound_of_coulomb; auto.
  Qed.

  (** If V⁻ = 0, an impulse with such a bound is 0. *)
  Theorem bounded_impulse_at_rest (f : vector R) (k : R) :
    squared lambda * square f <= k * square V -> V = null -> f = null.
  Proof.
    intros bound at_rest; apply square_zero; revert bound; rewrite at_rest.
    replace (square null) with 0 by by_ring; pose proof (one_moves c valid); pose proof (square_nonnegative f).
    assert (0 < squared lambda) by (unfold squared; reals; nra); nra.
  Qed.

  (** If V⁻ = 0, the bodies keep their velocities under every law. *)
  Corollary rest_stays_at_rest (f : vector R) : is_answer c f -> V = null -> after c f = c.
  Proof.
    intros answer at_rest; apply impulse_bound_of_every_law in answer.
    rewrite (bounded_impulse_at_rest f _ answer at_rest); apply after_null.
  Qed.
End Bounds.
