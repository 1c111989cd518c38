//! `remedy`: which counterweights and balancer shafts take away what is left?

use crankstar::engine::{Engine, LengthUnit};
use crankstar::exact::Turn;
use crankstar::file::{Layout, parse_angle, parse_length, parse_number};
use crankstar::remedy::{self, Wish};
use crankstar::report;
use num_rational::BigRational;
use num_traits::Signed;

use super::failure::Failure;
use super::pages::Pages;
use super::verify::proved;
use super::{EngineAndOrders, write};

/// Arguments of `remedy`.
#[derive(clap::Args)]
pub struct Remedy {
    #[command(flatten)]
    about: EngineAndOrders,
    /// Two planes for counterweights and couples, positions along the crankshaft [default: the outermost throws]
    #[arg(long, value_name = "Z1,Z2", value_delimiter = ',', allow_hyphen_values = true)]
    planes: Vec<String>,
    /// Counterweights on each throw with this balance factor: one for all throws, or one per throw
    #[arg(long, value_name = "FACTORS", value_delimiter = ',')]
    balance_factor: Vec<String>,
    /// How far those are turned on from opposite to their throw, in degrees: one for all throws, or one per throw
    #[arg(long, value_name = "ANGLES", value_delimiter = ',', allow_hyphen_values = true, requires = "balance_factor")]
    skew: Vec<String>,
    /// Print the remedy as JSON with its certificates, for `verify`
    #[arg(long, conflicts_with = "output")]
    json: bool,
    #[command(flatten)]
    pages: Pages,
}

impl Remedy {
    /// Prints the remedy, and writes the page into the folder.
    pub fn run(&self) -> Result<(), Failure> {
        let (layout, orders) = self.about.read()?;
        let Layout::Known(engine, _) = layout else {
            return Err(Failure::new("a remedy needs an engine without unknowns; give them values below [values]"));
        };
        let remedy = remedy::remedy(&engine, &self.wish(&engine, orders)?).map_err(Failure::new)?;
        if self.json {
            return write::to_stdout(&proved(&report::remedy_document(&remedy))?);
        }
        self.pages.show(&report::remedy_answer(&remedy), || report::remedy_page(&remedy))
    }

    fn wish(&self, engine: &Engine, orders: Vec<u32>) -> Result<Wish, Failure> {
        let planes = match self.planes.as_slice() {
            [] => None,
            [first, second] => Some([plane(engine, first)?, plane(engine, second)?]),
            more => {
                let message = format!("--planes: {} positions; two are needed, such as 0.12,-0.12", more.len());
                return Err(Failure::new(message));
            }
        };
        let factors = self.balance_factor.iter().map(|text| factor(text)).collect::<Result<_, _>>()?;
        let skews = self.skew.iter().map(|text| {
            parse_angle(text)
                .map(Turn::new)
                .map_err(|right| Failure::new(format!("--skew: cannot read `{text}`: {right}")))
        });
        Ok(Wish { orders, planes, factors, skews: skews.collect::<Result<_, _>>()? })
    }
}

fn factor(text: &str) -> Result<BigRational, Failure> {
    let refused = |right: String| Failure::new(format!("--balance-factor: cannot read `{text}`: {right}"));
    match parse_number(text) {
        Ok(value) if value.is_negative() => Err(refused("a balance factor is 0 or more".to_owned())),
        Ok(value) => Ok(value),
        Err(error) => Err(refused(error.to_string())),
    }
}

/// A position in the unit of the engine.
fn plane(engine: &Engine, text: &str) -> Result<BigRational, Failure> {
    let refused = |right: &str| Failure::new(format!("--planes: cannot read `{text}`: {right}"));
    let (value, unit) = parse_length(text).map_err(|right| refused(&right))?;
    if unit == LengthUnit::Metre && !engine.positions_given() {
        return Err(refused("the cylinders stand one spacing apart, and positions count in spacings"));
    }
    Ok(value)
}
