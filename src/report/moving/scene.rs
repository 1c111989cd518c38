//! What does a page hold of an engine in motion? Numbers to draw by, finished words, and zeros as whole numbers.

use serde::Serialize;

use crate::page::Text;
use crate::proof::Sense;

/// An engine in motion, as the script of the page reads it. Angles are in degrees, in the sense in which the crank turns: anticlockwise from
/// where it is seen.
#[derive(Clone, Debug, Serialize)]
pub struct Scene {
    /// What the engine is called.
    pub title: String,
    /// From which end it is drawn, for those who hear the page.
    #[serde(skip)]
    pub seen: String,
    /// The cylinders from the free end on.
    pub bodies: Vec<Body>,
    /// The orders that are decided.
    pub orders: Vec<MovingOrder>,
    /// The order that the page opens on, by its place, and its force or moment: the first that is left.
    pub start: (usize, &'static str),
    /// What force and moment are counted in once they have their coefficients; none where their sizes are not known.
    pub units: Option<[MovingUnit; 2]>,
    /// The angle that is open, where there is one.
    pub angle: Option<MovingAngle>,
    /// What is to be known of the drawing.
    #[serde(skip)]
    pub notes: Vec<Text>,
    /// The words that the script puts together.
    pub words: Words,
}

/// A cylinder with its crank.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Body {
    /// What it is called.
    pub name: String,
    /// What is on its piston seen from the free end; none behind one that moves alike.
    pub label: Option<String>,
    /// A number that cylinders on one throw have in common, from 0.
    pub crank: usize,
    /// Who works on this throw, told once for each.
    pub pin: Option<String>,
    /// Which colour it has: that of its throw, or of its crankshaft where there are several.
    pub colour: usize,
    /// Where its crankshaft stands, to the right and up, in crank radii.
    pub axis: [f64; 2],
    /// How many times its crankshaft turns while the reference turns once; below 0 against it.
    pub speed: f64,
    /// Throw β.
    pub throw: f64,
    /// How many times the open angle enters β.
    pub throw_turns: f64,
    /// Direction α of its axis.
    pub bank: f64,
    /// How many times the open angle enters α.
    pub bank_turns: f64,
    /// Crank radius, in multiples of that of the engine.
    pub radius: f64,
    /// Length of its rod, or of its link, as it is drawn, in the same unit.
    pub rod: f64,
    /// The pin of a master rod that a link is on; none of a rod on the crankpin.
    pub knuckle: Option<Knuckle>,
    /// Distance e of its axis from the shaft, on the side of ψ = 90°, in the same unit.
    pub aside: f64,
}

/// A knuckle pin, on the master rod of the same crankpin.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct Knuckle {
    /// Δ: by how much the axis of the link's cylinder is ahead of that of the master's.
    pub angle: f64,
    /// γ: where it is, seen from the crankpin, from the master rod on.
    pub ahead: f64,
    /// Its distance from the crankpin, in crank radii of the engine.
    pub radius: f64,
    /// Length of the master rod, in the same unit.
    pub master: f64,
}

/// Decimals of multiples of m r ω², as a reader counts them.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct MovingUnit {
    /// So many are a multiple.
    pub factor: f64,
    /// What they are called.
    pub name: &'static str,
}

/// One order.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct MovingOrder {
    /// The order k.
    pub order: u32,
    /// What its vectors are multiplied by to be those of m r ω²: a length and a direction in degrees, of the direct ones; none where that
    /// is not known.
    pub coefficient: Option<[f64; 2]>,
    /// Whether the engine has it.
    pub exists: bool,
    /// The shaking force.
    pub force: MovingQuantity,
    /// The moment about the reference plane.
    pub moment: MovingQuantity,
}

/// The force or the moment of one order.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct MovingQuantity {
    /// What is left, in exact words.
    pub words: String,
    /// How much that is at most, where the sizes are known.
    pub most: Option<String>,
    /// The direct vectors, then the reverse ones.
    pub senses: [MovingSense; 2],
    /// The values at which one of the sums vanishes, or both, if an angle is open.
    pub marks: Vec<Mark>,
}

/// The vectors of one sense at θ = 0, and their sum.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct MovingSense {
    /// What they sum to, in exact words.
    pub words: String,
    /// Whether that is proved to be 0.
    pub zero: bool,
    /// Length of the longest arrow, whatever the open angle is.
    pub reach: f64,
    /// The vectors, those of one direction together.
    pub rays: Vec<Ray>,
    /// Length of the sum, approximately.
    pub length: f64,
    /// Direction of the sum in degrees, approximately.
    pub degrees: f64,
    /// Where the sum vanishes, if an angle is open.
    pub zeros: Option<Zeros>,
}

/// Vectors of one direction, laid end to end.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Ray {
    /// Whose they are.
    pub label: String,
    /// Their direction at θ = 0.
    pub degrees: f64,
    /// How many times the open angle enters it.
    pub turns: f64,
    /// Their lengths, positive.
    pub lengths: Vec<f64>,
    /// The sum of these.
    pub length: f64,
}

/// An angle that is open, counted in whole numbers of which `unit` are a degree.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct MovingAngle {
    /// φ or δ.
    pub symbol: &'static str,
    /// What it is called.
    pub name: &'static str,
    /// So many are a degree.
    pub unit: i64,
    /// The least value of the slider.
    pub low: i64,
    /// The largest value of the slider.
    pub high: i64,
    /// What one step of the slider adds.
    pub step: i64,
    /// The value that the words of verdicts are about.
    pub start: Mark,
}

/// A value of the open angle.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
pub struct Mark {
    /// In units of the slider.
    pub at: i64,
    /// As it is written: exactly, or with ≈ where an irrational angle is rounded.
    pub text: String,
    /// What vanishes there: direct, reverse, or both; empty where it is no zero.
    pub of: Vec<&'static str>,
    /// Whether force or moment vanishes.
    pub both: bool,
}

/// Where a sum vanishes.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
pub struct Zeros {
    /// Everywhere.
    pub everywhere: bool,
    /// At these values, in units of the slider, rising.
    pub at: Vec<i64>,
    /// Beside these, each at an irrational angle that this one is rounded from.
    pub near: Vec<i64>,
    /// Whether it is proved to vanish nowhere else.
    pub complete: bool,
    /// The same in exact words.
    pub words: String,
}

/// What is said of a sum that is proved to be 0.
pub(super) const ZERO: &str = "0, proved";

/// The words that the script puts together.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
pub struct Words {
    /// The senses, direct first.
    pub senses: [&'static str; 2],
    /// The force.
    pub force: &'static str,
    /// The moment.
    pub moment: &'static str,
    /// An order.
    pub order: &'static str,
    /// A sum that is in the list of zeros.
    pub zero: &'static str,
    /// A sum that vanishes at an irrational angle, where that is rounded.
    pub near: &'static str,
    /// A sum that is not in a complete list of zeros.
    pub not_zero: &'static str,
    /// A sum of which the list does not tell.
    pub undecided: &'static str,
    /// What stands before the angle of what is drawn.
    pub at: &'static str,
    /// What stands before the largest value of all orders.
    pub largest: &'static str,
    /// Starts the motion.
    pub play: &'static str,
    /// Stops it.
    pub pause: &'static str,
}

impl Default for Words {
    fn default() -> Self {
        Words {
            senses: Sense::BOTH.map(Sense::name),
            force: "force",
            moment: "moment",
            order: "Order",
            zero: ZERO,
            near: "0 at an irrational angle, here rounded",
            not_zero: "not 0",
            undecided: "not decided here",
            at: "at",
            largest: "at most",
            play: "Play",
            pause: "Pause",
        }
    }
}
