(* SPDX-License-Identifier: BSL-1.0 *)

(** Every law keeps the momenta, because F on A and -F on B act at one point. *)

Require Import Carom.reals.
Local Open Scope R_scope.

Definition momentum (mass : R) (b : body R) := scaled mass (velocity b).

(** Angular momentum about the point o. *)
Definition angular_momentum_about (o : vector R) (mass : R) (inertia : matrix R) (b : body R) :=
  sum (cross (difference (centre b) o) (momentum mass b)) (applied inertia (spin b)).

Definition has_mass (mass : R) (b : body R) := mass * inverse_mass b = 1.
Definition has_inertia_matrix (inertia : matrix R) (b : body R) :=
  forall v, applied inertia (applied (inverse_inertia b) v) = v.

Lemma momentum_pushed (mass : R) (b : body R) (p f : vector R) :
  has_mass mass b -> momentum mass (pushed b p f) = sum (momentum mass b) f.
Proof.
  intros inverse; unfold momentum, pushed; cbn [velocity].
  replace f with (scaled (mass * inverse_mass b) f) at 2 by (rewrite inverse; apply scaled_1).
  generalize (velocity b) (inverse_mass b); clear; by_ring.
Qed.

Lemma angular_momentum_pushed (o : vector R) (mass : R) (inertia : matrix R) (b : body R) (p f : vector R) :
  has_mass mass b -> has_inertia_matrix inertia b ->
  angular_momentum_about o mass inertia (pushed b p f) =
  sum (angular_momentum_about o mass inertia b) (cross (difference p o) f).
Proof.
  intros inverse inverse_matrix; unfold angular_momentum_about; rewrite momentum_pushed; auto.
  unfold pushed; cbn [centre spin]; rewrite applied_sum, inverse_matrix; unfold lever_arm.
  generalize (applied inertia (spin b)) (momentum mass b) (centre b); clear; by_ring.
Qed.

Theorem linear_momentum (c : contact R) (f : vector R) (mass_a mass_b : R) :
  has_mass mass_a (body_a c) -> has_mass mass_b (body_b c) ->
  sum (momentum mass_a (body_a (after c f))) (momentum mass_b (body_b (after c f))) =
  sum (momentum mass_a (body_a c)) (momentum mass_b (body_b c)).
Proof.
  intros of_a of_b; cbn [after body_a body_b]; rewrite !momentum_pushed by assumption.
  generalize (momentum mass_a (body_a c)) (momentum mass_b (body_b c)); clear; by_ring.
Qed.

Theorem angular_momentum (c : contact R) (f o : vector R) (mass_a mass_b : R) (inertia_a inertia_b : matrix R) :
  has_mass mass_a (body_a c) -> has_mass mass_b (body_b c) ->
  has_inertia_matrix inertia_a (body_a c) -> has_inertia_matrix inertia_b (body_b c) ->
  sum (angular_momentum_about o mass_a inertia_a (body_a (after c f)))
      (angular_momentum_about o mass_b inertia_b (body_b (after c f))) =
  sum (angular_momentum_about o mass_a inertia_a (body_a c))
      (angular_momentum_about o mass_b inertia_b (body_b c)).
Proof.
  intros of_a of_b turns_a turns_b; cbn [after body_a body_b]; rewrite !angular_momentum_pushed by assumption.
  generalize (angular_momentum_about o mass_a inertia_a (body_a c))
    (angular_momentum_about o mass_b inertia_b (body_b c)) (difference (point c) o); clear; by_ring.
Qed.

(** The moment of the impulse turns each body: J Δw = r × m Δv. *)
Theorem angular_momentum_of_each (b : body R) (p f : vector R) (mass : R) (inertia : matrix R) :
  has_mass mass b -> has_inertia_matrix inertia b ->
  applied inertia (difference (spin (pushed b p f)) (spin b)) =
  cross (lever_arm b p) (difference (momentum mass (pushed b p f)) (momentum mass b)).
Proof.
  intros of_b turns; rewrite momentum_pushed by assumption; unfold pushed; cbn [spin].
  replace (difference (sum (momentum mass b) f) (momentum mass b)) with f
    by (generalize (momentum mass b) f; clear; by_ring).
  rewrite <- (turns (cross (lever_arm b p) f)) at 2; f_equal.
  generalize (spin b) (applied (inverse_inertia b) (cross (lever_arm b p) f)); clear; by_ring.
Qed.
