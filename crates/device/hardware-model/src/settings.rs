//! The settings of a run: command line, then scenario, then model.

use std::path::PathBuf;

use quantities::{Rate, Timebase, TimebaseError};
use scenario::{
    Display, FieldOfView, LawWishes, Laws, RangeProgramme, RasterWishes, Scalar, ShadowFineness, View,
};

use crate::model::retrace;
use crate::{
    AnalogParts, Cpu, DataBanks, Economy, FeatureParts, HardwareModel, KindBanks, LevelSwitch, LevelTurn,
    Loader, MixingParts, ShadowParts, SweepMemoryKind, Yoke,
};

/// Everything that decides a picture of the hybrid machine but landscape, sun and pose.
#[derive(Debug, Clone, PartialEq)]
pub struct Settings {
    /// Raster of sweeps and of the read-out.
    pub raster: Raster,
    /// Clocks of the machine, as exact ratios.
    pub timebase: Timebase,
    /// Ground-range programme of the sweeps.
    pub range: RangeProgramme,
    /// Laws of the run.
    pub laws: Laws,
    /// Scalar type of the analog signals.
    pub scalar: Scalar,
    /// From reflectivity to grey.
    pub display: Display,
    /// Central processor of the digital side.
    pub cpu: Cpu,
    /// What the processor does about far ground while the vehicle turns.
    pub level_turn: LevelTurn,
    /// Delivery of coefficient words.
    pub loader: Loader,
    /// Drums and storage buffers of terrain.
    pub data_banks: DataBanks,
    /// Banks of the other kinds of data.
    pub kind_banks: KindBanks,
    /// Seed of part-to-part spread and noise.
    pub seed: u64,
    /// Kind of sweep memory.
    pub sweep_memory: SweepMemoryKind,
    /// Sub-generators of the feature generator and their organisation.
    pub feature_generator: FeatureParts,
    /// Variant and parts of the shadow controller.
    pub shadow_controller: ShadowParts,
    /// Parts of the mixing unit.
    pub mixing_unit: MixingParts,
    /// Words a second that reach the sub-generators of the feature generator; any number if `None`.
    pub feature_words: Option<f64>,
    /// Words a second that reach the line generators of the shadow controller; any number if `None`.
    pub segment_words: Option<f64>,
    /// Parts of the analog side.
    pub analog: AnalogParts,
    /// Deflection yoke, where the display turns the picture with the vehicle's roll.
    pub yoke: Option<Yoke>,
    /// Switch from the fine level to the coarse one, where the scenario has two.
    pub levels: Option<LevelSwitch>,
    /// How finely remote shadow is worked out, where it is drawn.
    pub shadows: Option<ShadowFineness>,
    /// Where shadow boundaries are kept from run to run; it changes no picture.
    pub shadow_cache: Option<ShadowCache>,
    /// What may be left out.
    pub economy: Economy,
}

/// Folder of shadow boundaries.
#[derive(Debug, Clone, PartialEq)]
pub struct ShadowCache {
    /// Path of the folder.
    pub folder: PathBuf,
    /// Bytes that it keeps at most; with 0 nothing in it changes.
    pub most_bytes: u64,
}

/// Bytes of shadow boundaries that a run keeps.
const OF_RUN: u64 = 256 << 20;

impl ShadowCache {
    /// A folder that keeps everything, as its owner asks.
    pub fn shared(folder: impl Into<PathBuf>) -> Self {
        Self { folder: folder.into(), most_bytes: u64::MAX }
    }

    /// The folder of a run, which keeps 256 MB.
    pub fn of_run(folder: impl Into<PathBuf>) -> Self {
        Self { folder: folder.into(), most_bytes: OF_RUN }
    }

    /// A folder that stays as it is.
    pub fn only_read(folder: impl Into<PathBuf>) -> Self {
        Self { folder: folder.into(), most_bytes: 0 }
    }
}

/// Sweeps, samples and read-out.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Raster {
    /// Number of sweeps a frame.
    pub sweeps: u32,
    /// Samples drawn in one sweep.
    pub samples: u32,
    /// Columns of the read-out.
    pub columns: u32,
    /// Lines of the read-out.
    pub lines: u32,
    /// Field of view of the picture.
    pub field: FieldOfView,
    /// Pictures shown a second.
    pub refresh: Rate,
}

/// Why settings do not fit together.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum SettingsError {
    /// A count is out of range.
    #[error("{key} = {found}: expected {low} to {high}")]
    Count {
        /// Key, as in a scenario file.
        key: &'static str,
        /// Value that was given for the key.
        found: u32,
        /// Least value that is allowed.
        low: u32,
        /// Greatest value that is allowed.
        high: u32,
    },
    /// Refresh is not a whole multiple of update.
    #[error("raster.refresh_hz = {refresh}: expected a whole multiple of the update rate {update}")]
    Refresh {
        /// Pictures shown a second.
        refresh: Rate,
        /// Pictures computed a second.
        update: Rate,
    },
    /// The digital memory reads the raster in which it was written.
    #[error(
        "raster.columns = {columns} with {sweeps} sweeps: a digital memory reads the raster it was written in; \
         expected as many columns as sweeps, or sweep_memory.kind = \"scan-converter\""
    )]
    DigitalRaster {
        /// Number of columns that was asked for.
        columns: u32,
        /// Number of sweeps a frame.
        sweeps: u32,
    },
    /// Clocks out of range.
    #[error(transparent)]
    Timebase(#[from] TimebaseError),
}

impl Settings {
    /// What raster, range, laws and display of a run come to; yoke, levels, shadows and economy are
    /// as for a scene that has none of them. `wishes` is the command line's raster over the scenario's.
    ///
    /// # Errors
    /// If a count is out of range or the rates do not divide.
    pub fn resolve(
        model: &HardwareModel,
        field: FieldOfView,
        wishes: RasterWishes,
        range: Option<RangeProgramme>,
        laws: LawWishes,
        scalar: Scalar,
        display: Display,
    ) -> Result<Self, SettingsError> {
        let sweeps = count("raster.sweeps", wishes.sweeps.unwrap_or(model.raster.sweeps), 1, 8192)?;
        let samples = count("raster.samples", wishes.samples.unwrap_or(model.raster.samples), 2, 65_536)?;
        let columns = count("raster.columns", wishes.columns.unwrap_or(sweeps), 1, 8192)?;
        let square = f64::from(columns) * field.tan_half_height / field.tan_half_width;
        let square = square.round().clamp(1.0, 8192.0) as u32;
        let lines = count("raster.lines", wishes.lines.unwrap_or(square), 1, 8192)?;
        if model.sweep_memory == SweepMemoryKind::DigitalMemory && columns != sweeps {
            return Err(SettingsError::DigitalRaster { columns, sweeps });
        }
        let update = wishes.update.unwrap_or(model.raster.update);
        let refresh = wishes.refresh.unwrap_or(model.raster.refresh);
        refresh.whole_ratio(update).ok_or(SettingsError::Refresh { refresh, update })?;
        let timebase = Timebase::new(
            model.master_clock,
            update,
            sweeps,
            samples,
            retrace(samples, model.raster.blanking_fraction),
        )?;
        Ok(Self {
            raster: Raster { sweeps, samples, columns, lines, field, refresh },
            timebase,
            range: range.unwrap_or(model.range),
            laws: laws.or(model.laws),
            scalar,
            display,
            cpu: model.cpu,
            level_turn: model.level_turn,
            loader: model.loader.clone(),
            data_banks: model.data_banks,
            kind_banks: model.kind_banks,
            seed: model.seed,
            sweep_memory: model.sweep_memory,
            feature_generator: model.feature_generator,
            shadow_controller: model.shadow_controller,
            mixing_unit: model.mixing_unit,
            feature_words: model.feature_words,
            segment_words: model.segment_words,
            analog: model.analog.clone(),
            yoke: None,
            levels: None,
            shadows: None,
            shadow_cache: None,
            economy: Economy::Bounded,
        })
    }
}

impl Settings {
    /// Whether a frame depends on those before it: by what data banks hold, by what tubes still show, or by how fast the heading turns.
    pub fn remembers_frames(&self) -> bool {
        let looks_at_turns = self.levels.is_some() && self.level_turn != LevelTurn::NEVER;
        self.data_banks.drum.is_some() || self.analog.remembers_frames() || looks_at_turns
    }

    /// What of these settings every image generator is asked for.
    pub fn view(&self) -> View {
        let Raster { samples, columns, lines, field, refresh, .. } = self.raster;
        View {
            columns,
            lines,
            field,
            update: self.timebase.update,
            refresh,
            display: self.display,
            laws: self.laws,
            ranges: [self.range.at_sample(0, samples as usize), self.range.end],
            yoke: self.yoke,
            levels: self.levels,
            shadows: self.shadows,
        }
    }
}

fn count(key: &'static str, found: u32, low: u32, high: u32) -> Result<u32, SettingsError> {
    match (low..=high).contains(&found) {
        true => Ok(found),
        false => Err(SettingsError::Count { key, found, low, high }),
    }
}
