//! Buffers that are used again.

use std::sync::{Mutex, MutexGuard, PoisonError};

/// Buffers that wait for the next who needs one; what they held last never matters.
///
/// Whoever comes back gets one that the same thread has left, if there is any: it is still in the cache of its core.
pub(crate) struct Pool<T>(Mutex<Vec<(Option<usize>, T)>>);

impl<T: Default> Pool<T> {
    /// One of them, or a new one.
    pub fn take(&self) -> T {
        let (thread, mut waiting) = (rayon::current_thread_index(), self.waiting());
        let own = waiting.iter().rposition(|(left_by, _)| *left_by == thread);
        own.or(waiting.len().checked_sub(1)).map(|number| waiting.remove(number).1).unwrap_or_default()
    }

    /// Leaves one to the next.
    pub fn give_back(&self, buffer: T) {
        self.waiting().push((rayon::current_thread_index(), buffer));
    }

    fn waiting(&self) -> MutexGuard<'_, Vec<(Option<usize>, T)>> {
        self.0.lock().unwrap_or_else(PoisonError::into_inner)
    }
}

impl<T> Default for Pool<T> {
    fn default() -> Self {
        Self(Mutex::default())
    }
}
