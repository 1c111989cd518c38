(* What is said of an engine?  Definitions only: who reads a theorem of a file on an engine has to trust these lines. *)
From Coq Require Import ZArith QArith List.
From mathcomp Require Import all_ssreflect all_algebra ssrZ.
Delimit Scope Q_scope with q.
Set Implicit Arguments. Unset Strict Implicit. Unset Printing Implicit Defensive.
Import GRing.Theory.

(** * An engine, in rational numbers *)

(* Angles in turns, seen from the free end, anticlockwise; lengths and masses in units that the engine shares. *)
Record cylinder := Cylinder {
  throw : Q;      (* where the crankpin stands, beta *)
  bank : Q;       (* where the cylinder axis points, alpha *)
  position : Q;   (* along the crankshaft, z *)
  mass : Q;       (* reciprocating *)
  radius : Q      (* of the crank *)
}.

Inductive sense := Direct | Reverse.    (* with the crank, against it *)

(* A mass that turns at [order] times the speed of the crank: a counterweight, a crankpin, a balancer shaft. *)
Record turning_mass := TurningMass {
  order : Z;
  turns : sense;
  place : Q;          (* along the crankshaft *)
  angle : Q;          (* its direction while the crank is at 0 *)
  mass_radius : Q
}.

Record engine := Engine {
  plane : Q;          (* that moments are taken about *)
  cylinders : list cylinder;
  turning_masses : list turning_mass
}.

(* The cylinders and masses of an engine that stand before one number of the motion, where rods differ. *)
Definition part_of (E : engine) (of_cylinders of_turning_masses : list bool) : engine :=
  Engine (plane E) (mask of_cylinders (cylinders E)) (mask of_turning_masses (turning_masses E)).

(** * The vectors of an order *)

Inductive quantity := Force (s : sense) | Moment (s : sense) | Torque.

Local Open Scope Q_scope.

Definition lever (E : engine) (q : quantity) (z : Q) : Q :=
  match q with Force _ => 1 | Moment _ => z - plane E | Torque => 1 end.

Definition cylinder_angle (q : quantity) (k : Z) (c : cylinder) : Q :=
  match q with
  | Force Direct | Moment Direct => inject_Z k * throw c - inject_Z (k - 1) * bank c
  | Force Reverse | Moment Reverse => inject_Z (k + 1) * bank c - inject_Z k * throw c
  | Torque => inject_Z k * (throw c - bank c)
  end.

Definition cylinder_weight (E : engine) (q : quantity) (c : cylinder) : Q :=
  match q with
  | Torque => mass c * radius c * radius c
  | _ => mass c * radius c * lever E q (position c)
  end.

Definition same_sense (s t : sense) : bool :=
  match s, t with Direct, Direct | Reverse, Reverse => true | _, _ => false end.

Definition takes_part (q : quantity) (k : Z) (t : turning_mass) : bool :=
  Z.eqb (order t) k && match q with Force s | Moment s => same_sense s (turns t) | Torque => false end.

Definition turning_weight (E : engine) (q : quantity) (t : turning_mass) : Q :=
  inject_Z (2 * order t * order t) * mass_radius t * lever E q (place t).

(* Angle and weight of each vector of order k. *)
Definition vectors (E : engine) (q : quantity) (k : Z) : list (Q * Q) :=
  [seq (cylinder_angle q k c, cylinder_weight E q c) | c <- cylinders E]
  ++ [seq (angle t, turning_weight E q t) | t <- turning_masses E & takes_part q k t].

(** * Their sum *)

Local Close Scope Q_scope.
Local Open Scope ring_scope.

Section Sum.
(* The complex numbers, or any other algebraically closed field with a norm. *)
Variable F : numClosedFieldType.

(* cis t = exp(2 pi i t) is such a function on the rational turns; nothing else about it is used. *)
Record circle := Circle {
  cis :> Q -> F;
  cis_add : forall s t, cis (s + t)%q = cis s * cis t;
  cis_one : forall t, cis t = 1 <-> exists n : Z, (t == inject_Z n)%q
}.

Definition number (q : Q) : F := (int_of_Z (Qnum q))%:~R / (int_of_Z (Zpos (Qden q)))%:~R.

Definition total (e : circle) (l : seq (Q * Q)) : F := \sum_(v <- l) number v.2 * e v.1.

(* The vector of order k, but for the factor c_k of the motion (1 in order 1) that all cylinders share. *)
Definition vector (e : circle) (E : engine) (q : quantity) (k : Z) : F := total e (vectors E q k).

(** * The shaking force itself, at the crank angle theta *)

Definition cosine (e : circle) (t : Q) : F := (e t + e (- t)%q) / 2%:R.

Definition turned (s : sense) (t : Q) : Q := match s with Direct => t | Reverse => (- t)%q end.

Definition shaking (e : circle) (E : engine) (arm : Q -> Q) (k : Z) (theta : Q) : F :=
  \sum_(c <- cylinders E)
    number (mass c * radius c * arm (position c))%q * cosine e (inject_Z k * (theta + (throw c - bank c)))%q * e (bank c)
  + \sum_(t <- turning_masses E | Z.eqb (order t) k)
    number (inject_Z (order t * order t) * mass_radius t * arm (place t))%q * e (angle t + turned (turns t) (inject_Z k * theta))%q.

Definition shaking_force e E k theta := shaking e E (fun=> 1%q) k theta.
Definition shaking_moment e E k theta := shaking e E (fun z => (z - plane E)%q) k theta.

End Sum.
