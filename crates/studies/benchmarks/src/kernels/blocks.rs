//! Blocks of the signal plane, each by itself.

use std::hint::black_box;
use std::slice::from_ref;

use feature_generator::{FeatureGenerator, FeatureProfile, FeatureProgram, Schedule};
use signal::{LANES, Lanes, Real};
use sweep_memory::{Beam, Memory, Steps, View, write_group};
use texture_generator::TextureGenerator;

use super::group::{Group, SAMPLES};
use super::{Work, alone};
use crate::STANDARD;

pub(super) fn terrain_generator<S: Real>() -> Work {
    let group = Group::of("first-light");
    let mut profile = group.profile::<S>();
    Work::new(SAMPLES, move || group.terrain().run(black_box(&group.programs), &group.light, &mut profile))
}

pub(super) fn projection<S: Real>() -> Work {
    let group = Group::of("nominal-drive");
    let profile = group.profile::<S>();
    let (processor, deflection) = (group.processor::<S>(), group.deflection());
    let mut projected = group.projected(&profile);
    Work::new(SAMPLES, move || processor.run(black_box(&profile.height), &deflection, &mut projected))
}

pub(super) fn write_beam<S: Real>() -> Work {
    let group = Group::of("nominal-drive");
    let profile = group.profile::<S>();
    let projected = group.projected(&profile);
    let settings = &group.scene.stage.settings;
    let (lines, rule) = (settings.raster.lines as usize, settings.laws.pixel_rule);
    let (mut side, mut rows) = (Vec::new(), vec![0.0; LANES * lines]);
    Work::new(SAMPLES, move || {
        let beam = Beam {
            position: &projected.position,
            line: &projected.line,
            entry: &projected.entry,
            intensity: &profile.reflectivity,
            breaks: None,
            far: None,
        };
        write_group(black_box(&beam), Steps::Curved, rule, lines, &mut side, &mut rows);
    })
}

/// The read beam over a frame of stripes, its yoke turned by `yoke` (rad).
pub(super) fn read_beam(memory: Memory, yoke: f64) -> Work {
    let group = Group::of("nominal-drive");
    let settings = &group.scene.stage.settings;
    let (lines, columns) = (settings.raster.lines as usize, settings.raster.columns as usize);
    let sweeps = STANDARD[0] as usize;
    let width = if matches!(memory, Memory::Digital) { sweeps } else { columns };
    let store: Vec<f32> = (0..lines * sweeps).map(|cell| (cell % 7) as f32 / 7.0).collect();
    let mut picture = vec![0.0; lines * columns];
    let view = View {
        fan: group.fan,
        projection: settings.laws.projection,
        pitch: group.scene.pose.attitude.pitch,
        raster: settings.raster.field,
        field: settings.raster.field,
        yoke,
    };
    Work::new(picture.len() as u64, move || {
        alone(|| memory.read(black_box(&store), lines, width, &view, &mut picture));
    })
}

pub(super) fn feature_schedule() -> Work {
    let group = Group::of("craters");
    let mut programs: [FeatureProgram; LANES] = Default::default();
    Work::new(SAMPLES, move || schedule(&group, &mut programs))
}

pub(super) fn feature_generator() -> Work {
    let group = Group::of("craters");
    let mut programs: [FeatureProgram; LANES] = Default::default();
    schedule(&group, &mut programs);
    let mut profile = FeatureProfile::<f32>::default();
    Work::new(SAMPLES, move || {
        let features = group.scene.stage.landscape.features();
        FeatureGenerator { ranges: group.table.ranges() }.run(features, black_box(&programs), &mut profile);
    })
}

fn schedule(group: &Group, programs: &mut [FeatureProgram; LANES]) {
    let (landscape, ranges) = (&group.scene.stage.landscape, group.table.ranges());
    let level = landscape.level();
    let schedule = Schedule {
        features: landscape.features(),
        parts: group.scene.stage.settings.feature_generator,
        region_origin: level.origin(),
        region_size: level.region_size(),
        among: None,
        absent: &[],
    };
    let span = [ranges[0], ranges[ranges.len() - 1]];
    for (program, &direction) in programs.iter_mut().zip(&group.directions) {
        schedule.write(group.foot(), direction, span, program);
    }
}

pub(super) fn texture_generator() -> Work {
    let group = Group::of("craters");
    let mut out = Vec::<Lanes<f32>>::new();
    Work::new(SAMPLES, move || {
        let texture = group.scene.stage.landscape.texture().expect("the scenario has one");
        let ranges = group.table.ranges();
        let all = 0..ranges.len();
        let generator = TextureGenerator { texture, ranges };
        generator.run(group.foot(), black_box(&group.directions), from_ref(&all), &mut out);
    })
}
