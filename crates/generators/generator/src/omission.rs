//! What a scene does not need, and is told so.

use landscape::Landscape;
use scenario::Scenery;

/// What leaving something out does to the picture.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Weight {
    /// The picture is the same to the bit.
    Lossless,
    /// The picture would be another: the generator does not have it.
    NotModelled,
    /// The picture changes by at most this many grey levels of 255 in any pixel.
    Bounded(f64),
}

/// Something that was left out of a run.
#[derive(Debug, Clone, PartialEq)]
pub struct Omission {
    /// Block it belongs to, by crate name.
    pub block: &'static str,
    /// What was left out.
    pub what: String,
    /// Why it cannot touch the picture, or by how little.
    pub why: String,
    /// What it does to the picture.
    pub weight: Weight,
}

/// What the photographs of a landscape are to a generator that draws the ground itself; `None` without photographs.
pub fn photographs_beside(landscape: &Landscape, block: &'static str) -> Option<Omission> {
    let omission = || {
        let what = "photographs of the ground (`[[photograph]]`)";
        Omission::lossless(
            block,
            what,
            "it draws the ground itself; --machine panels lays photographs over it",
        )
    };
    (!landscape.photographs().is_empty()).then(omission)
}

/// What the lists of faces of a stage are to a generator that does not draw them; `None` without lists.
pub fn face_lists_beside(scenery: &Scenery, block: &'static str) -> Option<Omission> {
    (!scenery.face_lists().is_empty()).then(|| Omission {
        block,
        what: "sea, ships, effects of faces (`[sea]`, `[[ship]]`, `[[effect]]`, `[[plume]]`)".into(),
        why: "--machine smooth-faces and exact draw them".into(),
        weight: Weight::NotModelled,
    })
}

impl Omission {
    /// Makes an omission that leaves the picture the same to the bit.
    pub fn lossless(block: &'static str, what: impl Into<String>, why: impl Into<String>) -> Self {
        Self { block, what: what.into(), why: why.into(), weight: Weight::Lossless }
    }
}
