//! How is it put for which φ and δ three classes of parts cancel?

use super::circle_words::{self, none_of};
use super::coordinate;
use super::plane_words::{irrational, rational, so};
use super::unknowns::{names, zero_where};
use crate::family::Quadratic;
use crate::page::Text;
use crate::report::texts::family as text;

/// `0 where δ ≡ 90° and φ ≡ 60°, or δ ≡ 180°`.
pub(super) fn condition(found: &Quadratic) -> Text {
    let [u, v] = names([&found.u, &found.v]);
    if found.is_mirrored() {
        return text::mirrored_curve(v, u);
    }
    if found.is_curve() {
        return text::nearly_curve(v, u);
    }
    let open = found.circle.iter().flat_map(circle_words::open);
    zero_where(zeros(found), open).unwrap_or_else(|| none_of(found.circle.as_ref()))
}

/// `δ ≡ 90° and φ ≡ 60°, or δ ≡ 180°`; none where no zero is known.
fn zeros(found: &Quadratic) -> Option<Text> {
    let both = [&found.u, &found.v];
    coordinate::in_words(rational(found.rational(), both).chain(irrational(found.irrational(), both)))
}

/// Why it vanishes there, and nowhere else.
pub(super) fn why(found: &Quadratic) -> Text {
    let [u, v] = names([&found.u, &found.v]);
    let lead = text::three_classes(u.clone(), v.clone());
    if found.is_mirrored() {
        return Text::joined([lead, text::mirrored(u, v)], " ");
    }
    if found.is_curve() {
        return Text::joined([lead, text::one_for_nearly_each(u, v)], " ");
    }
    let Some(circle) = &found.circle else {
        return Text::joined([lead, text::never_cancel()], " ");
    };
    let arcs = match found.claim.twist {
        Some(_) => text::twisted(u.clone(), circle.claim.arcs.len(), v),
        None => text::resultant((circle.polynomial.degree() / 2).to_string(), u.clone(), circle.claim.arcs.len(), v),
    };
    Text::joined([lead, arcs, so(circle, zeros(found), &u)], " ")
}
