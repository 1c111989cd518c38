//! Are all aims at once compared rightly? Moments, neighbours and minor orders against a plain loop over all stars.

use crate::support::german::phrases;
use crate::support::plain_aims::{Asked, TICKS, whole};
use crate::support::plain_search::{Star, arrange, of_even_throws};
use crate::support::program::scratch;
use crankstar::engine::{Cycle, CycleOrder};
use crankstar::exact::Turn;
use crankstar::file;
use crankstar::page::{self, Format, Language};
use crankstar::report;
use crankstar::search::{FoundStar, Front, Options, Pieces, Problem, Way, document, search};
use crankstar::shard::{Merged, Shard, Store};
use num_rational::BigRational;

const CYCLES: [Cycle; 2] = [Cycle::TwoStroke, Cycle::FourStroke];

fn by(way: Way, problem: &Problem) -> Front {
    search(problem, &Options { way, threads: 1, ..Options::default() }).expect("a front")
}

/// The values of a star that was found, as the plain loop has them.
fn plain(problem: &Problem, star: &FoundStar) -> Star {
    let moments = star.moments.iter().map(|moment| moment.sum.squared_modulus());
    let minor = star.minor.iter().map(|(_, sum)| sum.squared_modulus());
    let neighbours = problem.neighbours.then(|| whole(star.neighbours.expect("they are counted") as i64));
    Star::new(moments.chain(minor).chain(neighbours).collect(), star.stars.expect("counted"))
}

fn agrees(asked: &Asked, problem: &Problem, stars: &[Vec<i64>]) {
    let right = asked.front(stars);
    let found = by(Way::Join, problem);
    let is_there = |star: &FoundStar| {
        let star = plain(problem, star);
        right.iter().any(|other| other.has_values_of(&star) && other.count == star.count)
    };
    for star in &found.stars {
        assert!(is_there(star), "{problem:?}: {star:?}");
        file::parse("star.toml", &star.layout_file(problem)).expect("a layout");
    }
    assert_eq!(found.stars.len(), right.len(), "{problem:?}");
    assert_eq!(found.compared(), stars.len().into(), "{problem:?}");
    let told = |front: &Front| serde_json::to_string(&document(front).stars).expect("a text");
    assert_eq!(told(&found), told(&by(Way::Walk, problem)), "{problem:?}");
}

fn turn(ticks: i64) -> Turn {
    Turn::fraction(ticks, TICKS)
}

/// The same question for both.
fn problem(asked: &Asked, cylinders: u32) -> Problem {
    let number = |text: &str| file::parse_number(text).expect("a number");
    let whole = |value: &i64| BigRational::from_integer((*value).into());
    Problem {
        bank_angle: asked.vee.as_ref().map(|(angle, ..)| turn(*angle)),
        pin_split: asked.vee.as_ref().map(|(_, split, _)| turn(*split)),
        bank_offset: asked.vee.as_ref().map(|(.., offset)| number(offset)),
        neighbours: asked.neighbours,
        minor_orders: asked.minor.iter().filter_map(|&halves| CycleOrder::of_halves(halves)).collect(),
        mode_shape: (!asked.minor.is_empty()).then(|| asked.shape.iter().map(whole).collect()),
        ..Problem::inline(cylinders, asked.cycle, &asked.orders)
    }
}

fn falling(throws: i64) -> Vec<i64> {
    (1..=throws).rev().collect()
}

/// Stars of as many directions as pins.
fn of_pins(pins: i64) -> Vec<Vec<i64>> {
    let mut stars = Vec::new();
    arrange(&mut vec![0], &(1..pins).collect::<Vec<_>>(), &mut stars);
    stars
}

/// Pins on any of this many directions, the first at 0.
fn of_grid(pins: usize, directions: i64) -> Vec<Vec<i64>> {
    let mut stars = vec![vec![0]];
    for _ in 1..pins {
        let longer = |star: Vec<i64>| (0..directions).map(move |direction| [&star[..], &[direction]].concat());
        stars = stars.into_iter().flat_map(longer).collect();
    }
    stars
}

#[test]
fn three_and_four_aims_of_engines_in_line_are_those_of_all_stars() {
    for cycle in CYCLES {
        for cylinders in 3..=if cycle == Cycle::TwoStroke { 6 } else { 8 } {
            let (stars, directions) = of_even_throws(cylinders, cycle);
            // The two lowest minor orders.
            let step = if cycle == Cycle::TwoStroke { 2 } else { 1 };
            let asked = Asked {
                cycle,
                directions,
                vee: None,
                orders: vec![1, 2, 4],
                neighbours: true,
                minor: Vec::new(),
                shape: falling(cylinders.into()),
            };
            agrees(&asked, &problem(&asked, cylinders), &stars);
            let asked = Asked { orders: vec![1, 2], minor: vec![step, 2 * step], ..asked };
            agrees(&asked, &problem(&asked, cylinders), &stars);
        }
    }
}

#[test]
fn a_mode_shape_that_is_no_other_end_for_end_tells_a_star_from_its_reversal() {
    for (cylinders, cycle, shape) in [
        (5, Cycle::TwoStroke, vec![7, 4, 2, 0, -3]),
        (6, Cycle::TwoStroke, vec![9, 7, 6, 2, 1, -4]),
        (6, Cycle::FourStroke, vec![5, 5, 3, 1, 0, -2]),
        (7, Cycle::FourStroke, vec![8, 6, 3, 2, 1, 1, 0]),
    ] {
        let (stars, directions) = of_even_throws(cylinders, cycle);
        let step = if cycle == Cycle::TwoStroke { 2 } else { 1 };
        let asked =
            Asked { cycle, directions, vee: None, orders: vec![1, 2], neighbours: false, minor: vec![step], shape };
        agrees(&asked, &problem(&asked, cylinders), &stars);
        let asked = Asked { neighbours: true, minor: vec![step, 3 * step], orders: vec![2], ..asked };
        agrees(&asked, &problem(&asked, cylinders), &stars);
    }
}

#[test]
fn vees_with_split_pins_and_offset_banks_have_the_fronts_of_all_their_cylinders() {
    let degrees = |angle: i64| angle * TICKS / 360;
    for (pins, cycle, angle, split, offset) in [
        // Even: V6 of 60° on pins split by −60°, V8 of 90°, V10 of 72°, V8 two-stroke of 45°.
        (3, Cycle::FourStroke, 60, -60, "1/5"),
        (3, Cycle::FourStroke, 90, -30, "0"),
        (4, Cycle::FourStroke, 90, 0, "0.3"),
        (5, Cycle::FourStroke, 72, 0, "-1/4"),
        (4, Cycle::TwoStroke, 45, 0, "0"),
        // Uneven.
        (3, Cycle::FourStroke, 75, 10, "1/7"),
        (4, Cycle::TwoStroke, 60, 0, "1"),
        (4, Cycle::FourStroke, 63, 0, "1/2"),
    ] {
        let asked = Asked {
            cycle,
            directions: pins,
            vee: Some((degrees(angle), degrees(split), offset.to_owned())),
            orders: vec![1, 2, 3, 4],
            neighbours: true,
            minor: Vec::new(),
            shape: Vec::new(),
        };
        agrees(&asked, &problem(&asked, 2 * pins as u32), &of_pins(pins));
        let alone = Asked { neighbours: false, orders: vec![1, 2], ..asked };
        agrees(&alone, &problem(&alone, 2 * pins as u32), &of_pins(pins));
    }
}

#[test]
fn minor_orders_of_even_vees_are_those_of_all_their_firing_orders() {
    let degrees = |angle: i64| angle * TICKS / 360;
    for (pins, angle, split, shape) in
        [(3, 60, -60, falling(3)), (4, 90, 0, falling(4)), (4, 90, 0, vec![5, 3, 1, 0]), (5, 72, 0, falling(5))]
    {
        let asked = Asked {
            cycle: Cycle::FourStroke,
            directions: pins,
            vee: Some((degrees(angle), degrees(split), "0".to_owned())),
            orders: vec![1, 2],
            neighbours: true,
            minor: vec![1, 3],
            shape,
        };
        agrees(&asked, &problem(&asked, 2 * pins as u32), &of_pins(pins));
    }
}

#[test]
fn neighbours_on_a_grid_are_those_of_the_most_even_firing_orders() {
    for (cylinders, grid, cycle) in [
        (4, 6, Cycle::TwoStroke),
        (4, 6, Cycle::FourStroke),
        (5, 6, Cycle::FourStroke),
        (5, 5, Cycle::FourStroke),
        (6, 4, Cycle::FourStroke),
        (6, 6, Cycle::TwoStroke),
    ] {
        let asked = Asked {
            cycle,
            directions: grid,
            vee: None,
            orders: vec![1, 2],
            neighbours: true,
            minor: Vec::new(),
            shape: Vec::new(),
        };
        let problem = Problem { grid: Some(grid as u32), ..problem(&asked, cylinders) };
        let mut stars = of_grid(cylinders as usize, grid);
        stars.retain(|star| asked.is_balanced(star));
        agrees(&asked, &problem, &stars);
    }
}

#[test]
fn a_vee_on_a_grid_is_compared_by_all_its_cylinders_where_its_banks_are_offset() {
    let degrees = |angle: i64| angle * TICKS / 360;
    for (pins, grid, angle, split, offset, neighbours) in [
        (3, 6, 60, 0, "1/2", false),
        (3, 6, 90, 30, "1/3", true),
        (4, 4, 90, 0, "-1/4", false),
        (4, 6, 72, 0, "0", true),
        (4, 6, 60, 15, "0.4", false),
        (5, 4, 180, 0, "1", false),
        // Of a boxer with opposed pins the two banks of every throw balance the force; where just one of both vectors is zero the pins have to.
        (1, 4, 180, 180, "1/2", false),
        (3, 4, 180, 180, "1/2", false),
        (3, 5, 180, 180, "-1/3", true),
        (3, 6, 90, 180, "1/2", false),
    ] {
        let asked = Asked {
            cycle: Cycle::FourStroke,
            directions: grid,
            vee: Some((degrees(angle), degrees(split), offset.to_owned())),
            orders: vec![1, 2, 4],
            neighbours,
            minor: Vec::new(),
            shape: Vec::new(),
        };
        let problem = Problem { grid: Some(grid as u32), ..problem(&asked, 2 * pins as u32) };
        let mut stars = of_grid(pins, grid);
        stars.retain(|star| asked.is_balanced(star));
        agrees(&asked, &problem, &stars);
    }
}

#[test]
fn a_search_by_minor_orders_goes_on_from_its_state_file_and_refuses_a_firing_order_of_another_star() {
    let file = scratch("search-minor-state").join("state.shard");
    // Not the same end for end, so that a star and its reversal are two points.
    let shape = [9, 7, 6, 2, 1, -4].map(|value: i64| BigRational::from_integer(value.into()));
    let asked = Problem {
        minor_orders: [1, 2].into_iter().filter_map(CycleOrder::of_halves).collect(),
        mode_shape: Some(shape.to_vec()),
        ..Problem::inline(6, Cycle::FourStroke, &[1, 2])
    };
    let told = |front: &Front| serde_json::to_string(&document(front)).expect("a text");
    for way in [Way::Join, Way::Walk] {
        let _ = std::fs::remove_file(&file);
        let options = || Options { way, threads: 1, resume: Some(file.clone()), ..Options::default() };
        let whole = told(&search(&asked, &options()).expect("a front"));
        assert_eq!(told(&search(&asked, &options()).expect("read again")), whole);
        let question = Pieces::new(&asked, way).expect("a question").question();
        let kept = Merged::open(std::slice::from_ref(&file), &question).expect("a file");
        let read = |piece| serde_json::from_slice(&kept.read(piece).expect("a piece")).expect("JSON");
        let mut pieces: Vec<serde_json::Value> = kept.pieces().map(read).collect();
        let is_full = |piece: &&mut serde_json::Value| !piece["stars"].as_array().expect("stars").is_empty();
        let piece = pieces.iter_mut().find(is_full).expect("a star");
        piece["stars"][0]["firing_order"] = serde_json::json!([0, 1, 2, 3, 5, 4]);
        std::fs::remove_file(&file).expect("the file");
        let mut altered = Store::open(&file, &question, Shard::WHOLE).expect("a file");
        for (number, piece) in pieces.iter().enumerate() {
            altered.put(number, piece.to_string().as_bytes()).expect("written");
        }
        altered.finish().expect("written");
        let refused = search(&asked, &options()).expect_err("no such firing order").to_string();
        assert!(refused.contains("does not fit this search"), "{refused}");
    }
    // Another mode is another search.
    let other = Problem { mode_shape: None, ..asked };
    let refused = search(&other, &Options { resume: Some(file), ..Options::default() }).expect_err("another question");
    assert!(refused.to_string().contains("belongs to another question"), "{refused}");
}

#[test]
fn a_page_tells_all_that_was_compared_in_german_too() {
    let even = Problem {
        neighbours: true,
        pin_split: Some(turn(-60 * TICKS / 360)),
        bank_offset: Some(BigRational::new(1.into(), 5.into())),
        minor_orders: [1].into_iter().filter_map(CycleOrder::of_halves).collect(),
        ..Problem::vee(6, Cycle::FourStroke, Turn::fraction(1, 6), &[1, 2])
    };
    let front = by(Way::Join, &even);
    let pages = [report::search_answer(&front), report::search_page(&front)];
    let uneven_shape = [5, 2, 0].map(|value: i64| BigRational::from_integer(value.into())).to_vec();
    let in_part = by(Way::Join, &Problem { mode_shape: Some(uneven_shape), ..even });
    assert!(front.counts_whole_classes() && !in_part.counts_whole_classes());
    for page in pages.into_iter().chain([report::search_answer(&in_part)]) {
        let text = page::write(&page, Format::GITHUB, &page::Options::default()).remove(0).text;
        for words in ["that of bank 2 is 60° behind", "Bank 1 is 0.2", "these minor orders", "Order ½", "Neighbours"]
        {
            assert!(text.contains(words), "{words}: {text}");
        }
        // Each crank star has two firing orders, and is one star.
        assert!(!text.contains("4 of the 2"), "{text}");
        let unknown: Vec<&str> = phrases(&page).into_iter().filter(|words| !Language::De.knows(words)).collect();
        let unknown: Vec<&&str> = unknown.iter().filter(|words| words.chars().any(char::is_alphabetic)).collect();
        assert!(unknown.is_empty(), "no German for {unknown:#?}");
    }
}
