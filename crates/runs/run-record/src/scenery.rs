//! What lies and stands on the ground, how it is lit and what it reflects: how much of each, and one hash of all.

use std::fmt::{self, Write};

use features::{Crater, Features};
use generator::Stage;
use landscape::{Attitude, CraterGrain, Photometry};
use scenario::{Scenery, Standing};
use serde::{Deserialize, Serialize};
use solids::{Body, Kind};

/// Everything of a stage that is neither stored terrain nor a setting.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct SceneryRecord {
    /// Craters of the feature list.
    pub craters: usize,
    /// Rocks of the whole mission.
    pub rock_bodies: usize,
    /// Man-made things of the whole mission.
    pub culture_bodies: usize,
    /// Bodies of the whole mission that move or are open.
    #[serde(default, skip_serializing_if = "is_none")]
    pub guest_bodies: usize,
    /// Number of groups of objects.
    #[serde(default, skip_serializing_if = "is_none")]
    pub groups: usize,
    /// Light points, sheets, overlays and discs of the sky of the whole mission.
    #[serde(default, skip_serializing_if = "is_none")]
    pub effects: usize,
    /// Patches of track that the whole mission leaves.
    pub track_patches: usize,
    /// Number of far silhouettes.
    pub silhouettes: usize,
    /// Whether the soil has texture.
    pub texture: bool,
    /// Name of the law of reflection.
    pub photometry: String,
    /// BLAKE3 of all of these, hexadecimal.
    pub blake3: String,
}

impl SceneryRecord {
    /// The record of `stage`: bodies and tracks of the whole mission.
    pub fn new(stage: &Stage) -> Self {
        let (landscape, scenery) = (&stage.landscape, &stage.scenery);
        let bodies = |kind: Kind| scenery.standing().iter().filter(|one| one.body.kind == kind).count();
        let few = (landscape.texture(), landscape.silhouettes(), landscape.photometry());
        let dated = (scenery.suns(), scenery.patches(f64::INFINITY));
        let hash = hash_of(&(few, dated, hash_of_craters(landscape.features()), hash_of_bodies(scenery)));
        Self {
            craters: landscape.features().craters().len(),
            rock_bodies: bodies(Kind::Rock),
            culture_bodies: bodies(Kind::Culture),
            guest_bodies: scenery.all_guests().len(),
            groups: scenery.groups().len(),
            effects: effects(scenery),
            track_patches: scenery.patches(f64::INFINITY).len(),
            silhouettes: landscape.silhouettes().len(),
            texture: landscape.texture().is_some(),
            photometry: format!("{:?}", landscape.photometry()),
            blake3: with_crater_grain(with_guests(hash, scenery), landscape.crater_grain()),
        }
    }
}

/// How many light points, sheets, overlays and discs of the sky a mission has.
fn effects(scenery: &Scenery) -> usize {
    let all = scenery.all_effects().iter().map(|carried| &carried.effects);
    all.map(|one| one.lights.len() + one.sheets.len() + one.overlays.len() + one.discs.len()).sum()
}

/// Records without any have no such key: they keep the bytes that they had before there were any.
fn is_none(count: &usize) -> bool {
    *count == 0
}

/// The hash of a scenery and of what it has for other generators than the hybrid machine; `hash` itself where it has none.
fn with_guests(hash: String, scenery: &Scenery) -> String {
    let dressed: Vec<_> = scenery.standing().iter().map(|one| &one.body).filter(is_dressed).collect();
    let hash = match (dressed.is_empty(), scenery.all_guests().is_empty(), scenery.groups().is_empty()) {
        (true, true, true) => hash,
        _ => hash_of(&(hash, dressed, scenery.all_guests(), scenery.groups())),
    };
    match scenery.all_effects() {
        [] => hash,
        effects => hash_of(&(hash, effects)),
    }
}

/// The hash of a scenery and of what its craters do to texture; `hash` itself where they do nothing.
fn with_crater_grain(hash: String, grain: Option<&CraterGrain>) -> String {
    match grain {
        None => hash,
        Some(grain) => hash_of(&(hash, grain)),
    }
}

/// Whether a body has more than a place, a shape and greys.
fn is_dressed(body: &&Body) -> bool {
    let solid = &body.solid;
    let has_looks = solid.is_colourful() || solid.is_smooth() || solid.photometry() != Photometry::Lambert;
    has_looks || body.priority != 0 || body.group.is_some()
}

/// Craters and bodies come by the hundred thousand: their numbers are hashed as they are, not as text.
fn hash_of_numbers(numbers: impl Iterator<Item = f64>) -> blake3::Hash {
    let mut hasher = blake3::Hasher::new();
    let mut block = Vec::with_capacity(BLOCK);
    for number in numbers {
        block.extend_from_slice(&number.to_le_bytes());
        if block.len() == BLOCK {
            hasher.update(&block);
            block.clear();
        }
    }
    hasher.update(&block);
    hasher.finalize()
}

/// Bytes that a hasher takes at once: a whole number of f64.
const BLOCK: usize = 1 << 14;

fn hash_of_craters(features: &Features) -> blake3::Hash {
    let numbers = |crater: Crater| {
        let [x, y] = crater.centre();
        let kind = f64::from(crater.type_number());
        [kind, x, y, crater.floor(), crater.foot(), crater.outer(), crater.depth(), crater.rim()]
    };
    hash_of_numbers(features.craters().iter().flat_map(numbers))
}

fn hash_of_bodies(scenery: &Scenery) -> blake3::Hash {
    let own = scenery.vehicle().into_iter().flat_map(|shape| {
        // Where it stands follows from the poses.
        shape.bodies([0.0, 0.0, shape.eye_height], Attitude::default())
    });
    let own: Vec<Standing> = own.map(|body| Standing { from: 0.0, until: 0.0, body }).collect();
    hash_of_numbers(scenery.standing().iter().chain(&own).flat_map(numbers_of_body))
}

fn numbers_of_body(Standing { from, until, body }: &Standing) -> impl Iterator<Item = f64> {
    let kind = f64::from(u8::from(body.kind == Kind::Culture));
    let head = [*from, *until, f64::from(body.object), kind];
    let points = [body.foot].into_iter().chain(body.vertices());
    let faces = body.solid.faces().iter().flat_map(|face| {
        [face.albedo].into_iter().chain(face.corners.iter().map(|&corner| f64::from(corner)))
    });
    head.into_iter().chain(points.flat_map(|point| point.to_array())).chain(faces)
}

/// BLAKE3 of every number in `value`: its Debug text names all fields, and floats in it read back the same.
pub fn hash_of(value: &impl fmt::Debug) -> String {
    struct Hashed(blake3::Hasher);
    impl Write for Hashed {
        fn write_str(&mut self, text: &str) -> fmt::Result {
            self.0.update(text.as_bytes());
            Ok(())
        }
    }
    let mut hashed = Hashed(blake3::Hasher::new());
    write!(hashed, "{value:?}").expect("a hasher takes everything");
    hashed.0.finalize().to_hex().to_string()
}

#[cfg(test)]
mod tests {
    use super::hash_of;

    #[test]
    fn the_last_bit_counts() {
        assert_eq!(hash_of(&[1.0, 0.1]), hash_of(&[1.0, 0.1]));
        assert_ne!(hash_of(&[1.0, 0.1]), hash_of(&[1.0, 0.1_f64.next_up()]));
        assert_ne!(hash_of(&0.0), hash_of(&-0.0));
    }
}
