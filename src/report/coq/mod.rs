//! What does `classify --format coq` write? The verdicts on an engine as theorems of Coq, which `formal/Checker.v` proves.

mod engine;
mod evidence;
mod not_stated;
mod theorem;

use crate::proof::Document;
use crate::text::coq_comment;

pub use not_stated::NotStated;

/// A file that Coq compiles beside those of `formal/`: the engine in rational numbers, a theorem for each verdict, and for each shape
/// that has evidence; with statements on every order, those too.
///
/// # Errors
/// What the engine has that the file cannot state.
pub fn coq_file(document: &Document) -> Result<String, NotStated> {
    not_stated::check(document)?;
    let theorems = theorem::theorems(document)?;
    let mut text = format!("{}\n{}\n{SECTION}\n", head(document), engine::definition(document));
    for theorem in &theorems {
        text.push_str(&format!("{}\n", theorem.text));
    }
    text.push_str("End Verdicts.\n\n(* All of them; none may rest on an axiom. *)\nDefinition verdicts :=\n");
    let names: Vec<String> = theorems.iter().map(|theorem| format!("  {}", theorem.name)).collect();
    text.push_str(&format!("  (\n{}).\nPrint Assumptions verdicts.\n", names.join(",\n")));
    Ok(text)
}

/// What stands before the theorems: any field of complex numbers, and the circle in it.
const SECTION: &str = "\
Section Verdicts.
(* Of the function t |-> exp(2 pi i t) on the rational turns only this is used: it takes sums to products, and it is 1 at whole turns
   alone. *)
Variables (F : numClosedFieldType) (e : circle F).
";

fn head(document: &Document) -> String {
    format!(
        "(* {}: verdicts on {}, each a theorem.

   Written by crankstar classify --format coq. Compile with formal/ of crankstar: coqc -Q formal Crankstar THIS.v
   A theorem is about the sum of the vectors of an order, without the number c_k of the motion that all cylinders share (1 in order 1;
   0 in odd orders above 1 of rods without offset). formal/Engine.v says what its words mean. *)
From Coq Require Import ZArith QArith.
From mathcomp Require Import all_ssreflect all_algebra ssrZ.
From Crankstar Require Import Sums Splitting Engine Checker.
Local Open Scope Z_scope.
",
        coq_comment(&document.title),
        document.masses.name()
    )
}
