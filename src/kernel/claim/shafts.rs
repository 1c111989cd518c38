//! Which balancer shafts does an order need, and is that what is claimed?

use super::answer::{Answer, Evidence, Status};
use super::error::ClaimError;
use super::finding::Finding;
use super::ordinal::order_number;
use super::statement::{Shafts, Statement};
use crate::engine::Engine;
use crate::proof::{Quantity, Sense};
use crate::remedy::{Request, remedy};
use crate::verdict::{Judgement, OrderVerdict, both_vanish};

/// What may be claimed, in words.
const NEEDS: [(&str, Shafts); 9] = [
    ("nothing", Shafts::Nothing),
    ("no balancer shaft", Shafts::None),
    ("counterweights alone", Shafts::Counterweights),
    ("one balancer shaft with the crank", Shafts::With),
    ("one balancer shaft against the crank", Shafts::Against),
    ("a balancer shaft with the crank", Shafts::AmongThemWith),
    ("a balancer shaft against the crank", Shafts::AmongThemAgainst),
    ("two balancer shafts", Shafts::Two),
    ("a lanchester pair", Shafts::Lanchester),
];

const OWN: &str =
    "the engine has weights of this order, which the remedy resizes or takes away: claim what it needs without them";

const SLIGHT: &str = "weights of less than a millionth of the load are not proposed, and whether the two shafts would be alike is not decided";

/// `order 2 needs a Lanchester pair`; none where the words are of another claim.
pub(super) fn parse(text: &str) -> Option<Result<Statement, ClaimError>> {
    let (order, needs) = text.strip_prefix("order ")?.split_once(" needs ")?;
    let order = match order_number(order) {
        Ok(order) => order,
        Err(mistake) => return Some(Err(mistake)),
    };
    let found = NEEDS.iter().find(|(words, _)| *words == needs);
    Some(match found {
        Some((_, shafts)) => Ok(Statement::Shafts { order, shafts: *shafts }),
        None => Err(ClaimError::new(
            format!("`{needs}` is not something that an order needs"),
            "nothing, no balancer shaft, counterweights alone, one balancer shaft with (or against) the crank, a balancer \
             shaft with (or against) the crank and perhaps others, two balancer shafts, or a Lanchester pair",
        )),
    })
}

/// Finds the least set of shafts for the order, beside counterweights where it is order 1.
pub(super) fn answer(engine: &Engine, order: u32, claimed: Shafts) -> Answer {
    let judged = match Judgement::new(engine, &[order], &Quantity::PLANAR) {
        Ok(judged) => judged,
        Err(number) => return Answer::nothing(number.to_string()),
    };
    let Some(verdict) = judged.orders.first() else { return Answer::nothing("no order was decided") };
    let Some([direct, reverse]) = left(verdict) else {
        return Answer::nothing("whether the residual of the order vanishes is not decided");
    };
    let remedy = match remedy(engine, &Request { orders: vec![order], ..Request::default() }) {
        Ok(remedy) => remedy,
        Err(refused) => return Answer::nothing(refused.to_string()),
    };
    if remedy.resized().any(|plane| !plane.becomes.is_on_the_crank() || plane.becomes.vector.vanishes()) {
        return Answer::nothing(OWN);
    }
    // Counterweights on a crankshaft are the shaft that turns as it does.
    let with = direct && !engine.has_crank_turning(order, Sense::Direct);
    let against = reverse && !engine.has_crank_turning(order, Sense::Reverse);
    // Of a vector too slight for a weight nothing is proposed, and it is there.
    let has_shaft = |sense| remedy.shafts.iter().any(|shaft| shaft.sense == sense);
    let is_proposed = (!with || has_shaft(Sense::Direct)) && (!against || has_shaft(Sense::Reverse));
    let is_so = match claimed {
        Shafts::Nothing => !direct && !reverse,
        Shafts::None => !with && !against,
        Shafts::Counterweights => (direct || reverse) && !with && !against,
        Shafts::With => with && !against,
        Shafts::Against => !with && against,
        Shafts::AmongThemWith => with,
        Shafts::AmongThemAgainst => against,
        Shafts::Two => with && against,
        Shafts::Lanchester if with && against && !is_proposed => return Answer::nothing(SLIGHT),
        Shafts::Lanchester => with && against && remedy.shafts.iter().all(|shaft| shaft.lanchester),
    };
    let finding = match is_proposed {
        true => Finding::Remedy(Box::new(remedy)),
        false => Finding::CombinedOrders(vec![verdict.clone()]),
    };
    Answer { status: Status::of(is_so), finding, evidence: evidence(verdict) }
}

/// Whether the direct and the reverse vector of force or moment are left; none where that is not decided.
fn left(order: &OrderVerdict) -> Option<[bool; 2]> {
    if !order.exists() {
        return Some([false, false]);
    }
    let of_sense = |sense: usize| {
        let [force, moment] = [&order.force, &order.moment].map(|whole| whole.outcomes[sense].vanishes());
        both_vanish(force, moment).map(|vanish| !vanish)
    };
    Some([of_sense(0)?, of_sense(1)?])
}

/// The verdicts that the answer rests on.
pub(super) fn evidence(order: &OrderVerdict) -> Vec<Evidence> {
    let parts = order.parts.iter().filter(|part| part.exists);
    let verdicts = parts.flat_map(|part| [&part.force, &part.moment].into_iter().flat_map(|one| one.verdicts()));
    verdicts.map(|verdict| Evidence::Verdict(verdict.clone())).collect()
}
