//! The threads that draw.

use std::error::Error;
use std::io;
use std::sync::{Arc, Mutex, PoisonError};

use rayon::{ThreadPool, ThreadPoolBuildError, ThreadPoolBuilder};

/// So many threads, as many as there are processors if 0. Where the system has no threads, as in a page, the calling thread draws alone.
///
/// # Errors
/// If the system refuses to start them.
pub(crate) fn pool(threads: usize) -> Result<Arc<ThreadPool>, ThreadPoolBuildError> {
    match ThreadPoolBuilder::new().num_threads(threads).build() {
        Err(error) if is_unsupported(&error) => calling_thread(),
        built => built.map(Arc::new),
    }
}

fn is_unsupported(error: &ThreadPoolBuildError) -> bool {
    let source = error.source().and_then(|source| source.downcast_ref::<io::Error>());
    source.is_some_and(|source| source.kind() == io::ErrorKind::Unsupported)
}

/// A thread joins one pool and never leaves it, so all drives share this one.
static CALLING: Mutex<Option<Arc<ThreadPool>>> = Mutex::new(None);

fn calling_thread() -> Result<Arc<ThreadPool>, ThreadPoolBuildError> {
    let mut calling = CALLING.lock().unwrap_or_else(PoisonError::into_inner);
    if let Some(pool) = &*calling {
        return Ok(Arc::clone(pool));
    }
    let pool = Arc::new(ThreadPoolBuilder::new().num_threads(1).use_current_thread().build()?);
    *calling = Some(Arc::clone(&pool));
    Ok(pool)
}
