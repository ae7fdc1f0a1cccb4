//! Where ground that one picture shows should be in the next, by its distance and both poses.

use generator::PlaneKind;
use glam::DVec3;
use scenario::{Pose, View};
use scene_sampler::Camera;

/// Half of the window (pixels) around a corner in which there must be nothing but ground at about one distance.
const AROUND: isize = 5;
/// Largest distance in that window over the smallest. Chosen: at an edge before farther ground no place of the ground is followed.
const MOST_RATIO: f64 = 1.25;

/// What a picture shows, by the distance of each pixel.
pub struct Sight {
    camera: Camera,
    columns: usize,
    lines: usize,
    /// Distance of each pixel (m), infinite for sky.
    distances: Vec<f32>,
}

impl Sight {
    /// The sight from a pose, with the distances that its picture has, line by line.
    pub fn new(pose: &Pose, view: &View, distances: Vec<f32>) -> Self {
        let [columns, lines] = [view.columns, view.lines].map(|count| count as usize);
        Self { camera: Camera::new(pose, view), columns, lines, distances }
    }

    /// Whether a corner at a pixel may be followed: no sky and no edge before farther ground is near it.
    pub fn is_ground(&self, [x, y]: [usize; 2]) -> bool {
        let offsets = (-AROUND..=AROUND).flat_map(|j| (-AROUND..=AROUND).map(move |i| [i, j]));
        let around = offsets.filter_map(|[i, j]| self.distance([x as isize + i, y as isize + j]));
        let (least, most) =
            around.fold((f64::INFINITY, 0.0_f64), |(least, most), found| (least.min(found), most.max(found)));
        most < f64::from(PlaneKind::Distance.sky()) && most <= MOST_RATIO * least
    }

    fn distance(&self, [x, y]: [isize; 2]) -> Option<f64> {
        let inside = |at: isize, count: usize| usize::try_from(at).ok().filter(|at| *at < count);
        let (x, y) = (inside(x, self.columns)?, inside(y, self.lines)?);
        Some(f64::from(self.distances[y * self.columns + x]))
    }

    /// The place on the map (north, east, up; m) that a pixel shows in its middle; `None` for sky.
    pub fn place(&self, pixel: [usize; 2]) -> Option<DVec3> {
        let distance = self.distance(pixel.map(|at| at as isize)).filter(|distance| distance.is_finite())?;
        Some(self.camera.shown(pixel, distance))
    }
}

/// Where (pixels) a camera at `pose` shows a place of the map; `None` outside of the picture.
pub fn shown(pose: &Pose, view: &View, place: DVec3) -> Option<[f64; 2]> {
    let camera = Camera::new(pose, view);
    let from_eye = camera.place(place);
    let at = camera.projection.project(from_eye).map(|at| at - 0.5);
    let size = [view.columns, view.lines].map(|count| f64::from(count) - 1.0);
    let is_inside = from_eye.z > 0.0 && (0..2).all(|axis| (0.0..=size[axis]).contains(&at[axis]));
    is_inside.then_some(at)
}

#[cfg(test)]
mod tests {
    use landscape::Attitude;
    use quantities::{Rate, radians};
    use scenario::{Curvature, Display, FieldOfView, Laws};

    use super::*;

    fn view() -> View {
        let rate = Rate::new(30, 1).unwrap();
        View {
            columns: 200,
            lines: 100,
            field: FieldOfView { tan_half_width: 0.5, tan_half_height: 0.25 },
            update: rate,
            refresh: rate,
            display: Display { white: 1.0, gamma: 1.0 },
            laws: Laws { curvature: Curvature::Parabolic, ..Laws::default() },
            ranges: [1.0, 1e5],
            yoke: None,
            levels: None,
            shadows: None,
        }
    }

    fn down_from(up: f64) -> Pose {
        let attitude = Attitude { roll: 0.0, pitch: radians(-90.0), heading: 0.0 };
        Pose { time: 0.0, eye: [100.0, 200.0, up], attitude, yoke: 0.0 }
    }

    /// A plane far below: what lies 1000 m beside the foot of the eye goes away from the middle as the eye comes down.
    #[test]
    fn ground_goes_where_the_pinhole_says() {
        let view = view();
        let high = Sight::new(&down_from(20_000.0), &view, vec![20_000.0; 200 * 100]);
        let place = high.place([120, 50]).unwrap();
        // 20.5 pixels to the right of the middle are 20.5/200 of the distance along the axis; on the map right is east.
        let along = 20_000.0 / (1.0 + 0.1025_f64 * 0.1025 + 0.0025 * 0.0025).sqrt();
        assert!((place.y - 200.0 - 0.1025 * along).abs() < 1e-6, "{place}");
        let own = shown(&down_from(20_000.0), &view, place).unwrap();
        assert!((own[0] - 120.0).abs() < 1e-9 && (own[1] - 50.0).abs() < 1e-9, "{own:?}");
        let low = shown(&down_from(20_000.0 - along / 2.0), &view, place).unwrap();
        assert!((low[0] - 99.5 - 41.0).abs() < 1e-3, "{low:?}");
        assert_eq!(shown(&down_from(2_000.0), &view, place), None);
    }

    #[test]
    fn edges_and_sky_are_no_ground() {
        let mut distances = vec![100.0_f32; 200 * 100];
        distances[40 * 200 + 60] = f32::INFINITY;
        distances[70 * 200 + 150] = 130.0;
        let sight = Sight::new(&down_from(100.0), &view(), distances);
        assert!(sight.is_ground([30, 30]) && !sight.is_ground([62, 44]) && !sight.is_ground([150, 73]));
        assert!(sight.is_ground([150, 76]) && sight.is_ground([0, 99]));
        assert_eq!(sight.place([60, 40]), None);
    }
}
