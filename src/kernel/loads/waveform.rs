//! What comes of all orders together in a revolution, and where does it peak?

use std::cmp::Ordering;
use std::collections::{BTreeMap, BTreeSet};
use std::f64::consts::TAU;

use num_complex::Complex;

use crate::motion::golden_section;
use crate::proof::Quantity;

/// One order of a waveform: `direct · e^{ikθ} + reverse · e^{−ikθ}`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Harmonic {
    /// The order k.
    pub order: u32,
    /// What turns with the crank.
    pub direct: Complex<f64>,
    /// What turns against it.
    pub reverse: Complex<f64>,
}

impl Harmonic {
    /// The largest part of its vectors.
    fn longest(&self) -> f64 {
        [self.direct, self.reverse].iter().flat_map(|vector| [vector.re.abs(), vector.im.abs()]).fold(0.0, f64::max)
    }

    /// Whether both vectors are zero.
    pub(super) fn is_none(&self) -> bool {
        self.direct == ZERO && self.reverse == ZERO
    }
}

/// A vector that repeats with every revolution; only orders that do not vanish are kept.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Waveform {
    harmonics: Vec<Harmonic>,
}

/// The largest length of a waveform.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Peak {
    /// The length, zero to peak.
    pub value: f64,
    /// Crank angle in degrees in [0, 360) where it first stands; none where the length never changes.
    pub angle: Option<f64>,
    /// The vector there.
    pub vector: Complex<f64>,
}

/// The directions `e^{2πij/n}`, once for all orders.
#[derive(Clone, Debug)]
pub struct Circle {
    directions: Vec<Complex<f64>>,
}

impl Circle {
    /// A revolution in this many steps.
    pub fn new(steps: usize) -> Self {
        // Curves are drawn with these: their last digits, on which places of names hang, are the same on every machine.
        let direction = |j: usize| {
            let (sin, cos) = libm::sincos(TAU * j as f64 / steps as f64);
            Complex::new(cos, sin)
        };
        Circle { directions: (0..steps).map(direction).collect() }
    }

    /// How many steps.
    pub fn steps(&self) -> usize {
        self.directions.len()
    }
}

const ZERO: Complex<f64> = Complex::new(0.0, 0.0);

/// Angles of a revolution at which a peak is first looked for; more for high orders.
const STEPS: usize = 720;

impl Waveform {
    /// The waveform of these orders; vectors that are zero are omitted.
    pub fn new(harmonics: impl IntoIterator<Item = Harmonic>) -> Self {
        Waveform { harmonics: harmonics.into_iter().filter(|harmonic| !harmonic.is_none()).collect() }
    }

    /// The orders, each with its two vectors.
    pub fn harmonics(&self) -> &[Harmonic] {
        &self.harmonics
    }

    /// Every vector times a factor.
    pub fn scaled(&self, factor: f64) -> Self {
        self.map(|vector| vector * factor)
    }

    /// Every vector turned, and lengthened, by the same complex factor.
    pub fn turned(&self, by: Complex<f64>) -> Self {
        self.map(|vector| vector * by)
    }

    fn map(&self, change: impl Fn(Complex<f64>) -> Complex<f64>) -> Self {
        let changed = |h: &Harmonic| Harmonic { order: h.order, direct: change(h.direct), reverse: change(h.reverse) };
        Waveform::new(self.harmonics.iter().map(changed))
    }

    /// Every vector times `e^{−inθ}`: what turns this many times stands still.
    pub(super) fn orders_back(&self, turns: i64) -> Self {
        let mut turning: BTreeMap<i64, Complex<f64>> = BTreeMap::new();
        for harmonic in &self.harmonics {
            let order = i64::from(harmonic.order);
            *turning.entry(order - turns).or_default() += harmonic.direct;
            *turning.entry(-order - turns).or_default() += harmonic.reverse;
        }
        let orders: BTreeSet<u64> = turning.keys().map(|order| order.unsigned_abs()).collect();
        let of = |order: i64| turning.get(&order).copied().unwrap_or_default();
        let harmonic = |order: u64| {
            let signed = order as i64;
            let reverse = if order == 0 { Complex::default() } else { of(-signed) };
            Harmonic { order: order as u32, direct: of(signed), reverse }
        };
        Waveform::new(orders.into_iter().map(harmonic))
    }

    /// The vector at a crank angle in radians.
    pub fn at(&self, theta: f64) -> Complex<f64> {
        let term = |harmonic: &Harmonic| {
            let turning = Complex::cis(f64::from(harmonic.order) * theta);
            harmonic.direct * turning + harmonic.reverse * turning.conj()
        };
        self.harmonics.iter().map(term).sum()
    }

    /// The vectors at the steps of a circle.
    pub fn sample(&self, circle: &Circle) -> Vec<Complex<f64>> {
        let steps = circle.steps();
        // With z = x + iy: d z + r z̄ = (d + r) x + i(d − r) y. At −θ only y changes its sign: half the circle is enough. The terms in
        // x are summed at θ, those in y at −θ; the last place is 0 once more.
        let mut values = vec![Complex::new(0.0, 0.0); steps + 1];
        for harmonic in &self.harmonics {
            let (on_x, on_y) =
                (harmonic.direct + harmonic.reverse, (harmonic.direct - harmonic.reverse) * Complex::i());
            let (stride, mut place) = (harmonic.order as usize % steps, 0);
            let (ahead, behind) = values.split_at_mut(steps / 2 + 1);
            for (x, y) in ahead.iter_mut().zip(behind.iter_mut().rev()) {
                let z = circle.directions[place];
                *x += on_x * z.re;
                *y += on_y * z.im;
                place += stride;
                if place >= steps {
                    place -= steps;
                }
            }
            // Half a turn has no partner: y is 0 there.
            if steps.is_multiple_of(2) {
                ahead[steps / 2] += on_x * circle.directions[place].re;
            }
        }
        for j in 1..steps.div_ceil(2) {
            let (x, y) = (values[j], values[steps - j]);
            (values[j], values[steps - j]) = (x + y, x - y);
        }
        values.truncate(steps);
        values
    }

    /// The largest length in a revolution.
    pub fn peak(&self) -> Peak {
        self.peak_by(|vector| vector.norm_sqr())
    }

    /// The largest size of the real part: that of a torque.
    pub fn real_peak(&self) -> Peak {
        let peak = self.peak_by(|vector| vector.re * vector.re);
        Peak { value: peak.vector.re.abs(), ..peak }
    }

    /// The peak of what these vectors are: the largest length, or the largest size of the real part.
    pub fn peak_of(&self, quantity: Quantity) -> Peak {
        match quantity {
            Quantity::Planar(_) => self.peak(),
            Quantity::Axial(_) => self.real_peak(),
        }
    }

    /// The largest size of the component in a direction of length 1.
    pub fn component_peak(&self, direction: Complex<f64>) -> Peak {
        let peak = self.turned(direction.conj()).real_peak();
        Peak { vector: peak.vector * direction, ..peak }
    }

    fn peak_by(&self, size: impl Fn(Complex<f64>) -> f64) -> Peak {
        if let [only] = self.harmonics.as_slice()
            && (only.direct == ZERO || only.reverse == ZERO)
            && size(Complex::i()) > 0.0
        {
            let vector = only.direct + only.reverse;
            return Peak { value: vector.norm(), angle: None, vector };
        }
        let Some(highest) = self.harmonics.iter().map(|harmonic| harmonic.order).max() else {
            return Peak { value: 0.0, angle: None, vector: ZERO };
        };
        // Squares of very short vectors would be 0: they are compared at lengths near 1. A power of two changes no digit.
        let (_, exponent) = libm::frexp(self.harmonics.iter().map(Harmonic::longest).fold(0.0, f64::max));
        let near_one = self.scaled(libm::scalbn(1.0, -exponent));
        let peak = near_one.peak_of_samples(highest, size);
        let back = |length: f64| libm::scalbn(length, exponent);
        Peak { value: back(peak.value), vector: Complex::new(back(peak.vector.re), back(peak.vector.im)), ..peak }
    }

    fn peak_of_samples(&self, highest: u32, size: impl Fn(Complex<f64>) -> f64) -> Peak {
        let circle = Circle::new(STEPS.max(32 * highest as usize));
        let sizes: Vec<f64> = self.sample(&circle).into_iter().map(&size).collect();
        let step = TAU / circle.steps() as f64;
        let tops: Vec<Peak> = tops(&sizes).into_iter().map(|j| self.refined(j as f64 * step, step, &size)).collect();
        let largest = tops.iter().map(|top| size(top.vector)).fold(0.0, f64::max);
        // Equal peaks differ by roundings; the first of them is named, so that it is the same on every machine.
        let equal = tops.into_iter().filter(|top| size(top.vector) >= largest * (1.0 - 1e-9));
        let first = equal.min_by(|a, b| a.angle.partial_cmp(&b.angle).unwrap_or(Ordering::Equal));
        first.unwrap_or(Peak { value: 0.0, angle: None, vector: ZERO })
    }

    /// The largest value within one step of a place, by golden sections.
    fn refined(&self, place: f64, step: f64, size: &impl Fn(Complex<f64>) -> f64) -> Peak {
        let theta = golden_section(place - step, place + step, 60, |theta| size(self.at(theta)));
        // Flat tops leave the place uncertain by the root of the rounding; the sample itself may be the top.
        let theta = if size(self.at(place)) >= size(self.at(theta)) { place } else { theta };
        let vector = self.at(theta);
        let degrees = theta.to_degrees().rem_euclid(360.0);
        let degrees = if degrees > 360.0 - 5e-5 { 0.0 } else { degrees };
        Peak { value: vector.norm(), angle: Some(degrees), vector }
    }
}

/// The samples, largest among their neighbours, beside which the largest value may stand.
///
/// The square of a waveform of orders up to K has orders up to 2K and, if M is its largest value, a second derivative of at most
/// 2K² M (Bernstein). So with 32 K samples one is less than a hundredth of M below it.
fn tops(sizes: &[f64]) -> Vec<usize> {
    let count = sizes.len();
    let largest = sizes.iter().copied().fold(0.0, f64::max);
    let is_top = |&j: &usize| {
        let beside = sizes[(j + count - 1) % count].max(sizes[(j + 1) % count]);
        sizes[j] >= beside && sizes[j] >= 0.99 * largest
    };
    (0..count).filter(is_top).collect()
}
