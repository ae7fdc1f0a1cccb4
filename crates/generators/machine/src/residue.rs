//! Stores and pictures of the last frames, kept as long as a tube may show what is left of them.

use std::sync::{Arc, Mutex, MutexGuard, PoisonError};

use control_plane::FramePlan;

/// A store, and the plan by which it was written.
pub(crate) type Written = (FramePlan, Vec<f32>);

/// Something of each of the last frames. What is kept changes no bit: what is gone is drawn again.
#[derive(Debug)]
pub(crate) struct Recent<T>(Mutex<Vec<(u64, Arc<T>)>>);

impl<T> Recent<T> {
    /// That of a frame, if it is still there.
    pub fn get(&self, frame: u64) -> Option<Arc<T>> {
        let kept = self.kept();
        kept.iter().find(|(known, _)| *known == frame).map(|(_, found)| Arc::clone(found))
    }

    /// Keeps that of a frame, and of all the `most` last kept.
    pub fn keep(&self, frame: u64, value: Arc<T>, most: usize) {
        let mut kept = self.kept();
        kept.retain(|(known, _)| *known != frame);
        kept.push((frame, value));
        let surplus = kept.len().saturating_sub(most);
        kept.drain(..surplus);
    }

    fn kept(&self) -> MutexGuard<'_, Vec<(u64, Arc<T>)>> {
        self.0.lock().unwrap_or_else(PoisonError::into_inner)
    }
}

impl<T> Default for Recent<T> {
    fn default() -> Self {
        Self(Mutex::default())
    }
}
