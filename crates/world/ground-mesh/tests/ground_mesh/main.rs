//! Meshes of the ground: closed, near the closed form, the same from any number of threads.

mod bodies;
mod closed;
mod error;
mod faded;
mod fitting;
mod refused;

use glam::DVec3;
use ground_mesh::GroundMesh;
use landscape::{Bank, Landscape, Level};

/// Splitmix64: random numbers that are the same in every run.
struct Random(u64);

impl Random {
    fn unit(&mut self) -> f64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut mixed = self.0;
        mixed = (mixed ^ mixed >> 30).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        mixed = (mixed ^ mixed >> 27).wrapping_mul(0x94d0_49bb_1331_11eb);
        ((mixed ^ mixed >> 31) >> 11) as f64 / (1u64 << 53) as f64
    }

    fn between(&mut self, low: f64, high: f64) -> f64 {
        low + (high - low) * self.unit()
    }

    /// A level whose words are random: heights of up to `height` (m), slopes and curvatures by region of as much.
    fn level(&mut self, region: f64, origin: [f64; 2], corners: [usize; 2], height: f64) -> Level {
        let words = (0..corners[0] * corners[1]).map(|_| [0; 9].map(|_| self.between(-height, height)));
        let words = words.collect();
        Level::new(region, origin, corners, words).unwrap()
    }

    /// An eye over a landscape of one or more levels, up to 30 m above its height 0.
    fn eye(&mut self, [south, west, north, east]: [f64; 4]) -> DVec3 {
        DVec3::new(self.between(south, north), self.between(west, east), self.between(5.0, 30.0))
    }
}

fn of_levels(levels: Vec<Level>) -> Landscape {
    Landscape::new(Bank::new("test", levels, None).unwrap(), 0.3)
}

/// A fine level in the middle of a coarse one; sides are no multiples of any step.
const OUTER: [f64; 4] = [-150.0, -90.0, 750.0, 810.0];

fn two_levels() -> Landscape {
    let mut random = Random(7);
    let fine = random.level(50.0, [110.0, 110.0], [7, 6], 4.0);
    let coarse = random.level(180.0, [OUTER[0], OUTER[1]], [6, 6], 9.0);
    of_levels(vec![fine, coarse])
}

/// Corners of all triangles (m).
fn corners(mesh: &GroundMesh) -> impl Iterator<Item = [DVec3; 3]> + Clone {
    mesh.triangles().iter().map(|corners| corners.map(|corner| mesh.vertices()[corner as usize].place))
}
