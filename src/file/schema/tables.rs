//! Which keys has a layout file? Each table with its keys, what stands behind them, and a sentence about each.
//!
//! The readers of the tables are the structures beside it; `tests/suite/schemas.rs` asks them for their keys and holds this list to them.

use super::kind::Kind::{self, *};

/// A table of the file.
pub(super) struct Keys {
    /// Its name in the file: what stands in its brackets. The top of the file has none.
    pub name: &'static str,
    /// One sentence.
    pub about: &'static str,
    /// Its keys.
    pub keys: &'static [Key],
}

/// A key of a table.
pub(super) struct Key {
    pub name: &'static str,
    pub is_needed: bool,
    pub kind: Kind,
    pub about: &'static str,
}

const fn key(name: &'static str, kind: Kind, about: &'static str) -> Key {
    Key { name, is_needed: false, kind, about }
}

const fn needed(name: &'static str, kind: Kind, about: &'static str) -> Key {
    Key { name, is_needed: true, kind, about }
}

const THROWS: Key =
    key("throws", Each(&Angle), "Crankpins from the free end, in degrees; left out, they follow from the firing.");
const SPACING: Key = key("spacing", Length, "Distance between neighbouring crankpins; 1 if left out.");
const POSITIONS: Key =
    key("positions", Each(&Length), "Position of each crankpin along the crankshaft, in place of spacing.");
const BY_BANK: Key = key(
    "numbering",
    OneOfOrEach(&["per bank", "alternating", "by-bank", "by-pin"], &Text),
    "How the cylinders are numbered: \"per bank\", \"alternating\", or a name for each, bank after bank from the free end.",
);
const ALONG: Key = key(
    "numbering",
    OneOfOrEach(&["along the shaft", "per bank", "alternating"], &Text),
    "How the cylinders are numbered: along the shaft, \"per bank\", \"alternating\", or a name for each along the shaft.",
);
const NAMES: Key = key("numbering", Each(&Text), "A name for each cylinder.");
const SENSES: Kind = OneOf(&["with", "against"]);
const SENSE: Key = needed("sense", SENSES, "Whether the second crankshaft turns \"with\" the first or \"against\" it.");

/// The forms of engine: a file has one of them.
pub(in crate::file) const FORMS: [&str; 14] = [
    "cylinder",
    "inline",
    "vee",
    "flat",
    "boxer",
    "fan",
    "vr",
    "w",
    "radial",
    "opposed_piston",
    "u",
    "square_four",
    "h",
    "delta",
];

/// Every table; the first is the top of the file.
pub(super) const TABLES: &[Keys] = &[
    Keys {
        name: "",
        about: "An engine, as far as its balance goes: general keys, and one form (cylinder, inline, vee, flat, boxer, fan, vr, w, \
                radial, opposed_piston, u, square_four, h or delta).",
        keys: &[
            key("title", Text, "Title of the report."),
            key("source", Text, "Where the crank star is published."),
            key(
                "orders",
                Each(&Integer(1, 1000)),
                "Orders to judge, 1 to 1000; left out, 1, 2, 4, 6 and others that matter.",
            ),
            key(
                "reference_plane",
                Length,
                "Position that moments are taken about; the middle of the cylinders if left out.",
            ),
            key(
                "rotation",
                OneOf(&["anticlockwise", "clockwise"]),
                "Which way the crank turns in the drawing; anticlockwise if left out.",
            ),
            key(
                "seen_from",
                OneOf(&["free end", "flywheel"]),
                "The end of the crankshaft towards the reader; the free end if left out.",
            ),
            key("cycle", OneOf(&["four-stroke", "two-stroke"]), "Two or four strokes; a compressor works in two."),
            key("firing_order", TextOrEach(&Text), "\"1-3-4-2\", or a list."),
            key("firing_angles", Each(&Angle), "Crank angle of each firing, one per cylinder."),
            key("speed", Speed, "Revolutions a minute; \"6000 rpm\", \"100 Hz\", \"314 rad/s\"."),
            key("bearings", Each(&Length), "Positions of the main bearings along the crankshaft, two or more."),
            key(
                "effects",
                Each(&OneOf(&["torque", "remedy", "gas", "firing", "torsion"])),
                "What is asked for beside forces and moments.",
            ),
            key("document", Table("document"), "Title block of the report."),
            key(
                "mechanism",
                Table("mechanism"),
                "Crank, rods and masses: with them, and a speed, answers are in newtons.",
            ),
            key("articulated", Table("articulated"), "Rods that work on a master rod."),
            key(
                "crankshaft",
                TableOrTables("crankshaft.geared", "crankshaft"),
                "Masses on the crankshaft; or [[crankshaft]], one for each of several that are geared together.",
            ),
            key("counterweight", Tables("counterweight"), "A counterweight, one table each."),
            key("balancer", Tables("balancer"), "A balancer shaft, one table each."),
            key("gas", Table("gas"), "The pressure in the cylinders."),
            key("flywheel", Table("flywheel"), "Its moment of inertia, or how evenly the engine is to turn, or both."),
            key("torsion", Table("torsion"), "The crankshaft as discs and springs."),
            key(
                "values",
                Values,
                "Values of the unknowns of the file: angles phi and delta, lengths of one small letter.",
            ),
            key("cylinder", Tables("cylinder"), "One table for each cylinder, in place of a form."),
            key("inline", Table("inline"), "An engine in line."),
            key("vee", Table("vee"), "A V engine: bank 1 at −φ/2, bank 2 at +φ/2."),
            key("flat", Table("flat"), "A V of 180° on shared crankpins."),
            key("boxer", Table("boxer"), "Opposed crankpins 180° apart."),
            key("fan", Table("fan"), "Any number of banks on shared crankpins: W, X and others."),
            key("vr", Table("vr"), "A VR engine: two narrow banks, a throw for each cylinder."),
            key("w", Table("w"), "A W engine: two narrow Vs on one crankshaft."),
            key("radial", Table("radial"), "Rows of cylinders evenly round the crankshaft."),
            key("opposed_piston", Table("opposed_piston"), "Two pistons in each cylinder, on two crankshafts."),
            key("u", Table("u"), "Two rows side by side, each with its crankshaft."),
            key("square_four", Table("square_four"), "Two rows of two side by side."),
            key("h", Table("h"), "Two flat engines, one above the other."),
            key("delta", Table("delta"), "Opposed pistons in a triangle, on three crankshafts."),
        ],
    },
    Keys {
        name: "document",
        about: "Title block of a calculation report; every key may be left out.",
        keys: &[
            key("number", Text, "Number of the document."),
            key("revision", Text, "Its revision."),
            key("project", Text, "What it belongs to."),
            key("author", Text, "Who calculated."),
            key("checked", Text, "Who checked it."),
            key("date", Text, "When."),
            key("objective", Text, "What it is for."),
            key("assumptions", Each(&Text), "What is assumed, one sentence each, in plain text."),
        ],
    },
    Keys {
        name: "mechanism",
        about: "Crank, rods and masses: one value for all cylinders, or a list with one for each.",
        keys: &[
            key("source", Text, "Where the numbers are from."),
            key("stroke", Column(&Length), "Twice the crank radius."),
            key("crank_radius", Column(&Length), "In place of the stroke."),
            key("rod_length", Column(&Length), "Between the centres of its eyes."),
            key("rod_ratio", Column(&Number), "Crank radius over rod length, in place of rod_length."),
            key("scotch_yoke", Truth, "true for a Scotch yoke, which has no rod."),
            key(
                "pin_offset",
                Column(&Length),
                "How far the cylinder axis passes the crankshaft, on the side to which the pin goes after dead centre; 0 if left out.",
            ),
            key("offset_ratio", Column(&Number), "The offset over the rod length, in place of pin_offset."),
            key("reciprocating_mass", Column(&Mass), "All that goes to and fro, per cylinder."),
            key("piston_mass", Column(&Mass), "In place of reciprocating_mass, with pin_mass and a share of the rod."),
            key("pin_mass", Column(&Mass), "The piston pin."),
            key("piston_rod_mass", Column(&Mass), "With a crosshead: the piston rod."),
            key("crosshead_mass", Column(&Mass), "With a crosshead: the crosshead."),
            key("rod_mass", Column(&Mass), "The connecting rod, which is shared out by rod_centre."),
            key("rod_centre", Column(&Length), "From the big end to the rod's centre of gravity."),
            key("rotating_mass", Column(&Mass), "At the crankpin, per cylinder."),
        ],
    },
    Keys {
        name: "articulated",
        about: "Rods that work on a master rod, beside any form whose cylinders share crankpins.",
        keys: &[
            needed(
                "master",
                Column(&Text),
                "The cylinder whose rod is on the crankpin; a list, one for each crankpin.",
            ),
            key("knuckle_radius", Column(&Length), "From crankpin to knuckle pin."),
            key("knuckle_ratio", Column(&Number), "The same over the length of the master rod."),
            key("link_length", Column(&Length), "Length of the link."),
            key("link_ratio", Column(&Number), "Crank radius over link length."),
            key(
                "knuckle_angle",
                Column(&Angle),
                "Where the knuckle pins stand, from the master rod on, in the sense of rotation.",
            ),
            key(
                "knuckle_correction",
                Column(&Angle),
                "How far each knuckle pin is ahead of its cylinder, in place of knuckle_angle.",
            ),
            key("knuckle_mass", Column(&Mass), "At the knuckle pin; 0 if left out."),
        ],
    },
    Keys {
        name: "crankshaft",
        about: "Masses on the crankshaft: one value for all throws, or a list with one for each.",
        keys: &[
            key("length", Length, "With its middle in that of the cylinders; from bearing to bearing if left out."),
            key("pin_mass", Column(&Mass), "At the crank radius."),
            key("web_mass", Column(&Mass), "Both webs of a throw."),
            key("web_radius", Column(&Length), "Of their centre of gravity, towards the pin."),
            key(
                "balance_factor",
                Column(&Number),
                "Makes the counterweights: this share of all that rotates and half of what goes to and fro.",
            ),
            key(
                "counterweights",
                Table("crankshaft.counterweights"),
                "Makes the counterweights opposite to each throw, by shares.",
            ),
            key("counterweight_radius", Column(&Length), "Of the centres of gravity of those."),
            key(
                "web_offset",
                Column(&Length),
                "Two counterweights per throw, so far on both sides of it; left out, one in its plane.",
            ),
        ],
    },
    Keys {
        name: "crankshaft.counterweights",
        about: "Shares of the masses of a throw that its counterweights balance.",
        keys: &[
            key("rotating", Column(&Number), "Share of the rotating masses."),
            key("reciprocating", Column(&Number), "Share of the reciprocating masses."),
            key(
                "rotating_and_half_reciprocating",
                Column(&Number),
                "Share of all that rotates and half of what goes to and fro.",
            ),
        ],
    },
    Keys {
        name: "crankshaft.geared",
        about: "One of several crankshafts that are geared together; the first is the reference.",
        keys: &[
            needed("name", Text, "One to twelve letters or digits."),
            needed("sense", SENSES, "\"with\" the first crankshaft, or \"against\" it; of the first \"with\"."),
            key("speed", Integer(1, 1000), "How many times it turns while the first turns once; 1 if left out."),
            key("height", Length, "Of its axis over the middle."),
            key("offset", Length, "Of its axis to the left of the drawing."),
            key("distance", Length, "Of its axis from the middle, with angle, in place of height and offset."),
            key("angle", Angle, "The direction of its axis, with distance."),
            key("phase", Angle, "Added to the throws of its cylinders, as drawn."),
        ],
    },
    Keys {
        name: "counterweight",
        about: "A counterweight: mass and radius, or mass_radius.",
        keys: &[
            key(
                "throw",
                Integer(1, 1000),
                "The throw from which the angle counts; left out, it counts from the reference direction.",
            ),
            key("angle", Angle, "Opposite to its throw if left out."),
            key("mass", Mass, "With radius."),
            key("radius", Length, "Of its centre of gravity."),
            key(
                "mass_radius",
                MassRadius,
                "\"18.6 kg mm\", or \"1/4 m r\" in multiples of the reciprocating mass and crank radius.",
            ),
            key("position", Length, "Along the crankshaft; that of its throw if left out."),
        ],
    },
    Keys {
        name: "balancer",
        about: "A balancer shaft: mass and radius of its weight, or mass_radius.",
        keys: &[
            needed("order", Integer(1, 1000), "How many times it turns while the crank turns once."),
            needed("sense", SENSES, "\"with\" the crank, or \"against\" it."),
            key("mass", Mass, "With radius."),
            key("radius", Length, "Of its centre of gravity."),
            key(
                "mass_radius",
                MassRadius,
                "\"0.012 kg m\", or \"1/4 m r\" in multiples of the reciprocating mass and crank radius.",
            ),
            key(
                "coefficient_of",
                Text,
                "The mass-radius is multiplied by the coefficient c_k of this cylinder's piston; by 1 if left out.",
            ),
            needed("angle", Angle, "Of its weight at crank angle 0."),
            key("position", Length, "Of its weight along the crankshaft; needed."),
            key("height", Length, "Of its axis over the middle."),
            key("offset", Length, "Of its axis to the left of the drawing."),
        ],
    },
    Keys {
        name: "gas",
        about: "The pressure in all cylinders: a process, a table beside the file, or rows. [[gas.cylinder]] has what differs in some.",
        keys: GAS,
    },
    Keys { name: "gas.cylinder", about: "What differs in some cylinders.", keys: GAS },
    Keys {
        name: "flywheel",
        about: "The flywheel.",
        keys: &[
            key("inertia", Inertia, "Moment of inertia of all that turns with the crank."),
            key(
                "irregularity",
                Number,
                "How evenly the engine is to turn: largest speed less smallest, over the mean, such as \"1/50\".",
            ),
        ],
    },
    Keys {
        name: "torsion",
        about: "A crankshaft that twists: discs from the free end on, and a spring between each two.",
        keys: &[
            needed("inertias", Each(&Inertia), "Moment of inertia of each disc."),
            needed("stiffnesses", Each(&Stiffness), "Between each disc and the next."),
            key("crankpins_at", Each(&Integer(1, 10_000)), "The disc of each crankpin; 1, 2, … if left out."),
        ],
    },
    Keys {
        name: "cylinder",
        about: "A cylinder.",
        keys: &[
            key("name", Text, "Its number if left out."),
            key("throw", Angle, "Crank-throw angle; left out in all, they follow from the firing."),
            needed("bank", Angle, "Angle of the cylinder axis."),
            needed("position", Length, "Along the crankshaft, towards the free end."),
            key("reciprocating_mass", Mass, "1 if left out."),
            key(
                "pin",
                Integer(0, 1_000_000),
                "Cylinders with the same number share a crankpin; left out, those at the same position do.",
            ),
            key("crankshaft", Text, "The name of its crankshaft, of several."),
        ],
    },
    Keys { name: "inline", about: "An engine in line.", keys: &[THROWS, SPACING, POSITIONS, NAMES] },
    Keys {
        name: "vee",
        about: "A V engine: bank 1 at −φ/2, bank 2 at +φ/2.",
        keys: &[
            needed("bank_angle", Angle, "φ, between the banks; below 0 where bank 1 is the other bank."),
            THROWS,
            key(
                "pin_split",
                Angle,
                "From the pin of bank 1 to that of bank 2, above 0 anticlockwise as drawn; 0 if left out beside throws.",
            ),
            key("bank_offset", Length, "Bank 1 towards the free end of bank 2; 0 if left out."),
            key(
                "pin_offset",
                Each(&Length),
                "How far the axes of each bank pass the crankshaft, one value a bank; 0 if left out.",
            ),
            SPACING,
            POSITIONS,
            BY_BANK,
        ],
    },
    Keys {
        name: "flat",
        about: "A V of 180° on shared crankpins.",
        keys: &[
            THROWS,
            key("bank_offset", Length, "Bank 1 towards the free end of bank 2; 0 if left out."),
            SPACING,
            POSITIONS,
            BY_BANK,
        ],
    },
    Keys {
        name: "boxer",
        about: "Opposed crankpins 180° apart.",
        keys: &[THROWS, needed("stagger", Length, "Between the two cylinders of a pair."), SPACING, POSITIONS, BY_BANK],
    },
    Keys {
        name: "fan",
        about: "Any number of banks on shared crankpins.",
        keys: &[
            needed("banks", Each(&Angle), "Angles of the cylinder axes."),
            THROWS,
            key(
                "pin_splits",
                Each(&Angle),
                "One per bank: how far its pin stands anticlockwise, as drawn, from the throw; 0 if left out.",
            ),
            key("bank_offsets", Each(&Length), "One per bank; 0 if left out."),
            key("pin_offsets", Each(&Length), "One per bank: how far its axes pass the crankshaft; 0 if left out."),
            SPACING,
            POSITIONS,
            BY_BANK,
        ],
    },
    Keys {
        name: "vr",
        about: "Two narrow banks, a throw for each cylinder.",
        keys: &[
            needed("bank_angle", Angle, "φ: bank 1 at −φ/2, bank 2 at +φ/2."),
            THROWS,
            key("pin_splay", Angle, "Angle between the pins of both banks; 0 if left out beside throws."),
            key("pin_offset", Length, "How far both axes pass the crankshaft on their outer side; 0 if left out."),
            SPACING,
            POSITIONS,
            ALONG,
        ],
    },
    Keys {
        name: "w",
        about: "Two narrow Vs on one crankshaft.",
        keys: &[
            needed("bank_angle", Angle, "Between the two narrow Vs."),
            needed("narrow_angle", Angle, "In each of them."),
            THROWS,
            key(
                "pin_split",
                Angle,
                "From the pins of the first V to those of the second, above 0 anticlockwise as drawn.",
            ),
            key("pin_splay", Angle, "Within each narrow V, as of a VR."),
            key(
                "pin_offset",
                Length,
                "How far both axes of a narrow V pass the crankshaft on their outer side; 0 if left out.",
            ),
            key("bank_offset", Length, "The first V towards the free end of the second; 0 if left out."),
            SPACING,
            POSITIONS,
            ALONG,
        ],
    },
    Keys {
        name: "radial",
        about: "Rows of cylinders evenly round the crankshaft.",
        keys: &[
            needed("cylinders", Integer(1, 1000), "Of a row."),
            key("rows", Integer(1, 1000), "1 if left out; else the next two say how each row follows the one before."),
            key("row_rotation", Angle, "By which each row is turned from the one before."),
            key("row_throw", Angle, "From its throw to the next; left out, it follows from the firing."),
            key("row_spacing", Length, "Between rows; 1 if left out."),
            NAMES,
        ],
    },
    Keys {
        name: "opposed_piston",
        about: "Two pistons in each cylinder, on two crankshafts.",
        keys: &[
            needed("throws", Each(&Angle), "Of the lower crankshaft, from the free end."),
            needed("lead", Angle, "By how much the exhaust pistons are ahead."),
            key(
                "leading",
                OneOf(&["upper", "lower"]),
                "The crankshaft whose pistons open the exhaust; upper if left out.",
            ),
            key("sense", SENSES, "Of the upper crankshaft; \"with\" if left out."),
            key("distance", Length, "Between the crankshafts."),
            SPACING,
            POSITIONS,
        ],
    },
    Keys { name: "u", about: "Two rows side by side, each with its crankshaft.", keys: PAIR },
    Keys {
        name: "square_four",
        about: "Two rows of two side by side.",
        keys: &[
            needed("in_phase", OneOf(&["diagonals", "sides"]), "Which pistons go together."),
            SENSE,
            needed("distance", Length, "Between the crankshafts."),
            SPACING,
        ],
    },
    Keys { name: "h", about: "Two flat engines, one above the other.", keys: PAIR },
    Keys {
        name: "delta",
        about: "Opposed pistons in a triangle, on three crankshafts.",
        keys: &[
            needed("rows", Each(&Angle), "By how much each row is ahead."),
            key(
                "against",
                Each(&OneOf(&["A", "B", "C"])),
                "The corners whose crankshafts turn against the others; A if left out.",
            ),
            needed("circumradius", Length, "From the middle to each corner."),
            SPACING,
            POSITIONS,
        ],
    },
];

const PAIR: &[Key] = &[
    needed("throws", Each(&Angle), "Of the first crankshaft, from the free end."),
    SENSE,
    key("phase", Angle, "How far the pistons on the second crankshaft are ahead; 0 if left out."),
    needed("distance", Length, "Between the crankshafts."),
    SPACING,
    POSITIONS,
];

const GAS: &[Key] = &[
    key("bore", Length, "Of the cylinder; needed."),
    key("ambient", Pressure, "1.01325 bar if left out."),
    key("crankcase", Pressure, "Under the piston; ambient pressure if left out."),
    key(
        "dead_centre",
        OneOf(&["crank", "piston"]),
        "Where angles count from, with an offset: where the crank points along the axis, or where the piston is farthest out.",
    ),
    key("table", Text, "A CSV file beside the layout: crank angle and pressure."),
    key("pressure", Rows, "Rows of crank angle and pressure."),
    key("unit", Text, "Of pressures without one, in a table or in rows."),
    key("reading", OneOf(&["absolute", "gauge"]), "How the pressures of a table are meant; absolute if left out."),
    key("process", OneOf(&["spark-ignition", "diesel", "compressor"]), "A process, in place of measured pressures."),
    key("compression_ratio", Number, "Of the largest volume to the smallest."),
    key("intake_pressure", Pressure, "In the cylinder at the end of the intake."),
    key("exhaust_pressure", Pressure, "In the cylinder while it exhausts."),
    key("delivery_pressure", Pressure, "Of a compressor."),
    key("clearance", Number, "Of a compressor: clearance volume over swept volume."),
    key("compression_exponent", Number, "Polytropic exponent of the compression."),
    key("expansion_exponent", Number, "Polytropic exponent of the expansion."),
    key("heat", Quantity, "Heat of a cycle, or a pressure to find it from: peak_pressure or mean_pressure."),
    key("peak_pressure", Pressure, "Largest pressure, from which the heat follows."),
    key("mean_pressure", Pressure, "Indicated mean effective pressure, from which the heat follows."),
    key("wiebe_exponent", Number, "Form of the heat release."),
    key("intake_closes", Angle, "Crank angle after the dead centre of the combustion."),
    key("combustion_starts", Angle, "Crank angle after the dead centre of the combustion."),
    key("combustion_lasts", Angle, "In degrees of the crank."),
    key("exhaust_opens", Angle, "Crank angle after the dead centre of the combustion."),
    key("blowdown", Angle, "How long the pressure falls to that of the exhaust, in degrees of the crank."),
    key("cylinder", Tables("gas.cylinder"), "What differs in some cylinders, one table each."),
    key("cylinders", Each(&Text), "Of [[gas.cylinder]]: the names of the cylinders that it is about."),
];
