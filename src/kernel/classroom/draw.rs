//! Which numbers fall to a student? Those of a small generator that every machine runs alike.
//!
//! SplitMix64 (G. L. Steele, D. Lea and C. H. Flood, Fast splittable pseudorandom number generators, 2014), which begins at the
//! FNV-1a hash of 64 bits of the name, a zero byte and the eight bytes of the seed, the lowest first.

/// Numbers of one student.
#[derive(Clone, Debug)]
pub struct Draw(u64);

/// FNV-1a.
const BASIS: u64 = 0xcbf2_9ce4_8422_2325;
const PRIME: u64 = 0x0000_0100_0000_01b3;

impl Draw {
    /// The numbers of this student in the exercise of this seed; who else is in the list has no part in them.
    pub fn of(name: &str, seed: u64) -> Self {
        let bytes = name.bytes().chain([0]).chain(seed.to_le_bytes());
        Draw(bytes.fold(BASIS, |hash, byte| (hash ^ u64::from(byte)).wrapping_mul(PRIME)))
    }

    /// The next 64 bits.
    pub fn bits(&mut self) -> u64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mixed = (self.0 ^ (self.0 >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        let mixed = (mixed ^ (mixed >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        mixed ^ (mixed >> 31)
    }

    /// A number below the bound, which is not 0: the remainder of the next bits.
    pub fn below(&mut self, bound: usize) -> usize {
        // A remainder of a number below the bound fits.
        usize::try_from(self.bits() % (bound.max(1) as u64)).unwrap_or(0)
    }

    /// One of a list that is not empty.
    pub fn one_of<T: Copy>(&mut self, list: &[T]) -> T {
        list[self.below(list.len())]
    }

    /// The whole numbers below a count in some order (Fisher and Yates, from the last place down).
    pub fn order_of(&mut self, count: usize) -> Vec<usize> {
        let mut order: Vec<usize> = (0..count).collect();
        for last in (1..count).rev() {
            order.swap(last, self.below(last + 1));
        }
        order
    }
}
