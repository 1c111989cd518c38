//! How far does an exciting torque twist the train, how hard are its shafts twisted, and where does the power go? By the equations of theory, section 13.

use num_complex::Complex;

use super::Train;

/// Torques on the discs at one frequency, `Re(torque · e^{iωt})` each.
#[derive(Clone, Debug, PartialEq)]
pub struct Excitation {
    /// Angular frequency in radians a second, above 0.
    pub omega: f64,
    /// On each disc, in N m.
    pub torques: Vec<Complex<f64>>,
}

/// What stands in a row of the equations: a column with its entry each.
type Row = Vec<(usize, Complex<f64>)>;

fn entry(row: &Row, column: usize) -> Complex<f64> {
    row.iter().find(|(at, _)| *at == column).map_or(Complex::default(), |(_, value)| *value)
}

/// The twist of each disc in radians, `Re(twist · e^{iωt})`: `(K(1+iη) + iΩC − Ω²J) Θ = M`, from the ends of the tree inwards.
///
/// Rows are exchanged where that is more stable. At a natural frequency of a train without damping there is no finite answer, and
/// what is not a number comes out.
pub fn forced_twist(train: &Train, excitation: &Excitation) -> Vec<Complex<f64>> {
    let Excitation { omega, torques } = excitation;
    let stiffness = |link: usize| train.links[link].complex_stiffness(*omega) * train.weight(link);
    let count = train.inertias.len();
    let mut rows: Vec<Row> = (0..count)
        .map(|node| {
            let held: Complex<f64> = train.around[node].iter().map(|(_, link)| stiffness(*link)).sum();
            let around = train.around[node].iter().map(|(other, link)| (*other, -stiffness(*link)));
            std::iter::once((node, held - omega * omega * train.inertias[node])).chain(around).collect()
        })
        .collect();
    let mut right = vec![Complex::default(); count];
    for (index, disc) in train.discs.iter().enumerate() {
        let node = train.node(index);
        rows[node][0].1 += Complex::new(0.0, omega * disc.damping * disc.ratio * disc.ratio);
        right[node] += torques.get(index).copied().unwrap_or_default() * disc.ratio;
    }
    for &node in &train.order {
        let Some((parent, _)) = train.parents[node] else { continue };
        if entry(&rows[parent], node).norm() > entry(&rows[node], node).norm() {
            rows.swap(parent, node);
            right.swap(parent, node);
        }
        let factor = entry(&rows[parent], node) / entry(&rows[node], node);
        let pivot = rows[node].clone();
        rows[parent].retain(|(column, _)| *column != node);
        for (column, value) in pivot.into_iter().filter(|(column, _)| *column != node) {
            match rows[parent].iter_mut().find(|(at, _)| *at == column) {
                Some((_, entry)) => *entry -= factor * value,
                None => rows[parent].push((column, -factor * value)),
            }
        }
        let above = right[node];
        right[parent] -= factor * above;
    }
    let mut twist: Vec<Complex<f64>> = vec![Complex::default(); count];
    for &node in train.order.iter().rev() {
        let known = rows[node].iter().filter(|(column, _)| *column != node);
        let known: Complex<f64> = known.map(|(column, value)| value * twist[*column]).sum();
        twist[node] = (right[node] - known) / entry(&rows[node], node);
    }
    let largest = twist.iter().map(|one| one.norm()).fold(0.0, f64::max);
    train.of_discs(&twist.into_iter().map(|one| beyond_rounding(one, largest)).collect::<Vec<_>>())
}

/// What is smaller than this part of what it is the difference of is its rounding.
const ROUNDING: f64 = 1e-14;

fn beyond_rounding(value: Complex<f64>, beside: f64) -> Complex<f64> {
    if value.norm() < ROUNDING * beside { Complex::default() } else { value }
}

/// The torque in each link, `(k(1+iη) + iΩc)(Θ_i − Θ_j)`; 0 where its ends are turned alike but for rounding.
pub fn shaft_torques(train: &Train, omega: f64, twists: &[Complex<f64>]) -> Vec<Complex<f64>> {
    let of_link = |link: &super::Link| {
        let [one, other] = link.ends.map(|disc| twists[disc]);
        beyond_rounding(one - other, one.norm().max(other.norm())) * link.complex_stiffness(omega)
    };
    train.links.iter().map(of_link).collect()
}

/// The mean power in watts that becomes heat.
#[derive(Clone, Debug, PartialEq)]
pub struct Heat {
    /// At each disc that is damped absolutely.
    pub discs: Vec<f64>,
    /// In each link.
    pub links: Vec<f64>,
}

impl Heat {
    /// All of it.
    pub fn total(&self) -> f64 {
        self.discs.iter().chain(&self.links).sum()
    }
}

/// The heat of a vibration: `½Ω²c|Θ|²` of a disc, `½(Ωηk + Ω²c)|Θ_i − Θ_j|²` of a link.
pub fn heat(train: &Train, omega: f64, twists: &[Complex<f64>]) -> Heat {
    let discs = train.discs.iter().zip(twists);
    let link = |link: &super::Link| {
        0.5 * omega * link.complex_stiffness(omega).im * (twists[link.ends[0]] - twists[link.ends[1]]).norm_sqr()
    };
    Heat {
        discs: discs.map(|(disc, twist)| 0.5 * omega * omega * disc.damping * twist.norm_sqr()).collect(),
        links: train.links.iter().map(link).collect(),
    }
}
