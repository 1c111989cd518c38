//! How long is a closed form looked for? A count of steps, so that what is printed is the same on every machine.

/// Steps that one search for a closed form may take. Where they end, decimals are shown.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Budget {
    tests: u32,
    proposals: u32,
}

impl Budget {
    /// Exact tests of a proposed form.
    pub const TESTS: u32 = 40;
    /// Proposals weighed in decimals.
    pub const PROPOSALS: u32 = 400_000;

    /// The whole budget.
    pub fn new() -> Self {
        Budget { tests: Self::TESTS, proposals: Self::PROPOSALS }
    }

    /// Exact tests and proposals that were made.
    pub fn spent(&self) -> (u32, u32) {
        (Self::TESTS - self.tests, Self::PROPOSALS - self.proposals)
    }

    /// Whether one more exact test may be made.
    pub(super) fn test(&mut self) -> bool {
        let left = self.tests.checked_sub(1);
        self.tests = left.unwrap_or(0);
        left.is_some()
    }

    /// Whether this many more proposals may be weighed.
    pub(super) fn weigh(&mut self, proposals: usize) -> bool {
        let left = u32::try_from(proposals).ok().and_then(|count| self.proposals.checked_sub(count));
        if let Some(left) = left {
            self.proposals = left;
        }
        left.is_some()
    }
}

impl Default for Budget {
    fn default() -> Self {
        Budget::new()
    }
}
