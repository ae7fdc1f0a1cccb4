//! From a point of the vehicle to its shadow as the camera has it (section 19.3).

use glam::{DMat3, DVec3};
use landscape::Attitude;

use crate::Shot;

/// `S`: the projection along the sun's rays onto the plane W = 0, in terrain axes (north, east, down). `to_sun` is the
/// unit vector to the sun (north, east, up), above the horizontal.
pub fn shadow_projection(to_sun: DVec3) -> DMat3 {
    // cot e cos a and cot e sin a, without the angles.
    let [north, east] = [to_sun.x / to_sun.z, to_sun.y / to_sun.z];
    DMat3::from_cols(DVec3::X, DVec3::Y, DVec3::new(north, east, 0.0))
}

/// `S'_i = T F'_i + C`: T and C of one picture and one sun.
///
/// The report has one attitude, since its camera is fixed to the vehicle. A picture that is drawn without the vehicle's
/// roll has its own: `T = Rc^T S R` with the camera's `Rc` in front.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Chain {
    /// From a point in vehicle axes to its shadow in the camera's.
    pub turn: DMat3,
    /// Shift C, which is added after the turn (m).
    pub shift: DVec3,
    /// Height of a point in vehicle axes above the ground is `eye_height - down . point`.
    down: DVec3,
    eye_height: f64,
}

impl Chain {
    /// The chain of a shot over flat ground, under the sun in direction `to_sun` (north, east, up; above the
    /// horizontal).
    pub fn new(shot: &Shot, to_sun: DVec3) -> Self {
        Self::of(&shot.vehicle, &shot.camera, shot.height, to_sun)
    }

    pub(crate) fn of(vehicle: &Attitude, camera: &Attitude, height: f64, to_sun: DVec3) -> Self {
        let (to_terrain, to_camera) = (vehicle.to_terrain(), camera.to_terrain().transpose());
        let (project, eye) = (shadow_projection(to_sun), DVec3::new(0.0, 0.0, -height));
        Self {
            turn: to_camera * project * to_terrain,
            shift: to_camera * (project * eye - eye),
            down: to_terrain.transpose() * DVec3::Z,
            eye_height: height,
        }
    }

    /// Shadow of a point, in camera axes (forward, starboard, down; m).
    pub fn shadow(&self, point: DVec3) -> DVec3 {
        self.turn * point + self.shift
    }

    /// Height of a point above the ground (m).
    pub fn height(&self, point: DVec3) -> f64 {
        self.eye_height - self.down.dot(point)
    }
}

#[cfg(test)]
mod tests {
    use glam::{DMat3, DVec3};
    use landscape::{Attitude, Sun};
    use quantities::radians;

    use super::{Chain, shadow_projection};

    fn chain() -> Chain {
        let attitude = Attitude { roll: radians(10.0), pitch: radians(-5.0), heading: radians(30.0) };
        Chain::of(&attitude, &attitude, 2.0, to_sun(25.0, 140.0))
    }

    fn to_sun(elevation: f64, azimuth: f64) -> DVec3 {
        let sun = Sun { azimuth: radians(azimuth), elevation: radians(elevation) };
        DVec3::from_array(sun.direction())
    }

    fn is_near(found: DVec3, expected: [f64; 3]) -> bool {
        (found - DVec3::from_array(expected)).length() < 4e-15
    }

    #[test]
    fn check_values_of_23_6() {
        let chain = chain();
        let rows = [
            [0.9287214840177703, -0.141474151144734, -0.8023397813329779],
            [0.15885663134616, 1.31529987351326, 1.788154440383517],
            [-0.1105167639421969, -0.2193545299102925, -0.2440213575310308],
        ];
        for (i, row) in rows.into_iter().enumerate() {
            assert!(is_near(chain.turn.row(i), row), "row {i}: {}", chain.turn.row(i));
        }
        assert!(is_near(chain.shift, [1.635658505913998, -3.645350870477857, 2.536075316624307]));
        let shadow = chain.shadow(DVec3::new(3.0, 1.0, -0.5));
        assert!(is_near(shadow, [4.681518697489064, -2.747558323117876, 2.107181173652939]), "{shadow}");
        assert!((shadow.y / shadow.x - -0.586894659758922).abs() < 1e-15);
        assert!((shadow.z / shadow.x - 0.450106324424834).abs() < 1e-15);
        let other = chain.shadow(DVec3::new(-1.0, -1.5, 0.25));
        assert!(is_near(other, [0.7185633032800838, -5.330118701998029, 2.914618536049185]), "{other}");
        assert!((chain.height(DVec3::new(3.0, 1.0, -0.5)) - 2.056075508927139).abs() < 4e-15);
    }

    #[test]
    fn it_is_a_projection_of_rank_two() {
        let t = chain().turn;
        let close = |a: DMat3, b: DMat3| (0..3).all(|i| (a.col(i) - b.col(i)).length() < 1e-14);
        assert!(close(t * t, t));
        assert!(t.determinant().abs() < 1e-15);
        assert!((t.col(0).x + t.col(1).y + t.col(2).z - 2.0).abs() < 1e-14);
    }

    #[test]
    fn what_is_above_the_ground_is_moved_away_from_the_sun() {
        // The sun in the north, 45 degrees up: 3 m above the ground is moved 3 m south.
        let moved = shadow_projection(to_sun(45.0, 0.0)) * DVec3::new(7.0, 2.0, -3.0);
        assert!((moved - DVec3::new(4.0, 2.0, 0.0)).length() < 1e-14, "{moved}");
        let foot = shadow_projection(to_sun(90.0, 0.0)) * DVec3::new(7.0, 2.0, -3.0);
        assert!((foot - DVec3::new(7.0, 2.0, 0.0)).length() < 1e-14, "{foot}");
    }

    /// A level picture of a rolled vehicle has the shadow where the rolled one has it, turned back by the roll.
    #[test]
    fn a_camera_without_the_roll_turns_it_back() {
        let vehicle = Attitude { roll: 0.3, pitch: 0.1, heading: 1.0 };
        let level = Attitude { roll: 0.0, ..vehicle };
        let point = DVec3::new(2.0, 0.4, 0.3);
        let [rolled, upright] = [vehicle, level]
            .map(|camera| Chain::of(&vehicle, &camera, 1.6, to_sun(20.0, 80.0)).shadow(point));
        let roll = Attitude { roll: 0.3, ..Attitude::default() }.to_terrain();
        assert!((roll * rolled - upright).length() < 1e-14);
    }
}
