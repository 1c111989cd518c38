//! What does it change that a knuckle pin is elsewhere than at the angle of its cylinder?

use crate::page::Block;

/// What is proved of links with a corrected knuckle angle.
pub(super) fn section() -> [Block; 4] {
    let paragraph = |text: &'static str| Block::Paragraph(text.into());
    [paragraph(MOTION), Block::Formula(HARMONIC.to_owned(), None), paragraph(THEOREM), paragraph(TERMS)]
}

const MOTION: &str = "**Corrected knuckle angles.** Where the table names an ε other than 0 the knuckle pin is not, seen from the crankpin, at the angle of its cylinder, but at $\\gamma = \\Delta + \\varepsilon$ from the master rod on. The master rod, as it tilts, then moves the pin across the axis of that cylinder by more than a sinusoid, and the shaking force of the piston has, with $\\kappa = a/l$,";
const HARMONIC: &str = "c_k = [k=1] \\left(1 + \\tfrac{\\kappa}{2} e^{i(\\Delta-\\varepsilon)} - \\tfrac{\\kappa}{2} e^{i(\\Delta+\\varepsilon)}\\right) + \\tfrac{\\kappa}{2} \\left(e^{i(k\\Delta+\\varepsilon)} + e^{i(k\\Delta-\\varepsilon)}\\right) c_k(\\lambda) + h_k";
const THEOREM: &str = "So every order may exist, odd ones included, and $c_1$ is not 1: order 1 is not that of rods on the crankpin itself. $c_k(\\lambda)$ is that of the master rod, 0 for odd k above 1 and omitted for k = 1. $h_k$ is what the link adds by tilting, a complex number without closed form. It is conjugate for $-\\Delta$ and $-\\varepsilon$, and $(-1)^k$ times itself for $-\\varepsilon$ alone, so that links that are copies or mirror images of each other have its two parts in common, except for signs.";
const TERMS: &str = "Each order is made of exact sums, multiplied by 1, by $c_k(\\lambda)$, and by the real and the imaginary part of each $h_k$: they are decided separately. Where all are zero the order is, proved. No theorem says that a part of $h_k$ is not zero: where a sum that it multiplies remains, bounds from below and above decide, or the order is not decided. Rows that name ε count in the real part (Re) or the imaginary part (Im) of $h_k$ where others count in $c_k$.";

/// On the masses at knuckle pins.
pub(super) const KNUCKLES: &str = "A knuckle pin moves as $(1-\\zeta)$ times the crankpin and $\\zeta$ times the piston pin of the master, $\\zeta = \\kappa e^{i(\\Delta+\\varepsilon)}$. So its mass, with \
                                   the big end of the link, is exactly a mass on each of them: terms of the sums of the master and of what turns with the crank.";
