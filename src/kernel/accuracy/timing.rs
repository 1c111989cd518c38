//! How long does an evaluation take?

use std::hint::black_box;
use std::time::{Duration, Instant};

/// Evaluations whose times are compared.
const REPEATS: usize = 7;
/// Short evaluations are timed together, so many that they take about this long.
const BATCH: Duration = Duration::from_micros(500);

/// A longer evaluation is timed once.
const LONGEST: Duration = Duration::from_millis(20);

/// Whether evaluations are timed, which takes several of each and a clock.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Timing {
    /// Each is run once.
    Off,
    /// Each is run until its time is known.
    On,
}

/// The result, and the median time where it is wanted.
pub fn measured<T>(timing: Timing, run: impl Fn() -> T) -> (T, Option<Duration>) {
    if timing == Timing::Off {
        return (run(), None);
    }
    let start = Instant::now();
    let result = run();
    let first = start.elapsed().max(Duration::from_nanos(1));
    if first > LONGEST {
        return (result, Some(first));
    }
    let batch = (BATCH.as_nanos() / first.as_nanos()).clamp(1, 100_000) as u32;
    let mut times: Vec<Duration> = (0..REPEATS)
        .map(|_| {
            let start = Instant::now();
            for _ in 0..batch {
                black_box(run());
            }
            start.elapsed() / batch
        })
        .collect();
    times.sort_unstable();
    (result, Some(times[REPEATS / 2]))
}
