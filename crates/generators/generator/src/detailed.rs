//! What a session with levels of detail tells besides its pictures.

use scenario::Pose;

use crate::{FrameCounts, FrameError, Planes};

/// A session that draws its ground at levels of detail.
pub trait Detailed {
    /// Draws frame `frame` from `pose`, with the levels of detail that the ground has for an eye at `levels`. Where both poses are the same it
    /// is the picture of [`Session::frame`](crate::Session::frame).
    ///
    /// # Errors
    /// If a pose cannot be drawn.
    fn held_frame(
        &self,
        frame: u64,
        pose: &Pose,
        levels: &Pose,
        planes: &mut Planes,
    ) -> Result<FrameCounts, FrameError>;

    /// How many tiles of ground that a camera at `pose` may show have another level for an eye at the second of `levels` than for one at
    /// the first.
    ///
    /// # Errors
    /// If a pose cannot be drawn.
    fn level_changes(&self, frame: u64, pose: &Pose, levels: [&Pose; 2]) -> Result<u64, FrameError>;

    /// The ground of frame `frame` from `pose`: how large its mesh is, and how far it is off the finest one.
    ///
    /// # Errors
    /// If the pose cannot be drawn.
    fn drawn_ground(&self, frame: u64, pose: &Pose) -> Result<DrawnGround, FrameError>;

    /// Heights of the ground of frame `frame` from `pose` as it is drawn, whether or not the camera shows it.
    ///
    /// # Errors
    /// If the pose cannot be drawn, or the drawn ground has holes or other triangles than [`DrawnPosts`] says.
    fn drawn_posts(&self, frame: u64, pose: &Pose) -> Result<DrawnPosts, FrameError>;
}

/// Drawn ground at the posts of the finest level. Each cell between them is cut from its north-western to its south-eastern post into two
/// triangles, which are the drawn ones or parts of them.
#[derive(Debug, Clone, PartialEq)]
pub struct DrawnPosts {
    /// Places of the rows (m), the southernmost first.
    pub north: Vec<f64>,
    /// Places of the columns (m), the westernmost first.
    pub east: Vec<f64>,
    /// Heights above the datum (m), row by row.
    pub heights: Vec<f64>,
}

/// The ground of a frame as it is drawn.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub struct DrawnGround {
    /// Tiles that the camera may show.
    pub tiles: u64,
    /// Vertices of these tiles.
    pub vertices: u64,
    /// Triangles of these tiles.
    pub triangles: u64,
    /// How far they are off the finest mesh.
    pub loss: GroundLoss,
}

/// How far drawn ground is off the finest mesh at those posts of the finest mesh that lie inside the picture, hidden ones with them.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub struct GroundLoss {
    /// How many posts were looked at.
    pub posts: u64,
    /// Heights off the finest ones (m).
    pub metres: Errors,
    /// The same heights as they would be seen across the line of sight (pixels): height x focal length / distance from the eye.
    pub pixels: Errors,
    /// How far the places are moved in the picture (pixels).
    pub moved: Errors,
}

/// Errors of one kind, added up.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub struct Errors {
    /// Sum of their squares.
    pub squares: f64,
    /// Largest error in size, 0 or more.
    pub worst: f64,
}

impl Errors {
    /// Adds the error of one more place.
    pub fn add(&mut self, error: f64) {
        self.squares += error * error;
        self.worst = self.worst.max(error.abs());
    }

    /// Adds errors that were added up elsewhere.
    pub fn join(&mut self, other: Self) {
        self.squares += other.squares;
        self.worst = self.worst.max(other.worst);
    }

    /// Root mean square of so many errors; 0 of none.
    pub fn rms(&self, count: u64) -> f64 {
        if count == 0 { 0.0 } else { (self.squares / count as f64).sqrt() }
    }
}

impl GroundLoss {
    /// Adds what was found elsewhere.
    pub fn join(&mut self, other: &Self) {
        self.posts += other.posts;
        self.metres.join(other.metres);
        self.pixels.join(other.pixels);
        self.moved.join(other.moved);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn errors_add_up_wherever_they_were_found() {
        let mut whole = Errors::default();
        [3.0, -4.0, 0.0].into_iter().for_each(|error| whole.add(error));
        let [mut first, mut second] = [Errors::default(); 2];
        first.add(3.0);
        second.add(-4.0);
        second.add(0.0);
        first.join(second);
        assert_eq!(first, whole);
        assert_eq!(
            (whole.worst, whole.rms(3), Errors::default().rms(0)),
            (4.0, (25.0_f64 / 3.0).sqrt(), 0.0)
        );
    }
}
