//! Rows of the grid as waveforms, held to one another and to closed forms.

use generator::{Generator, Planes};
use scenario::{Curvature, Laws};
use signal::{Probe, Waveform};

use crate::scenes::{bowl, plain, pose, prepare, settings, stage, sun};

const GRID: u32 = 64;
const EYE: f64 = 900.0;

/// All signals of `rows`, of a bowl before an observer who looks north with the sun in the west.
fn rows(rows: std::ops::Range<u32>, curvature: Curvature) -> Vec<Waveform> {
    let mut settings = settings(100, 30.0, GRID);
    settings.view.laws = Laws { curvature, ..settings.view.laws };
    let session = prepare(stage(
        &plain(8000.0, vec![bowl([4000.0, 4000.0], 500.0, 150.0)]),
        sun(270.0, 15.0),
        &settings,
    ));
    let mut probe = Probe::new(vec!["*".into()], rows);
    // Without planes: what is looked at is worked out all the same.
    session
        .unwrap()
        .frame(5, &pose([2500.0, 4000.0, EYE], -30.0, 0.0), &mut Planes::new(100, 100, &[]), &mut probe)
        .unwrap();
    probe.waveforms
}

fn values<'w>(waves: &'w [Waveform], row: u32, name: &str) -> &'w [f64] {
    let found = waves.iter().find(|wave| wave.sweep == row && wave.signal.name == name);
    &found.unwrap_or_else(|| panic!("{name} of row {row}")).values
}

#[test]
fn every_row_that_is_wanted_has_every_signal() {
    let waves = rows(10..13, Curvature::None);
    let names: Vec<_> = lunsim::ROW.signals.iter().map(|signal| signal.name).collect();
    let found: Vec<_> = waves.iter().map(|wave| (wave.sweep, wave.signal.name)).collect();
    let expected: Vec<_> = (10..13).flat_map(|row| names.iter().map(move |name| (row, *name))).collect();
    assert_eq!(found, expected);
    assert!(waves.iter().all(|wave| (wave.frame, wave.values.len()) == (5, GRID as usize)));
    assert!(waves.iter().flat_map(|wave| &wave.values).all(|value| value.is_finite()));
    let settings = settings(100, 30.0, GRID);
    let program = settings.program();
    let clock = program.scan(&settings.view).unwrap().timebase;
    assert_eq!((clock.sweeps, clock.active_samples, clock.retrace_samples), (GRID, GRID, 0));
}

/// Blocks 11 to 14 from the rows of block 10: central differences, codes of the light, lines of the projection.
#[test]
fn a_row_follows_from_its_neighbours() {
    let waves = rows(0..GRID, Curvature::None);
    let (mut dark, mut sloped) = (0, 0);
    for row in 1..GRID - 1 {
        let of = |name: &str| values(&waves, row, name);
        let [before, after] = [row - 1, row + 1].map(|row| values(&waves, row, "lunsim.height"));
        let (along, across, height) = (of("lunsim.along"), of("lunsim.across"), of("lunsim.height"));
        let run = values(&waves, row + 1, "lunsim.along")[0] - values(&waves, row - 1, "lunsim.along")[0];
        for at in 1..GRID as usize - 1 {
            let slope = (after[at] - before[at]) / run;
            assert!((of("lunsim.slope.along")[at] - slope).abs() < 1e-9);
            let slope = (height[at + 1] - height[at - 1]) / (across[at + 1] - across[at - 1]);
            assert!((of("lunsim.slope.across")[at] - slope).abs() < 1e-9);
            sloped += i32::from(slope.abs() > 0.1);
            let is_dark = of("lunsim.shadow")[at] == 1.0;
            dark += i32::from(is_dark);
            let light = if is_dark { 0.0 } else { of("lunsim.reflectivity")[at] };
            assert_eq!(of("lunsim.code")[at], (255.0 * light).round(), "row {row}, point {at}");
            // 30 degrees down, 15 to each side of it: the tangent of the angle below the line of sight.
            let below = libm::atan2(EYE - height[at], along[at]) - 30.0_f64.to_radians();
            let down = 0.5 * (libm::tan(below) / libm::tan(15.0_f64.to_radians()) + 1.0) * 1024.0;
            let expected = down.floor().clamp(-1.0, 1024.0);
            assert!((of("lunsim.line")[at] - expected).abs() <= 1.0, "row {row}, point {at}: {expected}");
        }
    }
    assert!(dark > 20 && sloped > 20, "{dark} dark, {sloped} sloped");
}

/// Block 10 takes the drop off before the slopes are formed, so light sees the lean of far ground.
#[test]
fn the_drop_of_the_lunoid_is_in_heights_and_slopes() {
    let waves = rows(40..41, Curvature::Parabolic);
    let of = |name: &str| values(&waves, 40, name);
    let (along, across) = (of("lunsim.along"), of("lunsim.across"));
    // Beside the bowl.
    let drop = (along[0] * along[0] + across[0] * across[0]) / (2.0 * 1_737_400.0);
    assert!((of("lunsim.height")[0] + drop).abs() < 1e-9 && drop > 1.0, "{drop}");
    let lean = -along[0] / 1_737_400.0;
    assert!((of("lunsim.slope.along")[0] - lean).abs() < 1e-9, "{lean}");
}
