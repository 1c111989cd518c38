//! Has a decimal the figures that a reader asks for, and does nothing else change with them?

use crankstar::page::{self, Block, Document, Figures, Format, Options, Piece, Text, Unit};

use crate::support::program::program;

fn set(text: Text, figures: usize) -> String {
    let mut document = Document::new("one", "");
    document.push(Block::Paragraph(text));
    let options = Options { figures: Figures::new(figures), ..Options::default() };
    page::write(&document, Format::PLAIN, &options)[0].text.trim().to_owned()
}

/// The number that a text begins with, after ≈ or not.
fn read(text: &str) -> f64 {
    let number =
        text.trim_start_matches(['≈', '\u{a0}', ' ']).split(['\u{202f}', '\u{a0}', ' ']).next().expect("a number");
    let mut ascii = number.replace('−', "-").replace("·10", "e").replace('⁻', "-");
    for (digit, sign) in "⁰¹²³⁴⁵⁶⁷⁸⁹".chars().enumerate() {
        ascii = ascii.replace(sign, &digit.to_string());
    }
    ascii.parse().unwrap_or_else(|_| panic!("{text} is no number"))
}

/// Numbers of all sizes, the same in each run.
fn values() -> impl Iterator<Item = f64> {
    (0..4000_u64).map(|index| {
        let bits = index.wrapping_mul(0x9E37_79B9_7F4A_7C15) ^ (index << 31);
        let mantissa = 1.0 + 9.0 * (bits >> 11) as f64 / (1_u64 << 53) as f64;
        let size = mantissa * 10_f64.powi((bits % 26) as i32 - 13);
        if bits & 64 == 0 { size } else { -size }
    })
}

#[test]
fn a_decimal_is_rounded_to_the_figures_that_are_asked_for() {
    for (value, figures) in values().zip((1..=12).cycle()) {
        // The standard library's exact rounding is the other method.
        let right: f64 = format!("{value:.*e}", figures - 1).parse().expect("a float");
        for text in [Piece::Quantity(value, Unit::KILOGRAM).into(), Text::measured(value, Unit::KILOGRAM)] {
            let printed = set(text, figures);
            let is_whole = !printed.contains(['.', '·']);
            // A whole number keeps all of its figures.
            let right = if is_whole && value.abs() >= 1.0 && value.abs() < 1e7 { value.round() } else { right };
            assert!((read(&printed) - right).abs() <= 1e-14 * right.abs(), "{value} to {figures}: {printed}");
        }
    }
}

#[test]
fn zero_and_nothing_finite_are_printed_as_they_are() {
    for figures in [1, 4, 12] {
        assert_eq!(set(Text::measured(0.0, Unit::NEWTON), figures), "≈ 0");
        assert_eq!(set(Text::measured(-0.0, Unit::NEWTON), figures), "≈ 0");
        assert_eq!(set(Text::zero(), figures), "0");
        assert_eq!(set(Text::measured(f64::NAN, Unit::NEWTON), figures), "≈ NaN");
    }
}

fn printed(arguments: &[&str]) -> String {
    let out = program().args(arguments).output().expect("the program runs");
    assert!(out.status.success(), "{arguments:?}: {}", String::from_utf8_lossy(&out.stderr));
    String::from_utf8(out.stdout).expect("a text")
}

const I3: &str = "reports/examples/thesis-i3/layout.toml";

#[test]
fn loads_print_the_eight_digits_that_their_table_has() {
    // The primary moment of the three at 6000/min, as `loads --format csv` has it.
    let answer = printed(&["loads", I3, "--digits", "8"]);
    let table = printed(&["loads", I3, "--format", "csv"]);
    let row = table.lines().find(|line| line.starts_with("1,")).expect("order 1");
    let moments = row.split(',').filter_map(|cell| cell.parse::<f64>().ok());
    assert!(moments.into_iter().any(|value| answer.contains(&format!("≈ {value:.4} "))), "{answer}\n{row}");
}

#[test]
fn what_is_zero_and_what_is_a_bound_does_not_change_with_the_digits() {
    for command in ["classify", "loads", "remedy", "bearings"] {
        let usual = printed(&[command, I3]);
        let zeros = |text: &str| text.split_whitespace().filter(|word| *word == "0").count();
        let bounds = |text: &str| {
            text.split_whitespace()
                .collect::<Vec<_>>()
                .join(" ")
                .split("at most ")
                .skip(1)
                .map(|rest| rest.split(' ').next().unwrap_or_default().to_owned())
                .collect::<Vec<_>>()
        };
        for digits in ["2", "6", "12"] {
            let asked = printed(&[command, I3, "--digits", digits]);
            assert_eq!(zeros(&usual), zeros(&asked), "{command} --digits {digits}");
            if command == "loads" {
                assert_eq!(bounds(&usual), bounds(&asked), "{command} --digits {digits}");
            }
        }
    }
}

#[test]
fn digits_that_no_float_has_are_refused() {
    for wrong in ["0", "1", "13", "-3", "many", "4.5"] {
        let out = program().args(["loads", I3, &format!("--digits={wrong}")]).output().expect("the program runs");
        assert_eq!(out.status.code(), Some(2), "{wrong}");
        let message = String::from_utf8_lossy(&out.stderr).into_owned();
        assert!(message.contains(wrong) && message.contains("--digits"), "{message}");
    }
}

#[test]
fn angles_have_the_digits_that_are_asked_for() {
    // The direction of a mass that balances the shaft, and the crank angle of the largest torque.
    for (command, file) in
        [("rotor", "examples/shaft.toml"), ("torque", "reports/examples/v8-gas/layout.toml"), ("bearings", I3)]
    {
        let digits = |text: &str| {
            let words = text.split_whitespace().filter_map(|word| word.split_once('°')).map(|(number, _)| number);
            let decimals = words.filter_map(|number| Some(number.split_once('.')?.1.len()));
            decimals.max().unwrap_or(0)
        };
        let [usual, many] =
            [printed(&[command, file]), printed(&[command, file, "--digits", "9"])].map(|text| digits(&text));
        assert!(usual <= 3 && many >= 5, "{command}: {usual}, {many}");
    }
}
