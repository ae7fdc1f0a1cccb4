//! Things side by side, in as many rows as they need.

/// Row and left edge of things of `widths`, `apart` from each other, in rows of `room`.
pub(crate) fn flow(widths: impl IntoIterator<Item = f32>, apart: f32, room: f32) -> Vec<(usize, f32)> {
    let (mut row, mut left) = (0, 0.0);
    let place = |width: f32| {
        if left > 0.0 && left + width > room {
            (row, left) = (row + 1, 0.0);
        }
        let place = (row, left);
        left += width + apart;
        place
    };
    widths.into_iter().map(place).collect()
}

/// Rows that they take: one if there is nothing.
pub(crate) fn rows(places: &[(usize, f32)]) -> usize {
    places.last().map_or(1, |(row, _)| row + 1)
}

#[cfg(test)]
mod tests {
    use super::{flow, rows};

    #[test]
    fn what_does_not_fit_goes_into_the_next_row() {
        assert_eq!(
            flow([30.0, 40.0, 20.0, 90.0, 5.0], 10.0, 80.0),
            [(0, 0.0), (0, 40.0), (1, 0.0), (2, 0.0), (3, 0.0)]
        );
        assert_eq!(
            (rows(&flow([90.0], 10.0, 80.0)), rows(&[])),
            (1, 1),
            "what is too wide has a row of its own"
        );
    }
}
