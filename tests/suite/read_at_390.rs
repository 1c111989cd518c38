//! Can the letters of every drawing be read: on a phone, and in half of a printed page?

use crankstar::engine::CycleOrder;
use crankstar::page::{Block, Document, Format, Picture};
use crankstar::report;

use crate::support::pages;
use crate::support::written::engine;

const TEXTS: [(&str, &str); 4] = [
    (
        "report",
        "vee = { bank_angle = 37.3, throws = [0, 36, 72, 108, 144, 180, 216, 252, 288, 324], pin_split = 11.7 }",
    ),
    ("bearings", include_str!("../../reports/examples/v8-gas/layout.toml")),
    ("mounts", include_str!("../../reports/examples/i4-mounts/layout.toml")),
    ("torsion", include_str!("../../reports/examples/marine-six-torsion/layout.toml")),
];
/// A phone of 390 pixels less the margins of the page.
const PHONE: f64 = 358.0;

fn page(question: &str, text: &str) -> Document {
    let engine = engine(text);
    let no_orders: [CycleOrder; 0] = [];
    match report::ask(question, &engine, &no_orders) {
        Some(study) => study.unwrap_or_else(|why| panic!("{question}: {why}")).page(),
        None => pages::document(&engine),
    }
}

fn pictures(page: &Document) -> Vec<&Picture> {
    page.blocks.iter().flat_map(|block| if let Block::Pictures(all) = block { &all[..] } else { &[] }).collect()
}

#[test]
fn letters_have_eleven_pixels_on_a_phone_or_the_drawing_is_moved_under_the_finger() {
    let (mut narrow, mut wide) = (0, 0);
    for (question, text) in TEXTS {
        let page = page(question, text);
        let html = pages::text(&page, Format::Html);
        for picture in pictures(&page) {
            let figure = &picture.figure;
            let shown = PHONE.max(figure.least_pixels());
            assert!(figure.letters * shown / figure.width > 10.99, "{question}: {}", picture.name);
            if figure.least_pixels() > PHONE {
                wide += 1
            } else {
                narrow += 1
            }
            assert!(html.contains(&format!("--least:{:.0}px", figure.least_pixels())), "{question}: {}", picture.name);
        }
        assert!(html.contains(".drawing { overflow-x: auto; } .drawing svg { min-width: var(--least); }"));
        let is_plot = |picture: &&Picture| !picture.name.starts_with("order-") && !picture.name.contains("view");
        if question != "report" {
            for plot in pictures(&page).iter().filter(|picture| is_plot(picture)) {
                assert!(plot.figure.least_pixels() <= PHONE, "{question}: {} is moved on a phone", plot.name);
            }
        }
    }
    assert!(narrow > 10 && wide > 0, "{narrow} narrow drawings, {wide} wide");
}

#[test]
fn drawings_whose_letters_are_small_in_half_of_a_page_have_the_whole_of_it() {
    let v20 = page("report", TEXTS[0].1);
    let spread = pictures(&v20).into_iter().filter(|picture| picture.figure.is_spread()).count();
    assert!(spread > 0);
    let tex = pages::text(&v20, Format::Latex);
    assert!(tex.contains("\\begin{minipage}[t]{\\textwidth}"), "{tex}");
    assert!(pages::text(&v20, Format::Html).matches("class=\"spread\"").count() >= spread);
    for picture in pictures(&v20).iter().filter(|picture| !picture.figure.is_spread()) {
        // Six points and more, 2.1 mm.
        assert!(picture.figure.letters * 83.0 / picture.figure.width > 2.1, "{}", picture.name);
    }
}
