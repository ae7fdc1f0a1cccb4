//! Levels of detail against what is lost: triangles, error and time of each rung of a ladder (chapter 7 of a thesis on tests of navigation asks
//! for it).
//!
//! **Law.** The ladders are those that a generator holds against its finest ground alone ([`Row::level_ladders`](generator::Row::level_ladders)).
//! The error of a rung is that of the drawn ground against the finest mesh, post by post ([`GroundLoss`]), in metres and in pixels.
//! **Time** is the median of several turns over all frames, of one thread. The rungs of a ladder take turns, so that a computer that slows
//! down slows all of them. Counts stand beside it, which no computer changes.
//! **Fronts.** A rung is on a front if no other of any ladder has both less error and less time, or fewer triangles. The error is the rms in pixels.

use std::time::Instant;

use generator::{
    DrawnGround, ErrorLadder, Errors, FrameError, GroundLoss, PlaneKind, Planes, Session, Stage,
};
use rayon::ThreadPool;
use scenario::Pose;
use serde::Serialize;
use signal::Probe;

use crate::parameter::Configure;
use crate::work::spread;
use crate::{StudyError, front};

/// What is looked at, and how often it is timed.
pub struct Looks<'a> {
    /// World and view of the frames.
    pub stage: &'a Stage,
    /// Frames with their poses, at least one.
    pub frames: &'a [(u64, Pose)],
    /// Turns that are timed, at least one.
    pub repetitions: u32,
    /// One thread, which draws what is timed.
    pub one: &'a ThreadPool,
}

/// What came of a ladder.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct LevelLadder {
    /// Name of the ladder.
    pub name: &'static str,
    /// What its rungs are, in words.
    pub what: &'static str,
    /// Outcomes of the rungs, in their order.
    pub rungs: Vec<LevelRung>,
}

/// What came of a rung.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct LevelRung {
    /// Name of the rung in its ladder.
    pub label: String,
    /// What was measured; none where the rung was refused.
    #[serde(flatten)]
    pub figures: Option<LevelFigures>,
    /// Reason why the generator refuses the rung.
    pub refused: Option<String>,
    /// Whether no other rung has both less error and less time.
    pub is_on_time_front: bool,
    /// Whether no other rung has both less error and fewer triangles.
    pub is_on_triangle_front: bool,
}

/// What a rung draws, loses and takes. Counts are means of a frame.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct LevelFigures {
    /// Tiles that the camera may show.
    pub tiles: f64,
    /// Vertices of these tiles.
    pub vertices: f64,
    /// Triangles of these tiles.
    pub triangles: f64,
    /// Posts of the finest mesh inside the picture.
    pub posts: f64,
    /// Heights off the finest mesh (m).
    pub metres: Size,
    /// The same across the line of sight (pixels): height x focal length / distance.
    pub pixels: Size,
    /// How far places are moved in the picture (pixels).
    pub moved_px: Size,
    /// Median, smallest and largest time of a frame (s) over the turns.
    pub time_s: [f64; 3],
}

/// Size of errors over all frames.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct Size {
    /// Root mean square over all posts.
    pub rms: f64,
    /// Largest error in size.
    pub worst: f64,
}

/// A rung made ready.
struct Ready {
    session: Box<dyn Session>,
    ground: DrawnGround,
    times: Vec<f64>,
}

/// Climbs a ladder. `hear` is told of each rung whose error is known.
///
/// # Errors
/// If the generator has no levels of detail, or a frame cannot be drawn by a rung that could be made ready.
pub fn level_ladder(
    (ladder, configure): (&ErrorLadder, &Configure<'_>),
    looks: &Looks<'_>,
    hear: &mut dyn FnMut(&str),
) -> Result<LevelLadder, StudyError> {
    let mut rungs = Vec::new();
    for (value, _) in ladder.rungs {
        // Words stand in quotes, as TOML has them.
        let label = value.trim_matches('"').to_owned();
        let sets: Vec<_> = ladder.fixed.iter().copied().chain([(ladder.key, *value)]).collect();
        let session = configure(&sets)
            .and_then(|generator| generator.prepare(looks.stage.clone()).map_err(|error| error.to_string()));
        let ready = match session {
            Ok(session) => Ok(Ready { ground: ground(&*session, looks)?, session, times: Vec::new() }),
            Err(refused) => Err(refused),
        };
        hear(&label);
        rungs.push((label, ready));
    }
    // The first turn is not counted: it warms up.
    for turn in 0..=looks.repetitions {
        for ready in rungs.iter_mut().filter_map(|(_, ready)| ready.as_mut().ok()) {
            let seconds = looks.one.install(|| seconds(&*ready.session, looks))?;
            if turn > 0 {
                ready.times.push(seconds);
            }
        }
    }
    let rungs = rungs.into_iter().map(|(label, ready)| {
        let (figures, refused) = match ready {
            Ok(ready) => (Some(figures(&ready, looks.frames.len())), None),
            Err(refused) => (None, Some(refused)),
        };
        LevelRung { label, figures, refused, is_on_time_front: false, is_on_triangle_front: false }
    });
    Ok(LevelLadder { name: ladder.name, what: ladder.what, rungs: rungs.collect() })
}

/// The ground of all frames as a session draws it.
fn ground(session: &dyn Session, looks: &Looks<'_>) -> Result<DrawnGround, StudyError> {
    let Some(detailed) = session.detailed() else {
        return Err(StudyError::Ladder("the generator has no levels of detail".into()));
    };
    let mut all = DrawnGround::default();
    for (frame, pose) in looks.frames {
        let own = detailed.drawn_ground(*frame, pose)?;
        all.tiles += own.tiles;
        all.vertices += own.vertices;
        all.triangles += own.triangles;
        all.loss.join(&own.loss);
    }
    Ok(all)
}

/// Mean time of a frame (s) in one turn.
fn seconds(session: &dyn Session, looks: &Looks<'_>) -> Result<f64, FrameError> {
    let view = &looks.stage.view;
    let mut planes = Planes::new(view.columns as usize, view.lines as usize, &[PlaneKind::Intensity]);
    let start = Instant::now();
    for (frame, pose) in looks.frames {
        session.frame(*frame, pose, &mut planes, &mut Probe::off())?;
    }
    Ok(start.elapsed().as_secs_f64() / looks.frames.len() as f64)
}

fn figures(ready: &Ready, frames: usize) -> LevelFigures {
    let DrawnGround { tiles, vertices, triangles, loss } = ready.ground;
    let GroundLoss { posts, metres, pixels, moved } = loss;
    let size = |errors: Errors| Size { rms: errors.rms(posts), worst: errors.worst };
    let [tiles, vertices, triangles, mean_posts] =
        [tiles, vertices, triangles, posts].map(|count| count as f64 / frames as f64);
    LevelFigures {
        tiles,
        vertices,
        triangles,
        posts: mean_posts,
        metres: size(metres),
        pixels: size(pixels),
        moved_px: size(moved),
        time_s: spread(&ready.times),
    }
}

/// Marks the rungs of all ladders that are on a front.
pub fn mark_fronts(ladders: &mut [LevelLadder]) {
    let cost_of_time = |figures: &LevelFigures| figures.time_s[0];
    let cost_of_triangles = |figures: &LevelFigures| figures.triangles;
    mark(ladders, cost_of_time, |rung| &mut rung.is_on_time_front);
    mark(ladders, cost_of_triangles, |rung| &mut rung.is_on_triangle_front);
}

fn mark(
    ladders: &mut [LevelLadder],
    cost: impl Fn(&LevelFigures) -> f64,
    is_on_front: impl Fn(&mut LevelRung) -> &mut bool,
) {
    let measured = ladders.iter_mut().flat_map(|ladder| &mut ladder.rungs);
    let mut measured: Vec<(&mut LevelRung, [f64; 2])> = measured
        .filter_map(|rung| {
            let figures = rung.figures?;
            Some((rung, [cost(&figures), figures.pixels.rms]))
        })
        .collect();
    let points: Vec<[f64; 2]> = measured.iter().map(|(_, point)| *point).collect();
    // Rungs of several ladders may draw the same ground: what ties with the front is on it.
    let best: Vec<[f64; 2]> = front(&points).into_iter().map(|index| points[index]).collect();
    for (rung, _) in measured.iter_mut().filter(|(_, point)| best.contains(point)) {
        *is_on_front(rung) = true;
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn rung(label: &str, time: f64, triangles: f64, rms: f64) -> LevelRung {
        let size = Size { rms, worst: 4.0 * rms };
        let figures = LevelFigures {
            tiles: 1.0,
            vertices: triangles,
            triangles,
            posts: 9.0,
            metres: size,
            pixels: size,
            moved_px: size,
            time_s: [time; 3],
        };
        LevelRung {
            label: label.into(),
            figures: Some(figures),
            refused: None,
            is_on_time_front: false,
            is_on_triangle_front: false,
        }
    }

    #[test]
    fn a_front_has_what_no_rung_of_any_ladder_beats() {
        let refused = LevelRung { figures: None, refused: Some("no".into()), ..rung("7", 0.0, 0.0, 0.0) };
        let mut ladders = [
            LevelLadder {
                name: "a",
                what: "a",
                rungs: vec![rung("1", 3.0, 30.0, 0.1), rung("2", 1.0, 20.0, 0.5)],
            },
            LevelLadder {
                name: "b",
                what: "b",
                rungs: vec![rung("1", 2.0, 10.0, 0.5), refused, rung("3", 4.0, 30.0, 0.1)],
            },
        ];
        mark_fronts(&mut ladders);
        let marks = |of: &dyn Fn(&LevelRung) -> bool| -> Vec<Vec<bool>> {
            ladders.iter().map(|ladder| ladder.rungs.iter().map(of).collect()).collect()
        };
        assert_eq!(marks(&|rung| rung.is_on_time_front), [vec![true; 2], vec![false; 3]]);
        // A rung with the triangles and the error of one on the front is on it.
        let on_triangles = marks(&|rung| rung.is_on_triangle_front);
        assert_eq!(on_triangles, [vec![true, false], vec![true, false, true]]);
    }
}
