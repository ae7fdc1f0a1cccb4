//! The analog side: how good each kind of part is (hardware section 3). Figures of a part that is not there are
//! `None`, or 0 where the comment says so.

mod comparator;
mod ideal;
mod wires;

use serde::Serialize;

pub use wires::{MAIN_WIRES, WireParts};

/// Everything analog. Times in seconds, rates in hertz, voltages in volts; a *share* is of the full scale.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct AnalogParts {
    /// Full scale (V): the machine unit. All voltages of the other parts are against it.
    pub full_scale: f64,
    /// Whether parts of a kind differ from one another by the tolerances of hardware section 0. Static errors are
    /// drawn for each part either way: they are themselves a spread.
    pub spread: bool,
    /// Folded ramps and limit stops.
    pub sweep: SweepParts,
    /// Basis functions g0, g1, g2 and their derivatives.
    pub function_generator: FunctionGeneratorParts,
    /// Products of basis functions; squares and roots of the reflectivity.
    pub multiplier: MultiplierParts,
    /// Products with coefficient words.
    pub multiplying_dac: MultiplyingDacParts,
    /// Amplifiers of the summers and of the video.
    pub amplifier: AmplifierParts,
    /// Inputs of one stage of a summer; one summing point that costs nothing if `None`.
    pub summer_inputs: Option<u32>,
    /// Comparators of occlusion, shadow edges and footprints, and of the folds where they are found by one.
    pub comparator: ComparatorParts,
    /// Sample-and-hold of the projection processor.
    pub sample_hold: SampleHoldParts,
    /// From slopes to reflectivity.
    pub reflectivity: ReflectivityParts,
    /// The blend between two levels of terrain. A record of the usual one does not name it.
    #[serde(skip_serializing_if = "LevelBlendParts::is_usual")]
    pub level_blend: LevelBlendParts,
    /// The three video switches.
    pub video_switch: VideoSwitchParts,
    /// Sub-generators of the feature generator.
    pub feature: FeatureChainParts,
    /// Line generators of the shadow controller.
    pub shadow_line: ShadowLineParts,
    /// D/A converter and filter of the texture generator.
    pub texture: TextureParts,
    /// Function generators of the projection processor.
    pub projection: ProjectionParts,
    /// Parts of the sweep memory (hardware section 3.8).
    pub memory: MemoryParts,
    /// The display: video amplifier and picture tube.
    pub picture_tube: PictureTubeParts,
    /// Bandwidth of the video behind the mixing unit (Hz); none is lost if `None`.
    pub video_bandwidth: Option<f64>,
    /// Output amplifiers of the main signals.
    pub wires: WireParts,
}

/// Sweep generator (hardware section 3.1).
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct SweepParts {
    /// Bits of the ramp's D/A converter; no steps if `None`.
    pub dac_bits: Option<u32>,
    /// Settling of the converter to 0.1 % (s), 6.9 time constants; 0: at once.
    pub settle: f64,
    /// Largest deviation of the converter from a straight line (share); 0: none.
    pub nonlinearity: f64,
    /// Area of the glitch where the highest bit changes (V s); half of it at each lower bit; 0: none.
    pub glitch: f64,
    /// Smoother: two poles, damping [`SMOOTHER_DAMPING`], this is 1/w (s); 0: no smoother.
    pub smoother: f64,
    /// From the instant at which the ramp meets its stop to the strobe of the registers (s), either sign; 0: aligned.
    pub strobe_offset: f64,
    /// How a fold is found.
    pub fold_detect: FoldDetect,
    /// Whether the accumulators are preset to the first range in retrace, so that the array settles there before the sweep begins;
    /// otherwise they are at the eye's foot, and the array jumps to the first range within a step.
    pub preset: bool,
}

/// Damping of the sweep generator's smoother (hardware section 3.1).
pub const SMOOTHER_DAMPING: f64 = 0.8;

/// How a fold is found.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum FoldDetect {
    /// By the overflow of the accumulator, ahead of all analog delay.
    Digital,
    /// By a comparator on the analog ramp.
    Comparator,
}

/// How much of the coarse level a blend shows at a share u of its way.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum BlendWeight {
    /// `10 u^3 - 15 u^4 + 6 u^5`, a function that the terrain generator has: level to the second derivative at both ends.
    Quintic,
    /// `u^2 (3 - 2 u)`, cheaper: level to the first derivative, so that the light has a kink at both ends.
    Cubic,
}

/// Blend of the modified terrain generator (section 8), for which two products a signal are enough in height and in the slope across;
/// the slope along the sweep needs a third.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct LevelBlendParts {
    /// Law of the weight over the blend.
    pub weight: BlendWeight,
    /// Whether the slope along the sweep has its third product, the rate of the weight times the difference of the heights; where the
    /// designer left it out, the light of the blended stretch is that of other slopes.
    pub slope_term: bool,
}

/// Function generators (hardware section 3.3).
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct FunctionGeneratorParts {
    /// Segments of the broken line; the function itself if `None`.
    pub segments: Option<u32>,
    /// Width of the diodes' knees (V); 0: sharp. There are knees with segments alone.
    pub rounding: f64,
    /// Static error, one sigma (share).
    pub error: f64,
    /// Bandwidth (Hz); unlimited if `None`.
    pub bandwidth: Option<f64>,
}

/// Analog multipliers (hardware section 3.4).
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct MultiplierParts {
    /// Static error, one sigma (share).
    pub error: f64,
    /// Scale error, one sigma (share of the product).
    pub scale_error: f64,
    /// What leaks of an input past a multiplier, at [`FEEDTHROUGH_FREQUENCY`] (share); it goes with the frequency.
    pub feedthrough: f64,
    /// Bandwidth (Hz); unlimited if `None`.
    pub bandwidth: Option<f64>,
}

/// Where feedthrough is told (Hz; hardware sections 3.4 and 3.5).
pub const FEEDTHROUGH_FREQUENCY: f64 = 1e6;

/// D/A multipliers with their registers (hardware section 3.5).
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct MultiplyingDacParts {
    /// Bits of a coefficient with its sign; the word as it is if `None`.
    pub bits: Option<u32>,
    /// Gain error, one sigma (share of the output).
    pub gain_error: f64,
    /// Bandwidth of the signal path (Hz).
    pub bandwidth: Option<f64>,
    /// Area of the glitch where the highest bit of a word changes (V s); 0: none.
    pub glitch: f64,
    /// From the strobe of a register to its word's effect (s); 0: at once.
    pub switching: f64,
    /// What leaks of the signal past its switches, at [`FEEDTHROUGH_FREQUENCY`] (share).
    pub feedthrough: f64,
}

/// Amplifiers (hardware section 3.2).
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct AmplifierParts {
    /// Gain-bandwidth product (Hz): n unity inputs leave 1/(n + 1) of it.
    pub gain_bandwidth: Option<f64>,
    /// Fastest change of the output (V/s).
    pub slew: Option<f64>,
    /// Noise in 10 MHz, rms (V); 0: none.
    pub noise: f64,
    /// Output voltage of either sign at which it clips (V).
    pub saturation: Option<f64>,
    /// Recovery from overload (s); of effect with a saturation alone.
    pub recovery: f64,
}

/// Comparators (hardware section 3.6).
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct ComparatorParts {
    /// From crossing to output at large overdrive (s); 0: at once.
    pub delay: f64,
    /// Overdrive times time that a decision takes beside it (V s); 0: none.
    pub overdrive: f64,
    /// Width of the hysteresis (share); 0: none.
    pub hysteresis: f64,
    /// Offset of the thresholds, one sigma (V); 0: none.
    pub offset: f64,
}

/// Sample-and-hold (hardware section 3.6).
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct SampleHoldParts {
    /// Acquisition to 0.1 % (s), 6.9 time constants; 0: at once.
    pub acquire: f64,
    /// Loss while it holds (V/s); 0: none.
    pub droop: f64,
    /// Step at the begin of the hold (V); 0: none.
    pub pedestal: f64,
    /// Aperture delay: the held value is this much older than its command (s).
    pub aperture: f64,
    /// Jitter of the aperture, one sigma (s).
    pub jitter: f64,
}

/// From slopes to reflectivity: three products, two squarers, two summers, a root and a divider (section 7).
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct ReflectivityParts {
    /// Delay of the reflectivity against the height of the same place (s); 0: matched.
    pub delay_mismatch: f64,
    /// Slope at full scale of the stage (m/m); of effect with a figure below alone.
    pub slope_full_scale: f64,
    /// Products of slopes with the sun's words, and squares of slopes.
    pub multiplier: MultiplierParts,
    /// Bandwidth of either summer (Hz); unlimited if `None`.
    pub summer_bandwidth: Option<f64>,
    /// Root: a squarer in the feedback of an amplifier.
    pub root: LoopParts,
    /// Divider: a multiplier in the feedback of an amplifier.
    pub divider: LoopParts,
    /// Voltage of either sign at which every wire of the stage clips (V).
    pub saturation: Option<f64>,
}

/// A part that solves its law by what stands in its feedback: the smaller the signal there, the slower it is and the larger its error.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct LoopParts {
    /// Static error of what stands in its feedback, one sigma (share).
    pub error: f64,
    /// Bandwidth with full scale in its feedback (Hz); unlimited if `None`.
    pub bandwidth: Option<f64>,
}

/// Video switches (hardware section 3.6).
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct VideoSwitchParts {
    /// Transition (s); 0: at once.
    pub time: f64,
    /// Mismatch of the two inputs' levels, one sigma (share).
    pub level_mismatch: f64,
    /// Mismatch of their gains, one sigma (share).
    pub gain_mismatch: f64,
    /// Delay of the input S against C (s), drawn like any delay.
    pub delay_mismatch: f64,
    /// What gets through of the input that is off, at [`CROSSTALK_FREQUENCY`] (share): a small capacity.
    pub crosstalk: Option<f64>,
}

/// Where crosstalk is told (Hz; hardware section 3.6).
pub const CROSSTALK_FREQUENCY: f64 = 5e6;

/// Sub-generators of the feature generator: two squarers, sum, limiter, parabola (hardware section 3.7).
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct FeatureChainParts {
    /// Static error of each of its multipliers, one sigma (share).
    pub error: f64,
    /// Bandwidth of the chain (Hz).
    pub bandwidth: Option<f64>,
}

/// Line generators of the shadow controller (hardware section 3.7).
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct ShadowLineParts {
    /// Static error, one sigma (share): full scale is the length of the segment.
    pub error: f64,
}

/// Converter and filter of the texture generator (hardware section 3.7).
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct TextureParts {
    /// Bits of its D/A converter, with the sign; the pattern as it is if `None`.
    pub bits: Option<u32>,
    /// Bandwidth of the filter behind it (Hz).
    pub bandwidth: Option<f64>,
}

/// Function generators of the projection processor: elevation and both deflections.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct ProjectionParts {
    /// Static error, one sigma (share).
    pub error: f64,
    /// Bandwidth (Hz); unlimited if `None`.
    pub bandwidth: Option<f64>,
}

/// Sweep memory (hardware section 3.8).
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct MemoryParts {
    /// Resolution (TV lines a picture height, at 50 % response); as fine as the raster if `None`.
    pub tv_lines: Option<u32>,
    /// Shades of grey that can be told apart; any number if `None`.
    pub grey: Option<u32>,
    /// Share of a picture that is left after it was erased; 0: none.
    pub erase_residual: f64,
    /// Displacement of the reading against the writing, one sigma (share of the picture's height); 0: none.
    pub registration: f64,
    /// How the beam current follows the speed of writing.
    pub write_compensation: WriteCompensation,
    /// Bandwidth of the write deflection (Hz).
    pub deflection: Option<f64>,
    /// Tubes: with 2 one is written while the other is read.
    pub tubes: u32,
    /// Bits of the words of a digital memory; it keeps numbers as they are if `None`.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub bits: Option<u32>,
}

/// How the beam current follows the speed of writing, so that exposure does not depend on it.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum WriteCompensation {
    /// In full: exposure does not depend on the speed.
    Exact,
    /// Within this ratio of the greatest to the least current.
    Ratio(f64),
    /// Not at all: exposure is the time that the beam stays.
    Off,
}

/// Video amplifier and picture tube of the display (hardware section 3.9).
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct PictureTubeParts {
    /// Bandwidth of the video amplifier (Hz); none is lost if `None`.
    pub bandwidth: Option<f64>,
    /// Exponent of the tube for which the video is corrected: it is `w^(1 / correction)`; 1: it is not.
    pub correction: f64,
    /// Exponent of the tube's law; 1: light is as the drive.
    pub gamma: f64,
    /// Video at which the beam is cut off (share of what drives white); 0: at black.
    pub cut_off: f64,
    /// Decay of the phosphor to a tenth (s); 0: at once.
    pub phosphor: f64,
    /// Resolution (TV lines a picture height, at 50 % response); as fine as the raster if `None`.
    pub tv_lines: Option<u32>,
    /// Fields of a picture: with 2 each showing scans every other line.
    pub fields: u32,
}

impl AnalogParts {
    /// Every part does its algebra: full scale 1 V, nothing else is there.
    pub const fn ideal() -> Self {
        Self {
            full_scale: 1.0,
            spread: false,
            sweep: SweepParts::IDEAL,
            function_generator: FunctionGeneratorParts::IDEAL,
            multiplier: MultiplierParts::IDEAL,
            multiplying_dac: MultiplyingDacParts::IDEAL,
            amplifier: AmplifierParts::IDEAL,
            summer_inputs: None,
            comparator: ComparatorParts::IDEAL,
            sample_hold: SampleHoldParts::IDEAL,
            reflectivity: ReflectivityParts::IDEAL,
            level_blend: LevelBlendParts::IDEAL,
            video_switch: VideoSwitchParts::IDEAL,
            feature: FeatureChainParts::IDEAL,
            shadow_line: ShadowLineParts::IDEAL,
            texture: TextureParts::IDEAL,
            projection: ProjectionParts::IDEAL,
            memory: MemoryParts::IDEAL,
            picture_tube: PictureTubeParts::IDEAL,
            video_bandwidth: None,
            wires: WireParts::IDEAL,
        }
    }
}
