(* SPDX-License-Identifier: BSL-1.0 *)

(** The law rough over the real numbers, with the root √s. Its κ (rough_with in laws.v) is that of the literature
    (Chatterjee and Ruina) and lies in [0, 1 + e_t]. Its impulse pushes and lies in the friction cone. If the contact
    slides, the impulse lies on the surface of the cone. The law creates no energy. Symbols: laws.v. *)

Require Import Carom.reals Carom.collision_matrix Carom.laws_of_impulse Carom.energy.
Local Open Scope R_scope.

Definition kappa (c : contact R) : R := let (p, q) := rough_kappa c in p + q * sqrt (radicand c).

Definition rough_impulse (c : contact R) : vector R :=
  let (first, second) := rough_impulses c in sum first (scaled (sqrt (radicand c)) second).

Lemma rough_impulse_is (c : contact R) : rough_impulse c = rough_with c (kappa c).
Proof.
  unfold rough_impulse, rough_impulses, kappa; destruct (rough_kappa c) as [p q]; unfold rough_with.
  generalize (scaled (1 + restitution c)%num (stops_approach c)) (from_one_to_other c) (sqrt (radicand c)).
  clear; by_ring.
Qed.

(** If the F with κ = 1 + e_t lies in the cone, rough has this κ. *)
Theorem kappa_in_cone (c : contact R) : sticks_in_cone c = true -> kappa c = 1 + tangential_restitution c.
Proof. intros sticks; unfold kappa, rough_kappa; rewrite sticks; reals; ring. Qed.

(** ‖N × D‖ - μ N·D, the divisor in sliding_kappa. *)
Definition divisor (c : contact R) : R := sqrt (radicand c) - friction c * dot (normal c) (from_one_to_other c).

(** The κ of the literature if the contact slides: μ (1+ε) N·P_I / (‖N × D‖ - μ N·D). *)
Definition sliding_kappa (c : contact R) : R :=
  friction c * (1 + restitution c) * dot (normal c) (stops_approach c) / divisor c.

Lemma in_cone_true (c : contact R) (f : vector R) :
  in_cone c f = true <->
  0 <= dot (normal c) f /\ square (cross (normal c) f) <= squared (friction c * dot (normal c) f).
Proof. unfold in_cone; rewrite andb_true_iff, !negb_true_iff, !less_false; reflexivity. Qed.

Section Rough.
  Variable c : contact R.
  Hypothesis valid : is_valid c.

  Local Notation K := (collision_matrix c).
  Local Notation N := (normal c).
  Local Notation P_I := (stops_approach c).
  Local Notation D := (from_one_to_other c).
  Local Notation mu := (friction c).
  Local Notation root := (sqrt (radicand c)).
  (** The κ of an impulse inside the cone. *)
  Local Notation whole := (1 + tangential_restitution c).

  Lemma whole_in_range : 0 <= whole <= 2.
  Proof. pose proof (tangential_restitution_in_range c valid); lra. Qed.

  Lemma root_nonnegative : 0 <= root.
  Proof. apply sqrt_pos. Qed.

  Lemma root_squared : root * root = radicand c.
  Proof. apply sqrt_def, square_nonnegative. Qed.

  (** D is along N only if D = 0, because N·K D = 0. *)
  Lemma no_radicand : radicand c = 0 -> D = null.
  Proof.
    intros no_root; unfold radicand in no_root; rewrite square_cross in no_root.
    pose proof (square_positive N (has_normal c valid)) as normal_positive.
    destruct (Req_dec (square D) 0) as [is_zero | not_zero]; [apply square_zero; auto | exfalso].
    assert (D <> null) as not_null by (intros is_null; apply not_zero; rewrite is_null; by_ring).
    (* (N·N) D = (N·D) N, so that D·K D would be 0. *)
    assert (scaled (square N) D = scaled (dot N D) N) as along.
    { assert (square (difference (scaled (square N) D) (scaled (dot N D) N)) = 0) as same.
      { transitivity (square N * (square N * square D - dot N D * dot N D)).
        - generalize N D; clear; by_ring.
        - rewrite no_root; ring. }
      apply square_zero in same; revert same; generalize (scaled (square N) D) (scaled (dot N D) N); clear.
      intros v w same; apply vector_equal; [apply (f_equal x_of) in same | apply (f_equal y_of) in same |
        apply (f_equal z_of) in same]; revert same; destruct v, w; in_components; lra. }
    pose proof (positive_form c D valid not_null) as form.
    assert (square N * dot D (applied K D) = 0) as none.
    { rewrite <- dot_scaled_left, along, dot_scaled_left, tangential by auto; ring. }
    nra.
  Qed.

  Lemma cross_stops_approach : cross N P_I = null.
  Proof. unfold stops_approach; rewrite cross_scaled, cross_self; apply scaled_null. Qed.

  Lemma cross_rough (k : R) : cross N (rough_with c k) = scaled k (cross N D).
  Proof.
    unfold rough_with; rewrite cross_sum, !cross_scaled, cross_stops_approach, scaled_null.
    generalize (scaled k (cross N D)); clear; by_ring.
  Qed.

  (** ‖N × F‖² = κ² s. *)
  Lemma square_cross_rough (k : R) : square (cross N (rough_with c k)) = k * k * radicand c.
  Proof. rewrite cross_rough; unfold radicand, square; rewrite dot_scaled, dot_scaled_left; reals; ring. Qed.

  Lemma push_of_rough_with (k : R) : dot N (rough_with c k) = (1 + restitution c) * dot N P_I + k * dot N D.
  Proof. unfold rough_with; rewrite dot_sum, !dot_scaled; reflexivity. Qed.

  Lemma rough_with_0 : rough_with c 0 = frictionless_impulse c.
  Proof.
    unfold rough_with, frictionless_impulse, stops_approach; rewrite scaled_0, sum_null, scaled_scaled; f_equal.
    reals; field; pose proof (normal_compliance_positive c valid); lra.
  Qed.

  (** If μ = 0, the impulse is the frictionless impulse. *)
  Theorem rough_without_friction : mu = 0 -> rough_impulse c = frictionless_impulse c.
  Proof.
    intros no_friction; rewrite rough_impulse_is, <- rough_with_0; unfold kappa, rough_kappa.
    destruct (sticks_in_cone c) eqn:sticks.
    - apply in_cone_true in sticks as [_ inside]; rewrite square_cross_rough, no_friction in inside.
      unfold squared in inside; reals.
      pose proof (square_nonnegative (cross N D)) as radicand_nonnegative; fold (radicand c) in radicand_nonnegative.
      pose proof whole_in_range.
      destruct (Req_dec whole 0) as [is_zero | not_zero]; [rewrite is_zero; f_equal; ring |].
      assert (D = null) as none by (apply no_radicand; assert (0 < whole * whole) by nra; nra).
      unfold rough_with; rewrite none, !scaled_null; reflexivity.
    - unfold on_the_cone; rewrite no_friction; f_equal; destruct (_ || _); reals; unfold Rdiv; ring.
  Qed.

  Hypothesis colliding : approach c < 0.

  Local Notation push := ((1 + restitution c) * dot N P_I).

  Lemma push_positive : 0 < push.
  Proof.
    pose proof (stops_approach_pushes c valid colliding); pose proof (restitution_in_range c valid); nra.
  Qed.

  (** F is not null, because it stops or reverses the approach. So an F in the cone pushes: N·F > 0. *)
  Lemma pushes_in_cone (k : R) : in_cone c (rough_with c k) = true -> 0 < dot N (rough_with c k).
  Proof.
    intros inside; apply in_cone_true in inside as [[| is_zero] inside]; auto; exfalso.
    rewrite <- is_zero, square_cross, <- is_zero in inside; unfold squared in inside; reals.
    pose proof (square_positive N (has_normal c valid)); pose proof (square_nonnegative (rough_with c k)).
    assert (rough_with c k = null) as none by (apply square_zero; nra).
    pose proof (rough_approach c valid k) as stops; rewrite none, applied_null, dot_null in stops.
    pose proof (restitution_in_range c valid); nra.
  Qed.

  Section Slides.
    Hypothesis outside : sticks_in_cone c = false.

    (** N·F < 0 or ‖N × F‖ > μ N·F, for F with κ = 1 + e_t. *)
    Lemma not_in_cone :
      push + whole * dot N D < 0 \/ 0 <= push + whole * dot N D /\ mu * (push + whole * dot N D) < whole * root.
    Proof.
      destruct (Rlt_le_dec (push + whole * dot N D) 0) as [| pushes]; [left; auto | right; split; auto].
      apply Rnot_le_lt; intros inside; apply (eq_true_false_abs (sticks_in_cone c)); auto.
      apply in_cone_true; rewrite square_cross_rough, push_of_rough_with; split; [exact pushes |].
      rewrite <- root_squared; unfold squared; reals; pose proof root_nonnegative; pose proof whole_in_range.
      assert (0 <= whole * root) by nra; nra.
    Qed.

    Lemma divisor_bound : 0 < divisor c /\ mu * push <= whole * divisor c.
    Proof.
      unfold divisor; pose proof not_in_cone as cases; pose proof push_positive; pose proof whole_in_range.
      pose proof root_nonnegative as [root_positive | no_root]; pose proof (friction_in_range c valid).
      - destruct cases as [pulls | [pushes beyond]]; [| split; nra].
        assert (dot N D < 0) by nra; split; nra.
      - pose proof root_squared as no_radicand_is; rewrite <- no_root, Rmult_0_l in no_radicand_is.
        rewrite (no_radicand (eq_sym no_radicand_is)), dot_null in cases; nra.
    Qed.

    Theorem divisor_positive : 0 < divisor c.
    Proof. apply divisor_bound. Qed.

    Lemma sliding_kappa_times_divisor : sliding_kappa c * divisor c = mu * push.
    Proof. unfold sliding_kappa; field; pose proof divisor_positive; lra. Qed.

    Lemma sliding_kappa_in_range : 0 <= sliding_kappa c <= whole.
    Proof.
      pose proof divisor_bound as [positive bound]; pose proof sliding_kappa_times_divisor.
      pose proof push_positive; pose proof (friction_in_range c valid).
      assert (0 <= mu * push) by nra; split; nra.
    Qed.

    (** ‖N × F‖ = μ N·F. *)
    Lemma slides_on_the_cone :
      sliding_kappa c * root = mu * dot N (rough_with c (sliding_kappa c)).
    Proof.
      rewrite push_of_rough_with; pose proof sliding_kappa_times_divisor as times; unfold divisor in times; lra.
    Qed.

    Lemma slides_square :
      square (cross N (rough_with c (sliding_kappa c))) = squared (mu * dot N (rough_with c (sliding_kappa c))).
    Proof. rewrite square_cross_rough, <- root_squared, <- slides_on_the_cone; unfold squared; reals; ring. Qed.

    Lemma slides_in_cone : in_cone c (rough_with c (sliding_kappa c)) = true.
    Proof.
      apply in_cone_true; rewrite slides_square; split; [| apply Rle_refl].
      pose proof slides_on_the_cone as on_the_cone_is; pose proof sliding_kappa_in_range; pose proof root_nonnegative.
      destruct (friction_in_range c valid) as [rough | smooth]; [assert (0 <= sliding_kappa c * root) by nra; nra |].
      assert (sliding_kappa c = 0) as none by (unfold sliding_kappa; rewrite <- smooth; unfold Rdiv; ring).
      rewrite push_of_rough_with, none; pose proof push_positive; lra.
    Qed.

    (** If the contact slides, p + q √s is the κ of the literature. *)
    Theorem kappa_is_textbook : kappa c = sliding_kappa c.
    Proof.
      pose proof divisor_positive as positive; pose proof root_squared as is_root.
      pose proof root_nonnegative as root_sign.
      unfold kappa, rough_kappa; rewrite outside; unfold on_the_cone, sliding_kappa, divisor, squared in *.
      revert positive is_root root_sign; generalize (dot N D) (dot N P_I); generalize root; generalize (radicand c).
      intros s r d p positive <- root_sign; destruct (_ || _) eqn:divides.
      - assert (r * r - mu * d * (mu * d) <> 0).
        { apply orb_true_iff in divides; rewrite !less_true in divides; reals; lra. }
        reals; field; split; lra.
      - apply orb_false_iff in divides; rewrite !less_false in divides; reals.
        assert (r = - (mu * d)) as -> by (destruct divides; nra); field; lra.
    Qed.
  End Slides.

  Lemma kappa_cases :
    kappa c = whole /\ sticks_in_cone c = true \/ kappa c = sliding_kappa c /\ sticks_in_cone c = false.
  Proof.
    destruct (sticks_in_cone c) eqn:sticks; [left | right]; split; auto using kappa_is_textbook, kappa_in_cone.
  Qed.

  Theorem kappa_in_range : 0 <= kappa c <= 1 + tangential_restitution c.
  Proof.
    pose proof whole_in_range.
    destruct kappa_cases as [[-> _] | [-> outside]]; [| apply sliding_kappa_in_range; auto]; lra.
  Qed.

  Lemma rough_in_cone : in_cone c (rough_impulse c) = true.
  Proof.
    rewrite rough_impulse_is; destruct kappa_cases as [[-> sticks] | [-> outside]]; auto.
    apply slides_in_cone; auto.
  Qed.

  (** ‖N × F‖ ≤ μ N·F. *)
  Theorem friction_cone :
    0 <= dot N (rough_impulse c) /\ square (cross N (rough_impulse c)) <= squared (mu * dot N (rough_impulse c)).
  Proof. apply in_cone_true, rough_in_cone. Qed.

  (** ‖N × F‖ = μ N·F if the contact slides. *)
  Theorem slides_on_friction_cone :
    sticks_in_cone c = false ->
    square (cross N (rough_impulse c)) = squared (mu * dot N (rough_impulse c)).
  Proof. intros; rewrite rough_impulse_is, kappa_is_textbook by auto; apply slides_square; auto. Qed.

  (** N·F > 0. *)
  Theorem push_of_rough : 0 < dot N (rough_impulse c).
  Proof. pose proof rough_in_cone; rewrite rough_impulse_is in *; apply pushes_in_cone; auto. Qed.

  Theorem restitution_of_rough_law : approach (after c (rough_impulse c)) = - restitution c * approach c.
  Proof. rewrite rough_impulse_is; apply restitution_of_rough; auto. Qed.

  (** If e_t = -1, the impulse is the frictionless impulse. *)
  Theorem rough_that_keeps_slip : tangential_restitution c = -1 -> rough_impulse c = frictionless_impulse c.
  Proof.
    intros keeps; pose proof kappa_in_range; rewrite rough_impulse_is, <- rough_with_0; f_equal; lra.
  Qed.

  Theorem energy_of_rough_law (mass_a mass_b : R) (inertia_a inertia_b : matrix R) :
    is_accounted mass_a inertia_a (body_a c) -> is_accounted mass_b inertia_b (body_b c) ->
    let energy := total_energy mass_a mass_b inertia_a inertia_b in
    energy (after c (rough_impulse c)) - energy c <= 0.
  Proof.
    intros; rewrite rough_impulse_is; apply energy_of_rough; auto.
    pose proof kappa_in_range; pose proof whole_in_range; lra.
  Qed.
End Rough.

(** A contact whose D lies on the surface of the opposite friction cone: s = 4 = (μ N·D)², N·D < 0. *)
Definition opposite_cone :=
  a_contact (a_body 1 (uniform 4) null (vec (-4) (-2) 0) null) (a_body 0 zero_matrix null null null)
            (vec (1 / 2) (-1 / 2) 0) (vec 0 1 0) 0 2 0.

Lemma opposite_cone_matrix :
  collision_matrix opposite_cone = rows (vec 2 1 0) (vec 1 2 0) (vec 0 0 3).
Proof.
  cbv [collision_matrix inverse_masses of_spin lever_arm opposite_cone body_a body_b point centre
       inverse_mass inverse_inertia].
  in_components; same_components; field.
Qed.

Lemma opposite_cone_velocity : relative_velocity opposite_cone = vec (-4) (-2) 0.
Proof.
  cbv [relative_velocity velocity_at lever_arm opposite_cone body_a body_b point centre velocity spin].
  in_components; same_components; ring.
Qed.

Lemma opposite_cone_stops_approach : stops_approach opposite_cone = vec 0 1 0.
Proof.
  unfold stops_approach, normal_compliance, approach; rewrite opposite_cone_matrix, opposite_cone_velocity.
  cbv [opposite_cone normal]; in_components; same_components; field.
Qed.

Lemma opposite_cone_difference : from_one_to_other opposite_cone = vec 2 (-1) 0.
Proof.
  unfold from_one_to_other, stops_point.
  rewrite opposite_cone_stops_approach, opposite_cone_matrix, opposite_cone_velocity.
  rewrite (solved_unique _ _ (vec (-2) 0 0)); in_components; [same_components; ring | lra | same_components; ring].
Qed.

(** For this contact, 1 / (s - (μ N·D)²) does not exist, but κ does. *)
Theorem kappa_on_opposite_cone :
  is_valid opposite_cone /\ approach opposite_cone = -2 /\ sticks_in_cone opposite_cone = false /\
  radicand opposite_cone =
    squared (friction opposite_cone * dot (normal opposite_cone) (from_one_to_other opposite_cone)) /\
  kappa opposite_cone = 1 / 2.
Proof.
  assert (is_valid opposite_cone) as valid.
  { split; cbn [opposite_cone body_a body_b normal restitution friction tangential_restitution]; try lra;
      unfold is_possible, symmetric, positive_semidefinite; cbn [inverse_mass inverse_inertia].
    - split; [| split; [| left; lra]]; intros; rewrite !applied_uniform, !dot_scaled.
      + rewrite (dot_symmetric v w); reflexivity.
      + pose proof (square_nonnegative v); unfold square in *; reals; lra.
    - split; [| split; [| right; split; reflexivity]]; intros; rewrite !applied_zero_matrix, !dot_null; lra.
    - unfold inverse_masses; cbn; lra.
    - intros same; apply (f_equal y_of) in same; cbn in same; lra. }
  assert (approach opposite_cone = -2) as approaches.
  { unfold approach; rewrite opposite_cone_velocity; cbv [opposite_cone normal]; in_components; ring. }
  assert (sticks_in_cone opposite_cone = false) as slides.
  { apply not_true_is_false; intros sticks; apply in_cone_true in sticks as [_ inside]; revert inside.
    unfold rough_with; rewrite opposite_cone_stops_approach, opposite_cone_difference.
    cbv [opposite_cone normal restitution friction tangential_restitution]; in_components; lra. }
  assert (radicand opposite_cone = 4) as under_root.
  { unfold radicand; rewrite opposite_cone_difference; cbv [opposite_cone normal]; in_components; ring. }
  split; [| split; [| split; [| split]]]; auto.
  - rewrite under_root, opposite_cone_difference; cbv [opposite_cone normal friction]; in_components; ring.
  - rewrite kappa_is_textbook by (auto; lra); unfold sliding_kappa, divisor.
    rewrite under_root, opposite_cone_stops_approach, opposite_cone_difference.
    replace 4 with (2 * 2) by ring; rewrite sqrt_square by lra.
    cbv [opposite_cone normal friction restitution]; in_components; field.
Qed.
