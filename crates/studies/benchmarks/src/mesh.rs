//! The ground of a scene as a mesh, drawn by a ray tracer: POV-Ray, as far from the ground as the machine's eye and with the same
//! sun, of as many pixels.
//!
//! The mesh is made for the eye: meridians as far apart on the picture as the sweeps of a machine would be, rings whose distances
//! are those of a geometric programme. Normals are those of the ground at each vertex. So the ray tracer has the finest
//! triangles where they are seen largest; that the mesh is made anew for every frame, and read, is not counted.

use std::fmt::Write as _;
use std::io;
use std::process::Command;
use std::time::Instant;

use quantities::sin_cos;
use scenario::Pose;

use crate::TimedScene;

/// What the ray tracer made of a mesh.
#[derive(Debug)]
pub struct Traced {
    /// Triangles of the mesh.
    pub triangles: usize,
    /// Reflectivity, line by line from the top left.
    pub picture: Vec<f32>,
    /// Tracing alone (s): neither reading the mesh nor dividing space.
    pub seconds: f64,
    /// The whole run (s).
    pub whole: f64,
}

/// Meridians stand this much farther out than the picture's edges: no ray passes the mesh.
const WIDER: f64 = 1.01;
/// The least of so many runs counts.
const RUNS: usize = 2;

/// Traces the ground that `scene` shows from `pose`, which looks level, by two threads; `side` meridians and as many rings. `None`
/// where there is no POV-Ray.
///
/// # Errors
/// If it ends badly or writes what nobody expects.
pub fn trace(scene: &TimedScene, pose: &Pose, side: usize) -> Result<Option<Traced>, String> {
    let folder = tempfile::tempdir().map_err(|error| error.to_string())?;
    let raster = scene.stage.settings.raster;
    let size = [raster.columns as usize, raster.lines as usize];
    let (text, triangles) = described(scene, pose, side);
    std::fs::write(folder.path().join("mesh.pov"), text).map_err(|error| error.to_string())?;
    let (mut seconds, mut whole) = (f64::INFINITY, f64::INFINITY);
    for _ in 0..RUNS {
        let begin = Instant::now();
        let [width, height] = [format!("+W{}", size[0]), format!("+H{}", size[1])];
        let options = ["+Imesh.pov", "+Omesh.ppm", "+FP16", "File_Gamma=1.0", "-D", "-A", "+WT2"];
        let run =
            Command::new("povray").args(options).args([width, height]).current_dir(folder.path()).output();
        let said = match run {
            Err(error) if error.kind() == io::ErrorKind::NotFound => return Ok(None),
            Err(error) => return Err(format!("povray: {error}")),
            Ok(ended) => String::from_utf8_lossy(&ended.stderr).into_owned(),
        };
        whole = whole.min(begin.elapsed().as_secs_f64());
        seconds = seconds.min(trace_time(&said).ok_or(format!("povray told no trace time:\n{said}"))?);
    }
    let file = std::fs::read(folder.path().join("mesh.ppm")).map_err(|error| error.to_string())?;
    let picture = pixels(&file, size[0] * size[1]).ok_or("povray wrote no 16-bit PPM of that size")?;
    Ok(Some(Traced { triangles, picture, seconds, whole }))
}

/// The seconds in brackets behind `Trace Time:`.
fn trace_time(said: &str) -> Option<f64> {
    let line = said.lines().find(|line| line.trim().starts_with("Trace Time:"))?;
    line.split('(').nth(1)?.split_whitespace().next()?.parse().ok()
}

/// The red of each pixel of a binary PPM with 65 535 levels, as a share.
fn pixels(file: &[u8], count: usize) -> Option<Vec<f32>> {
    let begin = file.len().checked_sub(6 * count)?;
    file[..begin].ends_with(b"65535\n").then_some(())?;
    let reds = file[begin..].chunks_exact(6);
    Some(reds.map(|pixel| f32::from(u16::from_be_bytes([pixel[0], pixel[1]])) / 65_535.0).collect())
}

/// Scene file and number of triangles. Axes of POV-Ray: x to the right, y up, z ahead, the eye at the origin.
fn described(scene: &TimedScene, pose: &Pose, side: usize) -> (String, usize) {
    let (settings, landscape) = (&scene.stage.settings, &scene.stage.landscape);
    let (sin, cos) = sin_cos(pose.attitude.heading);
    let turned = |[north, east, up]: [f64; 3]| [east * cos - north * sin, up, north * cos + east * sin];
    let field = settings.raster.field;
    let [start, end] = [settings.range.start, settings.range.end];
    let (mut vertices, mut normals, mut there) = (String::new(), String::new(), Vec::new());
    for ring in 0..side {
        let range = start * libm::pow(end / start, ring as f64 / (side - 1) as f64);
        for meridian in 0..side {
            let tangent = WIDER * field.tan_half_width * (2.0 * meridian as f64 / (side - 1) as f64 - 1.0);
            let ahead = 1.0 / (1.0 + tangent * tangent).sqrt();
            let [north, east] = [(cos - sin * tangent) * ahead, (sin + cos * tangent) * ahead];
            let [x, y] = [pose.eye[0] + range * north, pose.eye[1] + range * east];
            let point = landscape.at(x, y);
            let (height, slopes) = point.map_or((0.0, [0.0; 2]), |point| (point.height, point.slopes));
            let [right, up, far] = turned([range * north, range * east, height - pose.eye[2]]);
            let _ = writeln!(vertices, ",<{right:.7},{up:.7},{far:.7}>");
            let [right, up, far] = turned([-slopes[0], -slopes[1], 1.0]);
            let _ = writeln!(normals, ",<{right:.9},{up:.9},{far:.9}>");
            there.push(point.is_some());
        }
    }
    let (mut faces, mut triangles) = (String::new(), 0);
    for [ring, meridian] in (0..side - 1).flat_map(|ring| (0..side - 1).map(move |meridian| [ring, meridian]))
    {
        let near = ring * side + meridian;
        for corners in [[near, near + side, near + 1], [near + 1, near + side, near + side + 1]] {
            if corners.iter().all(|&corner| there[corner]) {
                let _ = writeln!(faces, ",<{},{},{}>", corners[0], corners[1], corners[2]);
                triangles += 1;
            }
        }
    }
    let sun = turned(scene.stage.scenery.sun(pose.time).direction()).map(|part| 1e7 * part);
    let text = format!(
        "#version 3.7;
global_settings {{ assumed_gamma 1.0 max_trace_level 1 }}
background {{ rgb 0 }}
camera {{ perspective location 0 direction z right x*{width:.12} up y*{height:.12} }}
light_source {{ <{},{},{}> rgb 1 parallel point_at 0 shadowless }}
mesh2 {{
vertex_vectors {{ {count}
{vertices}}}
normal_vectors {{ {count}
{normals}}}
face_indices {{ {triangles}
{faces}}}
pigment {{ rgb 1 }} finish {{ ambient 0 diffuse {albedo} }}
}}
",
        sun[0],
        sun[1],
        sun[2],
        width = 2.0 * field.tan_half_width,
        height = 2.0 * field.tan_half_height,
        count = side * side,
        albedo = landscape.albedo(),
    );
    (text, triangles)
}

#[cfg(test)]
mod tests {
    use super::{pixels, trace_time};

    #[test]
    fn what_the_ray_tracer_writes_is_read() {
        let said = "Render Time:\n  Trace Time:       0 hours  0 minutes  1 seconds (1.250 seconds)\n  using 2 thread(s)";
        assert_eq!(trace_time(said), Some(1.25));
        assert_eq!(trace_time("Render Time:\n"), None);
        let mut file = b"P6\n2 1\n65535\n".to_vec();
        file.extend([0x80, 0, 1, 1, 1, 1, 0xff, 0xff, 0, 0, 0, 0]);
        assert_eq!(pixels(&file, 2), Some(vec![32_768.0 / 65_535.0, 1.0]));
        assert_eq!(pixels(&file, 3), None);
    }
}
