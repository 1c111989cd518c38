//! Which formulas do the numbers follow? Numbered on from those of the proofs, alike in every format.

use super::super::mechanism_words;
use crate::engine::Engine;
use crate::loads::Loads;
use crate::order::MassGroup;
use crate::page::Text;
use crate::report::texts::loads as text;

/// The equations with what they say, in TeX, and their numbers.
pub(super) fn equations(engine: &Engine, loads: &Loads) -> Vec<(Text, String, u32)> {
    let mut equations = mechanism_words::motion(engine);
    let turning = [MassGroup::Rotating, MassGroup::Crankshaft, MassGroup::Counterweights];
    let has = |wanted: &[MassGroup]| loads.groups.iter().any(|loads| wanted.contains(&loads.group));
    let rotating = if has(&turning) { " + [k=1]\\; 2 \\sum_u \\frac{U_u}{m\\,r}\\, e^{i\\beta_u}" } else { "" };
    equations.push((
        text::rotating_vectors(),
        format!("\\begin{{aligned}} V_k^{{+}} &= \\sum_j \\frac{{m_j\\, r_j}}{{m\\,r}}\\, c_{{k,j}}\\, e^{{i(k\\beta_j - (k-1)\\alpha_j)}}{rotating}, \\\\ V_k^{{-}} &= \\sum_j \\frac{{m_j\\, r_j}}{{m\\,r}}\\, c_{{k,j}}^{{*}}\\, e^{{i(-k\\beta_j + (k+1)\\alpha_j)}} \\end{{aligned}}"),
    ));
    if has(&turning) {
        equations.push((text::turning_mass(), "U_u = m_{\\mathrm{rot}}\\, r".to_owned()));
    }
    if has(&[MassGroup::Balancers]) {
        equations
            .push((text::balancer_shaft(), "\\Delta V_n^{\\pm} = 2 n^2 \\frac{U}{m\\,r}\\, e^{i\\gamma}".to_owned()));
    }
    equations.push((
        text::force(),
        "\\begin{aligned} F_k(\\theta) &= \\tfrac12 K \\left( V_k^{+} e^{ik\\theta} + V_k^{-} e^{-ik\\theta} \\right), \\\\ \\hat F_k,\\ \\check F_k &= \\tfrac12 K \\left|\\, |V_k^{+}| \\pm |V_k^{-}| \\,\\right| \\end{aligned}".to_owned(),
    ));
    if loads.torque.is_some() {
        equations.push((
            text::inertia_torque(),
            "\\begin{aligned} T(\\theta) &= K\\,r\\; \\mathrm{Re} \\sum_k t_k\\, Q_k\\, e^{ik\\theta}, \\\\ Q_k &= \\sum_j \\frac{m_j\\, r_j^2}{m\\,r^2}\\, e^{ik(\\beta_j - \\alpha_j)}, \\qquad \\mathrm{Re} \\sum_k t_k\\, e^{ik\\psi} = -\\frac{s'\\,s''}{r^2} \\end{aligned}".to_owned(),
        ));
    }
    if engine.faster_crank().is_some() {
        equations.push((
            text::faster_crankshaft(),
            "\\psi = \\nu\\theta + \\beta - \\alpha, \\qquad V_{\\nu j}^{\\pm} \\mathrel{+}= \\nu^2\\, V_j^{\\pm}, \\qquad t_{\\nu j}\\, Q_{\\nu j} \\mathrel{+}= \\nu^3\\, t_j\\, Q_j".to_owned(),
        ));
    }
    // The proofs hold (1) and (2).
    equations.into_iter().zip(3..).map(|((words, tex), number)| (words, tex, number)).collect()
}
