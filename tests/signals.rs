//! The signal table, and wires that only a probe asks for: held to the ground they stand for.

use std::collections::BTreeSet;

use generator::{PlaneKind, Planes};
use landscape::Level;
use landscape::basis::values;
use lunoid_tests::{ComparedScene, Shipped, random};
use machine::Prepare;
use signal::{Axis, Kind, Probe, Waveform};
use signal_plane::signals;
use sweep_program::{Colour, Fan};

const SEEDS: std::ops::Range<u64> = 7100..7112;

fn named<'w>(waves: &'w [Waveform], sweep: u32, name: &str) -> &'w Waveform {
    let found = waves.iter().find(|wave| wave.sweep == sweep && wave.signal.name == name);
    found.unwrap_or_else(|| panic!("{name} of sweep {sweep} was not recorded"))
}

/// Value of a wire of changes when a sample is taken.
fn held(wave: &Waveform, sample: f64) -> f64 {
    wave.values[wave.times.partition_point(|&time| time <= sample) - 1]
}

fn drawn(scene: &ComparedScene) -> Vec<Waveform> {
    scene.draw(1, &["*"]).unwrap().waveforms
}

/// Samples that lie inside the profile, with their ground ranges.
fn inside(waves: &[Waveform], sweep: u32) -> impl Iterator<Item = (usize, f64)> {
    let ranges = named(waves, sweep, "sweep.range").values.clone();
    let end = named(waves, sweep, "tg.height").values.windows(2).rposition(|pair| pair[0] != pair[1]);
    ranges.into_iter().enumerate().take(end.map_or(0, |last| last + 1))
}

#[test]
fn every_signal_is_named_once_and_belongs_to_a_block_of_the_house() {
    let names: BTreeSet<_> = signals().iter().map(|signal| signal.name).collect();
    assert_eq!(names.len(), signals().len());
    for signal in signals() {
        assert!(signal.name.contains('.') && !signal.name.contains(['-', ' ']), "{}", signal.name);
        assert!(!signal.meaning.is_empty() && !signal.figure.is_empty(), "{}", signal.name);
        let digital = matches!(signal.kind, Kind::Bus | Kind::Event);
        assert!(!digital || signal.axis == Axis::Changes, "{}", signal.name);
        let block =
            std::path::Path::new(env!("CARGO_MANIFEST_DIR")).join("../crates/device").join(signal.block());
        assert!(block.is_dir(), "{}: {}", signal.name, block.display());
    }
}

/// Shadow gates are found for the sweeps that are looked at alone, with or without drums and a processor that take time.
#[test]
#[ignore = "long: .ci/long runs it"]
fn some_sweeps_alone_are_those_of_the_whole_frame() {
    let mut changes = 0;
    for (name, machine, frame) in [
        ("craters", "ideal", 10),
        ("long-shadows", "ideal", 30),
        ("long-shadows", "pra-nominal", 4),
        ("full-drive", "pra-overloaded", 3),
        ("showpiece", "ideal", 5),
    ] {
        let scene = Shipped::changed(name, Some(96), |scenario| scenario.machine = machine.into());
        let (pose, raster) = (scene.pose(frame).pose, scene.settings.raster);
        let size = [raster.columns, raster.lines].map(|count| count as usize);
        let session = scene.stage().prepare();
        let mut whole = Probe::new(vec!["*".into()], 0..96);
        scene.draw(&*session, frame, &mut whole);
        for asked in [0..1, 3..4, 28..30, 41..42, 60..61, 95..96] {
            let mut alone = Probe::new(vec!["*".into()], asked.clone());
            // Made ready anew: it has no shadow boundaries but those that these sweeps need.
            let session = scene.stage().prepare();
            session.frame(frame, &pose, &mut Planes::new(size[0], size[1], &[]), &mut alone).unwrap();
            let of_whole: Vec<_> =
                whole.waveforms.iter().filter(|wave| asked.contains(&wave.sweep)).cloned().collect();
            assert!(of_whole == alone.waveforms, "{name} on {machine}, sweeps {asked:?}");
            let gates = of_whole.iter().filter(|wave| wave.signal.name == "sc.gate");
            changes += gates.map(|gate| gate.values.len() - 1).sum::<usize>();
        }
    }
    assert!(changes > 20, "{changes} changes of the gate");
}

/// A column drawn alone is that of the whole picture, with a tube and without.
#[test]
fn a_column_alone_is_that_of_the_whole_picture() {
    for (name, machine) in [("craters", "ideal"), ("long-shadows", "ideal"), ("craters", "pra-nominal")] {
        let scene = Shipped::changed(name, Some(96), |scenario| scenario.machine = machine.into());
        let (pose, raster) = (scene.pose(4).pose, scene.settings.raster);
        let whole = scene.machine(4).planes;
        for column in [0, 40, raster.columns as usize - 1] {
            let mut planes =
                Planes::new(raster.columns as usize, raster.lines as usize, &[PlaneKind::Intensity]);
            let session = scene.stage().prepare();
            let there = session.column(4, &pose, column, &mut planes, &mut Probe::off()).unwrap();
            assert!(there.contains(&column), "{there:?}");
            let [found, expected] = [&planes, &whole].map(|planes| {
                let rows = planes.get(PlaneKind::Intensity).unwrap().chunks_exact(planes.columns());
                rows.flat_map(|row| row[there.clone()].to_vec()).collect::<Vec<f32>>()
            });
            assert!(found == expected, "{name} on {machine}, columns {there:?}");
        }
    }
}

#[test]
fn what_the_colours_add_is_the_height() {
    for seed in SEEDS {
        let scene = random::scene(seed);
        let waves = drawn(&scene);
        for sweep in [0, scene.sweeps - 1] {
            let height = named(&waves, sweep, "tg.height");
            let shares = Colour::ALL.map(|c| named(&waves, sweep, &format!("tg.{}.height", c.name())));
            let scale = height.values.iter().fold(1.0_f64, |most, value| most.max(value.abs()));
            for (sample, range) in inside(&waves, sweep) {
                let sum: f64 = shares.iter().map(|share| share.values[sample]).sum();
                let error = (sum - height.values[sample]).abs();
                let tolerance = if scene.scalar == scenario::Scalar::F64 { 1e-9 } else { 1e-4 };
                assert!(error <= tolerance * scale, "seed {seed}, sweep {sweep}, {range} m: {error}");
            }
        }
    }
}

#[test]
fn function_generators_follow_the_ramps() {
    let waves = drawn(&random::scene(7107));
    for (axis, fed, turned) in [("x", "x", false), ("x", "cx", true), ("y", "y", false), ("y", "cy", true)] {
        let ramp = &named(&waves, 0, &format!("sweep.{axis}")).values;
        for (p, function) in ["g0", "g1", "g2"].into_iter().enumerate() {
            let wire = &named(&waves, 0, &format!("tg.fn.{fed}.{function}")).values;
            for (sample, _) in inside(&waves, 0) {
                let ramp = if turned { 1.0 - ramp[sample] } else { ramp[sample] };
                assert!((wire[sample] - values(ramp)[p]).abs() < 1e-12, "{fed} {function} at {sample}");
            }
        }
    }
}

/// Corner of the region of a place that has a colour, by its place on the lattice alone.
fn corner(level: &Level, [x, y]: [f64; 2], colour: Colour) -> Option<f64> {
    let [k, l] = level.in_regions(x, y).map(|place| place.floor() as i64);
    let corners = [[k, l], [k + 1, l], [k, l + 1], [k + 1, l + 1]];
    let [m, n] = corners.into_iter().find(|[m, n]| Colour::of_corner(*m, *n) == colour)?;
    let [north, east] = level.corners().map(|count| count as i64);
    (0..north).contains(&m).then_some(())?;
    (0..east).contains(&n).then_some((m * east + n) as f64)
}

#[test]
fn registers_hold_the_corners_of_the_region_they_are_in() {
    for seed in SEEDS {
        let scene = random::scene(seed);
        let waves = drawn(&scene);
        let fan = Fan::covering(scene.laws.projection, scene.pitch, &scene.field, scene.sweeps).unwrap();
        for sweep in [0, scene.sweeps / 2, scene.sweeps - 1] {
            let (sin, cos) = quantities::sin_cos(scene.heading);
            let direction = fan.direction(sweep, [cos, sin]);
            for (sample, range) in inside(&waves, sweep) {
                let place: [f64; 2] = std::array::from_fn(|axis| scene.eye[axis] + range * direction[axis]);
                let [u, v] = scene.level.in_regions(place[0], place[1]);
                // At a boundary either region is right.
                if [u, v].iter().any(|place| (place - place.round()).abs() < 1e-6) {
                    continue;
                }
                for colour in Colour::ALL {
                    let hold = named(&waves, sweep, &format!("tg.{}.hold", colour.name()));
                    if let Some(corner) = corner(&scene.level, place, colour) {
                        let found = held(hold, sample as f64);
                        assert_eq!(found, corner, "seed {seed}, sweep {sweep}, {range} m, {colour:?}");
                    }
                }
                for (axis, at) in ["x", "y"].into_iter().zip([u, v]) {
                    let polarity =
                        held(named(&waves, sweep, &format!("sweep.polarity.{axis}")), sample as f64);
                    assert_eq!(
                        polarity,
                        f64::from(u8::from(at.floor() as i64 % 2 == 0)),
                        "{axis} at {range} m"
                    );
                }
            }
        }
    }
}

#[test]
fn late_words_are_told_at_the_stops_that_missed_them() {
    let mut scene = random::scene(7103);
    scene.loader.access = 25;
    scene.master_hz = 200_000;
    let drawn = scene.draw(1, &["dpu.late", "sweep.fold.*"]).unwrap();
    let mut words = 0;
    for sweep in 0..scene.sweeps {
        let late = named(&drawn.waveforms, sweep, "dpu.late");
        words += late.values.iter().map(|&mask| u64::from((mask as u16).count_ones())).sum::<u64>();
        let folds = ["x", "y"].map(|axis| named(&drawn.waveforms, sweep, &format!("sweep.fold.{axis}")));
        for time in &late.times {
            assert!(folds.iter().any(|fold| fold.times.contains(time)), "sweep {sweep}, {time}");
        }
    }
    assert!(words > 0);
    assert_eq!(words, drawn.counts["late_words"]);
}

#[test]
fn a_probe_without_a_picture_sees_the_same_waves() {
    let shipped = Shipped::read("craters", Some(64));
    let stage = shipped.stage();
    let session = stage.clone().prepare();
    let pose = shipped.pose(10).pose;
    let raster = &stage.settings.raster;
    let waves = |kinds: &[PlaneKind]| {
        let mut probe = Probe::new(vec!["*".into()], 3..21);
        let mut planes = Planes::new(raster.columns as usize, raster.lines as usize, kinds);
        let counts = session.frame(10, &pose, &mut planes, &mut probe).unwrap();
        (probe.waveforms, counts["sweeps"])
    };
    let (alone, sweeps) = waves(&[]);
    let (beside, all) = waves(&[PlaneKind::Intensity]);
    assert_eq!(all, u64::from(raster.sweeps));
    assert_eq!(sweeps, 24, "three groups of eight");
    assert_eq!(alone, beside);
    let wires = session.wires();
    assert!(wires.iter().any(|wire| wire.signal.name == "fg.height"));
    assert!(!wires.iter().any(|wire| wire.signal.name.contains(".coarse.")), "craters has one level");
    assert!(wires.iter().all(|wire| wire.full_scale > 0.0 && wire.volts.is_finite()));
}

#[test]
fn inner_wires_of_real_parts_are_those_of_the_parts() {
    let mut shipped = Shipped::read("first-light", Some(64));
    let ideal = shipped.settings.analog.clone();
    let segments = hardware_model::HardwareModel::load(
        &hardware_model::ModelSource::BuiltIn("ideal".into()),
        &[lunoid_tests::shipped::folder().join("../hardware-models/faults/facet.toml")],
        &[],
    );
    let pose = shipped.pose(10).pose;
    let mut recorded = |analog| {
        shipped.settings.analog = analog;
        let session = shipped.stage().prepare();
        let mut probe = Probe::new(vec!["tg.fn.x.g0".into(), "sweep.range".into()], 20..21);
        session.frame(10, &pose, &mut Planes::new(64, 64, &[]), &mut probe).unwrap();
        named(&probe.waveforms, 20, "tg.fn.x.g0").values.clone()
    };
    let clean = recorded(ideal);
    let broken = recorded(segments.unwrap().model.analog);
    // A broken line of six segments is off by at most max |g''| h^2 / 16, equal ripple (hardware report 3.3).
    let most = 5.774 / 36.0 / 16.0;
    let error = clean.iter().zip(&broken).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max);
    assert!(error > 0.3 * most && error < 2.5 * most, "{error} against {most}");
}

/// Waves of some signals of frame 10 of `craters`, by a machine with `parts` and occlusion by derivative.
fn by_derivative(parts: Option<&str>) -> (Vec<Waveform>, f64) {
    let mut shipped = Shipped::read("craters", Some(64));
    if let Some(name) = parts {
        let source = hardware_model::ModelSource::BuiltIn(name.into());
        shipped.settings.analog =
            hardware_model::HardwareModel::load(&source, &[], &[]).unwrap().model.analog;
    }
    shipped.settings.laws.occlusion = scenario::Occlusion::Derivative;
    let stage = shipped.stage();
    let session = stage.clone().prepare();
    assert!(session.wires().iter().any(|wire| wire.signal.name == "dpp.derivative"));
    let wanted = ["dpp.*", "mu.reflectivity", "sm.video"].map(str::to_owned);
    let mut probe = Probe::new(wanted.into(), 0..64);
    session.frame(10, &shipped.pose(10).pose, &mut Planes::new(64, 64, &[]), &mut probe).unwrap();
    (probe.waveforms, 1e6 / stage.settings.timebase.sample_rate().hertz())
}

#[test]
fn the_derivative_is_that_of_the_elevation_and_blanks_where_it_falls() {
    for (parts, tolerance, share) in [(None, 1e-9, 0.99), (Some("pra-nominal"), 0.02, 0.8)] {
        let (waves, sample_us) = by_derivative(parts);
        let (mut fallen, mut blanked, mut off, mut size) = (0, 0, 0.0_f64, 0.0_f64);
        for sweep in 0..64 {
            let [elevation, derivative, blank] = ["dpp.elevation", "dpp.derivative", "dpp.blank"]
                .map(|name| &named(&waves, sweep, name).values);
            // What it has changed by so far is how far it has come; from parts it is smoothed over a few samples.
            let mut come = elevation[1];
            let end = elevation.windows(2).rposition(|pair| pair[0] != pair[1]).map_or(0, |last| last);
            for sample in 2..end {
                come += derivative[sample] * sample_us;
                off = off.max((come - elevation[sample]).abs());
                size = size.max((elevation[sample] - elevation[1]).abs());
                if blank[sample] > blank[sample - 1] {
                    blanked += 1;
                    // From parts the gate comes late: by then the elevation has fallen.
                    let before = sample.saturating_sub(8);
                    fallen += i32::from(derivative[before..=sample].iter().any(|&change| change < 0.0));
                }
            }
            assert!(derivative[end + 2..].iter().all(|&change| change == 0.0), "{parts:?}, sweep {sweep}");
        }
        assert!(off <= tolerance * size, "{parts:?}: off by {off} of {size}");
        // A rim that falls between two samples is blanked behind a step that has risen by as much; where the elevation nearly
        // falls, noise of a comparator of parts blanks.
        let most = f64::from(fallen) >= share * f64::from(blanked);
        assert!(blanked > 100 && most, "{parts:?}: {fallen} of {blanked} blanks");
    }
}

#[test]
fn video_is_the_composite_where_the_beam_is_on() {
    let (waves, _) = by_derivative(None);
    let (mut on, mut off) = (0, 0);
    for sweep in 0..64 {
        let [light, blank, video] =
            ["mu.reflectivity", "dpp.blank", "sm.video"].map(|name| &named(&waves, sweep, name).values);
        let end = light.windows(2).rposition(|pair| pair[0] != pair[1]).map_or(0, |last| last);
        for sample in 0..=end {
            let expected = if blank[sample] > 0.5 { 0.0 } else { light[sample] };
            assert_eq!(video[sample], expected, "sweep {sweep}, sample {sample}");
            on += usize::from(expected > 0.0);
            off += usize::from(blank[sample] > 0.5 && light[sample] > 0.0);
        }
    }
    assert!(on > 1000 && off > 1000, "{on} samples written, {off} blanked");
}

#[test]
fn without_occlusion_by_derivative_there_is_no_such_wire() {
    let shipped = Shipped::read("profile", Some(16));
    let session = shipped.stage().prepare();
    let has = |name: &str| session.wires().iter().any(|wire| wire.signal.name == name);
    assert!(!has("dpp.derivative") && has("sm.video"));
}

/// Sub-generators one by one make what the block puts out: their heights add up, and the presence line is up where one of their
/// comparators is. Line generators one by one make the gate of shadow: it changes where one of their comparators answers.
#[test]
fn sub_generators_and_line_generators_make_what_their_blocks_put_out() {
    for parts in [None, Some("pra-nominal")] {
        let (mut in_footprints, mut answers) = (0, 0);
        let mut shipped = Shipped::read("full-drive", Some(64));
        if let Some(name) = parts {
            let source = hardware_model::ModelSource::BuiltIn(name.into());
            let model = hardware_model::HardwareModel::load(&source, &[], &[]).unwrap().model;
            shipped.settings.analog = model.analog;
            shipped.settings.feature_generator = model.feature_generator;
            shipped.settings.shadow_controller = model.shadow_controller;
        }
        let is_ideal =
            shipped.settings.analog.features_are_ideal() && shipped.settings.analog.wires.is_ideal();
        let session = shipped.stage().prepare();
        let wanted = ["fg.*", "sc.*"].map(str::to_owned);
        let mut probe = Probe::new(wanted.into(), 0..64);
        session.frame(60, &shipped.pose(60).pose, &mut Planes::new(64, 64, &[]), &mut probe).unwrap();
        for sweep in 0..64 {
            let all = |pattern: &str| -> Vec<&Waveform> {
                let is_meant = |wave: &&Waveform| wave.sweep == sweep && wave.signal.matches(pattern);
                probe.waveforms.iter().filter(is_meant).collect()
            };
            let [height, present, gate] =
                ["fg.height", "fg.present", "sc.gate"].map(|name| named(&probe.waveforms, sweep, name));
            let [heights, comparators] = ["fg.height.*", "fg.comparator.*"].map(all);
            let scale = height.values.iter().fold(1.0_f64, |most, value| most.max(value.abs()));
            for sample in 0..height.values.len() {
                let is_in = comparators.iter().any(|wave| wave.values[sample] > 0.5);
                let expected = present.values[sample];
                assert_eq!(f64::from(u8::from(is_in)), expected, "{parts:?}, sweep {sweep}, {sample}");
                in_footprints += u32::from(is_in);
                let sum: f64 = heights.iter().map(|wave| wave.values[sample]).sum();
                // A chain of parts sees straight lines between the rims of all craters, and alone between its own; amplifiers lag.
                let error = (sum - height.values[sample]).abs();
                assert!(!is_ideal || error <= 1e-4 * scale, "sweep {sweep}, {sample}: {error}");
            }
            let mut edges: Vec<f64> =
                all("sc.comparator.*").iter().flat_map(|wave| wave.times.clone()).collect();
            edges.sort_by(f64::total_cmp);
            let last = gate.values.windows(2).rposition(|pair| pair[0] != pair[1]).unwrap_or(0);
            for sample in 1..=last {
                let [before, after] =
                    [sample - 1, sample].map(|at| edges.partition_point(|edge| *edge <= at as f64));
                let changed = gate.values[sample] != gate.values[sample - 1];
                assert_eq!((after - before) % 2 == 1, changed, "{parts:?}, sweep {sweep}, {sample}");
                answers += u32::from(changed);
            }
        }
        assert!(in_footprints > 100 && answers > 20, "{parts:?}: {in_footprints} samples, {answers} answers");
    }
}
