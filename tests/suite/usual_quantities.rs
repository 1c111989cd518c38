//! Is a unit that was forgotten told, with its key, and nothing told of engines that there are?

use std::io::Write;
use std::path::{Path, PathBuf};
use std::process::{Output, Stdio};

use crankstar::file::{self, FileResolver, Layout, parse_layout, parse_layout_beside};

use crate::support::program::{call, scratch};

fn warnings(text: &str) -> Vec<String> {
    let layout = parse_layout("layout.toml", text).unwrap_or_else(|error| panic!("{text}\n{error}"));
    file::warnings("layout.toml", text, &layout).iter().map(ToString::to_string).collect()
}

const FOUR: &str = "speed = 3000\n[mechanism]\ncrank_radius = '46 mm'\nrod_length = '140 mm'\nreciprocating_mass = '450 g'\nrotating_mass = '0.4 kg'\n\
    [inline]\nthrows = [0, 180, 180, 0]\nspacing = '90 mm'\n[[counterweight]]\nthrow = 1\nmass = '1 kg'\nradius = '45 mm'\n";

#[test]
fn a_forgotten_unit_is_told_with_its_key_and_the_unit_that_may_be_meant() {
    assert_eq!(warnings(FOUR), Vec::<String>::new());
    for (from, to, words) in [
        ("'46 mm'", "46", ["crank_radius is read as 46 m", "layout.toml:3", "such as \"46 mm\""]),
        (
            "'46 mm'",
            "'0.046 mm'",
            ["crank_radius is read as 0.000046 m", "layout.toml:3", "engines have 0.001 m to 3 m"],
        ),
        ("crank_radius = '46 mm'", "stroke = 92", ["stroke is read as 92 m", "layout.toml:3", "such as \"92 mm\""]),
        ("'140 mm'", "140", ["rod_length is read as 140 m", "layout.toml:4", "such as \"140 mm\""]),
        (
            "'140 mm'",
            "[140, '140 mm', '140 mm', '140 mm']",
            ["rod_length is read as 140 m", "layout.toml:4:15", "such as \"140 mm\""],
        ),
        ("'0.4 kg'", "400000", ["rotating_mass is read as 400000 kg", "layout.toml:6", "such as \"400000 g\""]),
        ("'450 g'", "450", ["a reciprocating mass of 450 kg at a stroke of 92 mm", "layout.toml:5", "\"450 g\""]),
        ("'90 mm'", "'90 m'", ["spacing is read as 90 m", "layout.toml:9", "engines have 0.002 m to 10 m"]),
        ("'45 mm'", "45", ["radius is read as 45 m", "layout.toml:13", "such as \"45 mm\""]),
        ("'90 mm'", "0", ["spacing is 0", "layout.toml:9", "throws one spacing apart are then in one plane: how"]),
        ("3000", "0.5", ["speed is read as 0.5 rpm", "layout.toml:1", "such as \"0.5 rev/s\""]),
        ("3000", "'6.000 rpm'", ["speed is read as 6 rpm", "layout.toml:1", "10 rpm to"]),
        ("3000", "30000", ["speed makes a mean piston speed of 92 m/s", "layout.toml:1", "at most 40 m/s"]),
        ("3000", "'314 rev/s'", ["speed makes a mean piston speed of 58 m/s", "layout.toml:1", "at most 40 m/s"]),
    ] {
        // The crank and its rod are in the same unit, or the rod is too short.
        let text = match from {
            _ if to == "46" || to == "stroke = 92" => FOUR.replace(from, to).replace("'140 mm'", "'140 m'"),
            _ => FOUR.replace(from, to),
        };
        let told = warnings(&text).join("\n");
        assert!(told.starts_with("warning: "), "{to}: {told}");
        for words in words {
            assert!(told.contains(words), "{to}: no {words:?} in {told}");
        }
    }
    for key in ["balance_factor = 50", "counterweights = { rotating = 1, reciprocating = 50 }"] {
        let four = FOUR.split("[[counterweight]]").next().expect("what stands before");
        let told = warnings(&format!("{four}[crankshaft]\ncounterweight_radius = '45 mm'\n{key}\n")).join("\n");
        assert!(
            told.contains("is read as 50\n") && told.contains("at most 5: is it in per cent? 50 % is 0.5"),
            "{told}"
        );
        assert!(
            warnings(&format!("{four}[crankshaft]\ncounterweight_radius = '45 mm'\n{}\n", key.replace("50", "0.5")))
                .is_empty()
        );
    }
    let fast = FOUR.replace("'46 mm'", "'4 mm'").replace("3000", "95000").replace("'450 g'", "'1 g'");
    assert!(warnings(&fast).join("").contains("speed makes a piston's acceleration"), "{:?}", warnings(&fast));
}

#[test]
fn multiples_and_what_is_left_out_are_no_odd_quantities() {
    for text in [
        "[inline]\nthrows = [0, 180, 180, 0]\nspacing = 1\n",
        "[inline]\nthrows = [0, 180, 180, 0]\nspacing = 100\n",
        "[mechanism]\nrod_ratio = 0.3\n[u]\nthrows = [0, 180]\nsense = 'against'\nphase = 180\ndistance = 50\n",
        "speed = 0\n[mechanism]\ncrank_radius = 1\nrod_length = 4\nreciprocating_mass = 1\n[inline]\nthrows = [0]\n",
        "[[cylinder]]\nthrow = 0\nbank = 0\nposition = 0\nreciprocating_mass = 2\n[[cylinder]]\nthrow = 0\nbank = 0\nposition = 90\n",
        "[inline]\nthrows = [0, 'phi']\n[values]\nphi = 180\n",
    ] {
        assert_eq!(warnings(text), Vec::<String>::new(), "{text}");
    }
}

/// The value that such a warning names would be refused next.
#[test]
fn no_unit_is_meant_of_a_value_that_is_refused_in_every_unit() {
    for (from, to) in [
        ("3000", "-1"),
        ("3000", "[1]"),
        ("'46 mm'", "-46"),
        ("'140 mm'", "-140"),
        ("'0.4 kg'", "-400000"),
        ("'45 mm'", "-45"),
    ] {
        let text = FOUR.replace(from, to);
        assert!(parse_layout("layout.toml", &text).is_err(), "{to}");
        let told: Vec<_> = file::warnings_of_values("layout.toml", &text).iter().map(ToString::to_string).collect();
        assert_eq!(told, Vec::<String>::new(), "{to}");
    }
    let offset = FOUR.replace("[inline]", "pin_offset = '-5 m'\n[inline]");
    let told = file::warnings_of_values("layout.toml", &offset);
    assert!(told[0].to_string().contains("pin_offset is read as -5 m"), "{}", told[0]);
}

const SHAFTS: &str = "speed = 3000\n[mechanism]\nstroke = '80 mm'\nrod_length = '140 mm'\nreciprocating_mass = '0.5 kg'\n\
    [[crankshaft]]\nname = 'L'\nsense = 'with'\noffset = '60 mm'\n\
    [[crankshaft]]\nname = 'R'\nsense = 'against'\nspeed = 2\noffset = '-60 mm'\n\
    [[cylinder]]\ncrankshaft = 'L'\nthrow = 0\nbank = 10\nposition = 0\n\
    [[cylinder]]\ncrankshaft = 'R'\nthrow = 30\nbank = -10\nposition = 0\n";

#[test]
fn how_often_a_crankshaft_turns_is_no_odd_speed() {
    assert_eq!(warnings(SHAFTS), Vec::<String>::new());
    assert_eq!(warnings(&SHAFTS.replace("speed = 3000", "speed = 3")).len(), 1);
}

#[test]
fn marine_model_and_racing_engines_are_usual() {
    let single = |stroke: &str, rod: &str, mass: &str, speed: u32| {
        format!(
            "speed = {speed}\n[mechanism]\nstroke = '{stroke}'\nrod_length = '{rod}'\nreciprocating_mass = '{mass}'\n[inline]\nthrows = [0]\n"
        )
    };
    for text in [
        single("3.468 m", "3.5 m", "14 t", 80),
        single("5 mm", "10 mm", "0.5 g", 30_000),
        single("39.77 mm", "102 mm", "0.3 kg", 20_000),
        single("12 ft", "24 ft", "8 t", 12),
        single("26 in", "120 in", "700 lb", 336),
    ] {
        assert_eq!(warnings(&text), Vec::<String>::new(), "{text}");
    }
}

fn toml_files(folder: &Path) -> Vec<PathBuf> {
    let entries = std::fs::read_dir(folder).expect("a folder").map(|entry| entry.expect("an entry").path());
    let (folders, files): (Vec<_>, Vec<_>) = entries.partition(|path| path.is_dir());
    let nested = folders.iter().flat_map(|folder| toml_files(folder));
    files.into_iter().filter(|path| path.extension().is_some_and(|ending| ending == "toml")).chain(nested).collect()
}

#[test]
fn no_engine_of_this_repository_is_odd() {
    let root = Path::new(env!("CARGO_MANIFEST_DIR"));
    let mut read = 0;
    for path in ["src/kernel/file/catalogue", "reports", "formal/engines", "docs", "examples"]
        .iter()
        .flat_map(|folder| toml_files(&root.join(folder)))
    {
        let text = std::fs::read_to_string(&path).expect("a text");
        let beside = |name: &str| std::fs::read_to_string(path.with_file_name(name)).map_err(|error| error.to_string());
        // Files of claims and exercises are no layouts.
        let Ok(layout) = parse_layout_beside("layout.toml", &text, FileResolver::new(&beside)) else { continue };
        let odd: Vec<String> = file::warnings("layout.toml", &text, &layout).iter().map(ToString::to_string).collect();
        assert!(odd.is_empty(), "{}: {odd:?}", path.display());
        read += 1;
    }
    assert!(read > 60, "only {read} layouts were found");
}

#[test]
fn warnings_change_neither_the_answer_nor_the_exit_status() {
    let folder = scratch("odd-quantities");
    let [odd, usual] =
        [("odd.toml", "46", "'140 m'"), ("usual.toml", "'46000 mm'", "'140 m'")].map(|(name, radius, rod)| {
            std::fs::write(
                folder.join(name),
                format!("title = 'four'\n{}", FOUR.replace("'46 mm'", radius).replace("'140 mm'", rod)),
            )
            .expect("a file");
            folder.join(name).display().to_string()
        });
    for arguments in [&["loads"][..], &["classify"], &["loads", "--json"]] {
        let [one, other] = [&odd, &usual].map(|path| call(&[arguments, &[path.as_str()]].concat()));
        assert_eq!((one.status.code(), &one.stdout), (Some(0), &other.stdout));
        let told = String::from_utf8_lossy(&one.stderr).into_owned();
        assert!(told.contains("crank_radius is read as 46 m") && told.contains("odd.toml:4"), "{told}");
        let quiet = call(&[arguments, &[odd.as_str(), "--quiet"]].concat());
        assert_eq!((quiet.status.code(), &quiet.stdout, quiet.stderr.as_slice()), (Some(0), &one.stdout, &b""[..]));
    }
    let swept = call(&["sweep", &odd, "--speed", "1000..2000:500"]);
    assert_eq!(String::from_utf8_lossy(&swept.stderr).matches("crank_radius is read as").count(), 1);
}

#[test]
fn a_quiet_program_tells_why_there_is_no_answer() {
    for arguments in [["--quiet", "classify", "I44"], ["classify", "I44", "--quiet"]] {
        let told = call(&arguments);
        assert_eq!(told.status.code(), Some(1));
        assert!(String::from_utf8_lossy(&told.stderr).contains("I44"), "{told:?}");
    }
}

#[test]
fn all_unknown_keys_are_told_in_one_run() {
    let text = "titel = 'four'\nspeed = 3000\n[mechanism]\nstroke = '86 mm'\nrod_lenght = '143 mm'\n[inline]\nthrows = [0, 180]\nspaceing = 1\n\
        [[counterweight]]\nthrow = 1\nmas = '1 kg'\nradius = '45 mm'\n";
    let error = parse_layout("layout.toml", text).expect_err("unknown keys").to_string();
    for (key, line) in [("titel", 1), ("rod_lenght", 5), ("spaceing", 8), ("mas", 11)] {
        assert!(error.contains(&format!("unknown key `{key}`")), "{key}: {error}");
        assert!(error.contains(&format!("layout.toml:{line}:1")), "{key}: {error}");
    }
    // What is missing because of them is not told as well.
    assert!(!error.contains("is missing"), "{error}");
    let many: String = (0..100).map(|index| format!("key{index} = 1\n")).collect();
    let error = parse_layout("layout.toml", &many).expect_err("unknown keys").to_string();
    assert!(error.matches("unknown key").count() >= 10);
}

/// Calls the program with a text on its standard input.
fn fed(arguments: &[&str], text: &str) -> Output {
    let mut child = std::process::Command::new(env!("CARGO_BIN_EXE_crankstar"))
        .args(arguments)
        .stdin(Stdio::piped())
        .stdout(Stdio::piped())
        .stderr(Stdio::piped())
        .spawn()
        .expect("the program");
    // Where the layout is a file nobody reads it.
    let _ = child.stdin.take().expect("a pipe").write_all(text.as_bytes());
    child.wait_with_output().expect("its end")
}

#[test]
fn a_layout_is_read_from_standard_input() {
    let text = format!("title = 'four'\n{FOUR}");
    let file = scratch("standard-input").join("four.toml");
    std::fs::write(&file, &text).expect("a file");
    let file = file.to_str().expect("a path");
    for arguments in [&["classify"][..], &["report"], &["loads", "--json"], &["sweep", "--speed", "1000..2000:500"]] {
        let (first, rest) = arguments.split_first().expect("a command");
        let [piped, named] = ["-", file].map(|path| fed(&[&[*first, path][..], rest].concat(), &text));
        assert_eq!(piped.status.code(), Some(0), "{arguments:?}: {}", String::from_utf8_lossy(&piped.stderr));
        assert_eq!(piped.stdout, named.stdout, "{arguments:?}");
    }
    let wrong = fed(&["classify", "-"], "inline.throws = [0, x]\n");
    let told = String::from_utf8_lossy(&wrong.stderr).into_owned();
    assert!(wrong.status.code() == Some(1) && told.contains("standard input:1"), "{told}");
    let empty = fed(&["classify", "-"], "");
    assert_eq!(empty.status.code(), Some(1));
}

#[test]
fn radians_a_second_and_tonnes_are_units() {
    let of = |text: &str| match parse_layout("layout.toml", text) {
        Ok(Layout::Known(engine, _)) => engine.dimensions().clone(),
        other => panic!("{other:?}"),
    };
    let one = of(&FOUR.replace("3000", "'314.159265358979 rad/s'").replace("'450 g'", "'0.00045 t'"));
    let other = of(FOUR);
    assert_eq!((&one.speed, &one.mass), (&other.speed, &other.mass));
    // 100 rad/s are 954.929658551… rpm, to a millionth.
    let hundred = of(&FOUR.replace("3000", "'100 rad/s'")).speed.expect("a speed");
    assert_eq!(hundred.to_string(), "954929659/1000000");
    let error = parse_layout("layout.toml", &FOUR.replace("3000", "'fast rad/s'")).expect_err("no number").to_string();
    assert!(error.contains("cannot read the speed") && error.contains("314 rad/s"), "{error}");
}

#[test]
fn a_rod_that_is_given_twice_is_told_with_both_ways_of_writing_it() {
    let told = |keys: &str| {
        let text = format!("[mechanism]\nstroke = '86 mm'\nrod_length = '143 mm'\n{keys}[inline]\nthrows = [0]\n");
        parse_layout("layout.toml", &text).expect_err("a contradiction").to_string()
    };
    let rotating =
        told("piston_mass = '0.4 kg'\nrod_mass = '0.6 kg'\nrod_centre = '40 mm'\nrotating_mass = '0.4 kg'\n");
    for words in
        ["rotating_mass contradicts rod_mass", "layout.toml:7", "omit rotating_mass", "rod_centre", "or omit rod_mass"]
    {
        assert!(rotating.contains(words), "{words}: {rotating}");
    }
    let reciprocating = told("reciprocating_mass = '0.5 kg'\nrod_mass = '0.6 kg'\nrotating_mass = '0.4 kg'\n");
    for words in
        ["rod_mass contradicts reciprocating_mass", "layout.toml:5", "piston_mass in place of reciprocating_mass"]
    {
        assert!(reciprocating.contains(words), "{words}: {reciprocating}");
    }
}

#[test]
fn metres_that_were_meant_as_millimetres_are_told_of_every_length_along_the_shaft() {
    let vee = "[vee]\nthrows = [0, 180]\nbank_angle = 60\nspacing = '96 mm'\n";
    let block = "[block]\nmass = 100\ninertia = [1, 1, 1]\ncentre = [0, 0, 0]\n";
    let mount = |place| format!("[[mount]]\nstiffness = [1, 1, 1]\nplace = {place}\n");
    let mounted =
        block.to_owned() + &["[100, 0, 0]", "[0, 0.3, 0.2]", "[0.1, -0.3, 0.2]", "[0, 0.1, -0.3]"].map(mount).concat();
    let weighed = format!(
        "{vee}[mechanism]\nreciprocating_mass = 1\ncrank_radius = '40 mm'\nrod_length = '140 mm'\n[crankshaft]\nbalance_factor = 0.5\n\
         counterweight_radius = '40 mm'\n"
    );
    let balancer = "[[balancer]]\norder = 2\nsense = 'with'\nmass_radius = '0.005 kg m'\nangle = 180\n";
    let twin = "[u]\nthrows = [0, 170]\nsense = 'against'\n";
    let shaft = "[torsion]\ninertias = [1, 1, 1]\nstiffnesses = [100]\nrated_speed = '3000 rpm'\n\
        [[torsion.shaft]]\nbetween = [2, 3]\nlength = '0.3 m'\nouter_diameter = '50 mm'\nshear_modulus = '80 GPa'\n";
    for (text, words) in [
        (format!("{vee}bank_offset = '20 m'\n"), "bank_offset is read as 20 m"),
        (format!("reference_plane = '80 m'\n{vee}"), "the reference plane is at 80 m"),
        (format!("reference_plane = '5 m'\n{vee}"), "the reference plane is at 5 m"),
        (
            format!("reference_plane = '-5 m'\n{vee}"),
            "the cylinders stand from -0.048 m to 0.048 m: is the unit right?",
        ),
        (vee.replace("'96", "'-96"), "spacing is below 0"),
        (vee.replace("'96 mm'", "80") + "[mechanism]\nstroke = '80 mm'\n", "spacing is read as 80 m"),
        (format!("{vee}bank_offset = 12\n"), "such as \"12 mm\""),
        (format!("{vee}{}", mounted.replace("centre = [0", "centre = [100")), "centre is read as 100 m"),
        (format!("{weighed}{balancer}position = 0\nheight = 80\n"), "height is read as 80 m"),
        (format!("{weighed}{balancer}position = 90\n"), "position is read as 90 m"),
        (format!("{twin}distance = 0\n"), "distance is 0"),
        (format!("{twin}distance = -5\n"), "distance is below 0"),
        (format!("{vee}{mounted}"), "place is read as 100 m"),
        (format!("{weighed}web_offset = 20\n"), "web_offset is read as 20 m"),
        (format!("{vee}{}", shaft.replace("'0.3 m'", "300")), "length is read as 300 m"),
        (format!("{vee}{}", shaft.replace("'50 mm'", "50")), "outer_diameter is read as 50 m"),
        (format!("{vee}{shaft}").replace("'3000 rpm'", "'3 rpm'"), "rated_speed is read as 3 rpm"),
    ] {
        let told = warnings(&text).join("\n");
        assert!(told.contains(words), "{text}: {told}");
    }
    assert_eq!(warnings(&format!("{vee}bank_offset = '20 mm'\n")), Vec::<String>::new());
    assert_eq!(warnings(&format!("{vee}{shaft}")), Vec::<String>::new());
    // Without a unit these count crank radii and spacings.
    assert_eq!(warnings(&format!("{twin}distance = 25\n")), Vec::<String>::new());
    assert_eq!(warnings(&vee.replace("'96 mm'", "80")), Vec::<String>::new());
    assert_eq!(warnings(&format!("{weighed}{balancer}position = 0\nheight = '80 mm'\n")), Vec::<String>::new());
    assert_eq!(warnings(&format!("reference_plane = '-500 mm'\n{vee}")), Vec::<String>::new());
    assert_eq!(warnings(&format!("reference_plane = 50\n{}", vee.replace("'96 mm'", "1"))), Vec::<String>::new());
}

#[test]
fn an_odd_value_of_an_option_or_of_a_shaft_is_told_as_one_of_a_layout_is() {
    let folder = scratch("odd-options");
    let path = |name: &str, text: &str| {
        let path = folder.join(name);
        std::fs::write(&path, text).expect("a file");
        path.display().to_string()
    };
    let four = path("four.toml", FOUR);
    let shaft = path("shaft.toml", "[[mass]]\nmass = 1\nradius = 80\nangle = 0\n[[mass]]\nmass = 1\n");
    for (arguments, words) in [
        (&["sweep", &four, "--spacing", "80..100:10"][..], "the cylinders reach over 240 m"),
        (&["remedy", &four, "--balance-factor", "50"], "balance_factor is read as 50"),
        (&["remedy", &four, "--reciprocating", "50"], "reciprocating is read as 50"),
        (&["rotor", &shaft], "radius is read as 80 m"),
    ] {
        let told = String::from_utf8(call(arguments).stderr).expect("a text");
        assert!(told.contains(words), "{arguments:?}: {told}");
    }
    let told = call(&["sweep", &four, "--spacing", "80..100:10 mm"]);
    assert!(told.stderr.is_empty(), "{told:?}");
    let shafts = path("shafts.toml", SHAFTS);
    let told = call(&["sweep", &shafts, "--set", "crankshaft.2.speed=1..3:1"]);
    assert!(told.status.success() && told.stderr.is_empty(), "{told:?}");
}
