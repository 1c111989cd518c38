(* Does the evidence prove the verdict on an engine?  The checker, and the theorems that it is right. *)
From Coq Require Import ZArith QArith List Lia.
From mathcomp Require Import all_ssreflect all_algebra all_field zify ssrZ.
From Crankstar Require Import Sums Splitting Engine.
Set Implicit Arguments. Unset Strict Implicit. Unset Printing Implicit Defensive.
Import GRing.Theory Num.Theory.

(** * The checker *)

Inductive certificate : Type :=
| Polygons (ps : list polygon)
| Residue (n ell g : Z)      (* over the n-th part of a turn, once like directions are added *)
| Split (steps : list step).

(* Angles times [conductor] and weights times [scaled_by] are whole; the certificate is about these numbers. *)
Record evidence := Evidence { conductor : Z; scaled_by : Z; certified : certificate }.

Definition is_whole (n : Z) (q : Q) : bool := Z.eqb (Z.modulo (Z.mul n (Qnum q)) (Zpos (Qden q))) 0.
Definition times (n : Z) (q : Q) : Z := Z.div (Z.mul n (Qnum q)) (Zpos (Qden q)).

Definition integral (N D : Z) (l : seq (Q * Q)) : seq term := [seq (times N v.1, times D v.2) | v <- l].

Definition check_certificate (N : Z) (l : seq term) (c : certificate) : bool :=
  match c with
  | Polygons ps => check_polygons N l ps
  | Residue n ell g =>
      let l1 := collected N l in
      let d := Z.div N n in
      Z.ltb 0 n && Z.eqb (Z.mul d n) N && all (in_class d 0) l1 && check_residue n (divide d l1) ell g
  | Split steps => check_splitting N l steps
  end.

Definition claims_zero (ev : evidence) : bool := if certified ev is Polygons _ then true else false.

(* Whether the evidence proves what it claims of this sum. *)
Definition check (l : seq (Q * Q)) (ev : evidence) : bool :=
  let: Evidence N D c := ev in
  Z.ltb 0 N && Z.ltb 0 D && all (fun v => is_whole N v.1 && is_whole D v.2) l
  && check_certificate N (integral N D l) c.

Definition check_zero l ev := claims_zero ev && check l ev.
Definition check_nonzero l ev := ~~ claims_zero ev && check l ev.

(* The terms of |direct|^2 - |reverse|^2. *)
Definition square (sign : Z) (l : seq (Q * Q)) : seq (Q * Q) :=
  flatten [seq [seq (v.1 - u.1, inject_Z sign * v.2 * u.2)%q | u <- l] | v <- l].
Definition squares (E : engine) (q : sense -> quantity) (k : Z) : seq (Q * Q) :=
  square 1 (vectors E (q Direct) k) ++ square (-1) (vectors E (q Reverse) k).

(* One verdict for each of the orders k, k + step, ..: is it left where it is one of the residues? *)
Fixpoint check_period (E : engine) (q : quantity) (step modulus : Z) (residues : seq Z) (k : Z) (evs : seq evidence) : bool :=
  match evs with
  | nil => true
  | ev :: evs' =>
      check (vectors E q k) ev && (claims_zero ev != (Z.modulo k modulus \in residues))
      && check_period E q step modulus residues (Z.add k step) evs'
  end.

(* No mass turns with the orders from the first on, or none makes a torque. *)
Definition pistons_alone (E : engine) (q : quantity) (first : Z) : bool :=
  if q is Torque then true else Z.leb 2 first && all (fun t => Z.leb (order t) 1) (turning_masses E).

(* The orders from the first on, by steps of one or two, by one period. *)
Definition check_every (E : engine) (q : quantity) (step first modulus : Z) (residues : seq Z) (evs : seq evidence) : bool :=
  let period := Z.mul step (Z.of_nat (size evs)) in
  pistons_alone E q first && Z.ltb 0 step && Z.ltb 0 modulus && Z.ltb 0 period && Z.eqb (Z.modulo period modulus) 0
  && all (fun c => is_whole period (throw c) && is_whole period (bank c)) (cylinders E)
  && check_period E q step modulus residues first evs.

(** * Proofs *)

Local Open Scope ring_scope.
Local Arguments Z.add : simpl never. Local Arguments Z.sub : simpl never. Local Arguments Z.mul : simpl never.
Local Arguments Z.div : simpl never. Local Arguments Z.modulo : simpl never. Local Arguments Pos.mul : simpl never.

Lemma eq_sum_all (F : numClosedFieldType) T (p : pred T) (s : seq T) (f g : T -> F) :
  all p s -> (forall x, p x -> f x = g x) -> \sum_(x <- s) f x = \sum_(x <- s) g x.
Proof. by move=> ps H; elim: s ps => [|x s IH] /=; rewrite ?big_nil // !big_cons => /andP[/H -> /IH ->]. Qed.

Lemma filter_none T (p a : pred T) (s : seq T) : all p s -> (forall x, p x -> a x = false) -> filter a s = [::].
Proof. by move=> ps H; elim: s ps => [|x s IH] //= /andP[/H -> /IH]. Qed.

Section Circle.
Variables (F : numClosedFieldType) (e : circle F).

Lemma cis_whole t n : (t == inject_Z n)%q -> e t = 1.
Proof. by move=> H; apply/cis_one; exists n. Qed.

Lemma cis_opp t : e (- t)%q * e t = 1.
Proof. by rewrite -cis_add; apply: (@cis_whole _ 0); ring. Qed.

Lemma cis_neq0 t : e t != 0.
Proof. by apply/eqP => t0; move: (cis_opp t); rewrite t0 mulr0 => /esym/eqP; rewrite oner_eq0. Qed.

(* Angles that differ by whole turns. *)
Lemma cis_eq s t n : (s - t == inject_Z n)%q -> e s = e t.
Proof.
move=> H; apply: (mulfI (cis_neq0 (- t)%q)); rewrite cis_opp -cis_add; apply: (@cis_whole _ n).
by rewrite -H; ring.
Qed.

Lemma cis_same s t : (s == t)%q -> e s = e t.
Proof. by move=> H; apply: (@cis_eq _ _ 0); rewrite H; ring. Qed.

Lemma cis_exp t k : e t ^+ k = e (inject_Z (Z.of_nat k) * t)%q.
Proof.
elim: k => [|k IH]; first by rewrite expr0; apply/esym/(@cis_whole _ 0); rewrite /=; ring.
rewrite exprS IH -cis_add; apply: cis_same; rewrite Nat2Z.inj_succ /Z.succ inject_Z_plus; ring.
Qed.

Section Root.
Variable N : Z.
Hypothesis N_gt0 : Z.lt 0 N.
Definition part : Q := (1 # Z.to_pos N)%q.

Lemma part_times k n : (inject_Z k * part == inject_Z n)%q <-> k = Z.mul n N.
Proof. by rewrite /part /inject_Z /Qeq /= Z2Pos.id //; split; lia. Qed.

Lemma prim_part : (Z.to_nat N).-primitive_root (e part).
Proof.
have n0 : (0 < Z.to_nat N)%N by lia.
have zN : e part ^+ Z.to_nat N = 1.
  by rewrite cis_exp; apply: (@cis_whole _ 1); apply/part_times; lia.
have [m prim_m m_dv] := prim_order_exists n0 zN.
suff -> : Z.to_nat N = m by [].
apply/eqP; rewrite eqn_dvd m_dv andbT.
have := prim_expr_order prim_m; rewrite cis_exp => /cis_one[c /part_times cE].
by apply/dvdnP; exists (Z.to_nat c); nia.
Qed.

Lemma is_whole_times n q : is_whole n q -> (inject_Z n * q == inject_Z (times n q))%q.
Proof.
move=> /Z.eqb_spec H; rewrite /times /Qeq /=; have := Z.div_mod (Z.mul n (Qnum q)) (Zpos (Qden q)); lia.
Qed.

Lemma cis_times t : is_whole N t -> e t = zpow N (e part) (times N t).
Proof.
move=> /is_whole_times H; rewrite /zpow; set k := times N t in H *.
have kb := Z.mod_pos_bound k N N_gt0; have kd := Z.div_mod k N.
rewrite cis_exp Z2Nat.id; last lia.
apply: (@cis_eq _ _ (Z.div k N)).
have NE : (inject_Z N * part == 1)%q by apply: (proj2 (part_times N 1)); lia.
have -> : (t == inject_Z k * part)%q by rewrite -H (Qmult_comm (inject_Z N)) -Qmult_assoc NE; ring.
have -> : (inject_Z k == inject_Z N * inject_Z (Z.div k N) + inject_Z (Z.modulo k N))%q.
  by rewrite -inject_Z_mult -inject_Z_plus -kd //; lia.
transitivity (inject_Z N * part * inject_Z (Z.div k N))%q; [by ring | by rewrite NE; ring].
Qed.

End Root.

Lemma Zint_neq0 n : Z.lt 0 n -> (int_of_Z n)%:~R != 0 :> F.
Proof. by move=> n0; rewrite intr_eq0; apply/eqP => n_eq0; have := int_of_ZK n; rewrite n_eq0 /=; lia. Qed.

Lemma ZintM a b : (int_of_Z (Z.mul a b))%:~R = (int_of_Z a)%:~R * (int_of_Z b)%:~R :> F.
Proof. by rewrite -[Z.mul a b]/((a * b)%R : Z) !rmorphM. Qed.

Lemma ZintD a b : (int_of_Z (Z.add a b))%:~R = (int_of_Z a)%:~R + (int_of_Z b)%:~R :> F.
Proof. by rewrite -[Z.add a b]/((a + b)%R : Z) !rmorphD. Qed.

Lemma number_eq p q : (p == q)%q -> number F p = number F q.
Proof.
rewrite /Qeq /number => H; apply/eqP; rewrite eqr_div ?Zint_neq0 // -!ZintM.
by rewrite H.
Qed.

Lemma number_Z n : number F (inject_Z n) = (int_of_Z n)%:~R.
Proof. by rewrite /number /= divr1. Qed.

Lemma numberM p q : number F (p * q)%q = number F p * number F q.
Proof.
have -> : number F (p * q)%q = (int_of_Z (Z.mul (Qnum p) (Qnum q)))%:~R / (int_of_Z (Z.mul (Zpos (Qden p)) (Zpos (Qden q))))%:~R by [].
by rewrite /number !ZintM invfM mulrACA.
Qed.

Lemma numberD p q : number F (p + q)%q = number F p + number F q.
Proof.
have -> : number F (p + q)%q = (int_of_Z (Z.add (Z.mul (Qnum p) (Zpos (Qden q))) (Z.mul (Qnum q) (Zpos (Qden p)))))%:~R
  / (int_of_Z (Z.mul (Zpos (Qden p)) (Zpos (Qden q))))%:~R by [].
by rewrite /number ZintD !ZintM addf_div ?Zint_neq0.
Qed.

Lemma number_times D q : Z.lt 0 D -> is_whole D q -> number F q = (int_of_Z (times D q))%:~R / (int_of_Z D)%:~R.
Proof.
move=> D0 /is_whole_times/number_eq; rewrite numberM !number_Z => <-.
by rewrite mulrAC mulfV ?mul1r // Zint_neq0.
Qed.

Lemma total_integral N D l : Z.lt 0 N -> Z.lt 0 D -> all (fun v => is_whole N v.1 && is_whole D v.2) l ->
  total e l = value N (e (part N)) (integral N D l) / (int_of_Z D)%:~R.
Proof.
move=> N0 D0 whole; rewrite /total /value /integral big_map mulr_suml.
apply: (eq_sum_all whole) => v /andP[w1 w2] /=.
by rewrite -(cis_times N0 w1) (number_times D0 w2) mulrAC.
Qed.

(** What the checker accepts is true of the sum. *)
Theorem check_sound l ev : check l ev -> if claims_zero ev then total e l = 0 else total e l <> 0.
Proof.
case: ev => N D c /= /andP[/andP[/andP[/Z.ltb_spec0 N0 /Z.ltb_spec0 D0] whole]].
rewrite /claims_zero /= (total_integral N0 D0 whole).
have prim := prim_part N0; have D_neq0 := Zint_neq0 D0.
case: c => [ps|n ell g|steps] /= H.
- by rewrite (check_polygons_sound N0 prim H) mul0r.
- case/andP: H => /andP[/andP[/Z.ltb_spec0 n0 /Z.eqb_spec nE] steps] H.
  have d0 : Z.lt 0 (Z.div N n) by nia.
  apply/eqP; rewrite mulf_neq0 ?invr_neq0 // -(value_collected N) (value_divide N0 prim d0 (esym nE) steps).
  rewrite turn0 mulf_neq0 ?(zpow_unit N0 prim) //; apply/eqP.
  exact: (check_residue_sound n0 (prim_divide N0 prim d0 (esym nE)) H).
- by apply/eqP; rewrite mulf_neq0 ?invr_neq0 //; apply/eqP/(check_splitting_sound N0 prim H).
Qed.

Lemma check_zero_sound l ev : check_zero l ev -> total e l = 0.
Proof. by case/andP=> z /check_sound; rewrite z. Qed.

Lemma check_nonzero_sound l ev : check_nonzero l ev -> total e l <> 0.
Proof. by case/andP=> /negbTE z /check_sound; rewrite z. Qed.

(** ** Lengths *)

Lemma cis_norm t : `|e t| = 1.
Proof.
have : `|e t| ^+ Pos.to_nat (Qden t) = 1.
  rewrite -normrX cis_exp (@cis_whole _ (Qnum t)) ?normr1 //.
  by rewrite positive_nat_Z /Qeq /=; lia.
by move/eqP; rewrite pexpr_eq1 ?normr_ge0 // => [/eqP|]; last lia.
Qed.

Lemma cis_conj t : (e t)^* = e (- t)%q.
Proof.
apply: (mulfI (cis_neq0 t)); rewrite -normCK cis_norm expr1n mulrC cis_opp //.
Qed.

Lemma number_conj q : (number F q)^* = number F q.
Proof. by rewrite /number rmorphM fmorphV !rmorph_int. Qed.

Lemma total_cat l m : total e (l ++ m) = total e l + total e m.
Proof. by rewrite /total big_cat. Qed.

Lemma total_square sign l : total e (square sign l) = (int_of_Z sign)%:~R * `|total e l| ^+ 2.
Proof.
rewrite normCK /total /square big_flatten big_map rmorph_sum big_distrlr mulr_sumr; apply: eq_bigr => v _.
rewrite big_map mulr_sumr; apply: eq_bigr => u _ /=.
rewrite (cis_add e v.1 (- u.1)%q) -cis_conj !numberM number_Z rmorphM number_conj /=.
by rewrite -!mulrA; congr (_ * (_ * (_ * _))); rewrite [RHS]mulrCA; congr (_ * _); rewrite mulrCA.
Qed.

Lemma total_squares E q k :
  total e (squares E q k) = `|vector e E (q Direct) k| ^+ 2 - `|vector e E (q Reverse) k| ^+ 2.
Proof. by rewrite total_cat !total_square mul1r mulN1r. Qed.

Lemma equal_squares (x y : F) : (`|x| ^+ 2 - `|y| ^+ 2 == 0) = (`|x| == `|y|).
Proof. by rewrite subr_eq0 eqr_expn2 ?normr_ge0. Qed.

End Circle.

(** * What a file on an engine proves with *)

Section Verdicts.
Variables (F : numClosedFieldType) (e : circle F) (E : engine).

Theorem vanishes q k ev : check_zero (vectors E q k) ev = true -> vector e E q k = 0.
Proof. exact: check_zero_sound. Qed.

Theorem is_left q k ev : check_nonzero (vectors E q k) ev = true -> vector e E q k <> 0.
Proof. exact: check_nonzero_sound. Qed.

(* Planar: the resultant swings along a line. *)
Theorem equal_lengths q k ev : check_zero (squares E q k) ev = true ->
  `|vector e E (q Direct) k| = `|vector e E (q Reverse) k|.
Proof. by move/(check_zero_sound e); rewrite total_squares => /eqP; rewrite equal_squares => /eqP. Qed.

(* Elliptical. *)
Theorem unequal_lengths q k ev : check_nonzero (squares E q k) ev = true ->
  `|vector e E (q Direct) k| <> `|vector e E (q Reverse) k|.
Proof. by move/(@check_nonzero_sound F e)/eqP; rewrite total_squares equal_squares => /eqP. Qed.

(** ** Every order by one period *)

Lemma no_masses q first k : pistons_alone E q first -> Z.le first k ->
  [seq (angle t, turning_weight E q t) | t <- turning_masses E & takes_part q k t] = [::].
Proof.
have none (p : pred turning_mass) : all p (turning_masses E) -> (forall t, p t -> takes_part q k t = false) ->
    [seq (angle t, turning_weight E q t) | t <- turning_masses E & takes_part q k t] = [::].
  by move=> ps H; rewrite (filter_none ps).
rewrite /pistons_alone; case: (q) none => [s|s|] none.
- case/andP => /Z.leb_spec0 first2 slow k_first; apply: (none _ slow) => t /Z.leb_spec0 t1.
  by rewrite /takes_part; case: Z.eqb_spec => //; lia.
- case/andP => /Z.leb_spec0 first2 slow k_first; apply: (none _ slow) => t /Z.leb_spec0 t1.
  by rewrite /takes_part; case: Z.eqb_spec => //; lia.
- by move=> _ _; apply: (none predT) => [|t _]; [exact: all_predT | rewrite /takes_part andbF].
Qed.

Lemma vectors_period q first k r period : pistons_alone E q first -> Z.le first k -> Z.le first r ->
  Z.modulo (Z.sub k r) period = Z0 -> Z.lt 0 period ->
  all (fun c => is_whole period (throw c) && is_whole period (bank c)) (cylinders E) ->
  vector e E q k = vector e E q r.
Proof.
move=> alone k1 r1 kr period0 whole.
rewrite /vector /vectors !(no_masses alone) //; rewrite !cats0 /total !big_map; apply: (eq_sum_all whole) => c.
case/andP=> /is_whole_times wt /is_whole_times wb /=; congr (_ * _).
have [i iE] : exists i, Z.sub k r = Z.mul i period.
  by exists (Z.div (Z.sub k r) period); have := Z.div_mod (Z.sub k r) period; lia.
have kE : (inject_Z k == inject_Z r + inject_Z i * inject_Z period)%q.
  by rewrite -inject_Z_mult -inject_Z_plus -iE; have -> : Z.add r (Z.sub k r) = k by lia.
have wt' : (inject_Z i * (inject_Z period * throw c) == inject_Z (Z.mul i (times period (throw c))))%q by rewrite wt inject_Z_mult.
have wb' : (inject_Z i * (inject_Z period * bank c) == inject_Z (Z.mul i (times period (bank c))))%q by rewrite wb inject_Z_mult.
set a := Z.mul i (times _ (throw c)) in wt'; set b := Z.mul i (times _ (bank c)) in wb'.
have D x y : (inject_Z (Z.sub x y) == inject_Z x - inject_Z y)%q.
  by rewrite /Z.sub inject_Z_plus inject_Z_opp; ring.
have S j : (inject_Z (Z.sub j 1) == inject_Z j - 1)%q by exact: D.
have P j : (inject_Z (Z.add j 1) == inject_Z j + 1)%q by rewrite inject_Z_plus; apply: Qeq_refl.
by case: q {alone} => [[]|[]|] /=; [apply: (@cis_eq _ _ _ _ (Z.sub a b)) | apply: (@cis_eq _ _ _ _ (Z.sub b a))
  | apply: (@cis_eq _ _ _ _ (Z.sub a b)) | apply: (@cis_eq _ _ _ _ (Z.sub b a)) | apply: (@cis_eq _ _ _ _ (Z.sub a b))];
  rewrite ?S ?P kE D -wt' -wb'; ring.
Qed.

Lemma check_period_sound q step modulus residues evs k : check_period E q step modulus residues k evs ->
  forall i, (i < size evs)%N -> let r := Z.add k (Z.mul step (Z.of_nat i)) in
  vector e E q r <> 0 <-> Z.modulo r modulus \in residues.
Proof.
elim: evs k => [|ev evs IH] k //= /andP[/andP[ok res] rest] [|i] i_lt.
  have -> : Z.add k (Z.mul step (Z.of_nat 0)) = k by lia.
  have := @check_sound F e _ _ ok; rewrite -/(vector e E q k).
  by case: (claims_zero ev) res; case: (Z.modulo k modulus \in residues) => // _ v; split.
have := IH _ rest i i_lt; have -> // : Z.add (Z.add k step) (Z.mul step (Z.of_nat i)) = Z.add k (Z.mul step (Z.of_nat i.+1)) by lia.
Qed.

(** Each of these orders is left where it is one of the residues, whatever its size. *)
Theorem every_order q step first modulus residues evs : check_every E q step first modulus residues evs = true ->
  forall k, Z.le first k -> Z.modulo (Z.sub k first) step = Z0 -> vector e E q k <> 0 <-> Z.modulo k modulus \in residues.
Proof.
case/andP => /andP[/andP[/andP[/andP[/andP[alone /Z.ltb_spec0 step0] /Z.ltb_spec0 m0] /Z.ltb_spec0 period0] /Z.eqb_spec div] whole] ok k k_first k_step.
set period := Z.mul step _ in period0 div whole.
have kd := Z.div_mod (Z.sub k first) step ltac:(lia); rewrite k_step in kd.
have size0 : Z.lt 0 (Z.of_nat (size evs)) by nia.
pose i := Z.modulo (Z.div (Z.sub k first) step) (Z.of_nat (size evs)).
have ib := Z.mod_pos_bound (Z.div (Z.sub k first) step) _ size0; rewrite -/i in ib.
have id := Z.div_mod (Z.div (Z.sub k first) step) (Z.of_nat (size evs)) ltac:(lia); rewrite -/i in id.
set j := Z.div (Z.div (Z.sub k first) step) _ in id.
have i_lt : (Z.to_nat i < size evs)%N by lia.
have /= := check_period_sound ok i_lt; rewrite Z2Nat.id; last lia.
set r := Z.add first _; have kr : Z.sub k r = Z.mul j period by rewrite /r /period; nia.
have <- : vector e E q k = vector e E q r.
  by apply: (@vectors_period _ first _ _ period) => //; rewrite ?kr ?Z.mod_mul //; rewrite /r; nia.
have [c pE] : exists c, period = Z.mul c modulus.
  by exists (Z.div period modulus); have := Z.div_mod period modulus; lia.
suff -> : Z.modulo k modulus = Z.modulo r modulus by [].
have -> : k = Z.add r (Z.mul (Z.mul j c) modulus) by rewrite -Z.mul_assoc -pE; lia.
by rewrite Z.mod_add //; lia.
Qed.

(* The even orders of force and moment, and all orders of the torque, as firing stars have them. *)
Theorem every_even_order q modulus residues evs : check_every E q 2 2 modulus residues evs = true ->
  forall k, Z.le 2 k -> Z.modulo k 2 = Z0 -> vector e E q k <> 0 <-> Z.modulo k modulus \in residues.
Proof. by move/every_order => H k k2 even; apply: H => //; rewrite Zminus_mod even. Qed.

Theorem every_torque_order modulus residues evs : check_every E Torque 1 1 modulus residues evs = true ->
  forall k, Z.le 1 k -> vector e E Torque k <> 0 <-> Z.modulo k modulus \in residues.
Proof. by move/every_order => H k k1; apply: H => //; rewrite Z.mod_1_r. Qed.

End Verdicts.
