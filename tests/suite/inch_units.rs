//! Do pages in pounds and inches say the same as those in newtons and metres?

use crankstar::loads::{Method, bearing_loads};
use crankstar::page::figure::Mark;
use crankstar::page::{self, Block, Document, Format, Options, Piece, Text, Unit, Units};
use crankstar::remedy::{Request, remedy};
use crankstar::report::{self, Numbers, Question, TorqueStudy};

use crate::support::written::engine as read;

const V8: &str = include_str!("../../reports/examples/v8-gas/layout.toml");
const I3: &str = include_str!("../../reports/examples/thesis-i3/layout.toml");

/// The units of the inch in those of the SI, as handbooks print them.
const SIZES: [(&str, &str, f64); 17] = [
    ("N", "lbf", 4.448222),
    ("N·m", "lbf·ft", 1.355818),
    ("N·a", "lbf·a", 4.448222),
    ("kg", "lb", 0.4535924),
    ("kg·m", "oz·in", 7.200779e-4),
    ("kg·mm", "oz·in", 0.7200779),
    ("m", "in", 0.0254),
    ("mm", "in", 25.4),
    ("cm³", "in³", 16.38706),
    ("J", "ft·lbf", 1.355818),
    ("kW", "hp", 0.7456999),
    ("bar", "psi", 0.06894757),
    ("kg·m²", "lb·ft²", 0.04214011),
    ("m/s", "ft/s", 0.3048),
    ("m/s²", "ft/s²", 0.3048),
    ("N·m/rad", "lbf·ft/rad", 1.355818),
    ("m r ω²·1 m", "m r ω²·1 in", 0.0254),
];

fn printed(text: &Text, units: Units) -> String {
    let mut document = Document::new("one", "");
    document.push(Block::Paragraph(text.clone()));
    let files = page::write(&document, Format::PLAIN, &Options { units, ..Options::default() });
    files[0].text.trim().to_owned()
}

/// The number that a text begins with, after ≈ or not.
fn number(text: &str) -> Option<f64> {
    let plain = text.trim_start_matches(['≈', '\u{a0}', ' ']).replace('−', "-");
    let end = plain.find(|letter: char| !"-.0123456789/·⁻⁰¹²³⁴⁵⁶⁷⁸⁹".contains(letter)).unwrap_or(plain.len());
    let plain = &plain[..end];
    let (digits, power) = plain.split_once("·10").unwrap_or((plain, ""));
    let superscripts = ['⁰', '¹', '²', '³', '⁴', '⁵', '⁶', '⁷', '⁸', '⁹'];
    let power: String = power
        .chars()
        .map(|letter| match superscripts.iter().position(|one| *one == letter) {
            Some(digit) => char::from_digit(digit as u32, 10).expect("a digit"),
            None => '-',
        })
        .collect();
    let (above, below) = digits.split_once('/').unwrap_or((digits, "1"));
    let value = above.parse::<f64>().ok()? / below.parse::<f64>().ok()?;
    Some(value * 10_f64.powi(if power.is_empty() { 0 } else { power.parse().ok()? }))
}

/// Every quantity in a text, in those inside it too.
fn quantities<'a>(text: &'a Text, found: &mut Vec<(&'a Piece, Unit)>) {
    for piece in text.pieces() {
        match piece {
            Piece::Phrase(_, values) => values.iter().for_each(|value| quantities(value, found)),
            Piece::Quantity(_, unit)
            | Piece::Measured(_, unit, _)
            | Piece::Exactly(_, unit)
            | Piece::Shortly(_, unit) => found.push((piece, *unit)),
            Piece::Link(text, _) => quantities(text, found),
            _ => {}
        }
    }
}

fn texts(blocks: &[Block]) -> Vec<&Text> {
    let mut all = Vec::new();
    for block in blocks {
        match block {
            Block::Paragraph(text) | Block::Note(text) | Block::Heading(_, text) => all.push(text),
            Block::Answer(list) | Block::List(list) => all.extend(list),
            Block::Table(table) => all.extend(table.header.iter().chain(table.rows.iter().flatten())),
            Block::Folded(fold) => all.extend(texts(&fold.blocks)),
            _ => {}
        }
    }
    all
}

/// Each quantity of a document, printed in inches and pounds and converted back, is that of the SI; how many there are.
fn assert_agrees(document: &Document) -> usize {
    let mut found = Vec::new();
    texts(&document.blocks).into_iter().for_each(|text| quantities(text, &mut found));
    let mut compared = 0;
    for (piece, unit) in &found {
        let text = Text::from((*piece).clone());
        let [si, inch] = [Units::Si, Units::Inch].map(|units| printed(&text, units));
        let Some((_, name, size)) = SIZES.iter().find(|(known, ..)| *known == unit.name) else {
            assert_eq!(si, inch, "{} is in no other units", unit.name);
            continue;
        };
        assert_eq!(Units::Inch.of(1.0, *unit).1.name, *name);
        let shows_unit = matches!(piece, Piece::Quantity(..));
        assert!(!shows_unit || (si.ends_with(unit.name) && inch.ends_with(name)), "{si} and {inch}");
        let (Some(before), Some(after)) = (number(&si), number(&inch)) else { panic!("{si} and {inch}") };
        let places = 6e-3 * before.abs() + 6e-4 * size;
        assert!((after * size - before).abs() <= places, "{si} and {inch}");
        compared += 1;
    }
    compared
}

#[test]
fn each_quantity_in_pounds_and_inches_converts_back_to_that_of_the_si() {
    let engine = read(V8);
    let numbers = Numbers::new(&engine, &[1, 2, 4], None).expect("numbers");
    assert!(assert_agrees(&report::loads_answer(&engine, &numbers, None, None)) > 1);
    let torque = TorqueStudy::new(&engine).expect("a torque");
    assert!(assert_agrees(&torque.page()) > 10);
    let i3 = read(I3);
    let remedy = remedy(&i3, &Request { orders: vec![1, 2], ..Request::default() }).expect("a remedy");
    assert!(assert_agrees(&report::remedy_page(&remedy)) > 5);
    let supported = read(I3);
    let [continuous, determinate] = [Method::Continuous, Method::Determinate]
        .map(|method| bearing_loads(&supported, &[1, 2], method).expect("loads"));
    assert!(assert_agrees(&report::bearings_answer(&supported, &continuous, &determinate)) > 5);
}

#[test]
fn the_table_of_units_is_that_of_the_handbooks() {
    let all = [
        Unit::NEWTON,
        Unit::NEWTON_METRE,
        Unit::NEWTON_SPACING,
        Unit::KILOGRAM,
        Unit::KILOGRAM_METRE,
        Unit::KILOGRAM_MILLIMETRE,
        Unit::METRE,
        Unit::MILLIMETRE,
        Unit::CUBIC_CENTIMETRE,
        Unit::JOULE,
        Unit::KILOWATT,
        Unit::BAR,
        Unit::KILOGRAM_SQUARE_METRE,
        Unit::METRE_PER_SECOND,
        Unit::METRE_PER_SQUARE_SECOND,
        Unit::NEWTON_METRE_PER_RADIAN,
        Unit::MULTIPLE_METRE,
    ];
    for (unit, (name, inch, size)) in all.into_iter().zip(SIZES) {
        assert_eq!(unit.name, name);
        let (value, other) = Units::Inch.of(size, unit);
        assert_eq!(other.name, inch);
        assert!((value - 1.0).abs() < 3e-7, "{name}: {value}");
        assert_eq!(Units::Si.of(size, unit), (size, unit));
    }
    assert_eq!(Units::Inch.of(90.0, Unit::DEGREE), (90.0, Unit::DEGREE));
}

#[test]
fn headings_and_drawings_change_their_units_with_the_numbers() {
    let i3 = read(I3);
    let numbers = Numbers::new(&i3, &[1, 2], None).expect("numbers");
    let document = report::loads_answer(&i3, &numbers, None, None);
    let files = |units| page::write(&document, Format::PLAIN, &Options { units, ..Options::default() })[0].text.clone();
    let (si, inch) = (files(Units::Si), files(Units::Inch));
    assert!(si.contains("N·m") && !si.contains("lbf"), "{si}");
    assert!(inch.contains("lbf·ft") && !inch.contains("N·m"), "{inch}");
    let page = report::loads_page(&i3, &numbers, None);
    let pictures = page.pictures();
    let drawn = pictures.iter().find(|picture| picture.name == "moment-along").expect("a plot of the moment");
    let words = |figure: &page::figure::Figure| -> Vec<String> {
        let text = |mark: &Mark| match mark {
            Mark::Text { text, .. } => Some(text.clone()),
            _ => None,
        };
        figure.marks.iter().filter_map(text).collect()
    };
    assert!(words(&drawn.figure).iter().any(|text| text.contains("N·m")));
    let inches = drawn.figure.in_inches.as_ref().expect("the plot in pounds");
    assert!(words(inches).iter().any(|text| text.contains("lbf·ft")));
    let mut formulas = Document::new("one", "");
    formulas.push(Block::Formula("F = 9862\\,\\mathrm{N}".into(), None));
    let text = &page::write(&formulas, Format::PLAIN, &Options { units: Units::Inch, ..Options::default() })[0].text;
    assert!(text.split_whitespace().collect::<Vec<_>>().join(" ").contains("into the formulas in SI units"), "{text}");
}

#[test]
fn inches_pounds_and_ounces_are_read_as_their_size_is_defined() {
    let engine = |keys: &str| read(&format!("inline.throws = [0, 180]\n[mechanism]\n{keys}"));
    let pairs = [
        ("stroke = '3 in'\nrod_length = '1/2 ft'", "stroke = '76.2 mm'\nrod_length = '152.4 mm'"),
        ("crank_radius = 1\nreciprocating_mass = '16 oz'", "crank_radius = 1\nreciprocating_mass = '1 lb'"),
        ("crank_radius = 1\nreciprocating_mass = '1 lb'", "crank_radius = 1\nreciprocating_mass = '453.59237 g'"),
    ];
    for (inch, si) in pairs {
        let [inch, si] = [engine(inch), engine(si)];
        assert_eq!(inch.dimensions().crank_radius, si.dimensions().crank_radius);
        assert_eq!(inch.dimensions().mass, si.dimensions().mass);
        assert_eq!(inch.cylinders(), si.cylinders());
    }
    let shaft = |size: &str| {
        let text = format!("[[balancer]]\norder = 2\nsense = 'with'\nmass_radius = '{size}'\nangle = 0\nposition = 0");
        engine(&format!("crank_radius = 1\nreciprocating_mass = 1\n{text}")).crankshaft().balancers[0]
            .mass_radius
            .clone()
    };
    assert_eq!(shaft("16 oz in"), shaft("1 lb in"));
    assert_eq!(shaft("12 lb in"), shaft("1 lb ft"));
    assert_eq!(shaft("1 lb in"), shaft("11521.246198 g mm"));
}

#[test]
fn every_spelling_of_a_unit_is_read() {
    let inertia = |size: &str| {
        let engine = read(&format!("inline.throws = [0, 180]\n[flywheel]\ninertia = '{size}'\n"));
        engine.flywheel().inertia.clone().expect("an inertia")
    };
    let squares =
        [("kg m", 1.0), ("kg cm", 1e-4), ("g m", 1e-3), ("lb ft", 0.0421401100938048), ("lb in", 2.926396534292e-4)];
    for (unit, size) in squares {
        for unit in [unit.to_owned(), unit.replace(' ', "·")] {
            for square in ["²", "^2", "2"] {
                for space in ["", " "] {
                    let found = crankstar::numbers::float(&inertia(&format!("300{space}{unit}{square}")));
                    assert!((found - 300.0 * size).abs() < 1e-9 * found, "{unit}{square}: {found}");
                }
            }
        }
    }
    let weight = |size: &str| {
        read(&format!(
            "inline.throws = [0, 180]\n[mechanism]\ncrank_radius = 1\nreciprocating_mass = 1\n[[balancer]]\norder = 2\nsense = 'with'\n\
             mass_radius = '{size}'\nangle = 0\nposition = 0\n"
        ))
        .crankshaft()
        .balancers[0]
            .mass_radius
            .clone()
    };
    for unit in ["kg mm", "kg m", "g mm", "g cm", "g m", "oz in", "lb in", "lb ft"] {
        assert_eq!(weight(&format!("3 {unit}")), weight(&format!("3 {}", unit.replace(' ', "·"))), "{unit}");
    }
}
