//! A landscape as its file describes it: nothing is built yet.

use std::path::{Path, PathBuf};

use crate::boulder::Shape;
use crate::crater::CraterForm;
use crate::distribution::Distribution;
use crate::frame::Frame;
use crate::grid::Grid;
use crate::growth::Growth;
use crate::height_grid::Area;
use crate::roughness::Roughness;
use crate::sunlight::Light;
use crate::switches::Reported;
use crate::texture::TextureWish;

/// A landscape in order. Features stand in the order of their names, whatever the order of the file.
#[derive(Debug, Clone, PartialEq)]
pub struct Description {
    /// Name of the landscape, for people.
    pub title: String,
    /// Piece of the sphere that it covers.
    pub frame: Frame,
    /// Posts of the heights.
    pub grid: Grid,
    /// What the features lie on.
    pub base: BaseWish,
    /// Features, in the order of their names.
    pub features: Vec<Feature>,
    /// Where the document's way is taken.
    pub reported: Reported,
    /// Sun and surface, where the file has them.
    pub light: Option<Light>,
}

impl Description {
    /// Files that it names: that of the base, and the pictures of enabled textures.
    pub fn files(&self) -> impl Iterator<Item = &Path> {
        let base = match &self.base {
            BaseWish::File { path, .. } => Some(path),
            BaseWish::Level(_) => None,
        };
        let enabled = self.features.iter().filter(|feature| feature.is_enabled);
        let pictures = enabled.filter_map(|feature| match &feature.kind {
            Kind::Texture(wish) => Some(&wish.path),
            _ => None,
        });
        base.into_iter().chain(pictures).map(PathBuf::as_path)
    }
}

/// What a file says about the base.
#[derive(Debug, Clone, PartialEq)]
pub enum BaseWish {
    /// The same height everywhere (m).
    Level(f64),
    /// An elevation file, and the band with the heights.
    File {
        /// Path of the file.
        path: PathBuf,
        /// Band with the heights, from 1, where the file has several.
        band: Option<usize>,
    },
}

/// Something that lies on the base.
#[derive(Debug, Clone, PartialEq)]
pub struct Feature {
    /// Name, by which heights are added up.
    pub id: String,
    /// Whether it is built.
    pub is_enabled: bool,
    /// Its kind, with its attributes.
    pub kind: Kind,
    /// Roughness over its extent.
    pub roughness: Option<Roughness>,
}

/// Kinds of features that a landscape can have.
#[derive(Debug, Clone, PartialEq)]
pub enum Kind {
    /// One crater by its attributes.
    Crater(CraterForm),
    /// Ground that grows from control points.
    Growth(Growth),
    /// An area without heights of its own, for roughness.
    Area(Area),
    /// A picture over the ground that says its albedo.
    Texture(TextureWish),
    /// One boulder at a place.
    Boulder {
        /// Place of its middle: north, east (m).
        at: [f64; 2],
        /// Radius, or side of a cube (m).
        radius: f64,
        /// What boulders are like.
        look: BoulderLook,
        /// Turns it and forms a rock.
        seed: u64,
    },
    /// Craters over a range, straight down, walls linear.
    Craters {
        /// Where they lie, and how large they are.
        distribution: Distribution,
        /// Lowest and highest wall as a share of the radius.
        wall: [f64; 2],
        /// Least and greatest depth as a share of the radius.
        depth: [f64; 2],
    },
    /// Boulders over a range.
    Boulders {
        /// Where they lie, and how large they are.
        distribution: Distribution,
        /// What they are like.
        look: BoulderLook,
    },
}

/// What boulders of a feature are like.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct BoulderLook {
    /// Form of each boulder.
    pub shape: Shape,
    /// Share of the height below the ground.
    pub burial: f64,
}

impl Kind {
    /// Word of the file.
    pub fn word(&self) -> &'static str {
        match self {
            Self::Crater(_) => "crater",
            Self::Growth(_) => "growth",
            Self::Area(_) => "area",
            Self::Texture(_) => "texture",
            Self::Boulder { .. } => "boulder",
            Self::Craters { .. } => "craters",
            Self::Boulders { .. } => "boulders",
        }
    }
}
