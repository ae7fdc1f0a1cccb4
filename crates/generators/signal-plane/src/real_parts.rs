//! What of the machine is made of real parts: a block whose parts are all ideal is its algebra, and nothing of this.

use control_plane::{Block, Elaboration, MachineStage, WrittenRaster};
use display_projection_processor::PartsProcessor;
use feature_generator::PartsFeatures;
use hardware_model::{Settings, SweepMemoryKind};
use landscape::Level;
use mixing_unit::PartsMixer;
use parts::LagStep;
use picture_tube::PictureTube;
use polyhedron_generator::PartsSwitch;
use shadow_controller::PartsLines;
use signal::Real;
use sweep_memory::{Tube, Words, WriteGun};
use terrain_generator::{PartsArray, PartsLight};
use texture_generator::PartsTexture;

use crate::output_amplifiers::OutputAmplifiers;

/// Blocks made of parts.
#[derive(Debug)]
pub struct RealParts<S> {
    /// Terrain generators of the fine and of the coarse level.
    pub terrain: Option<Terrain<S>>,
    /// Sub-generators of the feature generator.
    pub features: Option<PartsFeatures>,
    /// Line generators of the shadow controller.
    pub lines: Option<PartsLines>,
    /// Converter and filter of the texture generator.
    pub texture: Option<PartsTexture<S>>,
    /// Third video switch (VS3), for bodies.
    pub bodies: Option<PartsSwitch>,
    /// Mixing unit made of parts.
    pub mixer: Option<PartsMixer<S>>,
    /// Projection processor and write gun, which are joined by the beam's gate.
    pub beam: Option<BeamParts<S>>,
    /// Storage tubes of the sweep memory.
    pub tube: Option<Tube>,
    /// Words of a digital sweep memory, where they are rounded.
    pub words: Option<Words>,
    /// Video amplifier and picture tube of the display.
    pub picture_tube: Option<PictureTube>,
    /// Output amplifiers of the main signals.
    pub amplifiers: Option<OutputAmplifiers<S>>,
}

/// Terrain generators made of parts.
#[derive(Debug)]
pub struct Terrain<S> {
    pub fine: PartsArray<S>,
    pub coarse: Option<PartsArray<S>>,
    /// The stage that makes light of slopes.
    pub light: Option<PartsLight>,
    /// Delay of the reflectivity against the height.
    pub reflectivity: Option<LagStep<S>>,
}

/// Projection processor and write gun.
#[derive(Debug)]
pub struct BeamParts<S> {
    pub processor: PartsProcessor<S>,
    pub gun: WriteGun<S>,
}

impl<S: Real> RealParts<S> {
    /// The parts of the blocks of `list` that the model of `stage` names; `ranges` of the samples (m).
    pub fn new(stage: &MachineStage, list: &Elaboration, ranges: &[f64], raster: &WrittenRaster) -> Self {
        let settings = &stage.settings;
        let (analog, seed, laws) = (&settings.analog, settings.seed, &settings.laws);
        let step = 1.0 / settings.timebase.sample_rate().hertz();
        let mixing = (&settings.mixing_unit, laws.texture_in_shadow);
        let occlusion = (laws.occlusion, laws.curvature);
        let beam = || BeamParts {
            processor: PartsProcessor::new(occlusion, ranges, raster.lines as f64, step, analog, seed),
            gun: WriteGun::new(analog, seed, step, ranges.len(), raster.lines),
        };
        let texture = stage.landscape.texture().filter(|_| list.has_parts(Block::Texture));
        let lines_a_second = raster.lines as f64 / (ranges.len() as f64 * step);
        let tube = raster.on_tube(settings.raster.sweeps);
        Self {
            terrain: list.has_parts(Block::Terrain).then(|| Terrain::new(stage, step)),
            features: list
                .has_parts(Block::Features)
                .then(|| PartsFeatures::new(step, &settings.feature_generator, analog, seed)),
            lines: list
                .has_parts(Block::Shadows)
                .then(|| PartsLines::new(&settings.shadow_controller, analog, seed))
                .flatten(),
            texture: texture.map(|texture| PartsTexture::new(texture, ranges, step, analog, seed)),
            bodies: list.has_parts(Block::Bodies).then(|| PartsSwitch::new(lines_a_second, analog, seed)),
            mixer: list.has_parts(Block::Mixing).then(|| PartsMixer::new(mixing, step, analog, seed)),
            beam: list.has_parts(Block::Beam).then(beam),
            tube: list.has_parts(Block::Memory).then(|| Tube::new(&analog.memory, tube, seed)),
            words: words(settings),
            picture_tube: list.has_parts(Block::PictureTube).then(|| PictureTube::of(settings)),
            amplifiers: list.has_parts(Block::Amplifiers).then(|| OutputAmplifiers::new(stage, step, raster)),
        }
    }
}

/// Words of the sweep memory, if it is a digital one that rounds.
fn words(settings: &Settings) -> Option<Words> {
    let bits =
        settings.analog.memory.bits.filter(|_| settings.sweep_memory == SweepMemoryKind::DigitalMemory);
    bits.map(|bits| Words::new(bits, settings.display.white))
}

impl<S> RealParts<S> {
    /// The stage that makes light of slopes, where it is made of parts.
    pub fn light(&self) -> Option<&PartsLight> {
        self.terrain.as_ref()?.light.as_ref()
    }
}

impl<S: Real> Terrain<S> {
    fn new(stage: &MachineStage, step: f64) -> Self {
        let settings = &stage.settings;
        let array = |level: &Level, name| PartsArray::new(step, level, &settings.analog, settings.seed, name);
        let levels = stage.landscape.bank().levels();
        let reflectivity = &settings.analog.reflectivity;
        let mismatch = reflectivity.delay_mismatch;
        let light = || PartsLight::new(step, &settings.analog, settings.seed);
        Self {
            fine: array(&levels[0], "tg"),
            coarse: settings.levels.and_then(|_| levels.get(1)).map(|level| array(level, "mtg")),
            light: (!reflectivity.stage_is_ideal()).then(light),
            reflectivity: (mismatch > 0.0).then(|| LagStep::new(step, mismatch)),
        }
    }
}
