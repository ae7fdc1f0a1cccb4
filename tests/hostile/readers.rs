//! Every reader of a file that people, or other programs, write.

use std::fmt::Display;
use std::fs;
use std::path::Path;

use diagnostics::Problem;
use drive::{Drive, DriveError};
use faces::{Effect, Setting};
use hardware_model::{HardwareModel, ModelSource};
use landscape::projection::{Method, Projection};
use landscape::{Bank, FileCoordinates, Level, MapFrame};
use loop_protocol::{Home, Message, Opening, Session};
use photo_camera::Light;
use photo_camera::voids::Wishes;
use photo_check::{Ground, fill_voids, read_points};
use photograph::{Map, MapUnit, PhotoFile, Photograph, Placement};
use picture::{Depth, GreyPicture};
use quantities::Rate;
use scenario::Scenario;
use solids::shape_files::{self, Openness};
use survey::{Affine, Elevation, Frame, ReadOptions, SurveyError};
use vehicle_shadow::Camera;

use crate::allocation::largest_request;

/// Most bytes that a piece of memory may have for a file of so many bytes: packed elevations grow by up to 4096, PNG by up to
/// 1032; a parser's tables of some hundred bytes for each byte come to less.
fn most_memory(file: usize) -> usize {
    (1 << 22) + 8192 * file
}

/// A reader: a file of this name goes in, nothing or an error comes out.
#[derive(Debug, Clone, Copy)]
pub struct Reader {
    /// Folder of the corpus.
    pub name: &'static str,
    /// Name that its files have.
    pub file: &'static str,
    read: fn(&Path) -> Result<(), String>,
}

/// All readers that are given damaged files.
pub const READERS: [Reader; 33] = [
    Reader { name: "scenario", file: "scene.toml", read: |path| said(Scenario::read(path)) },
    Reader {
        name: "path-csv",
        file: "path.csv",
        read: |path| scene_of(path, "[path]\nfile = \"path.csv\"\n"),
    },
    Reader {
        name: "path-tum",
        file: "path.tum",
        read: |path| scene_of(path, "[path]\nfile = \"path.tum\"\n"),
    },
    Reader { name: "path-gpx", file: "path.gpx", read: track },
    Reader { name: "path-lon-lat", file: "path.csv", read: track },
    Reader { name: "model", file: "model.toml", read: model },
    Reader { name: "craters", file: "craters.csv", read: |path| said(features::list::read(path)) },
    Reader { name: "stars", file: "stars.csv", read: |path| scene_of(path, STARS) },
    Reader { name: "obj", file: "shape.obj", read: shape },
    Reader { name: "stl", file: "shape.stl", read: shape },
    Reader { name: "ply", file: "shape.ply", read: shape },
    Reader { name: "gltf", file: "shape.gltf", read: shape },
    Reader { name: "glb", file: "shape.glb", read: shape },
    Reader { name: "bank", file: "ground.bank", read: |path| said(landscape::bank_file::read(path)) },
    Reader { name: "geotiff", file: "dem.tif", read: elevation },
    Reader { name: "pds", file: "dem.lbl", read: elevation },
    Reader { name: "npy", file: "dem.npy", read: elevation },
    Reader { name: "dted", file: "dem.dt0", read: elevation },
    Reader { name: "pds4", file: "dem.xml", read: |path| beside(path, "dat", &SAMPLES) },
    Reader { name: "isis", file: "dem.cub", read: elevation },
    Reader { name: "envi", file: "dem.hdr", read: |path| beside(path, "dat", &SAMPLES) },
    Reader { name: "ascii", file: "dem.asc", read: elevation },
    Reader { name: "prj", file: "dem.prj", read: grid_beside },
    Reader {
        name: "png",
        file: "frame.png",
        read: |path| said(picture::read_png(path, &picture::Limits::default())),
    },
    Reader { name: "baseline", file: "timing.json", read: |path| said(timing::read(path)) },
    Reader { name: "run", file: "run.json", read: |path| said(replay::HeldRun::read(folder(path))) },
    Reader { name: "poses", file: "poses.csv", read: |path| said(vehicle_shadow::read_poses(path)) },
    Reader { name: "state", file: "there.state", read: |path| said(state::State::read(path)) },
    Reader { name: "camera", file: "camera.json", read: |path| said(Camera::read(path)) },
    Reader { name: "photo-file", file: "photo.json", read: |path| said(PhotoFile::read(path)) },
    Reader { name: "control-points", file: "points.csv", read: control_points },
    Reader { name: "message", file: "message.loop", read: message },
    Reader { name: "effect", file: "effect.toml", read: effect },
];

/// The reader of a folder of the corpus.
pub fn reader(name: &str) -> Reader {
    let found = READERS.into_iter().find(|reader| reader.name == name);
    found.unwrap_or_else(|| panic!("no reader is called `{name}`"))
}

impl Reader {
    /// What it says of `bytes` in `folder`. Panics if it asks for more memory than such a file may, or if its error does not
    /// name the file.
    pub fn read(&self, folder: &Path, bytes: &[u8]) -> Result<(), String> {
        let path = folder.join(self.file);
        // Some file systems write a file that is cut to nothing and filled again to the disk at once; a new one they do not.
        let _ = fs::remove_file(&path);
        fs::write(&path, bytes).expect("a folder that can be written");
        let (result, largest) = largest_request(|| (self.read)(&path));
        let most = most_memory(bytes.len());
        assert!(largest <= most, "{}: {largest} bytes at once for a file of {}", self.name, bytes.len());
        if let Err(said) = &result {
            assert!(said.contains(self.stem()), "{}: does not name its file: {said}", self.name);
        }
        result
    }

    /// The image beside a label is its file too.
    fn stem(&self) -> &str {
        self.file.split('.').next().unwrap_or(self.file)
    }
}

fn said<T>(result: Result<T, impl Display>) -> Result<(), String> {
    result.map(|_| ()).map_err(|error| error.to_string())
}

fn folder(path: &Path) -> &Path {
    path.parent().expect("a file in a folder")
}

/// A message of a loop; what can be read is answered by a session that opens nothing.
fn message(path: &Path) -> Result<(), String> {
    let bytes = fs::read(path).expect("a file that was written");
    let request = Message::decode(&bytes).map_err(|error| error.to_string())?;
    let reply = Session::new(Nowhere).answer(&request);
    assert!(reply.header.contains_key("ok") != reply.header.contains_key("error"), "one of both");
    Ok(())
}

/// A host that opens nothing.
struct Nowhere;

impl Home for Nowhere {
    fn open(&mut self, _asked: &Opening) -> Result<Drive, DriveError> {
        Err(Problem::of_file("request", "nothing is opened here").into())
    }
}

fn shape(path: &Path) -> Result<(), String> {
    let closed = said(shape_files::read(path, Openness::Closed));
    closed.and(said(shape_files::read(path, Openness::Any)))
}

/// An effect at 30 frames a second. A pattern of few bytes has all the faces that a run allows; these are few.
fn effect(path: &Path) -> Result<(), String> {
    let frames = Rate::new(30, 1).expect("a rate");
    said(Effect::read(path, Setting { frames, signals: &["pitch"], most: 2500 }))
}

fn model(path: &Path) -> Result<(), String> {
    said(HardwareModel::load(&ModelSource::File(path.to_owned()), &[], &[]))
}

/// A file without a place needs a spacing, and one that has a place refuses it.
fn elevation(path: &Path) -> Result<(), String> {
    let read =
        |spacing| survey::read(path, &ReadOptions { band: Some(1), spacing, ..ReadOptions::default() });
    match read(Some([10.0; 2])) {
        Err(SurveyError::Option { .. }) => said(read(None)),
        found => said(found),
    }
}

/// Samples beside a label or header: 24 x 24 words of 16 bits.
const SAMPLES: [u8; 1152] = [7; 1152];

/// An elevation label with a file beside it that it leads to.
fn beside(path: &Path, ending: &str, bytes: &[u8]) -> Result<(), String> {
    fs::write(path.with_extension(ending), bytes).expect("a folder that can be written");
    elevation(path)
}

/// Control points over 4 x 4 posts of the Moon in degrees.
fn control_points(path: &Path) -> Result<(), String> {
    let place = Affine { first: [0.01, 0.0], step: [-0.01, 0.01] };
    let elevation = Elevation::new(4, 4, vec![5.0; 16], place, Frame::Geographic { radius: 1_737_400.0 });
    let map =
        Map::new([0.5, 0.0, 0.0], [0.0, -0.5, 1.0], MapUnit::Degree).map_err(|error| error.to_string())?;
    let picture = GreyPicture::new(2, 2, Depth::Eight, vec![9; 4]).map_err(|error| error.to_string())?;
    let photo =
        Photograph::new(picture, Placement::Map(map), Light::default()).map_err(|error| error.to_string())?;
    let filling = fill_voids(&elevation, Wishes::default()).map_err(|error| error.to_string())?;
    let ground = Ground::new(&elevation, filling, &photo).map_err(|error| error.to_string())?;
    read_points(path, &ground).map(|_| ()).map_err(|problems| problems.render(false))
}

/// A coordinate system beside a grid.
fn grid_beside(path: &Path) -> Result<(), String> {
    let grid = path.with_extension("asc");
    let text = "ncols 2\nnrows 2\nxllcorner 5\nyllcorner 6\ncellsize 1\n1 2\n3 4\n";
    fs::write(&grid, text).expect("a folder that can be written");
    elevation(&grid)
}

/// A scenario around a path on the sphere, over a bank that says where it lies.
fn track(path: &Path) -> Result<(), String> {
    let bank = folder(path).join("place.bank");
    if !bank.exists() {
        let latitude = 0.1_f64;
        let method = Method::Equirectangular { parallel: latitude };
        let radius = landscape::LUNOID_RADIUS;
        let projection = Projection { method, latitude: 0.0, longitude: 0.2, radius, offset: [0.0; 2] };
        let map = MapFrame {
            projection: Some(projection),
            coordinates: FileCoordinates::Degrees,
            origin: [radius * latitude, 0.0],
            first_sample: [0.0; 2],
            spacing: [10.0; 2],
        };
        let level = Level::new(500.0, [0.0; 2], [2, 2], vec![[0.0; 9]; 4]).expect("a level");
        let made = Bank::new("place", vec![level], None).expect("a bank").with_map(Some(map));
        landscape::bank_file::write(&bank, &made).expect("a folder that can be written");
    }
    let name = path.file_name().unwrap_or_default().display();
    let text = format!(
        "format = 1\ntitle = \"T\"\nshows = \"T.\"\nframes = 2\n[landscape]\nbank = \"place.bank\"\n[sun]\n\
         azimuth_deg = 100\nelevation_deg = 15\n[path]\nfile = \"{name}\"\ncoordinates = \"lon-lat\"\n"
    );
    said(Scenario::parse(&folder(path).join("scene.toml").display().to_string(), &text))
}

/// Stars of a file over a vehicle that stands still.
const STARS: &str = "[path]\nkeyframes = [{ t_s = 0, x_m = 200, y_m = 200 }]\n[stars]\nfile = \"stars.csv\"\nturn_deg = [10, 20, 30]\n";

/// A whole scenario around a file that it names.
fn scene_of(path: &Path, course: &str) -> Result<(), String> {
    let text = format!(
        "format = 1\ntitle = \"T\"\nshows = \"T.\"\nframes = 2\n[landscape.generated]\nseed = 1\nextent_m = [400, 400]\n\
         region_size_m = 50\n[sun]\nazimuth_deg = 100\nelevation_deg = 15\n{course}"
    );
    said(Scenario::parse(&folder(path).join("scene.toml").display().to_string(), &text))
}
