//! What does a check of a study claim? One thing, each kind with what it needs.

use crankstar::engine::CycleOrder;
use crankstar::file::parse_number;
use crankstar::proof::Planar;
use crankstar::sweep::Zeros;
use num_rational::BigRational;
use serde::Deserialize;

use super::study::Word;

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct CheckTable {
    /// A family, or the path of a layout file.
    pub engine: Word,
    pub kind: Option<Word>,
    pub place: Option<Word>,
    pub words: Option<Word>,
    /// The value of the family's parameter that `says` is about.
    pub at: Option<Word>,
    /// A claim about one engine.
    says: Option<Word>,
    /// `moment 2 along`: what vanishes at the values named, everywhere where none are.
    vanishes: Option<Word>,
    /// `moment 1`: what has constant length at the values named.
    constant: Option<Word>,
    /// Where on the grid the firing is the `least` uneven, the `most` uneven, or more `even` than one step before.
    firing: Option<Word>,
    /// These values, and perhaps others.
    met_at: Option<Vec<Word>>,
    /// These values of the range, and no others.
    only_at: Option<Vec<Word>>,
    /// `m_cw ρ b` in multiples of m r a.
    counterweight: Option<Word>,
    /// The factor that no volume of the family reaches, of that of the engine in line.
    volume_below: Option<Word>,
    /// Where on the grid the flywheel is the `lightest`, the `heaviest`, or `lighter` than one step before.
    flywheel: Option<Word>,
    /// The order of the gas torque that vanishes at the values named of the grid, for every pressure that the cylinders share.
    torque_vanishes: Option<Word>,
}

/// What a check claims: one of these, so that no key is read as another.
pub(super) enum Check {
    /// A claim about one engine, in the words of claims.
    Says(String),
    /// A part of a quantity that vanishes at these values; everywhere, where there are none.
    Vanishes { part: Part, at: Option<Values> },
    /// A quantity whose largest and smallest value are alike at these values.
    Constant { part: Part, at: Values },
    /// Where on the grid the firing is like this.
    Fires { how: Firing, at: Values },
    /// `m_cw ρ b` in multiples of m r a.
    Counterweight(String),
    /// The factor that no volume of the family reaches, of that of the engine in line.
    VolumeBelow(String),
    /// Where on the grid the flywheel weighs so much.
    Flywheel { how: Weighs, at: Values },
    /// Where on the grid this order of the gas torque vanishes.
    TorqueVanishes { order: CycleOrder, at: Values },
}

/// A part of a force or moment, as it was written.
pub(super) struct Part {
    pub words: String,
    pub quantity: Planar,
    pub order: u32,
    pub of: Zeros,
}

/// Values of the family's parameter.
pub(super) enum Values {
    /// These, and perhaps others.
    Among(Vec<BigRational>),
    /// These, and no others.
    Only(Vec<BigRational>),
}

/// What is said of the firing.
#[derive(Clone, Copy)]
pub(super) enum Firing {
    LeastUneven,
    MostUneven,
    MoreEvenThanBefore,
}

/// What is said of the flywheel.
#[derive(Clone, Copy)]
pub(super) enum Weighs {
    Least,
    Most,
    LessThanBefore,
}

impl Values {
    /// Whether these values, `complete` where they are proved to be all, are the claimed ones.
    pub fn are(&self, found: &[BigRational], complete: bool) -> bool {
        match self {
            Values::Among(claimed) => claimed.iter().all(|value| found.contains(value)),
            Values::Only(claimed) => complete && found == claimed.as_slice(),
        }
    }

    pub fn in_words(&self) -> String {
        let list =
            |values: &[BigRational]| values.iter().map(|value| format!("{value}°")).collect::<Vec<String>>().join(", ");
        match self {
            Values::Only(values) if values.is_empty() => "nowhere".to_owned(),
            Values::Only(values) => format!("only at {}", list(values)),
            Values::Among(values) => format!("at {}", list(values)),
        }
    }
}

impl Firing {
    fn read(word: &str) -> Result<Self, String> {
        match word {
            "least" => Ok(Firing::LeastUneven),
            "most" => Ok(Firing::MostUneven),
            "even" => Ok(Firing::MoreEvenThanBefore),
            _ => Err(format!("cannot read the firing `{word}`; least, most or even")),
        }
    }

    pub fn in_words(self) -> &'static str {
        match self {
            Firing::LeastUneven => "the firing is the least uneven of the grid",
            Firing::MostUneven => "the firing is the most uneven of the grid",
            Firing::MoreEvenThanBefore => "the firing is more even than one step before",
        }
    }
}

impl Weighs {
    fn read(word: &str) -> Result<Self, String> {
        match word {
            "lightest" => Ok(Weighs::Least),
            "heaviest" => Ok(Weighs::Most),
            "lighter" => Ok(Weighs::LessThanBefore),
            _ => Err(format!("cannot read the flywheel `{word}`; lightest, heaviest or lighter")),
        }
    }

    pub fn in_words(self) -> &'static str {
        match self {
            Weighs::Least => "the flywheel is the lightest of the grid",
            Weighs::Most => "the flywheel is the heaviest of the grid",
            Weighs::LessThanBefore => "the flywheel is lighter than one step before",
        }
    }
}

impl CheckTable {
    /// The one thing that the check claims.
    pub fn read(&self) -> Result<Check, String> {
        let values = |list: &[Word]| {
            let value = |text: &Word| parse_number(&text.0).map_err(|error| error.to_string());
            let mut values = list.iter().map(value).collect::<Result<Vec<_>, String>>()?;
            values.sort();
            Ok::<_, String>(values)
        };
        let engine = &self.engine.0;
        let at = match (&self.met_at, &self.only_at) {
            (Some(list), None) => Some(Values::Among(values(list)?)),
            (None, Some(list)) => Some(Values::Only(values(list)?)),
            (None, None) => None,
            (Some(_), Some(_)) => return Err(format!("a check of `{engine}` with both met_at and only_at")),
        };
        let needed = || format!("a check of `{engine}` that needs met_at or only_at");
        let without = |at: Option<Values>, check: Check| match at {
            None => Ok(check),
            Some(_) => Err(format!("a check of `{engine}` that is not about values has neither met_at nor only_at")),
        };
        let claims = [
            ("says", &self.says),
            ("vanishes", &self.vanishes),
            ("constant", &self.constant),
            ("firing", &self.firing),
            ("counterweight", &self.counterweight),
            ("volume_below", &self.volume_below),
            ("flywheel", &self.flywheel),
            ("torque_vanishes", &self.torque_vanishes),
        ];
        let mut claims = claims.into_iter().filter_map(|(key, words)| Some((key, words.as_ref()?.0.clone())));
        let (Some((key, words)), None) = (claims.next(), claims.next()) else {
            return Err(format!("a check of `{engine}` that says nothing, or two things"));
        };
        match key {
            "says" => without(at, Check::Says(words)),
            "vanishes" => Ok(Check::Vanishes { part: Part::read(words)?, at }),
            "constant" => {
                let part = Part::read(words).and_then(Part::whole)?;
                Ok(Check::Constant { part, at: at.ok_or_else(needed)? })
            }
            "firing" => Ok(Check::Fires { how: Firing::read(&words)?, at: at.ok_or_else(needed)? }),
            "counterweight" => without(at, Check::Counterweight(words)),
            "volume_below" => without(at, Check::VolumeBelow(words)),
            "flywheel" => Ok(Check::Flywheel { how: Weighs::read(&words)?, at: at.ok_or_else(needed)? }),
            _ => {
                let order = words.parse::<CycleOrder>().map_err(|error| error.to_string())?;
                Ok(Check::TorqueVanishes { order, at: at.ok_or_else(needed)? })
            }
        }
    }
}

impl Part {
    /// `moment 2 along`, `force 1`.
    fn read(words: String) -> Result<Self, String> {
        let parts: Vec<&str> = words.split_whitespace().collect();
        let (name, order, of) = match parts.as_slice() {
            [name, order] => (*name, *order, Some(Zeros::Largest)),
            [name, order, "along"] => (*name, *order, Some(Zeros::Along)),
            [name, order, "across"] => (*name, *order, Some(Zeros::Across)),
            [name, order, "direct"] => (*name, *order, Some(Zeros::Direct)),
            [name, order, "reverse"] => (*name, *order, Some(Zeros::Reverse)),
            _ => ("", "", None),
        };
        let quantity = match name {
            "moment" => Some(Planar::Moment),
            "force" => Some(Planar::Force),
            _ => None,
        };
        match (quantity, order.parse(), of) {
            (Some(quantity), Ok(order), Some(of)) => Ok(Part { words, quantity, order, of }),
            _ => Err(format!("cannot read `{words}`; such as `moment 2 along`")),
        }
    }

    /// The quantity itself: a part of it has no constant length.
    fn whole(self) -> Result<Self, String> {
        match self.of {
            Zeros::Largest => Ok(self),
            Zeros::Direct | Zeros::Reverse | Zeros::Along | Zeros::Across => {
                Err(format!("`{}` names a part; such as `moment 2`", self.words))
            }
        }
    }
}
