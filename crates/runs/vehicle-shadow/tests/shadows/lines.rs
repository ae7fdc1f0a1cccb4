//! Television lines as waveforms: against the pictures that they made, and against closed forms.

use std::fs;
use std::sync::atomic::AtomicBool;

use glam::DVec3;
use picture::{Depth, GreyPicture, Limits, read_png};
use quantities::{radians, sin_cos};
use scenario::{Scenery, TrackPatch};
use serde_json::Value;
use signal::{Probe, Waveform};
use solids::Solid;
use vehicle_shadow::{
    Augmentation, GroundLaw, Look, MadeFrom, Method, OutlineRule, SIGNALS, ScanConverter, ShadowFolder,
    Shape, TrueGround,
};

use crate::scenes::{flat, stage, sun};
use crate::sequences::{Folder, SIZE};

const EYE: f64 = 1.6334;
/// All of a sequence's lines.
const ALL: std::ops::Range<u32> = 0..SIZE[1] as u32;

fn augmentation(shape: Shape, ground: GroundLaw, method: Method) -> Augmentation {
    Augmentation {
        inputs: String::new(),
        shape,
        eye_height: EYE,
        sun: Some(sun(200.0, 30.0)),
        penumbra: false,
        ground,
        method,
    }
}

fn flat_ground() -> GroundLaw {
    GroundLaw::Flat(OutlineRule::Parts)
}

/// Puts the shadow into the sequence, and looks at lines of frame 5.
fn looked(folder: &Folder, augmentation: &Augmentation, lines: std::ops::Range<u32>) -> Vec<Waveform> {
    let mut look = Look { frame: 5, probe: Probe::new(vec!["vs.*".into()], lines) };
    let cancel = AtomicBool::new(false);
    let sequence = folder.sequence().unwrap();
    let from = MadeFrom { inputs: String::new(), keys: Value::Null };
    let out = ShadowFolder::claim(&folder.join("out"), &sequence, &from, false).unwrap();
    augmentation.run(&sequence, &out, &cancel, &|_| {}, &mut look).unwrap();
    look.probe.waveforms
}

fn named<'w>(waves: &'w [Waveform], line: usize, name: &str) -> &'w Waveform {
    let found = waves.iter().find(|wave| wave.sweep == line as u32 && wave.signal.name == name);
    found.unwrap_or_else(|| panic!("{name} of line {line} was not recorded"))
}

/// Pictures of all codes.
fn rows_of_codes(folder: &Folder, depth: Depth) -> GreyPicture {
    let count = SIZE[0] * SIZE[1];
    let code = |index: usize| (index * usize::from(depth.white()) / (count - 1)) as u16;
    let picture = GreyPicture::new(SIZE[0], SIZE[1], depth, (0..count).map(code).collect()).unwrap();
    (4..7).for_each(|frame| folder.put(&format!("frame-{frame:06}.png"), &picture));
    picture
}

/// Mean over each column of a wire that is told when it changes.
fn means(wave: &Waveform) -> Vec<f64> {
    let end = SIZE[0] as f64;
    let until = wave.times.iter().skip(1).copied().chain([end]);
    let stretches: Vec<_> = wave.times.iter().copied().zip(until).zip(&wave.values).collect();
    let mean = |column: usize| {
        let (from, to) = (column as f64, column as f64 + 1.0);
        let part = |&((start, end), value): &((f64, f64), &f64)| {
            (f64::min(end, to) - f64::max(start, from)).max(0.0) * value
        };
        stretches.iter().map(part).sum()
    };
    (0..SIZE[0]).map(mean).collect()
}

/// What is probed of the video is what the picture is made of, line by line; and what darkens it are the gates of the
/// converters.
#[test]
fn probed_video_is_that_of_the_picture() {
    for depth in [Depth::Eight, Depth::Sixteen] {
        for (method, penumbra) in [
            (Method::Synchronised { dac_bits: 10 }, false),
            (Method::Synchronised { dac_bits: 6 }, true),
            (Method::ScanConverter(ScanConverter { gain: 0.8, ..ScanConverter::default() }), false),
        ] {
            let folder = Folder::new();
            let old = rows_of_codes(&folder, depth);
            let rover = Shape::find("rover", EYE).unwrap();
            let behind = Some(sun(215.0, 22.0));
            let augmentation =
                Augmentation { sun: behind, penumbra, ..augmentation(rover, flat_ground(), method) };
            let waves = looked(&folder, &augmentation, ALL);
            let new = read_png(folder.join("out/frame-000005.png"), &Limits::default()).unwrap();
            let (mut dark, mut between) = (0, 0);
            for line in 0..SIZE[1] {
                let values = |name| &named(&waves, line, name).values;
                let codes = |name| values(name).iter().map(|value| (value + 0.5).floor() as u16);
                assert!(codes("vs.video.out").eq(new.line(line).iter().copied()), "{method:?} {line}");
                assert!(codes("vs.video.in").eq(old.line(line).iter().copied()), "{method:?} {line}");
                dark += values("vs.dark").iter().filter(|&&share| share > 0.5).count();
                between += values("vs.gate").iter().filter(|&&share| share > 0.0 && share < 1.0).count();
                if let Method::Synchronised { .. } = method {
                    let means = means(named(&waves, line, "vs.blank"));
                    let most = means.iter().zip(values("vs.dark")).map(|(a, b)| (a - b).abs());
                    assert!(most.fold(0.0, f64::max) < 1e-12, "{method:?} {line}");
                }
            }
            assert!(dark > 100 && (between > 100) == penumbra, "{method:?}: {dark} dark, {between} between");
        }
    }
}

/// A wall before the eye, its sun behind it and 20 degrees aside: the shadow is a parallelogram that leans to starboard. Through
/// both methods, the tube's by the lines that it is written with.
#[test]
fn the_gate_of_a_wall_switches_where_the_closed_form_does() {
    let (low, high) = (DVec3::new(6.0, -1.4, 0.0), DVec3::new(6.1, 1.0, 4.0));
    let (aside, along) = sin_cos(radians(20.0));
    let [reach_x, reach_y] = [along, aside].map(|part| 4.0 / libm::tan(radians(30.0)) * part);
    // Places of both edges, as shares of the width, on the line whose middle has this share of the height.
    let edges = |share: f64| {
        // What a line sees of the ground lies straight across, as far ahead as it lies below the horizon.
        let north = EYE / (0.268 * (2.0 * share - 1.0));
        let [near, far] = [(north - high.x) / reach_x, (north - low.x) / reach_x];
        let places = [low.y + near * reach_y, high.y + far * reach_y];
        (near > 0.0 && far < 1.0).then(|| places.map(|east| 0.5 + 0.5 * east / north / 0.466))
    };
    let tube = Method::ScanConverter(ScanConverter { registration: [0.1, 0.2], ..ScanConverter::default() });
    for (method, lines) in [(Method::Synchronised { dac_bits: 10 }, 60), (tube, 650)] {
        let folder = Folder::new();
        let row = |frame: u32| format!("{frame},{frame},10,20,{EYE},0,0,0\n");
        folder.poses(&(4..7).map(row).collect::<String>());
        let wall = Shape::new(vec![Solid::boxed(low, high, 1.0).unwrap()], EYE);
        let waves = looked(&folder, &augmentation(wall, flat_ground(), method), ALL);
        let mut checked = 0;
        for line in 0..SIZE[1] {
            let written = (line as f64 + 0.5) / 60.0 * f64::from(lines);
            let Some(places) = edges((written.floor() + 0.5) / f64::from(lines)) else { continue };
            let expect = |name: &str, places: [f64; 2]| {
                let wave = named(&waves, line, name);
                assert_eq!(wave.values, [0.0, 1.0, 0.0], "{name} of line {line}");
                for (found, place) in wave.times[1..].iter().zip(places) {
                    let expected = place * SIZE[0] as f64;
                    assert!(
                        (found - expected).abs() < 1e-9,
                        "{name} of line {line}: {found}, not {expected}"
                    );
                }
            };
            expect("vs.gate", places);
            if method != tube {
                expect("vs.blank", places.map(|place| (place * 1024.0).round() / 1024.0));
            }
            checked += 1;
        }
        assert!(checked > 10, "{checked} lines");
    }
}

/// A patch of track across the way, no vehicle: tracks are all there is, from edge to edge.
#[test]
fn tracks_have_a_gate_of_their_own() {
    let folder = Folder::new();
    let row = |frame: u32| format!("{frame},{frame},240,240,{EYE},0,-30,0\n");
    folder.poses(&(4..7).map(row).collect::<String>());
    let patch = |laid: f64, east: f64| {
        let corners = [[1.0, 0.0], [1.0, 0.3], [0.0, 0.3], [0.0, 0.0]];
        TrackPatch { laid, corners: corners.map(|[x, y]| [242.0 + x, 240.0 + east + y]) }
    };
    let ground = || {
        let stage = stage(&flat(), Scenery::still(sun(200.0, 30.0)), SIZE.map(|count| count as u32));
        Box::new(TrueGround::new(stage).unwrap())
    };
    let wires = |tracks: Vec<TrackPatch>, method| {
        let law = GroundLaw::True { ground: ground(), tracks };
        let wires = augmentation(Shape::new(Vec::new(), EYE), law, method).wires(Depth::Eight);
        wires.iter().map(|wire| wire.signal.name).collect::<Vec<_>>()
    };
    let synchronised = Method::Synchronised { dac_bits: 10 };
    let both = vec![patch(0.0, 0.2), patch(9.0, -0.5)];
    assert_eq!(wires(both.clone(), synchronised), SIGNALS.map(|signal| signal.name));
    let tube = wires(Vec::new(), Method::ScanConverter(ScanConverter::default()));
    assert_eq!(tube, ["vs.video.in", "vs.gate", "vs.dark", "vs.video.out"]);
    // Frame 5 comes at 5 s: the second patch is not laid yet.
    let law = GroundLaw::True { ground: ground(), tracks: both };
    let waves = looked(&folder, &augmentation(Shape::new(Vec::new(), EYE), law, synchronised), ALL);
    let (sin, cos) = sin_cos(radians(30.0));
    let mut checked = 0;
    for line in 0..SIZE[1] {
        let [tracks, gate] = ["vs.tracks", "vs.gate"].map(|name| named(&waves, line, name));
        assert_eq!((&tracks.times, &tracks.values), (&gate.times, &gate.values), "line {line}");
        let y = 0.268 * (2.0 * line as f64 + 1.0 - 60.0) / 60.0;
        let depth = EYE / (sin + y * cos);
        let ahead = depth * (cos - y * sin);
        if !(2.001..2.999).contains(&ahead) {
            assert!(!(1.999..3.001).contains(&ahead) && tracks.values == [0.0], "line {line}: {tracks:?}");
            continue;
        }
        assert_eq!(tracks.values, [0.0, 1.0, 0.0], "line {line}");
        for (found, east) in tracks.times[1..].iter().zip([0.2, 0.5]) {
            let expected = SIZE[0] as f64 * (0.5 + 0.5 * east / depth / 0.466);
            assert!((found - expected).abs() < 1e-6, "line {line}: {found}, not {expected}");
        }
        checked += 1;
    }
    assert!(checked > 5, "{checked} lines");
}

/// Looking makes a picture again that is there, and leaves its bytes; lines and frames that nobody asked for are not recorded.
#[test]
fn looking_changes_nothing() {
    let folder = Folder::new();
    let rover = Shape::find("rover", EYE).unwrap();
    let augmentation = augmentation(rover, flat_ground(), Method::Synchronised { dac_bits: 10 });
    assert_eq!(looked(&folder, &augmentation, 0..0), []);
    let bytes = fs::read(folder.join("out/frame-000005.png")).unwrap();
    let waves = looked(&folder, &augmentation, 40..42);
    assert_eq!(waves.len(), 2 * 5);
    assert!(waves.iter().all(|wave| wave.frame == 5 && [40, 41].contains(&wave.sweep)));
    assert_eq!(fs::read(folder.join("out/frame-000005.png")).unwrap(), bytes);
    assert_eq!(looked(&folder, &augmentation, 40..42), waves);
}
