//! How is it put for which φ and δ three classes of parts cancel?

use super::super::typeset;
use super::circle_words::{self, none_of};
use super::plane_words::{irrational, so};
use super::unknowns::{alternatives, names, near, zero_where};
use crate::exact::Turn;
use crate::family::{Place, Quadratic, Root, Roots, is_in_range};
use crate::page::{Text, phrase};

/// `0 where δ ≡ 90° and φ ≡ 60°, or δ ≡ 180°`.
pub(super) fn condition(found: &Quadratic) -> Text {
    let [u, v] = names([&found.u, &found.v]);
    if found.is_mirrored() {
        return phrase!("0 on a curve: at two, one or no {} for each {}", v, u);
    }
    if found.is_curve() {
        return phrase!("0 on a curve: at one {} for nearly each {}", v, u);
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
    let lead = phrase!(
        "The parts make three classes: {} turns the parts of each, {} turns the second class against the first, and the third as much against \
         the second.",
        u.clone(),
        v.clone()
    );
    if found.is_mirrored() {
        let mirrored = phrase!(
            "Call them A, B and C. A and C are equally long for every {}, and the condition that follows from this always holds (proved; theory, \
             section 17), so that each has two {}, one or none, as 4|A|² − |B|² is positive, zero or negative, and where A = C = 0 all or none, \
             as B = 0 or not.",
            u,
            v
        );
        return Text::joined([lead, mirrored], " ");
    }
    if found.is_curve() {
        let curve = phrase!(
            "Call them A, B and C, D = |A|² − |C|² and E the product of B with the conjugate of A, less that of C with the conjugate of B. D² = |E|² \
             for every {} (proved), so that each at which A and C differ in length has one {}, which turns by −D/E; where they do not, it has \
             two, one or none, as 4|A|² − |B|² is positive, zero or negative, and where A = C = 0 all or none, as B = 0 or not.",
            u,
            v
        );
        return Text::joined([lead, curve], " ");
    }
    let Some(circle) = &found.circle else {
        let never = "A real polynomial that vanishes where they cancel (theory, section 17) is constant and not zero (proved), so they never \
                     cancel.";
        return Text::joined([lead, never.into()], " ");
    };
    if found.twist.is_some() {
        let twist = phrase!(
            "Call them A, B and C, and E the product of B with the conjugate of A, less that of C with the conjugate of B. A and C are equally long for every {} (proved), so that they cancel only where E vanishes; the circle is divided into {} arcs, and each shows how often it does there (proved; theory, section 17). At each such angle there are two {}, one or none, as 4|A|² − |B|² is positive, zero or negative (proved), and where A = C = 0 all or none, as B = 0 or not.",
            u.clone(),
            circle.arcs.len(),
            v
        );
        return Text::joined([lead, twist, so(circle, zeros(found), &u)], " ");
    }
    let arcs = phrase!(
        "Where they cancel, a real polynomial of degree {} in the turn by {} vanishes (theory, section 17); the circle is divided into {} arcs, and each shows how often it does there (proved). For each such angle there is one {} if first and third class differ in length, and none, one or two if they do not.",
        (circle.polynomial.degree() / 2).to_string(),
        u.clone(),
        circle.arcs.len(),
        v
    );
    Text::joined([lead, arcs, so(circle, zeros(found), &u)], " ")
}
