//! Albedo of the ground out of photographs.

use glam::DVec3;
use landscape::{AlbedoMap, AlbedoMapError, Texels};
use photo_camera::voids::{Border, Fill, Wishes, fill};
use rayon::prelude::*;

use crate::{Drape, DrapeError, Footprint, Ground};

/// Least cosine between normal and sun by which light is divided. Chosen by the specification: darker ground has no albedo worth its noise.
pub const LEAST_COSINE: f64 = 0.1;

/// Albedo of each post, row by row from the south.
#[derive(Debug, Clone, PartialEq)]
pub struct Albedo {
    /// Albedo, 0 or more; NaN where no photograph sees the post and the posts around do not enclose it.
    pub values: Vec<f64>,
    /// Posts in shadow in the photograph, or beside it: their albedo is that of the posts around.
    pub shadowed: usize,
    /// Posts that no photograph sees, and whose albedo is that of the posts around.
    pub inferred: usize,
    /// Number of posts without albedo.
    pub missing: usize,
}

impl Drape {
    /// Albedo of all posts: light over the cosine of the photograph's sun. Posts in its shadow or beside it, and unseen ones that others enclose, are
    /// filled harmonically. Under the law of Lambert this is the albedo of the ground.
    ///
    /// # Errors
    /// If a photograph does not say where its sun was.
    pub fn albedo(&self) -> Result<Albedo, DrapeError> {
        let ground = self.ground();
        let suns: Vec<DVec3> =
            (0..self.photographs().len()).map(|number| self.sun_of(number)).collect::<Result<_, _>>()?;
        let shadowed: Vec<Vec<bool>> = suns.iter().map(|sun| ground.shadowed(*sun)).collect();
        let columns = ground.size()[1];
        let of_post = |post: usize| {
            let place = ground.post([post / columns, post % columns]);
            let normal = ground.normal([place.x, place.y]);
            let Some(shown) = self.at(place, &Footprint::square(normal, ground.spacing())) else {
                return (Of::Nothing, 0);
            };
            let cosine = normal.dot(suns[shown.photograph]);
            match cosine <= 0.0 || shadowed[shown.photograph][post] {
                true => (Of::Shadow, 0),
                false => (Of::Light(shown.light / cosine.max(LEAST_COSINE)), reach(shown.weight, ground)),
            }
        };
        let found: Vec<(Of, usize)> = (0..ground.heights().len()).into_par_iter().map(of_post).collect();
        filled(&away_from_shadow(&found, ground), ground)
    }
}

/// Pixels of a photograph beside a shadow that have a part of it: linear look-ups reach one pixel, and shadows are known to half a one. Chosen.
const BESIDE_PIXELS: f64 = 1.5;

/// Most posts beside a shadow that have no albedo of their own. Chosen: it bounds the work where pixels are large.
const MOST_BESIDE: f64 = 8.0;

/// How many posts around one reach into the same pixels of a photograph with so many pixels on a square metre.
fn reach(weight: f64, ground: &Ground) -> usize {
    (BESIDE_PIXELS / (weight.sqrt() * ground.spacing())).ceil().min(MOST_BESIDE) as usize
}

/// The posts, but those beside a shadow are in shadow too: their pixels have a part of it.
fn away_from_shadow(found: &[(Of, usize)], ground: &Ground) -> Vec<Of> {
    let [rows, columns] = ground.size();
    let is_beside = |post: usize, reach: usize| {
        let (row, column) = (post / columns, post % columns);
        let around = |at: usize, count: usize| at.saturating_sub(reach)..(at + reach + 1).min(count);
        around(row, rows).any(|row| {
            around(column, columns).any(|column| matches!(found[row * columns + column].0, Of::Shadow))
        })
    };
    let of_post = |post: usize| match found[post] {
        (Of::Light(_), reach) if is_beside(post, reach) => Of::Shadow,
        (of, _) => of,
    };
    (0..found.len()).into_par_iter().map(of_post).collect()
}

impl Drape {
    /// Light of all posts, each in a square of a cell. Unseen posts that others enclose are filled harmonically; others are NaN.
    ///
    /// # Errors
    /// If they cannot be filled.
    pub fn lights(&self) -> Result<Vec<f64>, DrapeError> {
        let ground = self.ground();
        let columns = ground.size()[1];
        let of_post = |post: usize| {
            let place = ground.post([post / columns, post % columns]);
            let footprint = Footprint::square(ground.normal([place.x, place.y]), ground.spacing());
            self.at(place, &footprint).map_or(Of::Nothing, |shown| Of::Light(shown.light))
        };
        let found: Vec<Of> = (0..ground.heights().len()).into_par_iter().map(of_post).collect();
        Ok(filled(&found, ground)?.values)
    }
}

impl Albedo {
    /// The albedo of the posts of `ground` as a map: texels whose centres are the posts. Albedo above 1 is 1; where there is none it is `beside`, 0..=1.
    ///
    /// # Errors
    /// If the posts are not those of the albedo, or `beside` is out of its range.
    pub fn map(&self, ground: &Ground, beside: f64) -> Result<AlbedoMap, AlbedoMapError> {
        let texel = |value: &f64| if value.is_nan() { beside as f32 } else { value.clamp(0.0, 1.0) as f32 };
        let [rows, columns] = ground.size();
        let texels = self.values.chunks(columns).rev().flatten().map(texel).collect();
        let half = ground.spacing() / 2.0;
        let [south, west, _] = (ground.post([0, 0]) - half).to_array();
        let [north, east, _] = (ground.post([rows - 1, columns - 1]) + half).to_array();
        AlbedoMap::new([south, west, north, east], [columns, rows], Texels::Grey(texels))
    }
}

/// What a post is known by.
#[derive(Debug, Clone, Copy)]
enum Of {
    Light(f64),
    Shadow,
    Nothing,
}

/// Posts without light filled from those around.
fn filled(found: &[Of], ground: &Ground) -> Result<Albedo, DrapeError> {
    let known: Vec<f64> =
        found.iter().map(|of| if let Of::Light(light) = of { *light } else { f64::NAN }).collect();
    let wishes = Wishes { fill: Fill::Harmonic, border: Border::StaysVoid, allow_large_holes: true };
    let values = fill(ground.size(), &known, wishes)?.heights;
    let count = |is: &dyn Fn(&Of) -> bool| {
        found.iter().zip(&values).filter(|(of, value)| is(of) && !value.is_nan()).count()
    };
    let shadowed = count(&|of| matches!(of, Of::Shadow));
    let inferred = count(&|of| matches!(of, Of::Nothing));
    let missing = values.iter().filter(|value| value.is_nan()).count();
    Ok(Albedo { values, shadowed, inferred, missing })
}
