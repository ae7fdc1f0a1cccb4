//! Overlays of one fault each, that the program carries.

/// The overlays by name, with their text; `docs/blocks/lod-mesh.md` has the sign of each.
pub(crate) const FAULTS: [(&str, &str); 6] = [
    ("no-morph", include_str!("../../../../hardware-models/faults/lod-mesh/no-morph.toml")),
    ("per-tile", include_str!("../../../../hardware-models/faults/lod-mesh/per-tile.toml")),
    ("no-stitch", include_str!("../../../../hardware-models/faults/lod-mesh/no-stitch.toml")),
    ("mean-radius", include_str!("../../../../hardware-models/faults/lod-mesh/mean-radius.toml")),
    ("coarse-light", include_str!("../../../../hardware-models/faults/lod-mesh/coarse-light.toml")),
    ("one-percent", include_str!("../../../../hardware-models/faults/lod-mesh/one-percent.toml")),
];
