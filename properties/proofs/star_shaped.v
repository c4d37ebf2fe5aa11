(* SPDX-License-Identifier: BSL-1.0 *)

(** Bodies of uniform density that are star-shaped from the point of contact have rrᵀ ⪯ 15 S (r and S as in
    well_conditioned.v), so K ⪯ 16 λI. No proof assumes that a body is convex. No number below 15 suffices, because
    needles come near 15. *)

Require Import List.
Require Import Carom.reals Carom.collision_matrix Carom.well_conditioned.
Import ListNotations.
Local Open Scope R_scope.

(** The proof by a mean over the boundary. q is the offset of a boundary point from the point of contact, weighted by
    the volume of the cone over it. In polar coordinates, the centre of mass is at (3/4) mean q, and the mean of (x·v)²
    over the points x of the volume is (3/5) mean (q·v)². Both equations are hypotheses. Only the functions with
    has_mean need a mean. *)
Section Mean.
  Variables (has_mean : (vector R -> R) -> Prop) (mean : (vector R -> R) -> R).
  Hypotheses
    (one_has_mean : has_mean (fun _ => 1))
    (sum_has_mean : forall f g, has_mean f -> has_mean g -> has_mean (fun q => f q + g q))
    (scaled_has_mean : forall s f, has_mean f -> has_mean (fun q => s * f q))
    (mean_one : mean (fun _ => 1) = 1)
    (mean_sum : forall f g, has_mean f -> has_mean g -> mean (fun q => f q + g q) = mean f + mean g)
    (mean_scaled : forall s f, has_mean f -> mean (fun q => s * f q) = s * mean f)
    (mean_nonnegative : forall f, has_mean f -> (forall q, 0 <= f q) -> 0 <= mean f).

  (** Jensen's inequality. *)
  Lemma mean_of_square (f : vector R -> R) :
    has_mean f -> has_mean (fun q => f q * f q) -> mean f * mean f <= mean (fun q => f q * f q).
  Proof.
    intros has_f has_square; pose (e := mean f).
    assert (0 <= mean (fun q => f q * f q + (-2 * e * f q + e * e * 1))) as spread.
    { apply mean_nonnegative; [repeat (apply sum_has_mean || apply scaled_has_mean); auto |].
      intros q; pose proof (Rle_0_sqr (f q - e)); unfold Rsqr in *; lra. }
    rewrite mean_sum, mean_sum, !mean_scaled, mean_one in spread by auto; fold e in spread |- *; lra.
  Qed.

  Variables (s : matrix R) (r : vector R).
  Hypotheses
    (form_has_mean : forall v, has_mean (fun q => dot q v))
    (square_has_mean : forall v, has_mean (fun q => dot q v * dot q v))
    (centre_by_mean : forall v, - dot r v = 3 / 4 * mean (fun q => dot q v))
    (moments_by_mean :
       forall v, dot v (applied s v) = 3 / 5 * mean (fun q => dot q v * dot q v) - dot r v * dot r v).

  Theorem star_shaped_by_mean : dominates s r.
  Proof.
    intros v; rewrite moments_by_mean.
    pose proof (mean_of_square (fun q => dot q v) (form_has_mean v) (square_has_mean v)) as jensen; cbv beta in jensen.
    assert (mean (fun q => dot q v) = - (4 / 3) * dot r v) as at_mean by (pose proof (centre_by_mean v); lra).
    rewrite at_mean in jensen; lra.
  Qed.
End Mean.

(** A polyhedron that is star-shaped from the point of contact. It consists of tetrahedra with that point as apex. Each
    has the corners of its base as offsets from the apex, and its share of the volume. *)
Record tetrahedron := { share : R; corner_a : vector R; corner_b : vector R; corner_c : vector R }.

(** The tetrahedron is not flat. Its volume is a sixth of the determinant. *)
Definition has_volume (t : tetrahedron) := 0 < determinant (rows (corner_a t) (corner_b t) (corner_c t)).

Definition is_star_shaped (parts : list tetrahedron) :=
  Forall (fun t => 0 <= share t) parts /\ fold_right (fun t rest => share t + rest) 0 parts = 1.

Definition scaled_matrix (s : R) (m : matrix R) := product (uniform s) m.
(** v vᵀ. *)
Definition outer (v : vector R) := rows (scaled (x_of v) v) (scaled (y_of v) v) (scaled (z_of v) v).

(** The means of x and x xᵀ over the points x of a uniform tetrahedron, from its apex. *)
Definition corners (t : tetrahedron) := sum (corner_a t) (sum (corner_b t) (corner_c t)).
Definition tetrahedron_centre (t : tetrahedron) := scaled (1 / 4) (corners t).
Definition tetrahedron_moments (t : tetrahedron) :=
  scaled_matrix (1 / 20)
    (matrix_sum (matrix_sum (outer (corner_a t)) (outer (corner_b t)))
                (matrix_sum (outer (corner_c t)) (outer (corners t)))).

(** The means of x and x xᵀ over all tetrahedra together, from the point of contact. *)
Definition centre_from_point (parts : list tetrahedron) :=
  fold_right (fun t rest => sum (scaled (share t) (tetrahedron_centre t)) rest) null parts.
Definition moments_from_point (parts : list tetrahedron) :=
  fold_right (fun t rest => matrix_sum (scaled_matrix (share t) (tetrahedron_moments t)) rest) zero_matrix parts.

(** S about the centre, and r from the centre to the point. *)
Definition moments_about_centre (parts : list tetrahedron) :=
  matrix_sum (moments_from_point parts) (scaled_matrix (-1) (outer (centre_from_point parts))).
Definition arm_of (parts : list tetrahedron) := negated (centre_from_point parts).

Lemma outer_form (u v : vector R) : dot v (applied (outer u) v) = dot u v * dot u v.
Proof. unfold outer; by_ring. Qed.

Lemma applied_scaled_matrix (s : R) (m : matrix R) (v : vector R) :
  applied (scaled_matrix s m) v = scaled s (applied m v).
Proof. unfold scaled_matrix; by_ring. Qed.

Lemma tetrahedron_moments_form (t : tetrahedron) (v : vector R) :
  dot v (applied (tetrahedron_moments t) v) =
  1 / 20 * (dot (corner_a t) v * dot (corner_a t) v + dot (corner_b t) v * dot (corner_b t) v +
            dot (corner_c t) v * dot (corner_c t) v + dot (corners t) v * dot (corners t) v).
Proof.
  unfold tetrahedron_moments; rewrite applied_scaled_matrix, !applied_matrix_sum, dot_scaled, !dot_sum,
    !outer_form; ring.
Qed.

(** The bound for one tetrahedron. Equality holds if the corners of the base have equal components along v. *)
Lemma tetrahedron_bound (t : tetrahedron) (v : vector R) :
  16 / 15 * (dot (tetrahedron_centre t) v * dot (tetrahedron_centre t) v) <=
  dot v (applied (tetrahedron_moments t) v).
Proof.
  rewrite tetrahedron_moments_form; unfold tetrahedron_centre; rewrite dot_scaled_left; unfold corners.
  rewrite !dot_sum_left; reals; generalize (dot (corner_a t) v) (dot (corner_b t) v) (dot (corner_c t) v); intros a b c.
  pose proof (Rle_0_sqr (a - b)); pose proof (Rle_0_sqr (b - c)); pose proof (Rle_0_sqr (c - a)); unfold Rsqr in *; lra.
Qed.

(** Jensen's inequality: c² ≥ 2 e c - e², its tangent at e, and sums of tangents are linear. *)
Lemma above_tangents (parts : list tetrahedron) (v : vector R) (e : R) :
  Forall (fun t => 0 <= share t) parts ->
  16 / 15 * (2 * e * dot (centre_from_point parts) v - e * e * fold_right (fun t rest => share t + rest) 0 parts) <=
  dot v (applied (moments_from_point parts) v).
Proof.
  induction 1 as [| t rest positive _ bound]; cbn [fold_right centre_from_point moments_from_point].
  - rewrite applied_zero_matrix; destruct v; in_components; lra.
  - fold (centre_from_point rest) (moments_from_point rest).
    rewrite applied_matrix_sum, applied_scaled_matrix, dot_sum, dot_scaled, dot_sum_left, dot_scaled_left.
    pose proof (tetrahedron_bound t v) as one; revert positive bound one; reals.
    generalize (share t) (dot (tetrahedron_centre t) v) (dot v (applied (tetrahedron_moments t) v))
      (dot (centre_from_point rest) v) (dot v (applied (moments_from_point rest) v))
      (fold_right (fun t rest => share t + rest) 0 rest).
    intros w c m d n total positive bound one.
    assert (16 / 15 * (2 * e * c - e * e) <= m) as tangent by (pose proof (Rle_0_sqr (c - e)); unfold Rsqr in *; lra).
    apply (Rmult_le_compat_l w) in tangent; auto; lra.
Qed.

Theorem star_shaped (parts : list tetrahedron) :
  is_star_shaped parts -> dominates (moments_about_centre parts) (arm_of parts).
Proof.
  intros [positive whole] v; unfold moments_about_centre, arm_of.
  pose proof (above_tangents parts v (dot (centre_from_point parts) v) positive) as bound; rewrite whole in bound.
  rewrite applied_matrix_sum, applied_scaled_matrix, dot_sum, dot_scaled, outer_form, dot_negated_left; reals; lra.
Qed.

Lemma moments_symmetric (parts : list tetrahedron) : symmetric (moments_about_centre parts).
Proof.
  assert (forall u, symmetric (outer u)) as outer_symmetric by (intros u v w; unfold outer; by_ring).
  assert (forall u v t, dot v (applied (tetrahedron_moments t) u) = dot u (applied (tetrahedron_moments t) v)) as part.
  { intros u v t; unfold tetrahedron_moments.
    rewrite !applied_scaled_matrix, !applied_matrix_sum, !dot_scaled, !dot_sum.
    rewrite (outer_symmetric (corner_a t) v u), (outer_symmetric (corner_b t) v u), (outer_symmetric (corner_c t) v u),
      (outer_symmetric (corners t) v u); reflexivity. }
  assert (symmetric (moments_from_point parts)) as whole.
  { intros v w; induction parts as [| t rest hypothesis]; cbn [fold_right moments_from_point].
    - rewrite !applied_zero_matrix; by_ring.
    - fold (moments_from_point rest).
      rewrite !applied_matrix_sum, !applied_scaled_matrix, !dot_sum, !dot_scaled, hypothesis, (part w v t).
      reflexivity. }
  intros v w; unfold moments_about_centre.
  rewrite !applied_matrix_sum, !applied_scaled_matrix, !dot_sum, !dot_scaled, whole, (outer_symmetric _ v w).
  reflexivity.
Qed.

(** A movable body of this mass that consists of these parts and touches at p. *)
Definition is_made_of (b : body R) (p : vector R) (mass : R) (parts : list tetrahedron) :=
  is_star_shaped parts /\ has_moments b mass (moments_about_centre parts) /\ lever_arm b p = arm_of parts.
Definition has_star_shape (b : body R) (p : vector R) := exists mass parts, is_made_of b p mass parts.

Lemma star_shape_dominated (b : body R) (p : vector R) :
  is_immovable b \/ has_star_shape b p -> is_dominated 15 b p.
Proof.
  intros [immovable | (mass & parts & shape & moments & arm)]; [left; auto | right].
  exists mass, (moments_about_centre parts); split; auto; rewrite arm; apply star_shaped; auto.
Qed.

Theorem star_shaped_well_conditioned (c : contact R) :
  is_valid c ->
  is_immovable (body_a c) \/ has_star_shape (body_a c) (point c) ->
  is_immovable (body_b c) \/ has_star_shape (body_b c) (point c) ->
  at_most (16 * inverse_masses c) (collision_matrix c).
Proof. intros valid shape_a shape_b; apply well_conditioned; auto; apply star_shape_dominated; auto. Qed.

Theorem star_shaped_condition_number (c : contact R) (u v : vector R) :
  is_valid c ->
  is_immovable (body_a c) \/ has_star_shape (body_a c) (point c) ->
  is_immovable (body_b c) \/ has_star_shape (body_b c) (point c) ->
  square u = square v ->
  dot u (applied (collision_matrix c) u) <= 16 * dot v (applied (collision_matrix c) v).
Proof. intros valid shape_a shape_b; apply condition_number; auto; apply star_shape_dominated; auto. Qed.

(** The polyhedron as a user gives it: triangles. Each triangle is counterclockwise when seen from outside. No
    determinant is then negative if the polyhedron is star-shaped. The determinant of a tetrahedron gives its share of
    the volume. *)
Record triangle := { first : vector R; second : vector R; third : vector R }.
Definition six_volumes (t : triangle) := determinant (rows (first t) (second t) (third t)).
Definition all_volumes (surface : list triangle) := fold_right (fun t rest => six_volumes t + rest) 0 surface.
Definition parts_of (surface : list triangle) :=
  map (fun t => Build_tetrahedron (six_volumes t / all_volumes surface) (first t) (second t) (third t)) surface.

Theorem star_shaped_surface (surface : list triangle) :
  Forall (fun t => 0 <= six_volumes t) surface -> 0 < all_volumes surface -> is_star_shaped (parts_of surface).
Proof.
  intros positive not_empty; unfold parts_of; set (whole := all_volumes surface) in *; split.
  - clearbody whole; induction positive as [| t rest one _ all]; cbn [map]; constructor; auto; cbn [share].
    apply Rmult_le_pos; auto; apply Rlt_le, Rinv_0_lt_compat; auto.
  - replace 1 with (all_volumes surface / whole) by (unfold whole in *; field; lra); clearbody whole; clear positive.
    induction surface as [| t rest all]; cbn [map fold_right all_volumes share]; [field; lra |].
    fold (all_volumes rest); rewrite all; field; lra.
Qed.

(** The needle. Its base has the size d and is at distance 1 from the point of contact. *)
Definition needle (d : R) : list tetrahedron :=
  [{| share := 1; corner_a := vec 1 (2 * d) 0; corner_b := vec 1 (- d) d; corner_c := vec 1 (- d) (- d) |}].

Definition needle_body (d : R) : body R :=
  a_body 1 (diagonal (vec (10 / (4 * d * d)) (1 / (3 / 80 + d * d / 10)) (1 / (3 / 80 + 3 * d * d / 10))))
         (vec (3 / 4) 0 0) (vec (-1) 0 0) (vec 0 0 0).

(** The needle moves along its length and hits an immovable body. *)
Definition needle_contact (d : R) : contact R :=
  a_contact (needle_body d) (a_body 0 zero_matrix (vec (-1) 0 0) (vec 0 0 0) (vec 0 0 0))
            (vec 0 0 0) (vec 1 0 0) 1 0 0.

Lemma needle_star_shaped (d : R) : is_star_shaped (needle d).
Proof. split; [repeat constructor; cbn; lra | cbn; ring]. Qed.

Lemma needle_arm (d : R) : arm_of (needle d) = vec (- 3 / 4) 0 0.
Proof.
  unfold arm_of, centre_from_point, needle, tetrahedron_centre, corners;
    cbn [fold_right share corner_a corner_b corner_c].
  in_components; same_components; field.
Qed.

Lemma needle_moments (d : R) :
  moments_about_centre (needle d) = diagonal (vec (3 / 80) (3 * d * d / 10) (d * d / 10)).
Proof.
  unfold moments_about_centre, moments_from_point, centre_from_point, needle, tetrahedron_moments, tetrahedron_centre,
    corners, scaled_matrix, outer; cbn [fold_right share corner_a corner_b corner_c].
  in_components; same_components; field.
Qed.

Lemma needle_has_moments (d : R) : 0 < d -> has_moments (needle_body d) 1 (moments_about_centre (needle d)).
Proof.
  intros positive; assert (0 < d * d) by nra; rewrite needle_moments; split;
    cbn [needle_body inverse_mass inverse_inertia].
  - lra.
  - reals; field.
  - intros v; unfold inertia, trace_without, trace; destruct v; in_components; same_components;
      field; repeat split; lra.
Qed.

Lemma needle_made_of (d : R) : 0 < d -> is_made_of (needle_body d) (vec 0 0 0) 1 (needle d).
Proof.
  intros positive; refine (conj (needle_star_shaped d) (conj (needle_has_moments d positive) _)).
  rewrite needle_arm; unfold lever_arm, needle_body; cbn [centre]; in_components; same_components; field.
Qed.

Lemma needle_immovable (d : R) : is_immovable (body_b (needle_contact d)).
Proof. split; reflexivity. Qed.

Lemma needle_contact_valid (d : R) : 0 < d -> is_valid (needle_contact d).
Proof.
  intros positive; assert (0 < d * d) by nra.
  split; cbn [needle_contact body_a body_b normal restitution friction tangential_restitution]; try lra.
  - split; [| split]; cbn [needle_body inverse_inertia inverse_mass].
    + intros v w; destruct v, w; in_components; ring.
    + intros [x y z].
      assert (0 < 10 / (4 * d * d)) as i by (apply Rdiv_lt_0_compat; lra).
      assert (0 < 1 / (3 / 80 + d * d / 10)) as j by (apply Rdiv_lt_0_compat; lra).
      assert (0 < 1 / (3 / 80 + 3 * d * d / 10)) as k by (apply Rdiv_lt_0_compat; lra).
      revert i j k; generalize (10 / (4 * d * d)) (1 / (3 / 80 + d * d / 10)) (1 / (3 / 80 + 3 * d * d / 10)).
      intros i j k; in_components; intros; pose proof (Rle_0_sqr x) as first_square;
        pose proof (Rle_0_sqr y) as second_square; pose proof (Rle_0_sqr z) as third_square; unfold Rsqr in *.
      apply (Rmult_le_compat_l i) in first_square; [| lra]; apply (Rmult_le_compat_l j) in second_square; [| lra];
        apply (Rmult_le_compat_l k) in third_square; [| lra]; lra.
    + left; reals; lra.
  - split; [| split]; cbn [inverse_inertia inverse_mass].
    + intros v w; rewrite !applied_zero_matrix; by_ring.
    + intros v; rewrite applied_zero_matrix; destruct v; in_components; lra.
    + right; split; reflexivity.
  - unfold inverse_masses; cbn; lra.
  - intros equal; apply (f_equal x_of) in equal; cbn in equal; lra.
Qed.

Lemma needle_inverse_masses (d : R) : inverse_masses (needle_contact d) = 1.
Proof. unfold inverse_masses; cbn; lra. Qed.

(** Along the needle K is λ, and across the needle K is nearly 16 λ. *)
Lemma needle_along (d : R) :
  dot (vec 1 0 0) (applied (collision_matrix (needle_contact d)) (vec 1 0 0)) = 1.
Proof.
  rewrite collision_matrix_form, !of_spin_form, needle_inverse_masses; unfold lever_arm, needle_contact, needle_body;
    cbn [body_a body_b point centre inverse_inertia].
  generalize (10 / (4 * d * d)) (1 / (3 / 80 + d * d / 10)) (1 / (3 / 80 + 3 * d * d / 10)); intros i j k.
  in_components; field.
Qed.

Lemma needle_across (d : R) :
  0 < d ->
  dot (vec 0 0 1) (applied (collision_matrix (needle_contact d)) (vec 0 0 1)) =
  16 - 40 * (d * d) / (1 + 8 / 3 * (d * d)).
Proof.
  intros positive; assert (0 < d * d) by nra.
  rewrite collision_matrix_form, !of_spin_form, needle_inverse_masses; unfold lever_arm, needle_contact, needle_body;
    cbn [body_a body_b point centre inverse_inertia].
  generalize (10 / (4 * d * d)) (1 / (3 / 80 + 3 * d * d / 10)); intros i k.
  in_components; field; split; lra.
Qed.

(** For each eta > 0, across a thin enough needle, K exceeds 16 - eta. *)
Lemma thin_needle (eta : R) :
  0 < eta -> exists d, 0 < d /\
  16 - eta < dot (vec 0 0 1) (applied (collision_matrix (needle_contact d)) (vec 0 0 1)).
Proof.
  intros positive; exists (Rmin 1 (eta / 41)); set (d := Rmin 1 (eta / 41)).
  assert (0 < d) as thick by (apply Rmin_glb_lt; lra).
  assert (d <= 1) by apply Rmin_l; assert (d <= eta / 41) by apply Rmin_r.
  split; auto; rewrite needle_across by auto; clearbody d.
  assert (0 < d * d) by nra; assert (d * d <= eta / 41) by nra.
  assert (40 * (d * d) / (1 + 8 / 3 * (d * d)) < eta); [| lra].
  apply (Rmult_lt_reg_r (1 + 8 / 3 * (d * d))); [lra |].
  unfold Rdiv; rewrite Rmult_assoc, Rinv_l, Rmult_1_r by lra; nra.
Qed.

Lemma needle_has_volume (d : R) : 0 < d -> Forall has_volume (needle d).
Proof.
  intros positive; assert (0 < d * d) by nra.
  repeat constructor; unfold has_volume; cbn [corner_a corner_b corner_c]; in_components; lra.
Qed.

(** The bound 16 cannot be lowered, even for one movable tetrahedron. *)
Theorem bound_is_sharp (eta : R) :
  0 < eta ->
  exists (c : contact R) (part : tetrahedron) (x : vector R),
    is_valid c /\ is_colliding c = true /\
    is_made_of (body_a c) (point c) 1 [part] /\ has_volume part /\ is_immovable (body_b c) /\
    x <> null /\ (16 - eta) * inverse_masses c * square x < dot x (applied (collision_matrix c) x).
Proof.
  intros positive; destruct (thin_needle eta positive) as (d & thick & nearly).
  exists (needle_contact d); eexists; exists (vec 0 0 1).
  split; [apply needle_contact_valid; auto |].
  split; [apply is_colliding_true; split; [rewrite needle_inverse_masses; lra |] |].
  { unfold approach, relative_velocity, velocity_at, needle_contact, needle_body, lever_arm;
      cbn [body_a body_b point normal velocity spin centre]; in_components; lra. }
  split; [apply needle_made_of; auto |].
  split; [apply (Forall_inv (needle_has_volume d thick)) | split; [apply needle_immovable | split]].
  - intros equal; apply (f_equal z_of) in equal; cbn in equal; lra.
  - rewrite needle_inverse_masses; replace (square (vec 0 0 1)) with 1 by (in_components; ring); lra.
Qed.

(** The bound of the condition number cannot be lowered. *)
Theorem condition_number_is_sharp (eta : R) :
  0 < eta ->
  exists (c : contact R) (part : tetrahedron) (u v : vector R),
    is_valid c /\ is_made_of (body_a c) (point c) 1 [part] /\ has_volume part /\ is_immovable (body_b c) /\
    square u = 1 /\ square v = 1 /\
    (16 - eta) * dot v (applied (collision_matrix c) v) < dot u (applied (collision_matrix c) u).
Proof.
  intros positive; destruct (thin_needle eta positive) as (d & thick & nearly).
  exists (needle_contact d); eexists; exists (vec 0 0 1), (vec 1 0 0).
  split; [apply needle_contact_valid; auto |].
  split; [apply needle_made_of; auto |].
  split; [apply (Forall_inv (needle_has_volume d thick)) | split; [apply needle_immovable | split; [| split]]].
  - in_components; ring.
  - in_components; ring.
  - rewrite needle_along; lra.
Qed.
