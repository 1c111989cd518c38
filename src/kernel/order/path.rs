//! What do the two vectors of an order trace together? A line, where that is proved.

use super::sum::OrderSum;

/// The path of `½(P⁺ e^{ikθ} + P⁻ e^{−ikθ})` as far as the exact sums prove it, whatever the factors are.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Path {
    /// The component along direction 0 is zero: `P⁺ = −P̄⁻`.
    pub nothing_along: bool,
    /// The component across direction 0 is zero: `P⁺ = P̄⁻`.
    pub nothing_across: bool,
    /// Both vectors are equally long: the path is a line, or a point.
    pub is_line: bool,
}

impl Path {
    /// The path of the two vectors of an order. The factor of a reverse sum is the conjugate one, so that it is its mirror image that is
    /// compared with the direct sum.
    pub fn of(direct: &OrderSum, reverse: &OrderSum, order: u32) -> Self {
        let nothing_along = Path::has_nothing_along(direct, reverse);
        let nothing_across = Path::has_nothing_across(direct, reverse);
        let is_line = nothing_along || nothing_across || direct.is_as_long_as(reverse, order);
        Path { nothing_along, nothing_across, is_line }
    }

    /// Whether the component along direction 0 is zero, where the rest of the path is not asked for.
    pub fn has_nothing_along(direct: &OrderSum, reverse: &OrderSum) -> bool {
        direct.plus(&reverse.mirrored()).vanishes()
    }

    /// Whether the component across direction 0 is zero, where the rest of the path is not asked for.
    pub fn has_nothing_across(direct: &OrderSum, reverse: &OrderSum) -> bool {
        direct.minus(&reverse.mirrored()).vanishes()
    }

    /// Of nothing.
    pub const POINT: Path = Path { nothing_along: true, nothing_across: true, is_line: true };

    /// Nothing is proved.
    pub const OPEN: Path = Path { nothing_along: false, nothing_across: false, is_line: false };
}
