//! Overlays of one fault each, that the program carries.

/// The overlays by name, with their text; `docs/blocks/smooth-faces.md` has the sign of each.
pub(crate) const FAULTS: [(&str, &str); 10] = [
    ("stepping", include_str!("../../../../hardware-models/faults/smooth-faces/stepping.toml")),
    ("few-edges", include_str!("../../../../hardware-models/faults/smooth-faces/few-edges.toml")),
    ("replace", include_str!("../../../../hardware-models/faults/smooth-faces/replace.toml")),
    ("uncut", include_str!("../../../../hardware-models/faults/smooth-faces/uncut.toml")),
    ("screen-linear", include_str!("../../../../hardware-models/faults/smooth-faces/screen-linear.toml")),
    ("sea-first", include_str!("../../../../hardware-models/faults/smooth-faces/sea-first.toml")),
    ("deep-hull", include_str!("../../../../hardware-models/faults/smooth-faces/deep-hull.toml")),
    ("late-sequence", include_str!("../../../../hardware-models/faults/smooth-faces/late-sequence.toml")),
    ("dead-sun", include_str!("../../../../hardware-models/faults/smooth-faces/dead-sun.toml")),
    ("four-channels", include_str!("../../../../hardware-models/faults/smooth-faces/four-channels.toml")),
];
