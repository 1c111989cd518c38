//! How do several threads make pieces that one takes in order? Each the next one, and none too far ahead.

use std::collections::BTreeMap;
use std::num::NonZero;
use std::sync::{Condvar, Mutex, PoisonError};
use std::thread;

/// Pieces that may wait to be taken, for each thread.
const AHEAD: usize = 2;

/// What the threads share.
struct Line<T, E> {
    /// The place in the list of the next piece to be made.
    next: usize,
    /// The place of the next to be taken.
    taken: usize,
    /// What is made and waits.
    made: BTreeMap<usize, Result<T, E>>,
    /// Whether nobody takes any more.
    stopped: bool,
}

/// How many threads a machine has cores for.
pub fn cores() -> usize {
    thread::available_parallelism().map_or(1, NonZero::get)
}

/// Makes the pieces of a list on this many threads, and takes each in the order of the list; memory holds a few at a time.
///
/// # Errors
/// The first in the order of the list that cannot be made, or be taken.
pub fn in_order<T: Send, E: Send>(
    threads: usize,
    list: &[usize],
    make: &(dyn Fn(usize) -> Result<T, E> + Sync),
    take: &mut dyn FnMut(usize, T) -> Result<(), E>,
) -> Result<(), E> {
    let threads = threads.min(list.len());
    let line = Mutex::new(Line { next: 0, taken: 0, made: BTreeMap::new(), stopped: false });
    let moved = Condvar::new();
    let held = || line.lock().unwrap_or_else(PoisonError::into_inner);
    let next = || {
        let mut line = held();
        loop {
            if line.stopped || line.next == list.len() {
                return None;
            }
            if line.next < line.taken + AHEAD * threads {
                line.next += 1;
                return Some(line.next - 1);
            }
            line = moved.wait(line).unwrap_or_else(PoisonError::into_inner);
        }
    };
    let work = || {
        while let Some(place) = next() {
            // A thread that dies must not leave the one that takes waiting.
            let made = std::panic::catch_unwind(std::panic::AssertUnwindSafe(|| make(list[place])));
            let mut line = held();
            match made {
                Ok(made) => drop(line.made.insert(place, made)),
                Err(panic) => {
                    line.stopped = true;
                    moved.notify_all();
                    drop(line);
                    std::panic::resume_unwind(panic);
                }
            }
            moved.notify_all();
        }
    };
    thread::scope(|scope| {
        // Where no thread is to be had the work is done here.
        let helpers = (0..threads).filter(|_| thread::Builder::new().spawn_scoped(scope, work).is_ok()).count();
        let outcome = (0..list.len()).try_for_each(|place| {
            if helpers == 0 {
                return make(list[place]).and_then(|made| take(list[place], made));
            }
            let mut line = held();
            let made = loop {
                match line.made.remove(&place) {
                    Some(made) => break made,
                    // Only a thread that died stops the line; the scope tells of it.
                    None if line.stopped => return Ok(()),
                    None => line = moved.wait(line).unwrap_or_else(PoisonError::into_inner),
                }
            };
            line.taken = place + 1;
            drop(line);
            moved.notify_all();
            take(list[place], made?)
        });
        held().stopped = true;
        moved.notify_all();
        outcome
    })
}
