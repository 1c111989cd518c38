//! Which formulas do the numbers follow? Numbered on from those of the proofs, alike in every format.

use crate::engine::Engine;
use crate::loads::Loads;
use crate::order::MassGroup;

/// The equations with what they say, in TeX, and their numbers.
pub(super) fn equations(engine: &Engine, loads: &Loads) -> Vec<(&'static str, String, u32)> {
    let offset = engine.has_offset();
    let root = if offset { "(\\lambda\\sin\\psi - \\delta)^2" } else { "\\lambda^2\\,{\\sin}^2\\psi" };
    let mut equations = vec![
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
    ];
    let turning = [MassGroup::Rotating, MassGroup::Crankshaft, MassGroup::Counterweights];
    let has = |wanted: &[MassGroup]| loads.groups.iter().any(|loads| wanted.contains(&loads.group));
    let rotating = if has(&turning) { " + [k=1]\\; 2 \\sum_u \\frac{U_u}{m\\,r}\\, e^{i\\beta_u}" } else { "" };
    equations.push((
        "The rotating vectors of order k are, with the stars of (2) and the arms for the moment W,",
        format!("\\begin{{aligned}} V_k^{{+}} &= \\sum_j \\frac{{m_j\\, r_j}}{{m\\,r}}\\, c_{{k,j}}\\, e^{{i(k\\beta_j - (k-1)\\alpha_j)}}{rotating}, \\\\ V_k^{{-}} &= \\sum_j \\frac{{m_j\\, r_j}}{{m\\,r}}\\, c_{{k,j}}^{{*}}\\, e^{{i(-k\\beta_j + (k+1)\\alpha_j)}} \\end{{aligned}}"),
    ));
    if has(&turning) {
        equations.push((
            "where U is the mass-radius of a mass that turns with the crank, at its angle β; for a rotating mass at a crankpin",
            "U_u = m_{\\mathrm{rot}}\\, r".to_owned(),
        ));
    }
    if has(&[MassGroup::Balancers]) {
        equations.push((
            "A balancer shaft at n times the speed of the crank, with it or against it, with its weight U at the angle γ for θ = 0, adds",
            "\\Delta V_n^{\\pm} = 2 n^2 \\frac{U}{m\\,r}\\, e^{i\\gamma}".to_owned(),
        ));
    }
    equations.push((
        "and the force of order k, with its largest and smallest length,",
        "\\begin{aligned} F_k(\\theta) &= \\tfrac12 K \\left( V_k^{+} e^{ik\\theta} + V_k^{-} e^{-ik\\theta} \\right), \\\\ \\hat F_k,\\ \\check F_k &= \\tfrac12 K \\left|\\, |V_k^{+}| \\pm |V_k^{-}| \\,\\right| \\end{aligned}".to_owned(),
    ));
    if loads.torque.is_some() {
        equations.push((
            "The inertia torque on the crankshaft, positive in its sense of rotation, is",
            "\\begin{aligned} T(\\theta) &= K\\,r\\; \\mathrm{Re} \\sum_k t_k\\, Q_k\\, e^{ik\\theta}, \\\\ Q_k &= \\sum_j \\frac{m_j\\, r_j^2}{m\\,r^2}\\, e^{ik(\\beta_j - \\alpha_j)}, \\qquad \\mathrm{Re} \\sum_k t_k\\, e^{ik\\psi} = -\\frac{s'\\,s''}{r^2} \\end{aligned}".to_owned(),
        ));
    }
    if engine.faster_crank().is_some() {
        equations.push((
            "A crankshaft that turns ν times while the reference turns once adds only to the orders that ν divides, with the factor ν² for its vectors and ν³ for its torque at the reference crankshaft,",
            "\\psi = \\nu\\theta + \\beta - \\alpha, \\qquad V_{\\nu j}^{\\pm} \\mathrel{+}= \\nu^2\\, V_j^{\\pm}, \\qquad t_{\\nu j}\\, Q_{\\nu j} \\mathrel{+}= \\nu^3\\, t_j\\, Q_j".to_owned(),
        ));
    }
    // The proofs hold (1) and (2).
    equations.into_iter().zip(3..).map(|((words, tex), number)| (words, tex, number)).collect()
}
