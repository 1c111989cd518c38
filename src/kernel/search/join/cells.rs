//! Which inner sums lie near a point of the plane? A grid of square cells, each with the sums in it.

/// The sums of an order, sorted by cell.
pub(super) struct Cells {
    /// The corner with the least coordinates.
    corner: [i64; 2],
    /// Cells are 2^shift wide.
    shift: u32,
    /// Cells in x and in y.
    count: [i64; 2],
    /// Where each cell begins among the sums, row by row; one more than there are cells.
    starts: Vec<u32>,
    sums: Vec<Sum>,
}

/// One inner sum, and which.
#[derive(Clone, Copy, Default)]
struct Sum {
    at: [i64; 2],
    number: u32,
}

impl Cells {
    /// Sorts sums into about as many cells as there are sums.
    pub fn new(sums: impl Iterator<Item = [i64; 2]> + Clone) -> Self {
        let (mut low, mut high, mut total) = ([i64::MAX; 2], [i64::MIN; 2], 0_u64);
        for sum in sums.clone() {
            total += 1;
            low = [low[0].min(sum[0]), low[1].min(sum[1])];
            high = [high[0].max(sum[0]), high[1].max(sum[1])];
        }
        let count = |shift: u32| [0, 1].map(|axis| ((high[axis] - low[axis]) >> shift) + 1);
        // No more cells than sums, nor narrower than a millionth.
        let fits = |shift: &u32| count(*shift).map(|cells| cells as u128).iter().product::<u128>() <= u128::from(total);
        let shift = (20..62).find(fits).unwrap_or(62);
        let count = count(shift);
        let cell = |at: [i64; 2]| (((at[1] - low[1]) >> shift) * count[0] + ((at[0] - low[0]) >> shift)) as usize;
        let mut starts = vec![0_u32; (count[0] * count[1]) as usize + 1];
        sums.clone().for_each(|at| starts[cell(at) + 1] += 1);
        for next in 1..starts.len() {
            starts[next] += starts[next - 1];
        }
        let mut sorted = vec![Sum::default(); total as usize];
        let mut free = starts.clone();
        for (number, at) in (0..).zip(sums) {
            let place = &mut free[cell(at)];
            sorted[*place as usize] = Sum { at, number };
            *place += 1;
        }
        Cells { corner: low, shift, count, starts, sums: sorted }
    }

    /// The longer side of what the sums spread over.
    pub fn extent(&self) -> i64 {
        self.count[0].max(self.count[1]) << self.shift
    }

    /// Adds the numbers of the sums that, with this one, have both coordinates within `reach` of 0.
    pub fn near(&self, sum: [i64; 2], reach: i64, found: &mut Vec<u32>) {
        let mut ranges = [(0, 0); 2];
        for axis in 0..2 {
            let from = (-sum[axis] - reach - self.corner[axis]) >> self.shift;
            let to = (-sum[axis] + reach - self.corner[axis]) >> self.shift;
            ranges[axis] = (from.max(0), to.min(self.count[axis] - 1));
            if ranges[axis].0 > ranges[axis].1 {
                return;
            }
        }
        for row in ranges[1].0..=ranges[1].1 {
            let at = |column: i64| self.starts[(row * self.count[0] + column) as usize] as usize;
            for other in &self.sums[at(ranges[0].0)..at(ranges[0].1 + 1)] {
                if (sum[0] + other.at[0]).abs() <= reach && (sum[1] + other.at[1]).abs() <= reach {
                    found.push(other.number);
                }
            }
        }
    }
}
