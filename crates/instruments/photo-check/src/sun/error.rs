//! Why no sun is found from shadows.

/// Why no sun is found from the shadows of a photograph.
#[derive(Debug, Clone, Copy, PartialEq, thiserror::Error)]
pub enum SunError {
    /// Fewer posts than a search needs.
    #[error(
        "the photograph shows {found} posts of the ground, expected {expected} or more; give a larger or finer elevation file"
    )]
    Few {
        /// Number of posts that the photograph shows.
        found: usize,
        /// Least number of posts.
        expected: usize,
    },
    /// Nothing in the photograph is dark.
    #[error(
        "the darkest posts have {share:.2} of the usual light of the photograph, expected {most} or less: no shadow is seen; give --sun"
    )]
    NoShadow {
        /// Light of the darkest thousandth, as a share of the usual light.
        share: f64,
        /// Largest share that counts as shadow.
        most: f64,
    },
    /// Too little or too much of the photograph is dark.
    #[error(
        "{percent:.2} % of the posts are dark in the photograph, expected {least} to {most} %; give --sun, or a photograph with shadow and light"
    )]
    DarkShare {
        /// Share of dark posts (%).
        percent: f64,
        /// Least share that can be held against shadows (%).
        least: f64,
        /// Largest share that can be held against shadows (%).
        most: f64,
    },
    /// Shadows of no sun lie where the photograph is dark.
    #[error(
        "shadows of no sun overlap with the dark posts of the photograph: the best correlation is {best:.3}, expected {least} or more; check \
         that photograph and elevations show one ground, or give --sun"
    )]
    NoOverlap {
        /// Best correlation of dark posts.
        best: f64,
        /// Least correlation that tells a sun.
        least: f64,
    },
    /// The overlap has no summit.
    #[error(
        "the overlap of shadows has no summit: the ground has too few of them; give --sun, or a larger elevation file"
    )]
    NoSummit,
}
