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

#[cfg(test)]
mod tests {
    use super::Pool;

    #[test]
    fn a_thread_gets_back_what_it_left_as_long_as_there_is_any() {
        let (pool, threads) =
            (Pool::default(), rayon::ThreadPoolBuilder::new().num_threads(1).build().unwrap());
        pool.give_back("outside");
        threads.install(|| pool.give_back("within"));
        pool.give_back("outside again");
        assert_eq!(threads.install(|| pool.take()), "within");
        assert_eq!(pool.take(), "outside again");
        assert_eq!(threads.install(|| pool.take()), "outside");
        assert_eq!(pool.take(), "");
    }
}
