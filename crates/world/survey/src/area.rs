//! Which part of a file becomes the bank, and how its samples come into the axes of the bank.

use std::f64::consts::PI;

use landscape::{FileCoordinates, Georeference, LUNOID_RADIUS, MapFrame};
use quantities::degrees;

use crate::elevation::{Elevation, Frame, Grid};
use crate::error::SurveyError;
use crate::patch::Patch;
use crate::read::around;
use landscape::projection::{Method, Projection, wrap};

/// The ground to survey.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub enum Area {
    /// All of the file, from centre to centre of the outermost samples.
    #[default]
    Whole,
    /// Edges in the file's own projected metres.
    Metres {
        /// South edge of the area (m).
        south: f64,
        /// West edge of the area (m).
        west: f64,
        /// North edge of the area (m).
        north: f64,
        /// East edge of the area (m).
        east: f64,
    },
    /// A rectangle around a point of the Moon.
    Centred {
        /// Latitude of the centre (rad).
        latitude: f64,
        /// Longitude of the centre, positive east (rad).
        longitude: f64,
        /// Size to the north and to the east (m).
        size: [f64; 2],
        /// How a geographic grid is laid onto the plane; a projected file keeps its own plane.
        plane: Plane,
    },
}

/// The tangent plane of a geographic grid.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Plane {
    /// Samples are taken as they are; true to scale along the parallel of the centre.
    #[default]
    Equirectangular,
    /// True at the centre in all directions, also near a pole; samples are interpolated between four.
    Orthographic,
}

/// An area cut from a file.
#[derive(Debug)]
pub struct Cut {
    /// Samples in the axes of the bank.
    pub patch: Patch,
    /// South, west, north, east in the coordinates of the file (m or rad) or of the orthographic plane (m).
    pub area: [f64; 4],
    /// Where the bank lies.
    pub georeference: Option<Georeference>,
    /// How the axes of the bank lie in the map of the file.
    pub map: MapFrame,
    /// True north at the centre, clockwise from the bank's north (rad).
    pub true_north: Option<f64>,
    /// What the user should know.
    pub warnings: Vec<String>,
}

/// Stretch of the tangent plane above which the user is told.
const STRETCH: f64 = 0.01;

/// An area in the coordinates of the file (or of the plane it is interpolated to), before samples are taken.
pub(crate) struct Placed {
    /// South, west, north, east.
    pub area: [f64; 4],
    /// Metres a unit of the file's coordinates: north, east.
    pub metres: [f64; 2],
    centre: Option<[f64; 2]>,
    /// The plane onto which samples are interpolated; the area is then in its metres.
    pub resampled: Option<Projection>,
    /// The map of the bank: that of the file, or the plane that its degrees are laid onto.
    projection: Option<Projection>,
    /// South-west corner of the area in that map: north, east (m).
    origin: [f64; 2],
}

impl Placed {
    /// Size to the north and to the east (m).
    pub fn size(&self) -> [f64; 2] {
        let [south, west, north, east] = self.area;
        [(north - south) * self.metres[0], (east - west) * self.metres[1]]
    }
}

/// Cuts `area` out of `elevation`. `reach(size)` says how far to the north and east (m) samples are wanted for an
/// area of that size: the last regions may go beyond it.
///
/// # Errors
/// If the area does not go with the file or lies outside it.
pub fn cut(
    elevation: &Elevation,
    area: Area,
    reach: impl FnOnce([f64; 2]) -> Result<[f64; 2], SurveyError>,
) -> Result<Cut, SurveyError> {
    let grid = elevation.grid();
    let placed = place(&grid, area)?;
    let size = placed.size();
    let [south, west, ..] = placed.area;
    let patch = match &placed.resampled {
        Some(plane) => {
            check_resampled(&grid, elevation.file_size, plane, size)?;
            resample(elevation, plane, size, reach(size)?)
        }
        None => {
            check_inside(&grid, placed.area)?;
            take(elevation, [south, west], placed.metres, reach(size)?)
        }
    };
    let mut warnings = Vec::new();
    elevation.frame.sphere().into_iter().for_each(|radius| warn_of_sphere(radius, &mut warnings));
    if let Frame::Geographic { .. } = elevation.frame {
        match placed.resampled {
            Some(_) => warnings.push("heights are interpolated between the samples of the file".into()),
            None => warn_of_stretch(placed.area, &mut warnings),
        }
    }
    let at = size.map(|length| 0.5 * length);
    let map = MapFrame {
        projection: placed.projection,
        coordinates: match elevation.frame {
            Frame::Plane(_) => FileCoordinates::Metres,
            Frame::Geographic { .. } => FileCoordinates::Degrees,
        },
        origin: placed.origin,
        first_sample: patch.first,
        spacing: patch.step,
    };
    let true_north = map.true_north(at);
    let georeference =
        placed.centre.map(|[latitude, longitude]| Georeference { latitude, longitude, at, true_north });
    Ok(Cut { patch, area: placed.area, georeference, map, true_north, warnings })
}

pub(crate) fn place(elevation: &Grid, area: Area) -> Result<Placed, SurveyError> {
    match (elevation.frame, area) {
        (Frame::Plane(projection), Area::Whole) => Ok(in_plane(elevation.extent(), projection)),
        (Frame::Plane(projection), Area::Metres { south, west, north, east }) => {
            Ok(in_plane([south, west, north, east], projection))
        }
        (Frame::Plane(None), Area::Centred { .. }) => Err(SurveyError::AreaKind {
            found: "by centre",
            reason: "the file does not say how its metres lie on the Moon",
            advice: "give the area in metres",
        }),
        (Frame::Plane(Some(projection)), Area::Centred { latitude, longitude, size, .. }) => {
            let [south, west, north, east] = elevation.extent();
            let middle = [0.5 * (south + north), 0.5 * (west + east)];
            let there = projection.forward_near(latitude, longitude, middle);
            let [north, east] = there.ok_or(SurveyError::AreaKind {
                found: "by centre",
                reason: "the projection of the file does not show this point",
                advice: "give the area in metres",
            })?;
            let [a, b] = size.map(|length| 0.5 * length);
            Ok(in_plane([north - a, east - b, north + a, east + b], Some(projection)))
        }
        (Frame::Geographic { .. }, Area::Metres { .. }) => Err(SurveyError::AreaKind {
            found: "in metres",
            reason: "the file is in degrees",
            advice: "give the area by its centre and size",
        }),
        (Frame::Geographic { radius }, Area::Whole) => {
            let [south, west, north, east] = elevation.extent();
            Ok(on_sphere(radius, 0.5 * (south + north), 0.5 * (west + east), [south, west, north, east]))
        }
        (
            Frame::Geographic { radius },
            Area::Centred { latitude, longitude, size, plane: Plane::Orthographic },
        ) => {
            let [a, b] = size.map(|length| 0.5 * length);
            let longitude = around(longitude);
            let plane =
                Projection { method: Method::Orthographic, latitude, longitude, radius, offset: [0.0; 2] };
            let area = [-a, -b, a, b];
            Ok(Placed {
                metres: [1.0; 2],
                resampled: Some(plane),
                projection: Some(plane),
                origin: [-a, -b],
                ..on_sphere(radius, latitude, longitude, area)
            })
        }
        (Frame::Geographic { radius }, Area::Centred { latitude, longitude, size, .. }) => {
            let (a, b) = (0.5 * size[0] / radius, 0.5 * size[1] / (radius * libm::cos(latitude)));
            // The file may count longitude from another meridian.
            let middle = 0.5 * (elevation.extent()[1] + elevation.extent()[3]);
            let x = middle + wrap(longitude - middle);
            Ok(on_sphere(radius, latitude, longitude, [latitude - a, x - b, latitude + a, x + b]))
        }
    }
}

fn in_plane(area: [f64; 4], projection: Option<Projection>) -> Placed {
    let middle = [0.5 * (area[0] + area[2]), 0.5 * (area[1] + area[3])];
    let on_moon = projection.filter(|p| is_moon(p.radius));
    Placed {
        area,
        metres: [1.0; 2],
        centre: on_moon.and_then(|p| p.inverse(middle)),
        resampled: None,
        projection,
        origin: [area[0], area[1]],
    }
}

fn on_sphere(radius: f64, latitude: f64, longitude: f64, area: [f64; 4]) -> Placed {
    let metres = [radius, radius * libm::cos(latitude)];
    let method = Method::Equirectangular { parallel: latitude };
    let middle = wrap(longitude);
    let plane = Projection { method, latitude: 0.0, longitude: middle, radius, offset: [0.0; 2] };
    // Edges may be counted from another meridian than the middle.
    let west = 0.5 * (area[1] - area[3]);
    Placed {
        area,
        metres,
        centre: is_moon(radius).then_some([latitude, middle]),
        projection: Some(plane),
        origin: [radius * area[0], metres[1] * west],
        resampled: None,
    }
}

/// Whether a sphere of that radius (m) is the Moon: a bank has a place there only.
fn is_moon(radius: f64) -> bool {
    (radius - LUNOID_RADIUS).abs() < 1000.0
}

pub(crate) fn check_inside(elevation: &Grid, area: [f64; 4]) -> Result<(), SurveyError> {
    let (held, step) = (elevation.extent(), elevation.affine.step.map(f64::abs));
    let geographic = matches!(elevation.frame, Frame::Geographic { .. });
    let around = elevation.turn().is_some();
    let fits = |axis: usize| {
        let free = axis == 1 && around;
        free || (area[axis] >= held[axis] - step[axis] && area[2 + axis] <= held[2 + axis] + step[axis])
    };
    let sane = area.iter().all(|edge| edge.is_finite()) && area[2] > area[0] && area[3] > area[1];
    let at_most_a_turn = !around || area[3] - area[1] <= 2.0 * PI * (1.0 + 1e-9);
    if sane && at_most_a_turn && fits(0) && fits(1) {
        return Ok(());
    }
    let text = |edges: [f64; 4]| {
        let [s, w, n, e] = if geographic { edges.map(degrees) } else { edges };
        let unit = if geographic { "deg" } else { "m" };
        format!("south {s:.4}, west {w:.4}, north {n:.4}, east {e:.4} {unit}")
    };
    Err(SurveyError::AreaOutside { found: text(area), extent: text(held) })
}

/// The centre must lie in the file, and the plane must not be larger than what the file can fill.
pub(crate) fn check_resampled(
    elevation: &Grid,
    file_size: [usize; 2],
    plane: &Projection,
    size: [f64; 2],
) -> Result<(), SurveyError> {
    let held = elevation.extent();
    let middle = 0.5 * (held[1] + held[3]);
    let longitude = middle + wrap(plane.longitude - middle);
    let step = elevation.affine.step.map(f64::abs);
    let within = |at: f64, low: f64, high: f64, step: f64| at >= low - step && at <= high + step;
    let inside = within(plane.latitude, held[0], held[2], step[0])
        && (elevation.turn().is_some() || within(longitude, held[1], held[3], step[1]));
    let samples = size.iter().map(|length| length / (plane.radius * step[0])).product::<f64>();
    let fits = samples <= 4.0 * file_size[0] as f64 * file_size[1] as f64;
    if inside && fits && size.iter().all(|length| *length > 0.0 && *length < 1.4 * plane.radius) {
        return Ok(());
    }
    let [s, w, n, e] = held.map(degrees);
    let found = format!(
        "{} m x {} m around {}, {}",
        size[0],
        size[1],
        text::latitude(degrees(plane.latitude), 4),
        text::longitude(degrees(plane.longitude), 4)
    );
    let extent = format!("south {s:.4}, west {w:.4}, north {n:.4}, east {e:.4} deg");
    Err(SurveyError::AreaOutside { found, extent })
}

/// One axis of the file seen from the bank: the first sample at or above the origin, and the direction.
struct Walk {
    file_first: i64,
    file_step: i64,
    first: f64,
    step: f64,
    count: usize,
}

fn walk(first: f64, step: f64, samples: usize, origin: f64, metres: f64, wanted: f64) -> Walk {
    let (start, file_start, file_step) = if step > 0.0 {
        (first, 0, 1)
    } else {
        (first + step * (samples - 1) as f64, samples as i64 - 1, -1)
    };
    let step = step.abs();
    let exact = (origin - start) / step;
    // A sample on the edge belongs to the area, also when its place is rounded.
    let index = (exact - 1e-6).ceil();
    let offset = ((index - exact) * step * metres).max(0.0);
    let count = ((wanted - offset) / (step * metres) + 1e-6).floor().max(0.0) as usize + 1;
    Walk {
        file_first: file_start + file_step * index as i64,
        file_step,
        first: offset,
        step: step * metres,
        count,
    }
}

fn take(elevation: &Elevation, origin: [f64; 2], metres: [f64; 2], wanted: [f64; 2]) -> Patch {
    let counts = [elevation.lines, elevation.columns];
    let affine = elevation.affine;
    let [north, east] =
        [0, 1].map(|k| walk(affine.first[k], affine.step[k], counts[k], origin[k], metres[k], wanted[k]));
    let turn = elevation.grid().turn();
    let mut heights = Vec::with_capacity(north.count * east.count);
    for i in 0..north.count {
        let line = usize::try_from(north.file_first + i as i64 * north.file_step).unwrap_or(usize::MAX);
        for j in 0..east.count {
            let column = east.file_first + j as i64 * east.file_step;
            let column = turn.map_or(column, |turn| column.rem_euclid(turn as i64));
            let column = usize::try_from(column).unwrap_or(usize::MAX);
            heights.push(elevation.height(line, column).unwrap_or(f64::NAN));
        }
    }
    // Columns count once around the globe, from the file's own first one.
    let file = Grid { columns: elevation.file_size[1], ..elevation.grid() };
    let column = east.file_first + elevation.corner[1] as i64;
    let column = file.turn().map_or(column, |turn| column.rem_euclid(turn as i64));
    Patch {
        first: [north.first, east.first],
        step: [north.step, east.step],
        count: [north.count, east.count],
        heights,
        file_first: [north.file_first + elevation.corner[0] as i64, column],
        file_step: [north.file_step, east.file_step],
    }
}

/// Heights on a square grid of a plane, with the spacing that the file has to the north.
fn resample(elevation: &Elevation, plane: &Projection, size: [f64; 2], wanted: [f64; 2]) -> Patch {
    let step = plane.radius * elevation.affine.step[0].abs();
    let count = wanted.map(|length| (length / step + 1e-6).floor() as usize + 1);
    let mut heights = Vec::with_capacity(count[0] * count[1]);
    for (line, column) in (0..count[0]).flat_map(|line| (0..count[1]).map(move |column| (line, column))) {
        let place = [line as f64 * step - 0.5 * size[0], column as f64 * step - 0.5 * size[1]];
        let height = plane.inverse(place).and_then(|point| between(elevation, point));
        heights.push(height.unwrap_or(f64::NAN));
    }
    Patch { first: [0.0; 2], step: [step; 2], count, heights, file_first: [0; 2], file_step: [1; 2] }
}

/// Bilinear between four samples; `None` if one of them is void.
fn between(elevation: &Elevation, [latitude, longitude]: [f64; 2]) -> Option<f64> {
    let affine = elevation.affine;
    let middle = 0.5 * (elevation.extent()[1] + elevation.extent()[3]);
    let longitude = middle + wrap(longitude - middle);
    let at = [(latitude - affine.first[0]) / affine.step[0], (longitude - affine.first[1]) / affine.step[1]];
    let (floor, turn) = (at.map(f64::floor), elevation.grid().turn());
    let [u, v] = [at[0] - floor[0], at[1] - floor[1]];
    let sample = |i: i64, j: i64| {
        let column = floor[1] as i64 + j;
        let column = turn.map_or(column, |turn| column.rem_euclid(turn as i64));
        elevation.height(usize::try_from(floor[0] as i64 + i).ok()?, usize::try_from(column).ok()?)
    };
    let near = (1.0 - v) * sample(0, 0)? + v * sample(0, 1)?;
    let far = (1.0 - v) * sample(1, 0)? + v * sample(1, 1)?;
    Some((1.0 - u) * near + u * far)
}

fn warn_of_sphere(radius: f64, warnings: &mut Vec<String>) {
    if !is_moon(radius) {
        warnings.push(format!("the file lies on a sphere of radius {radius:.0} m, which is not the Moon"));
    }
}

fn warn_of_stretch([south, _, north, _]: [f64; 4], warnings: &mut Vec<String>) {
    let middle = libm::cos(0.5 * (south + north));
    let stretch = |latitude: f64| (libm::cos(latitude) / middle - 1.0).abs();
    let worst = stretch(south).max(stretch(north));
    if worst > STRETCH {
        warnings.push(format!(
            "east-west distances are off by up to {:.1} % at the edge of the area: use a smaller area or the \
             orthographic plane",
            100.0 * worst
        ));
    }
}
