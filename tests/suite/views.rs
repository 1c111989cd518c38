//! Can the drawings of engines and the plots be read? No text on another, none off the page, and what stands where.

use std::fs;
use std::path::Path;

use crankstar::engine::Engine;
use crankstar::family;
use crankstar::file::{self, Layout, Template};
use crankstar::page::figure::{Anchor, Figure, Ink, Mark, Point};
use crankstar::page::plot::{Axis, Curve, Map, Plot, Polar};
use crankstar::page::{File, Format, svg};
use crankstar::report::{self, end_view, side_view};
use crankstar::report::{amplitudes, amplitudes_caption};
use crankstar::sweep::{self, Geometry, Parameter};

use crate::support::pages;

/// Layouts that are hard to draw.
const STRANGE: &[(&str, &str)] = &[
    (
        "W12 with offsets",
        "[fan]\nbanks = [-60, 0, 60]\nthrows = [0, 180, 180, 0]\nbank_offsets = [\"22 mm\", 0, \"-22 mm\"]\nspacing = \"110 mm\"\n\
         [mechanism]\nstroke = \"90 mm\"\nrod_length = \"150 mm\"\npin_offset = \"8 mm\"",
    ),
    (
        "W12, nine throws apart",
        "[fan]\nbanks = [-36, 0, 36]\nthrows = [0, 90, 270, 180]\npin_splits = [0, 12, 24]\nbank_offsets = [0.2, 0, -0.2]",
    ),
    (
        "V20",
        "[vee]\nbank_angle = \"71.3\"\nthrows = [0, 36, 72, 108, 144, 180, 216, 252, 288, 324]\npin_split = \"3.7\"\nbank_offset = 0.2",
    ),
    ("V6 at 37.3°", "[vee]\nbank_angle = \"37.3\"\nthrows = [0, 240, 120]\npin_split = \"22.7\""),
    ("VR6", "[vee]\nbank_angle = \"10.6\"\nthrows = [0, 240, 120]\npin_split = \"10.6\"\nbank_offset = 0.5"),
    (
        "in-line 13",
        "[inline]\nthrows = [0, \"360/13\", \"720/13\", \"1080/13\", \"1440/13\", \"1800/13\", \"2160/13\", \"2520/13\", \"2880/13\", \
         \"3240/13\", \"3600/13\", \"3960/13\", \"4320/13\"]",
    ),
    ("X24", "[fan]\nbanks = [-135, -45, 45, 135]\nthrows = [0, 120, 240, 240, 120, 0]"),
    ("radial of three rows", "[radial]\ncylinders = 7\nrows = 3\nrow_rotation = 17\nrow_throw = 120"),
    ("radial of 28", "[radial]\ncylinders = 7\nrows = 4\nrow_rotation = \"90/7\"\nrow_throw = 180"),
    (
        "long names, a plane far off",
        "bearings = [1.5, 0.5, -0.5, -2.5]\nreference_plane = 40\n[[cylinder]]\nname = \"WWWWWW\"\nthrow = 0\nbank = 0\nposition = 1\n\
         [[cylinder]]\nname = \"R12345\"\nthrow = 90\nbank = 200\nposition = 0\n\
         [[cylinder]]\nname = \"3\"\nthrow = 270\nbank = 200\nposition = -1",
    ),
    (
        "two cylinders that nearly meet",
        "[[cylinder]]\nthrow = 0\nbank = 1\nposition = 0\n[[cylinder]]\nthrow = 1\nbank = 0\nposition = \"1/1000\"\n\
         [[cylinder]]\nthrow = 180\nbank = 0\nposition = 9",
    ),
];

fn strange() -> Vec<(String, Engine)> {
    let read = |(name, text): &(&str, &str)| ((*name).to_owned(), file::parse(name, text).expect(name));
    STRANGE.iter().map(read).collect()
}

/// Layouts with numbers, counterweights and bearings.
fn examples() -> Vec<(String, Engine)> {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("reports/examples");
    let mut paths: Vec<_> =
        fs::read_dir(folder).expect("the examples").map(|entry| entry.expect("an entry").path()).collect();
    paths.sort();
    let read = |path: std::path::PathBuf| {
        let name = path.display().to_string();
        let text = fs::read_to_string(path.join("layout.toml")).expect("a layout");
        (name.clone(), file::parse(&name, &text).expect("an engine"))
    };
    paths.into_iter().filter(|path| path.join("layout.toml").exists()).map(read).collect()
}

fn all_engines() -> Vec<(String, Engine)> {
    let catalogue = file::catalogue().expect("the catalogue").into_iter();
    catalogue.map(|(entry, engine)| (entry.name.to_owned(), engine)).chain(examples()).chain(strange()).collect()
}

/// A text with the least box that it needs: left, right, bottom, top, upwards from the foot of the page.
struct TextBox {
    text: String,
    ends: [f64; 4],
}

/// The font is 3 mm high, its letters about 0.55 of that wide.
fn text_box(text: &str, at: Point, anchor: Anchor) -> TextBox {
    let width = 0.55 * 3.0 * text.chars().count() as f64;
    let left = match anchor {
        Anchor::Start => at.re,
        Anchor::Middle => at.re - width / 2.0,
        Anchor::End => at.re - width,
    };
    TextBox { text: text.to_owned(), ends: [left, left + width, at.im - 1.4, at.im + 1.4] }
}

fn boxes(figure: &Figure) -> Vec<TextBox> {
    let of = |mark: &Mark| match mark {
        Mark::Text { at, text, anchor, .. } => Some(text_box(text, *at, *anchor)),
        _ => None,
    };
    figure.marks.iter().filter_map(of).collect()
}

/// The same of an SVG file: its size, and its texts.
fn boxes_of(page: &str) -> ((f64, f64), Vec<TextBox>) {
    let value = |line: &str, name: &str| {
        let (_, rest) = line.split_once(&format!(" {name}=\"")).expect(name);
        rest.split_once('"').expect("a quote").0.to_owned()
    };
    let number = |text: &str| text.parse::<f64>().expect("a number");
    let view = value(page.lines().next().expect("a line"), "viewBox");
    let size: Vec<f64> = view.split(' ').map(number).collect();
    // What texts share stands at their group.
    let mut group = "";
    let mut texts = Vec::new();
    for line in page.lines() {
        match line {
            _ if line.starts_with("<g") => group = line,
            "</g>" => group = "",
            _ if line.starts_with("<text") => texts.push((line, group)),
            _ => {}
        }
    }
    let read = |(line, group): (&str, &str)| {
        let own = if line.contains(" text-anchor=") { line } else { group };
        let anchor = match value(own, "text-anchor").as_str() {
            "start" => Anchor::Start,
            "end" => Anchor::End,
            _ => Anchor::Middle,
        };
        let at = Point::new(number(&value(line, "x")), size[3] - number(&value(line, "y")) + 1.05);
        let text = line.split_once('>').and_then(|(_, rest)| rest.split_once('<')).expect("a text").0;
        text_box(&text.replace("&amp;", "&").replace("&lt;", "<").replace("&gt;", ">"), at, anchor)
    };
    ((size[2], size[3]), texts.into_iter().map(read).collect())
}

fn assert_readable(name: &str, size: (f64, f64), boxes: &[TextBox]) {
    let wrong = unreadable(size, boxes);
    assert!(wrong.is_empty(), "{name}: {wrong:#?}");
}

/// What is wrong with the texts of a page of this size.
fn unreadable((width, height): (f64, f64), boxes: &[TextBox]) -> Vec<String> {
    let mut wrong = Vec::new();
    for (index, one) in boxes.iter().enumerate() {
        let [left, right, bottom, top] = one.ends;
        let inside = left >= -0.05 && right <= width + 0.05 && bottom >= -0.05 && top <= height + 0.05;
        if !inside {
            wrong.push(format!("`{}` leaves the page of {width} by {height}: {:?}", one.text, one.ends));
        }
        for other in &boxes[..index] {
            let apart = right <= other.ends[0] + 0.05 || other.ends[1] <= left + 0.05;
            let apart = apart || top <= other.ends[2] + 0.05 || other.ends[3] <= bottom + 0.05;
            if !apart {
                wrong.push(format!("`{}` lies on `{}`", one.text, other.text));
            }
        }
    }
    wrong
}

/// What is wrong with the texts of a view or a plot.
pub fn unreadable_texts(figure: &Figure) -> Vec<String> {
    unreadable((figure.width, figure.height), &boxes(figure))
}

fn assert_figure(name: &str, figure: &Figure) {
    assert_readable(name, (figure.width, figure.height), &boxes(figure));
    assert!(!svg(figure, name).contains("NaN"), "{name}");
}

#[test]
fn no_text_of_a_view_lies_on_another_or_leaves_the_page() {
    for (name, engine) in all_engines() {
        assert_figure(&format!("{name}, end view"), &end_view(&engine));
        assert_figure(&format!("{name}, side view"), &side_view(&engine));
    }
}

#[test]
fn no_text_of_a_plot_lies_on_another_or_leaves_the_page() {
    let engines = examples().into_iter().chain(strange().into_iter().take(1));
    for (name, engine) in engines {
        let files = pages::files(&pages::document(&engine), Format::GITHUB);
        let plots = ["force", "moment", "torque.", "bearing"];
        for file in files.iter().filter(|file| file.name.ends_with(".svg")) {
            if plots.iter().any(|plot| file.name.starts_with(plot)) {
                let (size, boxes) = boxes_of(&file.text);
                assert_readable(&format!("{name}, {}", file.name), size, &boxes);
            }
        }
    }
}

fn sweep_files(text: &str, parameters: &[&str]) -> Vec<File> {
    let template = Template::new("test.toml", text).expect("it is TOML");
    let parameters: Vec<Parameter> =
        parameters.iter().map(|text| Parameter::parse(text).expect("a parameter")).collect();
    let swept = sweep::sweep(&template, &parameters, &[1, 2, 4, 6], &Geometry::default()).expect("a sweep");
    pages::files(&report::sweep_page(&swept), Format::GITHUB)
        .into_iter()
        .filter(|file| file.name.ends_with(".svg"))
        .collect()
}

#[test]
fn no_text_of_a_sweep_lies_on_another_or_leaves_the_page() {
    let v6 = "[vee]\nbank_angle = 60\nthrows = [0, 240, 120]\n";
    for parameters in [&["vee.bank_angle=0..180:5"][..], &["vee.bank_angle=0..180:20", "vee.pin_split=-60..60:10"]] {
        for file in sweep_files(v6, parameters) {
            let (size, boxes) = boxes_of(&file.text);
            assert_readable(&format!("{parameters:?}, {}", file.name), size, &boxes);
            let tells_degrees = boxes.iter().any(|label| label.text == "bank angle in °");
            assert!(tells_degrees, "{}: an axis does not say that it is in degrees", file.name);
        }
    }
}

#[test]
fn pictures_are_narrow_enough_for_a_phone() {
    for (name, engine) in all_engines() {
        // 3 mm of type shown 390 pixels wide are nearly ten pixels high on 120 mm.
        for (view, figure) in [("end", end_view(&engine)), ("side", side_view(&engine))] {
            assert!(figure.width <= 120.0, "{name}, {view}: {} mm wide", figure.width);
        }
    }
    let single = file::find("I1").expect("an entry").engine().expect("an engine");
    assert!(end_view(&single).width < 45.0 && side_view(&single).width < 75.0);
}

/// The filled and the hollow pins: their colours from the left.
fn pins(figure: &Figure) -> Vec<Ink> {
    let mut pins: Vec<(f64, Ink)> = figure
        .marks
        .iter()
        .filter_map(|mark| match mark {
            Mark::Polygon { corners, stroke, fill: Some(fill) }
                if stroke.ink == Ink::Blue
                    && *fill != Ink::Light
                    && (corners[2].im - corners[0].im - 2.2).abs() < 1e-9 =>
            {
                Some((corners[0].re, *fill))
            }
            _ => None,
        })
        .collect();
    // The last ones are those of the legend.
    let kinds = [Ink::Blue, Ink::Shade(20), Ink::Shade(0)];
    let legend = kinds.iter().filter(|kind| pins.iter().any(|(_, fill)| fill == *kind)).count();
    pins.truncate(pins.len() - legend);
    pins.sort_by(|a, b| a.0.total_cmp(&b.0));
    pins.into_iter().map(|(_, ink)| ink).collect()
}

#[test]
fn the_side_view_tells_90_from_270_degrees() {
    let crossplane = file::find("V8-crossplane").expect("an entry").engine().expect("an engine");
    // Throws at 0°, 270°, 90°, 180°: in the plane, towards the reader, away, in the plane.
    assert_eq!(pins(&side_view(&crossplane)), [Ink::Shade(20), Ink::Blue, Ink::Shade(0), Ink::Shade(20)]);
}

/// Where the cylinder axes stand left of the shaft, in an in-line engine with this offset.
fn axis_of(offset: &str) -> f64 {
    let text = format!("[inline]\nthrows = [0]\n[mechanism]\nrod_ratio = 0.25\noffset_ratio = \"{offset}\"");
    let figure = end_view(&file::parse("test", &text).expect("an engine"));
    let red = figure.marks.iter().find_map(|mark| match mark {
        Mark::Line { from, to, stroke, .. } if stroke.ink == Ink::Red => Some(to.re - from.re),
        _ => None,
    });
    red.unwrap_or(0.0)
}

#[test]
fn the_offset_is_drawn_to_scale_on_its_side() {
    // The rod is 41·4/5 mm long on the page; ψ = 90° is to the left.
    let rod = 41.0 * 4.0 / 5.0;
    assert!((axis_of("0.05") + 0.05 * rod).abs() < 1e-9);
    assert!((axis_of("-0.1") - 0.1 * rod).abs() < 1e-9);
    assert!(axis_of("0") == 0.0);
}

#[test]
fn pistons_stand_at_the_height_of_their_crank_angle() {
    let text = "[inline]\nthrows = [0, 90, 180]\n[mechanism]\nrod_ratio = 0.25";
    let figure = end_view(&file::parse("test", text).expect("an engine"));
    let pins: Vec<Point> = figure
        .marks
        .iter()
        .filter_map(|mark| match mark {
            Mark::Circle { centre, radius, .. } if (*radius - 0.6).abs() < 1e-9 => Some(*centre),
            _ => None,
        })
        .collect();
    let mut heights: Vec<f64> = pins.iter().map(|pin| pin.im).collect();
    heights.sort_by(|a, b| b.total_cmp(a));
    let radius = 41.0 / 5.0;
    let drop = radius * (5.0 - 15.0_f64.sqrt());
    assert!((heights[0] - heights[1] - drop).abs() < 1e-9 && (heights[0] - heights[2] - 2.0 * radius).abs() < 1e-9);
}

#[test]
fn coinciding_cylinders_share_one_label_and_the_firing_order_is_told() {
    let six = file::find("I6").expect("an entry").engine().expect("an engine");
    let texts: Vec<String> = boxes(&end_view(&six)).into_iter().map(|label| label.text).collect();
    for wanted in ["1, 6", "2–5", "3, 4", "2, 5", "Fires 1–5–3–6–2–4"] {
        assert!(texts.iter().any(|text| text == wanted), "{wanted}: {texts:?}");
    }
}

fn curve(number: usize, name: &str, value: impl Fn(f64) -> f64) -> Curve {
    Curve::new(number, name, (0..=360).map(f64::from).map(|x| (x, value(x.to_radians()))).collect())
}

#[test]
fn curves_that_coincide_share_a_name() {
    let mut plot = Plot::new("", Axis::angle("θ", 0.0, 360.0, 90), Axis::linear("F"));
    plot.curves =
        vec![curve(0, "sum", f64::sin), curve(1, "order 1", f64::sin), curve(2, "order 2", |x| (2.0 * x).cos())];
    let figure = plot.figure();
    let texts: Vec<String> = boxes(&figure).into_iter().map(|label| label.text).collect();
    assert!(texts.contains(&"sum ≈ order 1".to_owned()) && texts.contains(&"order 2".to_owned()), "{texts:?}");
    assert_figure("coinciding", &figure);
}

#[test]
fn contour_lines_follow_the_values() {
    let rows = (0..30).map(|y| (0..30).map(|x| f64::from(x) + f64::from(y)).collect()).collect();
    let axis = || Axis::linear("").within(-0.5, 29.5);
    let value = Axis::linear("v");
    let map = Map { title: String::new(), x: axis(), y: axis(), value, rows, curves: Vec::new(), marks: Vec::new() };
    let figure = map.figure();
    let lines: Vec<&Vec<Point>> = figure
        .marks
        .iter()
        .filter_map(|mark| match mark {
            Mark::Path { points, stroke } if stroke.ink == Ink::Black => Some(points),
            _ => None,
        })
        .collect();
    assert!(lines.len() >= 4, "{}", lines.len());
    for line in lines {
        let (first, last) = (line[0], line[line.len() - 1]);
        let slope = (last.im - first.im) / (last.re - first.re);
        assert!(slope < 0.0 && line.len() <= 6, "a straight line: {line:?}");
    }
    assert_figure("contours", &figure);
}

#[test]
fn crank_angles_at_one_place_share_a_mark() {
    let tips: Vec<(f64, f64)> = (0..=4).map(|quarter| if quarter % 2 == 0 { (0.0, 5.0) } else { (5.0, 0.0) }).collect();
    let mut polar = Polar::new("", "N", Vec::new());
    polar.mark_quarters(&tips, 4);
    let labels: Vec<&str> = polar.marks.iter().map(|mark| mark.label.as_str()).collect();
    assert_eq!(labels, ["θ = 0°, 180°", "θ = 90°, 270°"]);
    polar.marks.clear();
    polar.mark_quarters(&[(0.0, 0.0); 5], 4);
    assert!(polar.marks.is_empty());
}

fn open_figure(text: &str) -> Option<(Figure, String)> {
    let Layout::Open(family) = file::parse_layout("test", text).expect("a family") else { return None };
    let orders = family::classify(&family, family.orders()).expect("orders");
    amplitudes(&family, &orders).zip(amplitudes_caption(&family, &orders).map(|caption| caption.plain()))
}

#[test]
fn the_exact_zeros_of_an_open_angle_are_marked_on_its_axis() {
    let (figure, caption) = open_figure("[vee]\nbank_angle = \"phi\"\nthrows = [0, 120, 240]").expect("a drawing");
    assert_figure("open V6", &figure);
    let texts: Vec<String> = boxes(&figure).into_iter().map(|label| label.text).collect();
    assert!(texts.contains(&"180°".to_owned()) && texts.contains(&"order 2".to_owned()), "{texts:?}");
    assert!(
        caption.contains("zero for all angles: force at 1, 2, 4.") && caption.contains("force: force at 6."),
        "{caption}"
    );
    assert!(caption.contains("zero for all angles: moment at 6."), "{caption}");
    let (split, _) =
        open_figure("[vee]\nbank_angle = 90\nthrows = [0]\npin_split = \"delta\"").expect("a drawing of the split");
    assert_figure("open split", &split);
    let texts: Vec<String> = boxes(&split).into_iter().map(|label| label.text).collect();
    assert!(texts.iter().any(|text| text == "Pin split δ in °"), "{texts:?}");
}

#[test]
fn the_pin_split_that_balances_is_marked() {
    // The reverse vectors of order 1 cancel everywhere at 90°; the direct ones at δ = 180°.
    let (figure, _) =
        open_figure("orders = [1]\n[vee]\nbank_angle = 180\nthrows = [0]\npin_split = \"delta\"").expect("a drawing");
    let rings = figure.marks.iter().filter(|mark| matches!(mark, Mark::Circle { fill: Some(Ink::Shade(0)), .. }));
    assert!(rings.count() > 0);
}

#[test]
fn two_open_angles_have_no_curves() {
    assert!(open_figure("[vee]\nbank_angle = \"phi\"\nthrows = [0]\npin_split = \"delta\"").is_none());
}
