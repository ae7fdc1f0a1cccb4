//! A run folder made by hand: small frames, every one of another grey.

use std::collections::BTreeMap;
use std::fs;
use std::path::{Path, PathBuf};

use picture::{Depth, GreyPicture, write_png};
use replay::{SCOPES, picture_name};
use report::{Beside, DeadlineLine, ScopePlot, Sight, SightLine, SweepWaves, TimingSummary, UnitLine, Wave};
use run_record::file_hash;
use serde_json::{Value, json};
use tempfile::TempDir;
use timing::{Cause, Deadline, Sets, Slack};

pub const COLUMNS: usize = 64;
pub const LINES: usize = 36;
pub const SWEEPS: u32 = 32;
/// Angle of the yoke in every frame (rad).
pub const YOKE: f64 = 0.2;

/// A folder of a finished run.
pub struct RunFolder {
    folder: TempDir,
    pub record: Value,
}

impl RunFolder {
    /// `frames` frames, from `first` on.
    pub fn new(first: u64, frames: u64) -> Self {
        let folder = tempfile::tempdir().unwrap();
        fs::create_dir(folder.path().join("frames")).unwrap();
        let run = Self { record: record(first, frames), folder };
        let mut poses = String::from(
            "frame,t_s,x_m,y_m,z_m,heading_deg,pitch_deg,roll_deg,speed_m_s,turn_deg_s,slope_deg\n",
        );
        for frame in first..first + frames {
            let codes =
                (0..COLUMNS * LINES).map(|at| ((at % COLUMNS) as u64 * 3 + frame) as u16 % 256).collect();
            let picture = GreyPicture::new(COLUMNS, LINES, Depth::Eight, codes).unwrap();
            write_png(run.join(&picture_name(frame)), &picture, &[]).unwrap();
            let at = frame as f64;
            poses += &format!("{frame},{},{},{},1.6,90,-2.5,0.25,0,0,0\n", 0.1 * at, 100.0 + at, 200.0 - at);
        }
        fs::write(run.join("poses.csv"), poses).unwrap();
        run.write_record();
        run
    }

    /// Puts frames in colour in place of the grey ones.
    pub fn paint(&self) {
        for frame in self.record["frames"].as_array().unwrap() {
            let path = self.join(&picture_name(frame["frame"].as_u64().unwrap()));
            let grey = picture::read_png(&path, &picture::Limits::default()).unwrap();
            write_png(&path, &grey.to_colour(), &[]).unwrap();
        }
    }

    pub fn path(&self) -> &Path {
        self.folder.path()
    }

    pub fn join(&self, name: &str) -> PathBuf {
        self.path().join(name)
    }

    pub fn write_record(&self) {
        fs::write(self.join("run.json"), self.record.to_string()).unwrap();
    }

    /// The page as it stands now.
    pub fn page(&self) -> String {
        let path = report::write_page(self.path()).unwrap();
        fs::read_to_string(path).unwrap()
    }

    /// What a replay of the hybrid machine leaves beside the record, with one plot for each of `scopes`.
    pub fn beside(&self, scopes: &[(u64, u32)]) -> Beside {
        let mut beside = Beside::new(self.record["fingerprint"].as_str().unwrap());
        let frames = self.record["frames"].as_array().unwrap().len();
        let first = self.record["frames"][0]["frame"].as_u64().unwrap();
        beside.stage = ["scenarios/it's.toml", "--sweeps", "32"].map(str::to_owned).into();
        let line = SightLine { edge: 0.5, pitch: [0.1, 0.9], yoke: YOKE };
        beside.sight = Some(Sight {
            tube: true,
            sweeps: SWEEPS,
            field: [0.4, 0.225],
            raster: 0.45,
            first,
            frames: vec![line; frames],
        });
        beside.timing = Some(timing(first));
        fs::create_dir_all(self.join(SCOPES)).unwrap();
        scopes.iter().for_each(|&(frame, sweep)| self.add_plot(&mut beside, frame, sweep));
        beside.write(self.path()).unwrap();
        beside
    }

    fn add_plot(&self, beside: &mut Beside, frame: u64, sweep: u32) {
        let mut plot = ScopePlot {
            frame,
            sweep,
            asked: vec!["tg.*".into()],
            signals: vec!["tg.height".into()],
            blake3: String::new(),
        };
        let path = self.join(&plot.file());
        let svg = format!(
            "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"90\" height=\"40\" viewBox=\"0 0 90 40\">\
             <style>@media (prefers-color-scheme:dark){{[fill=\"#ffffff\"]{{fill:#12151a}}}}</style>\
             <path d=\"M0 0H90V40H0Z\" fill=\"#ffffff\"/><text x=\"4\" y=\"20\">{frame} {sweep}</text></svg>"
        );
        fs::write(&path, svg).unwrap();
        plot.blake3 = file_hash(&path).unwrap();
        beside.add(plot, Some(waves(frame, sweep)));
    }
}

/// Number of samples of a recorded sweep.
const SAMPLES: u32 = 80;

/// A height of 2 m a sample from 10 m on, with no number at the last sample; a doubled height; and a gate that opens at sample 20.
fn waves(frame: u64, sweep: u32) -> SweepWaves {
    let samples = || (0..SAMPLES).map(|sample| sample as f32);
    let value = |value: f32, sample: f32| (sample as u32 + 1 < SAMPLES).then_some(value);
    let analog = |name: &str, times: f32| Wave {
        name: name.into(),
        unit: "m".into(),
        kind: "analog".into(),
        times: Vec::new(),
        values: samples().map(|sample| value(times * (10.0 + 2.0 * sample), sample)).collect(),
    };
    let gate = Wave {
        name: "sc.gate".into(),
        unit: "1".into(),
        kind: "gate".into(),
        times: vec![0.0, 20.0],
        values: vec![Some(0.0), Some(1.0)],
    };
    SweepWaves {
        frame,
        sweep,
        sample_us: 0.5,
        place: "sweep.range".into(),
        places: samples().map(|sample| 3.0 * sample).collect(),
        signals: vec![analog("tg.height", 1.0), analog("mu.height", 2.0), gate],
    }
}

fn record(first: u64, frames: u64) -> Value {
    let frame = |frame: u64| {
        json!({ "frame": frame, "time_s": 0.1 * frame as f64, "pixels_blake3": "p",
                "files": [{ "file": picture_name(frame), "blake3": "f" }], "counts": {} })
    };
    let omission = |block: &str, what: &str, weight: Value| json!({ "block": block, "what": what, "why": "the ground has none & <never>", "weight": weight });
    json!({
        "schema": "lunoid.run/2",
        "format": 1,
        "fingerprint": "0123456789abcdef",
        "program": { "name": "lunoid", "version": "1.2.3", "commit": "c0ffee", "result_family": "unfused" },
        "scenario": { "file": { "file": "scenarios/it's.toml", "blake3": "b" }, "title": "A <bump> & more",
                      "shows": "\"Nothing\" </script><b>but</b> a test." },
        "references": [],
        "generator": "hybrid",
        "line": "sweep",
        "model": { "name": "pra-nominal", "files": [], "values": [
            { "key": "raster.sweeps", "value": "<32>", "origin": "hardware-models/ideal.toml:8" }] },
        "ground": { "source": "generated", "title": "G", "content_blake3": "g", "albedo": 1.0, "generator": null,
                    "levels": [{ "region_size_m": 50.0, "origin_m": [0.0, 0.0], "corners": [9, 9] }] },
        "scenery": { "craters": 0, "rock_bodies": 0, "culture_bodies": 0, "track_patches": 0, "silhouettes": 0,
                     "texture": false, "photometry": "Lambert", "blake3": "s" },
        "sun": { "azimuth_deg": 100.0, "elevation_deg": 15.0 },
        "vehicle": { "eye_height_m": 1.6, "wheelbase_m": 2.3, "track_m": 1.8, "max_speed_m_s": 5.0,
                     "max_turn_deg_s": 10.0, "max_slope_deg": 25.0 },
        "path": { "waypoints": 2, "waypoints_blake3": "w" },
        "view": view(),
        "settings": settings(),
        "pictures": { "kind": "grey PNG", "depth": 8, "one_file_for_each": "update" },
        "omissions": [
            omission("shadow-controller", "line generators and VS2", json!("lossless")),
            omission("polyhedron-generator", "small rocks", json!({ "bounded_grey_levels_of_255": 2.5 })),
        ],
        "limits": [{ "limit": "speed", "unit": "m/s", "allowed": 5.0, "found": 7.25, "frame": 1, "time_s": 0.1, "frames": [1, 4] }],
        "totals": { "sweeps": 12_345, "late_words": 0 },
        "range": [first, first + frames],
        "frames": (first..first + frames).map(frame).collect::<Vec<_>>(),
        "outputs": [{ "file": "poses.csv", "blake3": "h" }],
    })
}

fn view() -> Value {
    json!({
        "columns": COLUMNS, "lines": LINES, "field_of_view_deg": [43.602_818_972_703_6, 25.360_765_745_8],
        "update": "10 Hz", "refresh": "30 Hz", "display": { "white": 1.0, "gamma": 1.0 },
        "laws": { "projection": "exact" }, "ranges_m": [2.0, 300.0], "yoke": null, "levels": null, "shadows": null,
    })
}

/// Settings of the hybrid machine.
fn settings() -> Value {
    json!({
        "scalar": "f32",
        "raster": { "sweeps": SWEEPS, "samples_per_sweep": 80 },
        "clocks": { "master": "20000000 Hz", "sample": "32000 Hz", "active_samples": 80, "retrace_samples": 0 },
        "range": { "programme": "geometric", "start_m": 2.0 },
        "cpu_ticks": {}, "data_banks_ticks": {}, "analog_si": {},
        "loader": {
            "served_by": "wired-pointers", "words_per_access": 9, "access_ticks": 0, "pointer_ticks": 0,
            "io_processor_ticks": {}, "strobe_ticks": 0, "urgent_first": true, "diagonal_register": false,
            "stop_after_crossings": null, "late_policy": "strobe-through", "delay": [],
        },
        "blocks": {
            "feature_generator": { "organisation": "scheduled", "sub_generators": null },
            "shadow_controller": { "variant": "digital", "line_generators": null },
            "mixing_unit": { "gate": "presence", "threshold": 0.0 },
        },
        "seed": 0, "sweep_memory": "scan-converter", "economy": "bounded",
    })
}

fn timing(frame: u64) -> TimingSummary {
    let mut slack = Slack::default();
    [40, 3, -6].into_iter().for_each(|ticks| slack.add(ticks));
    TimingSummary {
        frames: vec![frame],
        tick_s: 5e-8,
        ticks: 666_667,
        folds: 74_859,
        late_words: 9,
        sets: Sets { wanted: 400, loaded: 300, late: 1, wasted: 100, cancelled: 0 },
        deadlines: vec![DeadlineLine { deadline: Deadline::TRANSFER, slack, worst_frame: Some(frame) }],
        units: vec![UnitLine {
            unit: "loader.red".into(),
            least: 0.05,
            mean: 0.06,
            most: 1.25,
            longest_queue: 3,
        }],
        causes: BTreeMap::from([(Cause::Queue, 1)]),
        sweeps: vec![(7, 1)],
        late: vec![vec![7]],
    }
}
