//! Faces of a pixel in words.

use generator::Fact;

use super::FaceLayer;
use super::triangle::linear;

impl FaceLayer {
    /// The faces at the middle of a pixel in words, near to far.
    pub fn facts(&self, pixel: [usize; 2]) -> Vec<Fact> {
        let at = pixel.map(|at| at as f64 + 0.5);
        let told = |face: u32| Fact::new("face", self.told(face, at));
        self.covers(at).into_iter().map(told).collect()
    }

    fn told(&self, face: u32, at: [f64; 2]) -> String {
        let triangle = &self.triangles[face as usize];
        let list = &self.lists[triangle.paint.of[0] as usize];
        let corners = triangle.brightness.map(|brightness| format!("{brightness:.4}")).join(", ");
        format!(
            "{} of {} ({}): depth {:.3} m, brightness {:.4} between corners {corners}; {} {:.4} north, {:.4} east, {:.4} up{}",
            triangle.paint.of[1],
            list.name,
            list.label.name(),
            1.0 / linear(&triangle.nearness, at),
            triangle.brightness_at(at),
            if list.has_own_sun { "its own sun" } else { "the scene's sun" },
            list.sun.x,
            list.sun.y,
            list.sun.z,
            triangle.paint.level.map_or("", |_| "; laid upon what is behind it")
        )
    }
}
