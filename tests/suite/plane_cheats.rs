//! Is every way to cheat either checker with two open angles caught, and is every honest document accepted, also as JSON?

use crankstar::proof::{
    ArcClaim, Certificate, ClassesClaim, CoprimeClaim, DividedClaim, MeetingClaim, OpenDocument, Polygon, ProductClaim,
    Reason, TriangleClaim, TriangleShape, Vector, WhenClaim, check_open_document,
};
use num_rational::BigRational;

use crate::support::second;
use crate::support::two_angles::documents;

pub fn half() -> BigRational {
    BigRational::new(1.into(), 2.into())
}

/// Evidence with one more opposed pair: of no sum for which it was right without.
pub fn forged(certificate: &Certificate) -> Certificate {
    let mut polygons = match certificate {
        Certificate::Polygons { polygons } => polygons.clone(),
        _ => Vec::new(),
    };
    polygons.push(Polygon { sides: 2, rotation: BigRational::new(1.into(), 97.into()), weight: half() });
    Certificate::Polygons { polygons }
}

/// A change, and whether there was something to change.
pub type Cheat<C> = (&'static str, fn(&mut C) -> bool);

/// As if the arcs were about a factor.
pub fn divided() -> DividedClaim {
    let one =
        vec![Vector { angle: BigRational::new(0.into(), 1.into()), weight: BigRational::new(1.into(), 1.into()) }];
    let coprime = CoprimeClaim {
        phi: half(),
        delta: half(),
        conductor: 1,
        prime: 2,
        root: 1,
        scale: 1.into(),
        u: vec![1],
        v: Vec::new(),
    };
    DividedClaim { without: vec![one.clone()], coprime, powers: vec![vec![one.clone(), one]], equalities: Vec::new() }
}

const CLASSES: [Cheat<ClassesClaim>; 18] = [
    ("the circle of a factor", |claim| claim.circle.as_mut().map(|circle| circle.divided = Some(divided())).is_some()),
    ("another u", |claim| {
        claim.phi += half();
        if let Some(circle) = &mut claim.circle {
            circle.phi = claim.phi.clone();
        }
        true
    }),
    ("u taken backwards", |claim| {
        (claim.phi, claim.delta) = (-&claim.phi, -&claim.delta);
        if let Some(circle) = &mut claim.circle {
            (circle.phi, circle.delta) = (claim.phi.clone(), claim.delta.clone());
        }
        true
    }),
    ("the circle of another u", |claim| claim.circle.as_mut().map(|circle| circle.delta += half()).is_some()),
    ("a class without one of its parts", |claim| claim.second.pop().is_some()),
    ("a part in the other class", |claim| {
        claim.second.insert(0, 0);
        true
    }),
    ("a part that is not there", |claim| {
        claim.second.push(99);
        true
    }),
    ("a part twice", |claim| {
        claim.second.extend(claim.second.last().copied());
        true
    }),
    ("a coefficient without evidence", |claim| claim.squares.pop().is_some()),
    ("forged evidence of a coefficient", |claim| {
        claim.squares.iter_mut().for_each(|certificate| *certificate = forged(certificate));
        true
    }),
    ("no circle", |claim| claim.circle.take().is_some()),
    ("a zero that is omitted", |claim| {
        let arcs = claim.circle.iter_mut().flat_map(|circle| &mut circle.arcs);
        let mut found = false;
        for arc in arcs {
            if let ArcClaim::Rational { to, .. } | ArcClaim::Crossing { to } = arc {
                *arc = ArcClaim::Free { to: to.clone() };
                found = true;
            }
        }
        if found {
            claim.meetings.clear();
        }
        found
    }),
    ("a meeting that is omitted", |claim| claim.meetings.pop().is_some()),
    ("a meeting too many", |claim| {
        let first = claim.squares[0].clone();
        claim.meetings.push(MeetingClaim::Once { first });
        true
    }),
    ("another turn", |claim| {
        let meeting = claim.meetings.iter_mut().find_map(|meeting| match meeting {
            MeetingClaim::Rational { turn, .. } => Some(turn),
            MeetingClaim::All { .. } | MeetingClaim::Once { .. } => None,
        });
        meeting.map(|turn| *turn += half()).is_some()
    }),
    ("a point as a line", |claim| {
        let meeting = claim.meetings.iter_mut().find_map(|meeting| match meeting {
            MeetingClaim::Rational { first, .. } | MeetingClaim::Once { first } => {
                let certificates = Box::new([forged(first), forged(first)]);
                Some((meeting, MeetingClaim::All { certificates }))
            }
            MeetingClaim::All { .. } => None,
        });
        meeting.map(|(meeting, other)| *meeting = other).is_some()
    }),
    ("a line as a point", |claim| {
        let meeting = claim.meetings.iter_mut().find_map(|meeting| match meeting {
            MeetingClaim::All { certificates } => {
                let first = certificates[0].clone();
                Some((meeting, MeetingClaim::Once { first }))
            }
            MeetingClaim::Rational { .. } | MeetingClaim::Once { .. } => None,
        });
        meeting.map(|(meeting, other)| *meeting = other).is_some()
    }),
    ("forged evidence of a meeting", |claim| {
        let certificate = claim.meetings.iter_mut().map(|meeting| match meeting {
            MeetingClaim::All { certificates } => &mut certificates[1],
            MeetingClaim::Rational { certificate, .. } => &mut **certificate,
            MeetingClaim::Once { first } => first,
        });
        certificate.map(|certificate| *certificate = forged(certificate)).count() > 0
    }),
];

const TRIANGLES: [Cheat<TriangleClaim>; 9] = [
    ("the sign of the squared area", |claim| {
        claim.alternatives.clear();
        claim.shape = match &claim.shape {
            TriangleShape::Never { bits } => TriangleShape::Two { bits: *bits },
            TriangleShape::Two { bits } => TriangleShape::Never { bits: *bits },
            TriangleShape::Flat { .. } => TriangleShape::Never { bits: 256 },
        };
        true
    }),
    ("the other sign", |claim| match &claim.shape {
        TriangleShape::Flat { .. } => {
            claim.shape = TriangleShape::Two { bits: 256 };
            true
        }
        TriangleShape::Never { .. } | TriangleShape::Two { .. } => false,
    }),
    ("forged evidence that it is flat", |claim| {
        claim.alternatives.clear();
        let certificate = forged(&Certificate::Polygons { polygons: Vec::new() });
        claim.shape = TriangleShape::Flat { certificate };
        true
    }),
    ("too few bits", |claim| change_bits(claim, 8)),
    ("too many bits", |claim| change_bits(claim, 4096)),
    ("another turn", |claim| {
        let first = claim.alternatives.first_mut();
        first.map(|alternative| alternative.conditions[0].turn += half()).is_some()
    }),
    ("a triangle twice", |claim| {
        let first = claim.alternatives.first().cloned();
        claim.alternatives.truncate(1);
        claim.alternatives.extend(first);
        !claim.alternatives.is_empty()
    }),
    ("a condition that is omitted", |claim| {
        claim.alternatives.first_mut().is_some_and(|alternative| alternative.conditions.pop().is_some())
    }),
    ("a condition on another angle", |claim| {
        let first = claim.alternatives.first_mut();
        first.map(|alternative| alternative.conditions[1].phi += half()).is_some()
    }),
];

const PRODUCTS: [Cheat<ProductClaim>; 8] = [
    ("a group that is omitted", |claim| claim.groups.pop().is_some()),
    ("a part in another group", |claim| {
        let moved = claim.groups[1].pop();
        claim.groups[0].extend(moved);
        true
    }),
    ("groups reversed", |claim| {
        claim.groups[1].reverse();
        true
    }),
    ("one group", |claim| {
        claim.groups = vec![claim.groups.concat()];
        claim.certificates.clear();
        true
    }),
    ("groups of one part", |claim| {
        claim.groups = claim.groups.concat().into_iter().map(|place| vec![place]).collect();
        claim.certificates.clear();
        true
    }),
    ("a part without evidence", |claim| claim.certificates.pop().is_some()),
    ("forged evidence of a part", |claim| {
        claim.certificates.iter_mut().for_each(|certificate| *certificate = forged(certificate));
        true
    }),
    ("factors that always vanish", |claim| {
        (claim.group, claim.firsts) = (WhenClaim::Always, WhenClaim::Never);
        true
    }),
];

fn change_bits(claim: &mut TriangleClaim, to: u32) -> bool {
    change_bits_of(&mut claim.shape, to)
}

/// Whether it has bits.
pub fn change_bits_of(shape: &mut TriangleShape, to: u32) -> bool {
    match shape {
        TriangleShape::Never { bits } | TriangleShape::Two { bits } => {
            *bits = to;
            true
        }
        TriangleShape::Flat { .. } => false,
    }
}

/// Where the claims of a kind are: verdict and sum.
fn places(document: &OpenDocument, is_it: impl Fn(&WhenClaim) -> bool) -> Vec<[usize; 2]> {
    let verdicts = document.open_verdicts.iter().enumerate();
    let sums = verdicts.flat_map(|(i, verdict)| verdict.sums.iter().enumerate().map(move |(j, sum)| ([i, j], sum)));
    sums.filter(|(_, sum)| is_it(&sum.when)).map(|(place, _)| place).collect()
}

/// Tries a change on a few claims of a kind, with both checkers; how many were there to be changed.
pub fn tried(
    documents: &[OpenDocument],
    name: &str,
    is_it: impl Fn(&WhenClaim) -> bool,
    change: impl Fn(&mut WhenClaim) -> bool,
) -> usize {
    let cheats = refused(documents, name, is_it, change);
    second::refuses(&cheats);
    cheats.len()
}

/// A few documents with a changed claim of a kind, after the first checker has refused each.
fn refused<'a>(
    documents: &[OpenDocument],
    name: &'a str,
    is_it: impl Fn(&WhenClaim) -> bool,
    change: impl Fn(&mut WhenClaim) -> bool,
) -> Vec<(&'a str, OpenDocument)> {
    let mut cheats = Vec::new();
    'all: for document in documents {
        for [i, j] in places(document, &is_it) {
            if cheats.len() == 5 {
                break 'all;
            }
            let mut forged = alone(document, i);
            let when = &mut forged.open_verdicts[i % 2].sums[j].when;
            let honest = when.clone();
            // A change to what a claim says already is none.
            if !change(when) || *when == honest {
                continue;
            }
            let fault = check_open_document(&forged).expect_err(name);
            assert_ne!(fault.reason, Reason::TooManySteps, "{name}");
            cheats.push((name, forged));
        }
    }
    cheats
}

/// The document with one verdict, and that of the other sense.
fn alone(document: &OpenDocument, at: usize) -> OpenDocument {
    let first = at - at % 2;
    let pair = document.open_verdicts[first..first + 2].to_vec();
    let (orders, quantities) = (vec![pair[0].order], vec![pair[0].quantity]);
    OpenDocument { orders, quantities, open_verdicts: pair, ..document.clone() }
}

#[test]
fn every_cheat_with_two_open_angles_is_caught() {
    let documents = documents();
    for document in &documents {
        let json = serde_json::to_string(document).expect("JSON");
        let read: OpenDocument = serde_json::from_str(&json).expect("it reads");
        assert_eq!(&read, document);
        check_open_document(&read).expect("it holds");
    }
    second::accepts(&documents, &[]);
    let is_classes = |when: &WhenClaim| matches!(when, WhenClaim::Classes(_));
    let is_triangle = |when: &WhenClaim| matches!(when, WhenClaim::Triangle(_));
    for (name, cheat) in CLASSES {
        let change = |when: &mut WhenClaim| match when {
            WhenClaim::Classes(claim) => cheat(claim),
            _ => false,
        };
        assert!(tried(&documents, name, is_classes, change) > 0, "never tried: {name}");
    }
    for (name, cheat) in TRIANGLES {
        let change = |when: &mut WhenClaim| match when {
            WhenClaim::Triangle(claim) => cheat(claim),
            _ => false,
        };
        assert!(tried(&documents, name, is_triangle, change) > 0, "never tried: {name}");
    }
    let is_product = |when: &WhenClaim| matches!(when, WhenClaim::Product(_));
    for (name, cheat) in PRODUCTS {
        let change = |when: &mut WhenClaim| match when {
            WhenClaim::Product(claim) => cheat(claim),
            _ => false,
        };
        assert!(tried(&documents, name, is_product, change) > 0, "never tried: {name}");
    }
    for other in [WhenClaim::Always, WhenClaim::Never] {
        let change = |when: &mut WhenClaim| {
            *when = other.clone();
            true
        };
        assert!(
            tried(&documents, "another kind", |when| is_classes(when) || is_triangle(when) || is_product(when), change)
                > 0
        );
    }
}
