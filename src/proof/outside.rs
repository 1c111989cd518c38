//! What may stand outside of `evidence`: numbers and their labels, and no verdict?

use serde_json::{Map, Value};

use super::reading::{Format, Unreadable};

/// What stands at one place.
enum Kind {
    /// A number; null where there is none.
    Number,
    /// One of these labels.
    Label(&'static [&'static str]),
    /// A person's text.
    Text,
    /// Any number of them.
    List(&'static Kind),
    /// A label with its number.
    Pair(&'static [&'static str]),
    /// These keys and no other.
    Object(&'static [Key]),
    /// It, or null.
    OrNull(&'static Kind),
    /// What is checked elsewhere.
    Checked,
}

/// A key, whether it may be left out, and what stands there.
type Key = (&'static str, bool, Kind);

const AMPLITUDES: Kind = Kind::Label(&["zero-to-peak"]);
const EFFECTS: &[&str] = &["reciprocating", "rotating", "crankshaft", "counterweights", "balancers"];
const NUMBERS: Kind = Kind::List(&Kind::Number);

const VECTOR: Kind = Kind::Object(&[
    ("amplitude", false, Kind::Number),
    ("angle_deg", false, Kind::Number),
    ("below", true, Kind::Number),
]);
const ORDER: Kind = Kind::Object(&[
    ("quantity", false, Kind::Label(&["force", "moment"])),
    ("order", false, Kind::Number),
    ("direct", false, VECTOR),
    ("reverse", false, VECTOR),
    ("largest", false, Kind::Number),
    ("smallest", false, Kind::Number),
    ("direction_deg", false, Kind::Number),
    ("along", false, Kind::Number),
    ("across", false, Kind::Number),
    ("dimensionless", false, Kind::Number),
]);
const TORQUE: Kind = Kind::Object(&[
    ("order", false, Kind::Number),
    ("amplitude", false, Kind::Number),
    ("phase_deg", false, Kind::Number),
    ("dimensionless", false, Kind::Number),
]);
const LARGEST: Kind = Kind::Object(&[
    ("value", false, Kind::Number),
    ("theta_deg", false, Kind::Number),
    ("error_bound", false, Kind::Number),
]);
const PEAK: Kind = Kind::Object(&[
    ("value", false, Kind::Number),
    ("crank_angle_deg", false, Kind::Number),
    ("effects", false, Kind::List(&Kind::Pair(EFFECTS))),
]);
const BOUND: Kind = Kind::OrNull(&Kind::Object(&[("at_most", false, Kind::Number), ("part", false, Kind::Number)]));

const LOADS: Kind = Kind::Object(&[
    ("format", false, Kind::Checked),
    ("title", false, Kind::Checked),
    ("amplitudes", false, AMPLITUDES),
    (
        "units",
        false,
        Kind::Object(&[
            ("force", false, Kind::Label(&["N", "m r ω²"])),
            ("moment", false, Kind::Label(&["N m", "N a", "m r ω² · 1 m", "m r ω² a"])),
            ("torque", false, Kind::Label(&["N m", "m r² ω²"])),
        ]),
    ),
    (
        "scale",
        false,
        Kind::OrNull(&Kind::Object(&[
            ("mass_kg", false, Kind::Number),
            ("crank_radius_m", false, Kind::Number),
            ("speed_rpm", false, Kind::Number),
            ("angular_speed_rad_s", false, Kind::Number),
            ("m_r_omega_squared_n", false, Kind::Number),
        ])),
    ),
    ("effects", false, Kind::List(&Kind::Label(EFFECTS))),
    (
        "coefficients",
        false,
        Kind::List(&Kind::Object(&[
            ("order", false, Kind::Number),
            ("re", false, Kind::Number),
            ("im", false, Kind::Number),
        ])),
    ),
    ("orders", false, Kind::List(&ORDER)),
    ("torque", false, Kind::List(&TORQUE)),
    ("roll", true, Kind::List(&TORQUE)),
    (
        "largest",
        false,
        Kind::Object(&[("force", false, LARGEST), ("moment", false, LARGEST), ("inertia_torque", true, LARGEST)]),
    ),
    ("peaks", false, Kind::Object(&[("force", false, PEAK), ("moment", false, PEAK), ("torque", true, PEAK)])),
    (
        "left_out",
        false,
        Kind::Object(&[("force", false, BOUND), ("moment", false, BOUND), ("inertia_torque", false, BOUND)]),
    ),
    ("coefficients_computed", false, Kind::Number),
    (
        "auto",
        true,
        Kind::Object(&[
            ("accuracy", false, Kind::Number),
            ("kept", false, NUMBERS),
            ("dropped", false, NUMBERS),
            ("torque_kept", false, NUMBERS),
            ("torque_dropped", false, NUMBERS),
            ("looked_at", false, Kind::Number),
        ]),
    ),
    ("evidence", false, Kind::Checked),
]);

const AMOUNT: Kind = Kind::Object(&[("largest", false, Kind::Number)]);
const WORST: Kind = Kind::Object(&[
    ("bearings", false, NUMBERS),
    ("peak", false, Kind::Number),
    ("unit", false, Kind::Label(&["N", "m r ω²"])),
]);
const ENGINE: Kind = Kind::Object(&[
    ("title", false, Kind::Text),
    ("position_unit", false, Kind::Label(&["m", "spacing"])),
    ("firing", false, Kind::OrNull(&Kind::Object(&[("intervals_deg", false, NUMBERS)]))),
    (
        "orders",
        false,
        Kind::List(&Kind::Object(&[
            ("order", false, Kind::Number),
            ("force", false, AMOUNT),
            ("moment", false, AMOUNT),
        ])),
    ),
    (
        "newtons",
        false,
        Kind::OrNull(&Kind::List(&Kind::Object(&[
            ("order", false, Kind::Number),
            ("force", false, Kind::Number),
            ("moment", false, Kind::Number),
        ]))),
    ),
    ("worst_bearings", false, Kind::OrNull(&WORST)),
    ("worst_bearing_with_gas", true, WORST),
]);
const COMPARE: Kind = Kind::Object(&[
    ("format", false, Kind::Checked),
    ("orders", false, NUMBERS),
    ("amplitudes", false, AMPLITUDES),
    ("engines", false, Kind::List(&ENGINE)),
    ("evidence", false, Kind::Checked),
]);

/// Refuses a document of loads or of a comparison that says more outside of its evidence than numbers.
pub(super) fn check(format: Format, tree: &Value) -> Result<(), Unreadable> {
    let found = match format {
        Format::Loads => LOADS.fits("", tree),
        Format::Compare => COMPARE.fits("", tree),
        Format::Classify | Format::Family | Format::Remedy | Format::Firing | Format::Sweep => Ok(()),
    };
    found.map_err(Unreadable::Malformed)
}

impl Kind {
    fn fits(&self, place: &str, value: &Value) -> Result<(), String> {
        let due = |what: &str| Err(format!("{place}: {value} stands where {what} is due"));
        match (self, value) {
            (Kind::Checked, _) | (Kind::Number, Value::Number(_) | Value::Null) | (Kind::Text, Value::String(_)) => {
                Ok(())
            }
            (Kind::OrNull(_), Value::Null) => Ok(()),
            (Kind::OrNull(kind), _) => kind.fits(place, value),
            (Kind::Label(labels), Value::String(text)) if labels.contains(&text.as_str()) => Ok(()),
            (Kind::List(kind), Value::Array(list)) => {
                let mut entries = list.iter().enumerate();
                entries.try_for_each(|(index, entry)| kind.fits(&format!("{place}[{index}]"), entry))
            }
            (Kind::Pair(labels), Value::Array(list)) => match &list[..] {
                [label, number] => {
                    Kind::Label(labels).fits(place, label)?;
                    Kind::Number.fits(place, number)
                }
                _ => due("a label with its number"),
            },
            (Kind::Object(keys), Value::Object(map)) => fit(keys, place, map),
            (Kind::Number, _) => due("a number"),
            (Kind::Label(_), _) => due("a label"),
            (Kind::Text, _) => due("a text"),
            (Kind::List(_) | Kind::Pair(_), _) => due("a list"),
            (Kind::Object(_), _) => due("an object"),
        }
    }
}

fn fit(keys: &[Key], place: &str, map: &Map<String, Value>) -> Result<(), String> {
    let at = |key: &str| if place.is_empty() { key.to_owned() } else { format!("{place}.{key}") };
    if let Some(key) = map.keys().find(|key| keys.iter().all(|(known, ..)| known != key)) {
        return Err(format!("{}: nothing is known of this key", at(key)));
    }
    for (key, may_lack, kind) in keys {
        match map.get(*key) {
            Some(value) => kind.fits(&at(key), value)?,
            None if *may_lack => (),
            None => return Err(format!("{}: is missing", at(key))),
        }
    }
    Ok(())
}
