//! Where is a smooth function largest that costs much? By parabolas through its best places, by golden sections where they do not help.
//!
//! R. P. Brent, Algorithms for Minimization without Derivatives, 1973, chapter 5.

/// The bracket is narrowed to this part: of a smooth top less than roundings of the values tell apart, of a kink the place.
const NEAR: f64 = 1e-7;
/// Golden sections alone would take 34 steps.
const MOST_STEPS: usize = 100;

/// A place with its value.
#[derive(Clone, Copy)]
struct Known {
    at: f64,
    value: f64,
}

/// Where a function with one top between two places is largest: some ten values where it is smooth there.
pub fn top_between(mut low: f64, mut high: f64, value: impl Fn(f64) -> f64) -> f64 {
    let smaller_part = (3.0 - 5.0_f64.sqrt()) / 2.0;
    let near = NEAR * (high - low);
    let know = |at: f64| Known { at, value: value(at) };
    let mut best = know(low + smaller_part * (high - low));
    let (mut second, mut third) = (best, best);
    let (mut step, mut step_before): (f64, f64) = (0.0, 0.0);
    for _ in 0..MOST_STEPS {
        let middle = (low + high) / 2.0;
        if (best.at - middle).abs() + (high - low) / 2.0 <= 2.0 * near {
            break;
        }
        // Parabolas whose steps do not shrink by half every other time lead nowhere.
        let to_top = to_top_of_parabola([best, second, third]);
        let shrinks = |to_top: &f64| step_before.abs() > near && to_top.abs() < step_before.abs() / 2.0;
        let to_end = |to_top: f64| (best.at + to_top - low).min(high - best.at - to_top);
        (step_before, step) = match to_top.filter(shrinks).filter(|to_top| to_end(*to_top) > 0.0) {
            Some(to_top) if to_end(to_top) < 2.0 * near => (step, near.copysign(middle - best.at)),
            Some(to_top) => (step, to_top),
            None => {
                let larger = if best.at < middle { high - best.at } else { low - best.at };
                (larger, smaller_part * larger)
            }
        };
        let next = know(best.at + step.signum() * step.abs().max(near));
        if next.value >= best.value {
            *(if next.at < best.at { &mut high } else { &mut low }) = best.at;
            (third, second, best) = (second, best, next);
        } else {
            *(if next.at < best.at { &mut low } else { &mut high }) = next.at;
            if next.value >= second.value || second.at == best.at {
                (third, second) = (second, next);
            } else if next.value >= third.value || third.at == best.at || third.at == second.at {
                third = next;
            }
        }
    }
    best.at
}

/// How far the top of the parabola through three places is from the first of them; none where they lie on a line.
fn to_top_of_parabola([best, second, third]: [Known; 3]) -> Option<f64> {
    let (a, b) = (second.at - best.at, third.at - best.at);
    let (falls_a, falls_b) = (best.value - second.value, best.value - third.value);
    let below = 2.0 * (b * falls_a - a * falls_b);
    let to_top = (b * b * falls_a - a * a * falls_b) / below;
    to_top.is_finite().then_some(to_top)
}
