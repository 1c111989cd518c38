//! How is a person told that a long command still works? On a terminal only, on standard error, and gone before anything is printed.

use std::io::IsTerminal;
use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::mpsc::{self, RecvTimeoutError, Sender};
use std::sync::{Mutex, MutexGuard, PoisonError};
use std::thread::{self, JoinHandle};
use std::time::Duration;

use indicatif::{ProgressBar, ProgressStyle};

/// What takes no longer than this is not told.
const PATIENCE: Duration = Duration::from_millis(500);
/// How often the spinner moves.
const TICK: Duration = Duration::from_millis(200);

/// The spinner that is shown, or will be.
static SPINNER: Mutex<Option<Spinner>> = Mutex::new(None);

/// Whether nothing is to be told but why there is no answer.
static IS_SILENT: AtomicBool = AtomicBool::new(false);

/// A spinner turns in a thread of its own until it is told to stop.
struct Spinner {
    stop: Sender<()>,
    turning: JoinHandle<()>,
}

/// From now on neither progress nor warnings are reported.
pub fn silence() {
    IS_SILENT.store(true, Ordering::Relaxed);
}

/// Whether [`silence`] was asked for.
pub fn is_silent() -> bool {
    IS_SILENT.load(Ordering::Relaxed)
}

/// A bar of this many pieces with the time left, in the place of the spinner.
pub fn bar(pieces: &str) -> ProgressBar {
    end();
    with_style(&format!("{{bar:40}} {{pos}}/{{len}} {pieces}, {{eta}} left"))
}

/// From now on these words tell what is being done, and for how long, until [`end`].
pub fn doing(words: &'static str) {
    end();
    if !is_shown() {
        return;
    }
    let (stop, told) = mpsc::channel();
    let turning = thread::spawn(move || {
        if told.recv_timeout(PATIENCE) != Err(RecvTimeoutError::Timeout) {
            return;
        }
        let spinner = with_style("{spinner} {msg}, {elapsed}").with_message(words).with_elapsed(PATIENCE);
        spinner.tick();
        while told.recv_timeout(TICK) == Err(RecvTimeoutError::Timeout) {
            spinner.tick();
        }
        spinner.finish_and_clear();
    });
    *spinner() = Some(Spinner { stop, turning });
}

/// The spinner goes away.
pub fn end() {
    if let Some(Spinner { stop, turning }) = spinner().take() {
        drop(stop);
        // It cannot be told of a spinner that failed, and the answer does not hang on it.
        let _ = turning.join();
    }
}

/// Whether anything is reported beside the answer: on a terminal, unless it is to be quiet.
pub fn is_shown() -> bool {
    !is_silent() && std::io::stderr().is_terminal()
}

fn spinner() -> MutexGuard<'static, Option<Spinner>> {
    SPINNER.lock().unwrap_or_else(PoisonError::into_inner)
}

fn with_style(template: &str) -> ProgressBar {
    if !is_shown() {
        return ProgressBar::hidden();
    }
    let style = ProgressStyle::with_template(template);
    style.map_or_else(|_| ProgressBar::new(0), |style| ProgressBar::new(0).with_style(style))
}
