(* SPDX-License-Identifier: BSL-1.0 *)

(** Arithmetic that rounds each result, as binary32 and binary64 do: to nearest, ties to even, with subnormal numbers.
    Here a result that is too large does not become infinite, so that the theorems bound the results as well. Each
    operation rounds once, as in C++ without contraction to fused operations and without wider registers. *)

From Flocq Require Import Core Relative.
Require Export Carom.reals.
Local Open Scope R_scope.

(** The operations over the real numbers, with each result rounded. *)
Definition rounded_operations (rounded : R -> R) : operations R := {|
  zero := 0;
  one := 1;
  plus x y := rounded (x + y);
  minus x y := rounded (x - y);
  times x y := rounded (x * y);
  over x y := rounded (x / y);
  opposite := Ropp;
  less x y := if Rlt_dec x y then true else false
|}.

(** The property of a rounding that the proofs use, for results of any size. The error is at most u times the exact
    result, plus h for underflow. *)
Definition rounds_within (u h : R) (rounded : R -> R) := forall x, Rabs (rounded x - x) <= u * Rabs x + h.

(** The format whose least positive number is 2^least, with the given number of digits. *)
Definition nearest (least digits : Z) := round radix2 (FLT_exp least digits) ZnearestE.
Definition binary32 := nearest (-149) 24.
Definition binary64 := nearest (-1074) 53.

Definition power (exponent : Z) := bpow radix2 exponent.

Lemma power_positive (exponent : Z) : 0 < power exponent. Proof. apply bpow_gt_0. Qed.

Lemma power_sum (i j : Z) : power (i + j) = power i * power j. Proof. apply bpow_plus. Qed.

Lemma half_power (exponent : Z) : / 2 * power (exponent + 1) = power exponent.
Proof. rewrite power_sum; unfold power; simpl; lra. Qed.

Lemma nearest_rounds_within (least digits : Z) :
  (0 < digits)%Z -> rounds_within (power (- digits)) (power (least - 1)) (nearest least digits).
Proof.
  intros some x.
  destruct (error_N_FLT radix2 least digits some (fun t => negb (Z.even t)) x) as (e & h & small & tiny & _ & sum).
  fold (power (- digits + 1)) in small; fold (power least) in tiny; rewrite half_power in small.
  replace least with (least - 1 + 1)%Z in tiny by ring; rewrite half_power in tiny.
  unfold nearest; rewrite sum; replace (x * (1 + e) + h - x) with (e * x + h) by ring.
  eapply Rle_trans; [apply Rabs_triang |]; rewrite Rabs_mult.
  pose proof (Rabs_pos x); nra.
Qed.

Lemma binary32_rounds_within : rounds_within (power (-24)) (power (-150)) binary32.
Proof. apply (nearest_rounds_within (-149) 24); reflexivity. Qed.

Lemma binary64_rounds_within : rounds_within (power (-53)) (power (-1075)) binary64.
Proof. apply (nearest_rounds_within (-1074) 53); reflexivity. Qed.
