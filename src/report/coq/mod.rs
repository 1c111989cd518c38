//! What does `classify --format coq` write? The verdicts on an engine as theorems of Coq, which `formal/Checker.v` proves.

mod engine;
mod every_order;
mod evidence;
mod exact;
mod firing;
mod not_stated;
mod parts;
mod real;
mod theorem;
mod theorems;

use self::every_order::Pattern;
use self::parts::Parts;
use self::theorem::Theorem;
use crate::proof::Document;
use crate::text::coq_comment;

pub use firing::coq_file_of_firing;
pub use not_stated::NotStated;

/// A file that Coq compiles beside those of `formal/`: the engine in rational numbers, a theorem for each verdict, and for each shape
/// that has evidence; with statements on every order, those too. From them follow theorems on the force itself, over the real numbers.
///
/// # Errors
/// What the engine has that the file cannot state.
pub fn coq_file(document: &Document) -> Result<String, NotStated> {
    let parts = Parts::of(document);
    file(&head(document), document, &parts, &Pattern::all(document, &parts))
}

/// The file below a comment that is open.
fn file(head: &str, document: &Document, parts: &Parts, every: &[Pattern]) -> Result<String, NotStated> {
    not_stated::check(document)?;
    let vectors = theorems::theorems(document, parts, every)?;
    let mut real = real::theorems(document, parts, every);
    real.extend(exact::theorem(document));
    let engine = engine::definition(document) + &parts.definitions(document);
    let mut text = format!("{head}{WRITTEN}\n{engine}\n{SECTION}\n{}", texts(&vectors));
    text.push_str(&format!(
        "End Verdicts.\n\n(* All of them; none may rest on an axiom. *)\n{}",
        all("verdicts", &vectors)
    ));
    if !real.is_empty() {
        text.push_str(&format!("\n{}\n{}{AXIOMS}{}", real::HEAD, texts(&real), all("forces", &real)));
    }
    Ok(text)
}

fn texts(theorems: &[Theorem]) -> String {
    theorems.iter().map(|theorem| format!("{}\n", theorem.text)).collect()
}

/// All theorems as one, whose axioms are printed.
fn all(name: &str, theorems: &[Theorem]) -> String {
    let names: Vec<String> = theorems.iter().map(|theorem| format!("  {}", theorem.name)).collect();
    format!("Definition {name} :=\n  (\n{}).\nPrint Assumptions {name}.\n", names.join(",\n"))
}

/// What stands before the theorems: any field of complex numbers, and the circle in it.
const SECTION: &str = "\
Section Verdicts.
(* Of the function t |-> exp(2 pi i t) on the rational turns only this is used: it takes sums to products, and it is 1 at whole turns
   alone. *)
Variables (F : numClosedFieldType) (e : circle F).
";

const AXIOMS: &str = "(* They rest on the four axioms of the real numbers that formal/README.md names. *)\n";

const WRITTEN: &str = "

   Written by crankstar classify --format coq. Compile with formal/ of crankstar: coqc -Q formal Crankstar THIS.v
   First the sums of vectors, then what they make of the real numbers. formal/Engine.v says what the words mean. *)
From Coq Require Import ZArith QArith.
From mathcomp Require Import all_ssreflect all_algebra ssrZ.
From Crankstar Require Import Sums Splitting Engine Checker EveryOrder.
Local Open Scope Z_scope.
";

fn head(document: &Document) -> String {
    format!(
        "(* {}: verdicts on {}, each a theorem.

   The sums of the vectors of an order are without the number c_k of the motion that all their cylinders share (1 in order 1 and 0 in odd
   orders above 1, of rods without offset); the force has that number.",
        coq_comment(&document.title),
        document.masses.name()
    )
}
