//! Sorting what is nearly in order.

/// Places up to which a value is moved to where it belongs.
const NEAR: usize = 16;

/// Sorts `values` into `sorted`. Those a few places off are moved there; those farther off are put `apart`, sorted among themselves
/// and merged with the others. What both held before does not matter.
pub(crate) fn sort_nearly<T: Copy + Ord>(
    values: impl Iterator<Item = T>,
    sorted: &mut Vec<T>,
    apart: &mut Vec<T>,
) {
    sorted.clear();
    apart.clear();
    // Handed over one by one: values of many short lists are a loop for each of them.
    values.for_each(|value| {
        let first = sorted.len().saturating_sub(NEAR);
        if first > 0 && value < sorted[first] {
            return apart.push(value);
        }
        let mut place = sorted.len();
        sorted.push(value);
        while place > first && value < sorted[place - 1] {
            sorted[place] = sorted[place - 1];
            place -= 1;
        }
        sorted[place] = value;
    });
    apart.sort_unstable();
    merge(sorted, apart);
}

/// Merges `apart` into `sorted`, both in order.
fn merge<T: Copy + Ord>(sorted: &mut Vec<T>, apart: &[T]) {
    let mut kept = sorted.len();
    sorted.extend_from_slice(apart);
    let mut place = sorted.len();
    for &value in apart.iter().rev() {
        while kept > 0 && value < sorted[kept - 1] {
            place -= 1;
            kept -= 1;
            sorted[place] = sorted[kept];
        }
        place -= 1;
        sorted[place] = value;
    }
}

#[cfg(test)]
mod tests {
    use super::sort_nearly;
    use proptest::prelude::{any, prop_assert_eq, proptest};

    proptest! {
        /// In order but for some steps, some long tails and some values anywhere.
        #[test]
        fn nearly_is_wholly(
            steps in proptest::collection::vec((0..40i64, 0..8u8, any::<i16>()), 0..300),
            before in proptest::collection::vec(any::<i64>(), 0..3),
        ) {
            let mut at = 0;
            let value = |(step, kind, anywhere): (i64, u8, i16)| {
                at += step;
                match kind {
                    0 => i64::from(anywhere),
                    1 => at - 60,
                    _ => at,
                }
            };
            let values: Vec<i64> = steps.into_iter().map(value).collect();
            let (mut nearly, mut wholly, mut apart) = (before.clone(), values.clone(), before);
            sort_nearly(values.iter().copied(), &mut nearly, &mut apart);
            wholly.sort_unstable();
            prop_assert_eq!(nearly, wholly);
        }
    }
}
