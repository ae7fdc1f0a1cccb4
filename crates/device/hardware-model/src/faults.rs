//! Overlays of one fault each, that the program carries.

/// Overlays with one fault each, in the order of the artefacts that they prove (hardware section 5), with their text.
pub const FAULTS: [(&str, &str); 25] = [
    ("tear", include_str!("../../../../hardware-models/faults/tear.toml")),
    ("stale", include_str!("../../../../hardware-models/faults/stale.toml")),
    ("mirror", include_str!("../../../../hardware-models/faults/mirror.toml")),
    ("starve", include_str!("../../../../hardware-models/faults/starve.toml")),
    ("smear", include_str!("../../../../hardware-models/faults/smear.toml")),
    ("slew", include_str!("../../../../hardware-models/faults/slew.toml")),
    ("fold", include_str!("../../../../hardware-models/faults/fold.toml")),
    ("fringe", include_str!("../../../../hardware-models/faults/fringe.toml")),
    ("quilt", include_str!("../../../../hardware-models/faults/quilt.toml")),
    ("facet", include_str!("../../../../hardware-models/faults/facet.toml")),
    ("coarse", include_str!("../../../../hardware-models/faults/coarse.toml")),
    ("edge", include_str!("../../../../hardware-models/faults/edge.toml")),
    ("hold", include_str!("../../../../hardware-models/faults/hold.toml")),
    ("chatter", include_str!("../../../../hardware-models/faults/chatter.toml")),
    ("slide", include_str!("../../../../hardware-models/faults/slide.toml")),
    ("blur", include_str!("../../../../hardware-models/faults/blur.toml")),
    ("expose", include_str!("../../../../hardware-models/faults/expose.toml")),
    ("ghost", include_str!("../../../../hardware-models/faults/ghost.toml")),
    ("register", include_str!("../../../../hardware-models/faults/register.toml")),
    ("seam", include_str!("../../../../hardware-models/faults/seam.toml")),
    ("roll", include_str!("../../../../hardware-models/faults/roll.toml")),
    ("jerk", include_str!("../../../../hardware-models/faults/jerk.toml")),
    ("clip", include_str!("../../../../hardware-models/faults/clip.toml")),
    ("stripe", include_str!("../../../../hardware-models/faults/stripe.toml")),
    ("band", include_str!("../../../../hardware-models/faults/band.toml")),
];

/// What the head of an overlay of one fault says that it proves, without the place of its source; nothing where it says nothing.
pub fn proof(text: &str) -> &str {
    let (_, rest) = text.split_once("Proves ").unwrap_or_default();
    let rest = rest.lines().next().unwrap_or_default();
    rest.trim_end_matches('.').split(" (").next().unwrap_or_default()
}

/// What the head of an overlay of one fault predicts of the picture: its sentences behind what it proves; nothing where it says nothing.
pub fn prediction(text: &str) -> String {
    let head = text.split("format =").next().unwrap_or_default();
    let behind = head.lines().skip_while(|line| !line.contains("Proves ")).skip(1);
    let sentences = behind.map_while(|line| line.strip_prefix("# "));
    sentences.collect::<Vec<_>>().join(" ")
}
