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
    /// Cylinders all round a common throw.
    Radial,
    /// One table per cylinder.
    General,
}
