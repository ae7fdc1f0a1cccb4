//! Map projections of a sphere: closed forms (Snyder, USGS Professional Paper 1395, chapters 12, 20, 21).

use std::f64::consts::{FRAC_PI_2, FRAC_PI_4, PI};

/// The rule from latitude and longitude to the plane.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Method {
    /// North and east proportional to latitude and longitude; true to scale along `parallel`.
    Equirectangular {
        /// Latitude that is true to scale (rad).
        parallel: f64,
    },
    /// Conformal, seen from the opposite pole; the centre is the pole named by the sign of its latitude.
    PolarStereographic {
        /// Scale at the pole.
        scale: f64,
    },
    /// Seen from infinity; shows half of the sphere.
    Orthographic,
}

/// A projection with its constants. Plane coordinates are north, east (m).
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Projection {
    /// Kind of map projection, in closed form.
    pub method: Method,
    /// Latitude of the centre (rad); for [`Method::PolarStereographic`] a pole.
    pub latitude: f64,
    /// Longitude of the centre (rad, east); at a pole the meridian that runs along the north axis.
    pub longitude: f64,
    /// Radius of the sphere (m).
    pub radius: f64,
    /// False northing and easting (m).
    pub offset: [f64; 2],
}

impl Projection {
    /// Plane coordinates north, east (m) of a point (rad); `None` where the projection has no picture.
    pub fn forward(&self, latitude: f64, longitude: f64) -> Option<[f64; 2]> {
        let east = wrap(longitude - self.longitude);
        let plane = match self.method {
            Method::Equirectangular { parallel } => [latitude - self.latitude, east * libm::cos(parallel)],
            Method::PolarStereographic { scale } => polar(latitude, east, self.pole(), scale)?,
            Method::Orthographic => orthographic(latitude, east, self.latitude)?,
        };
        Some([0, 1].map(|axis| self.radius * plane[axis] + self.offset[axis]))
    }

    /// Plane coordinates of a point (rad), on the turn around the sphere that lies nearest to the east of `near` (m). An
    /// equirectangular map may count its longitudes from 0 to 360 degrees.
    pub fn forward_near(&self, latitude: f64, longitude: f64, near: [f64; 2]) -> Option<[f64; 2]> {
        let [north, east] = self.forward(latitude, longitude)?;
        let Method::Equirectangular { parallel } = self.method else { return Some([north, east]) };
        let turn = 2.0 * PI * self.radius * libm::cos(parallel);
        Some([north, east + turn * ((near[1] - east) / turn).round()])
    }

    /// Latitude and longitude (rad, longitude in (-pi, pi]) of a plane point; `None` outside the picture.
    pub fn inverse(&self, place: [f64; 2]) -> Option<[f64; 2]> {
        let [north, east] = [0, 1].map(|axis| (place[axis] - self.offset[axis]) / self.radius);
        let [latitude, longitude] = match self.method {
            Method::Equirectangular { parallel } => {
                let longitude = east / libm::cos(parallel);
                let latitude = north + self.latitude;
                if latitude.abs() > FRAC_PI_2 + 1e-12 || longitude.abs() > 2.0 * PI {
                    return None;
                }
                [latitude, longitude]
            }
            Method::PolarStereographic { scale } => polar_inverse(north, east, self.pole(), scale),
            Method::Orthographic => orthographic_inverse(north, east, self.latitude)?,
        };
        Some([latitude, wrap(longitude + self.longitude)])
    }

    /// Direction of true north in the plane, clockwise from the plane's north axis (rad).
    pub fn true_north(&self, place: [f64; 2]) -> Option<f64> {
        let [latitude, longitude] = self.inverse(place)?;
        if let Method::Equirectangular { .. } = self.method {
            return Some(0.0);
        }
        let toward = if latitude > 0.0 { -1e-6 } else { 1e-6 };
        let [north, east] = self.forward_near(latitude + toward, longitude, place)?;
        let sign = if toward > 0.0 { 1.0 } else { -1.0 };
        Some(libm::atan2(sign * (east - place[1]), sign * (north - place[0])))
    }

    /// 1 for the north pole, -1 for the south pole.
    fn pole(&self) -> f64 {
        if self.latitude < 0.0 { -1.0 } else { 1.0 }
    }
}

/// Longitude 0 runs down from the north pole and up from the south pole; 90 east is to the right of both.
fn polar(latitude: f64, east: f64, pole: f64, scale: f64) -> Option<[f64; 2]> {
    if pole * latitude <= -FRAC_PI_2 + 1e-12 {
        return None;
    }
    let rho = 2.0 * scale * libm::tan(FRAC_PI_4 - 0.5 * pole * latitude);
    Some([-pole * rho * libm::cos(east), rho * libm::sin(east)])
}

fn polar_inverse(north: f64, east: f64, pole: f64, scale: f64) -> [f64; 2] {
    let rho = (north * north + east * east).sqrt();
    let latitude = pole * (FRAC_PI_2 - 2.0 * libm::atan(rho / (2.0 * scale)));
    let longitude = if rho == 0.0 { 0.0 } else { libm::atan2(east, -pole * north) };
    [latitude, longitude]
}

fn orthographic(latitude: f64, east: f64, centre: f64) -> Option<[f64; 2]> {
    let (s, c) = (libm::sin(latitude), libm::cos(latitude));
    let (s0, c0) = (libm::sin(centre), libm::cos(centre));
    let toward_viewer = s0 * s + c0 * c * libm::cos(east);
    (toward_viewer >= 0.0).then(|| [c0 * s - s0 * c * libm::cos(east), c * libm::sin(east)])
}

fn orthographic_inverse(north: f64, east: f64, centre: f64) -> Option<[f64; 2]> {
    let (s0, c0) = (libm::sin(centre), libm::cos(centre));
    let toward_viewer = 1.0 - north * north - east * east;
    if toward_viewer < 0.0 {
        return None;
    }
    let up = toward_viewer.sqrt();
    let latitude = libm::asin((up * s0 + north * c0).clamp(-1.0, 1.0));
    Some([latitude, libm::atan2(east, up * c0 - north * s0)])
}

/// The same longitude in (-pi, pi].
pub fn wrap(longitude: f64) -> f64 {
    let turn = 2.0 * PI;
    let wrapped = longitude - turn * ((longitude + PI) / turn).floor();
    if wrapped == -PI { PI } else { wrapped }
}

#[cfg(test)]
mod tests {
    use super::{Method, Projection};
    use proptest::prelude::{Strategy, prop_assert, proptest};
    use quantities::{degrees, radians};

    const R: f64 = 1_737_400.0;

    fn with(method: Method, latitude: f64, longitude: f64) -> Projection {
        let (latitude, longitude) = (radians(latitude), radians(longitude));
        Projection { method, latitude, longitude, radius: R, offset: [0.0; 2] }
    }

    fn near(found: [f64; 2], expected: [f64; 2], tolerance: f64) {
        let close = (0..2).all(|k| (found[k] - expected[k]).abs() < tolerance);
        assert!(close, "{found:?} against {expected:?}");
    }

    #[test]
    fn closed_forms_at_points_known_by_geometry() {
        // Orthographic: 30 deg north of the centre on its meridian lies R / 2 north.
        let view = with(Method::Orthographic, 0.0, 20.0);
        near(view.forward(radians(30.0), radians(20.0)).unwrap(), [R / 2.0, 0.0], 1e-6);
        near(view.forward(0.0, radians(50.0)).unwrap(), [0.0, R / 2.0], 1e-6);
        assert_eq!(view.forward(0.0, radians(111.0)), None);
        assert_eq!(view.inverse([R, R]), None);
        // Polar stereographic: the equator has radius 2 R.
        let north = with(Method::PolarStereographic { scale: 1.0 }, 90.0, 0.0);
        near(north.forward(0.0, 0.0).unwrap(), [-2.0 * R, 0.0], 1e-6);
        near(north.forward(0.0, radians(90.0)).unwrap(), [0.0, 2.0 * R], 1e-6);
        let south = with(Method::PolarStereographic { scale: 1.0 }, -90.0, 0.0);
        near(south.forward(0.0, 0.0).unwrap(), [2.0 * R, 0.0], 1e-6);
        near(south.forward(0.0, radians(90.0)).unwrap(), [0.0, 2.0 * R], 1e-6);
        // Equirectangular with true scale at 60 deg: a degree of longitude is half a degree of latitude.
        let flat = with(Method::Equirectangular { parallel: radians(60.0) }, 0.0, 180.0);
        near(
            flat.forward(radians(1.0), radians(-179.0)).unwrap(),
            [R * radians(1.0), R * radians(0.5)],
            1e-6,
        );
    }

    #[test]
    fn longitudes_may_count_from_0_to_360() {
        let flat = with(Method::Equirectangular { parallel: radians(60.0) }, 0.0, 0.0);
        let place = [R * radians(1.0), R * radians(0.5 * 190.0)];
        near(flat.inverse(place).unwrap().map(degrees), [1.0, -170.0], 1e-9);
        near(flat.forward_near(radians(1.0), radians(-170.0), place).unwrap(), place, 1e-6);
        assert!(flat.true_north(place).unwrap().abs() < 1e-9);
        let polar = with(Method::PolarStereographic { scale: 1.0 }, 90.0, 0.0);
        assert_eq!(polar.forward_near(1.0, 2.0, [0.0, 1e9]), polar.forward(1.0, 2.0));
    }

    #[test]
    fn the_south_pole_patch_lies_where_its_description_says() {
        // Shared data: centre 85.006 S, 5.768 W; upper left corner x -15472.86, y 150986.65; 485 x 437 m.
        let south = with(Method::PolarStereographic { scale: 1.0 }, -90.0, 0.0);
        let centre = south.inverse([150_986.65 - 218.3, -15_472.86 + 242.5]).unwrap();
        near(centre.map(degrees), [-85.006, -5.768], 6e-4);
        let turned = south.true_north([150_986.65 - 218.3, -15_472.86 + 242.5]).unwrap();
        assert!((degrees(turned) + 5.768).abs() < 1e-3, "{}", degrees(turned));
    }

    fn any_projection() -> impl Strategy<Value = Projection> {
        (0..4, -80.0..80.0f64, -180.0..180.0f64).prop_map(|(kind, latitude, longitude)| match kind {
            0 => with(Method::Equirectangular { parallel: radians(latitude) }, 0.0, longitude),
            1 => with(Method::PolarStereographic { scale: 0.99 }, 90.0, longitude),
            2 => with(Method::PolarStereographic { scale: 1.0 }, -90.0, longitude),
            _ => with(Method::Orthographic, latitude, longitude),
        })
    }

    proptest! {
        #[test]
        fn inverse_undoes_forward(
            projection in any_projection(), latitude in -89.0..89.0f64, longitude in -179.9..179.9f64,
        ) {
            if let Some(place) = projection.forward(radians(latitude), radians(longitude)) {
                let [found, east] = projection.inverse(place).unwrap();
                let back = projection.forward(found, east).unwrap();
                for k in 0..2 {
                    prop_assert!((back[k] - place[k]).abs() < 1e-2 + 1e-9 * place[k].abs(), "{:?} {:?}", back, place);
                }
                if projection.method != Method::Orthographic {
                    prop_assert!((degrees(found) - latitude).abs() < 1e-9);
                    prop_assert!(degrees(super::wrap(east - radians(longitude))).abs() < 1e-9);
                }
            }
        }

        /// A short way along a true azimuth lies on the map along that azimuth plus the direction of true north: to the north
        /// in every projection, any way where the projection is conformal.
        #[test]
        fn azimuths_turn_with_true_north(
            projection in any_projection(), latitude in -88.0..88.0f64, longitude in -179.0..179.0f64, azimuth in 0.0..360.0f64,
        ) {
            let (latitude, longitude) = (radians(latitude), radians(longitude));
            let is_conformal = matches!(projection.method, Method::PolarStereographic { .. });
            let azimuth = if is_conformal { radians(azimuth) } else { 0.0 };
            let Some(place) = projection.forward(latitude, longitude) else { return Ok(()) };
            let short = 1e-5;
            let [north, east] = [short * libm::cos(azimuth), short * libm::sin(azimuth) / libm::cos(latitude)];
            let Some(there) = projection.forward_near(latitude + north, longitude + east, place) else { return Ok(()) };
            let Some(turn) = projection.true_north(place) else { return Ok(()) };
            let way = [there[0] - place[0], there[1] - place[1]];
            // At the edge of an orthographic map a way has no length.
            if way[0].abs() + way[1].abs() < 0.1 * short * R {
                return Ok(());
            }
            let off = libm::atan2(way[1], way[0]) - azimuth - turn;
            prop_assert!(degrees(super::wrap(off)).abs() < 0.02, "{:?} {}", projection, degrees(super::wrap(off)));
        }
    }
}
