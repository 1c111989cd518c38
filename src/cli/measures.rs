//! In which units does a person want to read, and to how many figures?

use crankstar::page::{Figures, Language, Options, Units};

/// In which units, and to how many figures, a person wants to read.
#[derive(clap::Args)]
pub struct Measures {
    /// The units of forces, lengths and masses on pages and in answers; JSON stays in those of the SI
    #[arg(long, value_enum, default_value = "si")]
    units: Units,
    /// Significant figures of decimals, 2 to 12 [default: three or four]; bounds, drawings and data keep their own
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u8).range(2..=Figures::MOST as i64))]
    digits: Option<u8>,
}

impl Measures {
    /// The options of a page that they decide.
    pub fn options(&self, language: Language) -> Options {
        let figures = self.digits.map_or_else(Figures::default, |count| Figures::new(count.into()));
        Options { units: self.units(), figures, language, ..Options::default() }
    }

    /// Whether figures are asked for.
    pub fn are_digits_given(&self) -> bool {
        self.digits.is_some()
    }

    /// The units.
    pub fn units(&self) -> Units {
        self.units
    }
}
