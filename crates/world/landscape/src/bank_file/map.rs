//! The section `map`: how the axes of a bank lie in the map of its elevation file.

use std::f64::consts::PI;

use crate::BankError;
use crate::map_frame::{FileCoordinates, MapFrame};
use crate::projection::{Method, Projection};

/// Bytes of the section.
pub(super) const LENGTH: usize = 104;

/// Words of the section behind its two codes.
const NUMBERS: usize = 12;

/// A value that cannot be: its byte in the section, what was found, what was expected.
pub(super) struct MapFault {
    pub at: usize,
    pub found: String,
    pub expected: String,
}

/// Bytes of the section.
pub(super) fn payload(map: &MapFrame) -> Vec<u8> {
    let (code, numbers) = words(map);
    let coordinates: u32 = match map.coordinates {
        FileCoordinates::Metres => 0,
        FileCoordinates::Degrees => 1,
    };
    let codes = [code, coordinates].into_iter().flat_map(u32::to_le_bytes);
    codes.chain(numbers.iter().flat_map(|value| value.to_le_bytes())).collect()
}

/// Whether a bank may have this map: what is wrong with the first number that is out of its range.
pub(super) fn check(map: &MapFrame) -> Result<(), BankError> {
    let (code, numbers) = words(map);
    match out_of_range(code, &numbers) {
        None => Ok(()),
        Some((index, (low, high, what))) => Err(BankError::Map { what, found: numbers[index], low, high }),
    }
}

/// Code of the projection, and the numbers of the section.
fn words(map: &MapFrame) -> (u32, [f64; NUMBERS]) {
    let (code, parameter) = match map.projection.map(|projection| projection.method) {
        None => (0_u32, 0.0),
        Some(Method::Equirectangular { parallel }) => (1, parallel),
        Some(Method::PolarStereographic { scale }) => (2, scale),
        Some(Method::Orthographic) => (3, 0.0),
    };
    let [latitude, longitude, radius] =
        map.projection.map_or([0.0; 3], |p| [p.latitude, p.longitude, p.radius]);
    let offset = map.projection.map_or([0.0; 2], |projection| projection.offset);
    let pairs =
        [[radius, parameter], [latitude, longitude], offset, map.origin, map.first_sample, map.spacing];
    (code, std::array::from_fn(|index| pairs[index / 2][index % 2]))
}

/// The first number that is out of its range, by its index, with that range.
fn out_of_range(code: u32, numbers: &[f64; NUMBERS]) -> Option<(usize, Range)> {
    let ranges = ranges(code).into_iter().enumerate();
    ranges.into_iter().find(|&(index, (low, high, _))| !(low..=high).contains(&numbers[index]))
}

/// The frame in the bytes of the section.
pub(super) fn read(bytes: &[u8; LENGTH]) -> Result<MapFrame, MapFault> {
    let code = |at: usize| u32::from_le_bytes(std::array::from_fn(|index| bytes[at + index]));
    let number = |index: usize| f64::from_le_bytes(std::array::from_fn(|byte| bytes[8 + 8 * index + byte]));
    let numbers: [f64; NUMBERS] = std::array::from_fn(number);
    let coordinates = match code(4) {
        0 => FileCoordinates::Metres,
        1 => FileCoordinates::Degrees,
        other => return Err(fault(4, other, "0 (metres) or 1 (degrees)".into())),
    };
    let known = code(0);
    if known > 3 {
        return Err(fault(
            0,
            known,
            "0 to 3: no projection, equirectangular, polar stereographic, orthographic".into(),
        ));
    }
    if let Some((index, (low, high, what))) = out_of_range(known, &numbers) {
        return Err(fault(8 + 8 * index, numbers[index], format!("{what} within {low} to {high}")));
    }
    let [radius, parameter, latitude, longitude, north, east, origin_north, origin_east, ..] = numbers;
    let method = match known {
        0 => None,
        1 => Some(Method::Equirectangular { parallel: parameter }),
        2 => Some(Method::PolarStereographic { scale: parameter }),
        _ => Some(Method::Orthographic),
    };
    let of_method = |method| Projection { method, latitude, longitude, radius, offset: [north, east] };
    Ok(MapFrame {
        projection: method.map(of_method),
        coordinates,
        origin: [origin_north, origin_east],
        first_sample: [numbers[8], numbers[9]],
        spacing: [numbers[10], numbers[11]],
    })
}

fn fault(at: usize, found: impl ToString, expected: String) -> MapFault {
    MapFault { at, found: found.to_string(), expected }
}

/// Least and largest value of a number, and its name.
type Range = (f64, f64, &'static str);

/// Range and name of each number.
fn ranges(projection: u32) -> [Range; NUMBERS] {
    const FAR: f64 = 1e12;
    let radius = if projection == 0 { (0.0, 0.0, "no radius") } else { (1.0, 1e9, "radius") };
    let parameter = match projection {
        // At a pole nothing is true to scale.
        1 => (-0.5 * PI + 1e-9, 0.5 * PI - 1e-9, "parallel"),
        2 => (1e-6, 1e6, "scale"),
        _ => (0.0, 0.0, "no parameter"),
    };
    [
        radius,
        parameter,
        (-0.5 * PI, 0.5 * PI, "latitude"),
        (-2.0 * PI, 2.0 * PI, "longitude"),
        (-FAR, FAR, "false northing"),
        (-FAR, FAR, "false easting"),
        (-FAR, FAR, "north of the origin"),
        (-FAR, FAR, "east of the origin"),
        (-FAR, FAR, "north of the south-west sample"),
        (-FAR, FAR, "east of the south-west sample"),
        (0.0, FAR, "spacing to the north"),
        (0.0, FAR, "spacing to the east"),
    ]
}
