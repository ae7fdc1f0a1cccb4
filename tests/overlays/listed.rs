//! Overlays of one fault each: those that ship, and one for every other part.

use hardware_model::FAULTS;

/// A fault, and where it is.
pub struct Overlay {
    pub name: &'static str,
    /// What a hardware model says; empty for one that ships.
    text: &'static str,
    /// Signals that the faulty part drives.
    pub at: &'static [&'static str],
}

impl Overlay {
    /// The overlay as a file; full scale is 10 V.
    pub fn text(&self) -> String {
        let shipped = FAULTS.iter().find(|(name, _)| *name == self.name).map(|(_, text)| (*text).to_owned());
        shipped.unwrap_or_else(|| format!("format = 1\n[analog]\nfull_scale_v = 10\n{}", self.text))
    }
}

const fn shipped(name: &'static str, at: &'static [&'static str]) -> Overlay {
    Overlay { name, text: "", at }
}

const fn own(name: &'static str, text: &'static str, at: &'static [&'static str]) -> Overlay {
    Overlay { name, text, at }
}

/// All of them; those that ship first, in their order.
pub static OVERLAYS: &[Overlay] = &[
    shipped("tear", WORDS),
    shipped("stale", WORDS),
    shipped("mirror", WORDS),
    shipped("starve", WORDS),
    shipped("smear", &["tg.product.*", "tg.coarse.product.*", "tg.*sum.*"]),
    shipped("slew", SUMS),
    shipped("fold", RAMPS),
    shipped("fringe", STROBED),
    shipped("quilt", DACS),
    shipped("facet", FUNCTIONS),
    shipped("coarse", WORDS),
    shipped("edge", &["fg.present", "sc.gate", "dpp.blank"]),
    shipped("hold", &["dpp.hold"]),
    shipped("chatter", &["tg.*sum.*", "dpp.blank"]),
    shipped("slide", &["tg.reflectivity"]),
    shipped("blur", &["sweep.range"]),
    shipped("expose", &["sm.write"]),
    shipped("ghost", &[]),
    shipped("register", &[]),
    shipped("seam", FADES),
    shipped("roll", &["yoke.angle"]),
    shipped("jerk", &[]),
    shipped("clip", SUMS),
    shipped("stripe", ACCUMULATORS),
    shipped("band", &["tg.slope.*"]),
    own("late-words", "[loader]\naccess_ns = 3000\n", WORDS),
    own(
        "slow-drum",
        "[drum]\nrotation_ms = 2000\nrate_mb_s = 0.01\nrecord_words = 9\nqueue = 'fifo'\ncount = 1\n[buffer]\nwords = 360\n",
        WORDS,
    ),
    own("slow-set-up", "[cpu]\nsweep_setup_us = 3000\n", ACCUMULATORS),
    own("ramp-bits", "[sweep]\ndac_bits = 4\n", RAMPS),
    own("ramp-settling", "[sweep]\ndac_bits = 10\nsettle_ns = 200\n", RAMPS),
    own("ramp-nonlinearity", "[sweep]\ndac_bits = 10\nnonlinearity_pct = 2\n", RAMPS),
    own("ramp-glitch", "[sweep]\ndac_bits = 10\nglitch_v_ns = 500\n", RAMPS),
    own("ramp-comparators", "[sweep]\nfold_detect = 'comparator'\n[comparator]\ndelay_ns = 100\n", STOPS),
    own("basis-error", "[function_generator]\nerror_pct = 1\n", FUNCTIONS),
    own("basis-bandwidth", "[function_generator]\nbandwidth_mhz = 1\n", FUNCTIONS),
    own("product-error", "[multiplier]\nerror_pct = 1\n", PRODUCTS),
    own("product-scale", "[multiplier]\nscale_error_pct = 1\n", PRODUCTS),
    own("product-feedthrough", "[multiplier]\nfeedthrough_pct = 1\n", PRODUCTS),
    own("product-bandwidth", "[multiplier]\nbandwidth_mhz = 1\n", PRODUCTS),
    own("converter-bandwidth", "[multiplying_dac]\nbandwidth_mhz = 1\n", DACS),
    own("converter-switching", "[multiplying_dac]\nswitching_ns = 300\n", DACS),
    own("converter-feedthrough", "[multiplying_dac]\nfeedthrough_pct = 1\n", DACS),
    own("amplifier-noise", "[amplifier]\nnoise_mv = 5\n", SUMS),
    own("amplifier-bandwidth", "[amplifier]\ngain_bandwidth_mhz = 1\n", SUMS),
    own("light-error", "[reflectivity]\nmultiplier_error_pct = 1\n", LIGHT_MULTIPLIERS),
    own("light-scale", "[reflectivity]\nmultiplier_scale_error_pct = 1\n", LIGHT_MULTIPLIERS),
    own("light-feedthrough", "[reflectivity]\nmultiplier_feedthrough_pct = 1\n", LIGHT_SLOPES),
    own("light-bandwidth", "[reflectivity]\nmultiplier_bandwidth_mhz = 1\n", LIGHT_SLOPES),
    own("light-summers", "[reflectivity]\nsummer_bandwidth_mhz = 1\n", LIGHT_SUMS),
    own("light-root-error", "[reflectivity]\nroot_error_pct = 1\n", &["tg.light.root"]),
    own("light-root-bandwidth", "[reflectivity]\nroot_bandwidth_mhz = 1\n", &["tg.light.root"]),
    own("light-divider-error", "[reflectivity]\ndivider_error_pct = 1\n", &["tg.light.cosine"]),
    own("light-divider-bandwidth", "[reflectivity]\ndivider_bandwidth_mhz = 1\n", &["tg.light.cosine"]),
    own("light-saturation", "[reflectivity]\nsaturation_v = 2\n", &["tg.light.squares", "tg.light.root"]),
    own("feature-error", "[feature_generator]\nchain_error_pct = 5\n", FEATURES),
    own("feature-bandwidth", "[feature_generator]\nchain_bandwidth_mhz = 0.5\n", FEATURE_SUMS),
    own("few-sub-generators", "[feature_generator]\nsub_generators = 1\n", FEATURES),
    own("slow-crater-loads", "[feature_generator]\nload_words_us = 0.5\n", FEATURES),
    own("shadow-lines", "[shadow_controller]\nline_error_pct = 5\n", SHADOW_LINES),
    own("few-line-generators", "[shadow_controller]\nline_generators = 1\n", SHADOW_LINES),
    own(
        "shadow-tube",
        "[shadow_controller]\nvariant = 'scan-converter'\nregistration_offset_pct = [1, 1]\n",
        &["sc.or"],
    ),
    own("texture-bits", "[texture_generator]\ndac_bits = 3\n", &["txg.texture"]),
    own("texture-filter", "[texture_generator]\nfilter_mhz = 0.5\n", &["txg.texture"]),
    own(
        "comparator-offset",
        "[comparator]\noffset_mv = 500\n",
        &["fg.comparator.*", "sc.comparator.*", "fg.or", "sc.or", "dpp.blank"],
    ),
    own("comparator-hysteresis", "[comparator]\nhysteresis_pct = 5\n", SHADOW_LINES),
    own("comparator-overdrive", "[comparator]\noverdrive_mv_ns = 5000\ndelay_ns = 10\n", GATES),
    own("gates-keyed", "[mixing_unit]\ngate = 'self-keyed'\nthreshold = 0.1\n", &["mu.vs1"]),
    own("switch-time", "[video_switch]\ntime_ns = 300\n", FADES),
    own("switch-level", "[video_switch]\nlevel_mismatch_pct = 5\n", &["mu.reflectivity"]),
    own("switch-gain", "[video_switch]\ngain_mismatch_pct = 5\n", &["mu.reflectivity"]),
    own("switch-delay", "[video_switch]\ndelay_mismatch_ns = 200\n", &["mu.reflectivity"]),
    own("crosstalk", "[video_switch]\ncrosstalk_db = -20\n", &["mu.reflectivity"]),
    own("video-bandwidth", "[video]\nbandwidth_mhz = 0.5\n", &["mu.reflectivity"]),
    own("slow-wires", "[wires]\nbandwidth_mhz = 0.5\n", WIRES),
    own("projection-error", "[dpp]\nfunction_error_pct = 1\n", &["dpp.elevation"]),
    own("projection-bandwidth", "[dpp]\nfunction_bandwidth_mhz = 1\n", &["dpp.elevation"]),
    own("deflection-bandwidth", "[sweep_memory]\ndeflection_mhz = 0.5\n", &["sm.write"]),
    own(
        "features-on-drums",
        "[drum]\nrotation_ms = 17\n[feature_bank]\ndrums = 'apart'\nrecord_words = 9\nbuffer_words = 27\n",
        FEATURES,
    ),
    own(
        "shadows-on-drums",
        "[drum]\nrotation_ms = 17\n[shadow_bank]\ndrums = 'apart'\nrecord_words = 9\nbuffer_words = 27\n",
        &["sc.or"],
    ),
    own(
        "bodies-on-drums",
        "[drum]\nrotation_ms = 17\n[polyhedron_bank]\ndrums = 'apart'\nrecord_words = 9\nbuffer_words = 27\n",
        &["pg.*"],
    ),
];

const ACCUMULATORS: &[&str] = &["sweep.accumulator.*", "sweep.coarse.accumulator.*"];
const RAMPS: &[&str] = &["sweep.x", "sweep.y", "sweep.coarse.x", "sweep.coarse.y"];
const STOPS: &[&str] = &["sweep.fold.*", "sweep.coarse.fold.*"];
const STROBED: &[&str] = &["sweep.polarity.*", "sweep.coarse.polarity.*", "tg.*.hold"];
const WORDS: &[&str] = &["tg.*.word*"];
const FUNCTIONS: &[&str] = &["tg.*fn.*"];
const PRODUCTS: &[&str] = &["tg.product.*", "tg.coarse.product.*"];
const DACS: &[&str] = &["tg.*.dac*"];
const SUMS: &[&str] = &["tg.*sum.*"];
const LIGHT_SLOPES: &[&str] = &["tg.light.product.n", "tg.light.product.e", "tg.light.square.*"];
const LIGHT_MULTIPLIERS: &[&str] = &["tg.light.product.*", "tg.light.square.*"];
const LIGHT_SUMS: &[&str] = &["tg.light.facing", "tg.light.squares"];
const FEATURE_SUMS: &[&str] = &["fg.height.*", "fg.height", "fg.slope.*"];
const FEATURES: &[&str] = &["fg.height.*", "fg.comparator.*", "fg.height", "fg.slope.*", "fg.or", "fg.grain"];
const SHADOW_LINES: &[&str] = &["sc.or", "sc.comparator.*"];
const GATES: &[&str] = &["fg.comparator.*", "sc.comparator.*", "fg.present", "sc.gate"];
const FADES: &[&str] = &["mu.vs1.fade", "mu.vs2.fade"];
const WIRES: &[&str] = &[
    "tg.height",
    "tg.slope.*",
    "tg.reflectivity",
    "fg.height",
    "fg.slope.*",
    "fg.reflectivity",
    "mu.height",
    "mu.reflectivity",
];
