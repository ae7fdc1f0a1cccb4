//! What puts each artefact in.

use std::path::PathBuf;

use hardware_model::{HardwareModel, ModelSource};

/// An artefact and the overlay on the ideal machine that puts its cause in.
#[derive(Debug, Clone, Copy)]
pub struct Cause {
    /// Number in the list of artefacts: 1 is A1.
    pub number: usize,
    /// Name of its file in `hardware-models/faults/`.
    pub overlay: &'static str,
}

/// All, A1 first. A1 and A4, and A13 and A14, are two signatures of one cause.
pub const CAUSES: [Cause; 27] = {
    const fn cause(number: usize, overlay: &'static str) -> Cause {
        Cause { number, overlay }
    }
    [
        cause(1, "tear"),
        cause(2, "stale"),
        cause(3, "mirror"),
        cause(4, "tear"),
        cause(5, "starve"),
        cause(6, "smear"),
        cause(7, "slew"),
        cause(8, "fold"),
        cause(9, "fringe"),
        cause(10, "quilt"),
        cause(11, "facet"),
        cause(12, "coarse"),
        cause(13, "edge"),
        cause(14, "edge"),
        cause(15, "hold"),
        cause(16, "chatter"),
        cause(17, "slide"),
        cause(18, "blur"),
        cause(19, "expose"),
        cause(20, "ghost"),
        cause(21, "register"),
        cause(22, "seam"),
        cause(23, "roll"),
        cause(24, "jerk"),
        cause(25, "clip"),
        cause(26, "stripe"),
        cause(27, "band"),
    ]
};

/// The ideal machine, with an overlay if there is one.
pub fn model(overlay: Option<&str>) -> HardwareModel {
    let folder = PathBuf::from(env!("CARGO_MANIFEST_DIR")).join("../hardware-models/faults");
    let overlays: Vec<PathBuf> =
        overlay.into_iter().map(|name| folder.join(format!("{name}.toml"))).collect();
    let ideal = ModelSource::BuiltIn("ideal".into());
    HardwareModel::load(&ideal, &overlays, &[]).unwrap_or_else(|e| panic!("{e}")).model
}

/// The model of artefact `number`.
pub fn faulty(number: usize) -> HardwareModel {
    model(Some(CAUSES[number - 1].overlay))
}
