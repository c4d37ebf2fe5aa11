(* SPDX-License-Identifier: BSL-1.0 *)

(** Statements of laws_of_impulse.v, for the outcome of every law, also if the contact does not collide. *)

Require Import Carom.reals Carom.laws_of_impulse Carom.friction Carom.similarity.
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
