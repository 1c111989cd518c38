//! Which of two forms would a person rather read? The one with fewer signs, roots, cosines and nested roots.

use super::form::{Form, Root};

/// Printed letters, and more for each root, cosine and nested root, and for each further term beside a cosine.
pub(super) fn of(form: &Form) -> usize {
    let letters = form.to_string().chars().filter(|letter| !matches!(letter, ' ' | '°')).count();
    letters + weights(form)
}

fn weights(form: &Form) -> usize {
    let further = if form.terms().iter().any(|(root, _)| root.has_cosine()) { form.terms().len() - 1 } else { 0 };
    2 * further + form.terms().iter().map(|(root, _)| weight(root)).sum::<usize>()
}

fn weight(root: &Root) -> usize {
    match root {
        Root::One => 0,
        Root::Whole(_) => 3,
        Root::Nested(inside) => 9 + weights(inside),
        Root::Cosine(_) => 2,
        // A power is one cosine to a reader.
        Root::Product(root, cosines) => weight(root) + 2 * cosines.chunk_by(|a, b| a == b).count(),
    }
}
