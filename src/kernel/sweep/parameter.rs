//! Which value of a layout file is swept? Its key, the words for it, and its range.

use num_rational::BigRational;

use super::SweepError;
use super::range::Range;
use crate::file::{self, Key, Template};

/// A value of the layout file and the values that it takes.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Parameter {
    /// Where it is in the file.
    pub key: Key,
    /// What it is called.
    pub label: String,
    /// Its values.
    pub range: Range,
    /// Keys of the file that say the same in another way, and give way to it.
    pub(super) instead_of: &'static [&'static str],
}

/// A parameter that has a flag of its own: its flag, its key where that is the same for all forms, what it replaces.
pub struct ShortCut {
    /// The flag without its dashes.
    pub flag: &'static str,
    /// The key by form; a form that has none is not listed. `*` stands for every form.
    keys: &'static [(&'static str, &'static str)],
    instead_of: &'static [&'static str],
}

/// The parameters with flags of their own.
pub const SHORT_CUTS: [ShortCut; 6] = [
    ShortCut {
        flag: "bank-angle",
        keys: &[("vee", "vee.bank_angle"), ("vr", "vr.bank_angle"), ("w", "w.bank_angle")],
        instead_of: &[],
    },
    ShortCut { flag: "pin-split", keys: &[("vee", "vee.pin_split")], instead_of: &[] },
    ShortCut {
        flag: "spacing",
        keys: &[
            ("inline", "inline.spacing"),
            ("vee", "vee.spacing"),
            ("flat", "flat.spacing"),
            ("boxer", "boxer.spacing"),
            ("fan", "fan.spacing"),
            ("vr", "vr.spacing"),
            ("w", "w.spacing"),
            ("radial", "radial.row_spacing"),
        ],
        instead_of: &[
            "inline.positions",
            "vee.positions",
            "flat.positions",
            "boxer.positions",
            "fan.positions",
            "vr.positions",
            "w.positions",
        ],
    },
    ShortCut { flag: "rod-ratio", keys: &[("*", "mechanism.rod_ratio")], instead_of: &["mechanism.rod_length"] },
    ShortCut {
        flag: "balance-factor",
        keys: &[("*", "crankshaft.balance_factor")],
        instead_of: &["counterweight", "crankshaft.counterweights"],
    },
    ShortCut { flag: "speed", keys: &[("*", "speed")], instead_of: &[] },
];

/// Keys of a layout file that hold no quantity.
const TEXTS: [&str; 8] = ["title", "source", "name", "document", "cycle", "effects", "orders", "firing_order"];

impl Parameter {
    /// Reads `KEY=FROM..TO:STEP`.
    ///
    /// # Errors
    /// What cannot be read.
    pub fn parse(text: &str) -> Result<Self, SweepError> {
        let (key, range) = text.split_once('=').ok_or_else(|| {
            SweepError::new(format!("`{text}` sets nothing; write KEY=FROM..TO:STEP, such as vee.bank_angle=0..180:10"))
        })?;
        let key = Key::parse(key.trim()).map_err(SweepError::new)?;
        if key.to_string().split('.').any(|part| TEXTS.contains(&part)) {
            return Err(SweepError::new(format!("`{key}` holds no quantity; such as vee.bank_angle=0..180:10")));
        }
        Ok(Parameter { label: key.name().replace('_', " "), key, range: Range::parse(range)?, instead_of: &[] })
    }

    /// The parameter of a flag of [`SHORT_CUTS`] for the form of this layout.
    ///
    /// # Errors
    /// A form that has no such key, or a range that cannot be read.
    pub fn short_cut(flag: &str, range: &str, template: &Template) -> Result<Self, SweepError> {
        let found = SHORT_CUTS.iter().find(|known| known.flag == flag);
        let Some(known) = found else { return Err(SweepError::new(format!("there is no flag --{flag}"))) };
        let form = template.form().unwrap_or_default();
        let key = known.keys.iter().find(|(of, _)| *of == "*" || *of == form).map(|(_, key)| *key);
        let Some(key) = key else {
            let forms: Vec<String> = known.keys.iter().map(|(form, _)| format!("[{form}]")).collect();
            let message = format!("--{flag} is for layouts of the form {}, and this one is [{form}]", forms.join(", "));
            return Err(SweepError::new(format!("{message}; --set KEY={range} takes any key of the file")));
        };
        let range = Range::parse(range).map_err(|error| SweepError::new(format!("--{flag}: {error}")))?;
        let key = Key::parse(key).map_err(SweepError::new)?;
        Ok(Parameter { label: flag.replace('-', " "), key, range, instead_of: known.instead_of })
    }

    /// The unit of its values: that of the range, else the one in which a bare number of this key counts; empty where that has none.
    pub fn unit(&self) -> &str {
        match (self.range.unit(), file::number_kind(&self.key.to_string())) {
            ("", Some("speed")) => "rpm",
            ("", Some("angle")) => "°",
            (unit, _) => unit,
        }
    }

    /// The template without the keys that give way to this parameter.
    pub(super) fn prepared<'a>(&self, template: &Template<'a>) -> Template<'a> {
        template.without(self.instead_of)
    }

    /// The name of a column: `bank_angle`, `bank_angle_mm`.
    pub fn column(&self) -> String {
        let name = self.label.replace(' ', "_");
        let unit: String = self.range.unit().chars().filter(|letter| letter.is_ascii_alphanumeric()).collect();
        if unit.is_empty() { name } else { format!("{name}_{unit}") }
    }

    /// `vee.bank_angle = 90`.
    pub(super) fn at(&self, value: &BigRational) -> String {
        format!("{} = {}", self.key, self.range.written(value))
    }
}
