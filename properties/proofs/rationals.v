(* SPDX-License-Identifier: BSL-1.0 *)

(** The laws over the rational numbers, which compute. The theorems prove that the results are those of the laws over
    the real numbers. Every finite binary64 number is rational, and only rough needs a root. *)

Require Import QArith Qreals Bool.
Require Import Carom.reals Carom.described_bodies.

(** Fractions are reduced after each operation. Otherwise numerators and denominators would grow without bound. *)
#[export] Instance rational_operations : operations Q := {
  zero := 0%Q;
  one := 1%Q;
  plus x y := Qred (x + y);
  minus x y := Qred (x - y);
  times x y := Qred (x * y);
  over x y := Qred (x / y);
  opposite x := Qopp x;
  less x y := negb (Qle_bool y x)
}.

Local Open Scope R_scope.

Lemma reduced (x : Q) : Q2R (Qred x) = Q2R x.
Proof. apply Qeq_eqR, Qred_correct. Qed.

Lemma of_zero : Q2R zero = zero. Proof. apply RMicromega.Q2R_0. Qed.
Lemma of_one : Q2R one = one. Proof. apply RMicromega.Q2R_1. Qed.
Lemma of_plus (x y : Q) : Q2R (plus x y) = plus (Q2R x) (Q2R y).
Proof. change (Q2R (Qred (x + y)) = Q2R x + Q2R y); rewrite reduced; apply Q2R_plus. Qed.
Lemma of_minus (x y : Q) : Q2R (minus x y) = minus (Q2R x) (Q2R y).
Proof. change (Q2R (Qred (x - y)) = Q2R x - Q2R y); rewrite reduced; apply Q2R_minus. Qed.
Lemma of_times (x y : Q) : Q2R (times x y) = times (Q2R x) (Q2R y).
Proof. change (Q2R (Qred (x * y)) = Q2R x * Q2R y); rewrite reduced; apply Q2R_mult. Qed.
Lemma of_opposite (x : Q) : Q2R (opposite x) = opposite (Q2R x).
Proof. apply Q2R_opp. Qed.

(** In both fields, a number divided by 0 is 0. *)
Lemma of_over (x y : Q) : Q2R (over x y) = over (Q2R x) (Q2R y).
Proof.
  change (Q2R (Qred (x / y)) = Q2R x / Q2R y); rewrite reduced; unfold Qdiv, Rdiv; rewrite Q2R_mult; f_equal.
  destruct (Qeq_dec y 0) as [is_zero | is_not].
  - rewrite (Qeq_eqR _ _ is_zero), RMicromega.Q2R_0, Rinv_0.
    replace (Q2R (/ y)) with (Q2R (/ 0)) by (apply Qeq_eqR; rewrite is_zero; reflexivity).
    unfold Q2R; cbn; ring.
  - apply Q2R_inv; auto.
Qed.

Lemma of_less (x y : Q) : less x y = less (Q2R x) (Q2R y).
Proof.
  apply eq_true_iff_eq; rewrite less_true; cbn [less rational_operations].
  rewrite negb_true_iff, <- not_true_iff_false, Qle_bool_iff.
  split; intros is_less.
  - apply Qlt_Rlt; apply Qnot_le_lt; auto.
  - intros at_most; apply Qle_Rle in at_most; lra.
Qed.

(** Maps vectors, matrices and records from rational numbers to real numbers. *)
Definition of_vector (v : vector Q) := vec (Q2R (x_of v)) (Q2R (y_of v)) (Q2R (z_of v)).
Definition of_matrix (m : matrix Q) := rows (of_vector (row_x m)) (of_vector (row_y m)) (of_vector (row_z m)).
Definition of_body (b : body Q) :=
  a_body (Q2R (inverse_mass b)) (of_matrix (inverse_inertia b)) (of_vector (centre b)) (of_vector (velocity b))
         (of_vector (spin b)).
Definition of_contact (c : contact Q) :=
  a_contact (of_body (body_a c)) (of_body (body_b c)) (of_vector (point c)) (of_vector (normal c))
            (Q2R (restitution c)) (Q2R (friction c)) (Q2R (tangential_restitution c)).
Definition of_quaternion (q : quaternion Q) :=
  a_quaternion (Q2R (w_part q)) (Q2R (x_part q)) (Q2R (y_part q)) (Q2R (z_part q)).
Definition of_description (d : description Q) :=
  a_description (Q2R (described_mass d)) (of_vector (principal_moments d)) (of_quaternion (orientation d))
                (of_vector (described_centre d)) (of_vector (described_velocity d)) (of_vector (described_spin d))
                (described_as_immovable d).

Ltac numbers_moved :=
  repeat rewrite ?of_plus, ?of_minus, ?of_times, ?of_over, ?of_opposite, ?of_zero, ?of_one; reflexivity.
Ltac components_moved definition :=
  intros; unfold definition, of_matrix, of_vector; cbn [x_of y_of z_of row_x row_y row_z]; numbers_moved.

Lemma of_dot v w : Q2R (dot v w) = dot (of_vector v) (of_vector w).
Proof. components_moved @dot. Qed.
Lemma of_sum v w : of_vector (sum v w) = sum (of_vector v) (of_vector w).
Proof. components_moved @sum. Qed.
Lemma of_difference v w : of_vector (difference v w) = difference (of_vector v) (of_vector w).
Proof. components_moved @difference. Qed.
Lemma of_scaled s v : of_vector (scaled s v) = scaled (Q2R s) (of_vector v).
Proof. components_moved @scaled. Qed.
Lemma of_negated v : of_vector (negated v) = negated (of_vector v).
Proof. components_moved @negated. Qed.
Lemma of_cross v w : of_vector (cross v w) = cross (of_vector v) (of_vector w).
Proof. components_moved @cross. Qed.
Lemma of_applied m v : of_vector (applied m v) = applied (of_matrix m) (of_vector v).
Proof.
  unfold applied, of_matrix; cbn [row_x row_y row_z]; rewrite <- !of_dot; reflexivity.
Qed.
Lemma of_transposed m : of_matrix (transposed m) = transposed (of_matrix m).
Proof. reflexivity. Qed.
Lemma of_product m n : of_matrix (product m n) = product (of_matrix m) (of_matrix n).
Proof. unfold product, of_matrix at 1; cbn [row_x row_y row_z]; rewrite !of_applied, of_transposed; reflexivity. Qed.
Lemma of_matrix_sum m n : of_matrix (matrix_sum m n) = matrix_sum (of_matrix m) (of_matrix n).
Proof. unfold matrix_sum, of_matrix at 1; cbn [row_x row_y row_z]; rewrite !of_sum; reflexivity. Qed.
Lemma of_diagonal d : of_matrix (diagonal d) = diagonal (of_vector d).
Proof. components_moved @diagonal. Qed.
Lemma of_uniform s : of_matrix (uniform s) = uniform (Q2R s).
Proof. unfold uniform; rewrite of_diagonal; reflexivity. Qed.
Lemma of_cross_matrix r : of_matrix (cross_matrix r) = cross_matrix (of_vector r).
Proof. components_moved @cross_matrix. Qed.
Lemma of_determinant m : Q2R (determinant m) = determinant (of_matrix m).
Proof. unfold determinant; rewrite of_dot, of_cross; reflexivity. Qed.
Lemma of_adjugate m : of_matrix (adjugate m) = adjugate (of_matrix m).
Proof.
  unfold adjugate; rewrite of_transposed; unfold of_matrix at 1; cbn [row_x row_y row_z].
  rewrite !of_cross; reflexivity.
Qed.
Lemma of_solved m v : of_vector (solved m v) = solved (of_matrix m) (of_vector v).
Proof. unfold solved; rewrite of_scaled, of_applied, of_adjugate, of_over, of_one, of_determinant; reflexivity. Qed.

Lemma of_lever_arm b p : of_vector (lever_arm b p) = lever_arm (of_body b) (of_vector p).
Proof. apply of_difference. Qed.
Lemma of_velocity_at b p : of_vector (velocity_at b p) = velocity_at (of_body b) (of_vector p).
Proof. unfold velocity_at; rewrite of_sum, of_cross, of_lever_arm; reflexivity. Qed.
Lemma of_relative_velocity c : of_vector (relative_velocity c) = relative_velocity (of_contact c).
Proof. unfold relative_velocity; rewrite of_difference, !of_velocity_at; reflexivity. Qed.
Lemma of_approach c : Q2R (approach c) = approach (of_contact c).
Proof. unfold approach; rewrite of_dot, of_relative_velocity; reflexivity. Qed.
Lemma of_inverse_masses c : Q2R (inverse_masses c) = inverse_masses (of_contact c).
Proof. apply of_plus. Qed.
Lemma of_of_spin b p : of_matrix (of_spin b p) = of_spin (of_body b) (of_vector p).
Proof.
  unfold of_spin; rewrite !of_product, of_transposed, of_cross_matrix, of_lever_arm; reflexivity.
Qed.
Lemma of_collision_matrix c : of_matrix (collision_matrix c) = collision_matrix (of_contact c).
Proof.
  unfold collision_matrix; rewrite !of_matrix_sum, of_uniform, of_inverse_masses, !of_of_spin; reflexivity.
Qed.
Lemma of_normal_compliance c : Q2R (normal_compliance c) = normal_compliance (of_contact c).
Proof. unfold normal_compliance; rewrite of_dot, of_applied, of_collision_matrix; reflexivity. Qed.

Ltac moved := repeat rewrite ?of_dot, ?of_sum, ?of_difference, ?of_scaled, ?of_negated, ?of_cross, ?of_applied,
  ?of_solved, ?of_plus, ?of_minus, ?of_times, ?of_over, ?of_opposite, ?of_one, ?of_zero, ?of_approach,
  ?of_normal_compliance, ?of_collision_matrix, ?of_relative_velocity.

Theorem frictionless_computes c : of_vector (frictionless_impulse c) = frictionless_impulse (of_contact c).
Proof. unfold frictionless_impulse; moved; reflexivity. Qed.

Theorem reflection_computes c : of_vector (reflection_impulse c) = reflection_impulse (of_contact c).
Proof. unfold reflection_impulse; moved; reflexivity. Qed.

Theorem sticking_computes c : of_vector (sticking_impulse c) = sticking_impulse (of_contact c).
Proof. unfold sticking_impulse; moved; reflexivity. Qed.

Lemma of_stops_approach c : of_vector (stops_approach c) = stops_approach (of_contact c).
Proof. unfold stops_approach; moved; reflexivity. Qed.
Lemma of_from_one_to_other c : of_vector (from_one_to_other c) = from_one_to_other (of_contact c).
Proof.
  unfold from_one_to_other, stops_point; rewrite of_difference, of_stops_approach; moved; reflexivity.
Qed.
Lemma of_rough_with c kappa : of_vector (rough_with c kappa) = rough_with (of_contact c) (Q2R kappa).
Proof. unfold rough_with; moved; rewrite of_stops_approach, of_from_one_to_other; reflexivity. Qed.
Lemma of_in_cone c f : in_cone c f = in_cone (of_contact c) (of_vector f).
Proof.
  unfold in_cone, square, squared; rewrite !of_less; moved; reflexivity.
Qed.
Lemma of_sticks_in_cone c : sticks_in_cone c = sticks_in_cone (of_contact c).
Proof. unfold sticks_in_cone; rewrite of_in_cone, of_rough_with; moved; reflexivity. Qed.
Lemma of_radicand c : Q2R (radicand c) = radicand (of_contact c).
Proof. unfold radicand, square; moved; rewrite of_from_one_to_other; reflexivity. Qed.

Lemma of_squared x : Q2R (squared x) = squared (Q2R x).
Proof. apply of_times. Qed.

(** The pair of on_the_cone over the rational numbers equals the pair over the real numbers. *)
Lemma of_on_the_cone c :
  (Q2R (fst (on_the_cone c)), Q2R (snd (on_the_cone c))) = on_the_cone (of_contact c).
Proof.
  unfold on_the_cone; rewrite <- of_radicand, <- of_stops_approach, <- of_from_one_to_other.
  cbn [of_contact normal restitution friction]; rewrite <- !of_dot.
  generalize (radicand c) (dot (normal c) (stops_approach c)) (dot (normal c) (from_one_to_other c)) (friction c)
    (restitution c); intros s stop along mu bounce; cbv zeta.
  rewrite <- of_one, <- of_zero, <- !of_plus, <- !of_times, <- of_squared, <- of_minus, <- !of_less, <- of_plus,
    <- of_opposite, <- !of_over, <- of_times.
  destruct (_ || _); reflexivity.
Qed.

(** The two impulses of rough, and the number under the root between them. *)
Theorem rough_computes c :
  let (first, second) := rough_impulses c in
  (of_vector first, of_vector second) = rough_impulses (of_contact c) /\ Q2R (radicand c) = radicand (of_contact c).
Proof.
  unfold rough_impulses, rough_kappa; rewrite of_sticks_in_cone, <- of_on_the_cone.
  destruct (sticks_in_cone (of_contact c)); [| destruct (on_the_cone c) as [p q]; cbn [fst snd]];
    (split; [rewrite of_rough_with, of_scaled, of_from_one_to_other | apply of_radicand]);
    [rewrite of_plus, of_one, of_zero |]; reflexivity.
Qed.

Theorem is_colliding_computes c : is_colliding c = is_colliding (of_contact c).
Proof. unfold is_colliding; rewrite !of_less, of_approach, of_inverse_masses, of_zero; reflexivity. Qed.

Theorem pushed_computes b p f : of_body (pushed b p f) = pushed (of_body b) (of_vector p) (of_vector f).
Proof.
  unfold pushed, of_body at 1; cbn [inverse_mass inverse_inertia centre velocity spin].
  rewrite !of_sum, of_scaled, of_applied, of_cross, of_lever_arm; reflexivity.
Qed.

Theorem resolved_computes (rational_law : contact Q -> vector Q) (law : contact R -> vector R) c :
  of_vector (rational_law c) = law (of_contact c) ->
  of_contact (resolved rational_law c) = resolved law (of_contact c).
Proof.
  intros same; unfold resolved; rewrite is_colliding_computes; destruct (is_colliding (of_contact c)); auto.
  unfold after, of_contact at 1; cbn [body_a body_b point normal restitution friction tangential_restitution].
  rewrite !pushed_computes, of_negated, same; reflexivity.
Qed.

Theorem body_of_computes d : of_body (body_of d) = body_of (of_description d).
Proof.
  unfold body_of; destruct d as [mass moments [w x y z] position speed turning []];
    cbn [described_as_immovable of_description].
  - unfold of_body; cbn [inverse_mass inverse_inertia centre velocity spin]; rewrite of_zero.
    unfold zero_matrix; rewrite of_uniform, of_zero; reflexivity.
  - unfold of_body, turned; cbn [inverse_mass inverse_inertia centre velocity spin].
    rewrite !of_product, of_transposed, of_diagonal; moved.
    assert (of_matrix (rotation (a_quaternion w x y z)) =
            rotation (of_quaternion (a_quaternion w x y z))) as same_rotation.
    { unfold rotation, of_quaternion, quaternion_square; cbn [w_part x_part y_part z_part]; unfold of_matrix, of_vector;
        cbn [row_x row_y row_z x_of y_of z_of]; numbers_moved. }
    assert (of_vector (reciprocal moments) = reciprocal (of_vector moments)) as same_reciprocal.
    { unfold reciprocal, of_vector; cbn [x_of y_of z_of]; numbers_moved. }
    cbn [orientation principal_moments described_mass described_centre described_velocity described_spin
         of_description].
    rewrite same_rotation, same_reciprocal; reflexivity.
Qed.
