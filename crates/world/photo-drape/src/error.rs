//! Why photographs cannot be laid over ground.

use photo_camera::voids::VoidError;
use photograph::PhotoError;
use sight::SightError;

/// Why photographs cannot be laid over ground.
#[derive(Debug, thiserror::Error)]
pub enum DrapeError {
    /// There is nothing to lay over the ground.
    #[error(
        "a scenario without photographs; expected one `[[photograph]]` or more, with `file` and `camera`"
    )]
    None,
    /// The axes of a photograph do not lie in those of the ground.
    #[error(
        "photograph {number}: {what}; expected a camera or a map in metres of the landscape, or a bank that says where it lies"
    )]
    Axes {
        /// Number of the photograph, from 1.
        number: usize,
        /// What its axes are.
        what: &'static str,
    },
    /// A photograph shows nothing of the ground.
    #[error("photograph {number}: {error}")]
    Photograph {
        /// Number of the photograph, from 1.
        number: usize,
        /// Why it shows nothing.
        error: PhotoError,
    },
    /// A camera stands where it sees no ground.
    #[error("photograph {number}: its camera stands in the ground: {error}")]
    Camera {
        /// Number of the photograph, from 1.
        number: usize,
        /// What is wrong with its place.
        error: SightError,
    },
    /// The ground cannot be posts.
    #[error("{posts} posts {spacing} m apart; expected 4 to {most}")]
    Posts {
        /// Number of posts that were asked for.
        posts: u128,
        /// Distance between them (m).
        spacing: f64,
        /// Most posts that are allowed.
        most: u128,
    },
    /// The ground has a hole.
    #[error(
        "the landscape has no ground {north} m north, {east} m east; expected ground everywhere under the posts"
    )]
    Hole {
        /// Place to the north (m).
        north: f64,
        /// Place to the east (m).
        east: f64,
    },
    /// Shadows cannot be filled.
    #[error("shadows of the photograph cannot be filled: {0}")]
    Fill(#[from] VoidError),
    /// Albedo needs the sun of the photograph.
    #[error(
        "photograph {number} does not say where its sun was; expected `sun_azimuth_elevation_rad` in its camera file"
    )]
    NoSun {
        /// Number of the photograph, from 1.
        number: usize,
    },
}
