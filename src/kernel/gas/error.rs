//! What does an engine lack for its gas forces?

/// Why the gas of an engine has no numbers.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum NoGas {
    /// Nothing is said of the gas.
    #[error("the layout says nothing of the gas; add [gas] with a bore, and a process or a table of pressures")]
    Gas,
    /// No rod: without λ the piston's way is not known.
    #[error("the layout gives no rods; below [mechanism], give rod_length or rod_ratio")]
    Rods,
    /// No crank radius.
    #[error("the layout gives no crank radius; below [mechanism], give stroke or crank_radius")]
    Radius,
    /// No heat gives the wanted highest pressure: without burning it is the second one, in bar.
    #[error(
        "no heat gives peak_pressure = \"{0} bar\": the compression alone reaches {1:.2} bar; write more than that"
    )]
    Peak(f64, f64),
    /// No heat gives the wanted mean pressure: without burning it is the second one, in bar.
    #[error("no heat gives mean_pressure = \"{0} bar\": without burning it is {1:.2} bar; write more than that")]
    Mean(f64, f64),
    /// A stage of a compressor whose piston cannot reach the pressure of delivery, or never takes in.
    #[error(
        "the compressor never delivers: its clearance is too large for the pressure of delivery; make one of them smaller"
    )]
    Delivery,
    /// Two pistons that face each other and move together, so that the volume between them stays as it is.
    #[error(
        "the two pistons of a cylinder move together, and the volume between them stays as it is; give another lead"
    )]
    Still,
    /// Numbers that no decimal can hold.
    #[error("the pressures, the bore or the stroke are too large for decimals")]
    TooLarge,
}
