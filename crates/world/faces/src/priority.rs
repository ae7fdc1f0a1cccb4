//! Which list wins a sample: by number of the list, or by depth.

use std::collections::BTreeMap;

use crate::error::FaceError;

/// How lists that cover one sample are ordered.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Order {
    /// The lowest number of a list wins; inside a list the face stored first (reported).
    Lists,
    /// The nearest face wins, whatever its list; of equally near ones the one stored first.
    Depth,
}

/// A face that covers a sample.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Cover {
    /// Priority of its list.
    pub priority: i32,
    /// Depth from the eye (m).
    pub depth: f64,
}

impl Order {
    /// Which of the faces at a sample is seen, as its place in `covers`, which stand in stored order; `None` where there are none.
    pub fn seen(self, covers: &[Cover]) -> Option<usize> {
        let numbers = 0..covers.len();
        match self {
            Self::Lists => numbers.min_by_key(|&k| covers[k].priority),
            Self::Depth => numbers.min_by(|&a, &b| covers[a].depth.total_cmp(&covers[b].depth)),
        }
    }

    /// Whether the two orders show different faces at a sample.
    pub fn disagree(covers: &[Cover]) -> bool {
        Self::Lists.seen(covers) != Self::Depth.seen(covers)
    }
}

/// Refuses two lists of the same priority.
///
/// # Errors
/// Names the first two lists that share a number.
pub fn check_priorities<'a>(lists: impl IntoIterator<Item = (&'a str, i32)>) -> Result<(), FaceError> {
    let mut taken = BTreeMap::new();
    for (name, priority) in lists {
        if let Some(other) = taken.insert(priority, name) {
            return Err(FaceError::EqualPriority { priority, lists: [other.into(), name.into()] });
        }
    }
    Ok(())
}
