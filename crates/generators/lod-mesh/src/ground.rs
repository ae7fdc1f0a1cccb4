//! The ground of a frame: tiles in view, at their levels, morphed.

use std::ops::Range;

use glam::DVec3;
use landscape::shade;
use lod_tiles::{Origin, State, Surface, Tile, TileMesh, TileState};
use rayon::prelude::*;
use scene_sampler::{Camera, Corner, Ground};

use crate::frustum::Frustum;
use crate::live;
use crate::parameters::{GroundLight, Show, Transition};
use crate::prepared::Prepared;
use crate::slots::on_board;
use crate::wires::FILL;

/// Tiles that are made before they are put into the mesh. Chosen: enough for all threads, and little memory.
const CHUNK: usize = 256;

/// The tiles of a frame as a mesh, in the axes of the map.
#[derive(Debug, Default)]
pub struct Mesh {
    /// Vertices: north, east, up (m).
    pub vertices: Vec<DVec3>,
    /// The same in camera axes (m), lowered by the drop of the lunoid.
    pub places: Vec<DVec3>,
    /// How many vertices have moved on their way to the next level, those of finer neighbours with them.
    pub morphing: u64,
    /// Numbers of the corners of each triangle, counter-clockwise seen from above.
    pub triangles: Vec<[u32; 3]>,
    /// Tiles of the mesh with the number of their first vertex, in the order of the terrain. Vertices of a tile come row by row, then those of
    /// finer neighbours on its edges.
    tiles: Vec<(Tile, u32)>,
}

/// State of the tiles for an eye.
pub fn state(prepared: &Prepared, eye: DVec3) -> State {
    at_change(prepared, eye, [eye; 2])
}

/// The same at the moment when levels change between those for two other eyes; they are the first one's.
pub fn at_change(prepared: &Prepared, eye: DVec3, levels: [DVec3; 2]) -> State {
    let in_tiles = |eye: DVec3| [eye.y, eye.x, eye.z];
    let (terrain, levels) = (&prepared.posts.terrain, levels.map(in_tiles));
    let state = State::at_change(terrain, &prepared.table.levels, in_tiles(eye), levels);
    let state = match prepared.run.transition {
        Transition::Morph => state,
        Transition::Switch => state.switched(),
    };
    on_board(terrain, state, &prepared.run, prepared.slots)
}

/// The surface of a state.
pub fn surface<'a>(prepared: &'a Prepared, state: &'a State) -> Surface<'a> {
    let run = &prepared.run;
    Surface {
        terrain: &prepared.posts.terrain,
        state,
        levels: prepared.table.levels.count(),
        edges: run.edges,
        stitch: run.stitch,
    }
}

/// Height (m) of the finest triangles under a place (east, north; m).
pub fn finest(prepared: &Prepared, place: [f64; 2]) -> f64 {
    surface(prepared, &prepared.finest).under(place)
}

/// The same; `None` beside the ground.
pub fn finest_at(prepared: &Prepared, place: [f64; 2]) -> Option<f64> {
    let [low, high] = prepared.posts.terrain.extent();
    let is_over = (0..2).all(|axis| (low[axis]..=high[axis]).contains(&place[axis]));
    is_over.then(|| finest(prepared, place))
}

/// The tiles that a camera may show.
pub fn in_view(prepared: &Prepared, camera: &Camera) -> Vec<Tile> {
    let frustum = Frustum::new(camera);
    let terrain = &prepared.posts.terrain;
    let may_show = |(tile, heights): &(Tile, _)| {
        let cells = terrain.cells(0);
        let corner = |at: usize| {
            let [east, north] = terrain.place(*tile, 0, [at, at]);
            [north, east]
        };
        frustum.may_show([corner(0), corner(cells)], heights)
    };
    let tiles = terrain.tiles().zip(prepared.posts.heights.iter().cloned());
    tiles.filter(may_show).map(|(tile, _)| tile).collect()
}

/// Tiles of a surface, seen by a camera.
pub fn mesh(surface: &Surface<'_>, tiles: &[Tile], camera: &Camera) -> Mesh {
    let mut mesh = Mesh::default();
    for tiles in tiles.chunks(CHUNK) {
        let part = |tile: &Tile| Mesh::of_tile(surface, *tile, camera);
        let parts: Vec<Mesh> = tiles.par_iter().map(part).collect();
        parts.into_iter().for_each(|part| mesh.append(part));
    }
    mesh
}

impl Mesh {
    /// A tile of a surface, seen by a camera.
    pub fn of_tile(surface: &Surface<'_>, tile: Tile, camera: &Camera) -> Self {
        let TileMesh { vertices, origins, triangles } = surface.mesh(tile);
        let vertices: Vec<DVec3> =
            vertices.into_iter().map(|[east, north, up]| DVec3::new(north, east, up)).collect();
        let drops: Vec<f64> = vertices.iter().map(|vertex| camera.drop_at(*vertex)).collect();
        // The drop of the lunoid morphs as heights do; otherwise a tile that is wholly the next level would bulge out of it.
        let morphed = |(own, Origin { between, share }): (&f64, &Origin)| {
            let [a, b] = between.map(|parent| drops[parent as usize]);
            own * (1.0 - share) + share * ((a + b) / 2.0)
        };
        let seen = |(vertex, drop): (&DVec3, f64)| camera.direction(*vertex - DVec3::Z * drop - camera.eye);
        let places = vertices.iter().zip(drops.iter().zip(&origins).map(morphed)).map(seen).collect();
        let morphing = origins.iter().filter(|origin| origin.share > 0.0).count() as u64;
        Self { vertices, places, morphing, triangles, tiles: vec![(tile, 0)] }
    }

    /// How many tiles it has.
    pub fn tile_count(&self) -> u64 {
        self.tiles.len() as u64
    }

    /// Numbers of the corners of the triangles of each tile, tile after tile.
    pub fn triangles_of_tiles(&self) -> impl Iterator<Item = (&[[u32; 3]], Tile)> {
        let mut begin = 0;
        self.tiles().map(move |(tile, vertices)| {
            let rest = &self.triangles[begin..];
            // Triangles come in the order of their tiles, and no tile has vertices of another.
            let many = rest.partition_point(|[corner, ..]| (*corner as usize) < vertices.end);
            begin += many;
            (&rest[..many], tile)
        })
    }

    /// Its tiles with the numbers of their vertices.
    pub fn tiles(&self) -> impl Iterator<Item = (Tile, Range<usize>)> {
        let next = self.tiles.iter().skip(1).map(|(_, first)| *first as usize);
        let ends = next.chain([self.vertices.len()]);
        self.tiles.iter().zip(ends).map(|((tile, first), end)| (*tile, *first as usize..end))
    }

    fn append(&mut self, part: Self) {
        let first = self.vertices.len() as u32;
        self.vertices.extend(part.vertices);
        self.places.extend(part.places);
        self.morphing += part.morphing;
        self.triangles.extend(part.triangles.into_iter().map(|corners| corners.map(|corner| corner + first)));
        self.tiles.extend(part.tiles.into_iter().map(|(tile, own)| (tile, own + first)));
    }
}

/// A mesh as faces with their light at `time` (s).
pub fn faces<'a>(
    prepared: &Prepared,
    surface: &Surface<'_>,
    mesh: &'a Mesh,
    camera: &Camera,
    time: f64,
) -> Ground<'a> {
    let stage = &prepared.stage;
    let sun = stage.scenery.sun(time).direction();
    let triangles = &mesh.triangles;
    let fill = if prepared.run.show == Show::Wires { FILL } else { 0.0 };
    let corner = |place: &DVec3| Corner { place: *place, colour: [fill; 3] };
    if prepared.run.show == Show::Wires {
        return Ground { corners: mesh.places.iter().map(corner).collect(), triangles, map: None };
    }
    let map = match prepared.run.light {
        GroundLight::Map => prepared.map(sun),
        GroundLight::Stored => prepared.stored.clone(),
        GroundLight::Live => None,
    };
    let mut corners: Vec<Corner> = mesh.places.iter().map(corner).collect();
    match &map {
        Some(_) if prepared.run.show == Show::Light => return Ground { corners, triangles, map },
        Some(map) => {
            let colour = |vertex: &DVec3| map.at(*vertex, camera.eye);
            corners
                .par_iter_mut()
                .zip(&mesh.vertices)
                .for_each(|(corner, vertex)| corner.colour = colour(vertex));
        }
        None => {
            let slopes = live::slopes(surface, mesh);
            let lit = mesh.vertices.par_iter().zip(&slopes);
            corners.par_iter_mut().zip(lit).for_each(|(corner, (vertex, slopes))| {
                let to_eye = (camera.eye - *vertex).normalize_or_zero().to_array();
                let light = shade(sun, *slopes, to_eye, *stage.landscape.photometry());
                corner.colour = stage
                    .landscape
                    .albedo_at(vertex.x, vertex.y)
                    .map(|albedo| (albedo * light).clamp(0.0, 1.0));
            });
        }
    }
    if prepared.run.show == Show::Levels {
        tint(surface, mesh, &mut corners);
    }
    Ground { corners, triangles, map: None }
}

/// Colours of the levels, the finest first; they repeat. Chosen: neighbours differ in hue and in lightness.
const COLOURS: [[f64; 3]; 6] = [
    [0.90, 0.25, 0.20],
    [0.95, 0.75, 0.20],
    [0.30, 0.75, 0.30],
    [0.25, 0.75, 0.90],
    [0.30, 0.35, 0.95],
    [0.80, 0.35, 0.85],
];

/// Colour of a level, as far on the way to the next level's as a tile has morphed.
pub fn level_colour(TileState { level, fraction }: TileState) -> [f64; 3] {
    let [own, next] = [level, level + 1].map(|level| COLOURS[level % COLOURS.len()]);
    [0, 1, 2].map(|k| (1.0 - fraction) * own[k] + fraction * next[k])
}

/// Gives every corner the colour of its tile's level, under its light.
fn tint(surface: &Surface<'_>, mesh: &Mesh, corners: &mut [Corner]) {
    for (tile, vertices) in mesh.tiles() {
        let colour = level_colour(surface.tile_state(tile));
        for corner in &mut corners[vertices] {
            let light = corner.colour.into_iter().fold(0.0, f64::max);
            corner.colour = colour.map(|channel| light * channel);
        }
    }
}
