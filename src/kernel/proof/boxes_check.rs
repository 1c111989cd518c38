//! Do the boxes of a torus say rightly where a sum in two unknowns vanishes?
//!
//! About the middle of a box the sum `Σ C_j e^{iπ(m_j s + n_j t)}` stays within `½ Σ (|m_j| S + |n_j| T)² |C_j|` of `p + i(a σ + b τ)`, S and T
//! the half-widths times π. A line that keeps all of that away from 0 shows that the box is free. With J = (ia, ib) as a real matrix and K
//! its adjugate, `z − K P(z) / det J` maps a box into itself, and two points of it nearer to each other, where `|K p|_i + |K_i| (e_a + e_b) R` is
//! below `|det J| R` for both rows i, R the half-width times π and e_a, e_b how far the derivatives stray on it: one zero (Krawczyk).

use num_bigint::BigInt;
use num_integer::Integer;
use num_rational::BigRational;
use num_traits::{One, Signed, ToPrimitive, Zero};

use super::audit::{Audit, Reason, demand, refuse_if, steps_of};
use super::ball::{Ball, Complex};
use super::boxes::{BoxZeroClaim, BoxesClaim};
use super::check::certify;
use super::collected::{Collected, collect, turn};
use super::decimals::{enclose, scale};
use super::part::Part;

/// Bits of enclosures.
const BITS: u32 = 64;
/// The largest multiple of s and of t.
const HIGHEST_TIMES: i64 = 512;
/// A box is no narrower than this power of two of a turn.
const FINEST: u32 = 40;

/// Checks the boxes against the parts.
pub(super) fn check_boxes(claim: &BoxesClaim, left: &[Part<'_>], audit: &Audit) -> Result<(), Reason> {
    refuse_if(left.len() < 3, format!("{} parts do not vanish, which contradicts `when`", left.len()))?;
    let torus = Torus::of(claim, left, audit)?;
    for (place, zero) in claim.zeros.iter().enumerate() {
        let about = || format!("the zero about ({}, {})", zero.s, zero.t);
        torus.check_zero(zero).map_err(|reason| reason.within(about()))?;
        for other in &claim.zeros[..place] {
            audit.spend(steps_of_box(zero) + steps_of_box(other))?;
            let widths = &zero.reach + &other.reach;
            if apart(&zero.s, &other.s) <= widths && apart(&zero.t, &other.t) <= widths {
                return Err("the boxes of two zeros meet".into());
            }
        }
    }
    torus.check_tree(claim)
}

/// The sum with its coefficients enclosed, its exponents doubled and as large either way.
struct Torus<'a> {
    /// `[m_j, n_j]`, each the least 0, and `S_j`.
    parts: Vec<([i64; 2], &'a Collected)>,
    vectors: Vec<([i64; 2], Complex)>,
    audit: &'a Audit,
}

/// The value, and the derivatives by πs and πt.
struct Jet {
    at: Complex,
    by: [Complex; 2],
}

/// From `low` on, so wide, along s and t.
#[derive(Clone)]
struct Place {
    low: [BigRational; 2],
    level: [u32; 2],
}

impl<'a> Torus<'a> {
    fn of(claim: &BoxesClaim, left: &'a [Part<'a>], audit: &'a Audit) -> Result<Self, Reason> {
        let s = multiples(left, 0, &claim.phi, audit)?;
        let t = multiples(left, 1, &claim.delta, audit)?;
        let highest = [&s, &t].map(|times| times.iter().copied().max().unwrap_or(0));
        let scale = scale(left.iter().map(Part::sum), audit)?;
        let mut torus = Torus { parts: Vec::new(), vectors: Vec::new(), audit };
        for (part, (m, n)) in left.iter().zip(s.into_iter().zip(t)) {
            let vector = enclose(part.sum(), &scale, &audit.circle(BITS), audit)?;
            torus.vectors.push(([2 * m - highest[0], 2 * n - highest[1]], vector));
            torus.parts.push(([m, n], part.sum()));
        }
        Ok(torus)
    }

    fn jet(&self, at: &[BigRational; 2]) -> Result<Jet, Reason> {
        let circle = self.audit.circle(BITS);
        let half = BigRational::new(1.into(), 2.into());
        let [s, t] = at.each_ref().map(|turns| turns * &half);
        let mut jet = Jet { at: Complex::zero(), by: [Complex::zero(), Complex::zero()] };
        for (times, vector) in &self.vectors {
            let [m, n] = times.map(|times| BigRational::from_integer(times.into()));
            let angle = &s * m + &t * n;
            self.audit.spend(circle.steps() + steps_of(&angle) + 6)?;
            let turned = vector.times(&circle.direction(&angle), BITS);
            // A quarter turn on.
            let along = turned.turned_back(3);
            for (by, times) in jet.by.iter_mut().zip(times) {
                *by = by.plus(&whole(&along, *times));
            }
            jet.at = jet.at.plus(&turned);
        }
        Ok(jet)
    }

    /// `Σ w_j (|m_j| S + |n_j| T) |C_j|`, rounded up.
    fn beyond(&self, reach: &[BigRational; 2], weight: impl Fn([i64; 2], &BigRational) -> BigRational) -> BigRational {
        let each = self.vectors.iter().map(|(times, vector)| {
            let [m, n] = times.map(|times| BigRational::from_integer(times.abs().into()));
            let far = &reach[0] * m + &reach[1] * n;
            let length = BigRational::from_integer(vector.longest());
            length * &far * weight(*times, &far)
        });
        each.sum()
    }

    fn check_tree(&self, claim: &BoxesClaim) -> Result<(), Reason> {
        let mut waiting = vec![Place { low: [BigRational::zero(), BigRational::zero()], level: [0, 0] }];
        for letter in claim.tree.chars() {
            self.audit.spend(2)?;
            let Some(place) = waiting.pop() else { return Err("more letters than boxes in `tree`".into()) };
            match letter {
                's' => waiting.extend(place.halves(0)?),
                't' => waiting.extend(place.halves(1)?),
                '0' => self.demand_free(&place)?,
                '1' => self.demand_within(&place, &claim.zeros)?,
                '?' => (),
                _ => return Err("a box is `s`, `t`, `0`, `1` or `?`".into()),
            }
        }
        Ok(demand(waiting.is_empty(), "`tree` ends before all boxes are listed")?)
    }

    fn demand_free(&self, place: &Place) -> Result<(), Reason> {
        let (middle, half) = place.about();
        let jet = self.jet(&middle)?;
        // π < 355/113.
        let reach = half.map(|half| half * BigRational::new(355.into(), 113.into()));
        let bend = self.beyond(&reach, |_, far| far.clone()) / BigRational::from_integer(2.into());
        let bend = bend.ceil().to_integer();
        let [a, b] = &jet.by;
        match jet.at.keeps_away(&[(a, &reach[0]), (b, &reach[1])], &bend) {
            true => Ok(()),
            false => Err(format!("no line keeps 0 away from the box about ({}, {})", middle[0], middle[1]).into()),
        }
    }

    fn demand_within(&self, place: &Place, zeros: &[BoxZeroClaim]) -> Result<(), Reason> {
        let (middle, half) = place.about();
        self.audit.spend(zeros.iter().map(steps_of_box).sum())?;
        let is_within = |zero: &BoxZeroClaim| {
            let each = [&zero.s, &zero.t].into_iter().zip(&middle).zip(&half);
            each.into_iter().all(|((zero_at, here), half)| apart(zero_at, here) + half <= zero.reach)
        };
        match zeros.iter().any(is_within) {
            true => Ok(()),
            false => Err(format!("the box about ({}, {}) is not within that of a zero", middle[0], middle[1]).into()),
        }
    }

    fn check_zero(&self, zero: &BoxZeroClaim) -> Result<(), Reason> {
        let middle = [zero.s.clone(), zero.t.clone()];
        for turns in middle.iter().chain([&zero.reach]) {
            self.audit.spend(steps_of(turns))?;
            refuse_if(turns.is_negative() || *turns >= BigRational::one(), "its turns are not from 0 to 1")?;
        }
        if !zero.reach.is_positive() || zero.reach > BigRational::new(1.into(), 4.into()) {
            return Err("its box reaches nowhere, or around the torus".into());
        }
        let mut jet = self.jet(&middle)?;
        if let Some(certificate) = &zero.certificate {
            certify(&self.at(&middle)?, true, certificate, self.audit)?;
            jet.at = Complex::zero();
        }
        // 333/106 < π < 355/113.
        let [least, most] = [(333, 106), (355, 113)].map(|(n, d)| BigRational::new(n.into(), d.into()) * &zero.reach);
        let reach = [most.clone(), most.clone()];
        let stray = [0, 1].map(|axis: usize| {
            let bend = self.beyond(&reach, |times, _| BigRational::from_integer(times[axis].abs().into()));
            let doubt = &jet.by[axis].re.doubt + &jet.by[axis].im.doubt;
            bend + BigRational::from_integer(doubt)
        });
        let stray = &stray[0] + &stray[1];
        let [[ax, ay], [bx, by]] = [0, 1].map(|axis: usize| [&jet.by[axis].re.middle, &jet.by[axis].im.middle]);
        let determinant = BigRational::from_integer((ax * by - ay * bx).abs());
        let rows = [[by.clone(), -bx], [-ay, ax.clone()]];
        let is_alone = rows.iter().all(|[x, y]| {
            let at = (x * &jet.at.re.middle + y * &jet.at.im.middle).abs();
            let off = at + x.abs() * &jet.at.re.doubt + y.abs() * &jet.at.im.doubt;
            let length = BigRational::from_integer((x * x + y * y).sqrt() + 1);
            BigRational::from_integer(off) + length * &stray * &most < &determinant * &least
        });
        Ok(demand(is_alone, "Krawczyk's test does not show that its box holds one")?)
    }

    /// The sum at a point.
    fn at(&self, [s, t]: &[BigRational; 2]) -> Result<Collected, Reason> {
        let mut terms = Vec::new();
        for ([m, n], sum) in &self.parts {
            let [m, n] = [m, n].map(|times| BigRational::from_integer((*times).into()));
            let by = s * m + t * n;
            self.audit.spend((sum.len() as u64).saturating_mul(steps_of(&by)))?;
            terms.extend(sum.iter().map(|(angle, weight)| (angle + &by, weight.clone())));
        }
        Ok(collect(terms, self.audit)?)
    }
}

impl Place {
    /// The second half, and the first, which is taken first.
    fn halves(mut self, axis: usize) -> Result<[Place; 2], Reason> {
        self.level[axis] += 1;
        refuse_if(self.level[axis] > FINEST, "a box is narrower than any that is listed")?;
        let mut second = self.clone();
        second.low[axis] += BigRational::new(BigInt::one(), BigInt::one() << self.level[axis]);
        Ok([second, self])
    }

    /// The middle, and the half-widths.
    fn about(&self) -> ([BigRational; 2], [BigRational; 2]) {
        let half = self.level.map(|level| BigRational::new(BigInt::one(), BigInt::one() << (level + 1)));
        ([0, 1].map(|axis: usize| &self.low[axis] + &half[axis]), half)
    }
}

/// By which whole multiples of a unit the parts are turned along an axis, the least 0.
fn multiples(left: &[Part<'_>], axis: usize, unit: &BigRational, audit: &Audit) -> Result<Vec<i64>, Reason> {
    refuse_if(!unit.is_positive(), "s and t take φ and δ a positive number of times")?;
    let mut all: Vec<BigInt> = Vec::new();
    for part in left {
        let apart = &part.turned_against(&left[0])[axis];
        audit.spend(steps_of(apart) + steps_of(unit))?;
        let times = apart / unit;
        refuse_if(!times.is_integer(), "a part is not turned by a whole multiple of s and t")?;
        all.push(times.to_integer());
    }
    let least = all.iter().min().cloned().unwrap_or_default();
    let times = all.iter().map(|times| (times - &least).to_i64().filter(|times| *times <= HIGHEST_TIMES));
    let times = times.collect::<Option<Vec<i64>>>();
    let times = times.ok_or_else(|| format!("s or t enters more than {HIGHEST_TIMES} times"))?;
    match times.iter().fold(0, |all: i64, times| all.gcd(times)) {
        1 => Ok(times),
        _ => Err("the multiples of s or of t have a common divisor".into()),
    }
}

fn whole(vector: &Complex, times: i64) -> Complex {
    let part = |ball: &Ball| Ball { middle: &ball.middle * times, doubt: &ball.doubt * times.abs() };
    Complex { re: part(&vector.re), im: part(&vector.im) }
}

fn steps_of_box(zero: &BoxZeroClaim) -> u64 {
    steps_of(&zero.s) + steps_of(&zero.t) + steps_of(&zero.reach)
}

/// How far two numbers of turns are from each other, modulo a turn.
fn apart(one: &BigRational, other: &BigRational) -> BigRational {
    let apart = turn(&(one - other));
    let back = BigRational::one() - &apart;
    apart.min(back)
}
