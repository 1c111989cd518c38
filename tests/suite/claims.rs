//! Are claims answered rightly, and is every answer proved?

use crankstar::claim::{Status, answer, parse_statement};
use crankstar::layout;
use crankstar::proof::{Vector, check_certificate};

fn status(engine: &str, says: &str) -> Status {
    let layout = layout::find(engine).expect("an engine").layout().expect("reads");
    let statement = parse_statement(says).unwrap_or_else(|mistake| panic!("{says}: {mistake:?}"));
    let answer = answer(&layout, &statement, None);
    for evidence in &answer.evidence {
        let vector = |t: &crankstar::exact::Term| Vector { angle: t.angle.turns().clone(), weight: t.weight.clone() };
        let terms: Vec<Vector> = evidence.sum().terms().iter().map(vector).collect();
        check_certificate(&terms, evidence.vanishes(), evidence.certificate()).expect("the certificate holds");
    }
    answer.status
}

#[test]
fn claims_are_answered() {
    let cases = [
        ("I4", "fourth-order force vanishes", "False"),
        ("I4", "order 2 force = 4", "True"),
        ("I3", "first-order couple = √3", "True"),
        ("I3", "first-order couple = 1.732", "TrueAsRounded"),
        ("I3", "first-order couple = 1.742", "False"),
        ("I2-270", "second-order moments vanish", "False"),
        ("I2-270", "every higher order vanishes", "False"),
        ("I5-15234", "second-order force vanishes", "True"),
        ("I5-12453", "first-order couple = ½√(50 − 22√5)", "True"),
        ("V8-crossplane", "first-order direct moment plane -18.43° ± 0.01°", "True"),
        ("V8-crossplane", "first-order moment = √10 at −arctan(1/3)", "True"),
        ("V8-crossplane", "first-order moment is rotating", "True"),
        ("V8-flatplane", "second-order moment vanishes", "TrueOnlyIf"),
        ("V6-60-shared", "first-order moment = 3√3/2", "True"),
        ("V6-60-shared", "first-order moment is planar", "False"),
        ("V10-72", "no free moment", "False"),
        ("boxer-2", "every order of the force vanishes", "True"),
        ("boxer-2", "no free moment", "False"),
        ("radial-4", "every higher order of the force vanishes", "True"),
        ("I6", "every order vanishes", "False"),
        ("I6", "no free moment", "TrueOnlyIf"),
        ("I8-242", "orders 1 and 2 vanish", "True"),
        ("I8-44", "fires evenly", "TrueOnlyIf"),
        ("I2-180", "fires evenly", "False"),
    ];
    for (engine, says, expected) in cases {
        let found = format!("{:?}", status(engine, says));
        assert_eq!(found.split([' ', '{']).next(), Some(expected), "{engine}: {says}: {found}");
    }
}
