//! The Apollo 17 path: the rule of `docs/real-ground.md` by which stops become rows.

use std::fmt::Write as _;
use std::path::Path;

use landscape::{Georeference, LUNOID_RADIUS};
use quantities::{degrees, radians};

/// Mean speed of a leg (m/s). The curve through the rows starts and ends at rest, so its peak is half as much again.
const SPEED: f64 = 3.0;
/// Stay at every stop (s), in which the vehicle turns to the next leg.
const STAY: f64 = 60.0;

/// Latitude and longitude (degrees) of the stops in order, without those that have no position.
pub fn read(file: &Path) -> Vec<[f64; 2]> {
    let text = std::fs::read_to_string(file).expect("the stops");
    let place = |line: &str| {
        let cells: Vec<&str> = line.split(',').collect();
        Some([cells[5].parse().ok()?, cells[6].parse().ok()?])
    };
    let mut stops: Vec<[f64; 2]> = text.lines().skip(1).filter_map(place).collect();
    // An excursion begins where the one before it ended.
    stops.dedup();
    stops
}

/// Rows of the path: arrival at and departure from every stop.
pub fn rows(stops: &[[f64; 2]], georeference: Georeference) -> String {
    let places: Vec<[f64; 2]> = stops.iter().map(|stop| in_bank(*stop, georeference)).collect();
    let legs: Vec<[f64; 2]> = places.windows(2).map(|ends| leg(ends[0], ends[1])).collect();
    let mut text = String::from("t_s,x_m,y_m,heading_deg\n");
    let mut time = 0.0;
    for (stop, [x, y]) in places.iter().enumerate() {
        let arrival = legs[stop.saturating_sub(1)][1];
        let departure = legs.get(stop).map_or(arrival, |leg| leg[1]);
        for (time, heading) in [(time, arrival), (time + STAY, departure)] {
            writeln!(text, "{time:.1},{x:.1},{y:.1},{heading:.1}").expect("a text takes all");
        }
        time += STAY + legs.get(stop).map_or(0.0, |leg| leg[0] / SPEED);
    }
    text
}

/// Equirectangular, true to scale along the parallel of the bank's centre: as the survey lays the file down.
fn in_bank([latitude, longitude]: [f64; 2], centre: Georeference) -> [f64; 2] {
    [
        centre.at[0] + LUNOID_RADIUS * (radians(latitude) - centre.latitude),
        centre.at[1] + LUNOID_RADIUS * libm::cos(centre.latitude) * (radians(longitude) - centre.longitude),
    ]
}

/// Length (m) and heading (degrees).
fn leg(from: [f64; 2], to: [f64; 2]) -> [f64; 2] {
    let [north, east] = [to[0] - from[0], to[1] - from[1]];
    [libm::hypot(north, east), degrees(libm::atan2(east, north)).rem_euclid(360.0)]
}
