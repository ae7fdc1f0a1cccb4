//! Signals that lie behind a fault and need not move, and why.

use signal::name_matches;

/// Overlays, each with the signals that need not move, and the reason.
pub const EXCEPTIONS: &[(&str, &[&str], &str)] = &[
    (
        "tear",
        FINE_LEVEL,
        "regions of 300 m leave every word of the fine level its time; late-words is slower",
    ),
    ("tear", &["dpp.blank"], "what tears beyond the switch lies behind crests that stay"),
    (
        "stale",
        FINE_LEVEL,
        "regions of 300 m leave every word of the fine level its time; late-words is slower",
    ),
    ("late-words", &["fg.reflectivity", "pg.*"], "words are late beyond the craters and bodies in view"),
    ("slow-drum", FINE_LEVEL, "at a walking pace every corner of the fine level is in its buffer"),
    ("slew", &["dpp.blank"], "only the steepest rises are bounded, and they hide what they hid"),
    ("band", &["fg.reflectivity"], "the craters in view lie nearer than the blend"),
    ("slow-crater-loads", &["pg.*"], "craters that are drawn late hide nothing of the bodies"),
    ("starve", &["*"], "at a walking pace every record has come before it is asked for; slow-drum is slower"),
    ("stripe", &["*"], "of 96 sweeps each has more time than a set-up takes; slow-set-up is slower"),
    ("roll", &["yoke.angle"], "the scenario has no yoke; `a_yoke_that_steps_is_told` has one"),
    ("blur", &["*"], "the scenario names its own ground-range programme"),
];

/// What stands before the switch of the levels.
const FINE_LEVEL: &[&str] =
    &["tg.*.word*", "tg.*.dac*", "tg.*.height", "tg.sum.*", "fg.reflectivity", "pg.*"];

/// Why `signal` does not move under `overlay`, if it need not.
pub fn why_still(overlay: &str, signal: &str) -> Option<&'static str> {
    let is_here = |families: &[&str]| families.iter().any(|family| matches_level(family, signal));
    let found = EXCEPTIONS.iter().find(|(name, families, _)| *name == overlay && is_here(families));
    found.map(|(.., reason)| *reason)
}

/// Whether `pattern` has the family, of the same level.
fn matches_level(pattern: &str, family: &str) -> bool {
    name_matches(pattern, family)
        && (pattern == "*" || pattern.contains("coarse") == family.contains("coarse"))
}
