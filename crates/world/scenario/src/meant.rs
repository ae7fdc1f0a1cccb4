//! A scenario as meant: SI, checked, complete.

use std::path::{Path as FilePath, PathBuf};

use landscape::relief::Relief;
use landscape::{Photometry, Silhouette};
use quantities::Rate;

use crate::{
    AlbedoMapWish, Channel, CraterWishes, Display, EffectWishes, Event, FaceWishes, FieldWish, Group,
    LawWishes, LevelSwitch, Object, Path, PhotographWish, RangeProgramme, RasterWishes, Rocks, RollDisplay,
    Scalar, ShadowFineness, StarSource, Sunlight, TextureWish, Tracks, Vehicle, VehicleShape,
};

/// What happens: ground, light, vehicle, path, and how it is to be seen.
#[derive(Debug, Clone, PartialEq)]
pub struct Scenario {
    /// Title of the scenario in a few words, for people.
    pub title: String,
    /// One sentence: what it shows.
    pub shows: String,
    /// Name of the hardware model, unless the command names another.
    pub machine: String,
    /// How long it is.
    pub length: Length,
    /// Where the ground comes from.
    pub ground: GroundSource,
    /// Ground around a generated one, which is its coarse level.
    pub coarse: Option<Relief>,
    /// Craters on the ground, each with its own closed form.
    pub features: CraterWishes,
    /// Terrain database of the same ground, for generators that draw levels of detail.
    pub database: Option<PathBuf>,
    /// Share of the light that the ground returns, 0..=1.
    pub albedo: f64,
    /// Map of the same over it.
    pub albedo_map: Option<AlbedoMapWish>,
    /// Photographs of the ground; each file stands there once.
    pub photographs: Vec<PhotographWish>,
    /// How the ground returns it.
    pub photometry: Photometry,
    /// Small detail of the foreground.
    pub texture: Option<TextureWish>,
    /// Mountains beyond the ground.
    pub silhouettes: Vec<Silhouette>,
    /// Where the light comes from.
    pub sun: Sunlight,
    /// Remote shadow, where it is drawn.
    pub shadows: Option<ShadowFineness>,
    /// Rocks on the ground.
    pub rocks: Option<Rocks>,
    /// Man-made things; their ids differ.
    pub objects: Vec<Object>,
    /// Groups that objects belong to; their names differ.
    pub groups: Vec<Group>,
    /// What happens to them, ascending in time; the events of each object fit together.
    pub events: Vec<Event>,
    /// What is seen beside ground and bodies: lamps, stars, sheets, overlays, discs of the sky.
    pub effects: EffectWishes,
    /// Sea, ships, effects of files and plumes: lists of faces.
    pub faces: FaceWishes,
    /// What the wheels leave behind.
    pub tracks: Option<Tracks>,
    /// Size and limits of the vehicle.
    pub vehicle: Vehicle,
    /// What casts the vehicle's own shadow, where it casts one.
    pub vehicle_shape: Option<VehicleShape>,
    /// Files of that shape, as those of an object.
    pub vehicle_files: Vec<PathBuf>,
    /// Path that the vehicle drives.
    pub path: Path,
    /// File of the path, where it has one of its own.
    pub path_file: Option<PathBuf>,
    /// Raster that the scenario asks for.
    pub raster: RasterWishes,
    /// What the driver sees.
    pub field: FieldWish,
    /// Views from the vehicle, where it has several; their names differ.
    pub channels: Vec<Channel>,
    /// The one that is looked through; without it, the vehicle's own camera.
    pub channel: Option<Channel>,
    /// Ground-range programme asked for.
    pub range: Option<RangeProgramme>,
    /// Switch from the fine level of the ground to the coarse one.
    pub levels: Option<LevelSwitch>,
    /// What the display does about roll.
    pub roll: RollDisplay,
    /// Laws that the scenario asks for.
    pub laws: LawWishes,
    /// From reflectivity to grey.
    pub display: Display,
    /// Scalar type of the analog signals.
    pub scalar: Scalar,
    /// What the user should know of how files were read, in words.
    pub notes: Vec<String>,
}

/// Length of a scenario.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Length {
    /// A number of frames, at whatever update rate.
    Frames(u64),
    /// Number of seconds, above 0.
    Seconds(f64),
}

/// Where the ground comes from.
#[derive(Debug, Clone, PartialEq)]
pub enum GroundSource {
    /// A coefficient bank in a file, in the scenario's folder or below.
    Bank(PathBuf),
    /// A landscape that is generated from a seed.
    Generated(Relief),
}

impl Scenario {
    /// The scenario as it is seen through the channel of this name; `None` if it has no such channel.
    pub fn through(self, name: &str) -> Option<Self> {
        let channel = self.channels.iter().find(|channel| channel.name == name)?.clone();
        let field = channel.field.unwrap_or(self.field);
        Some(Self { channel: Some(channel), field, ..self })
    }

    /// Frames at `update` frames a second: those that begin before the end; at least one.
    pub fn frames(&self, update: Rate) -> u64 {
        match self.length {
            Length::Frames(frames) => frames,
            // Rounding of the product must not add a frame that begins at the very end.
            Length::Seconds(seconds) => ((seconds * update.hertz() - 1e-9).ceil() as u64).max(1),
        }
    }

    /// Says so if the vehicle stands for the whole mission because its path ends before, or begins after it.
    pub fn path_beside_mission(&self, update: Rate) -> Option<String> {
        let [first, .., last] = self.path.waypoints() else { return None };
        let end = (self.frames(update) - 1) as f64 / update.hertz();
        let name = self.path.name();
        if last.time <= 0.0 {
            return Some(format!(
                "{name}: the path ends at t = {} s, before the mission begins: the vehicle stands",
                last.time
            ));
        }
        (first.time >= end && first.time > 0.0).then(|| {
            format!(
                "{name}: the path begins at t = {} s, but the last frame is at t = {end:.3} s: the vehicle stands",
                first.time
            )
        })
    }

    /// Files that the scenario refers to, for the record of a run.
    pub fn files(&self) -> Vec<&FilePath> {
        let bank = match &self.ground {
            GroundSource::Bank(path) => Some(path.as_path()),
            GroundSource::Generated(_) => None,
        };
        let list = self.features.list.as_ref().map(|list| list.file.as_path());
        let shapes = self.objects.iter().flat_map(|object| &object.files).map(PathBuf::as_path);
        let vehicle = self.vehicle_files.iter().map(PathBuf::as_path);
        let map = self.albedo_map.as_ref().map(|map| map.file.as_path());
        let stars = self.effects.stars.as_ref().and_then(|stars| match &stars.source {
            StarSource::Catalogue { file, .. } => Some(file.as_path()),
            StarSource::Seeded(_) => None,
        });
        let database = self.database.as_deref();
        let ground = bank.into_iter().chain(database).chain(self.path_file.as_deref()).chain(list);
        let effects = self.faces.effects.iter().map(|wish| wish.file.as_path());
        let photographs = self.photographs.iter().flat_map(|wish| [wish.file.as_path(), &wish.camera]);
        ground
            .chain(shapes)
            .chain(vehicle)
            .chain(map)
            .chain(stars)
            .chain(photographs)
            .chain(effects)
            .collect()
    }
}
