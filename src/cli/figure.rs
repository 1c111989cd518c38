//! `figure`: how does one drawing get into a document of one's own?

use std::path::{Path, PathBuf};

use clap::ValueEnum;

use crankstar::engine::{Engine, Family};
use crankstar::family;
use crankstar::file::Layout;
use crankstar::loads::{Method, bearing_loads, bearing_orders};
use crankstar::page::Alone;
use crankstar::proof::Quantity;
use crankstar::report::{self, Contents, NamedPicture};
use crankstar::text::harmless;

use super::failure::Failure;
use super::masses::{Masses, masses_of_a_family};
use super::orders::{EngineAndOrders, classified};
use super::pages::Reader;
use super::sweep::Ranges;
use super::{folder, layouts, write};

/// Arguments of `figure`.
#[derive(clap::Args)]
#[command(after_help = EXAMPLES, mut_arg("digits", |digits| digits.hide(true)))]
pub struct Figure {
    #[command(flatten)]
    about: EngineAndOrders,
    /// Which drawing [default: the names of all are listed]
    name: Option<String>,
    /// What it is written in [default: TikZ into a file that ends in .tex, else SVG]
    #[arg(long, value_enum)]
    format: Option<Format>,
    /// Write TikZ as a document of its own, not as a piece to be input
    #[arg(long)]
    standalone: bool,
    /// The file to write [default: standard output]
    #[arg(long, value_name = "FILE")]
    output: Option<PathBuf>,
    #[command(flatten)]
    reader: Reader,
    #[command(flatten)]
    masses: Masses,
    #[command(flatten, next_help_heading = "For the drawings of a sweep")]
    ranges: Ranges,
}

const EXAMPLES: &str = "\
Names:
  end-view, side-view         the engine
  star:2, star:2:pistons      the vectors of an order, of all masses or the pistons
  force-along, moment-path    loads of a file with numbers, torque too
  bearing:1, polar:1          a main bearing over the crank angle, and as a path
  amplitudes                  of a layout with an open angle
  sweep:force-2               with a range such as --bank-angle

Examples:
  crankstar figure V8-crossplane
  crankstar figure V8-crossplane star:1 --output star.svg
  crankstar figure V8-crossplane star:1 --output star.tex
      then \\input{star} in a figure
  crankstar figure V2-90 sweep:force-2 --bank-angle 0..180:10";

#[derive(Clone, Copy, PartialEq, Eq, ValueEnum)]
enum Format {
    /// A drawing for browsers and editors
    Svg,
    /// A picture for LaTeX, with the colours that it needs
    Tikz,
}

impl Format {
    fn ending_and_name(self) -> (&'static str, &'static str) {
        match self {
            Format::Svg => ("svg", "SVG"),
            Format::Tikz => ("tex", "TikZ"),
        }
    }

    /// What a file of this name holds, by its ending; none where it has no ending.
    fn of_file(path: &Path) -> Result<Option<Self>, Failure> {
        match path.extension().map(|ending| ending.to_string_lossy().to_ascii_lowercase()).as_deref() {
            None => Ok(None),
            Some("svg") => Ok(Some(Format::Svg)),
            Some("tex" | "tikz" | "pgf") => Ok(Some(Format::Tikz)),
            Some(ending) => Err(Failure::misuse(format!(
                "`{}` is named as a file of {}, and a drawing is SVG or TikZ; end the name in .svg or .tex",
                layouts::shown(path),
                harmless(ending)
            ))),
        }
    }
}

impl Figure {
    /// Lists the drawings, or writes the one that is named.
    pub fn run(&self) -> Result<(), Failure> {
        if self.reader.measures().are_digits_given() {
            return Err(Failure::misuse(
                "--digits has no effect on a drawing, whose labels have the figures that they have room for; omit it",
            ));
        }
        let of_a_drawing = [
            ("--output", self.output.is_some()),
            ("--format", self.format.is_some()),
            ("--standalone", self.standalone),
        ];
        if let Some((option, _)) = of_a_drawing.into_iter().find(|(_, is_given)| self.name.is_none() && *is_given) {
            return Err(Failure::misuse(format!(
                "{option} needs the name of a figure, such as end-view; without {option} the names are listed"
            )));
        }
        let alone = self.alone()?;
        let figures = self.figures()?;
        let names = || figures.iter().map(|figure| figure.name.as_str()).collect::<Vec<_>>();
        let listed = || figures.iter().map(|figure| format!("{}\n", figure.name)).collect::<String>();
        let layout = layouts::shown(&self.about.layout);
        let Some(name) = &self.name else {
            if figures.is_empty() {
                write::warn(&format!("note: there is no figure of `{layout}` to draw"));
            }
            return write::to_stdout(&listed());
        };
        let Some(figure) = figures.iter().find(|figure| figure.name == *name) else {
            let there = match names().as_slice() {
                [] => "it has none".to_owned(),
                names => format!("there are {}", names.join(", ")),
            };
            return Err(Failure::new(format!("`{layout}` has no figure `{}`; {there}", harmless(name))));
        };
        let text = alone.write(&figure.picture, &self.reader.options()?);
        match &self.output {
            None => write::to_stdout(&text),
            Some(path) => {
                folder::write_file(path, text.as_bytes(), "star.svg")?;
                write::to_stdout(&format!("Written: {}\n", layouts::shown(path)))
            }
        }
    }

    fn alone(&self) -> Result<Alone, Failure> {
        let named = self.output.as_deref().map_or(Ok(None), Format::of_file)?;
        let usual = if self.standalone { Format::Tikz } else { Format::Svg };
        let format = self.format.or(named).unwrap_or(usual);
        if let Some(named) = named.filter(|named| *named != format) {
            let [(_, named), (right, format)] = [named, format].map(Format::ending_and_name);
            let message =
                format!("--output is named as a file of {named}, and holds {format}; end the name in .{right}");
            return Err(Failure::misuse(message));
        }
        match (format, self.standalone) {
            (Format::Svg, true) => Err(Failure::misuse("--standalone is of TikZ: an SVG file is a file of its own")),
            (Format::Svg, false) => Ok(Alone::Svg),
            (Format::Tikz, false) => Ok(Alone::Tikz),
            (Format::Tikz, true) => Ok(Alone::TikzDocument),
        }
    }

    /// The drawings of the sweep where a range is given, else those of the layout.
    fn figures(&self) -> Result<Vec<NamedPicture>, Failure> {
        if self.ranges.are_given() {
            let sweep = self.ranges.sweep(&self.about.layout, &self.about.asked()?, &[], &[])?;
            return Ok(report::sweep_figures(report::sweep_page(&sweep)));
        }
        let (layout, mut orders) = self.about.read()?;
        orders.extend(self.order().filter(|order| !orders.contains(order)));
        orders.sort_unstable();
        match layout {
            Layout::Known(engine, family) => self.of_engine(&engine, family.as_deref(), &orders),
            Layout::Open(_) if self.masses.are_given() => Err(masses_of_a_family()),
            Layout::Open(family) => {
                family::comparable(&family).map_err(Failure::new)?;
                let verdicts = family::classify(&family, &orders).map_err(Failure::new)?;
                Ok(report::figures(&[report::family_page(&family, &verdicts, false)]))
            }
        }
    }

    /// The order of the star that is asked for: it may be none of the usual ones.
    fn order(&self) -> Option<u32> {
        self.name.as_ref()?.strip_prefix("star:")?.split(':').next()?.parse().ok()
    }

    fn of_engine(
        &self,
        engine: &Engine,
        family: Option<&Family>,
        orders: &[u32],
    ) -> Result<Vec<NamedPicture>, Failure> {
        let judged = self.masses.judge(engine, orders, &Quantity::PLANAR)?;
        let open = classified(family, orders)?;
        let mut pages = vec![report::engine_page(Contents {
            engine,
            judged: &judged,
            family: open.as_ref().map(|(family, orders)| (*family, orders.as_slice())),
            needed: None,
            in_motion: false,
            accuracy: None,
            weighing: report::Weighing::usual(),
        })];
        if !engine.bearings().is_empty() {
            let orders = bearing_orders(engine, orders);
            let solve = |method| bearing_loads(engine, &orders, method);
            // Where numbers are missing the bearings have no drawings.
            if let (Ok(continuous), Ok(determinate)) = (solve(Method::Continuous), solve(Method::Determinate)) {
                pages.push(report::bearings_page(engine, &continuous, &determinate));
            }
        }
        Ok(report::figures(&pages))
    }
}
