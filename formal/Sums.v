(* Is a sum of weighted roots of unity zero?  Computation with whole numbers, and the proof that it is right. *)
From Coq Require Import ZArith List Lia Zpow_facts Znumtheory.
From mathcomp Require Import all_ssreflect all_algebra all_field zify ssrZ.
Set Implicit Arguments. Unset Strict Implicit. Unset Printing Implicit Defensive.
Import GRing.Theory.

(** * Sums, collected *)

(* (e, w) stands for w * z^e, z a primitive N-th root of unity such as exp(2 pi i / N). *)
Definition term := (Z * Z)%type.

Fixpoint add_term (e w : Z) (l : list term) : list term :=
  match l with
  | nil => [:: (e, w)]
  | (e', w') :: l' => if Z.eqb e e' then (e', Z.add w w') :: l' else (e', w') :: add_term e w l'
  end.

Fixpoint collect (N : Z) (l : list term) : list term :=
  match l with nil => nil | (e, w) :: l' => add_term (Z.modulo e N) w (collect N l') end.

Fixpoint all_zero (l : list term) : bool :=
  match l with nil => true | (_, w) :: l' => Z.eqb w Z0 && all_zero l' end.

(** * Zero: the corners of regular polygons *)

(* (p, e, w): a regular polygon of p sides, one corner at e, each corner of weight w. *)
Definition polygon := (Z * Z * Z)%type.

Fixpoint corners (step e w : Z) (p : nat) : list term :=
  match p with O => nil | S p' => (e, w) :: corners step (Z.add e step) w p' end.

Fixpoint expand (N : Z) (ps : list polygon) : list term :=
  match ps with
  | nil => nil
  | (p, e, w) :: ps' => corners (Z.div N p) e (Z.opp w) (Z.to_nat p) ++ expand N ps'
  end.

Fixpoint good_polygons (N : Z) (ps : list polygon) : bool :=
  match ps with
  | nil => true
  | (p, _, _) :: ps' => Z.leb 2 p && Z.eqb (Z.modulo N p) Z0 && good_polygons N ps'
  end.

(* The sum less its polygons collects to nothing. *)
Definition check_polygons (N : Z) (l : list term) (ps : list polygon) : bool :=
  Z.ltb Z0 N && good_polygons N ps && all_zero (collect N (l ++ expand N ps)).

(** * Not zero: an image modulo ell *)

Definition is_unit (ell g d : Z) : bool := Z.eqb (Z.gcd (Z.sub (Zpow_mod g d ell) 1) ell) 1.

(* g^d - 1 is prime to ell for every divisor d < N of N that is at most k, or N/d at most k. *)
Fixpoint units_up_to (N ell g : Z) (k : nat) : bool :=
  match k with
  | O => true
  | S k' => let d := Z.of_nat k in
      (if Z.eqb (Z.modulo N d) Z0
       then (Z.eqb d N || is_unit ell g d) && (Z.eqb d 1 || is_unit ell g (Z.div N d)) else true)
      && units_up_to N ell g k'
  end.

Fixpoint image (N ell g : Z) (l : list term) : Z :=
  match l with
  | nil => Z0
  | (e, w) :: l' => Z.add (Z.mul w (Zpow_mod g (Z.modulo e N) ell)) (image N ell g l')
  end.

Definition check_residue (N : Z) (l : list term) (ell g : Z) : bool :=
  Z.ltb Z0 N && Z.ltb 1 ell && Z.eqb (Zpow_mod g N ell) 1
  && units_up_to N ell g (Z.to_nat (Z.sqrt N))
  && negb (Z.eqb (Z.modulo (image N ell g l) ell) Z0).

(** * What a sum is *)

Local Open Scope ring_scope.

(* In any algebraically closed field with a norm, such as the complex numbers. *)
Section Value.
Variables (F : numClosedFieldType) (N : Z) (z : F).
Definition zpow (e : Z) : F := z ^+ Z.to_nat (Z.modulo e N).
Definition value (l : seq term) : F := \sum_(t <- l) (int_of_Z t.2)%:~R * zpow t.1.
End Value.

(** * Proofs *)

Section Proofs.
Variables (F : numClosedFieldType) (N : Z) (z : F).
Hypothesis N_gt0 : Z.lt Z0 N.
Let n := Z.to_nat N.
Hypothesis prim_z : n.-primitive_root z.
Local Notation zpow := (zpow N z).
Local Notation value := (value N z).

Lemma value_nil : value [::] = 0. Proof. by rewrite /value big_nil. Qed.
Lemma value_cons e w l : value ((e, w) :: l) = (int_of_Z w)%:~R * zpow e + value l.
Proof. by rewrite /value big_cons. Qed.
Lemma value_cat l m : value (l ++ m) = value l + value m.
Proof. by rewrite /value big_cat. Qed.

Lemma zpow_mod e : zpow (Z.modulo e N) = zpow e.
Proof. by rewrite /Sums.zpow Zmod_mod. Qed.

Lemma value_add e w l : value (add_term e w l) = (int_of_Z w)%:~R * zpow e + value l.
Proof.
elim: l => [|[e' w'] l IH] /=; first by rewrite value_cons value_nil.
case: (Z.eqb_spec e e') => [<-|_]; rewrite !value_cons.
  by rewrite -[Z.add w w']/((w + w') : Z) rmorphD rmorphD mulrDl addrA.
by rewrite IH addrCA.
Qed.

Lemma value_collect l : value (collect N l) = value l.
Proof.
elim: l => [|[e w] l IH] //=; by rewrite value_add IH value_cons zpow_mod.
Qed.

Lemma value_all_zero l : all_zero l -> value l = 0.
Proof.
elim: l => [|[e w] l IH] /=; first by rewrite value_nil.
by case/andP=> /Z.eqb_spec -> /IH; rewrite value_cons => ->; rewrite mul0r addr0.
Qed.

(* z to any exponent that is congruent. *)
Lemma zpow_nat (k : nat) : zpow (Z.of_nat k) = z ^+ k.
Proof.
have zN : z ^+ n = 1 by apply: prim_expr_order.
rewrite /Sums.zpow.
set r := Z.to_nat _; pose q := Z.to_nat (Z.div (Z.of_nat k) N).
have kE : k = (n * q + r)%N.
  have H1 := Z.div_mod (Z.of_nat k) N; have H2 := Z.mod_pos_bound (Z.of_nat k) N N_gt0.
  have H3 : Z.le Z0 (Z.div (Z.of_nat k) N) by apply: Z.div_pos; lia.
  rewrite /n /q /r; nia.
by rewrite [in RHS]kE exprD exprM zN expr1n mul1r.
Qed.

Lemma zpowD e f : zpow (Z.add e f) = zpow e * zpow f.
Proof.
rewrite -zpow_mod Zplus_mod zpow_mod.
have He := Z.mod_pos_bound e N N_gt0; have Hf := Z.mod_pos_bound f N N_gt0.
rewrite -[zpow e]zpow_mod -[zpow f]zpow_mod.
move: (Z.modulo e N) (Z.modulo f N) He Hf => a b Ha Hb.
have -> : a = Z.of_nat (Z.to_nat a) by lia.
have -> : b = Z.of_nat (Z.to_nat b) by lia.
by rewrite -Nat2Z.inj_add !zpow_nat exprD.
Qed.

Lemma value_corners step e w p :
  value (corners step e w p) = (int_of_Z w)%:~R * zpow e * \sum_(i < p) zpow step ^+ i.
Proof.
elim: p e => [|p IH] e /=; first by rewrite value_nil big_ord0 mulr0.
rewrite value_cons IH zpowD big_ord_recl expr0 mulrDr mulr1; congr (_ + _).
rewrite -!mulrA; congr (_ * (_ * _)); rewrite mulr_sumr; apply: eq_bigr => i _.
by rewrite -exprS.
Qed.

Lemma zpow_eq1 e : (zpow e == 1) = Z.eqb (Z.modulo e N) Z0.
Proof.
have He := Z.mod_pos_bound e N N_gt0.
rewrite /Sums.zpow -(prim_order_dvd prim_z); apply/idP/Z.eqb_spec => [|-> /=]; last by rewrite dvdn0.
case: (posnP (Z.to_nat (Z.modulo e N))) => [|r_gt0 /dvdn_leq]; lia.
Qed.

(* The powers of a root of unity sum to zero, unless all are 1. *)
Lemma geometric (x : F) p : x ^+ p = 1 -> x != 1 -> \sum_(i < p) x ^+ i = 0.
Proof.
move=> xp x1; apply/eqP; have : (x - 1) * (\sum_(i < p) x ^+ i) == 0 by rewrite -subrX1 xp subrr.
by rewrite mulf_eq0 subr_eq0 (negbTE x1).
Qed.

Lemma zpow_exp e (k : nat) : zpow e ^+ k = zpow (Z.mul e (Z.of_nat k)).
Proof.
elim: k => [|k IH]; first by rewrite expr0 Z.mul_0_r (zpow_nat 0).
rewrite exprS IH -zpowD; congr (Sums.zpow _ _ _); lia.
Qed.

Lemma polygon_zero p : Z.le 2 p -> Z.modulo N p = Z0 ->
  \sum_(i < Z.to_nat p) zpow (Z.div N p) ^+ i = 0.
Proof.
move=> p2 Np; have Nq : N = Z.mul p (Z.div N p) by rewrite [LHS](Z.div_mod N p) ?Np; lia.
have q_gt0 : Z.lt Z0 (Z.div N p) by nia.
apply: geometric.
  rewrite zpow_exp Z2Nat.id; last lia.
  by apply/eqP; rewrite zpow_eq1 Z.mul_comm -Nq Z.mod_same //; lia.
by rewrite zpow_eq1; apply/negP => /Z.eqb_spec; rewrite Z.mod_small; nia.
Qed.

Lemma value_expand ps : good_polygons N ps -> value (expand N ps) = 0.
Proof.
elim: ps => [|[[p e] w] ps IH] /=; first by rewrite value_nil.
case/andP => /andP[/Z.leb_spec0 p2 /Z.eqb_spec Np] /IH H.
by rewrite value_cat H addr0 value_corners polygon_zero // mulr0.
Qed.

(** Polygons prove that a sum is zero. *)
Theorem check_polygons_sound l ps : check_polygons N l ps -> value l = 0.
Proof.
case/andP=> /andP[_ good] /value_all_zero.
by rewrite value_collect value_cat value_expand // addr0.
Qed.

(* The sum as an integral polynomial at z. *)
Definition poly_of (l : seq term) : {poly int} :=
  \sum_(t <- l) (int_of_Z t.2)%:P * 'X^(Z.to_nat (Z.modulo t.1 N)).

Local Notation pZtoF := (map_poly (intr : int -> F)).
Local Notation pZtoC := (map_poly (intr : int -> algC)).
Local Notation pZtoQ := (map_poly (intr : int -> rat)).

Lemma poly_value l : (pZtoF (poly_of l)).[z] = value l.
Proof.
rewrite /poly_of /Sums.value rmorph_sum horner_sum; apply: eq_bigr => t _.
by rewrite rmorphM /= map_polyC map_polyXn /= hornerM hornerC hornerXn.
Qed.

Lemma pQ_ratr (R : numFieldType) (p : {poly int}) : map_poly (ratr : rat -> R) (pZtoQ p) = map_poly intr p.
Proof. by rewrite -map_poly_comp; apply: eq_map_poly => i /=; rewrite ratr_int. Qed.

(* z is a root of the n-th cyclotomic polynomial. *)
Lemma Phi_root : (pZtoF 'Phi_n).[z] = 0.
Proof.
have n0 : (0 < n)%N by rewrite /n; lia.
have : (pZtoF ('X^n - 1)).[z] == 0.
  by rewrite rmorphB rmorph1 /= map_polyXn !hornerE hornerXn (prim_expr_order prim_z) subrr.
rewrite -prod_Cyclotomic // rmorph_prod horner_prod /=.
rewrite prodf_seq_eq0 => /hasP[d]; rewrite -dvdn_divisors // => dn /= /eqP dz.
have d0 : (0 < d)%N := dvdn_gt0 n0 dn.
suff : (n %| d)%N by move=> nd; have /eqP -> : n == d by rewrite eqn_dvd dn nd.
rewrite (prim_order_dvd prim_z) -subr_eq0.
have -> : z ^+ d - 1 = (pZtoF ('X^d - 1)).[z] by rewrite rmorphB rmorph1 /= map_polyXn !hornerE hornerXn.
rewrite -prod_Cyclotomic // rmorph_prod horner_prod /=.
by rewrite (big_rem d) /= ?dz ?mul0r // -dvdn_divisors.
Qed.

(* An integral polynomial with the root z is a multiple of the n-th cyclotomic polynomial. *)
Lemma zero_divides (P : {poly int}) : (pZtoF P).[z] = 0 -> exists Q, P = Q * 'Phi_n.
Proof.
move=> Pz; have n0 : (0 < n)%N by rewrite /n; lia.
have mon : 'Phi_n \is monic := Cyclotomic_monic n.
have PE := Pdiv.RingMonic.rdivp_eq mon P.
set Q := Pdiv.CommonRing.rdivp P _ in PE; set R := Pdiv.CommonRing.rmodp P _ in PE.
exists Q; suff R0 : R = 0 by rewrite {1}PE R0 addr0.
have Rz : (pZtoF R).[z] = 0.
  by move: Pz; rewrite PE rmorphD rmorphM /= hornerD hornerM Phi_root mulr0 add0r.
apply/eqP/negPn/negP => Rn0.
have RQn0 : pZtoQ R != 0 by rewrite map_poly_eq0_id0 // intr_eq0 lead_coef_eq0.
have [z0 prim0] := C_prim_root_exists n0.
suff : coprimep (pZtoQ 'Phi_n) (pZtoQ R).
  case/Bezout_eq1_coprimepP => -[u v] /= /(congr1 (fun p => (map_poly (ratr : rat -> F) p).[z])).
  rewrite rmorphD !rmorphM /= !pQ_ratr hornerD !hornerM Rz Phi_root !mulr0 addr0 rmorph1 hornerC.
  by move/esym/eqP; rewrite oner_eq0.
rewrite -(coprimep_map (ratr_rmorphism [numFieldType of algC])) !pQ_ratr.
apply: Pdiv.ClosedField.root_coprimep => x.
rewrite (Cintr_Cyclotomic prim0) root_cyclotomic // => prim_x.
apply/negP => /eqP Rx; have [p [pE _ pP]] := minCpolyP x.
have dv : p %| pZtoQ R by rewrite -pP pQ_ratr; apply/rootP.
have := dvdp_leq RQn0 dv.
have -> : size p = size 'Phi_n.
  rewrite -(size_map_poly (ratr_rmorphism [numFieldType of algC]) p) -pE (minCpoly_cyclotomic prim_x).
  by rewrite size_Cyclotomic size_cyclotomic.
rewrite size_map_inj_poly //; last exact: intr_inj.
by rewrite leqNgt Pdiv.CommonRing.ltn_rmodp monic_neq0.
Qed.

Lemma Zexp (g : Z) (k : nat) : (g ^+ k : Z) = Z.pow g (Z.of_nat k).
Proof.
elim: k => [|k IH]; first by rewrite expr0.
by rewrite exprS IH Nat2Z.inj_succ Z.pow_succ_r //; lia.
Qed.

Section At.
Variable (ell g : Z).
Hypothesis ell_gt1 : Z.lt 1 ell.
Let at_g (p : {poly int}) : Z := Z_of_int p.[int_of_Z g].

Lemma at_gM p q : at_g (p * q) = Z.mul (at_g p) (at_g q).
Proof. by rewrite /at_g hornerM rmorphM. Qed.

Lemma at_Xn1 k : at_g ('X^k - 1) = Z.sub (Z.pow g (Z.of_nat k)) 1.
Proof.
by rewrite /at_g !(hornerE, hornerXn) rmorphB rmorphX /= int_of_ZK Zexp.
Qed.

Lemma prod_divides d m : (0 < m)%N -> (d %| m)%N -> Z.divide (at_g 'Phi_d) (Z.sub (Z.pow g (Z.of_nat m)) 1).
Proof.
move=> m0 dm; rewrite -at_Xn1 -prod_Cyclotomic // (big_rem d) -?dvdn_divisors //= at_gM.
by exists (at_g (\prod_(y <- rem d (divisors m)) 'Phi_y)); rewrite Z.mul_comm.
Qed.

Lemma powmod_divide (k a : Z) : Z.le Z0 k ->
  exists c, Zpow_mod g k ell = Z.add (Z.pow g k) (Z.mul c ell).
Proof.
move=> k0; rewrite Zpow_mod_correct //; last lia.
by exists (Z.opp (Z.div (Z.pow g k) ell)); have := Z.div_mod (Z.pow g k) ell; lia.
Qed.

Hypothesis gN : Zpow_mod g N ell = Zpos 1.
Hypothesis units : forall d, (d %| n)%N -> (d < n)%N -> is_unit ell g (Z.of_nat d).

Lemma unit_pow d : (d %| n)%N -> (d < n)%N -> Z.gcd ell (Z.sub (Z.pow g (Z.of_nat d)) 1) = Zpos 1.
Proof.
move=> dn d_lt; have [|c E] := @powmod_divide (Z.of_nat d) 0; first lia.
have /Z.eqb_spec/Z.gcd_bezout[u [v B]] := units dn d_lt; apply/Z.bezout_1_gcd.
by exists (Z.add v (Z.mul u c)), u; rewrite -[RHS]B E; lia.
Qed.

Lemma gcd_of_divide a b : Z.gcd ell b = Zpos 1 -> Z.divide a b -> Z.gcd ell a = Zpos 1.
Proof.
move=> H1 H2; apply/Z.bezout_1_gcd; move/Z.gcd_bezout: H1 => [u [v E]]; case: H2 => c bE.
by exists u, (Z.mul v c); rewrite -[RHS]E bE; lia.
Qed.

Lemma gcd_mult a b : Z.gcd ell a = Zpos 1 -> Z.gcd ell b = Zpos 1 -> Z.gcd ell (Z.mul a b) = Zpos 1.
Proof.
move=> Ha Hb; apply/Z.bezout_1_gcd; move/Z.gcd_bezout: Ha => [u [v E]]; move/Z.gcd_bezout: Hb => [u' [v' E']].
exists (Z.add (Z.mul u (Z.add (Z.mul u' ell) (Z.mul v' b))) (Z.mul u' (Z.mul v a))), (Z.mul v v'); nia.
Qed.

Lemma gauss_prod (s : seq nat) : (forall d, d \in s -> (d %| n)%N /\ (d < n)%N) ->
  Z.gcd ell (at_g (\prod_(d <- s) 'Phi_d)) = Zpos 1.
Proof.
elim: s => [_|d s IH H]; first by rewrite big_nil /at_g hornerC; apply: Z.gcd_1_r.
rewrite big_cons at_gM; apply: gcd_mult.
  have [dn d_lt] := H d (mem_head _ _).
  have d0 : (0 < d)%N by apply: dvdn_gt0 dn; rewrite /n; lia.
  exact: gcd_of_divide (unit_pow dn d_lt) (prod_divides d0 (dvdnn d)).
by apply: IH => e es; apply: H; rewrite inE es orbT.
Qed.

(* The n-th cyclotomic polynomial at g: the others are units, and their product with it is g^n - 1. *)
Lemma Phi_at_g : Z.divide ell (at_g 'Phi_n).
Proof.
have n0 : (0 < n)%N by rewrite /n; lia.
have nn : n \in divisors n by rewrite -dvdn_divisors.
apply: (@Z.gauss _ (at_g (\prod_(d <- rem n (divisors n)) 'Phi_d))); last first.
  apply: gauss_prod => d; rewrite mem_rem_uniq ?divisors_uniq //.
  case/andP=> dn ds; have dv : (d %| n)%N by rewrite dvdn_divisors.
  by split=> //; rewrite ltn_neqAle dn dvdn_leq.
rewrite Z.mul_comm -at_gM.
have := prod_Cyclotomic n0; rewrite (big_rem n) //= => ->; rewrite at_Xn1.
have NE : Z.of_nat n = N by rewrite /n; lia.
have [|c E] := @powmod_divide N 0; first lia.
by rewrite NE; exists (Z.opp c); lia.
Qed.

Lemma image_mod l : exists c, image N ell g l = Z.add (at_g (poly_of l)) (Z.mul c ell).
Proof.
elim: l => [|[e w] l [c IH]] /=; first by exists Z0; rewrite /poly_of big_nil /at_g horner0.
have e0 : Z.le Z0 (Z.modulo e N) by have := Z.mod_pos_bound e N N_gt0; lia.
have [c' E] := @powmod_divide _ 0 e0.
exists (Z.add c (Z.mul w c')); rewrite E IH /poly_of big_cons -/(poly_of l) /=.
have -> : at_g ((int_of_Z w)%:P * 'X^(Z.to_nat (Z.modulo e N)) + poly_of l) = Z.add (Z.mul w (Z.pow g (Z.modulo e N))) (at_g (poly_of l)).
  rewrite /at_g hornerD hornerM hornerC hornerXn rmorphD rmorphM rmorphX /= !int_of_ZK Zexp.
  by rewrite Z2Nat.id.
by lia.
Qed.

Lemma value_neq0 l : Z.modulo (image N ell g l) ell <> Z0 -> value l <> 0.
Proof.
move=> im v0; apply: im; have := poly_value l; rewrite v0 => /zero_divides[Q PE].
have [c ->] := image_mod l; rewrite PE at_gM; have [d ->] := Phi_at_g.
have -> : Z.add (Z.mul (at_g Q) (Z.mul d ell)) (Z.mul c ell) = Z.mul (Z.add (Z.mul (at_g Q) d) c) ell by lia.
by apply: Z.mod_mul; lia.
Qed.

End At.

Lemma units_up_to_sound ell g k : units_up_to N ell g k ->
  forall d e, Z.lt Z0 d -> Z.le d (Z.of_nat k) -> N = Z.mul d e ->
  (d = N \/ is_unit ell g d) /\ (d = Zpos 1 \/ is_unit ell g e).
Proof.
elim: k => [|k IH]; first by lia.
rewrite -[units_up_to _ _ _ _]/(_ && _) => /andP[Hk /IH H] d e d0 dk NE.
case: (Z.eq_dec d (Z.of_nat k.+1)) => [dE|dn]; last by apply: H NE; lia.
move: Hk; rewrite -dE NE Z.mul_comm Z.mod_mul ?Z.div_mul; try lia.
rewrite Z.eqb_refl => /andP[/orP[/Z.eqb_spec|] H1 /orP[/Z.eqb_spec|] H2]; split; auto; left; lia.
Qed.

(** An image modulo ell that is not zero proves that a sum is not zero. *)
Theorem check_residue_sound l ell g : check_residue N l ell g -> value l <> 0.
Proof.
case/andP=> /andP[/andP[/andP[_ /Z.ltb_spec0 ell1] /Z.eqb_spec gN] un] im.
suff U : forall d, (d %| n)%N -> (d < n)%N -> is_unit ell g (Z.of_nat d).
  by apply: (value_neq0 ell1 gN U); apply/Z.eqb_spec.
move=> d dn d_lt; have n0 : (0 < n)%N by rewrite /n; lia.
have d0 : (0 < d)%N := dvdn_gt0 n0 dn.
case/dvdnP: (dn) => q nE.
have NE : N = Z.mul (Z.of_nat d) (Z.of_nat q) by rewrite /n in nE; lia.
have [s1 s2] : Z.le (Z.mul (Z.sqrt N) (Z.sqrt N)) N /\ Z.lt N (Z.mul (Z.succ (Z.sqrt N)) (Z.succ (Z.sqrt N))).
  by apply: Z.sqrt_spec; lia.
have s0 := Z.sqrt_nonneg N; have U := units_up_to_sound un; rewrite Z2Nat.id // in U.
case: (Z.le_gt_cases (Z.of_nat d) (Z.sqrt N)) => d_sqrt.
  by case: (U (Z.of_nat d) (Z.of_nat q)) => [|//|//|[H|//] _]; rewrite /n in d_lt; lia.
have q_sqrt : Z.le (Z.of_nat q) (Z.sqrt N) by nia.
by case: (U (Z.of_nat q) (Z.of_nat d)) => [|//||_ [H|//]]; rewrite /n in d_lt; nia.
Qed.

End Proofs.
