//! What a reader did to shapes that the user should know.

use crate::split::Split;

/// What was done to the shapes of one file.
#[derive(Default)]
pub(super) struct Told {
    /// Shapes that were split.
    shapes: usize,
    /// Parts that these became.
    parts: usize,
    /// Shapes of those whose faces were turned.
    turned: usize,
    /// Faces without an area.
    left_out: usize,
    /// Largest change of the volume of one, as a share.
    volume: f64,
    /// Largest distance of a corner from the parts (m).
    distance: f64,
}

impl Told {
    /// Notes a shape that was split.
    pub fn split(&mut self, split: &Split, is_turned: bool) {
        self.shapes += 1;
        self.parts += split.parts.len();
        self.turned += usize::from(is_turned);
        self.volume = self.volume.max(split.volume_error.abs());
        self.distance = self.distance.max(split.distance);
    }

    /// Notes faces that were left out.
    pub fn left_out(&mut self, faces: usize) {
        self.left_out += faces;
    }

    /// One sentence for each thing that was done.
    pub fn notes(&self) -> Vec<String> {
        let shapes = |count| if count == 1 { "1 shape".to_owned() } else { format!("{count} shapes") };
        let split = (self.shapes > 0).then(|| {
            format!(
                "not convex: {} split into {} convex parts; the volume differs by {:.1e} of it at most, corners lie {:.1e} m \
                 outside at most",
                shapes(self.shapes),
                self.parts,
                self.volume,
                self.distance
            )
        });
        let turned = (self.turned > 0).then(|| {
            format!("inside out, or turned both ways round: faces of {} turned outwards", shapes(self.turned))
        });
        let left_out = (self.left_out > 0).then(|| {
            format!("faces with fewer than three different corners are left out: {}", self.left_out)
        });
        split.into_iter().chain(turned).chain(left_out).collect()
    }
}
