//! A photograph of 25 million pixels over a million posts: against Embree and OSMesa with the same texture, two threads
//! against one, and memory.
//!
//! The ground is that of `photo-drape`; its photographs make room for a map that this program makes: waves of grey, 0.16 m a pixel.

use std::fmt::Write as _;
use std::fs;
use std::path::Path;

use benchmarks::peers::embree::{EyeMesh, Program, camera_sight, screen_mesh};
use benchmarks::peers::median;
use glam::DVec3;
use picture::{Depth, GreyPicture, encode_png};
use quantities::sin_cos;
use rayon::ThreadPool;
use scenario::Pose;
use scene_sampler::Camera;

use crate::guests::{OsMesa, Sense, Side, SideChoice, fastest};
use crate::row::Row;

/// Scenario whose ground it is, and the side of that ground (m).
const SCENARIO: &str = "photo-drape";
const GROUND: f64 = 800.0;
/// Distance of posts (m): a million of them.
const SPACING: f64 = 0.8;
/// Pixels up to which coarser panels may lie beside those of all posts, as the issue allows.
const COARSER: f64 = 0.5;
/// Pixels along a side of the photograph.
const PIXELS: usize = 5000;
/// Columns and lines of the picture.
const PICTURE: [i64; 2] = [525, 480];
/// Turns of each side.
const TURNS: usize = 7;
/// Mean difference of two pictures up to which they show the same (light). Chosen: Embree looks a texture up without its smaller pictures.
const ALIKE: f64 = 0.05;
/// Memory that must not be passed, and that is aimed at (MB).
const MEMORY: [f64; 2] = [200.0, 100.0];

/// Lines of the table.
pub fn lines(
    [one, two]: &[ThreadPool; 2],
    peak: impl Fn(&str) -> Result<f64, String>,
) -> Result<String, String> {
    let folder = tempfile::tempdir().map_err(|error| error.to_string())?;
    let lights = photograph(folder.path())?;
    let scenario = write_scenario(folder.path())?;
    let choice = SideChoice { scenario: scenario.clone(), ..SideChoice::default() };
    let [mut side, mut alone] = [two.install(|| Side::new(&choice))?, two.install(|| Side::new(&choice))?];
    let mut text = String::new();
    side.draw(two)?;
    alone.draw(one)?;
    let times = in_turns(|| side.draw(two), || alone.draw(one))?;
    let quantity = "drape of a million posts and 25 million pixels: two threads against one".to_owned();
    text += &Row::of_times(38, quantity, (Sense::AsFast, [1.8, 1.95]), times, String::new()).line();
    drop(alone);
    let mesh = textured(&mut side, two)?;
    for row in
        [against_embree(&mut side, two, &mesh, &lights)?, against_osmesa(&mut side, two, &mesh, &lights)?]
    {
        match row {
            Ok(row) => text += &row.line(),
            Err(missing) => {
                let _ = writeln!(text, "| 38 | {missing} | | | | | | | |");
            }
        }
    }
    let found = peak(&scenario)?;
    let [must, aim] = MEMORY;
    let met = if found <= must { "met" } else { "**not met**" };
    let _ = writeln!(
        text,
        "| 38 | peak memory of that drape, three frames, MB | {must} | {aim} | {found:.1} MB | {met} | | | |"
    );
    Ok(text)
}

/// Level of the photograph's pixels along a side: waves that no mesh of triangles has.
fn waves(length: f64) -> Vec<f64> {
    (0..PIXELS).map(|at| 0.25 * sin_cos(at as f64 / length).0).collect()
}

/// Writes the photograph, its camera, and gives its light, line by line from the top.
fn photograph(folder: &Path) -> Result<Vec<f32>, String> {
    let (across, down) = (waves(31.0), waves(47.0));
    let level = |pixel: usize| 0.5 + across[pixel % PIXELS] + down[pixel / PIXELS];
    let codes: Vec<u16> = (0..PIXELS * PIXELS).map(|pixel| (255.0 * level(pixel)) as u16).collect();
    let lights = codes.iter().map(|code| f32::from(*code) / 255.0).collect();
    let picture = GreyPicture::new(PIXELS, PIXELS, Depth::Eight, codes).map_err(|error| error.to_string())?;
    let bytes = encode_png(&picture, &[]).map_err(|error| error.to_string())?;
    fs::write(folder.join("map.png"), bytes).map_err(|error| error.to_string())?;
    let pixel = GROUND / PIXELS as f64;
    let camera = format!(
        r#"{{ "format": 1, "camera": "map", "unit": "m", "east_of_pixel": [{pixel}, 0, 0], "north_of_pixel": [0, -{pixel}, {GROUND}] }}"#
    );
    fs::write(folder.join("map.json"), camera).map_err(|error| error.to_string())?;
    Ok(lights)
}

/// Writes the scenario with that photograph alone: its path without the ending.
fn write_scenario(folder: &Path) -> Result<String, String> {
    let shipped = Path::new(concat!(env!("CARGO_MANIFEST_DIR"), "/../../../scenarios"));
    let read =
        |name: String| fs::read_to_string(shipped.join(&name)).map_err(|error| format!("{name}: {error}"));
    let mut scenario: toml::Table =
        read(format!("{SCENARIO}.toml"))?.parse().map_err(|error| format!("{SCENARIO}: {error}"))?;
    let table = |text: &str| text.parse::<toml::Table>().map_err(|error| error.to_string());
    let [columns, lines] = PICTURE;
    let made = table(&format!(
        "raster = {{ columns = {columns}, lines = {lines}, update_hz = 10 }}\n\
         photograph = [{{ file = \"map.png\", camera = \"map.json\" }}]\n\
         panels = {{ spacing_m = {SPACING}, coarser_px = {COARSER}, pattern = \"1\" }}\n"
    ))?;
    scenario.extend(made);
    fs::write(folder.join("drape.toml"), scenario.to_string()).map_err(|error| error.to_string())?;
    let path = format!("{SCENARIO}.csv");
    fs::write(folder.join(&path), read(path.clone())?).map_err(|error| error.to_string())?;
    Ok(folder.join("drape").display().to_string())
}

/// The picture of a pose, and all panels before its camera: places on the photograph in place of normals.
struct Textured {
    picture: Vec<f32>,
    mesh: EyeMesh,
}

fn textured(side: &mut Side, two: &ThreadPool) -> Result<Textured, String> {
    side.draw(two)?;
    let (picture, frame, pose) = side.picture()?;
    let faces = side.session().faces(frame, &pose).map_err(|error| error.to_string())?;
    let mut mesh = screen_mesh(&faces.ok_or("panels have faces")?, &side.stage.view);
    name_pixels(&mut mesh, &Camera::new(&pose, &side.stage.view), &pose);
    Ok(Textured { picture, mesh })
}

/// The drape against Embree over all panels, with the photograph as a texture.
fn against_embree(
    side: &mut Side,
    two: &ThreadPool,
    textured: &Textured,
    lights: &[f32],
) -> Result<Result<Row, String>, String> {
    let program = match Program::compile()? {
        Ok(program) => program,
        Err(missing) => return Ok(Err(missing)),
    };
    let mut embree = program.start(&textured.mesh, &camera_sight(&side.stage.view, 1))?;
    embree.texture([PIXELS; 2], lights)?;
    let (packet, _) = fastest(&mut embree, false, |embree, packet| embree.drape(packet))?;
    let apart = alike(&textured.picture, &embree.picture()?)?;
    let times = in_turns(|| side.draw(two), || embree.drape(packet))?;
    let quantity = format!(
        "drape of a million posts and 25 million pixels into {} x {}, pattern 1, within {COARSER} pixels, against Embree with the same texture, space divided before",
        PICTURE[0], PICTURE[1]
    );
    let remark = format!(
        "{} triangles, packets of {packet}; pictures differ by {apart:.4}",
        textured.mesh.faces.len()
    );
    Ok(Ok(Row::of_times(38, quantity, (Sense::AsFast, [1.0, 3.0]), times, remark)))
}

/// The same against OSMesa over all panels, with its buffer made before.
fn against_osmesa(
    side: &mut Side,
    two: &ThreadPool,
    textured: &Textured,
    lights: &[f32],
) -> Result<Result<Row, String>, String> {
    let mut osmesa = match OsMesa::new(&textured.mesh, &camera_sight(&side.stage.view, 1))? {
        Ok(osmesa) => osmesa,
        Err(missing) => return Ok(Err(missing)),
    };
    osmesa.texture([PIXELS; 2], lights)?;
    osmesa.show(false)?;
    let apart = alike(&textured.picture, &osmesa.picture()?)?;
    let times = in_turns(|| side.draw(two), || osmesa.show(false))?;
    let remark = format!("{} triangles; pictures differ by {apart:.4}", textured.mesh.faces.len());
    let quantity = "the same against OSMesa, its buffers filled before".to_owned();
    Ok(Ok(Row::of_times(38, quantity, (Sense::AsFast, [3.0, 10.0]), times, remark)))
}

/// Mean difference of two pictures.
///
/// # Errors
/// If they do not show the same ground.
fn alike(picture: &[f32], other: &[f32]) -> Result<f64, String> {
    let pairs = picture.iter().zip(other);
    let apart =
        pairs.map(|(ours, other)| f64::from((ours - other).abs())).sum::<f64>() / picture.len() as f64;
    match apart <= ALIKE {
        true => Ok(apart),
        false => Err(format!("the pictures differ by {apart:.4} in the mean: expected the same ground")),
    }
}

/// Medians of two sides in turns (s).
fn in_turns(
    mut ours: impl FnMut() -> Result<f64, String>,
    mut other: impl FnMut() -> Result<f64, String>,
) -> Result<[f64; 2], String> {
    let mut times = [Vec::new(), Vec::new()];
    for _ in 0..TURNS {
        times[0].push(ours()?);
        times[1].push(other()?);
    }
    Ok(times.map(median))
}

/// Puts the photograph's pixel I, J where a mesh before the camera has the light of its vertices.
fn name_pixels(mesh: &mut EyeMesh, camera: &Camera, pose: &Pose) {
    let pixel = GROUND / PIXELS as f64;
    let axes = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]]
        .map(|way| camera.direction(DVec3::from_array(way)));
    for [place, look] in &mut mesh.vertices {
        // The mesh counts ahead, right, down; the camera right, down by its own measure, ahead.
        let [ahead, right, down] = place.map(f64::from);
        let seen = DVec3::new(right, down / camera.squeeze(), ahead);
        let [north, east] = [0, 1].map(|way| pose.eye[way] + axes[way].dot(seen));
        *look = [east / pixel, (GROUND - north) / pixel, 0.0].map(|part| part as f32);
    }
}
