//! Which engines can be picked, and what may be claimed?

use serde_json::{Value, json};

use super::mistake::Mistake;
use crate::engine::Form;
use crate::file;
use crate::report::moving;
use crate::text::Format;

/// Layouts that the catalogue has none of: with open angles, with numbers, with counterweights.
const STARTERS: [(&str, &str, &str); 4] = [
    (
        "open-v6",
        "V6 on shared pins, its bank angle left open",
        "title = \"V6, shared pins, open bank angle\"\n\n[vee]\nbank_angle = \"phi\"\nthrows = [0, 240, 120]\n",
    ),
    (
        "open-v8",
        "V8 of a cross-plane crankshaft, moved from 90°",
        "title = \"V8, cross-plane crankshaft, any bank angle\"\nvalues = { phi = 90 }\n\n[vee]\nbank_angle = \"phi\"\nthrows = [0, 270, 90, 180]\n",
    ),
    (
        "i4-numbers",
        "In-line four in newtons",
        "title = \"In-line four with numbers\"\ncycle = \"four-stroke\"\nfiring_order = \"1-3-4-2\"\nspeed = \"6000 rpm\"\neffects = [\"torque\", \"remedy\"]\n\n[inline]\nthrows = [0, 180, 180, 0]\nspacing = \"90 mm\"\n\n[mechanism]\nstroke = \"86 mm\"\nrod_ratio = 0.3\nreciprocating_mass = \"0.55 kg\"\nrotating_mass = \"0.45 kg\"\n",
    ),
    (
        "v-twin",
        "V-twin with counterweights",
        "title = \"V-twin, 90°, half of the reciprocating masses balanced\"\n\n[vee]\nbank_angle = 90\nthrows = [0]\n\n[mechanism]\nstroke = \"80 mm\"\nrod_ratio = 0.25\nreciprocating_mass = \"0.5 kg\"\nrotating_mass = \"0.4 kg\"\n\n[crankshaft]\ncounterweights = { rotating = 1, reciprocating = 0.5 }\ncounterweight_radius = \"40 mm\"\n",
    ),
];

/// Claims to begin with, each as the grammar reads it.
const CLAIMS: [&str; 5] = [
    "second-order force vanishes",
    "first-order moment is rotating",
    "every order of the force vanishes",
    "no free moment",
    "order 2 needs a Lanchester pair",
];

/// What the page shows beside any engine: the version, claims to begin with, and what makes an engine move.
pub(super) fn begin() -> Value {
    json!({
        "version": env!("CARGO_PKG_VERSION"),
        "claims": CLAIMS,
        "moving": { "style": moving::MOVING_STYLE, "script": moving::MOVING_SCRIPT },
    })
}

/// The layout of one engine: no other is built for it.
pub(super) fn engine(name: &str) -> Result<Value, Mistake> {
    let entry = file::find(name)
        .ok_or_else(|| Mistake::plain("the catalogue has no engine of this name", "`catalogue` lists them"))?;
    Ok(json!({ "name": entry.name, "text": entry.text }))
}

/// The engines known by name with their layouts, and further layouts.
pub(super) fn catalogue() -> Result<Value, Mistake> {
    let engines = file::catalogue().map_err(|error| Mistake::of(&error))?;
    let engines = engines.iter().map(|(entry, engine)| {
        let title = engine.title().escaped(Format::Plain);
        json!({ "name": entry.name, "title": title, "group": group(engine.form()), "text": entry.text })
    });
    let starters = STARTERS.map(|(name, title, text)| json!({ "name": name, "title": title, "text": text }));
    Ok(json!({
        "engines": engines.collect::<Vec<_>>(),
        "starters": starters,
    }))
}

/// Under which heading engines of a form stand.
fn group(form: Form) -> &'static str {
    match form {
        Form::Inline => "In line",
        Form::Vee => "V engines",
        Form::Flat => "Flat, on shared pins",
        Form::Boxer => "Boxers",
        Form::Fan => "W and fans",
        Form::Vr => "VR",
        Form::W => "W of narrow Vs",
        Form::Radial => "Radials",
        Form::OpposedPiston => "Opposed pistons",
        Form::U => "U",
        Form::H => "H",
        Form::Delta => "Deltas",
        Form::General => "Others",
    }
}
