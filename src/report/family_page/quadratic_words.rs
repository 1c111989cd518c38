//! How is it put for which φ and δ three classes of parts cancel?

use super::super::typeset;
use super::circle_words::{self, none_of};
use super::plane_words::{irrational, so};
use super::unknowns::{alternatives, names, near, zero_where};
use crate::exact::Turn;
use crate::family::{Place, Quadratic, Root, Roots, is_in_range};
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
    let [u, v] = names([&found.u, &found.v]);
    let rational = found.rational().flat_map(|(at, roots)| {
        let own = Place::exact(&found.u, at);
        let is_meant = |root: &&Root| {
            let other = match root {
                Root::Exact(turn, _) => Place::exact(&found.v, turn.turns()),
                Root::Near(degrees) => Place::near(&found.v, *degrees),
            };
            is_in_range(&[own.clone(), other])
        };
        let at = Text::label(format!("{u} ≡ {}", typeset::angle(&Turn::new(at.clone()))));
        let with = |root: &Root| {
            let v = match root {
                Root::Exact(turn, _) => Text::label(format!("{v} ≡ {}", typeset::angle(turn))),
                Root::Near(degrees) => near(&v, *degrees),
            };
            Text::joined([at.clone(), v], " and ")
        };
        match roots {
            Roots::All(_) if is_in_range(std::slice::from_ref(&own)) => vec![at.clone()],
            Roots::All(_) => Vec::new(),
            Roots::None(_) => Vec::new(),
            Roots::One { at, .. } => [at].into_iter().filter(is_meant).map(with).collect(),
            Roots::Mirror { at, .. } => at.iter().filter(is_meant).map(with).collect(),
        }
    });
    alternatives(rational.chain(irrational(found.irrational(), [&found.u, &found.v])))
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
    let arcs = match found.twist {
        Some(_) => text::twisted(u.clone(), circle.arcs.len(), v),
        None => text::resultant((circle.polynomial.degree() / 2).to_string(), u.clone(), circle.arcs.len(), v),
    };
    Text::joined([lead, arcs, so(circle, zeros(found), &u)], " ")
}
