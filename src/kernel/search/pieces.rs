//! How is the work shared, among threads and among machines? Numbered pieces, each the same whoever judges it.
//!
//! The first pieces are evaluated one after another, each from the front of those before; all others start from the front of these.
//! So what comes of a piece, and with it the front, its counts and the stars judged, depends on the question alone.

use std::collections::BTreeSet;
use std::ops::ControlFlow;
use std::path::{Path, PathBuf};
use std::sync::OnceLock;

use super::answer::{self, Front};
use super::front::{Judge, Pareto};
use super::options::{Options, Progress, SearchError};
use super::plan::{Plan, Way};
use super::problem::{Problem, ProblemError};
use super::space::Space;
use super::tables::Tables;
use super::walk::Counts;
use super::written::{self, Done};
use crate::shard::{Merged, Question, Shard, Store, in_order};
use crate::text::harmless;

/// Pieces that every machine judges for itself, to start the others from.
const FIRST: usize = 8;

/// A question cut into numbered pieces.
pub struct Pieces<'a> {
    problem: &'a Problem,
    space: Space,
    tables: Tables,
    plan: Plan,
    first: OnceLock<First>,
}

/// The pieces that each machine judges, and their front.
#[derive(Default)]
struct First {
    done: Vec<Done>,
    front: Pareto,
}

impl<'a> Pieces<'a> {
    /// Cuts a question into pieces.
    ///
    /// # Errors
    /// If the question makes no sense.
    pub fn new(problem: &'a Problem, way: Way) -> Result<Self, ProblemError> {
        let space = Space::new(problem)?;
        let (tables, plan) = Plan::new(&space, way);
        Ok(Pieces { problem, space, tables, plan, first: OnceLock::new() })
    }

    /// What the pieces are parts of.
    pub fn question(&self) -> Question {
        written::question(self.problem, &self.plan)
    }

    /// Those pieces, but for what is stopped.
    fn first(&self, options: &Options) -> &First {
        self.first.get_or_init(|| {
            let mut first = First::default();
            for number in (0..self.plan.len().min(FIRST)).take_while(|_| !options.is_stopped()) {
                let done = self.judge(number, &first.front);
                done.points.iter().for_each(|point| first.front.take(point.clone()));
                first.done.push(done);
            }
            first
        })
    }

    fn judge(&self, number: usize, front: &Pareto) -> Done {
        let (own, counts) = self.plan.run(number, &self.space, &self.tables, front.uncounted());
        Done { points: own.points().iter().filter(|point| point.classes > 0).cloned().collect(), counts }
    }

    /// Judges pieces on several threads, and takes each in the order of the list; this many others were done before.
    fn each(
        &self,
        list: &[usize],
        before: usize,
        options: &Options,
        take: &mut dyn FnMut(usize, &Done) -> Result<(), SearchError>,
    ) -> Result<(), SearchError> {
        if list.is_empty() {
            return Ok(());
        }
        let mut progress = Progress { done: before, pieces: before + list.len(), judged: 0 };
        let first = self.first(options);
        let make = |number| match options.is_stopped() {
            true => Err(SearchError::Stopped),
            false => Ok(first.done.get(number).cloned().unwrap_or_else(|| self.judge(number, &first.front))),
        };
        in_order(options.threads, list, &make, &mut |number, done: Done| {
            take(number, &done)?;
            progress.done += 1;
            progress.judged += done.counts.judged;
            match (options.progress)(progress) {
                ControlFlow::Continue(()) => Ok(()),
                ControlFlow::Break(()) => Err(SearchError::Stopped),
            }
        })
    }

    /// Judges all pieces.
    pub(super) fn front(&self, options: &Options) -> Result<Front, SearchError> {
        let mut sum = Sum::default();
        let all: Vec<usize> = (0..self.plan.len()).collect();
        self.each(&all, 0, options, &mut |_, done| {
            sum.add(done, &self.space).ok_or_else(|| unreachable!("this many stars exist"))
        })?;
        Ok(self.answer(sum))
    }

    /// Judges the pieces of a shard that its file lacks, and keeps each: what is in the file survives any stop.
    ///
    /// # Errors
    /// If the file cannot be read or written, is damaged or of something else, or the progress callback stops the search.
    pub fn keep(&self, shard: Shard, path: &Path, options: &Options) -> Result<(), SearchError> {
        let mut store = Store::open(path, &self.question(), shard).map_err(SearchError::Pieces)?;
        let there: BTreeSet<usize> = store.pieces();
        let of_shard = (0..self.plan.len()).filter(|piece| shard.takes(*piece));
        let list: Vec<usize> = of_shard.filter(|piece| !there.contains(piece)).collect();
        self.each(&list, there.len(), options, &mut |number, done| {
            let text = written::text(done).map_err(|error| SearchError::NotWritten(error.to_string()))?;
            store.put(number, text.as_bytes()).map_err(SearchError::Pieces)
        })?;
        store.finish().map_err(SearchError::Pieces)
    }

    /// The front of the pieces that these files hold, in any order.
    ///
    /// # Errors
    /// If a piece is missing, or a file is damaged, not finished or of something else.
    pub fn merged(&self, paths: &[PathBuf]) -> Result<Front, SearchError> {
        let merged = Merged::open(paths, &self.question()).and_then(Merged::whole).map_err(SearchError::Pieces)?;
        let mut sum = Sum::default();
        for number in merged.pieces() {
            let text = merged.read(number).map_err(SearchError::Pieces)?;
            let done = written::read(&text, number, &self.plan, &self.space, &self.tables);
            let added = done.and_then(|done| sum.add(&done, &self.space));
            added.ok_or_else(|| {
                let files: Vec<_> = paths.iter().map(|path| harmless(&path.to_string_lossy())).collect();
                SearchError::DoesNotFit { piece: number, files: files.join("`, `") }
            })?;
        }
        Ok(self.answer(sum))
    }

    fn answer(&self, sum: Sum) -> Front {
        answer::answer(self.problem, &self.space, sum.front.points().to_vec(), sum.counts)
    }
}

/// What several pieces come to together.
#[derive(Default)]
struct Sum {
    front: Pareto,
    counts: Counts,
}

impl Sum {
    /// Adds a piece; nothing where that is more than there can be.
    fn add(&mut self, done: &Done, space: &Space) -> Option<()> {
        self.counts = self.counts.plus(done.counts).filter(|sum| written::is_possible(*sum, space))?;
        done.points.iter().for_each(|point| self.front.take(point.clone()));
        Some(())
    }
}

/// Finds the exact Pareto front of a question: complete, ties counted.
///
/// # Errors
/// If the question makes no sense, the file of pieces cannot be read or written, or the progress callback stops the search.
pub fn search(problem: &Problem, options: &Options) -> Result<Front, SearchError> {
    let pieces = Pieces::new(problem, options.way).map_err(SearchError::Problem)?;
    match &options.resume {
        None => pieces.front(options),
        Some(path) => {
            pieces.keep(Shard::WHOLE, path, options)?;
            pieces.merged(std::slice::from_ref(path))
        }
    }
}
