//! What was printed badly once: is each thing said once, under a heading of its own, and in the form in which a reader expects it?

use std::collections::BTreeSet;

use super::true_sentences::{printed, said, written};
use crate::support::program::{call, scratch};

/// What the program prints, on its own lines.
fn lines(arguments: &[&str]) -> String {
    let output = call(arguments);
    assert!(output.status.success(), "{arguments:?}: {}", String::from_utf8_lossy(&output.stderr));
    String::from_utf8(output.stdout).expect("a text")
}

const OPPOSED: &str = "opposed_piston = { throws = [0, 240, 120], lead = 0, distance = 12 }";
const ALL_EFFECTS: &str = "reports/examples/thesis-i3/layout.toml";

#[test]
fn headings_of_a_page_differ() {
    let geared = written(&format!(
        "speed = 3000\neffects = [\"torque\"]\n{OPPOSED}\nmechanism = {{ reciprocating_mass = 1, rod_ratio = 0.25, crank_radius = \"50 mm\" }}"
    ));
    for layout in [ALL_EFFECTS, "reports/examples/v8-gas/layout.toml", "radial-9-master", &geared] {
        for question in ["report", "loads"] {
            let page = lines(&[question, layout, "--format", "markdown"]);
            let headings: Vec<&str> = page.lines().filter(|line| line.starts_with('#')).collect();
            let mut known = BTreeSet::new();
            for heading in headings {
                assert!(known.insert(heading.trim_start_matches('#').trim()), "{question} {layout}: {heading} twice");
            }
        }
    }
}

#[test]
fn a_polygon_is_listed_once_with_its_whole_weight() {
    let page = printed(&["report", "radial-14", "--format", "text"]);
    for list in page.split("sums to zero: ").skip(1).filter_map(|rest| rest.split_once('.')) {
        let polygons: Vec<&str> = list.0.split("; ").collect();
        let apart: BTreeSet<&&str> = polygons.iter().collect();
        assert_eq!(apart.len(), polygons.len(), "{}", list.0);
    }
    assert!(!page.contains("taken 0.5 long each"));
}

#[test]
fn a_phase_of_a_family_has_no_zero_before_its_unknown() {
    for banks in ["[\"-phi/2\", \"phi/2\"]", "[\"-phi\", 0, \"phi\"]"] {
        let page =
            said("report", &format!("fan = {{ banks = {banks}, throws = [0, 120, 240] }}"), &["--format", "text"]);
        assert!(page.contains("φ") && !page.contains(" 0° + ") && !page.contains(" 0° − "), "{page}");
    }
}

#[test]
fn an_order_of_the_roll_moment_that_is_named_first_is_in_its_table() {
    let page = lines(&["report", &written(OPPOSED), "--format", "text"]);
    assert!(page.contains("(order 3)"), "{page}");
    let table = page.split("Order   Torque   Roll").nth(1).expect("a table");
    let row = table.lines().find(|line| line.trim_start().starts_with("3 ")).expect("a row of order 3");
    assert!(row.contains("torque"), "{row}");
}

#[test]
fn a_claim_of_one_order_is_answered_of_one() {
    let answer = |says: &str| {
        let path = scratch("one-order").join("claims.toml");
        std::fs::write(&path, format!("title = \"x\"\n[[claim]]\nlayout = \"I4\"\nsays = \"{says}\"")).expect("claims");
        printed(&["check", path.to_str().expect("UTF-8")])
    };
    for says in ["orders 1 of the moment vanish", "order 1 of force and moment vanish"] {
        let answer = answer(says);
        assert!(answer.contains("It vanishes.") && !answer.contains("of them"), "{answer}");
    }
    assert!(answer("orders 1 and 2 of the moment vanish").contains("All of them vanish."));
}

/// Rods that differ by less than is computed: order 2 of torque and force may be zero.
#[test]
fn what_is_not_decided_has_its_bound_and_no_smallest_decimal_of_the_machine() {
    let less = format!("\"0.24{}\"", "9".repeat(58));
    let layout = written(&format!(
        "effects = [\"torque\"]\ninline = {{ throws = [0, 0, 90, 90], spacing = 1 }}\nmechanism = {{ rod_ratio = [0.25, 0.25, {less}, {less}], reciprocating_mass = 1 }}"
    ));
    let table = lines(&["loads", &layout, "--orders", "2", "--table", "torque", "--format", "csv"]);
    let row: Vec<&str> = table.lines().find(|line| line.starts_with("2,")).expect("order 2").split(',').collect();
    let [size, below] = [row[2], row[4]].map(|cell| cell.parse::<f64>().expect("a decimal"));
    assert!(row[1].is_empty() && below > 0.0 && below < 1e-18 && size > 1e-300 && size < below, "{row:?}");
    for more in [&["--format", "csv"][..], &["--json"]] {
        // The name of the layout's file holds the number of this process, which may begin with 308.
        let all = lines(&[&["loads", layout.as_str(), "--orders", "2"], more].concat()).replace(&layout, "");
        assert!(!all.contains("e-308"), "{all}");
    }
}

#[test]
fn the_unit_of_forces_is_a_formula_in_latex() {
    for layout in ["I4", "V6-60-even", ALL_EFFECTS] {
        let page = lines(&["report", layout, "--format", "latex"]);
        let unit = page.find("$m\\,r\\,\\omega^2$").is_some();
        assert!(unit && !page.contains("m r $\\omega$") && !page.contains("m r\\textsuperscript"), "{layout}");
    }
}

/// What `crankstar` writes into this file of a folder.
fn file_of(arguments: &[&str], name: &str) -> String {
    let folder = scratch("blemishes").join("out");
    lines(&[arguments, &["--output", folder.to_str().expect("UTF-8")]].concat());
    std::fs::read_to_string(folder.join(name)).unwrap_or_else(|error| panic!("{name}: {error}"))
}

#[test]
fn dashes_euros_and_ends_of_proofs_have_signs_in_latex() {
    let layout = written("title = 'A — B, 5 €'\ninline = { throws = [0, 180] }");
    for (page, sign) in [
        (lines(&["stars", "--format", "latex"]), "$\\blacksquare$"),
        (lines(&["report", &layout, "--format", "latex"]), "A \\textemdash{} B, 5 \\texteuro{}"),
    ] {
        assert!(page.contains(sign) && !page.contains("[U+"), "{sign}");
    }
}

/// Two cylinders with a best damper, geared to a fourth disc.
const GEARED: &str = "speed = '1234.5 rpm'\ncycle = 'four-stroke'\nfiring_order = '1-2'\n[inline]\nthrows = [0, 0]\n\
    [torsion]\ninertias = [0.03, 0.03, 0.3, 0.01]\nstiffnesses = ['1 MN m/rad', '1 MN m/rad']\nloss_factor = 0.01\nspeed_range = [500, 9000]\n\
    [[torsion.gear]]\nbetween = [3, 4]\nratio = '-7/3'\n\
    [[torsion.damper]]\ndisc = 1\ninertia = 0.02\ndamping = 'best'\nstiffness = 'best'\n\
    [[torsion.harmonic]]\norder = 3\ntorque = '100 N m'\n";

#[test]
fn a_campbell_diagram_reaches_the_range_of_speeds() {
    let layout = written(GEARED);
    assert!(file_of(&["torsion", &layout, "--format", "markdown"], "campbell.svg").contains(">8000<"));
    let layout = written(&GEARED.replace("[500, 9000]", "[500, 600]"));
    let drawn = file_of(&["torsion", &layout, "--format", "markdown"], "campbell.svg");
    assert!(drawn.contains(">1000<") && !drawn.contains(">2000<"), "{drawn}");
}

#[test]
fn the_equation_of_gears_breaks_and_has_an_ellipsis() {
    for (format, dots) in [("text", "…"), ("typst", "…"), ("latex", "\\dots")] {
        let page = lines(&["torsion", &written(GEARED), "--format", format]);
        assert!(page.contains(&format!("+ {dots}")) && !page.contains("ldots") && !page.contains("\\left("), "{page}");
    }
}

#[test]
fn the_ring_of_a_damper_is_no_disc_of_the_layout() {
    let page = lines(&["torsion", &written(GEARED), "--format", "markdown"]);
    let nodes = page.split("Node from disc").nth(1).and_then(|rest| rest.split("\n\n").next()).expect("a table");
    assert!(nodes.contains("| 1 | ring of damper 1 |") && !nodes.contains("| 5 |"), "{nodes}");
}

#[test]
fn the_speed_of_torsion_is_that_of_the_layout() {
    let page = printed(&["torsion", &written(GEARED), "--format", "markdown"]);
    assert!(page.contains("At 1234.5 rpm the first disc") && !page.contains("1234 rpm"), "{page}");
    let third = written(&GEARED.replace("'1234.5 rpm'", "'3700/3'"));
    assert!(printed(&["torsion", &third]).contains("At 1233 rpm the first disc"));
}

#[test]
fn firing_stars_of_one_cylinder_name_it_and_the_caption_counts_those_drawn() {
    let arguments = ["firing", "radial-7-master", "--format", "markdown"];
    let drawn = file_of(&arguments, "firing-stars.svg");
    assert!(drawn.contains(">Order ½ (cylinder 1)<") && !drawn.contains(">Order ½, 1<"), "{drawn}");
    assert!(lines(&arguments).contains("The first 12 firing stars of 56."));
    assert!(lines(&["firing", "I4", "--format", "markdown"]).contains("\nFiring stars."));
}

#[test]
fn the_acceleration_is_that_of_the_textbook_only_where_it_has_one() {
    let rods =
        "speed = 3000\nmechanism = { stroke = '90 mm', rod_length = '150 mm', OFFSET }\ninline = { throws = [0, 180] }";
    for (offset, has_textbook) in [("pin_offset = 0", true), ("pin_offset = '4 mm'", false)] {
        let page = said("angle", &rods.replace("OFFSET", offset), &["--at", "30", "--format", "markdown"]);
        assert_eq!(page.contains(", of the mechanism and by the textbook's two terms."), has_textbook, "{page}");
    }
}

#[test]
fn german_pages_have_no_english_reason_nor_unit_of_a_star() {
    let single = written(
        "speed = 3000\ncycle = 'four-stroke'\ninline = { throws = [0], spacing = '90 mm' }\n\
        mechanism = { stroke = '90 mm', rod_length = '150 mm', pin_offset = '4 mm', reciprocating_mass = 1 }\n\
        gas = { dead_centre = 'piston', bore = '70 mm', process = 'spark-ignition', compression_ratio = 11, mean_pressure = '11 bar' }",
    );
    let page = printed(&["moments", &single, "--lang", "de"]);
    assert!(page.contains("bekannt sind sie für Pleuel endlicher Länge"), "{page}");
    let rods = "fan = { banks = [-47.5, 0, 61.25], throws = [0, 180], spacing = '0.13 m' }\narticulated = { master = [3, 4], knuckle_radius = '41 mm' }\n\
        mechanism = { stroke = '99 mm', rod_length = '190 mm' }";
    let page = said("report", rods, &["--lang", "de", "--format", "latex"]);
    assert!(page.contains("$ $\\cdot$ Meter") && !page.contains("metre}"), "{page}");
}

#[test]
fn turned_mounts_say_so() {
    let layout = std::fs::read_to_string("reports/examples/i4-mounts/layout.toml").expect("a layout");
    let turned =
        said("mounts", &layout.replace("turned = [0, 0, 30]", "turned = [10, -20, 30]"), &["--format", "markdown"]);
    assert!(turned.contains("| Turned about x; y; z |") && turned.contains("| 10°; −20°; 30° |"), "{turned}");
    let straight = said("mounts", &layout.replace("turned = [0, 0, 30]", ""), &["--format", "markdown"]);
    assert!(!straight.contains("Turned about"), "{straight}");
}

#[test]
fn an_index_is_no_underscore_in_latex_nor_in_a_drawing() {
    let drawn = lines(&["figure", "V2-90", "sweep:force-2", "--bank-angle", "0..180:10"]);
    assert!(drawn.contains(">Force in m r ω² c<tspan") && !drawn.contains("c_k"), "{drawn}");

    for arguments in [
        &["compare", "I4", "V6-60-shared", "--format", "latex"][..],
        &["sweep", "V6-60-shared", "--bank-angle", "0..60:30", "--pin-split", "-60..60:60", "--format", "latex"],
    ] {
        let page = lines(arguments);
        assert!(page.contains("c_k$") && !page.contains("c\\_k"), "{arguments:?}");
    }
    let stress = file_of(
        &["torsion", "reports/examples/marine-six-torsion/layout.toml", "--format", "markdown"],
        "torsion-stress.svg",
    );
    assert!(stress.contains(">permitted ") && !stress.contains("τ_C"), "{stress}");
}

#[test]
fn the_halves_of_a_star_in_decimals_stand_after_an_approximate_sign() {
    let rods = "fan = { banks = [-47.5, 0, 61.25], throws = [0, 180] }\narticulated = { master = [3, 4], knuckle_radius = '41 mm' }\n\
        mechanism = { stroke = '99 mm', rod_length = '190 mm' }";
    let page = lines(&["report", &written(rods), "--format", "markdown"]);
    let halves =
        page.split("½ reverse in m r ω² |").nth(1).and_then(|rest| rest.split("\n\n").next()).expect("a table");
    let cells: Vec<&str> = halves.split('|').filter(|cell| cell.contains(" at ")).collect();
    assert!(!cells.is_empty() && cells.iter().all(|cell| cell.matches('≈').count() == 2), "{halves}");
}

#[test]
fn a_map_marks_all_points_of_its_least_value() {
    let asked =
        ["sweep", "V6-60-shared", "--bank-angle", "0..180:60", "--pin-split", "-60..60:60", "--format", "markdown"];
    let folder = scratch("least").join("out");
    lines(&[&asked[..], &["--output", folder.to_str().expect("UTF-8")]].concat());
    let map = std::fs::read_to_string(folder.join("moment-1.svg")).expect("a map");
    assert_eq!(map.matches(">≈ 1.500<").count(), 1, "{map}");
    // Two points and their sign in the legend.
    assert_eq!(map.matches("<circle").count(), 3, "{map}");
}

#[test]
fn an_address_as_long_as_a_line_may_break_in_latex_and_a_title_in_a_browser() {
    let address = format!("https://example.org/{}", "abcdefgh_ij/".repeat(10));
    let layout = written(&format!("title = 'T'\nsource = '{address}'\n[inline]\nthrows = [0, 180]\n"));
    let page = lines(&["report", &layout, "--format", "latex"]);
    assert_eq!(page.matches("ij/\\allowbreak{}").count(), 19, "{page}");
    assert!(!lines(&["report", "I4", "--format", "latex"]).contains("\\allowbreak"));
    assert!(lines(&["report", "I4", "--format", "html"]).contains("h1, h2, h3, p, li { overflow-wrap: anywhere; }"));
}

#[test]
fn appendices_of_a_family_are_named_by_their_orders() {
    let family = "vee = { bank_angle = 'phi', pin_split = 'delta', throws = [0, 120, 240] }";
    let page = lines(&["report", &written(family), "--format", "latex"]);
    for order in [1, 2, 4, 6] {
        assert_eq!(page.matches(&format!("\\section{{Order {order}: sums and certificates}}")).count(), 1, "{page}");
    }
}

#[test]
fn no_line_of_latex_ends_between_a_sign_and_its_number() {
    for layout in [ALL_EFFECTS, "reports/examples/v8-gas/layout.toml"] {
        for question in ["report", "loads"] {
            let page = lines(&[question, layout, "--format", "latex"]);
            let mut prose = page.lines().filter(|line| !line.starts_with("\\node"));
            assert!(prose.clone().any(|line| line.contains("$\\approx$~")));
            assert_eq!(prose.find(|line| line.contains("$\\approx$ ")), None, "{question} {layout}");
        }
    }
}

#[test]
fn a_table_without_headings_has_no_row_of_them() {
    let layout = written("title = 'T'\n[document]\nnumber = 'X-1'\n[inline]\nthrows = [0, 180]\n");
    let latex = lines(&["report", &layout, "--format", "latex"]);
    assert!(latex.contains("\\toprule\nDocument & X-1 \\\\\n"), "{latex}");
    let typst = lines(&["report", &layout, "--format", "typst"]);
    assert!(
        typst.contains("table.hline(), \n[Document], [X\\-1],")
            || typst.contains("table.hline(), \n[Document], [X-1],"),
        "{typst}"
    );
    assert!(!typst.contains("table.header([], []"), "{typst}");
}
