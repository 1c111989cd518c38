//! The hard cases and their references to 50 digits, one case a line.
//!
//! Computed with mpmath 1.4 at 75 digits (the last torque of the radial at 260) by the recipe of each line, from P⁺ and P⁻
//! of the theory (section 3), c_k by the hypergeometric series, and with an offset or for the torque t_k by the mean over N
//! equal steps of a revolution, N up to 340 000, so that what the mean leaves out is below the last digit.

use Ask::*;

/// What is asked.
#[derive(Clone, Copy)]
pub enum Ask {
    /// c_k of a crank: the real part for even k, the imaginary for odd.
    Coefficient {
        ratio: &'static str,
        offset: &'static str,
        order: u32,
    },
    /// The piston's way from top dead centre at ψ = 1, in crank radii.
    Position {
        ratio: &'static str,
    },
    /// Its acceleration at ψ = 1, in r ω².
    Acceleration {
        ratio: &'static str,
    },
    /// Largest force of an order, in newtons.
    Force(u32),
    /// Largest moment of an order, in newton-metres.
    Moment(u32),
    /// Largest inertia torque of an order, in newton-metres.
    Torque(u32),
    /// Peaks of the sum of orders.
    ForcePeak(&'static [u32]),
    MomentPeak(&'static [u32]),
    TorquePeak(&'static [u32]),
}

/// A case: what is hard, the engine, what is asked, how the reference was computed, the condition number, the bound in units
/// in the last place for a condition of 1, the reference.
pub type Case = (&'static str, &'static str, Ask, &'static str, u64, u64, &'static str);

const EVEN_TO_40: [u32; 21] = [1, 2, 4, 6, 8, 10, 12, 14, 16, 18, 20, 22, 24, 26, 28, 30, 32, 34, 36, 38, 40];

const BY_SERIES: &str = "k²·2C(½,m)λ^{2m−1}/4^m · ₂F₁(m−½, m+½; 2m+1; λ²), k = 2m";
const BY_MEAN: &str = "2/N · Σ −s̈(ψ_j) e^{−ikψ_j} over N equal steps";
const AMPLITUDE: &str = "½mrω²(|P⁺| + |P⁻|)";
const MOMENT: &str = "½mrω²(|P⁺| + |P⁻|), weights z";
const PEAK: &str = "max |Σ F_k(θ)|, Newton";
const MOMENT_PEAK: &str = "max |Σ C_k(θ)|, Newton";
const TORQUE: &str = "m r² ω² |Σ t_k e^{ik(β−α)}|";
const TORQUE_PEAK: &str = "max |Σ T_k(θ)|, Newton";

const NEARLY_EVEN_ANGLES: &str = r#"inline = { throws = [0, 120, "240.00000001"], spacing = "0.1 m" }"#;
const NEARLY_EQUAL_MASSES: &str = r#"inline = { throws = [0, 120, 240], spacing = "0.1 m" }
mechanism = { crank_radius = "50 mm", rod_ratio = 0.25, reciprocating_mass = ["1", "1", "1.000000001"] }"#;
const NEARLY_EQUAL_RODS: &str = r#"inline = { throws = [0, 90], spacing = "0.1 m" }
mechanism = { crank_radius = "50 mm", rod_ratio = ["0.25", "0.250000001"], reciprocating_mass = 1 }"#;
const THREE_FAR_AWAY: &str = r#"reference_plane = "1000 m"
inline = { throws = [0, 120, 240], positions = ["0.2 m", "0.1 m", "0 m"] }"#;
const FOUR_FAR_AWAY: &str = r#"reference_plane = "1000 m"
inline = { throws = [0, 180, 180, 0], positions = ["0.3 m", "0.2 m", "0.1 m", "0 m"] }"#;
/// Written out by the test: 500 tables.
const FIVE_HUNDRED: &str = "500 cylinders";
const PRIME_ANGLES: &str = r#"effects = ["torque"]
inline = { throws = ["1/1000000007 turn", "333333333/9999999967 turn", "7654321/1000000009 turn"], spacing = "0.1 m" }"#;
const LONG_WEIGHTS: &str = r#"effects = ["torque"]
inline = { throws = [0, 120, 240], spacing = "0.1 m" }
[mechanism]
crank_radius = "50 mm"
rod_ratio = 0.25
reciprocating_mass = ["1.23456789012345678901234567891", "1.23456789012345678901234567890", "1.23456789012345678901234567892"]"#;
const MILLION_RPM: &str = r#"speed = 1e6
effects = ["torque"]
vee = { bank_angle = 90, throws = [0], bank_offset = "0.1 m" }"#;
const STANDSTILL: &str = r#"speed = 0
effects = ["torque"]
vee = { bank_angle = 90, throws = [0], bank_offset = "0.1 m" }"#;
const NO_MASS: &str = r#"effects = ["torque"]
vee = { bank_angle = 90, throws = [0], bank_offset = "0.1 m" }
mechanism = { crank_radius = "50 mm", rod_ratio = 0.25, reciprocating_mass = 0 }"#;
const ROTATING_ALONE: &str = r#"vee = { bank_angle = 90, throws = [0], bank_offset = "0.1 m" }
mechanism = { crank_radius = "50 mm", rod_ratio = 0.25, reciprocating_mass = 0, rotating_mass = 0.5 }"#;
const RADIAL_101: &str = r#"effects = ["torque"]
radial = { cylinders = 101 }"#;
const NEARLY_SHORT_ROD: &str = r#"effects = ["torque"]
inline = { throws = [0] }
mechanism = { crank_radius = "50 mm", rod_ratio = 0.999, reciprocating_mass = 1 }"#;
const LONG_ROD: &str = r#"effects = ["torque"]
inline = { throws = [0] }
mechanism = { crank_radius = "50 mm", rod_ratio = 1e-8, reciprocating_mass = 1 }"#;
const SIX_WITH_OFFSET: &str = r#"inline = { throws = [0, 120, 240, 240, 120, 0], spacing = "0.1 m" }
mechanism = { crank_radius = "50 mm", rod_ratio = 0.25, offset_ratio = 0.02, reciprocating_mass = 1 }"#;
const VEE_75: &str = r#"speed = 6000
effects = ["torque"]
vee = { bank_angle = 75, throws = [0, 180], spacing = "0.1 m" }
mechanism = { crank_radius = "50 mm", rod_ratio = 0.3, reciprocating_mass = 1 }"#;

#[rustfmt::skip]
pub const CASES: &[Case] = &[
    ("λ = 0.999", "", Coefficient { ratio: "0.999", offset: "0", order: 2 }, BY_SERIES, 1, 1, "1.6823704946086654774818119057292363654328612877391"),
    ("λ = 0.999", "", Coefficient { ratio: "0.999", offset: "0", order: 40 }, BY_SERIES, 1, 1, "-4.2276631301054889030046106479157966540480123736864e-1"),
    ("λ = 0.999999", "", Coefficient { ratio: "0.999999", offset: "0", order: 2 }, BY_SERIES, 1, 1, "1.6976198895121944666454226698180506359770636477194"),
    ("λ = 0.999999", "", Coefficient { ratio: "0.999999", offset: "0", order: 40 }, BY_SERIES, 1, 1, "-1.2669263957485702759419458029025371228803600057057"),
    ("λ = 1 − 10^−12", "", Coefficient { ratio: "0.999999999999", offset: "0", order: 2 }, BY_SERIES, 1, 1, "1.6976527262455326135735944528310802688510934978435"),
    ("λ = 1 − 10^−12", "", Coefficient { ratio: "0.999999999999", offset: "0", order: 40 }, BY_SERIES, 1, 1, "-1.2740357959425403885962992054687173473490926023686"),
    ("λ = 1 − 10^−12", "", Coefficient { ratio: "0.999999999999", offset: "0", order: 100 }, BY_SERIES, 1, 1, "-1.2733667607242494391210465657027779707563361028159"),
    ("λ = 1 − 10^−16", "", Coefficient { ratio: "0.9999999999999999", offset: "0", order: 2 }, BY_SERIES, 1, 1, "1.6976527263135411010440476273634502032638298036232"),
    ("λ = 1 − 10^−16", "", Coefficient { ratio: "0.9999999999999999", offset: "0", order: 40 }, BY_SERIES, 1, 1, "-1.2740358171178072358177499810704001076215669342526"),
    ("λ = 1 − 10^−16", "", Coefficient { ratio: "0.9999999999999999", offset: "0", order: 100 }, BY_SERIES, 1, 1, "-1.2733668814053716263365186837709745925384756971705"),
    ("λ + δ = 0.999: λ = 0.98", "", Coefficient { ratio: "0.98", offset: "0.019", order: 2 }, BY_MEAN, 1, 1, "1.5650371864852155509651642506291555371684617448464"),
    ("λ + δ = 0.999: λ = 0.98", "", Coefficient { ratio: "0.98", offset: "0.019", order: 3 }, BY_MEAN, 1, 1, "2.0356022686187201196341136603012586254315576298616e-1"),
    ("λ + δ = 0.999: λ = 0.98", "", Coefficient { ratio: "0.98", offset: "0.019", order: 40 }, BY_MEAN, 1, 1, "-2.1053458476300733120315902201278846183347666692225e-1"),
    ("λ + δ = 0.999999: λ = 0.5", "", Coefficient { ratio: "0.5", offset: "0.499999", order: 2 }, BY_MEAN, 1, 1, "1.2515084727901153745862356309490430056352581695498"),
    ("λ + δ = 0.999999: λ = 0.5", "", Coefficient { ratio: "0.5", offset: "0.499999", order: 3 }, BY_MEAN, 1, 1, "9.4772427771723684078671862854814204677744785256679e-1"),
    ("λ + δ = 0.999999: λ = 0.5", "", Coefficient { ratio: "0.5", offset: "0.499999", order: 40 }, BY_MEAN, 1, 1, "-8.9160787815449555102142409915371386305750488231572e-1"),
    ("λ + δ = 0.999999: λ = 0.9", "", Coefficient { ratio: "0.9", offset: "0.099999", order: 2 }, BY_MEAN, 1, 1, "1.3806599228933134046942392024197681639120697849193"),
    ("λ + δ = 0.999999: λ = 0.9", "", Coefficient { ratio: "0.9", offset: "0.099999", order: 3 }, BY_MEAN, 1, 1, "5.0421580237047005165353834804895981904453729331921e-1"),
    ("λ + δ = 0.999999: λ = 0.9", "", Coefficient { ratio: "0.9", offset: "0.099999", order: 40 }, BY_MEAN, 1, 1, "-6.6734335983095361093285529894126883111206985444392e-1"),
    ("λ = 10^−8", "", Coefficient { ratio: "1e-8", offset: "0", order: 2 }, BY_SERIES, 1, 1, "1.0000000000000000250000000000000011718750000000001e-8"),
    ("λ = 10^−8", "", Coefficient { ratio: "1e-8", offset: "0", order: 4 }, BY_SERIES, 1, 1, "-2.500000000000000187500000000000013671875000000001e-25"),
    ("λ = 1/4, high order", "", Coefficient { ratio: "0.25", offset: "0", order: 40 }, BY_SERIES, 1, 1, "-5.7778320899110004233941094335223016337537148352242e-35"),
    ("λ = 1/4, high order", "", Coefficient { ratio: "0.25", offset: "0", order: 100 }, BY_SERIES, 1, 1, "-1.5394668448202023848604486893840198273633969798555e-88"),
    ("λ = 1/4, high order", "", Coefficient { ratio: "0.25", offset: "0", order: 102 }, BY_SERIES, 1, 1, "2.5079969780180422504358862415775761500612623595746e-90"),
    ("λ = 10^−8", "", Position { ratio: "1e-8" }, "−2 sin²½ + (√(1−λ² sin²1) − 1)/λ", 1, 2, "-4.596976976722273739669194227219396782220602936914e-1"),
    ("λ = 1 − 10^−12", "", Acceleration { ratio: "0.999999999999" }, "−cosψ − λ cos²ψ/√(1−λ² sin²ψ)³ + λ sin²ψ/√(1−λ² sin²ψ), ψ = 1", 3, 4, "-1.0806046117254502423700880982548499178550185084853"),
    ("throws 0°, 120°, 240.00000001°: a sum that cancels to 6·10^−11", NEARLY_EVEN_ANGLES, Force(1), AMPLITUDE, 1, 8, "8.6128546334166167153991557454916540794767810893182e-7"),
    ("the same", NEARLY_EVEN_ANGLES, Force(2), AMPLITUDE, 1, 8, "4.3757615252749681954729335739792136632145309743935e-7"),
    ("masses 1, 1, 1.000000001: a sum that cancels to 3·10^−10", NEARLY_EQUAL_MASSES, Force(1), AMPLITUDE, 1, 8, "4.9348022005446793094172454999380755676568497036204e-6"),
    ("the same", NEARLY_EQUAL_MASSES, Force(4), AMPLITUDE, 1, 8, "2.0223368029806813560684996855243385315339623748374e-8"),
    ("λ = 0.25 and 0.250000001, throws 0°, 90°: coefficients that cancel to 2·10^−9", NEARLY_EQUAL_RODS, Force(2), AMPLITUDE, 490_000_000, 4, "5.1780245691337625706522064403598573619032967021121e-6"),
    ("I3, reference plane a kilometre away", THREE_FAR_AWAY, Moment(1), MOMENT, 1, 8, "8.5473281366460845573714864257116736428628675581872e+2"),
    ("I4, reference plane a kilometre away", FOUR_FAR_AWAY, Moment(1), MOMENT, 1, 8, "0"),
    ("the same", FOUR_FAR_AWAY, Moment(2), MOMENT, 1, 8, "5.0135012130770054689390984244701463993153501075794e+6"),
    ("500 cylinders, throws i²/499 turn", FIVE_HUNDRED, Force(1), AMPLITUDE, 1, 8, "1.3787674193328849092637319814301933633773093227817e+5"),
    ("the same", FIVE_HUNDRED, Force(2), AMPLITUDE, 1, 8, "3.5024145202751521092707702642942109179106928595723e+4"),
    ("the same", FIVE_HUNDRED, Moment(2), MOMENT, 1, 8, "7.1221642891740052284536455028002917102724091727824e+4"),
    ("the same", FIVE_HUNDRED, ForcePeak(&[1, 2, 4, 6]), PEAK, 1, 8, "1.5489033372108956748641392947643382316921237661771e+5"),
    ("the same", FIVE_HUNDRED, MomentPeak(&[1, 2, 4, 6]), MOMENT_PEAK, 1, 8, "5.3354110301289879290883058189774342088475045620892e+5"),
    ("the same", FIVE_HUNDRED, Torque(3), TORQUE, 1, 8, "1.3239998366621784247240712457236068640198763029158e+3"),
    ("throws over primes of ten digits", PRIME_ANGLES, Force(1), AMPLITUDE, 1, 8, "1.4745075480587859305403307261128519856408137435688e+4"),
    ("the same", PRIME_ANGLES, Force(2), AMPLITUDE, 1, 8, "3.7005853139671191800452822556978585121365031584769e+3"),
    ("the same", PRIME_ANGLES, Force(40), AMPLITUDE, 1, 8, "5.1635300604211207960788515645229269221856162216198e-31"),
    ("the same", PRIME_ANGLES, Moment(2), MOMENT, 1, 8, "1.2053004657602650980044311335323075964438846591328e+1"),
    ("the same", PRIME_ANGLES, ForcePeak(&[1, 2, 4, 6]), PEAK, 1, 8, "1.8389770361846959449344722857269518953190973269076e+4"),
    ("the same", PRIME_ANGLES, Torque(3), TORQUE, 1, 8, "1.3707697483805562133583210688764029973866013714359e+2"),
    ("masses of 30 digits that differ in the last", LONG_WEIGHTS, Force(1), AMPLITUDE, 1, 8, "8.547328136646084557371486425711673642862867558159e-26"),
    ("the same", LONG_WEIGHTS, Force(6), AMPLITUDE, 1, 8, "1.3594289311250728393978308749356423160513287702638"),
    ("the same", LONG_WEIGHTS, Moment(1), MOMENT, 1, 8, "1.0552256863852013975140901340386250476850522496213e+3"),
    ("the same", LONG_WEIGHTS, Torque(1), TORQUE, 1, 8, "2.7140442394039022343386491738276163684159639698257e-28"),
    ("V2, 10⁶ rpm", MILLION_RPM, Force(2), AMPLITUDE, 1, 8, "1.9697847484087794736660870570596943255975684916767e+8"),
    ("the same", MILLION_RPM, Moment(1), MOMENT, 1, 8, "2.741556778080377394120691944410041982031583168678e+7"),
    ("the same", MILLION_RPM, ForcePeak(&[1, 2, 4, 6]), PEAK, 1, 8, "7.0754203627013256832687247773558790884744322510184e+8"),
    ("the same", MILLION_RPM, Torque(2), TORQUE, 1, 8, "0"),
    ("V2, 0 rpm", STANDSTILL, Force(1), AMPLITUDE, 1, 8, "0"),
    ("the same", STANDSTILL, ForcePeak(&[1, 2, 4, 6]), PEAK, 1, 8, "0"),
    ("the same", STANDSTILL, Torque(1), TORQUE, 1, 8, "0"),
    ("V2 without reciprocating mass", NO_MASS, Force(2), AMPLITUDE, 1, 8, "0"),
    ("the same", NO_MASS, Moment(1), MOMENT, 1, 8, "0"),
    ("the same", NO_MASS, Torque(1), TORQUE, 1, 8, "0"),
    ("V2 with rotating masses alone", ROTATING_ALONE, Force(1), AMPLITUDE, 1, 8, "4.9348022005446793094172454999380755676568497036204e+3"),
    ("the same", ROTATING_ALONE, Force(2), AMPLITUDE, 1, 8, "0"),
    ("radial of 101", RADIAL_101, Force(1), AMPLITUDE, 1, 8, "2.4920751112750630512557089774687281616667091003283e+5"),
    ("the same", RADIAL_101, Force(2), AMPLITUDE, 1, 8, "0"),
    ("the same", RADIAL_101, Force(100), AMPLITUDE, 1, 8, "3.8364670086095760809368112942596601235188061869918e-83"),
    ("the same", RADIAL_101, Force(102), AMPLITUDE, 1, 8, "6.2501168480718345025714409810582657331459212531874e-85"),
    ("the same", RADIAL_101, Torque(101), TORQUE, 1, 8, "1.9683600453113288269887620339485246780165921267138e-84"),
    ("I1, λ = 0.999", NEARLY_SHORT_ROD, ForcePeak(&EVEN_TO_40), PEAK, 1, 8, "8.3938219033357744933251670922890410763646507545733e+4"),
    ("the same", NEARLY_SHORT_ROD, Torque(1), TORQUE, 1, 8, "1.0377707023657853670660866885212295853692240229184e+2"),
    ("the same", NEARLY_SHORT_ROD, Torque(40), TORQUE, 1, 8, "7.3851898821504908844233831978808194141499757403815e+1"),
    ("I1, λ = 10^−8", LONG_ROD, Torque(1), TORQUE, 1, 8, "6.1685027506808492909841256419438301075741449567109e-7"),
    ("the same", LONG_ROD, Torque(2), TORQUE, 1, 8, "1.2337005501361698273543113749845196629770562610113e+2"),
    ("I6, δ = 0.02", SIX_WITH_OFFSET, Force(3), AMPLITUDE, 1, 8, "4.4266208895042528630111677075827220147115534674196e+1"),
    ("the same", SIX_WITH_OFFSET, Force(6), AMPLITUDE, 1, 8, "2.2187561239524639518264411544064484411996621433951"),
    ("the same", SIX_WITH_OFFSET, ForcePeak(&[1, 2, 3, 4, 6]), PEAK, 1, 8, "4.6484965018994992581938118230233668588315196817591e+1"),
    ("V4 of 75°, λ = 0.3", VEE_75, ForcePeak(&[1, 2, 4, 6]), PEAK, 1, 8, "1.4277017937421680852987059313656740408221444410999e+4"),
    ("the same", VEE_75, MomentPeak(&[1, 2, 4, 6]), MOMENT_PEAK, 1, 8, "2.484809197543788548701096230513728028554881915606e+3"),
    ("the same", VEE_75, TorquePeak(&[1, 2, 3, 4, 6]), TORQUE_PEAK, 1, 8, "5.3250015196884627638706576792391211175802004977261e+2"),
];
