//! What is said of what moves the pistons: of rods, with and without an offset, and of links on a master rod?
//!
//! A new mechanism has its sentences here; where they stand on a page is not its matter.

use crate::engine::{Cylinder, Engine, Rods};
use crate::page::Text;

/// What the verdicts rest on.
pub(super) fn assumed(engine: &Engine) -> Text {
    if engine.has_links() {
        return Text::from(ARTICULATED).and(" ").and(if engine.is_centric() {
            CENTRIC_ORDERS
        } else {
            ORDERS_OF_CORRECTED
        });
    }
    let unequal = engine.mechanisms().len() > 1;
    let orders = match (engine.faster_crank().is_some(), engine.has_odd_orders()) {
        (true, true) => EVERY_OWN_ORDER,
        (true, false) => CENTRIC_OWN_ORDERS,
        (false, true) => EVERY_ORDER,
        (false, false) if engine.has_offset() => INCLINED,
        (false, false) if unequal => CENTRIC_ORDERS,
        (false, false) => return ASSUMED.into(),
    };
    Text::from(RIGID).and(if unequal { RODS_DIFFER } else { "" }).and(" ").and(orders)
}

const RIGID: &str = "Assumed: a rigid crankshaft at constant speed, rods in the plane of their cylinder; in a radial all rods on the crankpin itself.";
const ARTICULATED: &str = "Assumed: a rigid crankshaft at constant speed, rods in the plane of their cylinder, each rod as two masses, links on the master rod as the layout file says.";
const RODS_DIFFER: &str = " The rods or their offsets differ: cylinders in which both are equal are decided together, since only they have the same coefficient $c_k$.";
const EVERY_ORDER: &str = "The cylinder axes miss the crankshaft, so that every order exists.";
const EVERY_OWN_ORDER: &str =
    "The cylinder axes miss the crankshaft, so that every order of each crankshaft exists, multiplied by its speed.";
const CENTRIC_OWN_ORDERS: &str =
    "Orders of centric cranks are 1 and the even ones, multiplied by the speed of their crankshaft.";
const ORDERS_OF_CORRECTED: &str = "Knuckle angles are corrected, so that every order may exist.";
const INCLINED: &str = "Cylinder axes miss the crankshaft, but their rods are infinitely long: their pistons have order 1 alone. Others have 1 and the even ones.";
const CENTRIC_ORDERS: &str = "Orders of a centric engine are 1 and the even ones.";

/// The same of equal centric rods.
pub(super) const ASSUMED: &str = "Assumed: a rigid crankshaft at constant speed, equal rods and no pin offset, rods in the plane of their cylinder; in a radial all rods on the crankpin itself. Orders of a centric engine are 1 and the even ones.";

/// What rows count in that name more than orders and cylinders, for those that the engine has.
pub(super) fn rows(engine: &Engine) -> Vec<&'static str> {
    let of_engine = || engine.cylinders().iter().filter_map(Cylinder::link);
    let plain = of_engine().any(|link| !link.is_corrected()).then_some(LINKS);
    let offsets = (engine.has_offset() && engine.mechanisms().len() > 1).then_some(OFFSETS);
    plain.into_iter().chain(engine.has_corrected_links().then_some(CORRECTED)).chain(offsets).collect()
}

const LINKS: &str = "Rows that name Δ belong to links on a master rod: their unit has $g_k$ in place of $c_k$.";

const CORRECTED: &str = "Rows that name ε are about links with a corrected knuckle angle: they count in the real part (Re) or the imaginary part (Im) of $h_k$ where others count in $c_k$, and rows of order 1 without it in m r ω².";

const OFFSETS: &str = "With unequal rods order 1 is multiplied by 1 and, with a pin offset, by the imaginary part of $c_1$, whose real part is 1 for every rod: rows of order 1 that name it (Im) count in m r ω² Im $c_1$, the others in m r ω².";

/// Why an order is made of several sums, in a plain sentence.
pub(super) fn why_several(engine: &Engine) -> Text {
    match (engine.has_links(), engine.has_offset(), engine.faster_crank().is_some()) {
        (true, ..) => {
            "A piston on a link moves differently from the master piston: each kind of link has its own coefficient.".into()
        }
        (false, true, _) => {
            "The cylinder axes miss the crankshaft: cylinders with different rods or offsets have different coefficients."
                .into()
        }
        (false, false, true) => "The crankshafts turn at different speeds: each has its own coefficients.".into(),
        (false, false, false) if engine.mechanisms().len() > 1 => {
            "The rods differ: cylinders with different rods have different coefficients.".into()
        }
        (false, false, false) => "The pistons have the coefficient $c_k$ of their rods; rotating masses have none.".into(),
    }
}

/// Where crankpins and cylinders stand.
pub(super) fn centres(engine: &Engine) -> &'static str {
    match (engine.only_rods(), engine.has_offset()) {
        (Err(_), _) => LINKED,
        (Ok(()), true) => ALIGNED,
        (Ok(()), false) => CENTRES,
    }
}

const ALIGNED: &str = "Crankpin j is at θ + β, the axis of cylinder j points to α; they are in line where θ + β = α. An offset e moves the top dead centre to arcsin(e/(r + l)) after that.";
const LINKED: &str = "Crankpin j is at θ + β, the axis of cylinder j points to α; they are in line where θ + β = α: the top dead centre of a master piston. That of a piston on a link may be beside it.";
const CENTRES: &str =
    "Crankpin j is at θ + β, the axis of cylinder j points to α; its piston is at top dead centre where θ + β = α.";

/// Where the crank angle of a cylinder is 0.
pub(super) fn counted_from(engine: &Engine) -> &'static str {
    if engine.has_offset() || engine.only_rods().is_err() { FROM_ALIGNMENT } else { FROM_TOP }
}

const FROM_TOP: &str = "crank angle of a cylinder, 0 at top dead centre";
const FROM_ALIGNMENT: &str = "crank angle of a cylinder, 0 where its crankpin is in line with the axis";

/// The formulas of the motion of a piston with what they say, in TeX.
pub(super) fn motion(engine: &Engine) -> Vec<(&'static str, String)> {
    let offset = engine.has_offset();
    let root = if offset { "(\\lambda\\sin\\psi - \\delta)^2" } else { "\\lambda^2\\,{\\sin}^2\\psi" };
    vec![
        (
            "The position of a piston along its axis, from the centre of the crankshaft, is",
            format!("s(\\psi) = r\\cos\\psi + l\\sqrt{{1 - {root}}}, \\qquad \\psi = \\theta + \\beta - \\alpha"),
        ),
        (
            "Its inertia force, outward positive, is",
            "-m\\,\\ddot s = m\\,r\\,\\omega^2\\, \\mathrm{Re} \\sum_{k\\ge1} c_k\\, e^{ik\\psi}".to_owned(),
        ),
        (
            match offset {
                true => "With an offset every order has a coefficient, real for even k and imaginary for odd k but for the 1 of the first:",
                false => "Without an offset the coefficients are, all terms of a series having one sign,",
            },
            match offset {
                true => "c_k = [k=1] + \\frac{k^2}{\\pi\\lambda} \\int_0^{2\\pi} \\sqrt{1 - (\\lambda\\sin\\psi - \\delta)^2}\\; e^{-ik\\psi}\\, d\\psi".to_owned(),
                false => "\\begin{aligned} c_1 &= 1, \\qquad c_3 = c_5 = \\dots = 0, \\\\ c_{2n} &= 8 n^2 (-1)^n \\sum_{j\\ge n} (-1)^j \\binom{1/2}{j} \\binom{2j}{j-n} \\frac{\\lambda^{2j-1}}{4^{j}} \\end{aligned}".to_owned(),
            },
        ),
    ]
}

/// Whether cranks and rods are drawn to scale.
pub(super) fn scale(engine: &Engine, is_shortened: bool) -> &'static str {
    match engine.all_rods() {
        Rods::Unknown => "The layout gives no rods: they are drawn 3.5 crank radii long.",
        _ if is_shortened => "Rods longer than six crank radii are drawn shorter.",
        _ if engine.has_offset() => "Crank radius, rod length and offset are to scale.",
        Rods::Alike(_) | Rods::Differ | Rods::Without(_) => "Crank radius and rod length are to scale.",
    }
}
