//! Block by block: a group of eight sweeps in the middle of a shipped frame, each block fed with what the one before it made.

#![allow(missing_docs)]

use std::hint::black_box;
use std::slice::from_ref;
use std::sync::Arc;

use benchmarks::{Choice, STANDARD, Scene};
use criterion::measurement::WallTime;
use criterion::{BatchSize, BenchmarkGroup, Criterion, Throughput, criterion_group, criterion_main};
use display_projection_processor::{Deflection, Processor, Projected};
use feature_generator::{FeatureGenerator, FeatureProfile, FeatureProgram, Schedule};
use glam::DVec3;
use landscape::SweepLight;
use machine::ControlPlane;
use polyhedron_generator::{Drawn, FaceLight, Field, LeftOut, PolyhedronGenerator, Sight, ViewPlane};
use quantities::sin_cos;
use rayon::ThreadPoolBuilder;
use remote_shadow::{Outlines, Resolution, ShadowBank};
use shadow_controller::ShadowController;
use signal::{LANES, Real};
use sweep_generator::RangeTable;
use sweep_memory::{Beam, Memory, Steps, View, write_group};
use sweep_program::{Fan, SweepProgram};
use terrain_generator::{Profile, TerrainGenerator};
use texture_generator::TextureGenerator;

/// A frame, and a group in its middle.
struct Group {
    scene: Scene,
    table: RangeTable,
    fan: Fan,
    programs: [SweepProgram; LANES],
    directions: [[f64; 2]; LANES],
    light: [SweepLight; LANES],
}

impl Group {
    fn of(scenario: &str) -> Self {
        let choice = Choice { model: Some("ideal"), raster: Some(STANDARD), ..Choice::default() };
        let control = ControlPlane::new(Scene::shipped(scenario, &choice).stage);
        let scene = Scene::shipped(scenario, &choice);
        let settings = &scene.stage.settings;
        let sweeps = control.sweeps(0, &scene.pose).expect("drawn by the tests");
        let first = settings.raster.sweeps / 2;
        let number = |lane: usize| first + lane as u32;
        let directions = std::array::from_fn(|lane| sweeps.direction(number(lane)));
        let programs = std::array::from_fn(|lane| sweeps.programs(number(lane)).swap_remove(0));
        let (sun, landscape) = (scene.stage.scenery.sun(0.0), &scene.stage.landscape);
        let lit = |direction| SweepLight::new(&sun, landscape.albedo(), *landscape.photometry(), direction);
        let pitch = scene.pose.attitude.pitch;
        let fan = Fan::covering(settings.laws.projection, pitch, &settings.raster.field, STANDARD[0]);
        Self {
            table: RangeTable::new(&settings.range, settings.raster.samples as usize),
            fan: fan.expect("the pitch is moderate"),
            light: directions.map(lit),
            programs,
            directions,
            scene,
        }
    }

    fn eye(&self) -> [f64; 2] {
        [self.scene.pose.eye[0], self.scene.pose.eye[1]]
    }

    fn terrain(&self) -> TerrainGenerator<'_> {
        let level = self.scene.stage.landscape.level();
        TerrainGenerator {
            buffer: level.words(),
            region_size: level.region_size(),
            ranges: self.table.ranges(),
            datum: self.scene.pose.eye[2],
        }
    }

    fn profile<S: Real>(&self) -> Profile<S> {
        let mut profile = Profile::default();
        self.terrain().run(&self.programs, &self.light, &mut profile);
        profile
    }

    fn projected<S: Real>(&self, profile: &Profile<S>) -> Projected<S> {
        let mut projected = Projected::default();
        self.processor().run(&profile.height, &self.deflection(), &mut projected);
        projected
    }

    fn processor<S: Real>(&self) -> Processor<S> {
        let laws = &self.scene.stage.settings.laws;
        Processor::new(laws.occlusion, laws.curvature, self.table.ranges())
    }

    fn deflection(&self) -> [Deflection; LANES] {
        let (settings, pitch) = (&self.scene.stage.settings, self.scene.pose.attitude.pitch);
        let raster = settings.raster;
        std::array::from_fn(|lane| {
            let tangent = self.fan.tangent(STANDARD[0] / 2 + lane as u32);
            Deflection::new(settings.laws.projection, pitch, tangent)
                .in_lines(f64::from(raster.lines), raster.field.tan_half_height)
        })
    }
}

fn samples(group: &mut BenchmarkGroup<'_, WallTime>) {
    group.throughput(Throughput::Elements(LANES as u64 * u64::from(STANDARD[1])));
}

fn terrain_path<S: Real>(c: &mut Criterion, scalar: &str) {
    let scene = Group::of("first-light");
    let mut group = c.benchmark_group(format!("eight sweeps of first light, {scalar}"));
    samples(&mut group);
    let mut profile = scene.profile::<S>();
    group.bench_function("terrain generator", |b| {
        b.iter(|| scene.terrain().run(black_box(&scene.programs), &scene.light, &mut profile));
    });
    let (processor, deflection) = (scene.processor::<S>(), scene.deflection());
    let mut projected = scene.projected(&profile);
    group.bench_function("display projection processor", |b| {
        b.iter(|| processor.run(black_box(&profile.height), &deflection, &mut projected));
    });
    let settings = &scene.scene.stage.settings;
    let lines = settings.raster.lines as usize;
    let (mut side, mut rows) = (Vec::new(), vec![0.0; LANES * lines]);
    let beam = Beam {
        position: &projected.position,
        line: &projected.line,
        entry: &projected.entry,
        intensity: &profile.reflectivity,
        breaks: None,
        far: None,
    };
    group.bench_function("sweep memory, write beam", |b| {
        b.iter(|| {
            write_group(
                black_box(&beam),
                Steps::Curved,
                settings.laws.pixel_rule,
                lines,
                &mut side,
                &mut rows,
            )
        });
    });
    group.finish();
}

fn ideal_blocks(c: &mut Criterion) {
    terrain_path::<f32>(c, "f32");
    terrain_path::<f64>(c, "f64");
}

/// Craters and texture, f32.
fn ground_detail(c: &mut Criterion) {
    let scene = Group::of("craters");
    let landscape = &scene.scene.stage.landscape;
    let mut group = c.benchmark_group("eight sweeps of craters, f32");
    samples(&mut group);
    let level = landscape.level();
    let schedule = Schedule {
        features: landscape.features(),
        parts: scene.scene.stage.settings.feature_generator,
        region_origin: level.origin(),
        region_size: level.region_size(),
        among: None,
    };
    let ranges = scene.table.ranges();
    let span = [ranges[0], ranges[ranges.len() - 1]];
    let mut programs: [FeatureProgram; LANES] = Default::default();
    group.bench_function("feature generator, schedule", |b| {
        b.iter(|| {
            for (program, &direction) in programs.iter_mut().zip(&scene.directions) {
                schedule.write(scene.eye(), direction, span, program);
            }
        });
    });
    let mut profile = FeatureProfile::<f32>::default();
    group.bench_function("feature generator", |b| {
        b.iter(|| FeatureGenerator { ranges }.run(landscape.features(), &programs, &mut profile));
    });
    let texture = landscape.texture().expect("the scenario has one");
    let mut out = Vec::<signal::Lanes<f32>>::new();
    group.bench_function("texture generator", |b| {
        let all = 0..ranges.len();
        b.iter(|| {
            TextureGenerator { texture, ranges }.run(scene.eye(), &scene.directions, from_ref(&all), &mut out)
        });
    });
    group.finish();
}

/// The read beam, on all threads: a frame of stripes.
fn read_out(c: &mut Criterion) {
    let scene = Group::of("first-light");
    let settings = &scene.scene.stage.settings;
    let (lines, columns) = (settings.raster.lines as usize, settings.raster.columns as usize);
    let store: Vec<f32> = (0..lines * STANDARD[0] as usize).map(|cell| (cell % 7) as f32 / 7.0).collect();
    let mut picture = vec![0.0; lines * columns];
    let mut view = View {
        fan: scene.fan,
        projection: settings.laws.projection,
        pitch: scene.scene.pose.attitude.pitch,
        raster: settings.raster.field,
        field: settings.raster.field,
        yoke: 0.0,
    };
    let mut group = c.benchmark_group("sweep memory, read beam");
    group.throughput(Throughput::Elements(picture.len() as u64));
    group.bench_function("digital memory", |b| {
        b.iter(|| Memory::Digital.read(black_box(&store), lines, STANDARD[0] as usize, &view, &mut picture));
    });
    group.bench_function("scan converter", |b| {
        b.iter(|| Memory::ScanConverter.read(black_box(&store), lines, columns, &view, &mut picture));
    });
    view.yoke = 0.1;
    group.bench_function("scan converter, yoke turned", |b| {
        b.iter(|| Memory::ScanConverter.read(black_box(&store), lines, columns, &view, &mut picture));
    });
    group.finish();
}

/// What is brought for a frame before its sweeps run, on one thread: gates of remote shadow, polyhedra.
fn before_the_sweeps(c: &mut Criterion) {
    let scene = Group::of("showpiece");
    let (stage, pose, eye) = (&scene.scene.stage, &scene.scene.pose, scene.eye());
    let (settings, sun) = (&stage.settings, stage.scenery.sun(0.0));
    let (sin, cos) = sin_cos(pose.attitude.heading);
    let directions: Vec<[f64; 2]> =
        (0..scene.fan.sweeps).map(|sweep| scene.fan.direction(sweep, [cos, sin])).collect();
    let tangents: Vec<f64> = (0..scene.fan.sweeps).map(|sweep| scene.fan.tangent(sweep)).collect();
    let mut group = c.benchmark_group("a frame of showpiece, one thread");
    let pool = ThreadPoolBuilder::new().num_threads(1).build().expect("there is room for a thread");

    let fineness = settings.shadows.expect("the scenario has shadows");
    let resolution = Resolution { finest: fineness.finest, angle: fineness.angle };
    let (bank, reach) = (ShadowBank::new(Arc::clone(&stage.landscape), resolution), settings.range.end);
    let tiles = bank.around(&sun, eye, reach, Some([directions[0], directions[directions.len() - 1]]));
    let shadows: Vec<&Outlines> = tiles.iter().map(|tile| &tile.outlines).collect();
    let parts = settings.shadow_controller;
    let controller = ShadowController { parts, map_centre: [0.0; 2], map_side: 1.0, tells_lines: false };
    let mut gates = Vec::new();
    group.bench_function("shadow controller", |b| {
        pool.install(|| {
            b.iter(|| controller.gates(eye, &directions, reach, black_box(&shadows), &mut gates))
        });
    });

    let (lines, field) = (f64::from(settings.raster.lines), settings.raster.field);
    let view = ViewPlane {
        eye: pose.eye,
        heading: pose.attitude.heading,
        pitch: pose.attitude.pitch,
        projection: settings.laws.projection,
        curvature: settings.laws.curvature,
        tan_half_height: field.tan_half_height,
        lines,
    };
    let sight = Sight::new(lines, 2.0 * libm::atan(field.tan_half_height));
    let light = FaceLight { sun: DVec3::from_array(sun.direction()) };
    let mut out = LeftOut::default();
    let seen: Vec<_> = stage
        .scenery
        .bodies(0.0)
        .filter(|body| sight.resolves(DVec3::from_array(pose.eye), body, &mut out))
        .collect();
    let mut generator = PolyhedronGenerator::default();
    group.bench_function("polyhedron generator", |b| {
        pool.install(|| {
            b.iter(|| {
                let field = Field::new(black_box(&view), &tangents);
                generator.run(&field, &light, &seen, |&body| {
                    Some(Drawn { aspect: field.aspect(body)?, dark: false })
                })
            });
        });
    });
    group.finish();
}

/// What is computed before a mission, on all threads.
fn before_the_mission(c: &mut Criterion) {
    let scene = Group::of("long-shadows");
    let (stage, eye) = (&scene.scene.stage, scene.eye());
    let sun = stage.scenery.sun(0.0);
    let fineness = stage.settings.shadows.expect("the scenario has shadows");
    let mut group = c.benchmark_group("before the mission");
    group.sample_size(10);
    group.bench_function("remote shadow within 100 m", |b| {
        let resolution = Resolution { finest: fineness.finest, angle: fineness.angle };
        b.iter_batched(
            || ShadowBank::new(Arc::clone(&stage.landscape), resolution),
            |bank| black_box(bank.around(&sun, eye, 100.0, None)),
            BatchSize::PerIteration,
        );
    });
    group.finish();
}

criterion_group!(benches, ideal_blocks, ground_detail, read_out, before_the_sweeps, before_the_mission);
criterion_main!(benches);
