//! Progress over the rows of an area: a line on standard error every five seconds.

use std::sync::atomic::{AtomicUsize, Ordering};
use std::sync::{Mutex, PoisonError};
use std::time::{Duration, Instant};

use command_line::output::tell;

/// Time between two lines.
const EVERY: Duration = Duration::from_secs(5);

/// Counts rows and says how many are done.
pub struct Rows {
    all: usize,
    done: AtomicUsize,
    /// When a line was last said; `None` where nothing is to be said.
    last: Option<Mutex<Instant>>,
}

impl Rows {
    /// Counts up to `all` rows, in silence unless `is_wanted`.
    pub fn new(all: usize, is_wanted: bool) -> Self {
        let last = is_wanted.then(|| Mutex::new(Instant::now()));
        Self { all, done: AtomicUsize::new(0), last }
    }

    /// Hears that a row is done.
    pub fn hear(&self) {
        let done = self.done.fetch_add(1, Ordering::Relaxed) + 1;
        let Some(last) = &self.last else { return };
        let mut last = last.lock().unwrap_or_else(PoisonError::into_inner);
        if last.elapsed() >= EVERY {
            *last = Instant::now();
            tell(&format!("rows {done}/{}  {} %\n", self.all, 100 * done / self.all.max(1)));
        }
    }
}
