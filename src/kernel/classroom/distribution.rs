//! How are the points of a class spread?

use num_rational::BigRational;
use num_traits::ToPrimitive;

use super::results::{Outcome, StudentResult};

/// The points of all sheets that are marked.
#[derive(Clone, Debug, PartialEq)]
pub struct Distribution {
    /// How many sheets these are, at least one.
    pub sheets: usize,
    /// The mean of their points.
    pub mean: BigRational,
    /// The variance of these points, the square of their standard deviation: the mean square of what they are off the mean.
    pub variance: BigRational,
    /// The largest points that a sheet could have.
    pub possible: BigRational,
    /// How many sheets have a part of the possible points in each tenth from 0 to 1; what lies between two counts in the upper one, all
    /// points in the last.
    pub tenths: [usize; 10],
}

impl Distribution {
    /// That of a class; none where no sheet is marked.
    pub fn of(results: &[StudentResult]) -> Option<Self> {
        let marked = results.iter().filter_map(|result| match &result.outcome {
            Outcome::Marked(sheet) => Some(sheet),
            Outcome::Unreadable(_) | Outcome::NotHandedIn | Outcome::HandedInTwice | Outcome::NotRead(_) => None,
        });
        let sheets: Vec<_> = marked.collect();
        let possible = sheets.iter().map(|sheet| sheet.possible.clone()).max()?;
        let count = BigRational::from_integer(sheets.len().into());
        let mean = sheets.iter().map(|sheet| sheet.points.clone()).sum::<BigRational>() / &count;
        let off = sheets.iter().map(|sheet| &sheet.points - &mean);
        let variance = off.map(|off| &off * &off).sum::<BigRational>() / count;
        let mut tenths = [0; 10];
        for sheet in &sheets {
            let tenth = (sheet.part() * BigRational::from_integer(10.into())).to_integer().to_usize();
            tenths[tenth.unwrap_or(0).min(9)] += 1;
        }
        Some(Distribution { sheets: sheets.len(), mean, variance, possible, tenths })
    }
}
