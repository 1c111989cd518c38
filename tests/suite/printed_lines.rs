//! Does every line of every calculation give, worked out from its printed figures, the printed result?

use std::f64::consts::PI;
use std::fs;
use std::path::Path;

use crankstar::file::{self, Layout};
use crankstar::page::Format;

use crate::support::pages;

/// Reads the arithmetic that the lines are written in: a small part of TeX.
struct Reader<'a> {
    rest: &'a str,
}

impl<'a> Reader<'a> {
    fn value(text: &'a str) -> f64 {
        let mut reader = Reader { rest: text };
        let value = reader.sum();
        assert!(reader.rest.trim().is_empty(), "not read: {:?} of {text:?}", reader.rest);
        value
    }

    fn take(&mut self, word: &str) -> bool {
        self.rest = self.rest.trim_start();
        match self.rest.strip_prefix(word) {
            Some(rest) => {
                self.rest = rest;
                true
            }
            None => false,
        }
    }

    fn sum(&mut self) -> f64 {
        let mut total = if self.take("-") { -self.product() } else { self.product() };
        loop {
            if self.take("+") {
                total += self.product();
            } else if self.take("-") {
                total -= self.product();
            } else {
                return total;
            }
        }
    }

    fn product(&mut self) -> f64 {
        let mut product = self.power();
        while self.take("\\cdot") || self.take("\\times") {
            product *= self.power();
        }
        product
    }

    fn power(&mut self) -> f64 {
        let base = self.atom();
        if self.take("^{\\circ}") {
            return base * PI / 180.0;
        }
        if self.take("^{") {
            let exponent = self.sum();
            assert!(self.take("}"), "an open exponent");
            return base.powf(exponent);
        }
        base
    }

    fn braced(&mut self) -> f64 {
        assert!(self.take("{"), "a brace before {:?}", self.rest);
        let value = self.sum();
        assert!(self.take("}"), "a brace before {:?}", self.rest);
        value
    }

    fn atom(&mut self) -> f64 {
        if self.take("\\frac") {
            let above = self.braced();
            return above / self.braced();
        }
        if self.take("\\sqrt") {
            return self.braced().sqrt();
        }
        if self.take("\\cos") {
            return self.atom().cos();
        }
        if self.take("\\pi") {
            return PI;
        }
        if self.take("\\dots") {
            return 0.0;
        }
        if self.take("\\left(") {
            let value = self.sum();
            assert!(self.take("\\right)"), "a bracket before {:?}", self.rest);
            return value;
        }
        self.rest = self.rest.trim_start();
        let end = self.rest.find(|c: char| !c.is_ascii_digit() && c != '.').unwrap_or(self.rest.len());
        let (number, rest) = self.rest.split_at(end);
        self.rest = rest;
        number.parse().unwrap_or_else(|_| panic!("a number before {rest:?}"))
    }
}

/// The lines of a report: the figures and the result of each.
fn lines(report: &str) -> Vec<(String, String)> {
    let blocks = report.split("\\begin{aligned}").skip(1).filter_map(|block| block.split("\\end{aligned}").next());
    let unbroken = blocks.map(|block| block.replace("\\\\\n", "").replace(['&', '\n'], "").replace("\\quad", ""));
    let parts = unbroken.filter_map(|line| {
        let parts: Vec<&str> = line.split("\\approx").collect();
        // A quantity that is shown without figures has nothing to work out.
        let [_, figures, result] = parts.as_slice() else { return None };
        Some(((*figures).to_owned(), result.split("\\ \\mathrm").next().unwrap_or(result).to_owned()))
    });
    parts.collect()
}

/// Half a unit of the sixth digit: what rounding to six digits may change. A printed 0 is right where no more than the rounding of floats is
/// left beside the largest figure.
fn agrees(figures: &str, worked_out: f64, printed: f64) -> bool {
    if printed == 0.0 {
        let numbers = figures.split(|c: char| !c.is_ascii_digit() && c != '.').filter_map(|number| number.parse().ok());
        return worked_out.abs() <= 1e-12 * numbers.fold(0.0, f64::max);
    }
    let size = worked_out.abs().max(printed.abs());
    size == 0.0 || (worked_out - printed).abs() <= 0.5000001 * 10_f64.powf(size.log10().floor() - 5.0)
}

#[test]
fn every_line_of_every_report_recomputes_as_printed() {
    let examples = Path::new(env!("CARGO_MANIFEST_DIR")).join("reports/examples");
    let mut checked = 0;
    for folder in fs::read_dir(examples).expect("the examples").map(|entry| entry.expect("an entry").path()) {
        let layout = fs::read_to_string(folder.join("layout.toml")).expect("a layout file");
        let Ok(Layout::Known(engine, open)) = file::parse_layout("layout.toml", &layout) else {
            panic!("{} is not an engine", folder.display())
        };
        let page = pages::document_of(&engine, open.as_deref());
        for format in [Format::GITHUB, Format::Latex] {
            let found = lines(&pages::text(&page, format));
            // An example of torsion alone gives no masses, and has no forces to compute.
            let has_forces = engine.dimensions().mass.is_some();
            assert!(
                found.len() > 4 || !has_forces,
                "{} has only {} lines in {format:?}",
                folder.display(),
                found.len()
            );
            for (figures, result) in found {
                let (worked_out, printed) = (Reader::value(&figures), Reader::value(&result));
                assert!(
                    agrees(&figures, worked_out, printed),
                    "{}: {figures} is {worked_out}, not {result}",
                    folder.display()
                );
                checked += 1;
            }
        }
    }
    assert!(checked > 200, "only {checked} lines were found");
}

#[test]
fn the_reader_of_lines_works_out_what_a_person_would() {
    let cases = [
        ("1 + 2 \\cdot 3^{2}", 19.0),
        ("\\frac{1}{2} \\cdot \\left(3 - 1\\right)", 1.0),
        ("\\sqrt{16} - 2.5 \\times 10^{-1}", 3.75),
        ("2 \\cdot \\cos\\left(2 \\cdot 30^{\\circ}\\right)", 1.0),
        ("-\\frac{0.5^{3}}{4} + \\dots", -0.03125),
    ];
    for (text, value) in cases {
        assert!((Reader::value(text) - value).abs() < 1e-12, "{text}");
    }
    assert!(!agrees("", 123.4567, 123.458) && agrees("", 123.4567, 123.457));
    assert!(agrees("700 - 700.0", 1e-13, 0.0) && !agrees("700 - 700.0", 1e-6, 0.0));
}
