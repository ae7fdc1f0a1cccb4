//! Pictures as they were written, kept as long as a tube may show what is left of them.

use std::sync::{Arc, Mutex, PoisonError};

use control_plane::FramePlan;

/// A store, and the plan by which it was written.
pub(crate) type Written = (FramePlan, Vec<f32>);

/// The last stores, with their frames. What is kept changes no bit: a store that is gone is drawn again.
#[derive(Debug, Default)]
pub(crate) struct Recent {
    stores: Mutex<Vec<(u64, Arc<Written>)>>,
}

impl Recent {
    /// The store of a frame, if it is still there.
    pub fn get(&self, frame: u64) -> Option<Arc<Written>> {
        let stores = self.stores.lock().unwrap_or_else(PoisonError::into_inner);
        stores.iter().find(|(known, _)| *known == frame).map(|(_, store)| Arc::clone(store))
    }

    /// Keeps a store, and of all the `most` last kept.
    pub fn keep(&self, frame: u64, store: Arc<Written>, most: usize) {
        let mut stores = self.stores.lock().unwrap_or_else(PoisonError::into_inner);
        stores.retain(|(known, _)| *known != frame);
        stores.push((frame, store));
        let surplus = stores.len().saturating_sub(most);
        stores.drain(..surplus);
    }
}
