//! Maps of a sphere as files describe them: name, centre, parallel, scale.

use std::f64::consts::TAU;

use quantities::radians;

use landscape::projection::{Method, Projection};

/// A kind of map that is known here.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Kind {
    /// Equirectangular, which has many names.
    Equirectangular,
    /// A polar stereographic map.
    Polar,
    /// Stereographic, which is known at a pole only.
    Stereographic,
    /// An orthographic map of a globe.
    Orthographic,
}

impl Kind {
    /// By the name that a file gives; `None` for one that is not known here. Capitals, spaces, `_` and `-` do not matter.
    pub fn named(name: &str) -> Option<Self> {
        let letters: String = name.chars().filter(char::is_ascii_alphabetic).collect();
        Some(match letters.to_ascii_lowercase().as_str() {
            "equirectangular" | "equidistantcylindrical" | "platecarree" | "simplecylindrical" => {
                Self::Equirectangular
            }
            "polarstereographic" | "stereographicnorthpole" | "stereographicsouthpole" => Self::Polar,
            "stereographic" => Self::Stereographic,
            "orthographic" => Self::Orthographic,
            _ => return None,
        })
    }
}

/// What a file says about its map (rad, m).
#[derive(Debug, Clone, Copy)]
pub struct Map {
    /// Latitude of the origin; that of the parallel if there is none.
    pub latitude: Option<f64>,
    /// Longitude of the origin, positive east.
    pub longitude: f64,
    /// Parallel that is true to scale.
    pub parallel: Option<f64>,
    /// Scale at the origin.
    pub scale: f64,
    /// Radius of the sphere.
    pub radius: f64,
    /// False northing and easting.
    pub offset: [f64; 2],
}

impl Map {
    /// The projection of a map of this kind; `None` for one that has no closed form here.
    pub fn projection(&self, kind: Kind) -> Option<Projection> {
        let latitude = self.latitude.or(self.parallel.filter(|_| kind == Kind::Polar)).unwrap_or(0.0);
        let (method, latitude) = match kind {
            Kind::Stereographic if !is_pole(latitude) => return None,
            Kind::Polar | Kind::Stereographic => {
                // A latitude other than the pole names the parallel of true scale.
                let true_at = if is_pole(latitude) { self.parallel.unwrap_or(latitude) } else { latitude };
                let scale = self.scale * 0.5 * (1.0 + libm::sin(true_at.abs()));
                (Method::PolarStereographic { scale }, radians(90.0_f64.copysign(true_at)))
            }
            Kind::Equirectangular => {
                (Method::Equirectangular { parallel: self.parallel.unwrap_or(0.0) }, latitude)
            }
            Kind::Orthographic => (Method::Orthographic, latitude),
        };
        let Self { longitude, radius, offset, .. } = *self;
        Some(Projection { method, latitude, longitude: around(longitude), radius, offset })
    }
}

/// The same longitude within a turn (rad): files count on, and meridians are added to what they count.
pub fn around(longitude: f64) -> f64 {
    if longitude.abs() > TAU { longitude % TAU } else { longitude }
}

fn is_pole(latitude: f64) -> bool {
    (latitude.abs() - radians(90.0)).abs() < 1e-9
}

/// Whether two lengths of a sample (m), each said in a word of its own, cannot both be meant: files round them to 1 %.
pub fn contradict(first: f64, second: f64) -> bool {
    (first / second - 1.0).abs() > 0.01
}

/// Note on a body that is no sphere, by its longest and its shortest axis (m); none for a sphere.
pub fn flattened(longest: f64, shortest: f64) -> Option<String> {
    let share = 100.0 * (1.0 - shortest / longest);
    (share.abs() > 1e-4)
        .then(|| format!("the body is flattened by {share:.3} %: a sphere of {longest} m stands for it"))
}

/// Note on a map whose name is not known.
pub fn unknown(name: &str) -> String {
    format!("{name} is a projection that is not known here: its metres are taken as they are")
}

#[cfg(test)]
mod tests {
    use super::{Kind, Map, flattened};
    use landscape::projection::Method;
    use quantities::radians;

    #[test]
    fn names_in_any_writing() {
        assert_eq!(Kind::named("Equidistant_Cylindrical"), Some(Kind::Equirectangular));
        assert_eq!(Kind::named("POLAR STEREOGRAPHIC"), Some(Kind::Polar));
        assert_eq!([Kind::named("Sinusoidal"), Kind::named("")], [None; 2]);
    }

    #[test]
    fn the_parallel_of_true_scale_is_said_in_two_ways() {
        let of = |latitude, parallel| {
            let map = Map { latitude, longitude: 0.0, parallel, scale: 1.0, radius: 1.0, offset: [0.0; 2] };
            map.projection(Kind::Polar).unwrap()
        };
        let by_latitude = of(Some(radians(-70.0)), None);
        assert_eq!(by_latitude, of(Some(radians(-90.0)), Some(radians(-70.0))));
        assert_eq!(by_latitude, of(None, Some(radians(-70.0))));
        assert_eq!(of(Some(radians(90.0)), None).method, Method::PolarStereographic { scale: 1.0 });
    }

    /// Meridians are added to longitudes that count to 360: a bank holds less than a turn either way.
    #[test]
    fn longitudes_beyond_a_turn_go_around() {
        let of = |longitude: f64| {
            let map = Map {
                latitude: None,
                longitude: radians(longitude),
                parallel: None,
                scale: 1.0,
                radius: 1.0,
                offset: [0.0; 2],
            };
            map.projection(Kind::Orthographic).unwrap().longitude
        };
        assert!((of(390.0) - radians(30.0)).abs() < 1e-12 && (of(-750.0) - radians(-30.0)).abs() < 1e-12);
        assert_eq!(of(200.0), radians(200.0));
    }

    #[test]
    fn spheres_are_not_flattened() {
        assert_eq!(flattened(1_737_400.0, 1_737_400.0), None);
        assert!(flattened(6_378_137.0, 6_356_752.3).unwrap().contains("0.335 %"));
    }
}
