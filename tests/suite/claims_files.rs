//! Are claims files and students' tables read rightly, answered, and told with the right exit status?

use std::fs;
use std::path::Path;
use std::process::Command;

use crankstar::claim::{Claims, Provenance, Quote, Status, TableVerdict, parse_claims};
use crankstar::file::{self, LayoutError};
use crankstar::page::{self, Document, Format, Options};
use crankstar::proof::{Vector, check_certificate};
use crankstar::report;
use crankstar::text::Untrusted;

use crate::support::program::{self, scratch};

fn claims(text: &str) -> Result<Claims, LayoutError> {
    parse_claims("claims.toml", text, &|name| match file::find(name) {
        Some(entry) => entry.engine().map_err(|error| error.to_string()),
        None => Err(format!("there is no engine `{name}`")),
    })
}

fn claim(layout: &str, says: &str) -> String {
    format!("[[claim]]\nlayout = \"{layout}\"\nsays = \"{says}\"\n")
}

fn table(rest: &str) -> TableVerdict {
    let text = format!("[[table]]\nlayout = \"V8-crossplane\"\n{rest}\n");
    claims(&text).expect("it reads").judged_tables().remove(0)
}

fn check(name: &str, text: &str) -> (Option<i32>, String, String) {
    let file = scratch(name).join(name);
    fs::write(&file, text).expect("a file");
    let output = Command::new(env!("CARGO_BIN_EXE_crankstar")).arg("check").arg(&file).output().expect("it starts");
    let text = |bytes: Vec<u8>| String::from_utf8(bytes).expect("a text");
    (output.status.code(), text(output.stdout), text(output.stderr))
}

/// The main file of a document.
fn text(document: &Document, format: Format) -> String {
    page::write(document, format, &Options::default()).remove(0).text
}

#[test]
fn check_ends_with_status_zero_where_all_claims_hold_and_one_where_one_fails() {
    let right = claim("I3", "first-order couple = √3") + &claim("I6", "orders 1 and 2 vanish");
    let (status, answers, _) = check("right.toml", &right);
    assert_eq!((status, answers.matches("  true").count()), (Some(0), 2));
    let (status, answers, _) = check("wrong.toml", &(right + &claim("I4", "4th-order force vanishes")));
    assert_eq!(status, Some(1));
    assert_eq!((answers.matches("  true").count(), answers.matches("  false").count()), (2, 1), "{answers}");
    let wrong = claims(&claim("I4", "4th-order force vanishes")).expect("it reads");
    let told = text(&report::claims_answer(&wrong), Format::Terminal { width: 160, colour: false });
    assert!(told.contains("false. The force of order 4 is planar, its largest value 4, along"), "{told}");
}

#[test]
fn the_claims_that_can_be_read_are_answered_beside_the_mistakes_of_all_others() {
    let right = claim("I3", "first-order couple = √3");
    let wrong = claim("I3", "nonsense") + &claim("I33", "no free moment") + "[[table]]\nlayout = \"I4\"\norder = 0\n";
    let (status, answers, mistakes) = check("mixed.toml", &(right.clone() + &wrong + &claim("I4", "F2 = 0")));
    assert_eq!(status, Some(1));
    assert!(answers.contains("1 of 2 hold") && answers.contains("true.") && answers.contains("false."), "{answers}");
    assert!(answers.contains("and are not counted: 3."), "{answers}");
    for words in ["`nonsense` is not an order", "mixed.toml:6", "/I33`: ", "mixed.toml:8", "cannot read the order `0`"]
    {
        assert!(mistakes.contains(words), "{words}: {mistakes}");
    }
    assert_eq!(mistakes.matches("error: ").count(), 3, "{mistakes}");
    // A right claim does not hide that another cannot be read.
    assert_eq!(check("one.toml", &(right + &claim("I3", "nonsense"))).0, Some(1));
    let (status, answers, mistakes) = check("none.toml", &wrong);
    assert_eq!((status, answers.as_str(), mistakes.matches("error: ").count()), (Some(1), "", 3));
}

#[test]
fn a_claims_file_that_is_wrong_is_told_with_its_place() {
    for (text, place, keyword) in [
        ("", "", "claims nothing"),
        ("[[claim]]\nlayout = \"I4\"\n", "claims.toml:1", "says"),
        (&claim("I4", "second-order farce vanishes"), "claims.toml:3", "farce"),
        (&claim("I99", "second-order force vanishes"), "claims.toml:2", "I99"),
        ("[[claim]]\nlayout = \"I4\"\nsays = \"fires evenly\"\ncolour = 1\n", "claims.toml:4", "colour"),
        ("[[table]]\nlayout = \"I4\"\norder = 0\n", "claims.toml:3", "order"),
        ("[[table]]\nlayout = \"I4\"\norder = 2\nrows = [{ cylinder = 9, direct = 0 }]\n", "claims.toml:4", "cylinder"),
        (
            "[[table]]\nlayout = \"I4\"\norder = 2\nrows = [{ cylinder = 1, direct = \"x\" }]\n",
            "claims.toml:4",
            "phase",
        ),
        ("[[table]]\nlayout = \"I4\"\norder = 2\nsums = { force_direct = \"√\" }\n", "claims.toml:4", "length"),
        ("[[table]]\nlayout = \"I4\"\norder = 2\n", "claims.toml:3", "claims nothing"),
        ("[[table]]\nlayout = \"I4\"\norder = 2\nrows = []\nsums = {}\n", "claims.toml:3", "claims nothing"),
        (
            "[[table]]\nlayout = \"I4\"\norder = 2\nrows = [{ cylinder = 1, direct = \"\" }]\n",
            "claims.toml:3",
            "claims nothing",
        ),
        (
            "[[claim]]\nlayout = \"I4\"\nsays = \"second-order force = 3 N\"\nnumbers = { reciprocating_mass = 0, crank_radius = 1, rod_length = 4, speed = 100 }\n",
            "claims.toml:4",
            "mass",
        ),
    ] {
        let message = claims(text).map(|_| ()).expect_err(text).to_string();
        assert!(message.contains(place) && message.contains(keyword), "{text}\n{message}");
    }
    let (status, answers, message) = check("broken.toml", "[[claim]");
    assert!(status == Some(1) && answers.is_empty() && !message.is_empty());
}

#[test]
fn a_right_table_is_right_and_the_first_wrong_entry_of_a_wrong_one_is_told() {
    let rows = "order = 2\nrows = [{ cylinder = 1, direct = 45, reverse = 225 }, { cylinder = 2, direct = \"585 deg\", reverse = 45 }]";
    assert!(matches!(table(rows), TableVerdict::Right(4)));
    let wrong = rows.replace("reverse = 45 ", "reverse = 44 ");
    let TableVerdict::WrongPhase { cylinder: 1, right, .. } = table(&wrong) else { panic!("not the second row") };
    assert_eq!(right.degrees().to_string(), "45");
    let both = wrong.replace("direct = 45", "direct = 46");
    assert!(matches!(table(&both), TableVerdict::WrongPhase { cylinder: 0, .. }));
}

#[test]
fn sums_of_a_table_are_lengths_exact_or_rounded() {
    let sums = |sums: &str| table(&format!("order = 1\nsums = {{ {sums} }}"));
    assert!(matches!(sums("force_direct = 0, moment_direct = \"2√10\", moment_reverse = 0"), TableVerdict::Right(3)));
    assert!(matches!(sums("moment_direct = 6.32"), TableVerdict::Right(1)));
    for wrong in [
        "moment_direct = 6.33",
        "moment_direct = 6",
        "moment_direct = 0",
        "force_direct = 0.001",
        "moment_reverse = \"√2\"",
    ] {
        assert!(matches!(sums(wrong), TableVerdict::WrongSum { .. }), "{wrong}");
    }
}

#[test]
fn one_order_that_is_asked_and_left_is_named_alone() {
    let (_, answers, _) = check("one.toml", &claim("I3", "F1 = M1 = 0"));
    let answers = answers.split_whitespace().collect::<Vec<_>>().join(" ");
    assert!(answers.contains("Order 1 remains:") && !answers.contains("Of the 1 orders"), "{answers}");
}

#[test]
fn newtons_of_the_worked_in_line_five_are_answered_with_the_exact_ones() {
    let numbers = "numbers = { reciprocating_mass = \"1.5 kg\", crank_radius = \"50 mm\", rod_length = \"175 mm\", speed = \"600 rpm\", spacing = \"0.15 m\" }\n";
    let at = |says: &str| {
        let text = claim("I5-14532", says) + numbers;
        claims(&text).expect("it reads").statements[0].claims[0].answer().status
    };
    assert_eq!(at("first-order couple = 65.18 N·m ± 1 %"), Status::False);
    assert_eq!(at("first-order couple = 69.34 N·m ± 0.01"), Status::True);
    assert_eq!(at("second-order couple = 58.3 N·m ± 1 %"), Status::False);
    assert!(matches!(at("orders 1 and 2 of the force vanish"), Status::True));
}

#[test]
fn numbers_of_a_claim_are_none_other_than_those_of_its_layout() {
    let layout = "speed = 600\n[inline]\nthrows = [0, 180, 180, 0]\nspacing = '0.1 m'\n[mechanism]\nreciprocating_mass = '1.5 kg'\n\
        crank_radius = '50 mm'\nrod_length = '175 mm'\n";
    let read = |layout: &str, numbers: &str| {
        let text = claim("own.toml", "second-order force = 3 N") + numbers;
        let find = |_: &str| file::parse("own.toml", layout).map_err(|error| error.to_string());
        parse_claims("claims.toml", &text, &find).map_err(|error| error.to_string())
    };
    let numbers =
        "numbers = { reciprocating_mass = 1.5, crank_radius = '5 cm', rod_length = '17.5 cm', speed = 600 }\n";
    read(layout, numbers).expect("the same");
    read("inline.throws = [0, 180, 180, 0]\n", &numbers.replace(" }", ", spacing = 0.15 }")).expect("no others");
    let bare = "[inline]\nthrows = [0, 120, 240]\npositions = [0, 1, 2]\n";
    read(bare, &numbers.replace(" }", ", spacing = 0.15 }")).expect("positions in multiples of the spacing");
    for (own, other, words) in [
        ("mass = 1.5", "mass = 1.4", "another reciprocating mass"),
        ("'5 cm'", "'6 cm'", "another crank radius"),
        ("'17.5 cm'", "'17 cm'", "another ratio of crank radius and rod"),
        ("speed = 600", "speed = 601", "another speed"),
        ("600 }", "600, spacing = '0.1 m' }", "positions in metres"),
    ] {
        let error = read(layout, &numbers.replace(own, other)).map(|_| ()).expect_err(words);
        assert!(error.contains(words) && error.contains("claims.toml:4"), "{words}: {error}");
    }
}

/// The published page's file, its engines found beside it.
fn published() -> Claims {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("reports/claims");
    let text = fs::read_to_string(folder.join("claims.toml")).expect("the claims");
    let find = |name: &str| match file::find(name) {
        Some(entry) => entry.engine().map_err(|error| error.to_string()),
        None => {
            let text = fs::read_to_string(folder.join(name)).map_err(|error| error.to_string())?;
            file::parse(name, &text).map_err(|error| error.to_string())
        }
    };
    parse_claims("claims.toml", &text, &find).unwrap_or_else(|error| panic!("{error}"))
}

#[test]
fn the_page_of_published_claims_is_as_stored() {
    let page = text(&report::claims_page(&published()), Format::GITHUB);
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("reports/claims/README.md");
    if std::env::var_os("CRANKSTAR_RENEW").is_some() {
        fs::write(&path, &page).expect("the page");
    }
    assert!(fs::read_to_string(&path).expect("the page") == page, "{} differs", path.display());
}

#[test]
fn every_answer_to_a_published_claim_is_decided_and_its_certificates_hold() {
    let claims = published();
    let all: Vec<_> = claims.statements.iter().flat_map(|statement| &statement.claims).collect();
    assert!(all.len() >= 40);
    for claim in all {
        let answer = claim.answer();
        assert_ne!(answer.status, Status::NotDecided, "{}: {}", claim.engine.written(), claim.says.written());
        let is_own = claim.provenance == Provenance::Own;
        assert!(
            !is_own || answer.status.holds(),
            "computed here, and false: {}: {}",
            claim.engine.written(),
            claim.says.written()
        );
        for evidence in &answer.evidence {
            let vector = |term: &crankstar::exact::Term| Vector {
                angle: term.angle.turns().clone(),
                weight: term.weight.clone(),
            };
            let terms: Vec<Vector> = evidence.sum().terms().iter().map(vector).collect();
            check_certificate(&terms, evidence.vanishes(), evidence.certificate()).expect("the certificate holds");
        }
    }
}

fn provenance(text: &str) -> Vec<Provenance> {
    let claims = claims(text).expect("it reads");
    claims.statements.into_iter().flat_map(|statement| statement.claims).map(|claim| claim.provenance).collect()
}

#[test]
fn only_a_claim_with_a_place_and_words_counts_as_that_of_its_source() {
    let place = "place = \"section 4.1\"\nwords = \"is balanced\"\n";
    let row = |rest: &str| format!("[[statement.claim]]\nlayout = \"I4\"\nsays = \"fires evenly\"\n{rest}");
    let statement = |rest: &str| format!("[[statement]]\ntext = \"x\"\n{rest}");
    let of = |text: &str| Untrusted::new(text);
    let quoted =
        |place: &str| Provenance::Quoted(Quote { source: of("a book"), place: of(place), words: of("is balanced") });
    let source = "source = \"a book\"\n";
    let text = [statement(&format!("{source}{place}")), row(""), row("kind = \"own\"\n"), row("place = \"page 7\"\n")]
        .concat();
    assert_eq!(provenance(&text), [quoted("section 4.1"), Provenance::Own, quoted("page 7")]);
    // A source of the file, and a row that says nothing of itself.
    let text = [source, &statement(""), &row(place), &row("")].concat();
    assert_eq!(provenance(&text), [quoted("section 4.1"), Provenance::Own]);
    let text = [statement("kind = \"folklore\"\n"), row(""), row("kind = \"own\"\n")].concat();
    assert_eq!(provenance(&text), [Provenance::Folklore, Provenance::Own]);
    for (wrong, keyword) in [
        (row("place = \"page 7\"\n"), "words"),
        (row("words = \"so\"\n"), "place"),
        (row("kind = \"quoted\"\n"), "place"),
        (row("kind = \"hearsay\"\n"), "folklore"),
        (row(&format!("kind = \"own\"\n{place}")), "quoted"),
    ] {
        let message = claims(&[source, &statement(""), &wrong].concat()).map(|_| ()).expect_err(&wrong).to_string();
        assert!(message.contains(keyword) && message.contains("claims.toml:"), "{wrong}\n{message}");
    }
    let message = claims(&[statement(""), row(place)].concat()).map(|_| ()).expect_err("no source").to_string();
    assert!(message.contains("`source`"), "{message}");
}

#[test]
fn a_page_counts_what_is_quoted_what_is_folklore_and_what_is_its_own_apart() {
    let row = |says: &str, rest: &str| format!("[[statement.claim]]\nlayout = \"I4\"\nsays = \"{says}\"\n{rest}");
    let quoted = "source = \"a book\"\nplace = \"page 7\"\nwords = \"fires as it should\"\n";
    let file = [
        "[[statement]]\ntext = \"x\"\n",
        &row("fires evenly", quoted),
        &row("second-order force vanishes", quoted),
        &row("fourth-order force vanishes", "kind = \"folklore\"\n"),
        &row("second-order force = 4", ""),
    ];
    let page = text(&report::claims_page(&claims(&file.concat()).expect("it reads")), Format::GITHUB);
    for words in [
        "Claims quoted from their sources: 1 of 2 hold.",
        "Common claims without a source: 0 of 1 hold.",
        "Our own cross-checks: 1 of 1 hold.",
        "**a book, page 7:** “fires as it should”",
    ] {
        assert!(page.contains(words), "{words}\n{page}");
    }
    let (claimed, own) = page.split_once("Cross-checks of our own:").expect("a table of its own");
    assert!(claimed.contains("fires evenly") && own.contains("second-order force = 4"));
    assert!(!claimed.contains("second-order force = 4 "), "{page}");
}

/// Each row that stands for a source on the published pages, with the section or equation that it is in.
#[test]
fn every_row_that_is_counted_as_a_source_s_claim_names_its_place_in_few_words() {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("reports");
    let mut quoted = 0;
    for name in ["claims", "thesis"] {
        let at = folder.join(name);
        let text = fs::read_to_string(at.join("claims.toml")).expect("the claims");
        let find = |name: &str| match file::find(name) {
            Some(entry) => entry.engine().map_err(|error| error.to_string()),
            None => {
                let text = fs::read_to_string(at.join(name)).map_err(|error| error.to_string())?;
                file::parse(name, &text).map_err(|error| error.to_string())
            }
        };
        let claims = parse_claims("claims.toml", &text, &find).unwrap_or_else(|error| panic!("{error}"));
        for claim in claims.statements.iter().flat_map(|statement| &statement.claims) {
            let Provenance::Quoted(Quote { source, place, words }) = &claim.provenance else { continue };
            let names_a_place =
                ["section ", "eq. ", "example", "solution"].iter().any(|word| place.written().contains(word));
            assert!(
                names_a_place && !source.written().is_empty(),
                "{name}: {}: {}",
                claim.says.written(),
                place.written()
            );
            assert!((1..=20).contains(&words.written().split_whitespace().count()), "{name}: {}", words.written());
            quoted += 1;
        }
    }
    assert!(quoted > 100);
}

#[test]
fn moments_of_a_layout_in_metres_are_told_to_be_in_metres() {
    let folder = scratch("claims-in-metres");
    let says = "says = 'first-order moment = √3'";
    let told = |spacing: &str| {
        std::fs::write(
            folder.join("three.toml"),
            format!("inline = {{ throws = [0, 240, 120], spacing = {spacing} }}"),
        )
        .expect("a file");
        std::fs::write(folder.join("claims.toml"), format!("[[claim]]\nlayout = 'three.toml'\n{says}\n"))
            .expect("a file");
        let out = program::call(&["check".as_ref(), folder.join("claims.toml").as_os_str()]);
        let printed = String::from_utf8(out.stdout).expect("a text");
        (out.status.code(), printed.split_whitespace().collect::<Vec<_>>().join(" "))
    };
    let (status, metres) = told("'100 mm'");
    assert!(status == Some(1) && metres.contains("are in metres"), "{metres}");
    let (status, spacings) = told("1");
    assert!(status == Some(0) && !spacings.contains("are in metres"), "{spacings}");
}

/// An order of unlike rods is several sums, one of offset axes is turned: no star of one vector for each cylinder.
#[test]
fn a_vector_star_table_is_of_an_engine_whose_orders_are_one_star_each() {
    let folder = scratch("table-of-several-sums");
    for (layout, why) in [
        ("rod_length = ['120 mm', '200 mm']", "rods or their offsets differ"),
        ("rod_length = '140 mm', pin_offset = ['10 mm', '-10 mm']", "rods or their offsets differ"),
        ("rod_length = '140 mm', pin_offset = '10 mm'", "axes miss the crankshaft"),
    ] {
        let layout = format!("inline = {{ throws = [0, 90] }}\nmechanism = {{ stroke = '80 mm', {layout} }}\n");
        fs::write(folder.join("engine.toml"), layout).expect("a layout");
        let table = "[[table]]\nlayout = 'engine.toml'\norder = 1\nrows = [{ cylinder = 1, direct = 0 }]\n";
        let file = folder.join("table.toml");
        fs::write(&file, table).expect("a table");
        let output = program::call(&["check", &file.display().to_string()]);
        let told = String::from_utf8_lossy(&output.stderr);
        assert_eq!(output.status.code(), Some(1), "{told}");
        assert!(told.contains("no vector-star table") && told.contains(why), "{told}");
    }
}

#[test]
fn a_series_takes_the_rod_ratio_of_the_numbers_of_its_claim() {
    let numbers = "numbers = { reciprocating_mass = \"0.5 kg\", crank_radius = \"43 mm\", rod_length = \"143 mm\", speed = \"6000 rpm\" }\n";
    for (factor, expected) in [("0.3007", Status::False), ("0.3078", Status::TrueAsRounded), ("43/143", Status::True)] {
        let text = claim("I4", &format!("F = 4 m r ω² ({factor} cos 2θ)")) + numbers;
        let claims = claims(&text).expect("it reads");
        assert_eq!(claims.statements[0].claims[0].answer().status, expected, "{factor}");
    }
}

#[test]
fn a_page_of_claims_says_that_formulas_and_loads_are_compared_in_decimals() {
    let page = text(&report::claims_page(&claims(&claim("I4", "no free moment")).expect("it reads")), Format::GITHUB);
    assert!(page.contains("except values in newtons, loads, and formulas that are compared angle by angle: these are compared in decimals."), "{page}");
}

/// The words of the program have German; the message of an error stays, with the numbers and the signs of TOML in it.
#[test]
fn reasons_are_german_and_no_comma_is_put_into_the_message_of_an_error() {
    let folder = scratch("german-reasons");
    fs::write(folder.join("four.toml"), "inline = { throws = [0, 180, 180, 0], spacing = '0.1 m' }\n")
        .expect("a layout");
    let claimed = claim("I8-44", "fires evenly") + &claim("four.toml", "worst main bearings 2 and 3");
    fs::write(folder.join("claims.toml"), claimed).expect("claims");
    let output = program::call(&[
        "check",
        &folder.join("claims.toml").display().to_string(),
        "--lang",
        "de",
        "--format",
        "markdown",
    ]);
    let told = String::from_utf8(output.stdout).expect("a text");
    assert!(told.contains("die Kröpfungen erlauben"), "{told}");
    assert!(!told.contains("0,15") && told.contains("0.15"), "{told}");
}

#[test]
fn the_mass_of_several_crankshafts_is_called_that_of_all() {
    let folder = scratch("mass-of-two-crankshafts");
    let layout = "opposed_piston = { throws = [0, 120, 240], lead = 20.5, distance = '400 mm', spacing = '100 mm' }\n\
        mechanism = { stroke = '60 mm', rod_length = '150 mm', reciprocating_mass = '1 kg' }\n";
    fs::write(folder.join("two.toml"), layout).expect("a layout");
    fs::write(folder.join("claims.toml"), claim("two.toml", "crankshaft mass = 3 kg")).expect("claims");
    let printed = |command: &str, file: &str| {
        let output = program::call(&[command, &folder.join(file).display().to_string(), "--format", "markdown"]);
        String::from_utf8(output.stdout).expect("a text")
    };
    let checked = printed("check", "claims.toml");
    assert!(checked.contains("The mass of the crankshafts together is 3 kg."), "{checked}");
    assert!(printed("remedy", "two.toml").contains("Mass of all crankshafts together that counts in the balance"));
}

#[test]
fn an_order_as_strong_as_the_strongest_one_is_named_with_it() {
    let claims = claims(&claim("V2-90", "order 5/2 is the strongest minor order")).expect("it reads");
    let told = text(&report::claims_answer(&claims), Format::GITHUB);
    assert!(told.contains("The strongest minor order is 1½") && told.contains("By symmetry as strong: 2½."), "{told}");
}

#[test]
fn one_interval_and_one_order_are_told_in_the_singular() {
    let told = |layout: &str, says: &str| {
        text(&report::claims_answer(&claims(&claim(layout, says)).expect("it reads")), Format::GITHUB)
    };
    assert!(told("I1", "fires evenly").contains("The interval is 720°."));
    assert!(told("I6", "every order vanishes").contains("this one of each period remains: 6;"));
    assert!(told("I2-180", "orders 1 and 2 vanish").contains("these remain: 1, 2;"));
}

#[test]
fn a_plane_that_is_not_that_of_the_moments_is_no_it() {
    let folder = scratch("claims-of-another-plane");
    let layout = "reference_plane = 1\ninline = { throws = [0, 180, 180, 0] }\n";
    fs::write(folder.join("four.toml"), layout).expect("a layout");
    fs::write(folder.join("claims.toml"), claim("four.toml", "second-order moment vanishes")).expect("claims");
    let output = program::call(&["check", &folder.join("claims.toml").display().to_string(), "--format", "markdown"]);
    let told = String::from_utf8(output.stdout).expect("a text");
    assert!(told.contains("which is not so here"), "{told}");
}
