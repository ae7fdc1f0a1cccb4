//! The ground point of every pixel.

use exact::{Ceilings, Outlook, Sight, View};
use generator::{Label, PlaneKind, Planes};
use glam::DVec3;
use landscape::Landscape;
use rayon::prelude::{IntoParallelIterator, ParallelIterator};
use scenario::{Curvature, Projection};

use crate::Stand;

/// East, north, up (m) of the ground that each pixel shows, line by line; none where it shows something else.
pub fn truth(landscape: &Landscape, stand: &Stand, planes: &Planes) -> Vec<Option<DVec3>> {
    let [columns, lines] = [planes.columns(), planes.lines()];
    let ceilings = Ceilings::new(landscape);
    let eye = stand.pose.eye;
    let outlook = Outlook::new(landscape, &ceilings, eye, Curvature::None, [0.0, f64::INFINITY], None);
    let view = View::new(Projection::Exact, &stand.pose.attitude).with_yoke(stand.pose.yoke);
    let labels = planes.get(PlaneKind::Label).unwrap_or(&[]);
    let point = |line: usize, column: usize| {
        if !labels.get(line * columns + column).is_some_and(|label| is_ground(*label)) {
            return None;
        }
        let place = |half: f64, at: usize, count: usize| half * ((2 * at + 1) as f64 / count as f64 - 1.0);
        let x = place(stand.field.tan_half_width, column, columns);
        let y = place(stand.field.tan_half_height, line, lines);
        match outlook.look(&view.ray(x, y)) {
            Sight::Ground(spot) => Some(DVec3::new(spot.place[1], spot.place[0], outlook.height(&spot))),
            _ => None,
        }
    };
    let lines = (0..lines).into_par_iter();
    lines
        .flat_map_iter(|line| (0..columns).map(move |column| (line, column)))
        .map(|(line, column)| point(line, column))
        .collect()
}

/// Whether a code of the plane of labels stands for ground.
fn is_ground(label: f32) -> bool {
    let label = Label::of_code(label as u8);
    matches!(label, Some(Label::Terrain | Label::Feature | Label::Track))
}
