//! Which forms of engine are there?

/// Which short form the layout file used; the order is that of the catalogue.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Form {
    /// All cylinders on one side of the crankshaft.
    Inline,
    /// Two banks.
    Vee,
    /// Two banks at 180° on shared pins.
    Flat,
    /// Opposed cylinders on pins of their own, 180° apart.
    Boxer,
    /// Three banks or more.
    Fan,
    /// Two narrow banks over one row of throws, each cylinder with its own.
    Vr,
    /// Two of those on common throws.
    W,
    /// Cylinders all round a common throw.
    Radial,
    /// Two pistons in each cylinder, on two crankshafts.
    OpposedPiston,
    /// Two engines in line side by side.
    U,
    /// Two flat engines, one above the other.
    H,
    /// Rows of three cylinders with two pistons each, on three crankshafts.
    Delta,
    /// One table per cylinder.
    General,
}
