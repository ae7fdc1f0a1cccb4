//! Tools of built ground against programs of other people: the light map against Embree, the viewshed against xarray-spatial; and the terrain
//! database against the layout of the document that it comes from.
//!
//! Both look at the same posts. Medians count, of turns that both take; xarray-spatial is called in turns of its own.

mod database;
mod viewshed;

use std::fmt::Write as _;
use std::path::Path;
use std::time::Instant;

use crate::guests::Sense;
use crate::row::Row;
use benchmarks::peers::embree::{EyeMesh, Program, Sight as MeshSight};
use benchmarks::peers::median;
use front_door::{Wishes, open};
use glam::DVec3;
use quantities::{radians, sin_cos};
use rayon::{ThreadPool, ThreadPoolBuilder};
use scenario::FieldOfView;
use sight::{Curvature, Height, Point, Posts, Sight};
use terrain_builder::{Frame, Grid, Heights, LightMap, Method};
use viewshed::{Lookout, viewshed};

/// Scenario whose ground is looked at, and how many posts of it along a side, so many metres apart.
const SCENARIO: &str = "lod-descent";
const POSTS: usize = 1025;
const SPACING: f64 = 30.0;
/// Turns of each side.
const TURNS: usize = 7;
/// Rays to the sun begin so far from their posts (m). Chosen: a post does not shade itself.
const LIFT: f64 = 0.05;

/// All rows as a table in Markdown.
///
/// # Errors
/// If the ground cannot be read, or a peer that is here fails.
pub fn table() -> Result<String, String> {
    let pool = ThreadPoolBuilder::new().num_threads(2).build().map_err(|error| error.to_string())?;
    let heights = pool.install(ground)?;
    let mut text = Row::HEAD.to_owned();
    for rows in [light_maps(&heights, &pool)?, viewsheds(&heights, &pool)?, database::rows(&pool).map(Ok)?] {
        match rows {
            Err(missing) => {
                let _ = writeln!(text, "| 37 | {missing} | | | | | | | |");
            }
            Ok(rows) => text.extend(rows.iter().map(Row::line)),
        }
    }
    Ok(text)
}

/// Heights of the scenario's ground, from the middle of its south-western quarter.
fn ground() -> Result<Heights, String> {
    let folder = Path::new(concat!(env!("CARGO_MANIFEST_DIR"), "/../../../scenarios"));
    let opened = open(&folder.join(SCENARIO).with_extension("toml"), &Wishes::default());
    let stage = opened.map_err(|error| error.to_string())?.stage().map_err(|error| error.to_string())?;
    let span = SPACING * (POSTS - 1) as f64;
    // On a sphere of any radius a range about the equator has the length that it is asked for.
    let radius = terrain_builder::MOON_RADIUS;
    let half = 0.5 * span / radius;
    let frame = Frame::new(radius, [-half, half], [-half, half]).map_err(|error| error.to_string())?;
    let exponent = (POSTS - 1).ilog2();
    let grid = Grid::new(&frame, SPACING, exponent).map_err(|error| error.to_string())?;
    let place = |index: usize| [index / POSTS, index % POSTS].map(|at| 0.25 * span + at as f64 * SPACING);
    let height = |index: usize| {
        let [north, east] = place(index);
        stage.landscape.height(north, east).ok_or_else(|| format!("no ground at {north}, {east}"))
    };
    let values = (0..POSTS * POSTS).map(height).collect::<Result<Vec<_>, _>>()?;
    Ok(Heights::new(grid, values))
}

/// Time of `work` on the threads of `pool` (s), and what it gives.
fn timed<T: Send>(pool: &ThreadPool, work: impl FnOnce() -> T + Send) -> (f64, T) {
    let begin = Instant::now();
    let found = pool.install(work);
    (begin.elapsed().as_secs_f64(), found)
}

/// The light map by the sweep, against one ray a vertex by Embree.
fn light_maps(heights: &Heights, pool: &ThreadPool) -> Result<Result<Vec<Row>, String>, String> {
    let program = match Program::compile()? {
        Ok(program) => program,
        Err(missing) => return Ok(Err(missing)),
    };
    let (sin, cos) = sin_cos(radians(80.0));
    let (up, level) = sin_cos(radians(8.0));
    let sun = DVec3::new(cos * level, sin * level, up);
    let mut embree = program.start(&mesh(heights), &a_pixel_a_post())?;
    let direction = sun.to_array();
    let mut best = (f64::INFINITY, 16);
    for packet in [16, 8, 1] {
        embree.light(packet, direction, LIFT)?;
        best = if let seconds = embree.light(packet, direction, LIFT)?
            && seconds < best.0
        {
            (seconds, packet)
        } else {
            best
        };
    }
    let (mut ours, mut traced, mut divided) = (Vec::new(), Vec::new(), Vec::new());
    let mut map = None;
    for _ in 0..TURNS {
        let (seconds, found) = timed(pool, || LightMap::new(heights, sun, Method::Sweep));
        ours.push(seconds);
        map = Some(found);
        divided.push(embree.divide("low")?);
        traced.push(embree.light(best.1, direction, LIFT)?);
    }
    let map = map.ok_or("no turn was taken")?;
    let [ours, traced, divided] = [ours, traced, divided].map(median);
    // A ray from a post that turns away from the sun begins below the ground.
    let faces_sun = |post: usize| heights.normal(post / POSTS, post % POSTS).dot(sun) > 0.0;
    let is_lit = embree
        .picture()?
        .iter()
        .enumerate()
        .map(|(post, lit)| *lit > 0.5 && faces_sun(post))
        .collect::<Vec<_>>();
    let differ =
        is_lit.iter().zip(map.shares()).filter(|(is_lit, share)| **is_lit != (**share > 0.0)).count();
    let dark = map.shares().iter().filter(|share| **share == 0.0).count();
    let share = |count: usize| 100.0 * count as f64 / map.shares().len() as f64;
    let remark = format!(
        "{:.1} % of the posts without sun, {:.2} % otherwise; packets of {}",
        share(dark),
        share(differ),
        best.1
    );
    let row = |how: &str, other: f64| {
        let quantity =
            format!("fast light map, {POSTS} x {POSTS} posts, against Embree, one ray a post, {how}");
        Row::of_times(37, quantity, (Sense::AsFast, [5.0, 20.0]), [ours, other], remark.clone())
    };
    Ok(Ok(vec![row("space divided for it", traced + divided), row("space divided before", traced)]))
}

/// The ground as Embree takes it: each cell cut from north-west to south-east, as the light map has it.
fn mesh(heights: &Heights) -> EyeMesh {
    let vertex = |index: usize| {
        let (row, column) = (index / POSTS, index % POSTS);
        let place = [row as f64 * SPACING, column as f64 * SPACING, heights.post(row, column)];
        [place.map(|part| part as f32), [0.0, 0.0, 1.0]]
    };
    let face = |index: usize| {
        let south_west = index / (POSTS - 1) * POSTS + index % (POSTS - 1);
        [south_west, south_west + POSTS, south_west + POSTS + 1, south_west + 1].map(|corner| corner as u32)
    };
    EyeMesh {
        vertices: (0..POSTS * POSTS).map(vertex).collect(),
        faces: (0..(POSTS - 1) * (POSTS - 1)).map(face).collect(),
    }
}

/// A picture with a pixel for each post; nobody looks at it from an eye.
fn a_pixel_a_post() -> MeshSight {
    MeshSight {
        size: [POSTS as u32; 2],
        field: FieldOfView { tan_half_width: 1.0, tan_half_height: 1.0 },
        albedo: 1.0,
        ranges: [0.0, f64::from(f32::MAX)],
        axes: [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]],
    }
}

/// What an observer 2 m and 50 m over the middle sees, against xarray-spatial.
fn viewsheds(heights: &Heights, pool: &ThreadPool) -> Result<Result<Vec<Row>, String>, String> {
    // Rows of posts run from the north.
    let southwards: Vec<f64> = heights.values().chunks(POSTS).rev().flatten().copied().collect();
    let middle = [POSTS / 2; 2];
    let mut rows = Vec::new();
    for height in [2.0, 50.0] {
        let lookout = Lookout { post: middle, height, spacing: SPACING, turns: TURNS };
        let seen = match viewshed(&southwards, &lookout)? {
            Ok(seen) => seen,
            Err(missing) => return Ok(Err(missing)),
        };
        let look = || {
            let posts = Posts::new([POSTS; 2], [0.0; 2], SPACING, southwards.clone())?;
            let observer =
                Point { place: posts.place(middle[0], middle[1]), height: Height::AboveGround(height) };
            posts.viewshed(&observer, 0.0, Curvature::FLAT)
        };
        let mut ours = Vec::new();
        let mut found = Vec::new();
        for _ in 0..TURNS {
            let (seconds, sights) = timed(pool, look);
            ours.push(seconds);
            found = sights.map_err(|error| error.to_string())?;
        }
        let differ = found
            .iter()
            .zip(&seen.visible)
            .filter(|(sight, visible)| (**sight == Sight::Visible) != **visible);
        let differ = differ.count();
        let visible = found.iter().filter(|sight| **sight == Sight::Visible).count();
        let share = |count: usize| 100.0 * count as f64 / found.len() as f64;
        let quantity = format!(
            "viewshed of an eye at {height} m, {POSTS} x {POSTS} posts, against xarray-spatial {}",
            seen.version
        );
        let remark =
            format!("{:.1} % of the posts visible, {:.2} % otherwise", share(visible), share(differ));
        rows.push(Row::of_times(
            37,
            quantity,
            (Sense::AsFast, [1.0, 4.0]),
            [median(ours), median(seen.seconds)],
            remark,
        ));
    }
    Ok(Ok(rows))
}
