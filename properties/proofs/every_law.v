(* SPDX-License-Identifier: BSL-1.0 *)

(** Restitution, non-penetration and a second impulse for the outcome of every law, also if the contact does not
    collide. The bodies part no faster than they met, under coulomb too. Symbols: laws.v. *)

Require Import Carom.reals Carom.laws_of_impulse Carom.energy Carom.friction Carom.similarity.
Local Open Scope R_scope.

Theorem restitution_of_every_law (l : law) (c : contact R) :
  is_valid c -> approach (after c (impulse_of l c)) = - restitution c * approach c.
Proof.
  intros valid; destruct l; cbn [impulse_of];
    [apply restitution_of_frictionless | apply restitution_of_reflection | apply restitution_of_sticking |
     apply restitution_of_rough_law]; auto.
Qed.

Theorem non_penetration_of_every_law (l : law) (c : contact R) :
  is_valid c -> 0 <= approach (resolved (impulse_of l) c).
Proof.
  intros valid; unfold resolved; destruct (is_colliding c) eqn:colliding.
  - apply is_colliding_true in colliding as [_ approaches].
    apply non_penetration; auto; apply restitution_of_every_law; auto.
  - destruct (Rlt_le_dec (approach c) 0) as [approaches | parts]; auto.
    assert (is_colliding c = true) as collides by (apply is_colliding_true; split; auto; apply (one_moves c valid)).
    rewrite collides in colliding; discriminate.
Qed.

Theorem repeat_of_every_law (l : law) (c : contact R) :
  is_valid c -> 0 < restitution c ->
  resolved (impulse_of l) (resolved (impulse_of l) c) = resolved (impulse_of l) c.
Proof. intros; apply repeat; auto; apply restitution_of_every_law; auto. Qed.

(** The equations of the law coulomb, which can have several answers F: N·V⁺ = -ε N·V⁻, F lies in the friction cone, and
    the contact sticks (N × V⁺ = 0), or ‖N × V⁺‖ (N × F) = -μ (N·F) (N × V⁺). *)
Record is_coulomb (c : contact R) (f : vector R) : Prop := {
  obeys_restitution : approach (after c f) = - restitution c * approach c;
  obeys_cone : in_cone c f = true;
  obeys_friction :
    let slip := cross (normal c) (relative_velocity (after c f)) in
    slip = null \/ scaled (sqrt (square slip)) (cross (normal c) f) = scaled (- (friction c * dot (normal c) f)) slip
}.

(** F is the impulse of one of the five laws. If the contact does not collide, F = 0. *)
Inductive is_answer (c : contact R) : vector R -> Prop :=
| no_impulse : is_colliding c = false -> is_answer c null
| answer_of (l : law) : is_colliding c = true -> is_answer c (impulse_of l c)
| answer_of_coulomb (f : vector R) : is_colliding c = true -> is_coulomb c f -> is_answer c f.

Lemma pushed_null (b : body R) (p : vector R) : pushed b p null = b.
Proof.
  destruct b as [mass inertia x v w]; unfold pushed; cbn [inverse_mass inverse_inertia centre velocity spin].
  rewrite cross_null, applied_null, scaled_null, !sum_null; reflexivity.
Qed.

Lemma after_null (c : contact R) : after c null = c.
Proof. destruct c; unfold after; cbn; rewrite negated_null, !pushed_null; reflexivity. Qed.

Lemma resolved_by_answer (l : law) (c : contact R) : exists f, is_answer c f /\ resolved (impulse_of l) c = after c f.
Proof.
  unfold resolved; destruct (is_colliding c) eqn:colliding; eauto using answer_of.
  exists null; rewrite after_null; auto using no_impulse.
Qed.

(** |N·V⁺| ≤ |N·V⁻|. *)
Theorem parts_no_faster_than_they_met (c : contact R) (f : vector R) :
  is_valid c -> is_answer c f -> Rabs (approach (after c f)) <= Rabs (approach c).
Proof.
  intros valid [| l | f' colliding [obeys _ _]]; [rewrite after_null; apply Rle_refl | |];
    apply parts_no_faster; auto using restitution_of_every_law.
Qed.
