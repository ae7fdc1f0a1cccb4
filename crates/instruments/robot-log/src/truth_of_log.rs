//! The ground truth that a robot log needs.

use replay::{TruthItem, TruthItems};

use crate::{Form, LogError};

/// Kinds of ground truth that a robot log needs: labels, and the distance from which depth follows.
pub const TRUTH_OF_LOG: [TruthItem; 2] = [TruthItem::Label, TruthItem::Distance];

/// Refuses a list of truth that lacks what a robot log needs.
///
/// # Errors
/// [`LogError::Lacks`].
pub fn expect_truth_of_log(items: &TruthItems) -> Result<(), LogError> {
    let lacks = |needed: &TruthItem| items.iter().all(|item| item != *needed);
    match TRUTH_OF_LOG.into_iter().find(lacks) {
        None => Ok(()),
        Some(item) => Err(LogError::Lacks {
            option: Form::Mcap.option(),
            lacks: item.name(),
            expected: TruthItems::of(TRUTH_OF_LOG).to_string(),
        }),
    }
}

#[cfg(test)]
mod tests {
    use super::expect_truth_of_log;

    #[test]
    fn what_lacks_is_named() {
        let said = |list: &str| {
            let items = list.parse().expect("a list");
            expect_truth_of_log(&items).map_err(|error| error.to_string())
        };
        assert_eq!(said("all"), Ok(()));
        assert_eq!(said("distance,label"), Ok(()));
        let expected = "--mcap: the ground truth has no `distance`; expected --truth with label,distance";
        assert_eq!(said("range,label"), Err(expected.into()));
        assert!(said("pose").unwrap_err().contains("no `label`"));
    }
}
