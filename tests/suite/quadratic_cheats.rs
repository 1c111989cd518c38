//! Is every way to cheat either checker with three classes of parts caught?

use crankstar::proof::{
    ArcClaim, Certificate, OpenDocument, QuadraticClaim, RootClaim, RootsClaim, TriangleShape, TwistClaim, WhenClaim,
    check_open_document,
};
use num_rational::BigRational;

use crate::plane_cheats::{Cheat, change_bits_of, divided, forged, half, tried};
use crate::support::second;
use crate::support::two_angles::{document, quadratic_documents, twists};

/// The first entry of `roots` that a change fits.
fn first(claim: &mut QuadraticClaim, change: impl Fn(&mut RootsClaim) -> bool) -> bool {
    claim.roots.iter_mut().any(change)
}

fn turns(roots: &mut RootsClaim) -> &mut [RootClaim] {
    match roots {
        RootsClaim::One { at, .. } | RootsClaim::Mirror { at, .. } => at,
        RootsClaim::All { .. } | RootsClaim::None { .. } => &mut [],
    }
}

const CLASSES: [Cheat<QuadraticClaim>; 20] = [
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
    ("middle and outer class exchanged", |claim| {
        std::mem::swap(&mut claim.second, &mut claim.third);
        true
    }),
    ("a class without one of its parts", |claim| claim.second.pop().is_some()),
    ("an outer class without its parts", |claim| {
        claim.third.clear();
        true
    }),
    ("a part in two classes", |claim| {
        claim.third = [claim.second.clone(), claim.third.clone()].concat();
        claim.third.sort_unstable();
        true
    }),
    ("a part twice", |claim| {
        claim.third.extend(claim.third.last().copied());
        true
    }),
    ("a part that is not there", |claim| {
        claim.third.push(99);
        true
    }),
    ("a coefficient without evidence", |claim| claim.coefficients.pop().is_some()),
    ("forged evidence of a coefficient", |claim| {
        claim.coefficients.iter_mut().for_each(|certificate| *certificate = forged(certificate));
        true
    }),
    ("every coefficient zero", |claim| {
        claim.coefficients.iter_mut().for_each(|certificate| {
            *certificate = Certificate::Polygons { polygons: Vec::new() };
        });
        (claim.circle, claim.roots) = (None, Vec::new());
        true
    }),
    ("a length without evidence", |claim| claim.lengths.pop().is_some()),
    ("forged evidence of a length", |claim| {
        claim.lengths.iter_mut().for_each(|certificate| *certificate = forged(certificate));
        !claim.lengths.is_empty()
    }),
    ("lengths of one size that differ", |claim| {
        let differ = claim.lengths.iter().any(|certificate| !certificate.claims_zero());
        let zero = || Certificate::Polygons { polygons: Vec::new() };
        claim.lengths.iter_mut().for_each(|certificate| *certificate = zero());
        differ
    }),
    ("lengths where there is no curve", |claim| {
        let is_curve = !claim.lengths.is_empty();
        claim.lengths = claim.coefficients.clone();
        !is_curve
    }),
    ("no circle", |claim| claim.circle.take().is_some()),
    ("no circle and no roots", |claim| {
        claim.roots.clear();
        claim.circle.take().is_some()
    }),
    ("a zero that is omitted", |claim| {
        let arcs = claim.circle.iter_mut().flat_map(|circle| &mut circle.arcs);
        let mut found = false;
        for arc in arcs {
            if let ArcClaim::Rational { to, .. } | ArcClaim::Crossing { to } = arc {
                *arc = ArcClaim::Free { to: to.clone() };
                found = true;
            }
        }
        claim.roots.clear();
        found
    }),
];

const ROOTS: [Cheat<QuadraticClaim>; 14] = [
    ("roots that are omitted", |claim| claim.roots.pop().is_some()),
    ("roots too many", |claim| {
        let lengths = claim.coefficients[0].clone();
        claim.roots.push(RootsClaim::One { lengths, at: Vec::new() });
        true
    }),
    ("another turn", |claim| {
        first(claim, |roots| {
            let root = turns(roots).first_mut();
            root.map(|root| root.turn += BigRational::new(1.into(), 7.into())).is_some()
        })
    }),
    ("forged evidence of a turn", |claim| {
        first(claim, |roots| {
            turns(roots).first_mut().map(|root| root.certificate = forged(&root.certificate)).is_some()
        })
    }),
    ("a turn twice", |claim| {
        first(claim, |roots| match roots {
            RootsClaim::One { at, .. } | RootsClaim::Mirror { at, .. } if !at.is_empty() => {
                at.push(at[0].clone());
                true
            }
            RootsClaim::One { .. } | RootsClaim::Mirror { .. } | RootsClaim::All { .. } | RootsClaim::None { .. } => {
                false
            }
        })
    }),
    ("all as none", |claim| {
        first(claim, |roots| match roots {
            RootsClaim::All { certificates } => {
                *roots = RootsClaim::None { certificates: certificates.clone() };
                true
            }
            RootsClaim::None { .. } | RootsClaim::One { .. } | RootsClaim::Mirror { .. } => false,
        })
    }),
    ("none as all", |claim| {
        first(claim, |roots| match roots {
            RootsClaim::None { certificates } => {
                *roots = RootsClaim::All { certificates: certificates.clone() };
                true
            }
            RootsClaim::All { .. } | RootsClaim::One { .. } | RootsClaim::Mirror { .. } => false,
        })
    }),
    ("none where outer ones are left", |claim| {
        first(claim, |roots| match roots {
            RootsClaim::One { lengths, .. } => {
                let zero = Certificate::Polygons { polygons: Vec::new() };
                *roots = RootsClaim::None { certificates: Box::new([zero.clone(), lengths.clone(), zero]) };
                true
            }
            RootsClaim::All { .. } | RootsClaim::None { .. } | RootsClaim::Mirror { .. } => false,
        })
    }),
    ("two of unequal length as a mirror", |claim| {
        first(claim, |roots| match roots {
            RootsClaim::One { lengths, .. } => {
                let (lengths, first) = (forged(lengths), lengths.clone());
                *roots =
                    RootsClaim::Mirror { lengths, first, shape: TriangleShape::Never { bits: 128 }, at: Vec::new() };
                true
            }
            RootsClaim::All { .. } | RootsClaim::None { .. } | RootsClaim::Mirror { .. } => false,
        })
    }),
    ("a mirror as one", |claim| {
        first(claim, |roots| match roots {
            RootsClaim::Mirror { lengths, .. } => {
                *roots = RootsClaim::One { lengths: lengths.clone(), at: Vec::new() };
                true
            }
            RootsClaim::All { .. } | RootsClaim::None { .. } | RootsClaim::One { .. } => false,
        })
    }),
    ("nothing as a mirror", |claim| {
        first(claim, |roots| match roots {
            RootsClaim::All { certificates } | RootsClaim::None { certificates } => {
                let lengths = Certificate::Polygons { polygons: Vec::new() };
                let (first, shape) = (certificates[0].clone(), TriangleShape::Flat { certificate: lengths.clone() });
                *roots = RootsClaim::Mirror { lengths, first, shape, at: Vec::new() };
                true
            }
            RootsClaim::One { .. } | RootsClaim::Mirror { .. } => false,
        })
    }),
    ("two as none", |claim| {
        first(claim, |roots| match roots {
            RootsClaim::Mirror { shape, at, .. } => match shape {
                TriangleShape::Two { bits } => {
                    (*shape, *at) = (TriangleShape::Never { bits: *bits }, Vec::new());
                    true
                }
                TriangleShape::Never { .. } | TriangleShape::Flat { .. } => false,
            },
            RootsClaim::All { .. } | RootsClaim::None { .. } | RootsClaim::One { .. } => false,
        })
    }),
    ("none as two", |claim| {
        first(claim, |roots| match roots {
            RootsClaim::Mirror { shape, .. } => match shape {
                TriangleShape::Never { bits } => {
                    *shape = TriangleShape::Two { bits: *bits };
                    true
                }
                TriangleShape::Two { .. } | TriangleShape::Flat { .. } => false,
            },
            RootsClaim::All { .. } | RootsClaim::None { .. } | RootsClaim::One { .. } => false,
        })
    }),
    ("too few bits", |claim| {
        first(claim, |roots| match roots {
            RootsClaim::Mirror { shape, .. } => change_bits_of(shape, 8),
            RootsClaim::All { .. } | RootsClaim::None { .. } | RootsClaim::One { .. } => false,
        })
    }),
];

/// The first sign that a change fits.
fn first_sign(claim: &mut QuadraticClaim, change: impl Fn(&mut TriangleShape) -> bool) -> bool {
    claim.twist.iter_mut().flat_map(|twist| &mut twist.signs).any(change)
}

fn zeros(certificates: &[Certificate]) -> Vec<Certificate> {
    certificates.iter().map(|_| Certificate::Polygons { polygons: Vec::new() }).collect()
}

const TWISTS: [Cheat<QuadraticClaim>; 16] = [
    ("no twist", |claim| claim.twist.take().is_some()),
    ("no twist and no lengths", |claim| {
        claim.lengths.clear();
        claim.twist.take().is_some()
    }),
    ("no lengths beside a twist", |claim| {
        claim.lengths.clear();
        claim.twist.is_some()
    }),
    ("a twist whose lengths differ", |claim| {
        claim.lengths = zeros(&claim.coefficients);
        let new = TwistClaim { coefficients: claim.coefficients.clone(), signs: Vec::new() };
        claim.twist.replace(new).is_none() && claim.circle.is_some()
    }),
    ("a twist without a circle", |claim| {
        claim.roots.clear();
        claim.twist.is_some() && claim.circle.take().is_some()
    }),
    ("a coefficient of the twist without evidence", |claim| {
        claim.twist.as_mut().is_some_and(|twist| twist.coefficients.pop().is_some())
    }),
    ("forged evidence of the twist", |claim| {
        let twist = claim.twist.iter_mut().flat_map(|twist| &mut twist.coefficients);
        twist.map(|certificate| *certificate = forged(certificate)).count() > 0
    }),
    ("a coefficient of the twist omitted as zero", |claim| {
        let each = claim.twist.iter_mut().flat_map(|twist| &mut twist.coefficients);
        let last = each.filter(|certificate| !certificate.claims_zero()).last();
        last.map(|certificate| *certificate = Certificate::Polygons { polygons: Vec::new() }).is_some()
    }),
    ("no twist at all as one", |claim| {
        claim.twist.as_mut().map(|twist| twist.coefficients = zeros(&twist.coefficients)).is_some()
    }),
    ("the arcs about the twist itself", |claim| {
        claim.circle.as_mut().is_some_and(|circle| circle.divided.take().is_some())
    }),
    ("a sign omitted", |claim| claim.twist.as_mut().is_some_and(|twist| twist.signs.pop().is_some())),
    ("a sign too many", |claim| {
        claim.twist.as_mut().map(|twist| twist.signs.push(TriangleShape::Two { bits: 96 })).is_some()
    }),
    ("two at an irrational turn as none", |claim| {
        first_sign(claim, |sign| match sign {
            TriangleShape::Two { bits } => {
                *sign = TriangleShape::Never { bits: *bits };
                true
            }
            TriangleShape::Never { .. } | TriangleShape::Flat { .. } => false,
        })
    }),
    ("none at an irrational turn as two", |claim| {
        first_sign(claim, |sign| match sign {
            TriangleShape::Never { bits } => {
                *sign = TriangleShape::Two { bits: *bits };
                true
            }
            TriangleShape::Two { .. } | TriangleShape::Flat { .. } => false,
        })
    }),
    ("one at an irrational turn", |claim| {
        first_sign(claim, |sign| {
            *sign = TriangleShape::Flat { certificate: Certificate::Polygons { polygons: Vec::new() } };
            true
        })
    }),
    ("too few bits for a sign", |claim| first_sign(claim, |sign| change_bits_of(sign, 8))),
];

/// With the first crossing begun at an earlier turn, and another sign there.
fn begun(document: &OpenDocument, turn: [i64; 2], sign: &TriangleShape) -> OpenDocument {
    let (mut document, mut changed) = (document.clone(), 0);
    let start = BigRational::new(turn[0].into(), turn[1].into());
    for sum in document.open_verdicts.iter_mut().flat_map(|verdict| &mut verdict.sums) {
        let WhenClaim::Quadratic(claim) = &mut sum.when else { continue };
        let (Some(twist), Some(circle)) = (&mut claim.twist, &mut claim.circle) else { continue };
        let arcs = &mut circle.arcs;
        let crossing = arcs.iter().position(|arc| matches!(arc, ArcClaim::Crossing { .. })).expect("a crossing");
        let cut = arcs.iter().position(|arc| *arc.to() > start).expect("an arc");
        assert!(cut < crossing);
        arcs.splice(cut..crossing, [ArcClaim::Monotone { to: start.clone() }]);
        twist.signs[0] = sign.clone();
        changed += 1;
    }
    assert!(changed > 0);
    document
}

/// E vanishes at 75.52°, and `4|A|² − |B|²` at 72.88°.
#[test]
fn a_sign_holds_on_the_whole_of_its_crossing() {
    let document = document(&twists()[0], &[1]);
    let honest = begun(&document, [37, 180], &TriangleShape::Two { bits: 96 });
    check_open_document(&honest).expect("it holds");
    second::accepts(&[honest], &[]);
    let cheat = begun(&document, [1, 5], &TriangleShape::Never { bits: 96 });
    let fault = check_open_document(&cheat).expect_err("a sign that changes").to_string();
    assert!(fault.contains("no line keeps it away from 0"), "{fault}");
    second::refuses(&[("a sign that changes on its crossing", cheat)]);
}

#[test]
fn every_cheat_with_three_classes_is_caught() {
    let mut documents = quadratic_documents();
    // Each cheat is tried on the first documents that it fits, and long ones take the checkers long.
    documents.sort_by_key(|document| serde_json::to_string(document).expect("JSON").len());
    for document in &documents {
        let json = serde_json::to_string(document).expect("JSON");
        let read: OpenDocument = serde_json::from_str(&json).expect("it reads");
        assert_eq!(&read, document);
        check_open_document(&read).expect("it holds");
    }
    second::accepts(&documents, &[]);
    let is_quadratic = |when: &WhenClaim| matches!(when, WhenClaim::Quadratic(_));
    let is_twisted = |when: &WhenClaim| matches!(when, WhenClaim::Quadratic(claim) if claim.twist.is_some());
    let twisted = [document(&twists()[0], &[1])];
    for (name, cheat) in CLASSES {
        let change = |when: &mut WhenClaim| match when {
            WhenClaim::Quadratic(claim) => cheat(claim),
            _ => false,
        };
        tried(&twisted, name, is_twisted, change);
    }
    for (name, cheat) in CLASSES.into_iter().chain(ROOTS).chain(TWISTS) {
        let change = |when: &mut WhenClaim| match when {
            WhenClaim::Quadratic(claim) => cheat(claim),
            _ => false,
        };
        assert!(tried(&documents, name, is_quadratic, change) > 0, "never tried: {name}");
    }
    for other in [WhenClaim::Always, WhenClaim::Never] {
        let change = |when: &mut WhenClaim| {
            *when = other.clone();
            true
        };
        assert!(tried(&documents, "another kind", is_quadratic, change) > 0);
    }
}
