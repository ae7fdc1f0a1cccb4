//! Programs of other people that do the same work, held against the machine by the binary `goals`.
//!
//! Each is a package of the system. What we write for it lies in the folder `peers` of this crate and is compiled when it is asked for.
//! Where a package is missing, the row says which one, and is skipped.

pub mod drawing;
pub mod embree;
mod process;
pub mod verilator;

/// Root mean square of the difference of two pictures of one size.
pub fn rms(picture: &[f32], right: &[f32]) -> f64 {
    let squares = picture.iter().zip(right).map(|(a, b)| f64::from(a - b) * f64::from(a - b));
    (squares.sum::<f64>() / right.len().max(1) as f64).sqrt()
}

/// The middle one of some times (s), at least one.
pub fn median(mut times: Vec<f64>) -> f64 {
    times.sort_unstable_by(f64::total_cmp);
    times[times.len() / 2]
}

#[cfg(test)]
mod tests {
    use super::{median, rms};

    #[test]
    fn figures_of_short_lists() {
        assert_eq!(rms(&[1.0, 2.0], &[1.0, 0.0]), 2f64.sqrt());
        assert_eq!(median(vec![3.0, 1.0, 2.0]), 2.0);
    }
}
