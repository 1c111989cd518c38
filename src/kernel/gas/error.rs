//! What does an engine lack for its gas forces?

use std::fmt;

/// Why the gas of an engine has no numbers.
#[derive(Clone, Debug, PartialEq)]
pub enum NoGas {
    /// Nothing is said of the gas.
    Gas,
    /// No rod: without λ the piston's way is not known.
    Rods,
    /// No crank radius.
    Radius,
    /// No heat gives the wanted highest pressure: without burning it is the second one, in bar.
    Peak(f64, f64),
    /// No heat gives the wanted mean pressure: without burning it is the second one, in bar.
    Mean(f64, f64),
    /// A stage of a compressor whose piston cannot reach the pressure of delivery, or never takes in.
    Delivery,
    /// Two pistons that face each other and move together, so that the volume between them stays as it is.
    Still,
    /// Numbers that no decimal can hold.
    TooLarge,
}

impl fmt::Display for NoGas {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            NoGas::Gas => f.write_str(
                "the layout says nothing of the gas; add [gas] with a bore, and a process or a table of pressures",
            ),
            NoGas::Rods => f.write_str(
                "the layout gives no rods; below [mechanism], give rod_length or rod_ratio",
            ),
            NoGas::Radius => f.write_str(
                "the layout gives no crank radius; below [mechanism], give stroke or crank_radius",
            ),
            NoGas::Peak(wanted, bar) => write!(
                f,
                "no heat gives peak_pressure = \"{wanted} bar\": the compression alone reaches {bar:.2} bar; write more than that"
            ),
            NoGas::Mean(wanted, bar) => write!(
                f,
                "no heat gives mean_pressure = \"{wanted} bar\": without burning it is {bar:.2} bar; write more than that"
            ),
            NoGas::Delivery => f.write_str(
                "the compressor never delivers: its clearance is too large for the pressure of delivery; make one of them smaller",
            ),
            NoGas::Still => f.write_str(
                "the two pistons of a cylinder move together, and the volume between them stays as it is; give another lead",
            ),
            NoGas::TooLarge => f.write_str("the pressures, the bore or the stroke are too large for decimals"),
        }
    }
}

impl std::error::Error for NoGas {}
