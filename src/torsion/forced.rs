//! How far does an exciting torque twist the shaft? Without damping, away from the natural frequencies.

use num_complex::Complex;

use super::Shaft;

/// Torques on the discs at one frequency, `Re(torque · e^{iωt})` each.
#[derive(Clone, Debug, PartialEq)]
pub struct Excitation {
    /// Angular frequency in radians a second, above 0.
    pub omega: f64,
    /// On each disc, in N m.
    pub torques: Vec<Complex<f64>>,
}

/// The twist of each disc in radians, `Re(twist · e^{iωt})`: `(K − ω²J) Θ = M`, solved from one end to the other.
///
/// Rows are exchanged where that is more stable. At a natural frequency there is no finite answer, and what is not a number
/// comes out.
pub fn forced_twist(shaft: &Shaft, excitation: &Excitation) -> Vec<Complex<f64>> {
    let count = shaft.inertias.len();
    let square = excitation.omega * excitation.omega;
    let spring = |index: usize| shaft.stiffnesses.get(index).copied().unwrap_or(0.0);
    // Each row has its diagonal and two entries behind it; the second fills where rows are exchanged.
    let mut rows: Vec<[f64; 3]> = (0..count)
        .map(|disc| {
            let behind = if disc == 0 { 0.0 } else { spring(disc - 1) };
            [behind + spring(disc) - square * shaft.inertias[disc], -spring(disc), 0.0]
        })
        .collect();
    let mut right = excitation.torques.clone();
    right.resize(count, Complex::default());
    for disc in 0..count.saturating_sub(1) {
        let mut below = [-spring(disc), rows[disc + 1][0], rows[disc + 1][1]];
        if below[0].abs() > rows[disc][0].abs() {
            std::mem::swap(&mut below, &mut rows[disc]);
            right.swap(disc, disc + 1);
        }
        let factor = below[0] / rows[disc][0];
        rows[disc + 1] = [below[1] - factor * rows[disc][1], below[2] - factor * rows[disc][2], 0.0];
        let above = right[disc];
        right[disc + 1] -= above * factor;
    }
    let mut twist = vec![Complex::default(); count];
    for disc in (0..count).rev() {
        let at = |index: usize| twist.get(index).copied().unwrap_or_default();
        twist[disc] = (right[disc] - at(disc + 1) * rows[disc][1] - at(disc + 2) * rows[disc][2]) / rows[disc][0];
    }
    twist
}
