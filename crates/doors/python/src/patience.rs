//! Work without the interpreter, which Ctrl-C ends.

use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::mpsc::{RecvTimeoutError, channel};
use std::thread;
use std::time::Duration;

use drive::DriveError;
use pyo3::prelude::*;

use crate::errors::raise;

/// Time between two looks for a signal.
const EVERY: Duration = Duration::from_millis(50);

/// `work` without the interpreter. A signal that came meanwhile is obeyed when the work is done: one frame, one plane of truth.
pub fn released<T: Send>(py: Python<'_>, work: impl FnOnce() -> Result<T, DriveError> + Send) -> PyResult<T> {
    let done = py.detach(work).map_err(|error| raise(py, &error));
    py.check_signals()?;
    done
}

/// The same for work of many steps, which asks its argument before each step whether it goes on.
pub fn obedient<T: Send>(
    py: Python<'_>,
    work: impl FnOnce(&mut (dyn FnMut() -> bool + Send)) -> Result<T, DriveError> + Send,
) -> PyResult<T> {
    let goes_on = AtomicBool::new(true);
    let (tell, hear) = channel();
    let (done, interrupted) = thread::scope(|scope| {
        let goes_on = &goes_on;
        scope.spawn(move || tell.send(work(&mut || goes_on.load(Ordering::Relaxed))));
        let (mut interrupted, mut hear) = (None, hear);
        loop {
            let heard;
            (hear, heard) = py.detach(move || {
                let heard = hear.recv_timeout(EVERY);
                (hear, heard)
            });
            match heard {
                Ok(done) => return (Some(done), interrupted),
                Err(RecvTimeoutError::Disconnected) => return (None, interrupted),
                Err(RecvTimeoutError::Timeout) => {}
            }
            if let Err(signal) = py.check_signals() {
                goes_on.store(false, Ordering::Relaxed);
                interrupted = Some(signal);
            }
        }
    });
    match (interrupted, done) {
        (Some(signal), _) => Err(signal),
        (None, Some(done)) => done.map_err(|error| raise(py, &error)),
        (None, None) => Err(pyo3::exceptions::PyRuntimeError::new_err("the work ended without a result")),
    }
}
