//! Which torque do the teeth of gears hand on?

use num_complex::Complex;

use super::{Excitation, Train};

/// The torque with which the first disc of each gear drives the second, as the first one feels it; the second feels it over the ratio of the
/// gear. From the twists and the torques in the links.
///
/// The teeth do not give way, so that no stiffness tells it. What is cut off at the gear tells it: a disc needs
/// `(iΩc − Ω²J) Θ`, less the torque on it, and what its shafts take; ν times that, summed over the discs that turn with the second one.
pub fn mesh_torques(
    train: &Train,
    excitation: &Excitation,
    twists: &[Complex<f64>],
    links: &[Complex<f64>],
) -> Vec<Complex<f64>> {
    let Excitation { omega, torques } = excitation;
    let needs = |disc: usize| {
        let own = &train.discs[disc];
        let moved = Complex::new(-omega * omega * own.inertia, omega * own.damping) * twists[disc];
        let taken = train.links.iter().zip(links).map(|(link, torque)| match link.ends {
            [from, _] if from == disc => *torque,
            [_, to] if to == disc => -torque,
            _ => Complex::default(),
        });
        (moved - torques.get(disc).copied().unwrap_or_default() + taken.sum::<Complex<f64>>()) * own.ratio
    };
    let of_gear = |cut: usize| {
        let [first, second] = train.gears[cut];
        let mut behind = vec![second];
        let mut at = 0;
        while let Some(&disc) = behind.get(at) {
            let others = train.gears.iter().enumerate().filter(|(gear, ends)| *gear != cut && ends.contains(&disc));
            let new: Vec<usize> = others.flat_map(|(_, ends)| *ends).filter(|end| !behind.contains(end)).collect();
            behind.extend(new);
            at += 1;
        }
        behind.into_iter().map(needs).sum::<Complex<f64>>() / train.discs[first].ratio
    };
    (0..train.gears.len()).map(of_gear).collect()
}
