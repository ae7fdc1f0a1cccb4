//! Where a pixel lies among the sweeps of each frame, as numbers for a page.

use hardware_model::SweepMemoryKind;
use machine::MachineStage;
use quantities::sin_cos;
use report::{Sight, SightLine};
use scenario::{FieldOfView, PoseRow, Projection};
use sweep_memory::covering;
use sweep_program::Fan;

/// Of the frames of `rows`, which follow one another.
pub fn sight(stage: &MachineStage, rows: &[PoseRow]) -> Option<Sight> {
    let settings = &stage.settings;
    let (raster, projection) = (&settings.raster, settings.laws.projection);
    let field = raster.field;
    let written = settings.yoke.map_or(field, |yoke| covering(field, yoke.travel));
    let line = |row: &PoseRow| line(row, projection, &written, raster.sweeps, settings.yoke.is_some());
    Some(Sight {
        tube: settings.sweep_memory == SweepMemoryKind::ScanConverter,
        sweeps: raster.sweeps,
        field: [field.tan_half_width, field.tan_half_height],
        raster: written.tan_half_width,
        first: rows.first()?.frame,
        frames: rows.iter().map(line).collect::<Option<_>>()?,
    })
}

fn line(
    row: &PoseRow,
    projection: Projection,
    written: &FieldOfView,
    sweeps: u32,
    turns: bool,
) -> Option<SightLine> {
    let pitch = row.pose.attitude.pitch;
    let fan = Fan::covering(projection, pitch, written, sweeps)?;
    let (sin, cos) = match projection {
        Projection::Exact => sin_cos(pitch),
        Projection::AsReported | Projection::Corrected => (0.0, 1.0),
    };
    Some(SightLine { edge: fan.edge, pitch: [sin, cos], yoke: if turns { row.pose.yoke } else { 0.0 } })
}

#[cfg(test)]
mod tests {
    use std::path::Path;

    use front_door::Wishes;
    use machine::ControlPlane;
    use scenario::PoseTable;

    use super::sight;

    /// Pitch, roll and yoke: what the page works out is where the machine wrote.
    #[test]
    fn a_page_finds_the_sweeps_that_the_machine_wrote() {
        let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../..");
        let pool = rayon::ThreadPoolBuilder::new().num_threads(1).build().unwrap();
        for (scenario, options) in [
            ("rough-ride", &[][..]),
            ("rough-ride", &[("dpp.projection", "as-reported")]),
            ("first-light", &[("sweep_memory.kind", "\"digital-memory\"")]),
        ] {
            let set = options.iter().map(|(key, value)| ((*key).into(), (*value).into())).collect();
            let wishes = Wishes { sweeps: Some(90), set, ..Wishes::default() };
            let file = root.join(format!("scenarios/{scenario}.toml"));
            let opened = front_door::open(&file, &wishes).unwrap_or_else(|error| panic!("{error}"));
            let stage = pool.install(|| opened.machine_stage()).unwrap();
            let (update, yoke) = (stage.settings.timebase.update, stage.settings.yoke);
            let table = PoseTable::resolve(&opened.scenario, &stage.landscape, update, yoke, 20..23).unwrap();
            let sight = sight(&stage, table.rows()).unwrap();
            let control = ControlPlane::new(stage.clone());
            let raster = stage.settings.raster;
            for row in table.rows() {
                let sweeps = control.sweeps(row.frame, &row.pose).unwrap();
                for pixel in [[0, 0], [45, 20], [89, 1], [10, 40], [70, 33]] {
                    let middle = |index: usize, count: u32| (2 * index + 1) as f64 / f64::from(count) - 1.0;
                    let place = [middle(pixel[0], raster.columns), middle(pixel[1], raster.lines)];
                    let (found, expected) =
                        (sight.sweep_at(row.frame, place).unwrap(), sweeps.place_of(&row.pose, pixel)[0]);
                    assert!((found - expected).abs() < 1e-9, "{scenario} {pixel:?}: {found} {expected}");
                }
            }
            assert_eq!((sight.sweep_at(19, [0.0; 2]), sight.sweep_at(23, [0.0; 2])), (None, None));
        }
    }
}
