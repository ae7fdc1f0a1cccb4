//! The artificial block of the thesis as we choose it: posts, a photograph from the constants of the listing, three observers.

use std::sync::OnceLock;

use glam::DVec3;
use panel_program::{Lie, Posts, View};
use photo_camera::{Affine, Axes, Camera, CameraFile, Ellipsoid, Geodetic, Light, Orientation};
use photograph::{Photograph, Placement};
use picture::{Depth, GreyPicture};

/// A second of arc (rad).
pub const SECOND: f64 = std::f64::consts::PI / 648_000.0;

/// Posts of the real set: rows 71 to 79, columns 172 to 183 beyond the reference.
pub const ROWS: [usize; 2] = [71, 79];
pub const COLUMNS: [usize; 2] = [172, 183];

/// Ground, lower and upper block: rows, columns, height (m), grey.
pub const LEVELS: [([f64; 2], [f64; 2], f64, u16); 3] = [
    ([74.0, 76.0], [176.0, 179.0], 83.0, 200),
    ([72.0, 78.0], [174.0, 181.0], 43.0, 120),
    ([f64::NEG_INFINITY, f64::INFINITY], [f64::NEG_INFINITY, f64::INFINITY], 3.0, 60),
];

/// Corner I, J of the frame in the photograph, as frames count: L10241024.
pub const FRAME: [f64; 2] = [1024.0, 1024.0];

/// An angle (rad) of degrees, minutes and seconds.
pub fn angle(degrees: f64, minutes: f64, seconds: f64) -> f64 {
    (3600.0 * degrees + 60.0 * minutes + seconds) * SECOND
}

/// Latitude and longitude (rad) of the first post of the grid, row 0 and column 0.
pub fn reference() -> [f64; 2] {
    [angle(37.0, 22.0, 47.0), -angle(122.0, 5.0, 3.0)]
}

pub fn lie() -> Lie {
    Lie::Degrees { body: Ellipsoid::CLARKE_1866, reference: reference(), at: [0.0, 0.0] }
}

/// Place (north, east; m) of a row and a column.
pub fn place(row: f64, column: f64) -> [f64; 2] {
    let [latitude, longitude] = reference();
    lie().place(latitude + row * SECOND, longitude + column * SECOND).unwrap()
}

/// Posts of the real set, moved north by `shift` seconds of arc, with heights (m) by row and column.
pub fn posts(shift: f64, height: impl Fn(usize, usize) -> f64) -> Posts {
    let rows = ROWS[0]..=ROWS[1];
    let all = rows.flat_map(|row| (COLUMNS[0]..=COLUMNS[1]).map(move |column| (row, column)));
    let post = |(row, column): (usize, usize)| {
        let [north, east] = place(row as f64 + shift, column as f64);
        DVec3::new(north, east, height(row, column))
    };
    Posts { size: [ROWS[1] - ROWS[0] + 1, COLUMNS[1] - COLUMNS[0] + 1], places: all.map(post).collect() }
}

/// The level of a row and column: height (m) and grey.
fn level(row: f64, column: f64) -> (f64, u16) {
    let inside = |range: [f64; 2], at: f64| (range[0]..=range[1]).contains(&at);
    let found = LEVELS.iter().find(|(rows, columns, ..)| inside(*rows, row) && inside(*columns, column));
    found.map_or((3.0, 60), |(.., height, grey)| (*height, *grey))
}

/// The artificial block on the posts of the real set.
pub fn block(shift: f64) -> Posts {
    posts(shift, |row, column| level(row as f64, column as f64).0)
}

/// The camera of the listing over a frame; its first pixel is the frame's north-eastern one turned by 180 degrees.
pub fn camera(frame: [f64; 2]) -> Camera {
    let [a1, b1, c1] = [20.11323959, 6.01620794, -34954.59484];
    let [a2, b2, c2] = [-6.022849824, 20.10938801, -22566.71593];
    let [i, j] = [frame[0], 5000.0 - frame[1]];
    let row = |a: f64, b: f64, c: f64| [a, -b, c + a * i + b * j];
    let affine = Affine::new(row(a1, b1, c1), row(a2, b2, c2)).unwrap();
    let orientation = Orientation::from_angles([0.8341764, -0.4563699, 3.0761254]).unwrap();
    let centre = DVec3::new(-2_693_765.9, -4_304_520.4, 3_859_018.3);
    Camera::new(0.153197, [2e-6, 0.0], centre, orientation, affine).unwrap()
}

/// The camera file of a frame.
pub fn camera_file(frame: [f64; 2]) -> CameraFile {
    let axes = Axes::Body(Ellipsoid::CLARKE_1866);
    CameraFile { camera: camera(frame), axes, light: Light::default() }
}

/// The picture of a frame over the block moved north by `shift` seconds: each pixel has the grey of the highest level that its ray meets.
pub fn picture(frame: [f64; 2], shift: f64) -> GreyPicture {
    let (camera, body) = (camera(frame), Ellipsoid::CLARKE_1866);
    let [latitude, longitude] = reference();
    let code = |pixel: usize| {
        let ray = camera.ray([pixel % 512, pixel / 512].map(|at| at as f64 + 0.5));
        let seen = LEVELS.iter().find_map(|&(rows, columns, height, grey)| {
            let Geodetic { latitude: north, longitude: east, .. } = body.place(ray.on_body(&body, height)?);
            let [row, column] = [(north - latitude) / SECOND - shift, (east - longitude) / SECOND];
            let inside = |range: [f64; 2], at: f64| (range[0]..=range[1]).contains(&at);
            (inside(rows, row) && inside(columns, column)).then_some(grey)
        });
        seen.unwrap_or(0)
    };
    GreyPicture::new(512, 512, Depth::Eight, (0..512 * 512).map(code).collect()).unwrap()
}

/// The photograph of a frame.
pub fn photograph(frame: [f64; 2], shift: f64) -> Photograph {
    let placement = Placement::Camera { camera: camera(frame), axes: Axes::Body(Ellipsoid::CLARKE_1866) };
    Photograph::new(picture(frame, shift), placement, Light::default()).unwrap()
}

/// The photograph of the frame of the set, painted once.
pub fn usual() -> &'static Photograph {
    static USUAL: OnceLock<Photograph> = OnceLock::new();
    USUAL.get_or_init(|| photograph(FRAME, 0.0))
}

/// The view of an observer (latitude, longitude in rad; height in m) to the north, level. The full field is twice the quadrant's.
pub fn view([latitude, longitude]: [f64; 2], height: f64) -> View {
    let [north, east] = lie().place(latitude, longitude).unwrap();
    View {
        eye: DVec3::new(north, east, height),
        axes: [DVec3::Y, -DVec3::Z, DVec3::X],
        half_field: [1600.0 / 15_000.0; 2],
        size: [512; 2],
    }
}

/// The three observers of the thesis.
pub fn observer(number: usize) -> View {
    let longitude = -angle(122.0, 1.0, 59.0);
    match number {
        1 => view([angle(37.0, 22.0, 30.0), longitude], 110.0),
        2 => view([angle(37.0, 20.0, 0.0), longitude], 110.0),
        _ => view([angle(37.0, 23.0, 30.0), longitude], 160.0),
    }
}
