//! The detectors: one for each artefact, each from what a run shows to one number.

pub mod array;
pub mod beam;
pub mod late;
pub mod picture;

use crate::artefacts::look::Look;
use crate::artefacts::scenes::Place;

/// A detector of one artefact.
#[derive(Debug, Clone, Copy)]
pub struct Detector {
    /// Number in the list of artefacts: 1 is A1.
    pub number: usize,
    pub name: &'static str,
    /// The scene that it looks at.
    pub place: Place,
    /// Unit of its number.
    pub unit: &'static str,
    /// From here on the artefact is there.
    pub threshold: f64,
    pub measure: fn(&Look<'_>) -> f64,
}

/// Detectors of all artefacts, A1 first.
pub const DETECTORS: [Detector; 27] = {
    const fn detector(
        number: usize,
        name: &'static str,
        place: Place,
        (threshold, unit): (f64, &'static str),
        measure: fn(&Look<'_>) -> f64,
    ) -> Detector {
        Detector { number, name, place, unit, threshold, measure }
    }
    [
        detector(1, "tear", Place::Relief, (0.1, "m"), late::tear),
        detector(2, "stale corner", Place::Relief, (2.0, "m"), late::stale_corner),
        detector(3, "mirror ghost", Place::Rows, (0.5, "of the mirrored ground"), late::mirror_ghost),
        detector(4, "corner comb", Place::Relief, (0.1, "of the crossings at corners"), late::corner_comb),
        detector(5, "drum starvation", Place::Turn, (4.0, "corners a frame"), late::drum_starvation),
        detector(6, "ridge smear", Place::Waves, (0.5, "m"), array::ridge_smear),
        detector(7, "slew flattening", Place::Rows, (0.15, "of the sweep"), array::slew_flattening),
        detector(8, "fold shortfall", Place::Plane, (4.0, "m"), array::fold_shortfall),
        detector(9, "bright fringe", Place::Plane, (5.0, "m"), array::bright_fringe),
        detector(10, "quilting", Place::Plateau, (0.03, "m"), array::quilting),
        detector(11, "facets", Place::Rows, (0.4, "a region"), array::facets),
        detector(12, "coefficient steps", Place::Rows, (0.1, "m"), array::coefficient_steps),
        detector(13, "displaced edge", Place::Strips, (1.0, "m"), beam::displaced_edge),
        detector(14, "crest overdraw", Place::Waves, (0.3, "µs"), beam::crest_overdraw),
        detector(15, "hold error", Place::Waves, (20.0, "mV"), beam::hold_error),
        detector(16, "derivative chatter", Place::Flat, (0.8, "toggles a µs"), beam::chatter),
        detector(17, "shade shift", Place::Waves, (10.0, "m"), beam::shade_shift),
        detector(18, "foreground blur", Place::Flat, (3.0, "lines"), beam::foreground_blur),
        detector(19, "exposure gradient", Place::Flat, (0.5, "power of the dwell"), beam::exposure),
        detector(20, "sticky picture", Place::Pictures, (0.1, "of the frame before"), picture::residue),
        detector(21, "registration", Place::Pictures, (0.5, "% of the height"), picture::registration),
        detector(22, "switch seams", Place::Strips, (80.0, "ns"), beam::switch_seam),
        detector(23, "roll steps", Place::Roll, (0.25, "degrees"), picture::roll_steps),
        detector(24, "lag of update", Place::Motion, (1.5, "showings"), picture::lag_of_update),
        detector(25, "saturation", Place::Rows, (20.0, "m"), array::saturation),
        detector(26, "queue jitter", Place::Relief, (0.05, "of the sweeps"), late::queue_jitter),
        detector(27, "blend band", Place::Levels, (2.0, "% of slope"), array::blend_band),
    ]
};
