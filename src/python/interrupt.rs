//! How does an interrupt from the keyboard stop what takes long? The work is done in a thread of its own, and Python is asked meanwhile.

use std::any::Any;
use std::panic::{AssertUnwindSafe, catch_unwind, resume_unwind};
use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::mpsc::{self, RecvTimeoutError};
use std::sync::{Arc, Mutex, PoisonError};
use std::thread;
use std::time::Duration;

use pyo3::prelude::*;

use super::error::told;

/// How often Python is asked whether somebody wants to stop.
const ASKED_EVERY: Duration = Duration::from_millis(50);

/// Does work without the lock of the interpreter. An interrupt raises at once; the work, which the flag tells to stop, ends by itself.
pub(super) fn interruptible<T: Send + 'static>(
    py: Python<'_>,
    work: impl FnOnce(&AtomicBool) -> PyResult<T> + Send + 'static,
) -> PyResult<T> {
    type Made<T> = Result<PyResult<T>, Box<dyn Any + Send>>;
    let stop = Arc::new(AtomicBool::new(false));
    let (done, outcome) = mpsc::sync_channel::<Made<T>>(1);
    let outcome = Mutex::new(outcome);
    let flag = Arc::clone(&stop);
    let started = thread::Builder::new().spawn(move || {
        // Who was interrupted waits for nothing any more.
        let _ = done.send(catch_unwind(AssertUnwindSafe(|| work(&flag))));
    });
    started.map_err(told)?;
    loop {
        let wait = || outcome.lock().unwrap_or_else(PoisonError::into_inner).recv_timeout(ASKED_EVERY);
        match py.detach(wait) {
            Ok(Ok(made)) => return made,
            Ok(Err(panic)) => resume_unwind(panic),
            Err(RecvTimeoutError::Disconnected) => return Err(told("the work ended without an answer")),
            Err(RecvTimeoutError::Timeout) => {
                py.check_signals().inspect_err(|_| stop.store(true, Ordering::Relaxed))?;
            }
        }
    }
}
