//! Overlays of one fault each, that the program carries.

/// The overlays by name, with their text; `docs/blocks/sampled.md` has the sign of each.
pub(crate) const FAULTS: [(&str, &str); 7] = [
    ("twinkle", include_str!("../../../../hardware-models/faults/sampled/twinkle.toml")),
    ("shared-stack", include_str!("../../../../hardware-models/faults/sampled/shared-stack.toml")),
    ("one-light", include_str!("../../../../hardware-models/faults/sampled/one-light.toml")),
    ("short-list", include_str!("../../../../hardware-models/faults/sampled/short-list.toml")),
    ("slow-sampler", include_str!("../../../../hardware-models/faults/sampled/slow-sampler.toml")),
    ("off-centre", include_str!("../../../../hardware-models/faults/sampled/off-centre.toml")),
    ("stack-only", include_str!("../../../../hardware-models/faults/sampled/stack-only.toml")),
];
