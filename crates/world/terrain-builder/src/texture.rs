//! Pictures over the ground that say its albedo.

use std::collections::BTreeMap;
use std::path::PathBuf;

use landscape::{AlbedoMap, AlbedoMapError, Texels};
use photographs::PhotographFileError;
use picture::Curve;

use crate::description::{Description, Kind};
use crate::grid::Axis;

/// A texture as a landscape file describes it.
#[derive(Debug, Clone, PartialEq)]
pub struct TextureWish {
    /// Picture: PNG, JPEG or TIFF.
    pub path: PathBuf,
    /// Row and column of the tile that it covers, from the south-west; none for the whole ground.
    pub tile: Option<[usize; 2]>,
    /// `u` at the western and the eastern border: 0 and 1 are the borders of the picture, beyond which it repeats.
    pub across: [f64; 2],
    /// `v` at the southern and the northern border: 0 is the lower border of the picture, 1 the upper one.
    pub upwards: [f64; 2],
    /// Albedo of black and of white, 0 to 1.
    pub ends: [f64; 2],
    /// From a code of the picture to its share of light.
    pub curve: Curve,
}

/// A picture that is no texture.
#[derive(Debug, thiserror::Error)]
pub enum TextureError {
    /// A picture that cannot be read.
    #[error("feature {feature:?}: {source}")]
    File {
        /// Name of the feature.
        feature: String,
        /// What is wrong with the file.
        source: Box<PhotographFileError>,
    },
    /// A picture without an albedo.
    #[error("feature {feature:?}: {source}")]
    Map {
        /// Name of the feature.
        feature: String,
        /// What is wrong with its texels.
        source: AlbedoMapError,
    },
}

/// Albedo of a landscape by its textures. That of a tile comes before that of the whole ground.
///
/// A border belongs to the tile north or east of it, the last border to the last tile.
#[derive(Debug, Clone)]
pub struct Textures {
    all: BTreeMap<Option<[usize; 2]>, Texture>,
    axes: [Axis; 2],
}

#[derive(Debug, Clone)]
struct Texture {
    wish: TextureWish,
    /// The picture over the square from 0 to 1.
    map: AlbedoMap,
}

impl Textures {
    /// Reads the pictures of all enabled textures.
    ///
    /// # Errors
    /// If a picture cannot be read.
    pub fn open(of: &Description) -> Result<Self, TextureError> {
        let mut all = BTreeMap::new();
        for feature in of.features.iter().filter(|feature| feature.is_enabled) {
            let Kind::Texture(wish) = &feature.kind else { continue };
            let id = || feature.id.clone();
            let picture = photographs::read_map(&wish.path, wish.curve)
                .map_err(|source| TextureError::File { feature: id(), source: source.into() })?;
            let texels = Texels::of_picture(&picture, wish.curve, wish.ends);
            let size = [picture.columns(), picture.lines()];
            let map = AlbedoMap::new([0.0, 0.0, 1.0, 1.0], size, texels)
                .map_err(|source| TextureError::Map { feature: id(), source })?;
            all.insert(wish.tile, Texture { wish: wish.clone(), map });
        }
        Ok(Self { all, axes: [of.grid.north, of.grid.east] })
    }

    /// Whether there is none.
    pub fn is_empty(&self) -> bool {
        self.all.is_empty()
    }

    /// Whether one of them has a colour.
    pub fn is_colourful(&self) -> bool {
        self.all.values().any(|texture| texture.map.texels().is_colourful())
    }

    /// Albedo for red, green and blue light at a place: north, east (m). None where no texture lies.
    pub fn at(&self, place: [f64; 2]) -> Option<[f64; 3]> {
        let tile = [0, 1].map(|axis| tile_of(&self.axes[axis], place[axis]));
        let tile = if let [Some(row), Some(column)] = tile { [row, column] } else { return None };
        let texture = self.all.get(&Some(tile)).or_else(|| self.all.get(&None))?;
        let share = |axis: usize| {
            let [low, high] = self.borders(texture, axis);
            (place[axis] - low) / (high - low)
        };
        texture.at([share(0), share(1)])
    }

    /// Size of the smallest texel on the ground (m); none without textures.
    pub fn finest_texel(&self) -> Option<f64> {
        let texel = |texture: &Texture| {
            let [columns, lines] = texture.map.size();
            let side = |axis: usize, texels: usize, [start, end]: [f64; 2]| {
                let [low, high] = self.borders(texture, axis);
                (high - low) / (texels as f64 * (end - start).abs())
            };
            side(0, lines, texture.wish.upwards).min(side(1, columns, texture.wish.across))
        };
        self.all.values().map(texel).reduce(f64::min)
    }

    /// First and last place (m) of what a texture covers along an axis.
    fn borders(&self, texture: &Texture, axis: usize) -> [f64; 2] {
        let along = &self.axes[axis];
        let [first, last] = match texture.wish.tile {
            Some(tile) => [tile[axis], tile[axis] + 1].map(|tile| tile * along.tile_cells()),
            None => [0, along.posts() - 1],
        };
        [first, last].map(|post| along.place(post))
    }
}

impl Texture {
    /// Albedo at a share of the way from its southern to its northern and from its western to its eastern border.
    fn at(&self, share: [f64; 2]) -> Option<[f64; 3]> {
        let along = |[start, end]: [f64; 2], share: f64| repeated(start + share * (end - start));
        self.map.at(along(self.wish.upwards, share[0]), along(self.wish.across, share[1]))
    }
}

/// A place of a picture that repeats: what lies from 0 to 1 stays, both borders with it.
fn repeated(at: f64) -> f64 {
    if (0.0..=1.0).contains(&at) { at } else { at - at.floor() }
}

/// Number of the tile that holds a place (m); none beyond the borders.
fn tile_of(axis: &Axis, place: f64) -> Option<usize> {
    let border = |tile: usize| axis.place(tile * axis.tile_cells());
    let is_in = border(0) <= place && place <= border(axis.tiles());
    let last = axis.tiles() - 1;
    is_in.then(|| {
        let near = ((place - axis.first) / (axis.resolution * axis.tile_cells() as f64)) as usize;
        // By rounding the place may belong to a neighbour.
        let near = near.min(last);
        if near < last && place >= border(near + 1) {
            near + 1
        } else if place < border(near) {
            near - 1
        } else {
            near
        }
    })
}
