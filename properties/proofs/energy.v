(* SPDX-License-Identifier: BSL-1.0 *)

(** The change of kinetic energy by an impulse, in closed form for each law. Frictionless and rough never increase the
    energy. A cube shows that reflection can increase it. Symbols: laws.v. *)

Require Import Carom.reals Carom.collision_matrix Carom.laws_of_impulse.
Local Open Scope R_scope.

Definition kinetic_energy (mass : R) (inertia : matrix R) (b : body R) :=
  mass / 2 * square (velocity b) + 1 / 2 * dot (spin b) (applied inertia (spin b)).

Record has_inertia (mass : R) (inertia : matrix R) (b : body R) : Prop := {
  inverts_mass : mass * inverse_mass b = 1;
  inverts_inertia : forall v, applied inertia (applied (inverse_inertia b) v) = v;
  inertia_symmetric : symmetric inertia
}.

(** An immovable body at rest counts with any mass and inertia, because its energy is 0 before and after the impulse. *)
Definition is_accounted (mass : R) (inertia : matrix R) (b : body R) :=
  has_inertia mass inertia b \/ (is_immovable b /\ velocity b = null /\ spin b = null).

Definition total_energy (mass_a mass_b : R) (inertia_a inertia_b : matrix R) (c : contact R) :=
  kinetic_energy mass_a inertia_a (body_a c) + kinetic_energy mass_b inertia_b (body_b c).

Lemma dot_null (v : vector R) : dot v null = 0. Proof. by_ring. Qed.
Lemma cross_null_left (v : vector R) : cross null v = null. Proof. by_ring. Qed.
Lemma cross_null (v : vector R) : cross v null = null. Proof. by_ring. Qed.

Lemma work_on_movable (mass : R) (inertia : matrix R) (b : body R) (p f : vector R) :
  has_inertia mass inertia b ->
  kinetic_energy mass inertia (pushed b p f) - kinetic_energy mass inertia b =
  dot f (velocity_at b p) + 1 / 2 * (inverse_mass b * dot f f + dot f (applied (of_spin b p) f)).
Proof.
  intros [inverse inverse_matrix is_symmetric].
  rewrite of_spin_form; unfold kinetic_energy, pushed, velocity_at, square; cbn [velocity spin].
  pose proof (inverse_matrix (cross (lever_arm b p) f)) as turns; revert turns.
  generalize (applied (inverse_inertia b) (cross (lever_arm b p) f)); intros turn turns.
  rewrite applied_sum, turns, !dot_sum, !dot_sum_left, !dot_scaled, !dot_scaled_left, (is_symmetric turn), turns.
  replace (dot f (cross (spin b) (lever_arm b p))) with (dot (spin b) (cross (lever_arm b p) f))
    by (generalize (lever_arm b p) (spin b); clear; by_ring).
  rewrite (dot_symmetric turn), (dot_symmetric (velocity b) f); reals.
  apply Rminus_diag_uniq; transitivity
    ((mass * inverse_mass b - 1) * (dot f (velocity b) + inverse_mass b / 2 * dot f f)).
  - field.
  - rewrite inverse; ring.
Qed.

Lemma work_on (mass : R) (inertia : matrix R) (b : body R) (p f : vector R) :
  is_accounted mass inertia b ->
  kinetic_energy mass inertia (pushed b p f) - kinetic_energy mass inertia b =
  dot f (velocity_at b p) + 1 / 2 * (inverse_mass b * dot f f + dot f (applied (of_spin b p) f)).
Proof.
  intros [movable | (immovable & at_rest & not_turning)]; [apply work_on_movable; auto |].
  rewrite immovable_untouched, of_spin_form by auto; unfold velocity_at; rewrite at_rest, not_turning.
  destruct immovable as [-> ->]; rewrite applied_zero_matrix, cross_null_left, sum_null, !dot_null; ring.
Qed.

(** If K is symmetric, K⁻¹ is symmetric. *)
Lemma solved_symmetric (m : matrix R) (v w : vector R) :
  determinant m <> 0 -> symmetric m -> dot v (solved m w) = dot w (solved m v).
Proof.
  intros invertible is_symmetric.
  rewrite <- (applied_solved m v invertible) at 1; rewrite <- (applied_solved m w invertible) at 2.
  rewrite (dot_symmetric _ (solved m w)), (dot_symmetric _ (solved m v)); apply is_symmetric.
Qed.

(** k = (1+ε) N·V⁻ / N·N, the factor in the impulse -k K⁻¹N of reflection. *)
Definition reflection_factor (c : contact R) := (1 + restitution c) * approach c / dot (normal c) (normal c).

(** V_T, the part of V⁻ in the plane of contact. *)
Definition along_plane (c : contact R) :=
  difference (relative_velocity c) (scaled (approach c / dot (normal c) (normal c)) (normal c)).

Section Energy.
  Variables (c : contact R) (mass_a mass_b : R) (inertia_a inertia_b : matrix R).
  Hypothesis counts_a : is_accounted mass_a inertia_a (body_a c).
  Hypothesis counts_b : is_accounted mass_b inertia_b (body_b c).

  Local Notation K := (collision_matrix c).
  Local Notation N := (normal c).
  Local Notation V := (relative_velocity c).
  Local Notation V_T := (along_plane c).
  Local Notation k := (reflection_factor c).
  Local Notation energy := (total_energy mass_a mass_b inertia_a inertia_b).
  Local Notation gained f := (energy (after c f) - energy c).

  Local Notation work f := (dot f V + 1 / 2 * dot f (applied K f)).

  (** ΔE = F·V⁻ + ½ F·K F. *)
  Theorem energy_change (f : vector R) : gained f = dot f V + 1 / 2 * dot f (applied K f).
  Proof.
    pose proof (work_on mass_a inertia_a (body_a c) (point c) f counts_a) as on_a.
    pose proof (work_on mass_b inertia_b (body_b c) (point c) (negated f) counts_b) as on_b.
    unfold total_energy; cbn [after body_a body_b].
    rewrite collision_matrix_form; unfold relative_velocity, inverse_masses; rewrite dot_difference.
    rewrite applied_negated, !dot_negated, !dot_negated_left in on_b; reals; lra.
  Qed.

  (** Kelvin: ΔE = ½ F·(V⁻ + V⁺). *)
  Corollary energy_change_kelvin (f : vector R) : gained f = 1 / 2 * dot f (sum V (relative_velocity (after c f))).
  Proof. rewrite energy_change, velocity_change, !dot_sum; field. Qed.

  Hypothesis valid : is_valid c.

  (** ΔE = ½ (V⁺·K⁻¹V⁺ - V⁻·K⁻¹V⁻). *)
  Theorem energy_is_norm (f : vector R) :
    let after_it := relative_velocity (after c f) in
    gained f = 1 / 2 * (dot after_it (solved K after_it) - dot V (solved K V)).
  Proof.
    pose proof (collision_matrix_invertible c valid) as invertible; intros after_it.
    assert (f = difference (solved K after_it) (solved K V)) as impulse.
    { rewrite <- (solved_applied K (difference _ _) invertible), applied_difference, !applied_solved by auto.
      rewrite <- (solved_applied K f invertible) at 1; f_equal; unfold after_it; rewrite velocity_change.
      generalize V (applied K f); clear; by_ring. }
    rewrite energy_change_kelvin; fold after_it; rewrite impulse at 1.
    rewrite dot_sum, !dot_difference_left, !(dot_symmetric (solved _ _)).
    rewrite (solved_symmetric K V after_it) by (auto; apply collision_matrix_symmetric; auto); field.
  Qed.

  (** ΔE = -(1-ε²) (N·V⁻)² / (2 N·K N). *)
  Lemma work_of_frictionless_is :
    work (frictionless_impulse c) =
    - (1 - restitution c * restitution c) * (approach c * approach c) / (2 * normal_compliance c).
  Proof.
    pose proof (normal_compliance_positive c valid).
    unfold frictionless_impulse; rewrite applied_scaled, dot_scaled, !dot_scaled_left.
    fold (normal_compliance c) (approach c); reals; field; lra.
  Qed.

  Theorem energy_of_frictionless_is :
    gained (frictionless_impulse c) =
    - (1 - restitution c * restitution c) * (approach c * approach c) / (2 * normal_compliance c).
  Proof. rewrite energy_change; apply work_of_frictionless_is. Qed.

  Lemma work_of_frictionless : work (frictionless_impulse c) <= 0.
  Proof.
    pose proof (normal_compliance_positive c valid); pose proof (restitution_in_range c valid).
    rewrite work_of_frictionless_is.
    assert (0 <= (1 - restitution c * restitution c) * (approach c * approach c))
      by (apply Rmult_le_pos; nra).
    assert (0 < / (2 * normal_compliance c)) by (apply Rinv_0_lt_compat; lra).
    unfold Rdiv; nra.
  Qed.

  Theorem energy_of_frictionless : gained (frictionless_impulse c) <= 0.
  Proof. rewrite energy_change; apply work_of_frictionless. Qed.

  (** P_I·K D = 0. *)
  Lemma stops_approach_is_conjugate : dot (stops_approach c) (applied K (from_one_to_other c)) = 0.
  Proof. unfold stops_approach at 1; rewrite dot_scaled_left, tangential by auto; reals; ring. Qed.

  (** V⁻ = -K P_II = -(K P_I + K D). *)
  Lemma velocity_in_parts : V = negated (sum (applied K (stops_approach c)) (applied K (from_one_to_other c))).
  Proof.
    rewrite <- applied_sum; replace (sum _ _) with (stops_point c)
      by (unfold from_one_to_other; generalize (stops_point c) (stops_approach c); clear; by_ring).
    rewrite stops_point_stops by auto; generalize V; clear; by_ring.
  Qed.

  (** ΔE = -½ (1-ε²) P_I·K P_I - ½ κ (2-κ) D·K D. *)
  Lemma work_of_rough_is (kappa : R) :
    let first := stops_approach c in
    let d := from_one_to_other c in
    work (rough_with c kappa) =
    - 1 / 2 * (1 - restitution c * restitution c) * dot first (applied K first)
    - 1 / 2 * kappa * (2 - kappa) * dot d (applied K d).
  Proof.
    intros first d; pose proof stops_approach_is_conjugate as conjugate.
    pose proof (collision_matrix_symmetric c valid) as is_symmetric.
    pose proof velocity_in_parts as velocity_is; unfold rough_with; fold first d in conjugate, velocity_is |- *.
    rewrite velocity_is, !applied_sum, !applied_scaled, !dot_negated, !dot_sum, !dot_sum_left, !dot_scaled,
      !dot_scaled_left, (is_symmetric d first), conjugate; reals; field.
  Qed.

  Theorem energy_of_rough_is (kappa : R) :
    let first := stops_approach c in
    let d := from_one_to_other c in
    gained (rough_with c kappa) =
    - 1 / 2 * (1 - restitution c * restitution c) * dot first (applied K first)
    - 1 / 2 * kappa * (2 - kappa) * dot d (applied K d).
  Proof. rewrite energy_change; apply work_of_rough_is. Qed.

  Lemma work_of_rough (kappa : R) : 0 <= kappa <= 2 -> work (rough_with c kappa) <= 0.
  Proof.
    intros in_range; rewrite work_of_rough_is; pose proof (restitution_in_range c valid).
    pose proof (semidefinite c valid (stops_approach c)) as of_first.
    pose proof (semidefinite c valid (from_one_to_other c)) as of_d.
    revert of_first of_d; generalize (dot (stops_approach c) (applied K (stops_approach c)))
      (dot (from_one_to_other c) (applied K (from_one_to_other c))); intros first d of_first of_d.
    assert (0 <= (1 - restitution c * restitution c) * first) by (apply Rmult_le_pos; nra).
    assert (0 <= kappa * (2 - kappa) * d) by (apply Rmult_le_pos; nra).
    lra.
  Qed.

  Theorem energy_of_rough (kappa : R) : 0 <= kappa <= 2 -> gained (rough_with c kappa) <= 0.
  Proof. rewrite energy_change; apply work_of_rough. Qed.

  (** ΔE = -k K⁻¹N·V⁻ + ½ k² N·K⁻¹N. *)
  Theorem energy_of_reflection_is :
    gained (reflection_impulse c) = - k * dot (solved K N) V + 1 / 2 * (k * k) * dot N (solved K N).
  Proof.
    rewrite energy_change; unfold reflection_impulse.
    rewrite applied_scaled, applied_solved, dot_scaled, !dot_scaled_left by (apply collision_matrix_invertible; auto).
    rewrite (dot_symmetric (solved K N) N); unfold reflection_factor; reals; field; apply normal_square; auto.
  Qed.

  (** ΔE = ½ k ((ε-1) (N·V⁻ / N·N) N·K⁻¹N - 2 N·K⁻¹V_T). *)
  Theorem energy_of_reflection_in_parts :
    gained (reflection_impulse c) =
    1 / 2 * k * ((restitution c - 1) * (approach c / dot N N) * dot N (solved K N) - 2 * dot N (solved K V_T)).
  Proof.
    pose proof (normal_square c valid).
    rewrite energy_of_reflection_is, (dot_symmetric _ V).
    replace V with (sum V_T (scaled (approach c / dot N N) N)) at 1
      by (unfold along_plane; generalize (scaled (approach c / dot N N) N) V; clear; by_ring).
    rewrite dot_sum_left, dot_scaled_left, (solved_symmetric K V_T N) by
      (auto using collision_matrix_invertible; apply collision_matrix_symmetric; auto).
    unfold reflection_factor; reals; field; auto.
  Qed.

  (** Reflection creates energy if and only if 2 (N·N) N·K⁻¹V_T > (1-ε) |N·V⁻| N·K⁻¹N. *)
  Theorem reflection_gains_energy :
    approach c < 0 ->
    0 < gained (reflection_impulse c) <->
    (1 - restitution c) * - approach c * dot N (solved K N) < 2 * dot N N * dot N (solved K V_T).
  Proof.
    intros colliding; pose proof (normal_square c valid) as not_zero; pose proof (restitution_in_range c valid).
    pose proof (square_positive N (has_normal c valid)) as positive; unfold square in positive.
    rewrite energy_of_reflection_in_parts; unfold reflection_factor.
    replace (1 / 2 * _ * _) with
      ((1 + restitution c) * - approach c / (2 * (dot N N * dot N N)) *
       (2 * dot N N * dot N (solved K V_T) - (1 - restitution c) * - approach c * dot N (solved K N)))
      by (reals; field; auto).
    assert (0 < (1 + restitution c) * - approach c / (2 * (dot N N * dot N N))) as sign.
    { apply Rmult_lt_0_compat; [nra | apply Rinv_0_lt_compat; nra]. }
    revert sign; generalize ((1 + restitution c) * - approach c / (2 * (dot N N * dot N N))); intros share sign.
    split; intros; nra.
  Qed.

  (** Sticking gives V⁺ = -ε (N·V⁻ / N·N) N, so ΔE = ½ (ε² (N·V⁻ / N·N)² N·K⁻¹N - V⁻·K⁻¹V⁻). *)
  Theorem energy_of_sticking_is :
    let kept := restitution c * approach c / dot N N in
    gained (sticking_impulse c) = 1 / 2 * (kept * kept * dot N (solved K N) - dot V (solved K V)).
  Proof.
    intros kept; rewrite energy_is_norm, velocity_change, sticking_changes by auto.
    replace (sum V _) with (scaled (- kept) N)
      by (unfold kept; reals; generalize (restitution c * approach c / dot N N) N V; clear; by_ring).
    replace (solved K (scaled (- kept) N)) with (scaled (- kept) (solved K N)).
    - rewrite dot_scaled, dot_scaled_left; reals; ring.
    - symmetry; apply solved_unique; [apply collision_matrix_invertible; auto |].
      rewrite applied_scaled, applied_solved; auto; apply collision_matrix_invertible; auto.
  Qed.
End Energy.

(** A cube with mass 1 kg and edge length 1 m moves obliquely and hits an immovable body with the middle of an edge. *)
Definition cube := a_body 1 (uniform 6) null (vec (-1) (-1) 0) null.
Definition plane := a_body 0 zero_matrix null null null.
Definition cube_on_plane (epsilon : R) := a_contact cube plane (vec (1 / 2) (-1 / 2) 0) (vec 0 1 0) epsilon 0 0.

Section Cube.
  Variable epsilon : R.

  Lemma cube_accounted : is_accounted 1 (uniform (1 / 6)) cube.
  Proof.
    left; split; cbn [cube inverse_mass inverse_inertia]; [lra | |]; intros v; [| intros w];
      rewrite !applied_uniform; [rewrite scaled_scaled; reals; replace (1 / 6 * 6) with 1 by field; apply scaled_1 |].
    rewrite !dot_scaled, (dot_symmetric v w); reflexivity.
  Qed.

  Lemma plane_accounted (mass : R) (inertia : matrix R) : is_accounted mass inertia plane.
  Proof. right; repeat split. Qed.

  Lemma cube_on_plane_valid : 0 <= epsilon <= 1 -> is_valid (cube_on_plane epsilon).
  Proof.
    intros in_range; split; cbn [cube_on_plane body_a body_b normal restitution friction tangential_restitution];
      try lra; unfold is_possible, symmetric, positive_semidefinite;
      cbn [cube plane inverse_mass inverse_inertia].
    - split; [| split; [| left; lra]]; intros; rewrite !applied_uniform, !dot_scaled.
      + rewrite (dot_symmetric v w); reflexivity.
      + pose proof (square_nonnegative v); unfold square in *; reals; lra.
    - split; [| split; [| right; split; reflexivity]]; intros; rewrite !applied_zero_matrix, !dot_null; lra.
    - unfold inverse_masses; cbn; lra.
    - intros same; apply (f_equal y_of) in same; cbn in same; lra.
  Qed.

  Lemma cube_on_plane_matrix :
    collision_matrix (cube_on_plane epsilon) = rows (vec (5 / 2) (3 / 2) 0) (vec (3 / 2) (5 / 2) 0) (vec 0 0 4).
  Proof.
    cbv [collision_matrix inverse_masses of_spin lever_arm cube_on_plane cube plane body_a body_b point centre
         inverse_mass inverse_inertia].
    in_components; same_components; field.
  Qed.

  Lemma cube_on_plane_impulse :
    reflection_impulse (cube_on_plane epsilon) = scaled (1 + epsilon) (vec (-3 / 8) (5 / 8) 0).
  Proof.
    unfold reflection_impulse; rewrite cube_on_plane_matrix.
    rewrite (solved_unique _ _ (vec (-3 / 8) (5 / 8) 0)).
    - cbv [approach relative_velocity velocity_at lever_arm cube_on_plane cube plane body_a body_b point centre normal
           restitution velocity spin].
      in_components; same_components; field.
    - in_components; lra.
    - in_components; cbn; same_components; field.
  Qed.

  Theorem cube_energy (mass : R) (inertia : matrix R) :
    let energy := total_energy 1 mass (uniform (1 / 6)) inertia in
    let c := cube_on_plane epsilon in
    energy c = 1 /\ energy (after c (reflection_impulse c)) = 1 + (1 + epsilon) * (1 + 5 * epsilon) / 16.
  Proof.
    intros energy c; unfold c; rewrite cube_on_plane_impulse; unfold energy.
    assert (total_energy 1 mass (uniform (1 / 6)) inertia (cube_on_plane epsilon) = 1) as at_first.
    { cbv [total_energy kinetic_energy cube_on_plane cube plane body_a body_b velocity spin].
      in_components; destruct inertia; field. }
    split; auto.
    pose proof (energy_change (cube_on_plane epsilon) 1 mass (uniform (1 / 6)) inertia cube_accounted
      (plane_accounted mass inertia) (scaled (1 + epsilon) (vec (-3 / 8) (5 / 8) 0))) as change.
    rewrite at_first, cube_on_plane_matrix in change; apply Rplus_eq_reg_r with (-1); ring_simplify in change.
    unfold Rminus in change; eapply eq_trans; [apply change |].
    cbv [relative_velocity velocity_at lever_arm cube_on_plane cube plane body_a body_b point centre velocity spin].
    in_components; field.
  Qed.
End Cube.

Lemma cube_on_plane_collides (epsilon : R) : is_colliding (cube_on_plane epsilon) = true.
Proof.
  apply is_colliding_true; unfold inverse_masses, approach, relative_velocity, velocity_at.
  cbn [cube_on_plane cube plane body_a body_b normal point velocity spin inverse_mass]; in_components; lra.
Qed.

(** The cube's energy grows from 1 J to 7/4 J at ε = 1, and from 1 J to 17/16 J at ε = 0. *)
Theorem reflection_can_gain_energy :
  let energy := total_energy 1 0 (uniform (1 / 6)) zero_matrix in
  let elastic := cube_on_plane 1 in
  let inelastic := cube_on_plane 0 in
  is_valid elastic /\ is_colliding elastic = true /\ is_valid inelastic /\ is_colliding inelastic = true /\
  energy elastic = 1 /\ energy (after elastic (reflection_impulse elastic)) = 7 / 4 /\
  energy inelastic = 1 /\ energy (after inelastic (reflection_impulse inelastic)) = 17 / 16.
Proof.
  cbv zeta; destruct (cube_energy 1 0 zero_matrix) as [before_elastic after_elastic].
  destruct (cube_energy 0 0 zero_matrix) as [before_inelastic after_inelastic].
  rewrite before_elastic, after_elastic, before_inelastic, after_inelastic.
  split; [apply cube_on_plane_valid; lra | split; [apply cube_on_plane_collides |]].
  split; [apply cube_on_plane_valid; lra | split; [apply cube_on_plane_collides |]].
  repeat split; field.
Qed.

Corollary reflection_creates_energy :
  exists (c : contact R) (mass_a mass_b : R) (inertia_a inertia_b : matrix R),
    is_valid c /\ is_colliding c = true /\
    is_accounted mass_a inertia_a (body_a c) /\ is_accounted mass_b inertia_b (body_b c) /\
    let energy := total_energy mass_a mass_b inertia_a inertia_b in
    0 < energy (after c (reflection_impulse c)) - energy c.
Proof.
  exists (cube_on_plane 1), 1, 0, (uniform (1 / 6)), zero_matrix.
  split; [apply cube_on_plane_valid; lra |].
  split; [apply cube_on_plane_collides | split; [apply cube_accounted | split; [apply plane_accounted |]]].
  cbv zeta; destruct reflection_can_gain_energy as (_ & _ & _ & _ & before & after_it & _).
  rewrite before, after_it; lra.
Qed.
