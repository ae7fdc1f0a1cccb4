//! Tiles of shadow, computed when first asked for and kept.

use std::collections::{BTreeMap, BTreeSet};
use std::path::Path;
use std::sync::{Arc, Mutex, MutexGuard, OnceLock, PoisonError};

use files::FolderError;
use landscape::{Landscape, Sun};
use rayon::prelude::*;

use crate::Tile;
use crate::cache::Cache;
use crate::cover::Cover;
use crate::ground::{GroundSheets, LitGround};
use crate::tile::{Casters, Place};

/// Suns whose tiles are kept in memory.
const SUNS: usize = 3;
/// Tiles of one sun that are kept in memory; when there are more, those of the last question stay.
const TILES: usize = 1 << 14;
/// Smallest distance between profiles (m): less than a grain of sand.
const SMALLEST_SPACING: f64 = 1e-3;

/// How finely shadows are computed.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Resolution {
    /// Smallest distance between profiles (m); less than a millimetre counts as one.
    pub finest: f64,
    /// Distance between profiles for each metre of distance from the eye (rad), 0 or more.
    pub angle: f64,
}

/// Remote shadow of a landscape under any sun, tile by tile as frames come to need it.
///
/// What it answers depends on the question alone, not on what was asked before nor on the number of threads.
#[derive(Debug)]
pub struct ShadowBank {
    ground: GroundSheets,
    resolution: Resolution,
    cache: Option<Cache>,
    failure: Mutex<Option<FolderError>>,
    suns: Mutex<Vec<Shelf>>,
}

/// Tiles of one sun. The sun asked for last stands last.
#[derive(Debug)]
struct Shelf {
    sun: [u64; 2],
    tiles: BTreeMap<Place, Slot>,
}

type Slot = Arc<OnceLock<Arc<Tile>>>;

impl ShadowBank {
    /// Shadows of `landscape`, none computed yet.
    pub fn new(landscape: Arc<Landscape>, resolution: Resolution) -> Self {
        let finest = resolution.finest.max(SMALLEST_SPACING);
        let resolution = Resolution { finest, ..resolution };
        Self {
            ground: GroundSheets::new(landscape),
            resolution,
            cache: None,
            failure: Mutex::default(),
            suns: Mutex::default(),
        }
    }

    /// The same, with tiles kept in `folder` from run to run. They are named by ground, sun and resolution; a file
    /// that is damaged or of something else is passed over and its tiles are computed anew. The folder is made when there is something to
    /// keep, and keeps no more than `most_bytes`: with 0 nothing in it changes.
    pub fn with_cache(self, folder: impl AsRef<Path>, most_bytes: u64) -> Self {
        let finest = self.resolution.finest;
        let cache = Cache::new(folder.as_ref(), &self.ground.landscape, finest, most_bytes);
        Self { cache: Some(cache), ..self }
    }

    pub(crate) fn ground(&self) -> &GroundSheets {
        &self.ground
    }

    /// How finely shadows are computed.
    pub fn resolution(&self) -> Resolution {
        self.resolution
    }

    /// Why the last tiles could not be kept on disk, if so; asking clears it. The tiles themselves are not affected.
    pub fn take_cache_failure(&self) -> Option<FolderError> {
        lock(&self.failure).take()
    }

    /// Shadow under `sun` within `reach` (m) of `eye` (north, east; m): tiles that do not overlap, by distance from the
    /// eye, fine near it and coarse far away. `towards`: unit vectors (north, east) of the left and the right edge of
    /// the view, less than half a turn apart; all around if `None`.
    ///
    /// Nothing for a sun in the zenith, and nothing for a sun, an eye or a reach that is no number. Under a sun below the
    /// horizon all is dark that no ray from below reaches.
    pub fn around(
        &self,
        sun: &Sun,
        eye: [f64; 2],
        reach: f64,
        towards: Option<[[f64; 2]; 2]>,
    ) -> Vec<Arc<Tile>> {
        let lit = LitGround::new(&self.ground, sun, self.resolution.finest);
        let numbers = [sun.azimuth, sun.elevation, eye[0], eye[1], reach];
        if lit.axes.cos <= 0.0 || reach <= 0.0 || !numbers.iter().all(|number| number.is_finite()) {
            return Vec::new();
        }
        let cover = Cover::new(&self.ground.landscape, self.resolution, sun, eye, reach, towards);
        let places = cover.places();
        let slots = self.slots(sun, &places);
        let mut missing: Vec<usize> = (0..slots.len()).filter(|&n| slots[n].get().is_none()).collect();
        let column = |n: usize| (places[n].level, places[n].at[0]);
        missing.sort_unstable_by_key(|&n| (column(n), places[n].at[1]));
        let columns: Vec<&[usize]> = missing.chunk_by(|&a, &b| column(a) == column(b)).collect();
        // A tile waits for nothing while it is computed, so threads that want the same one may wait for it.
        columns.into_par_iter().for_each(|column| {
            let mut casters = Casters::default();
            for &n in column {
                slots[n].get_or_init(|| Arc::new(Tile::compute(lit, places[n], &mut casters)));
            }
        });
        missing.sort_unstable();
        let tiles: Vec<Arc<Tile>> = slots.iter().filter_map(|slot| slot.get().cloned()).collect();
        self.keep(sun, missing.into_iter().map(|n| (places[n], &tiles[n])));
        tiles
    }

    fn keep<'a>(&self, sun: &Sun, tiles: impl Iterator<Item = (Place, &'a Arc<Tile>)>) {
        let tiles: Vec<_> = tiles.collect();
        if let Some(cache) = self.cache.as_ref().filter(|_| !tiles.is_empty())
            && let Err(failure) = cache.write(sun, &tiles)
        {
            *lock(&self.failure) = Some(failure);
        }
    }

    fn slots(&self, sun: &Sun, places: &[Place]) -> Vec<Slot> {
        let mut suns = lock(&self.suns);
        let shelf = self.shelf(&mut suns, sun);
        let slots = places.iter().map(|&place| shelf.tiles.entry(place).or_default().clone()).collect();
        if shelf.tiles.len() > TILES {
            let asked: BTreeSet<&Place> = places.iter().collect();
            shelf.tiles.retain(|place, _| asked.contains(place));
        }
        slots
    }

    fn shelf<'a>(&self, suns: &'a mut Vec<Shelf>, sun: &Sun) -> &'a mut Shelf {
        let key = [sun.azimuth.to_bits(), sun.elevation.to_bits()];
        let known = suns.iter().position(|shelf| shelf.sun == key);
        let shelf = known.map(|index| suns.remove(index)).unwrap_or_else(|| {
            let kept = self.cache.as_ref().map(|cache| cache.read(sun)).unwrap_or_default();
            let slot = |(place, tile)| (place, Arc::new(OnceLock::from(Arc::new(tile))));
            Shelf { sun: key, tiles: kept.into_iter().map(slot).collect() }
        });
        if suns.len() >= SUNS {
            suns.remove(0);
        }
        let last = suns.len();
        suns.push(shelf);
        &mut suns[last]
    }
}

/// What a thread that panicked left behind is whole: every change under these locks is a single step.
fn lock<T>(mutex: &Mutex<T>) -> MutexGuard<'_, T> {
    mutex.lock().unwrap_or_else(PoisonError::into_inner)
}
