//! Pictures of LUNSIM against columns of `exact`.

use exact::Columns;
use generator::{Generator, PlaneKind, Planes, Stage};
use scenario::Pose;
use signal::Probe;

/// Planes that are compared.
const KINDS: [PlaneKind; 4] =
    [PlaneKind::Intensity, PlaneKind::Reflectivity, PlaneKind::Shadow, PlaneKind::Range];

/// How far a picture is from `exact`, over the pixels where both show ground.
#[derive(Debug, Clone, Copy)]
pub struct Distance {
    /// Mean of |difference| of reflectivity.
    pub reflectivity: f64,
    /// Mean of |difference| of intensity, codes and shadow included.
    pub intensity: f64,
    /// Share of the pixels whose shadow is another.
    pub shade: f64,
    /// Share of the pixels where one shows ground and the other none.
    pub missing: f64,
}

/// Distance of frame `frame` of `stage` from `exact`, over every `every`-th column.
pub fn distance(program: &dyn Generator, stage: &Stage, frame: u64, pose: &Pose, every: usize) -> Distance {
    let view = &stage.view;
    let mut planes = Planes::new(view.columns as usize, view.lines as usize, &KINDS);
    let session = program.prepare(stage.clone()).unwrap();
    session.frame(frame, pose, &mut planes, &mut Probe::off()).unwrap();
    let exact = Columns::new(stage.clone());
    let mut sums = [0.0; 3];
    let (mut both, mut one) = (0.0, 0.0);
    for column in (every / 2..planes.columns()).step_by(every) {
        let reference = exact.column(frame, pose, column, &KINDS).unwrap();
        for line in 0..planes.lines() {
            let found = |kind| f64::from(planes.get(kind).unwrap()[line * planes.columns() + column]);
            let expected = |kind| f64::from(reference.get(kind).unwrap()[line]);
            match [found(PlaneKind::Range), expected(PlaneKind::Range)].map(f64::is_finite) {
                [true, true] => {}
                [false, false] => continue,
                _ => {
                    one += 1.0;
                    continue;
                }
            }
            both += 1.0;
            sums[0] += (found(PlaneKind::Reflectivity) - expected(PlaneKind::Reflectivity)).abs();
            sums[1] += (found(PlaneKind::Intensity) - expected(PlaneKind::Intensity)).abs();
            sums[2] += f64::from(u8::from(found(PlaneKind::Shadow) != expected(PlaneKind::Shadow)));
        }
    }
    let [reflectivity, intensity, shade] = sums.map(|sum| sum / both);
    Distance { reflectivity, intensity, shade, missing: one / (both + one) }
}
