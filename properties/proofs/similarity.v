(* SPDX-License-Identifier: BSL-1.0 *)

(** Contacts that are similar up to an isometry g and three scales: α of the normal, β of the velocities, γ of the
    inverse masses. The impulse F of each law then becomes (β/γ) g(F). *)

Require Import Carom.reals Carom.collision_matrix Carom.laws_of_impulse Carom.friction.
Local Open Scope R_scope.

(** The laws and the impulse of each law. *)
Inductive law := frictionless | reflection | sticking | rough.

Definition impulse_of (l : law) : contact R -> vector R :=
  match l with
  | frictionless => frictionless_impulse
  | reflection => reflection_impulse
  | sticking => sticking_impulse
  | rough => rough_impulse
  end.

Record isometry (g : vector R -> vector R) : Prop := {
  keeps_sum : forall v w, g (sum v w) = sum (g v) (g w);
  keeps_scaled : forall s v, g (scaled s v) = scaled s (g v);
  keeps_dot : forall v w, dot (g v) (g w) = dot v w
}.

Record similar (g : vector R -> vector R) (alpha beta gamma : R) (c c' : contact R) : Prop := {
  is_isometry : isometry g;
  alpha_positive : 0 < alpha;
  beta_positive : 0 < beta;
  gamma_positive : 0 < gamma;
  same_normal : normal c' = scaled alpha (g (normal c));
  same_velocity : relative_velocity c' = scaled beta (g (relative_velocity c));
  same_masses : inverse_masses c' = gamma * inverse_masses c;
  same_matrix : forall v, applied (collision_matrix c') (g v) = scaled gamma (g (applied (collision_matrix c) v));
  same_restitution : restitution c' = restitution c;
  same_friction : friction c' = friction c;
  same_tangential_restitution : tangential_restitution c' = tangential_restitution c
}.

Lemma negated_scaled (v : vector R) : negated v = scaled (-1) v.
Proof. by_ring. Qed.

Lemma difference_scaled (v w : vector R) : difference v w = sum v (scaled (-1) w).
Proof. by_ring. Qed.

Lemma scaled_sum (s : R) (v w : vector R) : scaled s (sum v w) = sum (scaled s v) (scaled s w).
Proof. by_ring. Qed.

Lemma scaled_difference (s : R) (v w : vector R) : scaled s (difference v w) = difference (scaled s v) (scaled s w).
Proof. by_ring. Qed.

Lemma solved_scaled (m : matrix R) (s : R) (v : vector R) : solved m (scaled s v) = scaled s (solved m v).
Proof. unfold solved; rewrite applied_scaled, !scaled_scaled; f_equal; reals; ring. Qed.

Lemma less_scaled (k x y : R) : 0 < k -> less (k * x) (k * y) = less x y.
Proof.
  intros positive; apply eq_true_iff_eq; rewrite !less_true; split; [apply Rmult_lt_reg_l | apply Rmult_lt_compat_l];
    auto.
Qed.

Lemma less_zero_scaled (k x : R) : 0 < k -> less (k * x) 0 = less x 0.
Proof. intros positive; rewrite <- (less_scaled k x 0), Rmult_0_r; auto. Qed.

Lemma zero_less_scaled (k x : R) : 0 < k -> less 0 (k * x) = less 0 x.
Proof. intros positive; rewrite <- (less_scaled k 0 x), Rmult_0_r; auto. Qed.

(** Quantities that an isometry keeps, also if its vectors are scaled afterwards. *)
Section Isometry.
  Variable g : vector R -> vector R.
  Hypothesis iso : isometry g.

  Lemma keeps_negated v : g (negated v) = negated (g v).
  Proof. rewrite !negated_scaled; apply (keeps_scaled g iso). Qed.

  Lemma keeps_difference v w : g (difference v w) = difference (g v) (g w).
  Proof. rewrite !difference_scaled, (keeps_sum g iso), (keeps_scaled g iso); reflexivity. Qed.

  Lemma scaled_dot s t v w : dot (scaled s (g v)) (scaled t (g w)) = s * t * dot v w.
  Proof. rewrite dot_scaled, dot_scaled_left, (keeps_dot g iso); ring. Qed.

  (** The cross product may change its sign, but its square does not. *)
  Lemma scaled_square_cross s t v w :
    square (cross (scaled s (g v)) (scaled t (g w))) = Rsqr (s * t) * square (cross v w).
  Proof. rewrite !square_cross; unfold square; rewrite !scaled_dot; unfold Rsqr; ring. Qed.
End Isometry.

Section Similar.
  Variables (g : vector R -> vector R) (alpha beta gamma : R) (c c' : contact R).
  Hypotheses (alike : similar g alpha beta gamma c c') (valid : is_valid c) (valid' : is_valid c').

  (** The factor that multiplies an impulse. *)
  Local Notation scale := (beta / gamma).

  Let iso := is_isometry _ _ _ _ _ _ alike.
  Let alpha_above := alpha_positive _ _ _ _ _ _ alike.
  Let beta_above := beta_positive _ _ _ _ _ _ alike.
  Let gamma_above := gamma_positive _ _ _ _ _ _ alike.
  Let normals := same_normal _ _ _ _ _ _ alike.
  Let velocities := same_velocity _ _ _ _ _ _ alike.
  Let matrices := same_matrix _ _ _ _ _ _ alike.
  Let restitutions := same_restitution _ _ _ _ _ _ alike.
  Let frictions := same_friction _ _ _ _ _ _ alike.
  Let tangential_restitutions := same_tangential_restitution _ _ _ _ _ _ alike.

  Lemma scale_positive : 0 < scale.
  Proof. apply Rdiv_lt_0_compat; auto. Qed.

  Lemma approach_similar : approach c' = alpha * beta * approach c.
  Proof. unfold approach; rewrite normals, velocities, (scaled_dot g iso); reflexivity. Qed.

  Lemma normal_square_similar : dot (normal c') (normal c') = alpha * alpha * dot (normal c) (normal c).
  Proof. rewrite normals, (scaled_dot g iso); reflexivity. Qed.

  Lemma normal_compliance_similar : normal_compliance c' = alpha * alpha * gamma * normal_compliance c.
  Proof.
    unfold normal_compliance; rewrite normals, applied_scaled, matrices, scaled_scaled, (scaled_dot g iso); ring.
  Qed.

  Lemma solved_similar (v : vector R) :
    solved (collision_matrix c') (g v) = scaled (/ gamma) (g (solved (collision_matrix c) v)).
  Proof.
    apply solved_unique; [apply invertible; auto |].
    rewrite applied_scaled, matrices, applied_solved, scaled_scaled, Rinv_l, scaled_1 by (auto using invertible; lra).
    reflexivity.
  Qed.

  Theorem is_colliding_similar : is_colliding c' = is_colliding c.
  Proof.
    unfold is_colliding; rewrite approach_similar, (same_masses _ _ _ _ _ _ alike); reals.
    rewrite zero_less_scaled, less_zero_scaled; auto; apply Rmult_lt_0_compat; auto.
  Qed.

  Lemma frictionless_similar : frictionless_impulse c' = scaled scale (g (frictionless_impulse c)).
  Proof.
    unfold frictionless_impulse.
    rewrite (keeps_scaled g iso), approach_similar, normal_compliance_similar, restitutions, normals, !scaled_scaled.
    f_equal; reals; field; pose proof (normal_compliance_positive c valid); repeat split; lra.
  Qed.

  Lemma reflection_similar : reflection_impulse c' = scaled scale (g (reflection_impulse c)).
  Proof.
    unfold reflection_impulse; pose proof (normal_square c valid).
    rewrite (keeps_scaled g iso), approach_similar, normal_square_similar, restitutions, normals, solved_scaled,
      solved_similar, !scaled_scaled.
    f_equal; reals; field; repeat split; auto; lra.
  Qed.

  Lemma sticking_similar : sticking_impulse c' = scaled scale (g (sticking_impulse c)).
  Proof.
    unfold sticking_impulse; pose proof (normal_square c valid).
    rewrite (keeps_negated g iso), approach_similar, normal_square_similar, restitutions, normals, velocities.
    replace (sum _ _) with
      (scaled beta (g (sum (relative_velocity c)
                           (scaled (restitution c * approach c / dot (normal c) (normal c)) (normal c))))).
    - rewrite solved_scaled, solved_similar, !negated_scaled, !scaled_scaled; f_equal; field; lra.
    - rewrite (keeps_sum g iso), (keeps_scaled g iso), scaled_sum, !scaled_scaled; f_equal; f_equal; reals; field.
      split; auto; lra.
  Qed.

  (** The parts of rough. *)
  Lemma stops_approach_similar : stops_approach c' = scaled scale (g (stops_approach c)).
  Proof.
    unfold stops_approach.
    rewrite (keeps_scaled g iso), approach_similar, normal_compliance_similar, normals, !scaled_scaled.
    f_equal; reals; field; pose proof (normal_compliance_positive c valid); repeat split; lra.
  Qed.

  Lemma stops_point_similar : stops_point c' = scaled scale (g (stops_point c)).
  Proof.
    unfold stops_point; rewrite (keeps_negated g iso), velocities, solved_scaled, solved_similar, !negated_scaled,
      !scaled_scaled; f_equal; field; lra.
  Qed.

  Lemma from_one_to_other_similar : from_one_to_other c' = scaled scale (g (from_one_to_other c)).
  Proof.
    unfold from_one_to_other; rewrite (keeps_difference g iso), stops_approach_similar, stops_point_similar.
    symmetry; apply scaled_difference.
  Qed.

  Lemma rough_with_similar (k : R) : rough_with c' k = scaled scale (g (rough_with c k)).
  Proof.
    unfold rough_with; rewrite (keeps_sum g iso), !(keeps_scaled g iso), stops_approach_similar,
      from_one_to_other_similar, restitutions, scaled_sum, !scaled_scaled; f_equal; f_equal; reals; ring.
  Qed.

  Lemma push_similar (f : vector R) : dot (normal c') (scaled scale (g f)) = alpha * scale * dot (normal c) f.
  Proof. rewrite normals; apply scaled_dot; auto. Qed.

  Lemma tangential_square_similar (f : vector R) :
    square (cross (normal c') (scaled scale (g f))) = Rsqr (alpha * scale) * square (cross (normal c) f).
  Proof. rewrite normals; apply scaled_square_cross; auto. Qed.

  Lemma push_scale_positive : 0 < alpha * scale.
  Proof. apply Rmult_lt_0_compat; [auto | apply scale_positive]. Qed.

  Lemma in_cone_similar (f : vector R) : in_cone c' (scaled scale (g f)) = in_cone c f.
  Proof.
    pose proof push_scale_positive as above; unfold in_cone, squared.
    rewrite push_similar, tangential_square_similar, frictions; reals; generalize dependent (alpha * scale).
    intros k above; rewrite less_zero_scaled by auto.
    replace (friction c * (k * dot (normal c) f) * (friction c * (k * dot (normal c) f))) with
      (Rsqr k * (friction c * dot (normal c) f * (friction c * dot (normal c) f))) by (unfold Rsqr; ring).
    rewrite less_scaled by (apply Rsqr_pos_lt; lra); reflexivity.
  Qed.

  Lemma sticks_in_cone_similar : sticks_in_cone c' = sticks_in_cone c.
  Proof. unfold sticks_in_cone; rewrite tangential_restitutions, rough_with_similar; apply in_cone_similar. Qed.

  Lemma radicand_similar : radicand c' = Rsqr (alpha * scale) * radicand c.
  Proof. unfold radicand; rewrite from_one_to_other_similar; apply tangential_square_similar. Qed.

  Lemma root_similar : sqrt (radicand c') = alpha * scale * sqrt (radicand c).
  Proof.
    pose proof push_scale_positive; rewrite radicand_similar, sqrt_mult by
      (apply Rle_0_sqr || apply square_nonnegative); rewrite sqrt_Rsqr by lra; reflexivity.
  Qed.

  Lemma on_the_cone_similar :
    on_the_cone c' = (fst (on_the_cone c), snd (on_the_cone c) / (alpha * scale)).
  Proof.
    pose proof push_scale_positive as above; unfold on_the_cone.
    rewrite radicand_similar, from_one_to_other_similar, stops_approach_similar, !push_similar, frictions, restitutions.
    generalize (radicand c) (dot (normal c) (from_one_to_other c)) (dot (normal c) (stops_approach c)) (friction c)
      (1 + restitution c)%num; generalize dependent (alpha * scale); intros k above s along stop mu bounce.
    unfold squared, Rsqr; reals; cbv zeta.
    replace (k * k * s - mu * (k * along) * (mu * (k * along))) with (k * k * (s - mu * along * (mu * along))) by ring.
    rewrite less_zero_scaled, zero_less_scaled by (apply Rmult_lt_0_compat; auto).
    generalize (s - mu * along * (mu * along)); intros rest; destruct (_ || _); cbn [fst snd].
    - unfold Rdiv; rewrite !Rinv_mult; f_equal; generalize (/ rest); intros inverse; field; lra.
    - replace (- (mu * (k * along) + mu * (k * along))) with (k * - (mu * along + mu * along)) by ring.
      unfold Rdiv; rewrite !Rinv_mult, Rmult_0_l; f_equal; generalize (/ - (mu * along + mu * along)); intros inverse.
      field; lra.
  Qed.

  Lemma kappa_similar : kappa c' = kappa c.
  Proof.
    pose proof push_scale_positive as above; unfold kappa, rough_kappa.
    rewrite sticks_in_cone_similar, tangential_restitutions, on_the_cone_similar, root_similar.
    generalize dependent (alpha * scale); intros k above.
    destruct (sticks_in_cone c), (on_the_cone c) as [p q]; cbn [fst snd]; reals; field; lra.
  Qed.

  Lemma rough_similar : rough_impulse c' = scaled scale (g (rough_impulse c)).
  Proof. rewrite !rough_impulse_is, kappa_similar; apply rough_with_similar. Qed.

  Theorem impulse_similar (l : law) : impulse_of l c' = scaled scale (g (impulse_of l c)).
  Proof.
    destruct l; [apply frictionless_similar | apply reflection_similar | apply sticking_similar | apply rough_similar].
  Qed.
End Similar.

(** A law's outcome of the changed contact is the changed outcome, if this holds for the effect of each impulse. *)
Theorem resolved_similar (change : contact R -> contact R) (g : vector R -> vector R) (alpha beta gamma : R)
    (c : contact R) (l : law) :
  similar g alpha beta gamma c (change c) -> is_valid c -> is_valid (change c) ->
  (forall f, after (change c) (scaled (beta / gamma) (g f)) = change (after c f)) ->
  resolved (impulse_of l) (change c) = change (resolved (impulse_of l) c).
Proof.
  intros alike valid valid' pushes; unfold resolved.
  rewrite (is_colliding_similar _ _ _ _ _ _ alike), (impulse_similar _ _ _ _ _ _ alike valid valid'), pushes.
  destruct (is_colliding c); reflexivity.
Qed.
