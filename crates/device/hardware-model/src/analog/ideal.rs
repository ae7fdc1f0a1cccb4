//! Which parts are not there: the figures of an ideal part, and what each block asks before it builds one.

use super::{
    AmplifierParts, AnalogParts, BlendWeight, ComparatorParts, FeatureChainParts, FoldDetect,
    FunctionGeneratorParts, LevelBlendParts, LoopParts, MemoryParts, MultiplierParts, MultiplyingDacParts,
    PictureTubeParts, ProjectionParts, ReflectivityParts, SampleHoldParts, ShadowLineParts, SweepParts,
    TextureParts, VideoSwitchParts, WriteCompensation,
};

impl SweepParts {
    /// Straight ramps that turn at their stops.
    pub const IDEAL: Self = Self {
        dac_bits: None,
        settle: 0.0,
        nonlinearity: 0.0,
        glitch: 0.0,
        smoother: 0.0,
        strobe_offset: 0.0,
        fold_detect: FoldDetect::Digital,
        preset: true,
    };
}

impl FunctionGeneratorParts {
    /// A generator that gives the function itself.
    pub const IDEAL: Self = Self { segments: None, rounding: 0.0, error: 0.0, bandwidth: None };
}

impl MultiplierParts {
    /// A multiplier that gives the product itself.
    pub const IDEAL: Self = Self { error: 0.0, scale_error: 0.0, feedthrough: 0.0, bandwidth: None };
}

impl MultiplyingDacParts {
    /// A multiplier that gives the product itself.
    pub const IDEAL: Self =
        Self { bits: None, gain_error: 0.0, bandwidth: None, glitch: 0.0, switching: 0.0, feedthrough: 0.0 };
}

impl AmplifierParts {
    /// An amplifier that does what a wire does.
    pub const IDEAL: Self =
        Self { gain_bandwidth: None, slew: None, noise: 0.0, saturation: None, recovery: 0.0 };
}

impl ComparatorParts {
    /// At once, at the very level.
    pub const IDEAL: Self = Self { delay: 0.0, overdrive: 0.0, hysteresis: 0.0, offset: 0.0 };
}

impl SampleHoldParts {
    /// Holds what there was.
    pub const IDEAL: Self = Self { acquire: 0.0, droop: 0.0, pedestal: 0.0, aperture: 0.0, jitter: 0.0 };
}

impl ReflectivityParts {
    /// The law itself, in step with the height.
    pub const IDEAL: Self = Self {
        delay_mismatch: 0.0,
        slope_full_scale: 1.0,
        multiplier: MultiplierParts::IDEAL,
        summer_bandwidth: None,
        root: LoopParts::IDEAL,
        divider: LoopParts::IDEAL,
        saturation: None,
    };

    /// Whether the stage is the law itself, in step with the height or not.
    pub fn stage_is_ideal(&self) -> bool {
        let Self { delay_mismatch, slope_full_scale, .. } = *self;
        *self == Self { delay_mismatch, slope_full_scale, ..Self::IDEAL }
    }
}

impl LevelBlendParts {
    /// A blend with all of its products.
    pub const IDEAL: Self = Self { weight: BlendWeight::Quintic, slope_term: true };

    /// Whether it is the blend that a model without a word of it has.
    pub fn is_usual(&self) -> bool {
        *self == Self::IDEAL
    }

    /// Whether the slopes are those of the blended ground, whatever its weight.
    pub fn is_ideal(&self) -> bool {
        self.slope_term
    }
}

impl LoopParts {
    /// A part that solves its law itself.
    pub const IDEAL: Self = Self { error: 0.0, bandwidth: None };
}

impl VideoSwitchParts {
    /// At once, without a step.
    pub const IDEAL: Self =
        Self { time: 0.0, level_mismatch: 0.0, gain_mismatch: 0.0, delay_mismatch: 0.0, crosstalk: None };
}

impl FeatureChainParts {
    /// The law of the crater itself.
    pub const IDEAL: Self = Self { error: 0.0, bandwidth: None };
}

impl ShadowLineParts {
    /// Lines where they are.
    pub const IDEAL: Self = Self { error: 0.0 };
}

impl TextureParts {
    /// A converter and a filter that leave the pattern as it is.
    pub const IDEAL: Self = Self { bits: None, bandwidth: None };
}

impl ProjectionParts {
    /// Generators that give the functions themselves.
    pub const IDEAL: Self = Self { error: 0.0, bandwidth: None };
}

impl MemoryParts {
    /// Reads what was written; one tube.
    pub const IDEAL: Self = Self {
        tv_lines: None,
        grey: None,
        erase_residual: 0.0,
        registration: 0.0,
        write_compensation: WriteCompensation::Exact,
        deflection: None,
        tubes: 1,
        bits: None,
    };

    /// Whether the picture read is the picture written, but for noise, which is in the video. The number of tubes does not
    /// matter where none has a fault, nor do the words of a digital memory, which are rounded as they are written.
    pub fn keeps_pictures(&self) -> bool {
        Self { tubes: 1, grey: None, bits: None, ..*self } == Self::IDEAL
    }
}

impl PictureTubeParts {
    /// Shows what is read, all lines at once.
    pub const IDEAL: Self = Self {
        bandwidth: None,
        correction: 1.0,
        gamma: 1.0,
        cut_off: 0.0,
        phosphor: 0.0,
        tv_lines: None,
        fields: 1,
    };
}

/// A block asks for its own parts alone; the full scale and the spread matter only where there is a part.
impl AnalogParts {
    /// Whether the folded ramps are straight and turn at their stops.
    pub fn sweep_is_ideal(&self) -> bool {
        self.sweep == SweepParts::IDEAL
    }

    /// Whether the terrain generator does its algebra: function generators, multipliers, D/A multipliers, summers,
    /// and the ramps that feed them.
    pub fn terrain_is_ideal(&self) -> bool {
        self.sweep_is_ideal()
            && self.function_generator == FunctionGeneratorParts::IDEAL
            && self.multiplier == MultiplierParts::IDEAL
            && self.multiplying_dac == MultiplyingDacParts::IDEAL
            && self.amplifier == AmplifierParts::IDEAL
            && self.reflectivity.delay_mismatch == 0.0
            && self.reflectivity.stage_is_ideal()
    }

    /// Whether the video switches of the mixing unit and the comparators that key them are ideal.
    pub fn switching_is_ideal(&self) -> bool {
        self.mixing_is_ideal() && self.comparator_is_ideal()
    }

    /// Whether the projection processor and the write gun put the beam where the law says, at once.
    pub fn beam_is_ideal(&self) -> bool {
        self.projection_is_ideal()
            && self.memory.write_compensation == WriteCompensation::Exact
            && self.memory.deflection.is_none()
    }

    /// Whether craters have the shape of their law, at once, and their comparators find footprints where they are and
    /// however steeply they are met; the comparators' delay is the mixing unit's.
    pub fn features_are_ideal(&self) -> bool {
        self.feature == FeatureChainParts::IDEAL
            && self.comparator.offset == 0.0
            && self.comparator.overdrive == 0.0
    }

    /// Whether the comparators of the shadow controller find boundaries where they are; their delay is the mixing unit's.
    pub fn shadow_lines_are_ideal(&self) -> bool {
        self.shadow_line == ShadowLineParts::IDEAL
            && self.comparator.hysteresis == 0.0
            && self.comparator.offset == 0.0
    }

    /// Whether texture is the pattern itself.
    pub fn texture_is_ideal(&self) -> bool {
        self.texture == TextureParts::IDEAL
    }

    /// Whether the third video switch lays bodies where they are: it switches at once, without a step.
    pub fn body_switch_is_ideal(&self) -> bool {
        self.video_switch == VideoSwitchParts::IDEAL && self.comparator.delay == 0.0
    }

    /// Whether the mixing unit switches at once and the video has no limit.
    pub fn mixing_is_ideal(&self) -> bool {
        self.video_switch == VideoSwitchParts::IDEAL && self.video_bandwidth.is_none()
    }

    /// Whether edges of occlusion, shadows and footprints lie where they are.
    pub fn comparator_is_ideal(&self) -> bool {
        self.comparator == ComparatorParts::IDEAL
    }

    /// Whether the display shows what is read: neither its parts nor noise in the video change it.
    pub fn display_is_ideal(&self) -> bool {
        self.picture_tube == PictureTubeParts::IDEAL && self.memory.grey.is_none()
    }

    /// Whether the picture shown is the picture written: neither storage tube nor display changes it.
    pub fn tubes_are_ideal(&self) -> bool {
        self.memory.keeps_pictures() && self.display_is_ideal()
    }

    /// Whether a picture depends on the frames before it: by residue, by the phosphor, or by lines that an earlier field has
    /// scanned.
    pub fn remembers_frames(&self) -> bool {
        self.memory.erase_residual > 0.0 || self.picture_tube.phosphor > 0.0 || self.picture_tube.fields > 1
    }

    /// Whether the projection processor does its algebra: function generators, comparator, sample-and-hold, and no
    /// noise on what it differentiates.
    pub fn projection_is_ideal(&self) -> bool {
        self.projection == ProjectionParts::IDEAL
            && self.comparator_is_ideal()
            && self.sample_hold == SampleHoldParts::IDEAL
            && self.amplifier.noise == 0.0
    }

    /// Whether nothing analog can be seen in a picture; the yoke's mechanics are [`crate::Yoke`]'s.
    pub fn is_ideal(&self) -> bool {
        self.terrain_is_ideal()
            && self.level_blend.is_ideal()
            && self.features_are_ideal()
            && self.shadow_lines_are_ideal()
            && self.texture_is_ideal()
            && self.mixing_is_ideal()
            && self.projection_is_ideal()
            && self.tubes_are_ideal()
            && self.wires.is_ideal()
    }
}
