//! How is the work shared? Numbered pieces in rounds, on any number of threads, with one and the same outcome.
//!
//! The pieces of a round start from the front of all earlier rounds, whichever thread takes them and whenever; so the
//! front, its counts and the stars judged depend on the question alone.

use std::collections::BTreeMap;
use std::fmt;
use std::ops::ControlFlow;
use std::path::PathBuf;
use std::sync::atomic::{AtomicUsize, Ordering};
use std::sync::{Mutex, PoisonError};
use std::thread;

use super::answer::{self, Front};
use super::front::{Judge, Pareto};
use super::piece::Counts;
use super::plan::{Plan, Way};
use super::problem::{Problem, ProblemError};
use super::resume::{self, Done};
use super::space::Space;
use super::tables::Tables;

/// Pieces that start from the same front.
const ROUND: usize = 8;

/// How far a search is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Progress {
    /// Pieces finished, those of earlier runs too.
    pub done: usize,
    /// Pieces in all.
    pub pieces: usize,
    /// Stars judged.
    pub judged: u64,
}

/// How to search.
pub struct Options<'a> {
    /// Number of threads, at least 1.
    pub threads: usize,
    /// How the stars are gone through; the front is the same.
    pub way: Way,
    /// The file that keeps the finished pieces.
    pub resume: Option<PathBuf>,
    /// Told after each piece; a break stops the search.
    pub progress: &'a (dyn Fn(Progress) -> ControlFlow<()> + Sync),
}

impl Default for Options<'_> {
    /// One thread per available core, nothing kept, nothing told.
    fn default() -> Self {
        let threads = thread::available_parallelism().map_or(1, usize::from);
        Options { threads, way: Way::default(), resume: None, progress: &|_| ControlFlow::Continue(()) }
    }
}

/// Why a search has no front.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum SearchError {
    /// The question makes no sense.
    Problem(ProblemError),
    /// The state file cannot be read or written.
    State(String),
    /// Stopped by the progress callback.
    Stopped,
}

impl fmt::Display for SearchError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            SearchError::Problem(mistake) => mistake.fmt(f),
            SearchError::State(message) => f.write_str(message),
            SearchError::Stopped => f.write_str("stopped"),
        }
    }
}

impl std::error::Error for SearchError {}

/// Finds the exact Pareto front of a question: complete, ties counted.
///
/// # Errors
/// If the question makes no sense, the state file cannot be read or written, or the progress callback stops the search.
pub fn search(problem: &Problem, options: &Options) -> Result<Front, SearchError> {
    let space = Space::new(problem).map_err(SearchError::Problem)?;
    let (tables, plan) = Plan::new(&space, options.way);
    let read = |path| resume::read(path, problem, &space, &tables, &plan);
    let known = options.resume.as_deref().map(read).transpose().map_err(SearchError::State)?;
    let hall = Hall { problem, space: &space, tables: &tables, plan: &plan, options };
    let state = Mutex::new(State { done: known.unwrap_or_default(), failure: None });
    let mut front = Pareto::default();
    let mut counts = Counts::default();
    let mut start = 0;
    while start < plan.len() {
        // The first pieces start from little; each round may be as long as all before it.
        let end = plan.len().min(start + start.clamp(1, ROUND));
        hall.round(start..end, &front, &state)?;
        let held = state.lock().unwrap_or_else(PoisonError::into_inner);
        for done in held.done.range(start..end).map(|(_, done)| done) {
            done.points.iter().for_each(|point| front.take(point.clone()));
            counts = counts.plus(done.counts).unwrap_or_else(|| unreachable!("no search judges 2^64 stars"));
        }
        start = end;
    }
    Ok(answer::answer(problem, &space, front.points().to_vec(), counts))
}

struct State {
    done: BTreeMap<usize, Done>,
    failure: Option<SearchError>,
}

/// What all threads read.
struct Hall<'a> {
    problem: &'a Problem,
    space: &'a Space,
    tables: &'a Tables,
    plan: &'a Plan,
    options: &'a Options<'a>,
}

impl Hall<'_> {
    /// Finishes the pieces of a round that are not done yet.
    fn round(&self, round: std::ops::Range<usize>, front: &Pareto, state: &Mutex<State>) -> Result<(), SearchError> {
        let held = |state: &Mutex<State>| state.lock().unwrap_or_else(PoisonError::into_inner).failure.clone();
        let open: Vec<usize> = {
            let state = state.lock().unwrap_or_else(PoisonError::into_inner);
            round.filter(|number| !state.done.contains_key(number)).collect()
        };
        let next = AtomicUsize::new(0);
        let work = || {
            while let Some(&number) = open.get(next.fetch_add(1, Ordering::Relaxed)) {
                if held(state).is_some() {
                    return;
                }
                self.finish(number, front, state);
            }
        };
        thread::scope(|scope| {
            let helpers = self.options.threads.min(open.len()).saturating_sub(1);
            // Where no thread is to be had the work is done here.
            (0..helpers).for_each(|_| drop(thread::Builder::new().spawn_scoped(scope, work)));
            work();
        });
        held(state).map_or(Ok(()), Err)
    }

    fn finish(&self, number: usize, front: &Pareto, state: &Mutex<State>) {
        let (own, counts) = self.plan.run(number, self.space, self.tables, front.uncounted());
        let points = own.points().iter().filter(|point| point.classes > 0).cloned().collect();
        let mut state = state.lock().unwrap_or_else(PoisonError::into_inner);
        state.done.insert(number, Done { points, counts });
        let written = self.options.resume.as_deref();
        let written = written.map(|path| resume::write(path, self.problem, &state.done, self.plan));
        if let Some(Err(message)) = written {
            state.failure = Some(SearchError::State(message));
        }
        let judged = state.done.values().map(|done| done.counts.judged).sum();
        let progress = Progress { done: state.done.len(), pieces: self.plan.len(), judged };
        if (self.options.progress)(progress).is_break() && state.failure.is_none() {
            state.failure = Some(SearchError::Stopped);
        }
    }
}
