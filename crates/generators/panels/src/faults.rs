//! Overlays of one fault each, that the program carries.

/// The overlays by name, with their text; `docs/blocks/panels.md` has the sign of each.
pub(crate) const FAULTS: [(&str, &str); 10] = [
    ("quadrant", include_str!("../../../../hardware-models/faults/panels/quadrant.toml")),
    ("real4", include_str!("../../../../hardware-models/faults/panels/real4.toml")),
    ("signed-bytes", include_str!("../../../../hardware-models/faults/panels/signed-bytes.toml")),
    ("box-average", include_str!("../../../../hardware-models/faults/panels/box-average.toml")),
    ("skewed-axes", include_str!("../../../../hardware-models/faults/panels/skewed-axes.toml")),
    ("linear-depth", include_str!("../../../../hardware-models/faults/panels/linear-depth.toml")),
    ("mirror-behind", include_str!("../../../../hardware-models/faults/panels/mirror-behind.toml")),
    ("mean-void", include_str!("../../../../hardware-models/faults/panels/mean-void.toml")),
    ("discard-partial", include_str!("../../../../hardware-models/faults/panels/discard-partial.toml")),
    ("both-ends", include_str!("../../../../hardware-models/faults/panels/both-ends.toml")),
];
