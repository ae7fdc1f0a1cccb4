//! The faces of a frame for a judge that draws them by area.

use faces::Order;
use generator::{FaceScene, Look, ScreenFace};

use crate::parameters::Parameters;
use crate::piece::{Piece, Spot};
use crate::scan_line::COINCIDE;
use crate::scene::Scene;

/// The pieces of a scene, with those that had no edge slot. `None` where lists hide what is nearer, or a level is laid upon what is
/// behind it: no face does that.
pub fn faces(scene: Scene, run: &Parameters) -> Option<FaceScene> {
    if run.order == Order::Lists || scene.lists.iter().any(|list| list.level.is_some()) {
        return None;
    }
    let mut pieces = scene.pieces;
    pieces.extend(scene.lost);
    pieces.sort_by_key(|piece| (piece.list, piece.face));
    let faces = (0..).zip(&pieces).map(|(id, piece)| ScreenFace {
        corners: piece.spots.iter().map(|spot| spot.at).collect(),
        q: nearness(&piece.spots),
        priority: 0,
        id,
    });
    let (faces, run) = (faces.collect(), *run);
    let looks = Box::new(move |face: usize, at| look(&pieces[face], &run, at));
    Some(FaceScene { faces, looks, coincidence: COINCIDE })
}

/// Light of a piece at a place on the screen (pixels), as its scan line there has it.
fn look(piece: &Piece, run: &Parameters, at: [f64; 2]) -> Look {
    let across = run.across();
    let brightness = match piece.ramp(across, at[across], run.interpolation) {
        Some(ramp) => ramp.course(run.interpolation).at(at[1 - across])[1],
        None => nearest(&piece.spots, at),
    };
    let light = faces::lit(piece.colour, run.ambient, brightness).map(|channel| channel.clamp(0.0, 1.0));
    Look { light, translucency: [0.0; 3] }
}

/// Brightness of the corner that is nearest to a place: a scan line through the last corner no longer meets the piece.
fn nearest(spots: &[Spot], [x, y]: [f64; 2]) -> f64 {
    let distance = |spot: &&Spot| {
        let [right, down] = [spot.at[0] - x, spot.at[1] - y];
        right * right + down * down
    };
    let nearest = spots.iter().min_by(|a, b| distance(a).total_cmp(&distance(b)));
    nearest.map_or(0.0, |spot| spot.brightness)
}

/// How near a plane piece is (1/m) as `q[0] x + q[1] y + q[2]`, from the largest triangle of its first corner.
fn nearness(spots: &[Spot]) -> [f64; 3] {
    let first = &spots[0];
    let from_first = |spot: &Spot| [spot.at[0] - first.at[0], spot.at[1] - first.at[1], spot.q - first.q];
    let fan = spots[1..].windows(2).map(|pair| {
        let [a, b] = [from_first(&pair[0]), from_first(&pair[1])];
        (a[0] * b[1] - b[0] * a[1], a, b)
    });
    let largest = fan.max_by(|a, b| a.0.abs().total_cmp(&b.0.abs()));
    let slopes = match largest {
        Some((area, a, b)) if area != 0.0 => {
            [(a[2] * b[1] - b[2] * a[1]) / area, (a[0] * b[2] - b[0] * a[2]) / area]
        }
        _ => [0.0; 2],
    };
    [slopes[0], slopes[1], first.q - slopes[0] * first.at[0] - slopes[1] * first.at[1]]
}
