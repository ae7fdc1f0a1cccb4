//! A scenario over the files of an export.

use std::fmt::Write;

use ephemeris::{elevation_and_azimuth, sun_direction};
use landscape::Bank;
use quantities::degrees;
use terrain_builder::{Export, Ground};

use crate::bodies::Object;
use crate::start::start;

/// Azimuth and elevation of the sun (degrees) where the landscape has none, or one that is down.
const USUAL_SUN_DEG: [f64; 2] = [90.0, 20.0];
/// Length of the drive (m), and its share of the ground at most.
const DRIVE_M: f64 = 10.0;
const DRIVE_SHARE: f64 = 0.02;
/// Seconds of the drive, at one metre a second or slower.
const DRIVE_S: f64 = 10.0;

/// Text of a scenario that drives north over the landscape, as near to its middle as it can.
pub(crate) fn text(
    ground: &Ground,
    bank: &Bank,
    export: &Export,
    objects: &[Object],
    has_albedo: bool,
) -> String {
    let description = ground.description();
    let grid = description.grid;
    let [[south, west], [north, east]] = grid.extent();
    let size = [north - south, east - west];
    let drive = DRIVE_M.min(DRIVE_SHARE * size[0]);
    let [x, y] = start(ground, bank, export, drive);
    let (features, objects) = (features(!export.craters.is_empty()), objects_of(objects));
    let albedo = if has_albedo { albedo(size) } else { String::new() };
    let sun = sun(ground);
    let (title, resolution) = (quoted(&description.title), grid.north.resolution);
    let (start, end) = (0.25 * resolution, size[0].max(size[1]));
    format!(
        "# Written by `lunoid terrain export`.
format = 1
title = {title}
shows = \"A drive over the middle of a landscape that the terrain builder made.\"
machine = \"ideal\"
duration_s = {DRIVE_S}

[landscape]
bank = \"ground.bank\"
database = \"terrain.lod\"
{albedo}{features}
[sun]
{sun}

[shadows]
finest_m = {finest}

[vehicle]

[path]
keyframes = [{{ t_s = 0, x_m = {x}, y_m = {y} }}, {{ t_s = {DRIVE_S}, x_m = {x_end}, y_m = {y} }}]

[raster]
sweeps = 500
update_hz = 5

[range]
programme = \"geometric\"
start_m = {start}
end_m = {end}

[display]
white = 0.8
gamma = 2.2
{objects}",
        finest = resolution.clamp(0.01, 1000.0),
        x_end = x + drive,
    )
}

/// The picture of the albedo over ground of this size (north, east; m).
fn albedo([north, east]: [f64; 2]) -> String {
    format!(
        "\n[landscape.albedo_map]\nfile = \"albedo.png\"\narea_m = [0, 0, {north}, {east}]\ncurve = \"linear\"\n"
    )
}

fn features(has_craters: bool) -> &'static str {
    if has_craters { "\n[features]\nlist = \"craters.csv\"\n" } else { "" }
}

fn objects_of(objects: &[Object]) -> String {
    let mut text = String::new();
    for (number, Object { file, at: [x, y], .. }) in objects.iter().enumerate() {
        // Writing to a text does not fail.
        let _ = write!(
            text,
            "\n[[object]]\nid = \"boulder-{number}\"\nfile = \"{file}\"\nx_m = {x}\ny_m = {y}\n"
        );
    }
    text
}

/// Keys of the sun: the landscape's sub-solar point, over the centre of the area.
fn sun(ground: &Ground) -> String {
    let centre = ground.description().frame.centre();
    let light = ground.description().light;
    match light.filter(|light| elevation_and_azimuth(sun_direction(centre, light.sub_solar))[0] > 0.0) {
        Some(light) => {
            let [[latitude, longitude], [north, east]] = [centre, light.sub_solar].map(in_degrees);
            format!(
                "sub_solar_deg = [{north}, {east}]\nplace = {{ longitude_deg = {longitude}, latitude_deg = {latitude} }}"
            )
        }
        None => {
            let [azimuth, elevation] = USUAL_SUN_DEG;
            format!("azimuth_deg = {azimuth}\nelevation_deg = {elevation}")
        }
    }
}

/// Angles in degrees, without what their rounding leaves.
fn in_degrees(angles: [f64; 2]) -> [f64; 2] {
    angles.map(|angle| (degrees(angle) * 1e10).round() / 1e10)
}

/// A text between quotes, as TOML has it: control characters, quotes and backslashes are escaped as in JSON.
fn quoted(text: &str) -> String {
    serde_json::Value::from(text).to_string()
}
