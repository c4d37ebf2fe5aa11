(* SPDX-License-Identifier: BSL-1.0 *)

(** The relations between two collisions that Carom requires of a solver. The changes exchange the bodies, give them a
    common velocity, translate, turn or mirror them, change the units, multiply the velocities, or lengthen the normal.
    Under every law, the outcome of the changed contact is the changed outcome of the contact. *)

Require Import Carom.reals Carom.collision_matrix Carom.similarity.
Local Open Scope R_scope.

(** A change that maps every contact to a similar one. An impulse, mapped by g and scaled, takes the changed contact to
    the changed outcome. *)
Record likeness (g : vector R -> vector R) (alpha beta gamma : R) (change : contact R -> contact R) : Prop := {
  by_isometry : isometry g;
  by_alpha : 0 < alpha;
  by_beta : 0 < beta;
  by_gamma : 0 < gamma;
  changes_normal : forall c, normal (change c) = scaled alpha (g (normal c));
  changes_velocity : forall c, relative_velocity (change c) = scaled beta (g (relative_velocity c));
  changes_masses : forall c, inverse_masses (change c) = gamma * inverse_masses c;
  changes_after : forall c f, after (change c) (scaled (beta / gamma) (g f)) = change (after c f);
  keeps_restitution : forall c, restitution (change c) = restitution c;
  keeps_friction : forall c, friction (change c) = friction c;
  keeps_tangential_restitution : forall c, tangential_restitution (change c) = tangential_restitution c;
  keeps_possible : forall c, is_possible (body_a c) -> is_possible (body_b c) ->
                             is_possible (body_a (change c)) /\ is_possible (body_b (change c))
}.

Lemma sum_left (u v w : vector R) : sum u v = sum u w -> v = w.
Proof.
  destruct u, v, w; in_components; intros same; injection same as same_x same_y same_z; f_equal; lra.
Qed.

Lemma scaled_left (s : R) (v w : vector R) : s <> 0 -> scaled s v = scaled s w -> v = w.
Proof.
  intros not_zero same; rewrite <- (scaled_1 v), <- (scaled_1 w), <- (Rinv_l s), <- !scaled_scaled, same; auto.
Qed.

Section Likeness.
  Variables (g : vector R -> vector R) (alpha beta gamma : R) (change : contact R -> contact R).
  Hypothesis alike : likeness g alpha beta gamma change.

  Let iso := by_isometry _ _ _ _ _ alike.
  Let alpha_above := by_alpha _ _ _ _ _ alike.
  Let beta_above := by_beta _ _ _ _ _ alike.
  Let gamma_above := by_gamma _ _ _ _ _ alike.

  (** The relative velocity after an impulse determines the collision matrix. *)
  Lemma likeness_matrix (c : contact R) (v : vector R) :
    applied (collision_matrix (change c)) (g v) = scaled gamma (g (applied (collision_matrix c) v)).
  Proof.
    pose proof (f_equal relative_velocity (changes_after _ _ _ _ _ alike c v)) as same.
    rewrite (changes_velocity _ _ _ _ _ alike), !velocity_change, (changes_velocity _ _ _ _ _ alike),
      (keeps_sum g iso), scaled_sum, applied_scaled in same.
    apply sum_left in same; apply (scaled_left (beta / gamma)).
    - apply Rgt_not_eq, Rdiv_lt_0_compat; auto.
    - rewrite same, scaled_scaled; f_equal; field; lra.
  Qed.

  Theorem likeness_similar (c : contact R) : similar g alpha beta gamma c (change c).
  Proof.
    split; try apply alike; apply likeness_matrix.
  Qed.

  Theorem likeness_valid (c : contact R) : is_valid c -> is_valid (change c).
  Proof.
    intros valid; destruct (keeps_possible _ _ _ _ _ alike c (possible_a c valid) (possible_b c valid)).
    split; auto.
    - rewrite (changes_masses _ _ _ _ _ alike); apply Rmult_lt_0_compat; [auto | apply (one_moves c valid)].
    - rewrite (changes_normal _ _ _ _ _ alike); intros is_null.
      pose proof (square_positive _ (has_normal c valid)) as long; unfold square in long.
      pose proof (scaled_dot g iso alpha alpha (normal c) (normal c)) as short; rewrite is_null in short.
      replace (dot null null) with 0 in short by by_ring.
      assert (0 < alpha * alpha) by (apply Rmult_lt_0_compat; auto); nra.
    - rewrite (keeps_restitution _ _ _ _ _ alike); apply (restitution_in_range c valid).
    - rewrite (keeps_friction _ _ _ _ _ alike); apply (friction_in_range c valid).
    - rewrite (keeps_tangential_restitution _ _ _ _ _ alike); apply (tangential_restitution_in_range c valid).
  Qed.

  Theorem likeness_impulse (l : law) (c : contact R) :
    is_valid c -> impulse_of l (change c) = scaled (beta / gamma) (g (impulse_of l c)).
  Proof.
    intros valid; apply (impulse_similar _ alpha); auto; [apply likeness_similar | apply likeness_valid; auto].
  Qed.

  Theorem likeness_outcome (l : law) (c : contact R) :
    is_valid c -> resolved (impulse_of l) (change c) = change (resolved (impulse_of l) c).
  Proof.
    intros valid; apply (resolved_similar _ g alpha beta gamma); auto;
      [apply likeness_similar | apply likeness_valid; auto | apply alike].
  Qed.
End Likeness.

Lemma identity_isometry : isometry (fun v => v).
Proof. split; reflexivity. Qed.

Lemma negated_isometry : isometry negated.
Proof. split; by_ring. Qed.

Lemma scaled_1_over_1 (v : vector R) : scaled (1 / 1) v = v.
Proof. replace (1 / 1) with 1 by field; apply scaled_1. Qed.

(** The bodies are exchanged. The normal points towards A, so it is reversed. *)
Definition swapped (c : contact R) : contact R :=
  a_contact (body_b c) (body_a c) (point c) (negated (normal c)) (restitution c) (friction c)
            (tangential_restitution c).

Lemma swap_likeness : likeness negated 1 1 1 swapped.
Proof.
  split; try (intros; reflexivity); try lra.
  - apply negated_isometry.
  - intros c; rewrite scaled_1; reflexivity.
  - intros c; rewrite scaled_1; unfold relative_velocity; cbn [swapped body_a body_b point].
    generalize (velocity_at (body_a c) (point c)) (velocity_at (body_b c) (point c)); by_ring.
  - intros c; unfold inverse_masses; cbn [swapped body_a body_b]; reals; ring.
  - intros c f; rewrite scaled_1_over_1; unfold after, swapped;
      cbn [body_a body_b point normal restitution friction tangential_restitution].
    replace (negated (negated f)) with f by by_ring; reflexivity.
  - intros c possible_a possible_b; split; auto.
Qed.

Theorem swap (l : law) (c : contact R) :
  is_valid c -> resolved (impulse_of l) (swapped c) = swapped (resolved (impulse_of l) c).
Proof. apply (likeness_outcome _ _ _ _ _ swap_likeness). Qed.

(** A change that treats both bodies alike, with a change of the point and a change of the normal. *)
Definition changed (on_body : body R -> body R) (on_point on_normal : vector R -> vector R) (c : contact R) :=
  a_contact (on_body (body_a c)) (on_body (body_b c)) (on_point (point c)) (on_normal (normal c)) (restitution c)
            (friction c) (tangential_restitution c).

(** The conditions on the change of a body. Both bodies may also gain a common velocity. *)
Record body_likeness (g : vector R -> vector R) (beta gamma : R) (common : vector R)
    (on_body : body R -> body R) (on_point : vector R -> vector R) : Prop := {
  body_velocity : forall b p, velocity_at (on_body b) (on_point p) = sum (scaled beta (g (velocity_at b p))) common;
  body_mass : forall b, inverse_mass (on_body b) = gamma * inverse_mass b;
  body_pushed : forall b p f, pushed (on_body b) (on_point p) (scaled (beta / gamma) (g f)) = on_body (pushed b p f);
  body_possible : forall b, is_possible b -> is_possible (on_body b)
}.

Lemma difference_of_sums (u v w : vector R) : difference (sum v u) (sum w u) = difference v w.
Proof. by_ring. Qed.

Lemma changed_likeness (g : vector R -> vector R) (alpha beta gamma : R) (common : vector R)
    (on_body : body R -> body R) (on_point on_normal : vector R -> vector R) :
  isometry g -> 0 < alpha -> 0 < beta -> 0 < gamma ->
  (forall v, on_normal v = scaled alpha (g v)) -> body_likeness g beta gamma common on_body on_point ->
  likeness g alpha beta gamma (changed on_body on_point on_normal).
Proof.
  intros iso above_alpha above_beta above_gamma normals bodies; split; auto; try (intros; reflexivity).
  - intros c; apply normals.
  - intros c; unfold relative_velocity; cbn [changed body_a body_b point].
    rewrite !(body_velocity _ _ _ _ _ _ bodies), difference_of_sums, (keeps_difference g iso); symmetry;
      apply scaled_difference.
  - intros c; unfold inverse_masses; cbn [changed body_a body_b]; rewrite !(body_mass _ _ _ _ _ _ bodies); reals; ring.
  - intros c f; unfold after, changed;
      cbn [body_a body_b point normal restitution friction tangential_restitution].
    rewrite <- !(body_pushed _ _ _ _ _ _ bodies); f_equal; f_equal.
    rewrite (keeps_negated g iso), !negated_scaled, !scaled_scaled; f_equal; ring.
  - intros c possible_a possible_b; split; apply (body_possible _ _ _ _ _ _ bodies); auto.
Qed.

Lemma body_equal (b b' : body R) :
  inverse_mass b = inverse_mass b' -> inverse_inertia b = inverse_inertia b' -> centre b = centre b' ->
  velocity b = velocity b' -> spin b = spin b' -> b = b'.
Proof. destruct b, b'; cbn; intros; subst; reflexivity. Qed.

(** Both bodies gain a common velocity. *)
Definition moving (u : vector R) : contact R -> contact R :=
  changed (fun b => a_body (inverse_mass b) (inverse_inertia b) (centre b) (sum (velocity b) u) (spin b))
          (fun p => p) (fun n => n).

Lemma galilean_likeness (u : vector R) : likeness (fun v => v) 1 1 1 (moving u).
Proof.
  apply changed_likeness with (common := u); try lra; [apply identity_isometry | intros; symmetry; apply scaled_1 |].
  split.
  - intros b p; rewrite scaled_1; unfold velocity_at; cbn [velocity spin].
    change (lever_arm (a_body _ _ _ _ _) p) with (lever_arm b p).
    generalize (velocity b) (cross (spin b) (lever_arm b p)); by_ring.
  - intros b; cbn [inverse_mass]; ring.
  - intros b p f; rewrite scaled_1_over_1; apply body_equal; try reflexivity; cbn [pushed velocity inverse_mass].
    generalize (velocity b) (inverse_mass b); by_ring.
  - auto.
Qed.

Theorem galilean (u : vector R) (l : law) (c : contact R) :
  is_valid c -> resolved (impulse_of l) (moving u c) = moving u (resolved (impulse_of l) c).
Proof. apply (likeness_outcome _ _ _ _ _ (galilean_likeness u)). Qed.

(** All positions are moved by one vector. *)
Definition translated (d : vector R) : contact R -> contact R :=
  changed (fun b => a_body (inverse_mass b) (inverse_inertia b) (sum (centre b) d) (velocity b) (spin b))
          (fun p => sum p d) (fun n => n).

Lemma translation_likeness (d : vector R) : likeness (fun v => v) 1 1 1 (translated d).
Proof.
  apply changed_likeness with (common := null); try lra;
    [apply identity_isometry | intros; symmetry; apply scaled_1 |].
  split.
  - intros b p; rewrite scaled_1, sum_null; unfold velocity_at, lever_arm; cbn [velocity spin centre].
    rewrite difference_of_sums; reflexivity.
  - intros b; cbn [inverse_mass]; ring.
  - intros b p f; rewrite scaled_1_over_1; apply body_equal; try reflexivity; unfold pushed, lever_arm;
      cbn [spin inverse_inertia centre].
    rewrite difference_of_sums; reflexivity.
  - auto.
Qed.

Theorem translation (d : vector R) (l : law) (c : contact R) :
  is_valid c -> resolved (impulse_of l) (translated d c) = translated d (resolved (impulse_of l) c).
Proof. apply (likeness_outcome _ _ _ _ _ (translation_likeness d)). Qed.

(** A matrix that keeps lengths and angles. *)
Definition orthogonal (q : matrix R) := forall v w, dot (applied q v) (applied q w) = dot v w.

(** Angular velocities are axial, as are cross products, so they also take the sign of det Q. The inverse inertia W
    becomes Q W Qᵀ. *)
Definition turned (q : matrix R) : contact R -> contact R :=
  changed (fun b => a_body (inverse_mass b) (product q (product (inverse_inertia b) (transposed q)))
                           (applied q (centre b)) (applied q (velocity b))
                           (scaled (determinant q) (applied q (spin b))))
          (applied q) (applied q).

Lemma cross_applied (q : matrix R) (v w : vector R) :
  cross (applied q v) (applied q w) = applied (transposed (adjugate q)) (cross v w).
Proof. by_ring. Qed.

Lemma transposed_twice (q : matrix R) : transposed (transposed q) = q.
Proof. by_ring. Qed.

(** The dot products with all vectors determine a vector. *)
Lemma same_dots (v w : vector R) : (forall u, dot u v = dot u w) -> v = w.
Proof.
  intros same; pose proof (same (vec 1 0 0)); pose proof (same (vec 0 1 0)); pose proof (same (vec 0 0 1)); clear same.
  apply vector_equal; taken_apart; in_components; lra.
Qed.

Lemma orthogonal_transposed (q : matrix R) (v : vector R) :
  orthogonal q -> applied (transposed q) (applied q v) = v.
Proof. intros keeps; apply same_dots; intros u; rewrite dot_transposed; apply keeps. Qed.

Lemma dot_of_transposed (q : matrix R) (v w : vector R) : dot (applied (transposed q) v) w = dot v (applied q w).
Proof. by_ring. Qed.

Lemma cross_turned (q : matrix R) (v w : vector R) :
  orthogonal q -> cross (applied q v) (applied q w) = scaled (determinant q) (applied q (cross v w)).
Proof.
  intros keeps; rewrite cross_applied; apply same_dots; intros u.
  rewrite dot_transposed, dot_scaled, <- dot_of_transposed.
  rewrite <- (orthogonal_transposed q (applied (adjugate q) u) keeps), adjugate_right, applied_scaled, dot_scaled_left.
  reflexivity.
Qed.

Lemma orthogonal_determinant (q : matrix R) : orthogonal q -> determinant q * determinant q = 1.
Proof.
  intros keeps; pose proof (cross_turned q (vec 1 0 0) (vec 0 1 0) keeps) as columns.
  apply (f_equal square) in columns; rewrite square_cross in columns; unfold square in columns.
  rewrite !keeps in columns.
  rewrite dot_scaled, dot_scaled_left, keeps in columns; clear keeps.
  revert columns; generalize (determinant q); intros d; in_components; lra.
Qed.

Lemma cross_scaled_left (s : R) (v w : vector R) : cross (scaled s v) w = scaled s (cross v w).
Proof. by_ring. Qed.

Lemma turned_possible (q : matrix R) (b : body R) :
  is_possible b ->
  is_possible (a_body (inverse_mass b) (product q (product (inverse_inertia b) (transposed q)))
                      (applied q (centre b)) (applied q (velocity b)) (scaled (determinant q) (applied q (spin b)))).
Proof.
  intros (is_symmetric & semidefinite & mass); unfold is_possible, is_immovable; cbn [inverse_mass inverse_inertia].
  repeat split.
  - intros v w; rewrite !applied_product, <- !(dot_of_transposed q); apply is_symmetric.
  - intros v; rewrite !applied_product, <- !(dot_of_transposed q); apply semidefinite.
  - destruct mass as [above | [no_mass no_inertia]]; [left; auto | right; split; auto].
    rewrite no_inertia; clear; by_ring.
Qed.

Lemma turned_likeness (q : matrix R) : orthogonal q -> likeness (applied q) 1 1 1 (turned q).
Proof.
  intros keeps; pose proof (orthogonal_determinant q keeps) as sign.
  apply changed_likeness with (common := null); try lra.
  - split; [apply applied_sum | intros; apply applied_scaled | apply keeps].
  - intros v; symmetry; apply scaled_1.
  - split.
    + intros b p; rewrite scaled_1, sum_null; unfold velocity_at, lever_arm; cbn [velocity spin centre].
      rewrite <- applied_difference, cross_scaled_left, (cross_turned q _ _ keeps), scaled_scaled, applied_sum.
      reals; rewrite sign, scaled_1; reflexivity.
    + intros b; cbn [inverse_mass]; ring.
    + intros b p f; rewrite scaled_1_over_1; apply body_equal; try reflexivity; unfold pushed, lever_arm;
        cbn [inverse_mass inverse_inertia centre velocity spin].
      * rewrite applied_sum, applied_scaled; reflexivity.
      * rewrite <- applied_difference, (cross_turned q _ _ keeps), !applied_product, !applied_scaled,
          (orthogonal_transposed q _ keeps), applied_sum, scaled_sum; reflexivity.
    + intros b; apply turned_possible.
Qed.

(** Q is a rotation or a reflection. *)
Theorem turning (q : matrix R) (l : law) (c : contact R) :
  orthogonal q -> is_valid c -> resolved (impulse_of l) (turned q c) = turned q (resolved (impulse_of l) c).
Proof. intros keeps; apply (likeness_outcome _ _ _ _ _ (turned_likeness q keeps)). Qed.

(** A rotation turns every vector, and angular velocities too. *)
Definition rotated_body (q : matrix R) (b : body R) : body R :=
  a_body (inverse_mass b) (product q (product (inverse_inertia b) (transposed q)))
         (applied q (centre b)) (applied q (velocity b)) (applied q (spin b)).
Definition rotated (q : matrix R) : contact R -> contact R := changed (rotated_body q) (applied q) (applied q).

(** A reflection also reverses the angular velocities. *)
Definition reflected_body (q : matrix R) (b : body R) : body R :=
  a_body (inverse_mass b) (product q (product (inverse_inertia b) (transposed q)))
         (applied q (centre b)) (applied q (velocity b)) (negated (applied q (spin b))).
Definition reflected (q : matrix R) : contact R -> contact R := changed (reflected_body q) (applied q) (applied q).

Lemma rotated_is_turned (q : matrix R) (c : contact R) : determinant q = 1 -> rotated q c = turned q c.
Proof. intros sign; unfold rotated, rotated_body, turned, changed; rewrite sign, !scaled_1; reflexivity. Qed.

Lemma reflected_is_turned (q : matrix R) (c : contact R) : determinant q = -1 -> reflected q c = turned q c.
Proof. intros sign; unfold reflected, reflected_body, turned, changed; rewrite sign, !negated_scaled; reflexivity. Qed.

Theorem rotation (q : matrix R) (l : law) (c : contact R) :
  orthogonal q -> determinant q = 1 -> is_valid c ->
  resolved (impulse_of l) (rotated q c) = rotated q (resolved (impulse_of l) c).
Proof. intros keeps sign; rewrite !rotated_is_turned by auto; apply turning; auto. Qed.

Theorem reflection_symmetry (q : matrix R) (l : law) (c : contact R) :
  orthogonal q -> determinant q = -1 -> is_valid c ->
  resolved (impulse_of l) (reflected q c) = reflected q (resolved (impulse_of l) c).
Proof. intros keeps sign; rewrite !reflected_is_turned by auto; apply turning; auto. Qed.

(** The mirror x = 0. *)
Definition mirror : matrix R := diagonal (vec (-1) 1 1).

Corollary mirror_symmetry (l : law) (c : contact R) :
  is_valid c -> resolved (impulse_of l) (reflected mirror c) = reflected mirror (resolved (impulse_of l) c).
Proof. apply reflection_symmetry; [intros v w |]; unfold mirror; by_ring. Qed.

(** The contact in other units. One old unit of mass is `mass` new units, and so on. The normal has a factor of its
    own. *)
Definition in_units (mass length time direction : R) : contact R -> contact R :=
  changed (fun b => a_body (inverse_mass b / mass)
                           (product (uniform (/ (mass * (length * length)))) (inverse_inertia b))
                           (scaled length (centre b)) (scaled (length / time) (velocity b))
                           (scaled (/ time) (spin b)))
          (scaled length) (scaled direction).

Lemma scaled_inertia (s : R) (m : matrix R) (v : vector R) :
  applied (product (uniform s) m) v = scaled s (applied m v).
Proof. rewrite applied_product; apply applied_uniform. Qed.

Lemma unit_scaling_likeness (mass length time direction : R) :
  0 < mass -> 0 < length -> 0 < time -> 0 < direction ->
  likeness (fun v => v) direction (length / time) (/ mass) (in_units mass length time direction).
Proof.
  intros above_mass above_length above_time above_direction.
  assert (0 < / (mass * (length * length))) as above_inertia.
  { apply Rinv_0_lt_compat; repeat apply Rmult_lt_0_compat; auto. }
  apply changed_likeness with (common := null); auto.
  - apply identity_isometry.
  - apply Rdiv_lt_0_compat; auto.
  - apply Rinv_0_lt_compat; auto.
  - split.
    + intros b p; rewrite sum_null; unfold velocity_at, lever_arm; cbn [velocity spin centre].
      rewrite <- scaled_difference, cross_scaled_left, cross_scaled, scaled_scaled, scaled_sum; f_equal; f_equal.
      reals; field; lra.
    + intros b; cbn [inverse_mass]; field; lra.
    + intros b p f; apply body_equal; try reflexivity; unfold pushed, lever_arm;
        cbn [inverse_mass inverse_inertia centre velocity spin].
      * rewrite scaled_sum, !scaled_scaled; f_equal; f_equal; reals; field; lra.
      * rewrite <- scaled_difference, cross_scaled, cross_scaled_left, scaled_inertia, !applied_scaled, scaled_sum,
          !scaled_scaled; f_equal; f_equal; reals; field; lra.
    + intros b (is_symmetric & semidefinite & moves); unfold is_possible, is_immovable;
        cbn [inverse_mass inverse_inertia]; repeat split.
      * intros v w; rewrite !scaled_inertia, !dot_scaled, is_symmetric; reflexivity.
      * intros v; rewrite scaled_inertia, dot_scaled; apply Rmult_le_pos; [lra | apply semidefinite].
      * destruct moves as [above | [no_mass no_inertia]].
        -- left; apply Rdiv_lt_0_compat; auto.
        -- right; rewrite no_mass, no_inertia; split; [unfold Rdiv; ring |].
           generalize (/ (mass * (length * length))); clear; by_ring.
Qed.

Theorem unit_scaling (mass length time direction : R) (l : law) (c : contact R) :
  0 < mass -> 0 < length -> 0 < time -> 0 < direction -> is_valid c ->
  resolved (impulse_of l) (in_units mass length time direction c) =
  in_units mass length time direction (resolved (impulse_of l) c).
Proof.
  intros above_mass above_length above_time above_direction.
  apply (likeness_outcome _ _ _ _ _
           (unit_scaling_likeness mass length time direction above_mass above_length above_time above_direction)).
Qed.

(** All velocities and angular velocities are multiplied by k. *)
Definition faster (k : R) : contact R -> contact R :=
  changed (fun b => a_body (inverse_mass b) (inverse_inertia b) (centre b) (scaled k (velocity b)) (scaled k (spin b)))
          (fun p => p) (fun n => n).

Lemma homogeneous_likeness (k : R) : 0 < k -> likeness (fun v => v) 1 k 1 (faster k).
Proof.
  intros above; apply changed_likeness with (common := null); auto; try lra;
    [apply identity_isometry | intros; symmetry; apply scaled_1 |].
  replace (k / 1) with k by field; split.
  - intros b p; rewrite sum_null; unfold velocity_at; cbn [velocity spin].
    change (lever_arm (a_body _ _ _ _ _) p) with (lever_arm b p).
    rewrite cross_scaled_left, scaled_sum; reflexivity.
  - intros b; cbn [inverse_mass]; ring.
  - intros b p f; replace (k / 1) with k by field; apply body_equal; try reflexivity; cbn [pushed velocity spin].
    + cbn [inverse_mass]; rewrite scaled_sum, !scaled_scaled; f_equal; f_equal; reals; ring.
    + change (lever_arm (a_body _ _ _ _ _) p) with (lever_arm b p); cbn [inverse_inertia].
      rewrite cross_scaled, applied_scaled, scaled_sum; reflexivity.
  - auto.
Qed.

Theorem homogeneous (k : R) (l : law) (c : contact R) :
  0 < k -> is_valid c -> resolved (impulse_of l) (faster k c) = faster k (resolved (impulse_of l) c).
Proof. intros above; apply (likeness_outcome _ _ _ _ _ (homogeneous_likeness k above)). Qed.

(** Only the normal is multiplied by k. *)
Definition with_longer_normal (k : R) : contact R -> contact R := changed (fun b => b) (fun p => p) (scaled k).

Lemma normal_length_likeness (k : R) : 0 < k -> likeness (fun v => v) k 1 1 (with_longer_normal k).
Proof.
  intros above; apply changed_likeness with (common := null); auto; try lra; [apply identity_isometry |].
  split; auto.
  - intros b p; rewrite scaled_1, sum_null; reflexivity.
  - intros b; ring.
  - intros b p f; rewrite scaled_1_over_1; reflexivity.
Qed.

(** The outcome differs only in the normal, and the impulse is the same. *)
Theorem normal_length (k : R) (l : law) (c : contact R) :
  0 < k -> is_valid c ->
  resolved (impulse_of l) (with_longer_normal k c) = with_longer_normal k (resolved (impulse_of l) c) /\
  impulse_of l (with_longer_normal k c) = impulse_of l c.
Proof.
  intros above valid; pose proof (normal_length_likeness k above) as alike; split.
  - apply (likeness_outcome _ _ _ _ _ alike); auto.
  - rewrite (likeness_impulse _ _ _ _ _ alike); auto; apply scaled_1_over_1.
Qed.
