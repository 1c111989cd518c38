//! At which scale is a star drawn, and how long is the bar that tells it?

use super::Star;
use crate::engine::{Engine, LengthUnit};
use crate::proof::{Planar, Quantity};
use crate::text::SUPERSCRIPTS;

/// Size of the letters of a star in millimetres.
pub(super) const LETTERS: f64 = 3.4;
/// Width of the panel of one star in millimetres.
pub(in crate::report) const WIDTH: f64 = 58.0;
/// The greatest length of a drawing has this many millimetres.
const RADIUS: f64 = 17.0;
/// The bar that tells the scale is at most so long in millimetres.
const LONGEST_BAR: f64 = 14.0;

/// Lengths and directions that differ by less are drawn as one: totals are sums of decimals.
pub(super) const SAME: f64 = 1e-9;

/// What the lengths of a star mean.
#[derive(Clone, Copy, Debug)]
pub(in crate::report) struct Scale {
    /// Millimetres a unit.
    pub millimetres: f64,
    /// Values in the unit, in plain text and as prose.
    pub(super) unit: (&'static str, &'static str),
}

impl Scale {
    /// The scale at which a star with these vectors of m r ω², or of that times the unit of the positions, fills a panel.
    pub(super) fn of_whole(star: &Star, quantity: Planar, engine: &Engine) -> Self {
        let unit = match (quantity, engine.length_unit()) {
            (Planar::Force, _) => ("{} m r ω²", "{} $m r \\omega^2$"),
            (Planar::Moment, LengthUnit::Spacing) => ("{} m r ω² a", "{} $m r \\omega^2 a$"),
            (Planar::Moment, LengthUnit::Metre) => ("{} m r ω² · metre", "{} $m r \\omega^2$ · metre"),
        };
        Scale::filling([star], unit)
    }

    /// The scale at which the longest of these stars fills a panel.
    pub fn of<'a>(stars: impl IntoIterator<Item = &'a Star>, quantity: impl Into<Quantity>, engine: &Engine) -> Self {
        let unit = match (quantity.into(), engine.length_unit()) {
            (Quantity::FORCE, _) => ("{} m r", "{} $m r$"),
            (Quantity::MOMENT, LengthUnit::Spacing) => ("{} m r a", "{} $m r a$"),
            (Quantity::MOMENT, LengthUnit::Metre) => ("{} m r · metre", "{} $m r$ · metre"),
            (Quantity::Axial(_), _) => ("{} m r²", "{} $m r^2$"),
        };
        Scale::filling(stars, unit)
    }

    /// The same for stars of what is counted in crank radii.
    pub fn of_crank_radii<'a>(stars: impl IntoIterator<Item = &'a Star>) -> Self {
        Scale::filling(stars, ("r", "$r$"))
    }

    fn filling<'a>(stars: impl IntoIterator<Item = &'a Star>, unit: (&'static str, &'static str)) -> Self {
        let reach = stars.into_iter().map(Star::reach).fold(0.0, f64::max);
        let millimetres = if reach > 0.0 { RADIUS / reach } else { 0.0 };
        Scale { millimetres, unit }
    }

    /// Whether a drawing tells the two apart.
    pub fn is_alike(&self, other: &Scale) -> bool {
        self.unit == other.unit && (self.millimetres - other.millimetres).abs() <= SAME * self.millimetres
    }

    /// The length of the bar in units: 1, 2 or 5 times a power of ten; none where there is nothing to measure.
    pub fn bar(&self) -> Option<(f64, String)> {
        let most = LONGEST_BAR / self.millimetres;
        let power = most.log10().floor();
        let ten: f64 = format!("1e{power}").parse().ok().filter(|_| power.is_finite())?;
        let digit = [5.0, 2.0, 1.0].into_iter().find(|digit| digit * ten <= most)?;
        let written = match power as i32 {
            plain @ ..=-1 if plain >= -3 => format!("{}", digit * ten),
            plain @ 0..=4 => format!("{digit}{}", "0".repeat(plain.unsigned_abs() as usize)),
            power => format!("{digit}·10{}", raised(power)),
        };
        Some((digit * ten, written))
    }
}

fn raised(power: i32) -> String {
    let digits = power.unsigned_abs().to_string();
    let digits = digits.bytes().map(|digit| SUPERSCRIPTS[usize::from(digit - b'0')]);
    (power < 0).then_some('⁻').into_iter().chain(digits).collect()
}
