//! What lies and stands on the ground, how it is lit and what it reflects: how much of each, and one hash of all.

use std::fmt::{self, Write};

use generator::Stage;
use serde::Serialize;
use solids::Kind;

/// Everything of a stage that is neither stored terrain nor a setting.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct SceneryRecord {
    craters: usize,
    rock_bodies: usize,
    culture_bodies: usize,
    track_patches: usize,
    silhouettes: usize,
    texture: bool,
    photometry: String,
    blake3: String,
}

impl SceneryRecord {
    /// The record of `stage`: bodies and tracks of the whole mission.
    pub fn new(stage: &Stage) -> Self {
        let (landscape, scenery) = (&stage.landscape, &stage.scenery);
        let bodies = |kind: Kind| scenery.standing().iter().filter(|one| one.body.kind == kind).count();
        let all = (landscape.features().craters(), landscape.texture(), landscape.silhouettes());
        Self {
            craters: landscape.features().craters().len(),
            rock_bodies: bodies(Kind::Rock),
            culture_bodies: bodies(Kind::Culture),
            track_patches: scenery.patches(f64::INFINITY).len(),
            silhouettes: landscape.silhouettes().len(),
            texture: landscape.texture().is_some(),
            photometry: format!("{:?}", landscape.photometry()),
            blake3: hash_of(&(all, landscape.photometry(), scenery)),
        }
    }
}

/// BLAKE3 of every number in `value`: its Debug text names all fields, and floats in it read back the same.
pub(crate) fn hash_of(value: &impl fmt::Debug) -> String {
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
