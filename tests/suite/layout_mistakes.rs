//! Does every mistake in a layout file end in a message that says what is wrong, and in which line?

use crankstar::file::parse;

/// The file is refused; the message has these words, and points at this line (0: at no line).
#[track_caller]
fn assert_refused(text: &str, line: usize, words: &str) {
    let shown: String = text.chars().take(300).collect();
    let error = match parse("layout.toml", text) {
        Ok(_) => panic!("accepted:\n{shown}"),
        Err(error) => error.to_string(),
    };
    assert!(error.contains(words), "no {words:?} for\n{shown}\n{error}");
    let place = error.split_once("layout.toml:").map_or("", |(_, place)| place);
    let pointed = place.split(':').next().and_then(|number| number.parse().ok()).unwrap_or(0);
    assert_eq!(pointed, line, "{shown}\n{error}");
}

/// Mistakes in keys and tables: the file, the line, words of the message.
#[rustfmt::skip]
const KEYS: &[(&str, usize, &str)] = &[
    ("",                                                          0, "describes no engine"),
    ("# nothing\n\n",                                             0, "describes no engine"),
    ("title = 'V6'",                                              0, "[inline], [vee]"),
    ("orders = [1]\ncycle = 'two-stroke'",                        0, "describes no engine"),
    ("inline.throws = [0]\n[radial]\ncylinders = 3",              2, "more than one engine"),
    ("[vee]\nbank_angle = 60\nthrows = [0]\n[flat]\nthrows = [0]", 4, "more than one engine"),
    ("colour = 'red'\ninline.throws = [0]",                       1, "unknown key `colour`"),
    ("Title = 'V6'\ninline.throws = [0]",                         1, "`title`"),
    ("[Inline]\nthrows = [0]",                                    1, "unknown key `Inline`"),
    ("[inline]\nthrow = [0]",                                     2, "`throws`"),
    ("[inline]\nthrows = [0]\nbank_angle = 60",                   3, "unknown key `bank_angle`"),
    ("[[cylinder]]\nthrow = 0\nbank = 0\nposition = 0\nmass = 1", 5, "`reciprocating_mass`"),
    ("[[cylinder]]",                                              1, "`bank` is missing"),
    ("[[cylinder]]\nbank = 0\nposition = 0",                      1, "`throw` is missing"),
    ("[[cylinder]]\nthrow = 0\nposition = 0",                     1, "`bank` is missing"),
    ("[[cylinder]]\nthrow = 0\nbank = 0",                         1, "`position` is missing"),
    ("[[cylinder]]\nthrow = 0\nbank = 0\nposition = 0\n\n[[cylinder]]\nbank = 0\nposition = 1", 6, "`throw` is missing"),
    ("[inline]\nspacing = 1",                                     1, "crank throws are missing"),
    ("firing_order = '1-2'\n[inline]",                            2, "with its cycle"),
    ("[vee]\nthrows = [0]",                                       1, "`bank_angle` is missing"),
    ("[vee]\nbank_angle = 60",                                    1, "crank throws are missing"),
    ("[flat]",                                                    1, "crank throws are missing"),
    ("[boxer]\nthrows = [0]",                                     1, "`stagger` is missing"),
    ("[fan]\nthrows = [0]",                                       1, "`banks` is missing"),
    ("[radial]",                                                  1, "`cylinders` is missing"),
    ("[radial]\ncylinders = 5\nrows = 2\nrow_throw = 180",        2, "`row_rotation` is missing"),
    ("[radial]\ncylinders = 5\nrows = 2\nrow_rotation = 36",      2, "`row_throw` is missing"),
    ("[radial]\ncylinders = 5\nrow_throw = 180",                  3, "`row_throw` is of several rows"),
    ("[radial]\nrow_rotation = 36\nrows = 1\ncylinders = 5",      2, "write rows = 2"),
    ("[radial]\ncylinders = 5\nrow_spacing = '0.1 m'",            3, "`row_spacing` is of several rows"),
    ("inline = 3",                                                1, "expected one table"),
    ("inline = [[0, 180]]",                                       1, "a list in brackets is in the wrong place"),
    ("[[vee]]\nbank_angle = 60\nthrows = [0]",                    1, "expected one table"),
    ("[cylinder]\nthrow = 0\nbank = 0\nposition = 0",             1, "[[two brackets]]"),
    ("cylinder = []",                                             1, "0 cylinders"),
    ("cylinder = [[0, 0, 0, 0]]",                                 1, "expected one table"),
    ("cylinder = [1, 2]",                                         1, "`1` is in the wrong place"),
    ("[inline]\nthrows = [0]\nthrows = [1]",                      3, "duplicate key"),
    ("inline.throws = [0]\n[inline]\nspacing = 1",                2, "duplicate key"),
    ("cycle = four-stroke\ninline.throws = [0]",                 1, "text stands in quotes"),
    ("cycle = two-stroke\ninline.throws = [0]",                  1, "text stands in quotes"),
    ("effects = [torque]\ninline.throws = [0]",                  1, "text stands in quotes"),
    ("firing_order = 1-3-4-2\ninline.throws = [0]",              1, "text stands in quotes"),
    ("title = 'V6\ninline.throws = [0]",                         1, "expected `'`"),
    ("title = \"V6\ninline.throws = [0]",                        1, "its closing quote"),
    ("orders = 1,2\ninline.throws = [0]",                        1, "such as [1, 2]"),
    ("speed = 6,000\ninline.throws = [0]",                       1, "decimals have a point"),
    ("cycle = 'four-stroke'\nfiring_order = '1342'\ninline.throws = [0, 180, 180, 0]", 2, "with hyphens between them"),
    ("throws = [0, 90]\n[vee]\nbank_angle = 90",                 1, "`throws` is a key of `inline`, `vee`"),
];

/// Mistakes in what turns; each file begins with an engine of two throws, its masses and its crank: four lines.
#[rustfmt::skip]
const CRANKSHAFT: &[(&str, usize, &str)] = &[
    ("[[counterweight]]\nthrow = 3\nmass = 1\nradius = 1",          6, "there is no throw `3`"),
    ("[[counterweight]]\nthrow = 3\nmass = 1\nradius = 1",          6, "throws 1 to 2"),
    ("[[counterweight]]\nthrow = 0\nmass = 1\nradius = 1",          6, "there is no throw `0`"),
    ("[[counterweight]]\nthrow = 1\nmass = -1\nradius = 1",         7, "a mass is 0 or more"),
    ("[[counterweight]]\nthrow = 1\nmass = 1\nradius = 0",          8, "a length above 0"),
    ("[[counterweight]]\nthrow = 1\nmass = 1\nradius = '-1 mm'",    8, "a length above 0"),
    ("[[counterweight]]\nthrow = 1\nmass = 1",                      5, "`radius` is missing"),
    ("[[counterweight]]\nthrow = 1\nradius = 1",                    5, "`mass` is missing"),
    ("[[counterweight]]\nangle = 0\nmass = 1\nradius = 1",          5, "without a position"),
    ("[[counterweight]]\nposition = 0\nmass = 1\nradius = 1",       5, "without a direction"),
    ("[[counterweight]]\nthrow = 1\nmass = 1\nradius = 1\nposition = '2b'", 9, "symbols have values"),
    ("[crankshaft]\nlength = '0.2 m'\n[[counterweight]]\nthrow = 1\nmass = 1\nradius = 1\nposition = '101 mm'", 11, "beyond the crankshaft"),
    ("[crankshaft]\nlength = '0.2 m'\n[[counterweight]]\nthrow = 1\nmass = 1\nradius = 1\nposition = '-101 mm'", 11, "from -100 mm to 100 mm"),
    ("[crankshaft]\nlength = 0",                                    6, "a length above 0"),
    ("[crankshaft]\nbalance_factor = 1\ncounterweight_radius = 1\nlength = '0.2 m'\nweb_offset = '60 mm'", 9, "beyond the crankshaft"),
    ("[crankshaft]\nbalance_factor = 1\ncounterweight_radius = 1\nlength = '5 mm'", 8, "beyond the crankshaft"),
    ("[crankshaft]\npin_mass = -1",                                 6, "a mass is 0 or more"),
    ("[crankshaft]\npin_mass = [1, 2, 3]",                          6, "3 values for 2 throws"),
    ("[crankshaft]\nweb_mass = 1",                                  6, "without its radius"),
    ("[crankshaft]\nweb_radius = 1",                                6, "without a mass"),
    ("[crankshaft]\nbalance_factor = 1",                            6, "add counterweight_radius"),
    ("[crankshaft]\ncounterweight_radius = 1",                      6, "add it"),
    ("[crankshaft]\nweb_offset = 1",                                6, "add it"),
    ("[crankshaft]\nbalance_factor = -0.5\ncounterweight_radius = 1", 6, "a balance factor is 0 or more"),
    ("[crankshaft]\nbalance_factor = 'half'\ncounterweight_radius = 1", 6, "cannot read the balance factor"),
    ("[crankshaft]\nbalance_factor = 1\ncounterweight_radius = 0",  7, "a length above 0"),
    ("[crankshaft]\nbalance_factor = 1\ncounterweight_radius = 1\n[[counterweight]]\nthrow = 1\nmass = 1\nradius = 1", 8, "both a balance factor and counterweights"),
    ("[crankshaft]\nmass = 1",                                      6, "unknown key `mass`"),
    ("[[balancer]]\norder = 0.5\nsense = 'with'\nmass_radius = 1\nangle = 0\nposition = 0",   6, "once in two revolutions"),
    ("[[balancer]]\norder = '1/2'\nsense = 'with'\nmass_radius = 1\nangle = 0\nposition = 0", 6, "no inertia force of the cranks has order 1/2"),
    ("[[balancer]]\norder = 1.5\nsense = 'with'\nmass_radius = 1\nangle = 0\nposition = 0",   6, "whole numbers"),
    ("[[balancer]]\norder = -2\nsense = 'with'\nmass_radius = 1\nangle = 0\nposition = 0",    6, "turns the other way"),
    ("[[balancer]]\norder = 0\nsense = 'with'\nmass_radius = 1\nangle = 0\nposition = 0",     6, "from 1 to 1000"),
    ("[[balancer]]\norder = 2\nsense = 'left'\nmass_radius = 1\nangle = 0\nposition = 0",     7, "\"with\" or \"against\""),
    ("[[balancer]]\norder = 2\nsense = 'with'\nangle = 0\nposition = 0",                      5, "without a weight"),
    ("[[balancer]]\norder = 2\nsense = 'with'\nmass_radius = 1\nangle = 0",                    5, "without a position"),
    ("[[balancer]]\norder = 2\nsense = 'with'\nmass_radius = 1\nangle = 0",                    5, "[[balancer]] needs position"),
    ("[[balancer]]\norder = 2\nsense = 'with'\nmass = 1\nangle = 0\nposition = 0",            8, "add radius"),
    ("[[balancer]]\norder = 2\nsense = 'with'\nradius = 1\nangle = 0\nposition = 0",          8, "add mass"),
    ("[[balancer]]\norder = 2\nsense = 'with'\nradius = 1\nmass = 1\nmass_radius = 1\nangle = 0\nposition = 0", 10, "given twice"),
    ("[[balancer]]\norder = 2\nsense = 'with'\nmass_radius = '-1 kg m'\nangle = 0\nposition = 0", 8, "0 or more"),
    ("[[balancer]]\norder = 2\nsense = 'with'\nmass_radius = '1 kg'\nangle = 0\nposition = 0", 8, "none of kg mm"),
];

#[test]
fn mistakes_in_what_turns_are_told_with_their_place() {
    let engine =
        "inline = { throws = [0, 180], spacing = '0.1 m' }\n[mechanism]\nreciprocating_mass = 1\ncrank_radius = 0.05\n";
    for (text, line, words) in CRANKSHAFT {
        assert_refused(&format!("{engine}{text}"), *line, words);
    }
    let turning = "[[counterweight]]\nthrow = 1\nmass = 1\nradius = 1\nposition = ";
    assert_refused(&format!("inline.throws = [0, 180]\n{turning}'3 cm'"), 6, "one spacing apart");
    let supported = format!("bearings = ['0.1 m', 0, '-0.1 m']\n{engine}{turning}");
    assert_refused(&format!("{supported}'0.11 m'"), 10, "the shaft reaches from -100 mm to 100 mm");
    assert!(parse("layout.toml", &format!("{supported}'0.1 m'")).is_ok());
    assert_refused(&format!("inline = {{ throws = [0, 'phi'] }}\n{turning}0"), 2, "angles or positions are open");
    assert_refused(
        "inline.throws = [0]\n[crankshaft]\nbalance_factor = 1\ncounterweight_radius = 1",
        3,
        "without masses",
    );
    assert_refused("[[cylinder]]\nthrow = 0\nbank = 0\nposition = 0\npin = 0", 5, "number of the pin");
}

/// Mistakes in values that fit together badly.
#[rustfmt::skip]
const VALUES: &[(&str, usize, &str)] = &[
    ("[inline]\nthrows = []",                                     2, "0 throws"),
    ("bearings = 3\n[inline]\nthrows = [0]",                      1, "expected a list in brackets"),
    ("bearings = []\n[inline]\nthrows = [0]",                     1, "0 main bearings"),
    ("bearings = [1]\n[inline]\nthrows = [0]",                    1, "1 main bearing"),
    ("bearings = [1, 0,\n 1.0]\n[inline]\nthrows = [0]",          2, "main bearings 1 and 3 are both at 1"),
    ("bearings = ['5 cm', '50 mm']\n[inline]\nthrows = [0]\nspacing = 1", 1, "main bearings 1 and 2 are both at 50 mm"),
    ("above = 101\n[inline]\nthrows = [0]",                      1, "threshold `101`"),
    ("above = -1\n[inline]\nthrows = [0]",                       1, "threshold `-1`"),
    ("above = '1 %'\n[inline]\nthrows = [0]",                    1, "threshold `1 %`"),
    ("bearings = [1, 'x']\n[inline]\nthrows = [0]",               1, "a bearing is at a known length"),
    ("bearings = [1, 'one']\n[inline]\nthrows = [0]",             1, "cannot read the length `one`"),
    ("bearings = [1, [0]]\n[inline]\nthrows = [0]",               1, "expected a number or a text"),
    ("bearings = [1, '0 mm']\n[inline]\nthrows = [0, 180]",       1, "are in multiples of their spacing"),
    ("bearings = [0.1, 0.2]\n[inline]\nthrows = [0]\n[crankshaft]\nlength = '0.3 m'", 1, "main bearing 2 at 200 mm is beyond the crankshaft"),
    ("bearings = [1, 0]\n[vee]\nbank_angle = 'phi'\nthrows = [0]", 1, "while an angle or position is open"),
    ("[inline]\nthrows = 180",                                    2, "expected a list in brackets"),
    ("[inline]\nthrows = [0, [180]]",                             2, "expected a number or a text"),
    ("[inline]\nthrows = [0, 180]\nspacing = 1\npositions = [1, 0]", 4, "both a spacing and positions"),
    ("[inline]\nthrows = [0, 180]\npositions = [1, 2, 3]",        3, "3 positions for 2 throws"),
    ("[inline]\nthrows = [0, 180]\npositions = []",               3, "0 positions for 2 throws"),
    ("[vee]\nbank_angle = -360\nthrows = [0]",                    2, "below 360 degrees"),
    ("[vee]\nbank_angle = 360\nthrows = [0]",                     2, "below 360 degrees"),
    ("[vee]\nbank_angle = [60]\nthrows = [0]",                    2, "expected a number or a text"),
    ("[vee]\nbank_angle = 60\nthrows = [0]\nnumbering = 'odd'",   4, "\"by-bank\" or \"by-pin\""),
    ("[fan]\nbanks = []\nthrows = [0]",                           2, "without banks"),
    ("[fan]\nbanks = [0, 60]\nthrows = [0]\npin_splits = [1]",    4, "1 value for 2 banks"),
    ("[fan]\nbanks = [0]\nthrows = [0]\nbank_offsets = [1, 2]",   4, "2 values for 1 bank\n"),
    ("[radial]\ncylinders = 0",                                   2, "from 1 to 2000"),
    ("[radial]\ncylinders = -9",                                  2, "from 1 to 2000"),
    ("[radial]\ncylinders = 4.5",                                 2, "a whole number"),
    ("[radial]\ncylinders = 1_000_000_000",                       2, "from 1 to 2000"),
    ("[radial]\ncylinders = 9\nrows = 0",                         3, "number of rows"),
    ("[radial]\ncylinders = 1000\nrows = 3\nrow_rotation = 0\nrow_throw = 0", 2, "`3000`"),
    ("orders = []\ninline.throws = [0]",                          1, "list of orders is empty"),
    ("orders = [0]\ninline.throws = [0]",                         1, "from 1 to 1000"),
    ("orders = [1001]\ninline.throws = [0]",                      1, "`1001`"),
    ("orders = [1.5]\ninline.throws = [0]",                       1, "`1.5`"),
    ("orders = [-1]\ninline.throws = [0]",                        1, "`-1`"),
    ("orders = ['two']\ninline.throws = [0]",                     1, "`two`"),
    ("orders = 2\ninline.throws = [0]",                           1, "expected a list in brackets"),
    ("title = true\ninline.throws = [0]",                         1, "`true` is in the wrong place"),
    ("source = ['a', 'b']\ninline.throws = [0]",                  1, "expected a number or a text"),
    ("speed = '100 s^-1'\ninline.throws = [0]",                   1, "`s^-1` is none of rpm"),
    ("speed = '100 1/s'\ninline.throws = [0]",                    1, "`1/s` is none of rpm"),
    ("speed = '100 1'\ninline.throws = [0]",                      1, "for instance"),
    ("values = 5\ninline.throws = [0]",                           1, "expected a table"),
    ("{ \"document\": \"crankstar\" }",                            1, "this file is JSON"),
    ("reference_plane = '9 deg'\ninline.throws = [0]",            1, "`deg` is none of mm"),
];

/// Names of cylinders, each in a file of three whose last has this name.
const NAMES: &[(&str, usize, &str)] = &[
    ("'1'", 9, "cylinders 1 and 3 have the same name `1`"),
    ("''", 13, "one to six letters (A to Z, a to z) or digits"),
    ("'toolong'", 13, "`toolong`"),
    ("'L 2'", 13, "one to six letters (A to Z, a to z) or digits"),
    ("'é'", 13, "one to six letters (A to Z, a to z) or digits"),
    ("'1-2'", 13, "one to six letters (A to Z, a to z) or digits"),
    ("[1]", 13, "expected a number or a text"),
];

/// Mistakes about firing, above an in-line four of throws 0, 180, 180, 0.
#[rustfmt::skip]
const FIRING: &[(&str, usize, &str)] = &[
    ("cycle = 'six-stroke'",                                              1, "\"four-stroke\" or \"two-stroke\""),
    ("cycle = 4",                                                         1, "`4`"),
    ("firing_order = '1-3-4-2'",                                          1, "cycle, which is missing"),
    ("firing_angles = [0, 540, 180, 360]",                                1, "cycle, which is missing"),
    ("cycle = 'four-stroke'\nfiring_order = '1-3-4'",                     2, "cylinder 2 is missing"),
    ("cycle = 'four-stroke'\nfiring_order = '1-3-4-4'",                   2, "cylinder 4 fires twice"),
    ("cycle = 'four-stroke'\nfiring_order = '1-3-4-5'",                   2, "`5`, which is not a cylinder"),
    ("cycle = 'four-stroke'\nfiring_order = '1-3-4-2-1'",                 2, "cylinder 1 fires twice"),
    ("cycle = 'four-stroke'\nfiring_order = ''",                          2, "firing order is empty"),
    ("cycle = 'four-stroke'\nfiring_order = []",                          2, "firing order is empty"),
    ("cycle = 'four-stroke'\nfiring_order = true",                        2, "expected a firing order"),
    ("cycle = 'four-stroke'\nfiring_order = [1, [3]]",                    2, "expected a number or a text"),
    ("cycle = 'four-stroke'\nfiring_order = '1-2-3-4'",                   2, "need 1080° to fire in the order 1-2-3-4"),
    ("cycle = 'two-stroke'\nfiring_order = '1-3-4-2'",                    2, "the cycle has 360°"),
    ("cycle = 'four-stroke'\nfiring_angles = [0, 180, 540]",              2, "3 firing angles for 4 cylinders"),
    ("cycle = 'four-stroke'\nfiring_angles = [0]",                        2, "1 firing angle for 4 cylinders"),
    ("cycle = 'four-stroke'\nfiring_angles = []",                         2, "0 firing angles for 4 cylinders"),
    ("cycle = 'four-stroke'\nfiring_angles = [0, 90, 180, 360]",          2, "cylinder 2 cannot fire 90° after the first"),
    ("cycle = 'four-stroke'\nfiring_angles = [0, 'x', 180, 360]",         2, "cannot read the angle `x`"),
    ("cycle = 'four-stroke'\nfiring_angles = [0, 540, 180, 360]\nfiring_order = '1-3-4-2'", 2, "one of them is enough"),
];

/// What is no TOML at all.
#[rustfmt::skip]
const NO_TOML: &[(&str, usize, &str)] = &[
    ("[inline]\nthrows = [0, 180",     2, "unclosed array"),
    ("[inline",                        1, "unclosed table"),
    ("[]",                             1, "keys cannot be empty"),
    ("title",                          1, "key with no value"),
    ("= 3",                            1, "keys cannot be empty"),
    ("title = 'no end",                1, "invalid literal string"),
    ("inline.throws = [0] and more",   1, "a value ends before this"),
    ("inline.throws = [.5]",           1, "expected digits"),
    ("inline.throws = [01]",           1, "leading zero"),
    ("title = 'a\0b'",                 1, "invalid literal string"),
    ("\u{1}\u{2}\u{3}",                1, "key with no value"),
    ("\u{7f}ELF\u{2}\u{1}\n",          1, "error"),
    ("%PDF-1.7\n%âãÏÓ",                1, "error"),
    ("{\"inline\": [0, 180]}",         1, "error"),
    ("<layout/>",                      1, "error"),
];

#[test]
fn mistakes_in_keys_values_and_syntax_are_named_with_their_line() {
    for &(text, line, words) in KEYS.iter().chain(VALUES).chain(NO_TOML) {
        assert_refused(text, line, words);
    }
}

#[test]
fn mistakes_in_names_are_named_with_their_line() {
    let cylinder = "[[cylinder]]\nthrow = 0\nbank = 0\nposition = 0\n";
    for &(name, line, words) in NAMES {
        assert_refused(&format!("{}name = {name}", cylinder.repeat(3)), line, words);
    }
}

#[test]
fn mistakes_about_firing_are_named_with_their_line() {
    for &(above, line, words) in FIRING {
        assert_refused(&format!("{above}\ninline.throws = [0, 180, 180, 0]"), line, words);
    }
}

/// Values that are no quantity of any kind, and words of the message.
const NO_QUANTITY: &[(&str, &str)] = &[
    ("nan", "`nan`"),
    ("-inf", "`-inf`"),
    ("'NaN'", "not a number"),
    ("1e400", "out of range"),
    ("'1e-400'", "out of range"),
    ("1e99999999999", "out of range"),
    ("''", "not a number"),
    ("'ten'", "not a number"),
    ("'1/0'", "a fraction over 0"),
    ("'1/0.0'", "a fraction over 0"),
    ("'1/2/3'", "not a number"),
    ("'1 2'", "not a number"),
    ("'--1'", "not a number"),
    ("'1.2.3'", "not a number"),
    ("'3 furlongs'", "`furlongs` is none of"),
    ("0x10", "not a number"),
    ("1979-05-27", "not a number"),
    ("true", "`true` is in the wrong place"),
    ("{ a = 1 }", "a table is in the wrong place"),
    ("[[]]", "expected a number or a text"),
];

/// Files whose line 2 or later misses a quantity at `@`, and a unit that is wrong there.
const HOLES: &[(&str, usize, &str)] = &[
    ("[[cylinder]]\nthrow = @\nbank = 0\nposition = 0", 2, "mm"),
    ("[[cylinder]]\nthrow = 0\nbank = @\nposition = 0", 3, "kg"),
    ("[[cylinder]]\nthrow = 0\nbank = 0\nposition = @", 4, "deg"),
    ("title = 'V6'\nbearings = [1, @]\ninline.throws = [0]", 2, "kg"),
    ("[[cylinder]]\nthrow = 0\nbank = 0\nposition = 0\nreciprocating_mass = @", 5, "mm"),
    ("reference_plane = @\ninline.throws = [0]", 1, "turn"),
    ("[inline]\nthrows = [0, @]", 2, "m"),
    ("[inline]\nthrows = [0, 180]\nspacing = @", 3, "lb"),
    ("[inline]\nthrows = [0, 180]\npositions = [1, @]", 3, "°"),
    ("[vee]\nbank_angle = @\nthrows = [0]", 2, "in"),
    ("[vee]\nbank_angle = 60\nthrows = [0]\npin_split = @", 4, "cm"),
    ("[vee]\nbank_angle = 60\nthrows = [0]\nbank_offset = @", 4, "deg"),
    ("[boxer]\nthrows = [0]\nstagger = @", 3, "g"),
    ("[fan]\nbanks = [0, @]\nthrows = [0]", 2, "m"),
    ("[radial]\ncylinders = 5\nrows = 2\nrow_throw = 0\nrow_rotation = @", 5, "m"),
    ("[radial]\ncylinders = 5\nrows = 2\nrow_throw = 0\nrow_rotation = 0\nrow_spacing = @", 6, "deg"),
];

#[test]
fn what_is_no_quantity_is_named_wherever_it_stands() {
    let digits = format!("1{}", "0".repeat(400));
    for &(file, line, unit) in HOLES {
        for &(value, words) in NO_QUANTITY {
            assert_refused(&file.replace('@', value), line, words);
        }
        assert_refused(&file.replace('@', &digits), line, "out of range");
        assert_refused(&file.replace('@', &format!("'{digits}'")), line, "out of range");
        assert_refused(&file.replace('@', &format!("'3 {unit}'")), line, &format!("`{unit}` is none of"));
    }
}

#[test]
fn negative_masses_are_refused() {
    assert_refused("[[cylinder]]\nthrow = 0\nbank = 0\nposition = 0\nreciprocating_mass = '-1 g'", 5, "0 or more");
}

#[test]
fn what_is_too_large_is_refused_by_name() {
    let list = |count: usize| vec!["0"; count].join(", ");
    assert_refused(&format!("[inline]\nthrows = [{}]", list(2001)), 2, "2001 throws");
    assert_refused(&format!("[vee]\nbank_angle = 1\nthrows = [{}]", list(1001)), 0, "2002 cylinders");
    let cylinders = "[[cylinder]]\nthrow = 0\nbank = 0\nposition = 0\n".repeat(2001);
    assert_refused(&cylinders, 1, "2001 cylinders");
    let order = (1..=100_000).map(|number| number.to_string()).collect::<Vec<_>>().join("-");
    let text = format!("cycle = 'four-stroke'\nfiring_order = '{order}'\n[inline]");
    assert_refused(&text, 2, "100000 cylinders");
}

#[test]
fn deep_nesting_is_refused() {
    for depth in [100, 1000, 100_000] {
        let lists = format!("inline.throws = {}0{}", "[".repeat(depth), "]".repeat(depth));
        assert_refused(&lists, 1, "nest too deeply");
        let tables = format!("inline = {}1{}", "{ a = ".repeat(depth), " }".repeat(depth));
        assert_refused(&tables, 1, "nest too deeply");
        assert_refused(&format!("{} = 1", vec!["a"; depth].join(".")), 0, "nest too deeply");
    }
}

#[test]
fn a_good_file_cut_anywhere_is_read_or_refused() {
    let whole =
        "title = \"V6 − 60°\"\ncycle = \"four-stroke\"\n[vee]\nbank_angle = \"1/6 turn\"\nthrows = [0, 120, 240]";
    for (end, _) in whole.char_indices() {
        if let Err(error) = parse("layout.toml", &whole[..end]) {
            assert!(error.to_string().starts_with("error: "), "{error}");
        }
    }
}
