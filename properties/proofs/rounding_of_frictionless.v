(* SPDX-License-Identifier: BSL-1.0 *)

(** frictionless_impulse (src/impulse/frictionless.hpp, `const S f`) computes f = -(1 + ε) a / k from a = N·V and k =
    N·KN, given numbers of the format. The sum, the product and the quotient are rounded to nearest, in this order. The
    change of sign is exact. The relative error of f is at most 3u, with u = 2^-24 or 2^-53, without a term of higher
    order. f is positive if the bodies approach. The same operations compute the factor of reflection_impulse, with N·N
    for k.

    Range: |a| and |a| / k have to be at least the least normal number, 2^-126 or 2^-1022. Nothing overflows if 4 |a|
    and 4 |a| / k are at most 2^127 or 2^1023.

    Some errors are outside this proof. The errors of a and k from rounded lever arms, angular velocities, inertias and
    masses are not covered: N·V may lose all its digits by cancellation. The products f N, f / m and f J⁻¹ (r × N), and
    their sums with the velocities, are not covered. So the error of an outcome and its backward error are not
    proved. *)

Require Import Carom.rounding.
From Flocq Require Import Core Relative.
Local Open Scope R_scope.

(** f, with the operations in the order of the C++ code. *)
Definition factor {T : Type} {of_T : operations T} (restitution approach compliance : T) : T :=
  (- (1 + restitution) * approach / compliance)%num.

Lemma factor_of_law (c : contact R) :
  frictionless_impulse c = scaled (factor (restitution c) (approach c) (normal_compliance c)) (normal c).
Proof. unfold frictionless_impulse, factor; f_equal; reals; unfold Rdiv; ring. Qed.

(** Three factors with relative errors of at most u / (1 + u), which is the largest relative error of rounding to
    nearest. *)
Lemma three_roundings (u e1 e2 e3 : R) :
  0 <= u -> Rabs e1 <= u / (1 + u) -> Rabs e2 <= u / (1 + u) -> Rabs e3 <= u / (1 + u) ->
  Rabs ((1 + e1) * (1 + e2) * (1 + e3) - 1) <= 3 * u.
Proof.
  intros not_negative first second third; set (v := u / (1 + u)) in *.
  assert (u * (1 - v) = v) as inverse by (unfold v; field; lra).
  assert (0 <= v) as v_not_negative by (pose proof (Rabs_pos e1); lra).
  assert (v < 1) as v_small by (apply (Rmult_lt_reg_r (1 + u)); [lra |]; unfold v; field_simplify; lra).
  replace ((1 + e1) * (1 + e2) * (1 + e3) - 1) with
    (e1 + e2 + e3 + (e1 * e2 + e1 * e3 + e2 * e3) + e1 * e2 * e3) by ring.
  assert (forall x y s t, Rabs x <= s -> Rabs y <= t -> Rabs (x * y) <= s * t) as products
    by (intros; rewrite Rabs_mult; apply Rmult_le_compat; auto using Rabs_pos).
  pose proof (products _ _ _ _ first second) as p12; pose proof (products _ _ _ _ first third) as p13;
    pose proof (products _ _ _ _ second third) as p23; pose proof (products _ _ _ _ p12 third) as p123.
  apply Rle_trans with (3 * v + 3 * (v * v) + v * v * v).
  - apply Rabs_le_inv in first, second, third, p12, p13, p23, p123; apply Rabs_le; lra.
  - assert (v * v <= u * v) by (apply Rmult_le_compat_r; nra).
    assert (0 <= v * v) by nra; assert (v * v * v <= v * v * u) by (apply Rmult_le_compat_l; nra).
    assert (u * v = v * v + u * v * v) by (rewrite <- inverse at 2; ring); lra.
Qed.

Section Format.
  Variables least digits : Z.
  Hypothesis two_digits : (1 < digits)%Z.

  #[local] Instance some_digits : Prec_gt_0 digits. Proof. unfold Prec_gt_0; lia. Qed.

  Let rounded := nearest least digits.
  Let unit := power (- digits).
  Let least_normal := power (least + digits - 1).

  Lemma rounded_relatively (x : R) :
    least_normal <= Rabs x -> exists e, Rabs e <= unit / (1 + unit) /\ rounded x = x * (1 + e).
  Proof.
    intros normal; unfold rounded, nearest.
    rewrite round_FLT_FLX by exact normal.
    destruct (relative_error_N_FLX'_ex radix2 digits some_digits (fun t => negb (Z.even t)) x) as (e & small & equal).
    exists e; split; auto.
    unfold u_ro in small; fold (power (- digits + 1)) in small; rewrite half_power in small; exact small.
  Qed.

  Variables restitution approach compliance : R.
  Hypotheses (restitution_in_range : 0 <= restitution <= 1) (positive : 0 < compliance).
  Hypotheses (least_small : (least + digits <= 1)%Z).
  Hypotheses (approach_stored : generic_format radix2 (FLT_exp least digits) approach)
    (approach_normal : least_normal <= Rabs approach) (quotient_normal : least_normal * compliance <= Rabs approach).

  Let exact := factor restitution approach compliance.
  Let computed := factor (of_T := rounded_operations rounded) restitution approach compliance.

  Lemma power_stored (exponent : Z) :
    (least <= exponent)%Z -> generic_format radix2 (FLT_exp least digits) (power exponent).
  Proof. apply generic_format_FLT_bpow; auto; exact some_digits. Qed.

  Lemma sum_bounded : 1 <= rounded (1 + restitution) <= 2.
  Proof.
    pose proof (power_stored 0 ltac:(lia)) as one_stored; pose proof (power_stored 1 ltac:(lia)) as two_stored.
    change (power 0) with 1 in one_stored; change (power 1) with 2 in two_stored; unfold rounded, nearest; split;
      [apply round_ge_generic | apply round_le_generic]; auto; try lra; try exact _.
  Qed.

  Lemma product_bounded :
    Rabs approach <= Rabs (rounded (- rounded (1 + restitution) * approach)) <= 4 * Rabs approach.
  Proof.
    destruct sum_bounded as (one_at_least & two_at_most); set (t := rounded (1 + restitution)) in *.
    pose proof (Rabs_pos approach) as size.
    assert (Rabs (- t * approach) = t * Rabs approach) as same
      by (rewrite Rabs_mult, Rabs_Ropp, (Rabs_pos_eq t) by lra; reflexivity).
    split.
    - apply abs_round_ge_generic; [apply FLT_exp_valid; exact some_digits | exact _ | |].
      + apply generic_format_abs; auto.
      + rewrite same; nra.
    - destruct (rounded_relatively (- t * approach)) as (e & small & ->); [rewrite same; nra |].
      rewrite Rabs_mult, same.
      assert (0 < unit) as unit_positive by apply power_positive.
      assert (unit / (1 + unit) <= 1) by (apply (Rmult_le_reg_r (1 + unit)); [lra |]; field_simplify; lra).
      assert (Rabs (1 + e) <= 2) by (apply Rabs_le_inv in small; apply Rabs_le; lra).
      replace (4 * Rabs approach) with (2 * Rabs approach * 2) by ring.
      apply Rmult_le_compat; auto using Rabs_pos; nra.
  Qed.

  (** |computed f - f| ≤ 3u |f|, without a term of higher order. *)
  Theorem factor_error : Rabs (computed - exact) <= 3 * unit * Rabs exact.
  Proof.
    destruct sum_bounded as (one_at_least & _); destruct product_bounded as (product_large & _).
    assert (0 < least_normal <= 1) as normal.
    { split; [apply power_positive |]; change 1 with (power 0); apply bpow_le; lia. }
    pose proof (Rabs_pos approach) as size.
    unfold computed, exact, factor, rounded_operations;
      cbn [zero one plus minus times over opposite real_operations].
    set (product := - rounded (1 + restitution) * approach) in *.
    destruct (rounded_relatively (rounded product / compliance)) as (e3 & small_3 & ->).
    { unfold Rdiv; rewrite Rabs_mult, Rabs_inv, (Rabs_pos_eq compliance) by lra.
      apply (Rmult_le_reg_r compliance); auto.
      replace (Rabs (rounded product) * / compliance * compliance) with (Rabs (rounded product)) by (field; lra); lra. }
    destruct (rounded_relatively product) as (e2 & small_2 & ->).
    { unfold product; rewrite Rabs_mult, Rabs_Ropp, (Rabs_pos_eq (rounded _)) by lra; nra. }
    unfold product; destruct (rounded_relatively (1 + restitution)) as (e1 & small_1 & ->).
    { rewrite Rabs_pos_eq; lra. }
    replace (_ - _) with (((1 + e1) * (1 + e2) * (1 + e3) - 1) * (- (1 + restitution) * approach / compliance))
      by (field; lra).
    rewrite Rabs_mult; apply Rmult_le_compat_r; [apply Rabs_pos |].
    apply three_roundings; auto; left; apply power_positive.
  Qed.

  (** Hence the impulse pushes if the bodies approach. *)
  Corollary factor_positive : approach < 0 -> 0 < computed.
  Proof.
    intros approaching; pose proof factor_error as error; apply Rabs_le_inv in error.
    assert (0 < exact) as positive_exact.
    { unfold exact, factor; reals; apply Rdiv_lt_0_compat; auto; nra. }
    assert (unit <= 1 / 4).
    { apply Rle_trans with (power (-2)); [apply bpow_le; lia | unfold power; simpl; lra]. }
    rewrite Rabs_pos_eq in error by lra; nra.
  Qed.

  (** Nothing overflows if 2^exponent is finite. *)
  Theorem factor_bounded (exponent : Z) :
    (least <= exponent)%Z -> 4 * Rabs approach <= power exponent -> 4 * Rabs approach <= power exponent * compliance ->
    rounded (1 + restitution) <= 2 /\ Rabs (rounded (- rounded (1 + restitution) * approach)) <= power exponent /\
    Rabs computed <= power exponent.
  Proof.
    intros large product_small quotient_small; destruct product_bounded as (_ & product_bound).
    split; [apply sum_bounded | split; [lra |]].
    apply abs_round_le_generic; [apply FLT_exp_valid; exact some_digits | exact _ | apply power_stored; auto |].
    cbn [zero one plus minus times over opposite rounded_operations].
    unfold Rdiv; rewrite Rabs_mult, Rabs_inv, (Rabs_pos_eq compliance) by lra.
    apply (Rmult_le_reg_r compliance); auto; rewrite Rmult_assoc, Rinv_l, Rmult_1_r by lra; lra.
  Qed.
End Format.

Theorem binary32_factor_error (restitution approach compliance : R) :
  0 <= restitution <= 1 -> 0 < compliance -> generic_format radix2 (FLT_exp (-149) 24) approach ->
  power (-126) <= Rabs approach -> power (-126) * compliance <= Rabs approach ->
  Rabs (factor (of_T := rounded_operations binary32) restitution approach compliance -
        factor restitution approach compliance) <=
  3 * power (-24) * Rabs (factor restitution approach compliance).
Proof. intros; apply (factor_error (-149) 24); auto; lia. Qed.

Theorem binary64_factor_error (restitution approach compliance : R) :
  0 <= restitution <= 1 -> 0 < compliance -> generic_format radix2 (FLT_exp (-1074) 53) approach ->
  power (-1022) <= Rabs approach -> power (-1022) * compliance <= Rabs approach ->
  Rabs (factor (of_T := rounded_operations binary64) restitution approach compliance -
        factor restitution approach compliance) <=
  3 * power (-53) * Rabs (factor restitution approach compliance).
Proof. intros; apply (factor_error (-1074) 53); auto; lia. Qed.
