//! Sorting what is nearly in order.

/// Places up to which a value is moved to where it belongs.
const NEAR: usize = 16;

/// Sorts `values`. Those a few places off are moved there; those farther off are put `apart`, sorted among themselves and
/// merged with the others. What `apart` held before does not matter.
pub(crate) fn sort_nearly<T: Copy + Ord>(values: &mut [T], apart: &mut Vec<T>) {
    apart.clear();
    let mut kept = 0usize;
    for index in 0..values.len() {
        let value = values[index];
        let first = kept.saturating_sub(NEAR);
        if first > 0 && value < values[first] {
            apart.push(value);
            continue;
        }
        let mut place = kept;
        while place > first && value < values[place - 1] {
            values[place] = values[place - 1];
            place -= 1;
        }
        values[place] = value;
        kept += 1;
    }
    apart.sort_unstable();
    merge(values, kept, apart);
}

/// Merges the first `kept` of `values` with `apart`, both in order; together they fill `values`.
fn merge<T: Copy + Ord>(values: &mut [T], mut kept: usize, apart: &[T]) {
    let mut place = values.len();
    for &value in apart.iter().rev() {
        while kept > 0 && value < values[kept - 1] {
            place -= 1;
            kept -= 1;
            values[place] = values[kept];
        }
        place -= 1;
        values[place] = value;
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
            let (mut nearly, mut wholly, mut apart) = (values.clone(), values, before);
            sort_nearly(&mut nearly, &mut apart);
            wholly.sort_unstable();
            prop_assert_eq!(nearly, wholly);
        }
    }
}
