//! The ground that lines of sight are held against, with its place on the map.

use std::ops::Range;
use std::path::Path;

use landscape::{Bank, LUNOID_RADIUS, Landscape, bank_file};
use sight::{Curvature, LineOfSight, Point, Posts, Raster, Sight, SightError, Terrain};
use survey::{Affine, Frame};

use command_line::Failure;
use front_door::read_scenario;

/// Most cells of a grid that is laid over a landscape. Chosen: half a gigabyte of heights.
const MOST_CELLS: f64 = 67_108_864.0;
/// Cells a region along each axis, where no size of a cell is given. Chosen.
const CELLS_A_REGION: f64 = 4.0;
/// Bytes that a bank begins with.
const BANK: &[u8] = b"LUNOBANK";

/// Ground of one of the surfaces.
pub enum Ground {
    /// Ground of triangles between posts.
    Mesh(Posts),
    /// Ground in closed form.
    Landscape(Box<Terrain>),
}

/// A ground with its place on a map.
pub struct Site {
    /// The ground that hides.
    pub ground: Ground,
    /// The places over which an area is looked at.
    pub targets: Raster,
    /// First row and column of the targets among the posts of a mesh.
    first: [usize; 2],
    /// Origin of the axes in the map (m).
    pub origin: [f64; 2],
    /// What the map is.
    pub frame: Frame,
    /// What the ground is, for people.
    pub title: String,
}

/// What a file on the command line is.
pub enum Source {
    /// A scenario or a bank.
    Landscape(Box<Landscape>, String),
    /// What an elevation file says.
    Elevation,
}

impl Source {
    /// Reads a scenario (`.toml`) or a bank; anything else is an elevation file.
    pub fn of(path: &Path) -> Result<Self, Failure> {
        if path.extension().is_some_and(|ending| ending == "toml") {
            let scenario = read_scenario(path)?;
            let landscape = front_door::landscape(front_door::bank(&scenario)?, &scenario)?;
            return Ok(Self::Landscape(Box::new(landscape), scenario.title));
        }
        if is_bank(path) {
            let bank: Bank = bank_file::read(path)?;
            let title = bank.title().to_owned();
            return Ok(Self::Landscape(Box::new(Landscape::new(bank, 0.0)), title));
        }
        Ok(Self::Elevation)
    }
}

fn is_bank(path: &Path) -> bool {
    use std::io::Read;
    let mut start = Vec::new();
    let read = files::open(path).map(|file| file.take(BANK.len() as u64).read_to_end(&mut start));
    read.is_ok() && start == BANK
}

impl Site {
    /// A landscape in closed form, or as a mesh of posts `cell` (m) apart.
    pub fn of_landscape(
        landscape: Landscape,
        title: String,
        area: Option<[f64; 4]>,
        cell: Option<f64>,
        level: Option<u32>,
    ) -> Result<Self, Failure> {
        let finest = landscape.level();
        let spacing = cell.unwrap_or(finest.region_size() / CELLS_A_REGION);
        let whole = finest.extent();
        let (origin, frame, title) = Self::map_of(&landscape, title);
        let Some(level) = level else {
            let targets = raster(area.unwrap_or(whole), spacing)?;
            let ground = Ground::Landscape(Box::new(Terrain::new(landscape)));
            return Ok(Self { ground, targets, first: [0; 2], origin, frame, title });
        };
        let posts = raster(whole, spacing)?;
        let at = |at: usize| {
            let [north, east] = posts.place(at / posts.size[1], at % posts.size[1]);
            landscape.height(north, east).unwrap_or(f64::NAN)
        };
        let heights = (0..posts.size[0] * posts.size[1]).map(at).collect();
        let posts = Posts::new(posts.size, posts.corner, posts.spacing, heights).map_err(Failure::usage)?;
        Self::of_posts(posts, level, area, (origin, frame, title))
    }

    /// Origin of a landscape's axes in its map (m), the map, and its title.
    pub fn map_of(landscape: &Landscape, title: String) -> ([f64; 2], Frame, String) {
        let map = landscape.bank().map().copied();
        let frame = Frame::Plane(map.and_then(|map| map.projection));
        (map.map_or([0.0; 2], |map| map.origin), frame, title)
    }

    /// A level of a mesh.
    pub fn of_posts(
        posts: Posts,
        level: u32,
        area: Option<[f64; 4]>,
        (origin, frame, title): ([f64; 2], Frame, String),
    ) -> Result<Self, Failure> {
        let posts = if level == 0 { posts } else { posts.level(level).map_err(surface_refused)? };
        let whole = Raster { size: posts.size(), corner: posts.corner(), spacing: posts.spacing() };
        let [rows, columns] = match area {
            Some(area) => within(&whole, area)?,
            None => whole.size.map(|count| 0..count),
        };
        let corner = whole.place(rows.start, columns.start);
        let targets = Raster { size: [rows.len(), columns.len()], corner, ..whole };
        let first = [rows.start, columns.start];
        Ok(Self { ground: Ground::Mesh(posts), targets, first, origin, frame, title })
    }

    /// Radius (m) of the body that its map names, else of the Moon.
    pub fn radius(&self) -> f64 {
        self.frame.sphere().unwrap_or(LUNOID_RADIUS)
    }

    /// Place of the targets in the map.
    pub fn affine(&self) -> Affine {
        let first = [0, 1].map(|axis| self.targets.corner[axis] + self.origin[axis]);
        Affine { first, step: [-self.targets.spacing, self.targets.spacing] }
    }

    /// Height (m) of the ground at a place.
    pub fn height(&self, place: [f64; 2]) -> Option<f64> {
        match &self.ground {
            Ground::Mesh(posts) => posts.height(place),
            Ground::Landscape(terrain) => terrain.height(place),
        }
    }

    /// What lies between an observer and each target.
    pub fn along(
        &self,
        observer: &Point,
        targets: &[Point],
        curvature: Curvature,
    ) -> Result<Vec<LineOfSight>, SightError> {
        match &self.ground {
            Ground::Mesh(posts) => posts.along(observer, targets, curvature),
            Ground::Landscape(terrain) => terrain.along(observer, targets, curvature),
        }
    }

    /// Whether a target of a height (m) is seen at each place of the area.
    pub fn viewshed(
        &self,
        observer: &Point,
        height: f64,
        curvature: Curvature,
        done: &(impl Fn() + Sync),
    ) -> Result<Vec<Sight>, SightError> {
        match &self.ground {
            Ground::Mesh(posts) => posts.viewshed_within(observer, self.window(), height, curvature, done),
            Ground::Landscape(terrain) => terrain.viewshed(observer, &self.targets, height, curvature, done),
        }
    }

    /// Least height (m) at which a target is seen at each place of the area.
    pub fn least_heights(
        &self,
        observer: &Point,
        curvature: Curvature,
        done: &(impl Fn() + Sync),
    ) -> Result<Vec<f64>, SightError> {
        match &self.ground {
            Ground::Mesh(posts) => posts.least_heights_within(observer, self.window(), curvature, done),
            Ground::Landscape(terrain) => terrain.least_heights(observer, &self.targets, curvature, done),
        }
    }

    fn window(&self) -> [Range<usize>; 2] {
        [0, 1].map(|axis| self.first[axis]..self.first[axis] + self.targets.size[axis])
    }
}

fn surface_refused(error: SightError) -> Failure {
    Failure::usage(format!("--surface: {error}; name a lower level"))
}

/// A grid over an area (south, west, north, east) from its north-western corner.
fn raster([south, west, north, east]: [f64; 4], spacing: f64) -> Result<Raster, Failure> {
    let counts = [north - south, east - west].map(|side| (side / spacing + 1e-9).floor() + 1.0);
    let [rows, columns] = counts;
    if rows < 2.0 || columns < 2.0 || rows * columns > MOST_CELLS {
        return Err(Failure::usage(format!(
            "--cell-m {spacing}: {rows} x {columns} cells; expected 2 or more along each axis and {MOST_CELLS} in all; give \
             another size of a cell or another --area"
        )));
    }
    Ok(Raster { size: [rows as usize, columns as usize], corner: [north, west], spacing })
}

/// Rows and columns of a grid that lie in an area.
fn within(grid: &Raster, [south, west, north, east]: [f64; 4]) -> Result<[Range<usize>; 2], Failure> {
    let span = |low: f64, high: f64, count: usize| {
        let first = (low / grid.spacing - 1e-9).ceil().max(0.0);
        let end = ((high / grid.spacing + 1e-9).floor() + 1.0).clamp(0.0, count as f64);
        (first < end).then_some(first as usize..end as usize)
    };
    let rows = span(grid.corner[0] - north, grid.corner[0] - south, grid.size[0]);
    let columns = span(west - grid.corner[1], east - grid.corner[1], grid.size[1]);
    rows.zip(columns).map(|(rows, columns)| [rows, columns]).ok_or_else(|| {
        let far = grid.place(grid.size[0] - 1, grid.size[1] - 1);
        Failure::usage(format!(
            "--area {south},{west},{north},{east}: no post of the ground lies there; expected a part of {},{},{},{}",
            far[0], grid.corner[1], grid.corner[0], far[1]
        ))
    })
}
