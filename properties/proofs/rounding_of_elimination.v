(* SPDX-License-Identifier: BSL-1.0 *)

(** The elimination of Ldlt::solve_by (src/impulse/solve3.hpp, from d0 to d2) with each result rounded, on a symmetric K
    with λI ⪯ K ⪯ cλI. The unit roundoff u is 2^-24 or 2^-53. The solver may get a least eigenvalue of at most (1 + s)
    λ; without one, s is 0. If c² (u + s) ≤ 1/64, the computed pivots differ from those of K by at most 8 c (c + 1) (u +
    s) λ, and are at least 3/4 λ. Neither C++ nor this proof scales K.

    The K of well_conditioned.v has c = 16. Then no pivot is below (1 - 2^-12) λ in binary32, or below (1 - 2^-41) λ in
    binary64. This holds for λ from 2^-119 in binary32, and from 2^-1015 in binary64. Nothing overflows for λ up to
    2^122 or up to 2^1018. If the solver gets a computed K, with an error of at most δλ in each entry and δ ≤ 2^-17, the
    pivots are at least λ/2.

    Each operation has to be rounded once. scaled_elimination also holds if a product is not rounded before it is
    subtracted, as in a fused operation.

    Some errors are outside this proof. The error of K from rounded lever arms, inertias and masses is not proved: δ is
    an assumption. The right-hand side and the substitutions y1, y2, x2, x1, x0 are not covered. So the backward error
    of the impulse and the error of an outcome are not proved. The decompositions of Eigen are not covered. *)

Require Import List Carom.rounding Carom.collision_matrix Carom.well_conditioned.
From Flocq Require Import Core.
Import ListNotations.
Local Open Scope R_scope.

(** The results of Ldlt::solve_by up to d2. The names are those of the C++ code if it has a name. *)
Section Elimination.
  Context {T : Type} {of_T : operations T} (pivot : T -> T) (m : matrix T).
  Local Open Scope number_scope.

  Definition d0 := pivot (x_of (row_x m)).
  Definition l10 := x_of (row_y m) / d0.
  Definition l20 := x_of (row_z m) / d0.
  Definition taken_11 := l10 * x_of (row_y m).
  Definition left_11 := y_of (row_y m) - taken_11.
  Definition d1 := pivot left_11.
  Definition taken_21 := l20 * x_of (row_y m).
  Definition e21 := y_of (row_z m) - taken_21.
  Definition l21 := e21 / d1.
  Definition taken_22 := l20 * x_of (row_z m).
  Definition left_22 := z_of (row_z m) - taken_22.
  Definition taken_again_22 := l21 * e21.
  Definition left_again_22 := left_22 - taken_again_22.
  Definition d2 := pivot left_again_22.

  Definition pivots := [d0; d1; d2].
  Definition quotients := [l10; l20; l21].
  Definition other_results := [taken_11; left_11; taken_21; e21; taken_22; left_22; taken_again_22; left_again_22].
End Elimination.

Lemma through (x y z s t : R) : Rabs (x - y) <= s -> Rabs (y - z) <= t -> Rabs (x - z) <= s + t.
Proof. intros; replace (x - z) with ((x - y) + (y - z)) by ring; eapply Rle_trans; [apply Rabs_triang | lra]. Qed.

Lemma size_of_near (x y s : R) : Rabs (x - y) <= s -> Rabs x <= Rabs y + s.
Proof. intros; replace x with (y + (x - y)) by ring; eapply Rle_trans; [apply Rabs_triang | lra]. Qed.

Lemma square_over_nonnegative (x y : R) : 0 < y -> 0 <= x / y * x.
Proof.
  intros; replace (x / y * x) with (x * x * / y) by (field; lra).
  apply Rmult_le_pos; [nra | left; apply Rinv_0_lt_compat; auto].
Qed.

(** A bound of y²/q - x²/p, from the errors of y and q as approximations of x and p. *)
Lemma square_over_error (c r x y p q : R) :
  1 <= c -> 0 <= r -> c * r <= 1 / 64 -> 1 <= p -> Rabs x <= (c - 1) / 2 -> x / p * x <= c - 1 ->
  Rabs (y - x) <= 3 * c * r -> Rabs (q - p) <= 4 * c * r ->
  15 / 16 <= q /\ Rabs (y / q * y - x / p * x) <= 15 / 2 * (c * c * r).
Proof.
  intros large not_negative small p_large x_bounded square_bounded y_near q_near.
  assert (15 / 16 <= q) as q_large by (apply Rabs_le_inv in q_near; lra).
  split; auto.
  pose proof (square_over_nonnegative x p ltac:(lra)) as square_not_negative.
  replace (y / q * y - x / p * x) with (/ q * ((y - x) * (y + x) + - (x / p * x * (q - p)))) by (field; lra).
  set (square := x / p * x) in *; clearbody square.
  assert (Rabs (y + x) <= c) as both_bounded.
  { replace (y + x) with ((y - x) + (x + x)) by ring.
    pose proof (Rabs_triang (y - x) (x + x)); pose proof (Rabs_triang x x); lra. }
  assert (Rabs ((y - x) * (y + x) + - (square * (q - p))) <= 7 * (c * c * r)) as numerator.
  { eapply Rle_trans; [apply Rabs_triang |]; rewrite Rabs_Ropp, !Rabs_mult, (Rabs_pos_eq square) by auto.
    assert (Rabs (y - x) * Rabs (y + x) <= 3 * c * r * c)
      by (apply Rmult_le_compat; auto using Rabs_pos).
    assert (square * Rabs (q - p) <= c * (4 * c * r))
      by (apply Rmult_le_compat; auto using Rabs_pos; lra).
    lra. }
  assert (0 < / q <= 16 / 15) as inverse.
  { split; [apply Rinv_0_lt_compat; lra |].
    replace (16 / 15) with (/ (15 / 16)) by field; apply Rinv_le_contravar; lra. }
  rewrite Rabs_mult, (Rabs_pos_eq (/ q)) by lra.
  assert (0 <= c * c * r) by (apply Rmult_le_pos; nra).
  pose proof (Rabs_pos ((y - x) * (y + x) + - (square * (q - p)))); nra.
Qed.

(** The errors if all numbers are scaled so that the least eigenvalue is 1. Each operation may have an error of u times
    its result plus h. Raising a pivot may add an error of s. *)
Section Scaled.
  Variables u h : R.
  Hypotheses (u_not_negative : 0 <= u) (h_not_negative : 0 <= h).

  Definition is_near x y := Rabs (x - y) <= u * Rabs y + h.

  Lemma near_through x y z s : is_near x y -> Rabs (y - z) <= s -> Rabs (x - z) <= u * Rabs z + (1 + u) * s + h.
  Proof.
    intros near close; pose proof (through _ _ _ _ _ near close); pose proof (size_of_near _ _ _ close) as size.
    apply (Rmult_le_compat_l u) in size; auto; lra.
  Qed.

  (** The error of (x / p) y if the raised pivot q replaces p. *)
  Lemma product_error c s p q x y quotient product :
    1 <= c -> 0 <= s -> c * c * (u + s) <= 1 / 64 -> 8 * c * h <= u ->
    0 < p -> p <= q -> q - p <= s * q ->
    is_near quotient (x / q) -> is_near product (quotient * y) ->
    Rabs (x / p * y) <= c - 4 / 5 -> Rabs y <= c / 2 ->
    Rabs (product - x / p * y) <= c * (2 * u + s).
  Proof.
    intros large s_not_negative small tiny positive above raised near_quotient near_product bounded y_bounded.
    assert (Rabs (x / q - x / p) <= s * Rabs (x / p)) as moved.
    { replace (x / q - x / p) with (- ((q - p) / q) * (x / p)) by (field; lra).
      rewrite Rabs_mult, Rabs_Ropp; apply Rmult_le_compat_r; [apply Rabs_pos |].
      rewrite Rabs_pos_eq by (apply Rmult_le_pos; [lra | left; apply Rinv_0_lt_compat; lra]).
      apply (Rmult_le_reg_r q); [lra |]; replace ((q - p) / q * q) with (q - p) by (field; lra); auto. }
    pose proof (near_through _ _ _ _ near_quotient moved) as quotient_error.
    set (t := x / p) in *; clearbody t.
    assert (Rabs (quotient * y - t * y) <= (u + s + u * s) * Rabs (t * y) + h * Rabs y) as product_moved.
    { replace (quotient * y - t * y) with ((quotient - t) * y) by ring; rewrite !Rabs_mult.
      apply (Rmult_le_compat_r (Rabs y)) in quotient_error; [lra | apply Rabs_pos]. }
    eapply Rle_trans; [apply (near_through _ _ _ _ near_product product_moved) |].
    pose proof (Rabs_pos (t * y)) as z_not_negative; pose proof (Rabs_pos y) as w_not_negative.
    set (z := Rabs (t * y)) in *; set (w := Rabs y) in *; clearbody z w.
    clear - u_not_negative h_not_negative large s_not_negative small tiny bounded y_bounded z_not_negative
      w_not_negative.
    assert (c * (u + s) <= 1 / 64) by nra.
    assert (u + s <= 1 / 64) by nra.
    assert (h * w <= u / 16) by nra.
    assert (h <= u / 8) by nra.
    assert ((1 + u) * (h * w) <= u / 15) by nra.
    assert (z * (u * (u + s + u * s)) <= u / 32).
    { assert (u + s + u * s <= 2 * (u + s)) by nra.
      assert (z * (u + s + u * s) <= 1 / 32) by nra; nra. }
    assert (z * (u * s) <= u / 64) by (assert (z * s <= 1 / 64) by nra; nra).
    assert (z * (2 * u + s) <= (c - 4 / 5) * (2 * u + s)) by nra.
    nra.
  Qed.

  Lemma difference_error c x y computed_y difference s :
    1 <= c -> c * u <= 1 / 64 -> 8 * c * h <= u -> Rabs (x - y) <= c ->
    is_near difference (x - computed_y) -> Rabs (computed_y - y) <= s ->
    Rabs (difference - (x - y)) <= u * Rabs (x - y) + 65 / 64 * s + u / 8.
  Proof.
    intros large small tiny bounded near close.
    assert (Rabs ((x - computed_y) - (x - y)) <= s) as moved.
    { replace ((x - computed_y) - (x - y)) with (- (computed_y - y)) by ring; rewrite Rabs_Ropp; auto. }
    pose proof (near_through _ _ _ _ near moved) as error; pose proof (Rabs_pos (computed_y - y)).
    assert (u <= 1 / 64) by nra; assert (h <= u / 8) by nra; nra.
  Qed.

  Variables c s k00 k10 k20 k11 k21 k22 : R.
  Let exact_d1 := k11 - k10 / k00 * k10.
  Let exact_e21 := k21 - k20 / k00 * k10.
  Let exact_left := k22 - k20 / k00 * k20.
  Let exact_d2 := exact_left - exact_e21 / exact_d1 * exact_e21.

  (** The bounds of the entries that follow from I ⪯ K ⪯ c I. *)
  Record is_bounded : Prop := {
    k00_bounded : 1 <= k00;
    k10_bounded : Rabs k10 <= (c - 1) / 2;
    k20_bounded : Rabs k20 <= (c - 1) / 2;
    k21_bounded : Rabs k21 <= (c - 1) / 2;
    k11_bounded : k11 <= c;
    k22_bounded : k22 <= c;
    exact_d1_bounded : 1 <= exact_d1;
    exact_e21_bounded : Rabs exact_e21 <= (c - 1) / 2;
    exact_left_bounded : 1 <= exact_left;
    exact_d2_bounded : 1 <= exact_d2
  }.

  Variable pivot : R -> R.
  Hypotheses (bounded : is_bounded) (large : 1 <= c) (s_not_negative : 0 <= s) (small : c * c * (u + s) <= 1 / 64)
    (tiny : 8 * c * h <= u).
  Hypotheses (not_lowered : forall x, x <= pivot x)
    (raised : forall exact x, 1 <= exact -> Rabs (pivot x - exact) <= Rabs (x - exact) + s).

  Variables l10 l20 taken_11 left_11 taken_21 e21 l21 taken_22 left_22 taken_again_22 left_again_22 : R.
  Let d0 := pivot k00.
  Let d1 := pivot left_11.
  Let d2 := pivot left_again_22.
  Hypotheses
    (near_l10 : is_near l10 (k10 / d0))
    (near_l20 : is_near l20 (k20 / d0))
    (near_taken_11 : is_near taken_11 (l10 * k10))
    (near_left_11 : is_near left_11 (k11 - taken_11))
    (near_taken_21 : is_near taken_21 (l20 * k10))
    (near_e21 : is_near e21 (k21 - taken_21))
    (near_l21 : is_near l21 (e21 / d1))
    (near_taken_22 : is_near taken_22 (l20 * k20))
    (near_left_22 : is_near left_22 (k22 - taken_22))
    (near_taken_again_22 : is_near taken_again_22 (l21 * e21))
    (near_left_again_22 : is_near left_again_22 (left_22 - taken_again_22)).

  Lemma small_products : c * (u + s) <= 1 / 64 /\ c * u <= 1 / 64 /\ u + s <= 1 / 64 /\ h <= u / 8 /\ 0 <= c * u.
  Proof.
    assert (c * (u + s) <= 1 / 64) by nra; assert (0 <= c * s) by nra; assert (0 <= c * u) by nra.
    repeat split; nra.
  Qed.

  Lemma first_error : k00 <= d0 /\ d0 - k00 <= s * d0 /\ Rabs (d0 - k00) <= s.
  Proof.
    pose proof (k00_bounded bounded) as least; pose proof (not_lowered k00) as above.
    pose proof (raised k00 k00 least) as close; fold d0 in above, close.
    rewrite Rminus_eq_0, Rabs_R0, Rplus_0_l in close; repeat split; auto.
    rewrite Rabs_pos_eq in close by lra; nra.
  Qed.

  Lemma exact_products :
    0 <= k10 / k00 * k10 <= c - 1 /\ Rabs (k20 / k00 * k10) <= c - 1 /\ 0 <= k20 / k00 * k20 <= c - 1 /\
    0 <= exact_e21 / exact_d1 * exact_e21 <= c - 1.
  Proof.
    destruct bounded as [k00_large _ _ k21_small k11_small k22_small d1_large e21_small left_large d2_large].
    repeat split; try (apply square_over_nonnegative; lra).
    - unfold exact_d1 in d1_large; lra.
    - replace (k20 / k00 * k10) with (k21 + - exact_e21) by (unfold exact_e21; ring).
      eapply Rle_trans; [apply Rabs_triang |]; rewrite Rabs_Ropp; lra.
    - unfold exact_left in left_large; lra.
    - pose proof (square_over_nonnegative k20 k00 ltac:(lra)); unfold exact_d2, exact_left in *; lra.
  Qed.

  Lemma products_error :
    Rabs (taken_11 - k10 / k00 * k10) <= c * (2 * u + s) /\ Rabs (taken_21 - k20 / k00 * k10) <= c * (2 * u + s) /\
    Rabs (taken_22 - k20 / k00 * k20) <= c * (2 * u + s).
  Proof.
    destruct exact_products as (square_10 & mixed & square_20 & _); destruct first_error as (above & clamped & _).
    pose proof (k10_bounded bounded); pose proof (k20_bounded bounded); pose proof (k00_bounded bounded).
    repeat split;
      [apply product_error with (q := d0) (quotient := l10) | apply product_error with (q := d0) (quotient := l20)
      | apply product_error with (q := d0) (quotient := l20)]; auto; try lra; rewrite Rabs_pos_eq; lra.
  Qed.

  Lemma second_errors :
    Rabs (left_11 - exact_d1) <= 4 * c * (u + s) - s /\ Rabs (e21 - exact_e21) <= 3 * c * (u + s) /\
    Rabs (left_22 - exact_left) <= 4 * c * (u + s).
  Proof.
    destruct exact_products as (square_10 & mixed & square_20 & _).
    destruct products_error as (error_11 & error_21 & error_22).
    destruct small_products as (_ & small_u & _ & _ & _).
    pose proof (exact_d1_bounded bounded) as d1_large; pose proof (exact_left_bounded bounded) as left_large.
    pose proof (exact_e21_bounded bounded) as e21_small.
    pose proof (k11_bounded bounded); pose proof (k22_bounded bounded).
    assert (Rabs exact_d1 <= c) as d1_size by (rewrite Rabs_pos_eq; unfold exact_d1 in *; lra).
    assert (Rabs exact_left <= c) as left_size by (rewrite Rabs_pos_eq; unfold exact_left in *; lra).
    assert (Rabs exact_e21 <= c) as e21_size by lra.
    pose proof (difference_error c _ _ _ _ _ large small_u tiny d1_size near_left_11 error_11) as first.
    pose proof (difference_error c _ _ _ _ _ large small_u tiny e21_size near_e21 error_21) as second.
    pose proof (difference_error c _ _ _ _ _ large small_u tiny left_size near_left_22 error_22) as third.
    fold exact_d1 in first; fold exact_e21 in second; fold exact_left in third.
    apply (Rmult_le_compat_l u) in d1_size, left_size, e21_small; auto.
    assert (u <= c * u) by nra; assert (s <= c * s) by nra.
    repeat split; lra.
  Qed.

  Lemma d1_error : Rabs (d1 - exact_d1) <= 4 * c * (u + s).
  Proof.
    destruct second_errors as (error & _); pose proof (raised exact_d1 left_11 (exact_d1_bounded bounded)) as close.
    fold d1 in close; lra.
  Qed.

  Lemma square_error :
    15 / 16 <= d1 /\
    Rabs (e21 / d1 * e21 - exact_e21 / exact_d1 * exact_e21) <= 15 / 2 * (c * c * (u + s)).
  Proof.
    destruct second_errors as (_ & error & _); destruct exact_products as (_ & _ & _ & square).
    destruct small_products as (small_all & _).
    pose proof (exact_d1_bounded bounded); pose proof (exact_e21_bounded bounded); pose proof d1_error.
    apply square_over_error; auto; lra.
  Qed.

  Lemma e21_size : Rabs e21 <= c / 2.
  Proof.
    destruct second_errors as (_ & error & _); destruct small_products as (small_all & _).
    pose proof (size_of_near _ _ _ error); pose proof (exact_e21_bounded bounded); lra.
  Qed.

  Lemma taken_again_error : Rabs (taken_again_22 - exact_e21 / exact_d1 * exact_e21) <=
    15 / 2 * (c * c * (u + s)) + 2 * (c * u).
  Proof.
    destruct square_error as (d1_large & error); destruct exact_products as (_ & _ & _ & square).
    replace (15 / 2 * (c * c * (u + s)) + 2 * (c * u)) with (c * (2 * u + 0) + 15 / 2 * (c * c * (u + s))) by ring.
    eapply through; [| eassumption].
    apply product_error with (q := d1) (quotient := l21); auto; try lra.
    - assert (0 <= c * c * s) by (apply Rmult_le_pos; nra); lra.
    - pose proof (size_of_near _ _ _ error) as size; rewrite (Rabs_pos_eq (exact_e21 / _ * _)) in size by lra; lra.
    - apply e21_size.
  Qed.

  Lemma left_again_error : Rabs (left_again_22 - exact_d2) <= 8 * c * (c + 1) * (u + s) - s.
  Proof.
    destruct second_errors as (_ & _ & left_error); pose proof taken_again_error as taken_error.
    destruct exact_products as (_ & _ & _ & square); destruct exact_products as (_ & _ & square_20 & _).
    destruct small_products as (small_all & small_u & small_sum & h_small & cu_not_negative).
    pose proof (exact_d2_bounded bounded) as d2_large; pose proof (k22_bounded bounded) as k22_small.
    assert (Rabs ((left_22 - taken_again_22) - exact_d2) <=
      4 * c * (u + s) + (15 / 2 * (c * c * (u + s)) + 2 * (c * u))) as close.
    { unfold exact_d2; replace (_ - _ - _) with
        ((left_22 - exact_left) + - (taken_again_22 - exact_e21 / exact_d1 * exact_e21)) by ring.
      eapply Rle_trans; [apply Rabs_triang |]; rewrite Rabs_Ropp; lra. }
    pose proof (near_through _ _ _ _ near_left_again_22 close) as error.
    assert (Rabs exact_d2 <= c) as d2_size by (rewrite Rabs_pos_eq by lra; unfold exact_d2, exact_left; lra).
    apply (Rmult_le_compat_l u) in d2_size; auto.
    assert (u <= c * u) by nra; assert (s <= c * s) by nra.
    assert (u * (4 * c * (u + s) + (15 / 2 * (c * c * (u + s)) + 2 * (c * u))) <= 1 / 4 * (c * u)).
    { assert (4 * c * (u + s) + (15 / 2 * (c * c * (u + s)) + 2 * (c * u)) <= 1 / 4) by lra; nra. }
    assert (0 <= c * c * (u + s)) by (apply Rmult_le_pos; nra).
    lra.
  Qed.

  Lemma d2_error : Rabs (d2 - exact_d2) <= 8 * c * (c + 1) * (u + s).
  Proof.
    pose proof left_again_error as error.
    pose proof (raised exact_d2 left_again_22 (exact_d2_bounded bounded)) as close; fold d2 in close; lra.
  Qed.

  Lemma quotient_size x p quotient :
    is_near quotient (x / p) -> 15 / 16 <= p -> Rabs x <= c / 2 -> Rabs quotient <= c.
  Proof.
    intros near p_large x_small; destruct small_products as (_ & small_u & small_sum & h_small & cu_not_negative).
    pose proof (size_of_near _ _ _ near) as size.
    assert (Rabs (x / p) <= 8 / 15 * c).
    { unfold Rdiv; rewrite Rabs_mult; assert (0 < / p <= 16 / 15) as inverse.
      { split; [apply Rinv_0_lt_compat; lra |].
        replace (16 / 15) with (/ (15 / 16)) by field; apply Rinv_le_contravar; lra. }
      rewrite (Rabs_pos_eq (/ p)) by lra; pose proof (Rabs_pos x).
      apply (Rle_trans _ (c / 2 * (16 / 15))); [apply Rmult_le_compat; lra | lra]. }
    assert (u * Rabs (x / p) <= 1 / 64 * (8 / 15 * c)) by (apply Rmult_le_compat; auto using Rabs_pos; lra).
    lra.
  Qed.

  Lemma quotient_sizes : Forall (fun x => Rabs x <= c) [l10; l20; l21].
  Proof.
    destruct first_error as (above & _); destruct square_error as (d1_large & _); pose proof e21_size.
    pose proof (k00_bounded bounded); pose proof (k10_bounded bounded); pose proof (k20_bounded bounded).
    repeat apply Forall_cons; try apply Forall_nil;
      [apply (quotient_size k10 d0) | apply (quotient_size k20 d0) | apply (quotient_size e21 d1)]; auto; lra.
  Qed.

  Lemma other_sizes :
    Forall (fun x => Rabs x <= 2 * c)
      [taken_11; left_11; taken_21; e21; taken_22; left_22; taken_again_22; left_again_22].
  Proof.
    destruct exact_products as (square_10 & mixed & square_20 & square).
    destruct products_error as (error_11 & error_21 & error_22); destruct second_errors as (left_1 & _ & left_2).
    pose proof taken_again_error as again; pose proof left_again_error as last; pose proof e21_size.
    destruct small_products as (small_all & small_u & small_sum & h_small & cu_not_negative).
    assert (0 <= c * s) by (apply Rmult_le_pos; lra); assert (c <= c * c) by nra.
    assert (c * (u + s) <= c * c * (u + s)) by (apply Rmult_le_compat_r; lra).
    pose proof (exact_d1_bounded bounded) as d1_large; pose proof (exact_left_bounded bounded) as left_large.
    pose proof (exact_d2_bounded bounded) as d2_large.
    assert (exact_d1 <= c) by (pose proof (k11_bounded bounded); unfold exact_d1; lra).
    assert (exact_left <= c) by (pose proof (k22_bounded bounded); unfold exact_left; lra).
    assert (exact_d2 <= c) by (unfold exact_d2; lra).
    apply size_of_near in error_11, error_21, error_22, left_1, left_2, again, last.
    rewrite (Rabs_pos_eq (k10 / _ * _)) in error_11 by lra; rewrite (Rabs_pos_eq (k20 / _ * _)) in error_22 by lra.
    rewrite (Rabs_pos_eq exact_d1) in left_1 by lra; rewrite (Rabs_pos_eq exact_left) in left_2 by lra.
    rewrite (Rabs_pos_eq (exact_e21 / _ * _)) in again by lra; rewrite (Rabs_pos_eq exact_d2) in last by lra.
    repeat apply Forall_cons; try apply Forall_nil; lra.
  Qed.

  Lemma scaled_elimination :
    (Rabs (d0 - k00) <= s /\ Rabs (d1 - exact_d1) <= 4 * c * (u + s) /\
     Rabs (d2 - exact_d2) <= 8 * c * (c + 1) * (u + s)) /\
    Forall (fun x => Rabs x <= c) [l10; l20; l21] /\
    Forall (fun x => Rabs x <= 2 * c)
      [taken_11; left_11; taken_21; e21; taken_22; left_22; taken_again_22; left_again_22].
  Proof.
    repeat split; [apply first_error | apply d1_error | apply d2_error | apply quotient_sizes | apply other_sizes].
  Qed.
End Scaled.

Lemma first_pivot_at_most (t : R) (m : matrix R) : at_most t m -> first_pivot m <= t.
Proof.
  intros above; pose proof (above (vec 1 0 0)); clear above; unfold first_pivot; taken_apart; in_components; lra.
Qed.

(** The bounds of the entries and of the Schur complements that follow from I ⪯ K ⪯ c I. *)
Lemma bounded_entries (c : R) (m : matrix R) :
  symmetric m -> at_least 1 m -> at_most c m ->
  is_bounded c (x_of (row_x m)) (x_of (row_y m)) (x_of (row_z m)) (y_of (row_y m)) (y_of (row_z m)) (z_of (row_z m)).
Proof.
  intros is_symmetric below above.
  pose proof (first_pivot_bounded 1 m below) as first.
  pose proof (second_pivot_bounded 1 m Rlt_0_1 is_symmetric below) as second.
  pose proof (second_minor_positive 1 m Rlt_0_1 is_symmetric below) as minor.
  pose proof (third_pivot_bounded 1 m Rlt_0_1 is_symmetric below) as third.
  apply entries_symmetric in is_symmetric as (xy & xz & yz).
  unfold third_pivot, second_pivot, second_minor, first_pivot in *.
  destruct m as [[k00 k01 k02] [k10 k11 k12] [k20 k21 k22]]; cbn [x_of y_of z_of row_x row_y row_z] in *; subst.
  assert (forall y z, y * y + z * z <=
    (k11 - k10 / k00 * k10) * y * y + 2 * (k21 - k20 / k00 * k10) * y * z + (k22 - k20 / k00 * k20) * z * z) as schur.
  { intros y z; pose proof (below (vec (- (k10 * y + k20 * z) / k00) y z)) as form; in_components.
    replace (_ + 2 * _ * y * z + _) with
      (- (k10 * y + k20 * z) / k00 * (k00 * (- (k10 * y + k20 * z) / k00) + k10 * y + k20 * z) +
       y * (k10 * (- (k10 * y + k20 * z) / k00) + k11 * y + k21 * z) +
       z * (k20 * (- (k10 * y + k20 * z) / k00) + k21 * y + k22 * z)) by (field; lra).
    pose proof (Rle_0_sqr (- (k10 * y + k20 * z) / k00)) as square; unfold Rsqr in square; lra. }
  assert (forall y z, 0 <= k10 / k00 * k10 * y * y + 2 * (k20 / k00 * k10) * y * z + k20 / k00 * k20 * z * z) as taken.
  { intros y z; replace (_ + _ + _) with ((k10 * y + k20 * z) / k00 * (k10 * y + k20 * z)) by (field; lra).
    apply square_over_nonnegative; lra. }
  pose proof (schur 1 1); pose proof (schur 1 (-1)); pose proof (schur 0 1); pose proof (schur 1 0).
  pose proof (taken 1 1); pose proof (taken 1 (-1)); clear schur taken.
  pose proof (below (vec 1 1 0)); pose proof (below (vec 1 (-1) 0)); pose proof (below (vec 1 0 1)).
  pose proof (below (vec 1 0 (-1))); pose proof (below (vec 0 1 1)); pose proof (below (vec 0 1 (-1))).
  pose proof (above (vec 1 1 0)); pose proof (above (vec 1 (-1) 0)); pose proof (above (vec 1 0 1)).
  pose proof (above (vec 1 0 (-1))); pose proof (above (vec 0 1 1)); pose proof (above (vec 0 1 (-1))).
  pose proof (above (vec 0 1 0)); pose proof (above (vec 0 0 1)); clear below above.
  in_components; split; try (apply Rabs_le); try lra.
  replace (k22 - k20 / k00 * k20 - _) with
    ((k00 * (k11 * k22 - k21 * k21) + k10 * (k21 * k20 - k10 * k22) + k20 * (k10 * k21 - k11 * k20)) /
     (k00 * k11 - k10 * k10)) by (field; split; lra); lra.
Qed.

Definition scaled_matrix (t : R) (m : matrix R) := rows (scaled t (row_x m)) (scaled t (row_y m)) (scaled t (row_z m)).

Lemma applied_scaled_matrix (t : R) (m : matrix R) (v : vector R) :
  applied (scaled_matrix t m) v = scaled t (applied m v).
Proof. unfold scaled_matrix; by_ring. Qed.

Lemma scaled_bounds (lambda c : R) (m : matrix R) :
  0 < lambda -> symmetric m -> at_least lambda m -> at_most (c * lambda) m ->
  symmetric (scaled_matrix (/ lambda) m) /\ at_least 1 (scaled_matrix (/ lambda) m) /\
  at_most c (scaled_matrix (/ lambda) m).
Proof.
  intros positive is_symmetric below above; assert (0 < / lambda) as inverse by (apply Rinv_0_lt_compat; auto).
  repeat split; [intros v w | intros v | intros v]; rewrite !applied_scaled_matrix, !dot_scaled.
  - rewrite is_symmetric; reflexivity.
  - apply (Rmult_le_reg_l lambda); auto; rewrite <- (Rmult_assoc _ (/ lambda)), Rinv_r by lra.
    pose proof (below v); lra.
  - apply (Rmult_le_reg_l lambda); auto; rewrite <- (Rmult_assoc _ (/ lambda)), Rinv_r by lra.
    pose proof (above v); lra.
Qed.

(** The entries of K off its diagonal. They are at most 15/2 λ if c = 16. *)
Theorem off_diagonal_bounded (lambda c : R) (m : matrix R) :
  symmetric m -> at_least lambda m -> at_most (c * lambda) m ->
  Rabs (x_of (row_y m)) <= (c - 1) / 2 * lambda /\ Rabs (x_of (row_z m)) <= (c - 1) / 2 * lambda /\
  Rabs (y_of (row_z m)) <= (c - 1) / 2 * lambda.
Proof.
  intros is_symmetric below above; apply entries_symmetric in is_symmetric as (xy & xz & yz).
  pose proof (below (vec 1 1 0)); pose proof (below (vec 1 (-1) 0)); pose proof (below (vec 1 0 1)).
  pose proof (below (vec 1 0 (-1))); pose proof (below (vec 0 1 1)); pose proof (below (vec 0 1 (-1))).
  pose proof (above (vec 1 1 0)); pose proof (above (vec 1 (-1) 0)); pose proof (above (vec 1 0 1)).
  pose proof (above (vec 1 0 (-1))); pose proof (above (vec 0 1 1)); pose proof (above (vec 0 1 (-1))).
  clear below above; taken_apart; in_components; repeat split; apply Rabs_le; lra.
Qed.

(** A computed elimination of m with λ I ⪯ m ⪯ c λ I is sound. The pivots are those of m up to a small part of λ, so no
    divisor is nearly zero. No result is large, so none overflows. *)
Record is_sound (rounded pivot : R -> R) (lambda c error : R) (m : matrix R) : Prop := {
  first_is_close : Rabs (d0 pivot m - first_pivot m) <= error * lambda;
  second_is_close : Rabs (d1 (of_T := rounded_operations rounded) pivot m - second_pivot m) <= error * lambda;
  third_is_close : Rabs (d2 (of_T := rounded_operations rounded) pivot m - third_pivot m) <= error * lambda;
  pivots_bounded :
    Forall (fun d => (1 - error) * lambda <= d <= (c + error) * lambda)
      (pivots (of_T := rounded_operations rounded) pivot m);
  quotients_bounded : Forall (fun x => Rabs x <= c) (quotients (of_T := rounded_operations rounded) pivot m);
  other_results_bounded :
    Forall (fun x => Rabs x <= 2 * c * lambda) (other_results (of_T := rounded_operations rounded) pivot m)
}.

(** The condition on `pivot`, which may raise a computed number x but never lowers it. If the exact number is at least
    λ, the error of pivot x is at most that of x plus sλ. *)
Definition is_pivoting (lambda s : R) (pivot : R -> R) :=
  (forall x, x <= pivot x) /\
  (forall exact x, lambda <= exact -> Rabs (pivot x - exact) <= Rabs (x - exact) + s * lambda).

(** The pivot of Ldlt::solve without a least eigenvalue. *)
Definition kept (x : R) := x.

(** The pivot of Ldlt::solve with a least eigenvalue: at_least of select.hpp. *)
Definition raised_to (least x : R) := if less x least then least else x.

Lemma kept_is_pivoting (lambda : R) : is_pivoting lambda 0 kept.
Proof. split; unfold kept; intros; lra. Qed.

Lemma raised_to_is_pivoting (lambda s least : R) :
  0 <= s * lambda -> least <= (1 + s) * lambda -> is_pivoting lambda s (raised_to least).
Proof.
  intros not_negative bounded; split; intros; unfold raised_to; destruct (less x least) eqn:below;
    try (apply less_true in below); try lra.
  pose proof (Rle_abs (- (x - exact))) as size; rewrite Rabs_Ropp in size.
  pose proof (Rabs_pos (x - exact)); apply Rabs_le; lra.
Qed.

Section Matrix.
  Variables (u tiny lambda c s : R) (rounded pivot : R -> R) (m : matrix R).
  Hypotheses (u_not_negative : 0 <= u) (is_rounding : rounds_within u tiny rounded)
    (tiny_quotients : 8 * c * tiny <= u) (tiny_results : 8 * c * tiny <= u * lambda).
  Hypotheses (positive : 0 < lambda) (large : 1 <= c) (is_symmetric : symmetric m) (below : at_least lambda m)
    (above : at_most (c * lambda) m).
  Hypotheses (s_not_negative : 0 <= s) (is_pivot : is_pivoting lambda s pivot)
    (small : c * c * (u + s) <= 1 / 64).

  Let h := u / (8 * c).
  Let scaled_pivot x := pivot (lambda * x) / lambda.

  #[local] Instance computing : operations R := rounded_operations rounded.

  Lemma h_bounds : 0 <= h /\ 8 * c * h <= u /\ tiny <= h /\ tiny <= h * lambda.
  Proof.
    assert (0 < / (8 * c)) by (apply Rinv_0_lt_compat; lra).
    unfold h; repeat split.
    - unfold Rdiv; nra.
    - right; field; lra.
    - apply (Rmult_le_reg_l (8 * c)); [lra |]; replace (8 * c * (u / (8 * c))) with u by (field; lra); auto.
    - apply (Rmult_le_reg_l (8 * c)); [lra |].
      replace (8 * c * (u / (8 * c) * lambda)) with (u * lambda) by (field; lra); auto.
  Qed.

  Lemma quotient_near (x y : R) : x = y -> is_near u h (rounded x) y.
  Proof. intros <-; destruct h_bounds as (_ & _ & bound & _); pose proof (is_rounding x); unfold is_near; lra. Qed.

  Lemma result_near (x y : R) : x / lambda = y -> is_near u h (rounded x / lambda) y.
  Proof.
    intros <-; destruct h_bounds as (_ & _ & _ & bound); pose proof (is_rounding x) as error; unfold is_near.
    assert (0 < / lambda) as inverse by (apply Rinv_0_lt_compat; auto).
    replace (rounded x / lambda - x / lambda) with ((rounded x - x) * / lambda) by (field; lra).
    unfold Rdiv; rewrite !Rabs_mult, (Rabs_pos_eq (/ lambda)) by lra.
    apply (Rmult_le_reg_r lambda); auto.
    replace (Rabs (rounded x - x) * / lambda * lambda) with (Rabs (rounded x - x)) by (field; lra).
    replace ((u * (Rabs x * / lambda) + h) * lambda) with (u * Rabs x + h * lambda) by (field; lra); lra.
  Qed.

  Lemma scaled_pivot_above (x : R) : x <= scaled_pivot x.
  Proof.
    destruct is_pivot as (not_lowered & _); unfold scaled_pivot.
    apply (Rmult_le_reg_l lambda); auto; replace (lambda * (pivot (lambda * x) / lambda)) with (pivot (lambda * x))
      by (field; lra); auto.
  Qed.

  Lemma scaled_back (x y : R) : Rabs (x / lambda - y / lambda) * lambda = Rabs (x - y).
  Proof.
    rewrite <- (Rabs_pos_eq lambda) at 3 by lra; rewrite <- Rabs_mult; f_equal; field; lra.
  Qed.

  Lemma scaled_pivot_close (exact x : R) :
    1 <= exact -> Rabs (scaled_pivot x - exact) <= Rabs (x - exact) + s.
  Proof.
    intros large_exact; destruct is_pivot as (_ & raised); unfold scaled_pivot.
    pose proof (raised (lambda * exact) (lambda * x) ltac:(nra)) as bound.
    rewrite <- (scaled_back (pivot _)), <- (scaled_back (lambda * x)) in bound.
    replace (lambda * exact / lambda) with exact in bound by (field; lra).
    replace (lambda * x / lambda) with x in bound by (field; lra).
    apply (Rmult_le_reg_r lambda); auto; lra.
  Qed.

  Lemma same_quotient (x y : R) : x / lambda / (y / lambda) = x / y.
  Proof.
    unfold Rdiv; rewrite Rinv_mult, Rinv_inv.
    replace (x * / lambda * (/ y * lambda)) with (x * / y * (/ lambda * lambda)) by ring.
    rewrite Rinv_l by lra; ring.
  Qed.

  Let k00 := x_of (row_x m).
  Let k10 := x_of (row_y m).
  Let k20 := x_of (row_z m).
  Let k11 := y_of (row_y m).
  Let k21 := y_of (row_z m).
  Let k22 := z_of (row_z m).

  Lemma scaled_pivot_of (x : R) : scaled_pivot (x / lambda) = pivot x / lambda.
  Proof. unfold scaled_pivot; replace (lambda * (x / lambda)) with x by (field; lra); reflexivity. Qed.

  Lemma scaled_entries :
    is_bounded c (k00 / lambda) (k10 / lambda) (k20 / lambda) (k11 / lambda) (k21 / lambda) (k22 / lambda).
  Proof.
    destruct (scaled_bounds lambda c m positive is_symmetric below above) as (symmetric_1 & below_1 & above_1).
    pose proof (bounded_entries c _ symmetric_1 below_1 above_1) as bounded.
    unfold scaled_matrix, scaled in bounded; cbn [row_x row_y row_z x_of y_of z_of] in bounded; reals.
    unfold k00, k10, k20, k11, k21, k22, Rdiv; rewrite !(Rmult_comm _ (/ lambda)); exact bounded.
  Qed.

  Ltac each_near :=
    first [apply quotient_near | apply result_near];
    rewrite ?scaled_pivot_of, ?same_quotient; try reflexivity; unfold k10, k20, k11, k21, k22, Rdiv; ring.

  Lemma exact_pivots :
    k11 / lambda - k10 / lambda / (k00 / lambda) * (k10 / lambda) = second_pivot m / lambda /\
    k22 / lambda - k20 / lambda / (k00 / lambda) * (k20 / lambda) -
      (k21 / lambda - k20 / lambda / (k00 / lambda) * (k10 / lambda)) /
        (k11 / lambda - k10 / lambda / (k00 / lambda) * (k10 / lambda)) *
        (k21 / lambda - k20 / lambda / (k00 / lambda) * (k10 / lambda)) = third_pivot m / lambda.
  Proof.
    pose proof (first_pivot_bounded lambda m below) as first.
    pose proof (second_minor_positive lambda m positive is_symmetric below) as minor.
    pose proof (entries_symmetric m is_symmetric) as (xy & xz & yz).
    unfold third_pivot, second_pivot, second_minor, first_pivot, k00, k10, k20, k11, k21, k22 in *.
    clear - positive first minor xy xz yz.
    destruct m as [[a01 a02 a03] [a10 a11 a12] [a20 a21 a22]]; cbn [x_of y_of z_of row_x row_y row_z] in *; subst.
    in_components; split; field; repeat split; nra.
  Qed.

  Lemma all_errors :
    (Rabs (d0 pivot m - first_pivot m) <= s * lambda /\
     Rabs (d1 pivot m - second_pivot m) <= 4 * c * (u + s) * lambda /\
     Rabs (d2 pivot m - third_pivot m) <= 8 * c * (c + 1) * (u + s) * lambda) /\
    Forall (fun x => Rabs x <= c) (quotients pivot m) /\
    Forall (fun x => Rabs x <= 2 * c * lambda) (other_results pivot m).
  Proof.
    destruct h_bounds as (h_not_negative & h_small & _ & _).
    destruct (scaled_elimination u h u_not_negative h_not_negative c s _ _ _ _ _ _ scaled_pivot scaled_entries large
      s_not_negative small h_small scaled_pivot_above scaled_pivot_close (l10 pivot m) (l20 pivot m)
      (taken_11 pivot m / lambda) (left_11 pivot m / lambda) (taken_21 pivot m / lambda) (e21 pivot m / lambda)
      (l21 pivot m) (taken_22 pivot m / lambda) (left_22 pivot m / lambda) (taken_again_22 pivot m / lambda)
      (left_again_22 pivot m / lambda)) as ((first & second & third) & of_quotients & of_others);
      [each_near .. |].
    destruct exact_pivots as (exact_1 & exact_2).
    rewrite exact_1, scaled_pivot_of in second; rewrite exact_2, scaled_pivot_of in third.
    rewrite scaled_pivot_of in first.
    apply (Rmult_le_compat_r lambda _ _ (Rlt_le _ _ positive)) in first, second, third.
    rewrite scaled_back in first, second, third.
    repeat split; auto.
    unfold other_results; revert of_others; generalize (taken_11 pivot m) (left_11 pivot m) (taken_21 pivot m)
      (e21 pivot m) (taken_22 pivot m) (left_22 pivot m) (taken_again_22 pivot m) (left_again_22 pivot m).
    clear - positive; intros.
    apply (Forall_map (fun x => x / lambda) (fun x => Rabs x <= 2 * c) [_; _; _; _; _; _; _; _]) in of_others.
    revert of_others; apply Forall_impl; intros x bound.
    replace x with (x / lambda * lambda) by (field; lra); rewrite Rabs_mult, (Rabs_pos_eq lambda) by lra.
    apply Rmult_le_compat_r; lra.
  Qed.

  Lemma exact_pivots_bounded :
    lambda <= first_pivot m <= c * lambda /\ lambda <= second_pivot m <= c * lambda /\
    lambda <= third_pivot m <= c * lambda.
  Proof.
    pose proof (first_pivot_bounded lambda m below);
      pose proof (second_pivot_bounded lambda m positive is_symmetric below);
      pose proof (third_pivot_bounded lambda m positive is_symmetric below).
    pose proof scaled_entries as entries.
    destruct (exact_products c _ _ _ _ _ _ entries) as (square_10 & _ & square_20 & square).
    destruct exact_pivots as (exact_1 & exact_2).
    pose proof (k11_bounded _ _ _ _ _ _ _ entries); pose proof (k22_bounded _ _ _ _ _ _ _ entries).
    assert (second_pivot m / lambda <= c) as second by (rewrite <- exact_1; lra).
    assert (third_pivot m / lambda <= c) as third by (rewrite <- exact_2; lra).
    pose proof (first_pivot_at_most _ m above) as first.
    apply (Rmult_le_compat_r lambda _ _ (Rlt_le _ _ positive)) in second, third.
    replace (second_pivot m / lambda * lambda) with (second_pivot m) in second by (field; lra).
    replace (third_pivot m / lambda * lambda) with (third_pivot m) in third by (field; lra).
    repeat split; auto.
  Qed.

  (** The error is at most 8 c (c + 1) (u + s) λ if c² (u + s) ≤ 1/64. *)
  Theorem elimination_is_sound : is_sound rounded pivot lambda c (8 * c * (c + 1) * (u + s)) m.
  Proof.
    destruct all_errors as ((first & second & third) & of_quotients & of_others).
    destruct exact_pivots_bounded as (first_bounded & second_bounded & third_bounded).
    assert (0 <= (u + s) * lambda) as unit by (apply Rmult_le_pos; lra).
    assert (s * lambda <= (u + s) * lambda) by (apply Rmult_le_compat_r; lra).
    assert ((u + s) * lambda <= 4 * c * ((u + s) * lambda)) by nra.
    assert (4 * c * ((u + s) * lambda) <= 8 * c * (c + 1) * ((u + s) * lambda)) by (apply Rmult_le_compat_r; nra).
    set (error := 8 * c * (c + 1) * (u + s)).
    assert (forall d p, Rabs (d - p) <= error * lambda -> lambda <= p <= c * lambda ->
      (1 - error) * lambda <= d <= (c + error) * lambda) as between.
    { intros d p close; apply Rabs_le_inv in close; lra. }
    assert (Rabs (d0 pivot m - first_pivot m) <= error * lambda) by (unfold error; lra).
    assert (Rabs (d1 pivot m - second_pivot m) <= error * lambda) by (unfold error; lra).
    split; auto; repeat apply Forall_cons; try apply Forall_nil; eauto.
  Qed.

  (** Hence the computed pivots are never below 3/4 λ. *)
  Corollary pivots_at_least : Forall (fun d => 3 / 4 * lambda <= d) (pivots pivot m).
  Proof.
    refine (Forall_impl _ _ (pivots_bounded _ _ _ _ _ _ elimination_is_sound)); intros d (least & _).
    eapply Rle_trans; [apply Rmult_le_compat_r | exact least]; [lra |].
    assert ((u + s) * (c * (c + 1)) <= (u + s) * (2 * (c * c))) by (apply Rmult_le_compat_l; nra); lra.
  Qed.
End Matrix.

Lemma results_finite (rounded pivot : R -> R) (lambda c error largest : R) (m : matrix R) :
  is_sound rounded pivot lambda c error m -> c <= largest -> 2 * c * lambda <= largest ->
  Forall (fun x => Rabs x <= largest)
    (quotients (of_T := rounded_operations rounded) pivot m ++
     other_results (of_T := rounded_operations rounded) pivot m).
Proof.
  intros [_ _ _ _ of_quotients of_others] first second; apply Forall_app; split;
    [refine (Forall_impl _ _ of_quotients) | refine (Forall_impl _ _ of_others)]; intros; cbv beta in *; lra.
Qed.

(** The conditions on the range of a format, for λ and for the quotients. *)
Lemma small_enough (u tiny at_1 : Z) (lambda : R) :
  (tiny + 7 <= u)%Z -> (tiny + 7 <= u + at_1)%Z -> power at_1 <= lambda ->
  8 * 16 * power tiny <= power u /\ 8 * 16 * power tiny <= power u * lambda.
Proof.
  intros quotients_in_range results_in_range range.
  assert (power 7 = 128) as seven by (unfold power; simpl; lra).
  replace (8 * 16 * power tiny) with (power (tiny + 7)) by (rewrite power_sum, seven; ring).
  split; [apply bpow_le; auto |].
  apply Rle_trans with (power u * power at_1); [rewrite <- power_sum; apply bpow_le; auto |].
  apply Rmult_le_compat_l; auto; left; apply power_positive.
Qed.

Lemma small_condition (u : Z) : (u <= -24)%Z -> 16 * 16 * (power u + 0) <= 1 / 64.
Proof.
  intros digits; assert (power u <= / 16777216); [| lra].
  apply Rle_trans with (power (-24)); [apply bpow_le; auto | unfold power; simpl; lra].
Qed.

Theorem binary32_elimination (lambda : R) (pivot : R -> R) (m : matrix R) :
  power (-119) <= lambda -> symmetric m -> at_least lambda m -> at_most (16 * lambda) m ->
  is_pivoting lambda 0 pivot -> is_sound binary32 pivot lambda 16 (2176 * power (-24)) m.
Proof.
  intros range is_symmetric below above is_pivot; pose proof (power_positive (-119)).
  destruct (small_enough (-24) (-150) (-119) lambda) as (quotients_in_range & results_in_range); try lia; auto.
  replace (2176 * power (-24)) with (8 * 16 * (16 + 1) * (power (-24) + 0)) by ring.
  apply (elimination_is_sound _ (power (-150))); auto; try lra;
    [left; apply power_positive | apply binary32_rounds_within | apply small_condition; lia].
Qed.

Theorem binary64_elimination (lambda : R) (pivot : R -> R) (m : matrix R) :
  power (-1015) <= lambda -> symmetric m -> at_least lambda m -> at_most (16 * lambda) m ->
  is_pivoting lambda 0 pivot -> is_sound binary64 pivot lambda 16 (2176 * power (-53)) m.
Proof.
  intros range is_symmetric below above is_pivot; pose proof (power_positive (-1015)).
  destruct (small_enough (-53) (-1075) (-1015) lambda) as (quotients_in_range & results_in_range); try lia; auto.
  replace (2176 * power (-53)) with (8 * 16 * (16 + 1) * (power (-53) + 0)) by ring.
  apply (elimination_is_sound _ (power (-1075))); auto; try lra;
    [left; apply power_positive | apply binary64_rounds_within | apply small_condition; lia].
Qed.

(** Simpler bounds for c = 16: 8 c (c + 1) u = 2176 u is less than 2^-12 in binary32, and less than 2^-41 in
    binary64. *)
Lemma pivots_between (rounded pivot : R -> R) (lambda c error bound : R) (m : matrix R) :
  0 <= lambda -> error <= bound -> is_sound rounded pivot lambda c error m ->
  Forall (fun d => (1 - bound) * lambda <= d <= (c + bound) * lambda)
    (pivots (of_T := rounded_operations rounded) pivot m).
Proof.
  intros not_negative wider sound; refine (Forall_impl _ _ (pivots_bounded _ _ _ _ _ _ sound)).
  intros d (least & greatest); apply (Rmult_le_compat_r lambda) in wider; auto; lra.
Qed.

Corollary binary32_pivots (lambda : R) (pivot : R -> R) (m : matrix R) :
  power (-119) <= lambda -> symmetric m -> at_least lambda m -> at_most (16 * lambda) m ->
  is_pivoting lambda 0 pivot ->
  Forall (fun d => (1 - power (-12)) * lambda <= d <= (16 + power (-12)) * lambda)
    (pivots (of_T := rounded_operations binary32) pivot m).
Proof.
  intros range is_symmetric below above is_pivot; pose proof (power_positive (-119)).
  eapply pivots_between; [lra | | apply binary32_elimination; auto]; unfold power; simpl; lra.
Qed.

Corollary binary64_pivots (lambda : R) (pivot : R -> R) (m : matrix R) :
  power (-1015) <= lambda -> symmetric m -> at_least lambda m -> at_most (16 * lambda) m ->
  is_pivoting lambda 0 pivot ->
  Forall (fun d => (1 - power (-41)) * lambda <= d <= (16 + power (-41)) * lambda)
    (pivots (of_T := rounded_operations binary64) pivot m).
Proof.
  intros range is_symmetric below above is_pivot; pose proof (power_positive (-1015)).
  eapply pivots_between; [lra | | apply binary64_elimination; auto]; unfold power; simpl; lra.
Qed.

(** Nothing overflows: every computed number is at most 2^127 in binary32, and at most 2^1023 in binary64. *)
Corollary binary32_finite (lambda : R) (pivot : R -> R) (m : matrix R) :
  power (-119) <= lambda <= power 122 -> symmetric m -> at_least lambda m -> at_most (16 * lambda) m ->
  is_pivoting lambda 0 pivot ->
  Forall (fun x => Rabs x <= power 127)
    (quotients (of_T := rounded_operations binary32) pivot m ++
     other_results (of_T := rounded_operations binary32) pivot m).
Proof.
  intros (range & small) is_symmetric below above is_pivot.
  eapply results_finite; [apply binary32_elimination; eauto | |].
  - apply (bpow_le radix2 4 127); lia.
  - replace (power 127) with (2 * 16 * power 122); [lra |].
    assert (power 5 = 32) as five by (unfold power; simpl; lra).
    change 127%Z with (5 + 122)%Z; rewrite power_sum, five; ring.
Qed.

Corollary binary64_finite (lambda : R) (pivot : R -> R) (m : matrix R) :
  power (-1015) <= lambda <= power 1018 -> symmetric m -> at_least lambda m -> at_most (16 * lambda) m ->
  is_pivoting lambda 0 pivot ->
  Forall (fun x => Rabs x <= power 1023)
    (quotients (of_T := rounded_operations binary64) pivot m ++
     other_results (of_T := rounded_operations binary64) pivot m).
Proof.
  intros (range & small) is_symmetric below above is_pivot.
  eapply results_finite; [apply binary64_elimination; eauto | |].
  - apply (bpow_le radix2 4 1023); lia.
  - replace (power 1023) with (2 * 16 * power 1018); [lra |].
    assert (power 5 = 32) as five by (unfold power; simpl; lra).
    change 1023%Z with (5 + 1018)%Z; rewrite power_sum, five; ring.
Qed.

(** Elimination if K itself is computed: m is the exact K, and n is the computed one. *)
Definition entries (m : matrix R) :=
  [x_of (row_x m); y_of (row_x m); z_of (row_x m); x_of (row_y m); y_of (row_y m); z_of (row_y m); x_of (row_z m);
   y_of (row_z m); z_of (row_z m)].
Definition is_close (t : R) (n m : matrix R) := Forall2 (fun x y => Rabs (x - y) <= t) (entries n) (entries m).

Lemma off_by_product (t e x y : R) : Rabs e <= t -> Rabs (e * (x * y)) <= t * (x * x + y * y) / 2.
Proof.
  intros bound; rewrite Rabs_mult.
  replace (t * (x * x + y * y) / 2) with (t * ((x * x + y * y) / 2)) by lra.
  apply Rmult_le_compat; auto using Rabs_pos.
  pose proof (Rle_0_sqr (x + y)); pose proof (Rle_0_sqr (x - y)); unfold Rsqr in *; apply Rabs_le; lra.
Qed.

Lemma close_forms (t : R) (n m : matrix R) (v : vector R) :
  is_close t n m -> Rabs (dot v (applied n v) - dot v (applied m v)) <= 3 * t * square v.
Proof.
  destruct n as [[n00 n01 n02] [n10 n11 n12] [n20 n21 n22]], m as [[m00 m01 m02] [m10 m11 m12] [m20 m21 m22]],
    v as [x y z].
  unfold is_close, entries; cbn [x_of y_of z_of row_x row_y row_z]; intros close.
  repeat match goal with each : Forall2 _ _ _ |- _ => inversion each; subst; clear each end.
  assert (forall n m x y, Rabs (n - m) <= t ->
    - (t * (x * x + y * y) / 2) <= (n - m) * (x * y) <= t * (x * x + y * y) / 2) as off
    by (intros; apply Rabs_le_inv, off_by_product; auto).
  pose proof (off n00 m00 x x ltac:(auto)); pose proof (off n01 m01 x y ltac:(auto));
    pose proof (off n02 m02 x z ltac:(auto)); pose proof (off n10 m10 y x ltac:(auto));
    pose proof (off n11 m11 y y ltac:(auto)); pose proof (off n12 m12 y z ltac:(auto));
    pose proof (off n20 m20 z x ltac:(auto)); pose proof (off n21 m21 z y ltac:(auto));
    pose proof (off n22 m22 z z ltac:(auto)).
  in_components; apply Rabs_le; lra.
Qed.

Lemma close_at_least (t s : R) (n m : matrix R) : is_close t n m -> at_least s m -> at_least (s - 3 * t) n.
Proof.
  intros close below v; pose proof (close_forms t n m v close) as form; apply Rabs_le_inv in form.
  pose proof (below v); lra.
Qed.

Lemma close_at_most (t s : R) (n m : matrix R) : is_close t n m -> at_most s m -> at_most (s + 3 * t) n.
Proof.
  intros close above v; pose proof (close_forms t n m v close) as form; apply Rabs_le_inv in form.
  pose proof (above v); lra.
Qed.

Theorem elimination_of_computed (u tiny lambda delta least : R) (rounded : R -> R) (n m : matrix R) :
  0 <= u <= power (-24) -> rounds_within u tiny rounded -> 256 * tiny <= u -> 256 * tiny <= u * lambda ->
  0 < lambda -> symmetric n -> at_least lambda m -> at_most (16 * lambda) m ->
  0 <= delta <= power (-17) -> is_close (delta * lambda) n m -> least <= (1 + delta) * lambda ->
  is_sound rounded (raised_to least) ((1 - 3 * delta) * lambda) 17 (2448 * (u + 5 * delta)) n /\
  Forall (fun d => lambda / 2 <= d) (pivots (of_T := rounded_operations rounded) (raised_to least) n).
Proof.
  intros (u_not_negative & u_small) is_rounding in_range in_range_of_lambda positive is_symmetric below above
    (delta_not_negative & delta_small) close least_small.
  assert (power (-24) = / 16777216) as u_most by (unfold power; simpl; lra).
  assert (power (-17) = / 131072) as delta_most by (unfold power; simpl; lra).
  set (mu := (1 - 3 * delta) * lambda).
  assert (99 / 100 * lambda <= mu) as mu_large by (unfold mu; apply Rmult_le_compat_r; lra).
  assert (0 <= delta * lambda <= / 131072 * lambda) as scaled_delta.
  { split; [apply Rmult_le_pos; lra | apply Rmult_le_compat_r; lra]. }
  assert (at_least mu n) as below_n.
  { replace mu with (lambda - 3 * (delta * lambda)) by (unfold mu; ring); apply close_at_least with m; auto. }
  assert (at_most (17 * mu) n) as above_n.
  { intros v; eapply Rle_trans; [apply (close_at_most _ _ _ _ close above) |].
    apply Rmult_le_compat_r; [apply square_nonnegative | unfold mu; lra]. }
  assert (is_pivoting mu (5 * delta) (raised_to least)) as is_pivot.
  { apply raised_to_is_pivoting; [apply Rmult_le_pos; lra |].
    apply Rle_trans with ((1 + delta) * lambda); auto; unfold mu; rewrite <- Rmult_assoc.
    apply Rmult_le_compat_r; nra. }
  assert (0 <= u * lambda) by (apply Rmult_le_pos; lra).
  assert (99 / 100 * (u * lambda) <= u * mu) by (apply (Rmult_le_compat_l u) in mu_large; lra).
  assert (is_sound rounded (raised_to least) mu 17 (2448 * (u + 5 * delta)) n) as sound.
  { replace (2448 * (u + 5 * delta)) with (8 * 17 * (17 + 1) * (u + 5 * delta)) by ring.
    apply (elimination_is_sound _ tiny); auto; lra. }
  split; auto; refine (Forall_impl _ _ (pivots_bounded _ _ _ _ _ _ sound)); intros d (lowest & _).
  eapply Rle_trans; [| exact lowest]; apply Rle_trans with (9 / 10 * mu); [lra |].
  apply Rmult_le_compat_r; lra.
Qed.

(** Elimination for a contact whose bodies have K ⪯ 16 λI, if K is computed accurately enough. *)
Theorem binary32_elimination_of_contact (c : contact R) (delta least : R) (computed : matrix R) :
  is_valid c -> is_dominated 15 (body_a c) (point c) -> is_dominated 15 (body_b c) (point c) ->
  power (-118) <= inverse_masses c -> symmetric computed -> 0 <= delta <= power (-17) ->
  is_close (delta * inverse_masses c) computed (collision_matrix c) -> least <= (1 + delta) * inverse_masses c ->
  Forall (fun d => inverse_masses c / 2 <= d)
    (pivots (of_T := rounded_operations binary32) (raised_to least) computed).
Proof.
  intros; pose proof (power_positive (-118)).
  destruct (small_enough (-24) (-149) (-118) (inverse_masses c)); try lia; auto.
  pose proof (half_power (-150)) as half; change (power (-150 + 1)) with (power (-149)) in half.
  eapply elimination_of_computed with (u := power (-24)); eauto using definite, well_conditioned;
    [split; [left; apply power_positive | lra] | apply binary32_rounds_within | lra ..].
Qed.

Theorem binary64_elimination_of_contact (c : contact R) (delta least : R) (computed : matrix R) :
  is_valid c -> is_dominated 15 (body_a c) (point c) -> is_dominated 15 (body_b c) (point c) ->
  power (-1014) <= inverse_masses c -> symmetric computed -> 0 <= delta <= power (-17) ->
  is_close (delta * inverse_masses c) computed (collision_matrix c) -> least <= (1 + delta) * inverse_masses c ->
  Forall (fun d => inverse_masses c / 2 <= d)
    (pivots (of_T := rounded_operations binary64) (raised_to least) computed).
Proof.
  intros; pose proof (power_positive (-1014)).
  destruct (small_enough (-53) (-1074) (-1014) (inverse_masses c)); try lia; auto.
  pose proof (half_power (-1075)) as half; change (power (-1075 + 1)) with (power (-1074)) in half.
  eapply elimination_of_computed with (u := power (-53)); eauto using definite, well_conditioned;
    [split; [left; apply power_positive | apply bpow_le; lia] | apply binary64_rounds_within | lra ..].
Qed.
