(* SPDX-License-Identifier: BSL-1.0 *)

(** The effect of each law on the relative velocity of the point of contact: restitution, non-penetration, and the
    equations that distinguish the laws. Symbols: laws.v. *)

Require Import Carom.reals Carom.collision_matrix.
Local Open Scope R_scope.

Section Laws.
  Variable c : contact R.
  Hypothesis valid : is_valid c.

  Local Notation K := (collision_matrix c).
  Local Notation N := (normal c).
  Local Notation V := (relative_velocity c).

  Lemma normal_square : dot N N <> 0.
  Proof. pose proof (square_positive N (has_normal c valid)); unfold square in *; lra. Qed.

  Lemma compliance : dot N (applied K N) <> 0.
  Proof. pose proof (normal_compliance_positive c valid); unfold normal_compliance in *; lra. Qed.

  Lemma invertible : determinant K <> 0.
  Proof. apply collision_matrix_invertible; auto. Qed.

  Lemma velocity_after (f : vector R) : relative_velocity (after c f) = sum V (applied K f).
  Proof. apply velocity_change. Qed.

  (** The changes of the relative velocity by the impulses. *)
  Lemma reflection_changes :
    applied K (reflection_impulse c) = scaled (- ((1 + restitution c) * approach c) / dot N N) N.
  Proof. unfold reflection_impulse; rewrite applied_scaled, applied_solved; auto; apply invertible. Qed.

  Lemma sticking_changes :
    applied K (sticking_impulse c) =
    negated (sum V (scaled (restitution c * approach c / dot N N) N)).
  Proof. unfold sticking_impulse; rewrite applied_negated, applied_solved; auto; apply invertible. Qed.

  Lemma stops_point_stops : applied K (stops_point c) = negated V.
  Proof. unfold stops_point; rewrite applied_negated, applied_solved; auto; apply invertible. Qed.

  Lemma stops_approach_stops : dot N (applied K (stops_approach c)) = - approach c.
  Proof.
    unfold stops_approach, normal_compliance; rewrite applied_scaled, dot_scaled.
    reals; field; apply compliance.
  Qed.

  (** P_II - P_I changes only the tangential velocity. *)
  Lemma tangential : dot N (applied K (from_one_to_other c)) = 0.
  Proof.
    unfold from_one_to_other; rewrite applied_difference, dot_difference, stops_point_stops, stops_approach_stops,
      dot_negated; unfold approach; ring.
  Qed.

  (** N·V⁺ = -ε N·V⁻ if the impulse changes N·V by -(1+ε) N·V⁻. *)
  Lemma restitution_by (f : vector R) :
    dot N (applied K f) = - (1 + restitution c) * approach c ->
    approach (after c f) = - restitution c * approach c.
  Proof.
    intros change; unfold approach at 1; change (normal (after c f)) with N.
    rewrite velocity_after, dot_sum, change; unfold approach; ring.
  Qed.

  Lemma frictionless_approach : dot N (applied K (frictionless_impulse c)) = - (1 + restitution c) * approach c.
  Proof.
    unfold frictionless_impulse, normal_compliance; rewrite applied_scaled, dot_scaled; reals; field.
    apply compliance.
  Qed.

  Lemma reflection_approach : dot N (applied K (reflection_impulse c)) = - (1 + restitution c) * approach c.
  Proof. rewrite reflection_changes, dot_scaled; reals; field; apply normal_square. Qed.

  Lemma sticking_approach : dot N (applied K (sticking_impulse c)) = - (1 + restitution c) * approach c.
  Proof.
    rewrite sticking_changes, dot_negated, dot_sum, dot_scaled; unfold approach; reals; field.
    apply normal_square.
  Qed.

  Lemma rough_approach (kappa : R) : dot N (applied K (rough_with c kappa)) = - (1 + restitution c) * approach c.
  Proof.
    unfold rough_with; rewrite applied_sum, !applied_scaled, dot_sum, !dot_scaled, tangential, stops_approach_stops.
    reals; ring.
  Qed.

  Theorem restitution_of_frictionless :
    approach (after c (frictionless_impulse c)) = - restitution c * approach c.
  Proof. apply restitution_by, frictionless_approach. Qed.

  Theorem restitution_of_reflection : approach (after c (reflection_impulse c)) = - restitution c * approach c.
  Proof. apply restitution_by, reflection_approach. Qed.

  Theorem restitution_of_sticking : approach (after c (sticking_impulse c)) = - restitution c * approach c.
  Proof. apply restitution_by, sticking_approach. Qed.

  Theorem restitution_of_rough (kappa : R) :
    approach (after c (rough_with c kappa)) = - restitution c * approach c.
  Proof. apply restitution_by, rough_approach. Qed.

  (** N·V⁺ ≥ 0 for every impulse that obeys the restitution. *)
  Theorem non_penetration (f : vector R) :
    approach c < 0 -> approach (after c f) = - restitution c * approach c -> 0 <= approach (after c f).
  Proof. intros colliding ->; pose proof (restitution_in_range c valid); nra. Qed.

  (** |N·V⁺| ≤ |N·V⁻| for every impulse that obeys the restitution. *)
  Theorem parts_no_faster (f : vector R) :
    approach (after c f) = - restitution c * approach c -> Rabs (approach (after c f)) <= Rabs (approach c).
  Proof.
    intros ->; pose proof (restitution_in_range c valid); pose proof (Rabs_pos (approach c)).
    rewrite Rabs_mult, Rabs_Ropp, (Rabs_pos_eq (restitution c)) by lra; nra.
  Qed.

  (** N × F = 0. *)
  Theorem frictionless_direction : cross N (frictionless_impulse c) = null.
  Proof. unfold frictionless_impulse; rewrite cross_scaled, cross_self; apply scaled_null. Qed.

  (** N × V⁺ = N × V⁻. *)
  Theorem reflection_plane : cross N (relative_velocity (after c (reflection_impulse c))) = cross N V.
  Proof.
    rewrite velocity_after, cross_sum, reflection_changes, cross_scaled, cross_self, scaled_null; apply sum_null.
  Qed.

  (** N × V⁺ = 0. *)
  Theorem sticks : cross N (relative_velocity (after c (sticking_impulse c))) = null.
  Proof.
    rewrite velocity_after, sticking_changes; generalize (restitution c * approach c / dot N N)%num;
      generalize (normal c) V; clear; by_ring.
  Qed.

  (** N·P_I > 0. *)
  Lemma stops_approach_pushes : approach c < 0 -> 0 < dot N (stops_approach c).
  Proof.
    intros colliding; unfold stops_approach; rewrite dot_scaled.
    pose proof (square_positive N (has_normal c valid)); pose proof (normal_compliance_positive c valid).
    unfold square in *; reals; unfold Rdiv.
    apply Rmult_lt_0_compat; [apply Rmult_lt_0_compat; [lra | apply Rinv_0_lt_compat; auto] | auto].
  Qed.

  Theorem push_of_frictionless : approach c < 0 -> 0 < dot N (frictionless_impulse c).
  Proof.
    intros colliding; pose proof (stops_approach_pushes colliding) as pushes; pose proof (restitution_in_range c valid).
    replace (frictionless_impulse c) with (scaled (1 + restitution c) (stops_approach c)).
    - rewrite dot_scaled; nra.
    - unfold frictionless_impulse, stops_approach; rewrite scaled_scaled; f_equal; reals; field.
      pose proof compliance; unfold normal_compliance; auto.
  Qed.

  (** N·K⁻¹N > 0. *)
  Lemma inverse_compliance_positive : 0 < dot N (solved K N).
  Proof.
    assert (solved K N <> null) as not_null.
    { intros is_null; pose proof (applied_solved K N invertible) as same; rewrite is_null, applied_null in same.
      apply (has_normal c valid); auto. }
    pose proof (positive_form c (solved K N) valid not_null) as form.
    rewrite applied_solved in form by apply invertible; rewrite dot_symmetric; auto.
  Qed.

  Theorem push_of_reflection : approach c < 0 -> 0 < dot N (reflection_impulse c).
  Proof.
    intros colliding; unfold reflection_impulse; rewrite dot_scaled.
    pose proof inverse_compliance_positive; pose proof (square_positive N (has_normal c valid)).
    pose proof (restitution_in_range c valid); unfold square in *; reals; unfold Rdiv.
    apply Rmult_lt_0_compat; auto; apply Rmult_lt_0_compat; [nra | apply Rinv_0_lt_compat; auto].
  Qed.

  (** If N is an eigenvector of K, reflection and frictionless have the same impulse. *)
  Theorem reflection_is_frictionless (value : R) :
    applied K N = scaled value N -> reflection_impulse c = frictionless_impulse c.
  Proof.
    intros eigen; pose proof compliance as positive; pose proof normal_square; pose proof invertible.
    rewrite eigen, dot_scaled in positive.
    assert (value <> 0) by (intros is_zero; apply positive; rewrite is_zero; ring).
    unfold reflection_impulse, frictionless_impulse, normal_compliance; rewrite eigen, dot_scaled.
    rewrite (solved_unique K N (scaled (/ value) N)); auto.
    - rewrite scaled_scaled; f_equal; reals; field; auto.
    - rewrite applied_scaled, eigen, scaled_scaled, Rinv_l, scaled_1; auto.
  Qed.

  (** Spheres: both lever arms are along the normal, and K N = λ N. Frictionless and reflection change no angular
      velocity. *)
  Section Spheres.
    Hypothesis along_a : cross (lever_arm (body_a c) (point c)) N = null.
    Hypothesis along_b : cross (lever_arm (body_b c) (point c)) N = null.

    Lemma normal_is_eigenvector : applied K N = scaled (inverse_masses c) N.
    Proof.
      rewrite collision_matrix_applied, !of_spin_applied, along_a, along_b, !applied_null.
      generalize (scaled (inverse_masses c) N) (lever_arm (body_a c) (point c)) (lever_arm (body_b c) (point c)).
      by_ring.
    Qed.

    Theorem collinear_spin_of_frictionless :
      spin (body_a (after c (frictionless_impulse c))) = spin (body_a c) /\
      spin (body_b (after c (frictionless_impulse c))) = spin (body_b c).
    Proof.
      unfold frictionless_impulse; cbn [after pushed body_a body_b spin].
      rewrite !cross_negated, !cross_scaled, along_a, along_b, scaled_null, negated_null, !applied_null, !sum_null; auto.
    Qed.

    Theorem collinear_spin_of_reflection :
      spin (body_a (after c (reflection_impulse c))) = spin (body_a c) /\
      spin (body_b (after c (reflection_impulse c))) = spin (body_b c).
    Proof.
      rewrite (reflection_is_frictionless (inverse_masses c) normal_is_eigenvector);
        apply collinear_spin_of_frictionless.
    Qed.
  End Spheres.
End Laws.

(** A contact that does not collide keeps its velocities under every law. Two immovable bodies do not collide. *)
Theorem separating_untouched (law : contact R -> vector R) (c : contact R) :
  0 <= approach c \/ inverse_masses c <= 0 -> resolved law c = c.
Proof.
  intros inactive; unfold resolved; destruct (is_colliding c) eqn:colliding; auto.
  apply is_colliding_true in colliding; lra.
Qed.

(** An immovable body keeps its velocities. *)
Theorem immovable_untouched (b : body R) (p f : vector R) : is_immovable b -> pushed b p f = b.
Proof.
  destruct b; intros [no_mass no_inertia]; cbn in no_mass, no_inertia; unfold pushed; cbn; subst.
  rewrite scaled_0, applied_zero_matrix, !sum_null; reflexivity.
Qed.

(** If ε > 0 and N·V⁺ = -ε N·V⁻ after a law, a second application of the law changes nothing. *)
Theorem repeat (law : contact R -> vector R) (c : contact R) :
  approach (after c (law c)) = - restitution c * approach c -> 0 < restitution c ->
  resolved law (resolved law c) = resolved law c.
Proof.
  intros obeys bounces; unfold resolved at 2 3; destruct (is_colliding c) eqn:colliding.
  - apply separating_untouched; left; apply is_colliding_true in colliding; rewrite obeys; nra.
  - unfold resolved; rewrite colliding; reflexivity.
Qed.
