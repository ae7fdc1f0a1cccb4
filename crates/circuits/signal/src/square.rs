//! Squares of values, turned.

use fearless_simd::Simd;
use fearless_simd::prelude::SimdBase;

use crate::LANES;

/// Eight rows of eight values: value n of row k becomes value k of row n. Three rounds of the perfect shuffle.
#[inline(always)]
pub fn turn_square<L: Simd, V: SimdBase<L>>(rows: &mut [V; LANES]) {
    for _ in 0..3 {
        let before = *rows;
        for k in 0..LANES / 2 {
            rows[2 * k] = before[k].zip_low(before[k + LANES / 2]);
            rows[2 * k + 1] = before[k].zip_high(before[k + LANES / 2]);
        }
    }
}

#[cfg(test)]
mod tests {
    use fearless_simd::{Level, SimdBase, dispatch, f32x8};

    use super::turn_square;

    #[test]
    fn rows_become_columns() {
        let values: [[f32; 8]; 8] = std::array::from_fn(|row| std::array::from_fn(|n| (8 * row + n) as f32));
        for vectors in [Level::new(), Level::baseline()] {
            dispatch!(vectors, simd => {
                let mut rows = values.map(|row| f32x8::load_array(simd, row));
                turn_square(&mut rows);
                for (n, row) in rows.into_iter().enumerate() {
                    assert_eq!(row.to_array(), values.map(|row| row[n]));
                }
            });
        }
    }
}
