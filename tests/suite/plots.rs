//! Do plots show what they are given, and nothing else? Ticks, thinning, breaks, and the same marks in both languages.

use crankstar::page::figure::{Figure, Ink, Mark, Point};
use crankstar::page::plot::{Axis, Curve, Map, Plot, PointMark, Polar, Rule};
use crankstar::page::{Language, Picture, svg, tikz};
use proptest::prelude::*;

fn labels(axis: &Axis, values: &[f64]) -> Vec<String> {
    axis.ruler(values.iter().copied(), 6).ticks.into_iter().map(|tick| tick.label).collect()
}

fn plot(points: Vec<(f64, f64)>) -> Plot {
    let mut plot = Plot::new("Force", Axis::linear("θ"), Axis::linear("F"));
    plot.curves.push(Curve::new(0, "force", points));
    plot
}

/// The paths of the curves, in millimetres.
fn paths(figure: &Figure) -> Vec<Vec<(f64, f64)>> {
    let path = |mark: &Mark| match mark {
        Mark::Path { points, .. } => Some(points.iter().map(|point| (point.re, point.im)).collect()),
        _ => None,
    };
    figure.marks.iter().filter_map(path).collect()
}

fn texts(figure: &Figure) -> Vec<String> {
    let text = |mark: &Mark| if let Mark::Text { text, .. } = mark { Some(text.clone()) } else { None };
    figure.marks.iter().filter_map(text).collect()
}

#[test]
fn linear_ticks_are_multiples_of_1_2_or_5_and_cover_the_data() {
    assert_eq!(
        labels(&Axis::linear(""), &[-8700.0, 12100.0]),
        ["−10\u{202f}000", "−5000", "0", "5000", "10\u{202f}000", "15\u{202f}000"]
    );
    assert_eq!(labels(&Axis::linear(""), &[0.0, 0.3]), ["0", "0.05", "0.1", "0.15", "0.2", "0.25", "0.3"]);
    assert_eq!(labels(&Axis::linear(""), &[-4.4e6, 0.0]), ["−5·10⁶", "−4·10⁶", "−3·10⁶", "−2·10⁶", "−10⁶", "0"]);
    assert_eq!(labels(&Axis::linear(""), &[0.0, 2.5e-5]), ["0", "0.5·10⁻⁵", "10⁻⁵", "1.5·10⁻⁵", "2·10⁻⁵", "2.5·10⁻⁵"]);
}

#[test]
fn a_logarithmic_axis_has_decades_or_1_2_and_5_times_them() {
    assert_eq!(labels(&Axis::log(""), &[0.04, 30.0]), ["0.01", "0.1", "1", "10", "100"]);
    assert_eq!(labels(&Axis::log(""), &[3.0, 60.0]), ["2", "5", "10", "20", "50", "100"]);
    assert_eq!(labels(&Axis::log(""), &[2e-12, 5e-3]), ["10⁻¹²", "10⁻¹⁰", "10⁻⁸", "10⁻⁶", "10⁻⁴", "10⁻²"]);
    let ruler = Axis::log("").ruler([0.0, -3.0, f64::NAN, 10.0, 1e5], 6);
    assert_eq!((ruler.low, ruler.high), (10.0, 1e5), "values that are not positive have no place");
    assert!(ruler.place(0.0).is_none() && ruler.place(-1.0).is_none());
    assert!((ruler.place(1e3).expect("a place") - 0.5).abs() < 1e-12);
    assert_eq!(ruler.small[..3], [20.0, 30.0, 40.0]);
}

#[test]
fn an_axis_of_crank_angles_has_ticks_at_quarter_turns() {
    let ruler = Axis::angle("θ", 0.0, 720.0, 90).ruler([3.0, 100.0], 6);
    assert_eq!((ruler.low, ruler.high), (0.0, 720.0));
    let values: Vec<f64> = ruler.ticks.iter().map(|tick| tick.value).collect();
    assert_eq!(values, [0.0, 90.0, 180.0, 270.0, 360.0, 450.0, 540.0, 630.0, 720.0]);
    let half = Axis::angle("θ", -180.0, 540.0, 180);
    assert_eq!(labels(&half, &[]), ["−180", "0", "180", "360", "540"]);
}

#[test]
fn constants_and_nothing_get_a_range_that_is_not_empty() {
    let range = |axis: Axis, values: &[f64]| {
        let ruler = axis.ruler(values.iter().copied(), 6);
        (ruler.low, ruler.high)
    };
    assert_eq!(range(Axis::linear(""), &[0.0, 0.0]), (-1.0, 1.0));
    assert_eq!(range(Axis::linear(""), &[50.0]), (0.0, 100.0));
    assert_eq!(range(Axis::linear(""), &[-50.0, -50.0]), (-100.0, 0.0));
    assert_eq!(range(Axis::linear(""), &[]), (0.0, 1.0));
    assert_eq!(range(Axis::log(""), &[-1.0]), (1.0, 10.0));
    assert_eq!(range(Axis::log(""), &[6.0]), (2.0, 20.0));
    assert_eq!(range(Axis::linear("").within(3.0, 3.0), &[0.0, 10.0]), (0.0, 10.0), "a range of no length is not used");
    assert_eq!(range(Axis::linear("").within(9.0, 3.0), &[0.0, 10.0]), (3.0, 9.0));
}

#[test]
fn thinning_keeps_the_extremes_and_moves_the_curve_by_less_than_a_thirtieth_of_a_millimetre() {
    let wave = |i: u32| {
        let x = f64::from(i) / 100.0;
        (x, 1000.0 * x.to_radians().cos() + 300.0 * (4.0 * x).to_radians().sin())
    };
    let points: Vec<(f64, f64)> = (0..=72_000).map(wave).collect();
    let plot = plot(points.clone());
    let drawn = paths(&plot.figure());
    assert_eq!(drawn.len(), 1);
    let drawn = &drawn[0];
    assert!((60..=400).contains(&drawn.len()), "{} points", drawn.len());
    let (x, y) = (plot.x.ruler([0.0, 720.0], 9), plot.y.ruler(points.iter().map(|p| p.1), 6));
    let frame = plot.figure().marks.into_iter().find_map(|mark| match mark {
        Mark::Polygon { corners, .. } => Some((corners[0], corners[2])),
        _ => None,
    });
    let (low, high) = frame.expect("a frame");
    let on_page = |(a, b): (f64, f64)| {
        let (right, up) = (x.place(a).expect("a place"), y.place(b).expect("a place"));
        // Points are drawn on a lattice of 4096 to a millimetre.
        let on_lattice = |length: f64| (length * 4096.0).round() / 4096.0;
        (on_lattice(low.re + (high.re - low.re) * right), on_lattice(low.im + (high.im - low.im) * up))
    };
    let all: Vec<(f64, f64)> = points.iter().map(|point| on_page(*point)).collect();
    let top = |points: &[(f64, f64)]| points.iter().map(|p| p.1).fold(f64::MIN, f64::max);
    let bottom = |points: &[(f64, f64)]| points.iter().map(|p| p.1).fold(f64::MAX, f64::min);
    assert!((top(&all) - top(drawn)).abs() < 1e-9 && (bottom(&all) - bottom(drawn)).abs() < 1e-9);
    let mut segments = drawn.windows(2);
    let mut segment = segments.next().expect("a segment");
    for (right, up) in all {
        while right > segment[1].0 {
            segment = segments.next().expect("a segment");
        }
        let ((x0, y0), (x1, y1)) = (segment[0], segment[1]);
        let slope = (y1 - y0) / (x1 - x0);
        let away = (up - y0 - slope * (right - x0)).abs() / slope.hypot(1.0);
        assert!(away < 1.0 / 30.0, "{away} mm at {right}");
    }
}

#[test]
fn a_value_that_is_no_number_breaks_the_curve() {
    let figure =
        plot(vec![(0.0, 1.0), (1.0, 2.0), (2.0, f64::NAN), (3.0, 1.0), (4.0, 5.0), (5.0, f64::INFINITY)]).figure();
    assert_eq!(paths(&figure).iter().map(Vec::len).collect::<Vec<_>>(), [2, 2]);
    assert!(!svg(&figure, "").contains("NaN") && !tikz(&figure).contains("NaN") && !svg(&figure, "").contains("inf"));
}

#[test]
fn a_point_alone_is_a_dot() {
    let figure = plot(vec![(1.0, f64::NAN), (2.0, 3.0), (3.0, f64::NAN)]).figure();
    assert!(paths(&figure).is_empty());
    assert_eq!(figure.marks.iter().filter(|mark| matches!(mark, Mark::Circle { .. })).count(), 1);
}

#[test]
fn a_curve_is_cut_at_the_edges_of_a_given_range() {
    let mut plot = plot((0..=8).map(|i| (f64::from(i), if i % 2 == 0 { 0.0 } else { 10.0 })).collect());
    plot.y = Axis::linear("F").within(-2.0, 5.0);
    let drawn = paths(&plot.figure());
    assert_eq!(drawn.len(), 5, "each tooth is cut off");
    let highest = drawn.iter().flatten().map(|point| point.1).fold(f64::MIN, f64::max);
    let at_edge = drawn.iter().flatten().filter(|point| (point.1 - highest).abs() < 1e-9).count();
    assert_eq!(at_edge, 8);
}

#[test]
fn stairs_hold_a_value_until_the_next_begins() {
    let stairs = Curve::new(0, "", vec![(0.0, 1.0), (2.0, 5.0), (3.0, 4.0)]).stepped();
    assert_eq!(stairs.points, [(0.0, 1.0), (2.0, 1.0), (2.0, 5.0), (3.0, 5.0), (3.0, 4.0)]);
}

#[test]
fn curves_differ_in_colour_or_dash_and_neighbours_in_both() {
    let styles: Vec<_> = (0..20).map(|number| Curve::new(number, "", Vec::new())).map(|c| (c.ink, c.dash)).collect();
    for (index, style) in styles.iter().enumerate() {
        assert!(!styles[..index].contains(style), "{index}");
        assert!(index == 0 || styles[index - 1].0 != style.0 && styles[index - 1].1 != style.1);
    }
}

fn samples() -> Vec<Figure> {
    let mut full = plot((0..900).map(|i| (f64::from(i), f64::from(i * i % 677))).collect());
    full.marks = vec![PointMark::ring((90.0, 0.0), "90°").of("exact zero"), PointMark::dot((400.0, 300.0), "best")];
    full.rules.push(Rule { at: 250.0, upright: true, label: "limit".into() });
    let tips = (0..=36).map(|i| (10.0 * f64::from(i).sin(), 10.0 * f64::from(i).cos())).collect();
    let polar = Polar::new("Vector", "Force in N", vec![Curve::new(2, "P", tips)]);
    let map = Map {
        title: "Map".into(),
        x: Axis::linear("x").within(0.0, 1.0),
        y: Axis::log("y").within(1.0, 100.0),
        value: Axis::linear("F in N"),
        rows: vec![vec![0.0, 1.0, 1.0], vec![f64::NAN, 2.0], vec![3.0, 3.0, 4.0]],
        curves: Vec::new(),
        marks: vec![PointMark::dot((0.5, 10.0), "here")],
    };
    vec![full.figure(), polar.figure(), map.figure()]
}

/// What a page draws as paths: its outlines, with y downwards, a closed one with its first corner at its end.
fn drawn_in(page: &str) -> Vec<Vec<(f64, f64)>> {
    let mut found: Vec<Vec<(f64, f64)>> = Vec::new();
    for data in page.split(" d=\"").skip(1).filter_map(|rest| rest.split('"').next()) {
        let mut words = data.char_indices().filter(|(_, letter)| letter.is_ascii_alphabetic()).peekable();
        while let Some((at, word)) = words.next() {
            let end = words.peek().map_or(data.len(), |(next, _)| *next);
            let numbers: Vec<f64> = data[at + 1..end]
                .replace('-', " -")
                .split_whitespace()
                .map(|number| number.parse().expect("a number"))
                .collect();
            if word == 'M' {
                found.push(vec![(numbers[0], numbers[1])]);
                assert_eq!(numbers.len(), 2, "{data}");
                continue;
            }
            let open = found.last_mut().expect("a line begins somewhere");
            let steps: Vec<(f64, f64)> = match word {
                'l' => numbers.chunks(2).map(|step| (step[0], step[1])).collect(),
                'h' => numbers.iter().map(|x| (*x, 0.0)).collect(),
                'v' => numbers.iter().map(|y| (0.0, *y)).collect(),
                'z' => vec![(open[0].0 - open[open.len() - 1].0, open[0].1 - open[open.len() - 1].1)],
                _ => panic!("{word} in {data}"),
            };
            for (x, y) in steps {
                let (from_x, from_y) = open[open.len() - 1];
                open.push((from_x + x, from_y + y));
            }
        }
    }
    found
}

/// The outlines that the marks of a figure without arrows ask for, as `drawn_in` reads them.
fn outlines(figure: &Figure) -> Vec<Vec<(f64, f64)>> {
    let down = |point: &Point| (point.re, figure.height - point.im);
    let closed = |corners: &[Point]| corners.iter().chain(corners.first()).map(down).collect::<Vec<_>>();
    let of_mark = |mark: &Mark| match mark {
        Mark::Line { from, to, arrow, .. } => {
            assert!(!arrow, "an arrow has a head");
            vec![vec![down(from), down(to)]]
        }
        Mark::Path { points, .. } => vec![points.iter().map(down).collect()],
        Mark::Polygon { corners, .. } => vec![closed(corners)],
        Mark::Rectangles { corners, .. } => {
            let corners_of =
                |(low, high): &(Point, Point)| [Point::new(low.re, high.im), *high, Point::new(high.re, low.im), *low];
            corners.iter().map(|pair| closed(&corners_of(pair))).collect()
        }
        Mark::Circle { .. } | Mark::Text { .. } | Mark::Title { .. } => Vec::new(),
    };
    figure.marks.iter().flat_map(of_mark).collect()
}

#[test]
fn svg_and_tikz_hold_the_same_marks() {
    for figure in samples() {
        let (page, tex) = (svg(&figure, "title"), tikz(&figure));
        let count = |matches: fn(&Mark) -> bool| figure.marks.iter().filter(|mark| matches(mark)).count();
        let path = count(|mark| matches!(mark, Mark::Path { .. }));
        assert_eq!(tex.matches("plot coordinates").count(), path);
        let texts = count(|mark| matches!(mark, Mark::Text { .. }));
        assert_eq!((page.matches("<text").count(), tex.matches("\\node[").count()), (texts, texts));
        let circles = count(|mark| matches!(mark, Mark::Circle { .. }));
        assert_eq!((page.matches("<circle").count(), tex.matches(" circle (").count()), (circles, circles));
        let cells =
            figure.marks.iter().map(|mark| if let Mark::Rectangles { corners, .. } = mark { corners.len() } else { 0 });
        assert_eq!(tex.matches(")rectangle(").count(), cells.sum::<usize>());
        let mut found = drawn_in(&page);
        for outline in outlines(&figure) {
            let is_it = |drawn: &Vec<(f64, f64)>| {
                let near = |(a, b): (&(f64, f64), &(f64, f64))| (a.0 - b.0).abs() < 0.006 && (a.1 - b.1).abs() < 0.006;
                drawn.len() == outline.len() && drawn.iter().zip(&outline).all(near)
            };
            let at = found.iter().position(is_it).unwrap_or_else(|| panic!("{outline:?} is not in\n{page}"));
            found.swap_remove(at);
        }
        assert!(found.is_empty(), "no mark is {found:?}");
        assert!(!tex.contains("[U+"), "a sign that LaTeX does not know");
    }
}

#[test]
fn a_map_draws_each_cell_once_and_crosses_those_without_a_value() {
    let figure = samples().remove(2);
    let cells = |shade: Ink| {
        let of_shade = figure.marks.iter().find_map(|mark| match mark {
            Mark::Rectangles { corners, fill } if *fill == shade => Some(corners.len()),
            _ => None,
        });
        of_shade.unwrap_or(0)
    };
    // 0 to 4 over 4 to 84 per cent black: neighbours of one value in a row are one rectangle.
    assert_eq!([4, 24, 44, 64, 84].map(|percent| cells(Ink::Shade(percent))), [1, 1, 1, 1, 1]);
    let crossed =
        figure.marks.iter().filter(|mark| matches!(mark, Mark::Line { stroke, .. } if stroke.ink == Ink::Grey));
    assert_eq!(crossed.count(), 4, "two cells have no value");
    assert!(texts(&figure).contains(&"F in N".to_owned()));
}

#[test]
fn a_polar_curve_has_equal_scales() {
    let circle = (0..=360).map(|i| f64::from(i).to_radians()).map(|a| (7.0 * a.sin(), 7.0 * a.cos())).collect();
    let drawn = paths(&Polar::new("", "N", vec![Curve::new(0, "", circle)]).figure()).remove(0);
    let width = |key: fn(&(f64, f64)) -> f64| {
        let ends = drawn.iter().map(key).fold((f64::MAX, f64::MIN), |(low, high), x| (low.min(x), high.max(x)));
        ends.1 - ends.0
    };
    let (wide, high) = (width(|p| p.0), width(|p| p.1));
    assert!((wide - high).abs() < 0.01, "{wide} {high}");
    assert!((wide - 2.0 * 38.0 * 7.0 / 8.0).abs() < 0.01, "the outer circle stands for 8");
}

fn any_value() -> impl Strategy<Value = f64> {
    let odd = [0.0, f64::NAN, f64::INFINITY, f64::NEG_INFINITY, f64::MAX, f64::MIN, f64::MIN_POSITIVE, 5e-324, 1.0];
    prop_oneof![proptest::sample::select(odd.to_vec()), any::<f64>(), -1e3..1e3]
}

proptest! {
    #[test]
    fn ticks_rise_and_lie_in_a_range_that_covers_the_values(
        low in -1e6_f64..1e6, span in 1e-3..1e7_f64, steps in 1usize..12, log in any::<bool>()
    ) {
        let low: f64 = if log { low.abs() + 1e-3 } else { low };
        let axis = if log { Axis::log("") } else { Axis::linear("") };
        let ruler = axis.ruler([low, low + span], steps);
        let slack = 1e-8 * (span + low.abs());
        prop_assert!(ruler.low <= low && ruler.high >= low + span);
        prop_assert!(ruler.ticks.len() >= 2, "{ruler:?}");
        prop_assert!(ruler.ticks.windows(2).all(|pair| pair[0].value < pair[1].value && pair[0].label != pair[1].label));
        prop_assert!(ruler.ticks.iter().all(|tick| tick.value >= ruler.low - slack && tick.value <= ruler.high + slack));
        if !log {
            prop_assert!(ruler.ticks.len() <= 2 * steps + 3);
        }
    }

    #[test]
    fn no_values_panic_or_leave_the_page(
        points in proptest::collection::vec((any_value(), any_value()), 0..30),
        ends in (any_value(), any_value()), given in any::<bool>(), log in any::<bool>()
    ) {
        let axis = if log { Axis::log("x") } else { Axis::linear("x") };
        let axis = if given { axis.within(ends.0, ends.1) } else { axis };
        let ticks = Axis { ticks: Some(points.iter().map(|point| point.0).collect()), ..axis.clone() };
        let mut plot = Plot::new("any", axis.clone(), ticks);
        plot.curves.push(Curve::new(1, "curve", points.clone()));
        plot.marks.extend(points.iter().map(|point| PointMark::dot(*point, "a")));
        plot.rules.push(Rule { at: ends.0, upright: given, label: "b".into() });
        let polar = Polar { marks: plot.marks.clone(), directions: vec![(ends.0, "c".into())], ..Polar::new("p", "N", plot.curves.clone()) };
        let rows = points.chunks(4).map(|row| row.iter().map(|point| point.1).collect()).collect();
        let map = Map {
            title: "map".into(), x: axis.clone(), y: Axis::linear("y"), value: axis,
            rows, curves: plot.curves.clone(), marks: plot.marks.clone(),
        };
        for figure in [plot.figure(), polar.figure(), map.figure()] {
            let page = svg(&figure, "any");
            prop_assert!(!page.contains("NaN") && !page.contains("\"inf"), "{page}");
            for (x, y) in paths(&figure).into_iter().flatten() {
                prop_assert!(x >= -1e-6 && x <= figure.width + 1e-6 && y >= -1e-6 && y <= figure.height + 1e-6);
            }
        }
    }
}

#[test]
fn a_legend_has_room_for_its_names_in_each_language() {
    let curves =
        [(0, "link 1"), (1, "link 5")].map(|(number, name)| Curve::new(number, name, vec![(1.0, 0.0), (0.0, 1.0)]));
    let figure = Polar::new("Links", "Force in N", curves.to_vec()).figure();
    let german = Language::De.picture(&Picture { name: "links".to_owned(), caption: "".into(), figure }).figure;
    let at = |name: &str| {
        let mut places = german.marks.iter().filter_map(|mark| match mark {
            Mark::Text { at, text, .. } if text == name => Some(at.re),
            _ => None,
        });
        places.next_back().unwrap_or_else(|| panic!("no {name}"))
    };
    // The first name, 21 mm long, and the sample of the second curve.
    assert!(at("Nebenpleuel 5") - at("Nebenpleuel 1") > 21.0 + 10.0);
}
