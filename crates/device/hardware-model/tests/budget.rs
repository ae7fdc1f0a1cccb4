//! The timing budget gives the numbers of the reference (hardware section 4).

use hardware_model::{Budget, GroundScale, HardwareModel, ModelSource};

/// Blanking of a television raster of so many lines (hardware 4.1).
fn blanking(sweeps: u32) -> f64 {
    if sweeps == 525 { 0.172 } else { 0.21 }
}

fn with(sets: &[(&str, String)]) -> HardwareModel {
    let sets: Vec<(String, String)> =
        sets.iter().map(|(key, value)| ((*key).into(), value.clone())).collect();
    let ideal = ModelSource::BuiltIn("ideal".into());
    HardwareModel::load(&ideal, &[], &sets).unwrap_or_else(|list| panic!("{list}")).model
}

/// A machine of that raster at a machine unit of 10 V, with further settings.
fn raster(sweeps: u32, update: u32, more: &[(&str, &str)]) -> HardwareModel {
    let mut sets = vec![
        ("raster.sweeps", sweeps.to_string()),
        ("raster.update_hz", update.to_string()),
        ("raster.refresh_hz", update.to_string()),
        ("raster.blanking_fraction", blanking(sweeps).to_string()),
        ("analog.full_scale_v", "10".into()),
    ];
    sets.extend(more.iter().map(|(key, value)| (*key, (*value).to_owned())));
    with(&sets)
}

fn budget(sweeps: u32, update: u32, range: f64, region_size: f64) -> Budget {
    raster(sweeps, update, &[]).budget(GroundScale { region_size, range })
}

/// Whether a value is the printed one. The tables are made from the drawn time of a sweep to three digits, 0.4 % at
/// most, and are themselves rounded.
#[track_caller]
fn assert_printed(value: f64, printed: &str) {
    let number: f64 = printed.parse().unwrap();
    let decimals = printed.split_once('.').map_or(0, |(_, decimals)| decimals.len());
    let unit = (0..decimals).fold(1.0, |unit, _| unit / 10.0);
    assert!((value - number).abs() <= 0.501 * unit + 0.004 * number, "{value} for {printed}");
}

#[test]
fn table_4_1_sweeps() {
    for (sweeps, update, period, active, sample, video) in [
        (525, 10, "190.5", "158", "158", "3.2"),
        (525, 30, "63.49", "52.6", "52.6", "9.5"),
        (525, 60, "31.75", "26.3", "26.3", "19"),
        (1000, 10, "100", "79", "79", "6.3"),
        (1000, 30, "33.33", "26.3", "26.3", "19"),
        (1000, 60, "16.67", "13.2", "13.2", "38"),
    ] {
        let sweep = budget(sweeps, update, 5000.0, 200.0).sweep;
        assert_printed(1e6 * sweep.period, period);
        assert_printed(1e6 * sweep.active, active);
        assert_printed(1e9 * sweep.sample, sample);
        assert_printed(1e-6 * sweep.video_bandwidth, video);
    }
}

/// The greatest number that a simulation found has up to two crossings more than the closed form: a sweep that does
/// not begin on a boundary.
#[test]
fn table_4_2_crossings() {
    for (range, region_size, mean, worst) in [
        (5e3, 200.0, "31.8", 37.0),
        (5e3, 300.0, "21.2", 25.0),
        (5e3, 500.0, "12.7", 15.0),
        (5e4, 200.0, "318", 355.0),
        (5e4, 500.0, "127", 142.0),
        (5e4, 2000.0, "31.8", 37.0),
    ] {
        let crossings = budget(525, 30, range, region_size).crossings;
        assert_printed(crossings.mean, mean);
        assert!(crossings.worst <= worst && worst <= crossings.worst + 2.0, "{worst}");
    }
}

#[test]
fn table_4_3_rates() {
    let rows = "
        525 10 5000 200 32 6.32 4.96 1.6 3.6 7.3
        525 10 5000 500 32 15.8 12.4 0.63 1.5 2.9
        525 30 5000 200 95 2.10 1.65 4.8 10.9 21.8
        525 30 5000 500 95 5.26 4.13 1.9 4.4 8.7
        525 30 50000 500 951 0.53 0.41 19 43.6 87
        525 30 50000 2000 951 2.10 1.65 4.8 10.9 21.8
        1000 30 5000 200 190 1.05 0.83 9.5 21.8 43.6
        525 60 5000 200 190 1.05 0.83 9.5 21.8 43.6
        1000 30 5000 500 190 2.63 2.07 3.8 8.7 17.4
        1000 30 50000 500 1901 0.26 0.21 38 87 174
        1000 60 5000 200 379 0.53 0.42 19 43 87
        1000 60 5000 500 379 1.32 1.04 7.6 17 35
        1000 60 50000 500 3788 0.13 0.10 76 174 347";
    for row in rows.lines().skip(1) {
        let cells: Vec<&str> = row.split_whitespace().collect();
        let [sweeps, update, range, region_size] =
            [0, 1, 2, 3].map(|index: usize| cells[index].parse::<u32>().unwrap());
        let found = budget(sweeps, update, range.into(), region_size.into()).crossings;
        let values = [found.rate, 1e12 * found.axis, 1e12 * found.interval, found.ramp];
        let words = [found.words_used, found.words_loaded];
        for (value, printed) in values.iter().chain(&words).zip(&cells[4..]) {
            assert_printed(1e-6 * value, printed);
        }
    }
}

#[test]
fn table_4_5_tears() {
    let rows = [
        (525, 5000.0, 500.0, ["0.12", "0.30", "1.2"]),
        (525, 5000.0, 300.0, ["0.34", "0.84", "3.4"]),
        (525, 5000.0, 200.0, ["0.76", "1.9", "7.6"]),
        (1000, 5000.0, 200.0, ["1.5", "3.8", "15"]),
    ];
    for (sweeps, range, region_size, printed) in rows {
        for (urgent, printed) in ["100", "250", "1000"].iter().zip(printed) {
            let model = raster(sweeps, 30, &[("loader.access_ns", urgent)]);
            assert_printed(model.budget(GroundScale { region_size, range }).loader.late, printed);
        }
    }
    let far = raster(1000, 30, &[("loader.access_ns", "100")]);
    let far = far.budget(GroundScale { region_size: 500.0, range: 5e4 });
    assert_printed(far.loader.late, "24");
    // Beyond it every crossing is late.
    let slow = raster(1000, 30, &[("loader.access_ns", "1000")]);
    let slow = slow.budget(GroundScale { region_size: 500.0, range: 5e4 });
    assert_eq!(slow.loader.late, slow.crossings.mean);
}

/// Lateness against the height step: e = 0.1, 0.2, 0.5 of a region.
#[test]
fn table_4_5_steps() {
    for (share, step) in [(0.1, 8.6e-3), (0.2, 0.058), (0.5, 0.5)] {
        let axis = budget(1000, 30, 5000.0, 200.0).crossings.axis;
        let model = raster(1000, 30, &[("loader.access_ns", &(1e9 * share * axis).to_string())]);
        let found = model.budget(GroundScale { region_size: 200.0, range: 5000.0 }).loader.step;
        assert!((found - step).abs() < 0.02 * step, "{found} for {step}");
    }
}

/// Percentages and multiples of table 4.6, whose crossings are rounded to whole ones: 13 and 32.
#[test]
fn table_4_6_processor() {
    let near = |share: f64, printed: f64, unit: f64| {
        assert!((share / unit - printed).abs() <= 0.51 + 0.02 * printed, "{} for {printed}", share / unit);
    };
    let usual = GroundScale { region_size: 200.0, range: 5000.0 };
    for (setup, shares) in
        [("50", [79.0, 150.0]), ("65", [102.0, 195.0]), ("14", [22.0, 42.0]), ("18", [28.0, 54.0])]
    {
        for (sweeps, printed) in [525, 1000].into_iter().zip(shares) {
            let model = raster(sweeps, 30, &[("cpu.sweep_setup_us", setup)]);
            near(model.budget(usual).cpu.sweep_setup, printed, 0.01);
        }
    }
    for (tables, printed) in [("2", 6.0), ("5", 15.0)] {
        near(
            raster(525, 30, &[("cpu.frame_tables_ms", tables)]).budget(usual).cpu.frame_tables,
            printed,
            0.01,
        );
    }
    near(raster(525, 30, &[("cpu.vertex_us", "90")]).budget(usual).cpu.hundred_vertices, 27.0, 0.01);
    let literal = ("loader.served_by", "cpu-interrupt");
    for (region_size, cost, words, interrupts, loads) in
        [(500.0, "25", "850", [5.0, 10.0], [6.0, 12.0]), (200.0, "35", "850", [18.0, 34.0], [16.0, 30.0])]
    {
        for (index, sweeps) in [525, 1000].into_iter().enumerate() {
            let one_by_one = ("loader.words_per_access", "1");
            let sets = [literal, one_by_one, ("cpu.interrupt_us", cost), ("loader.access_ns", words)];
            let cpu = raster(sweeps, 30, &sets).budget(GroundScale { region_size, range: 5000.0 }).cpu;
            near(cpu.interrupts, interrupts[index], 1.0);
            near(cpu.loads, loads[index], 1.0);
        }
    }
}

/// Corners of a sector, words, and time on a drum of 0.6 million words a second; new corners in a turn.
#[test]
fn table_4_7_drums() {
    let drum = [("drum.rotation_ms", "17.5"), ("drum.rate_mb_s", "1.2"), ("drum.record_words", "9")];
    for (range, region_size, corners, fill, turning) in [
        (2380.0, 200.0, 110.0, 1.7, 12.4),
        (5e3, 200.0, 370.0, 5.6, 55.0),
        (5e3, 300.0, 184.0, 2.8, 24.2),
        (5e3, 500.0, 82.0, 1.2, 9.0),
        (5e4, 2000.0, 363.0, 5.4, 55.0),
        (5e4, 500.0, 4721.0, 71.0, 873.0),
    ] {
        let found = raster(525, 30, &drum).budget(GroundScale { region_size, range }).drum.unwrap();
        // The table counted one place and heading.
        assert!((found.corners - corners).abs() < 0.03 * corners, "{} for {corners}", found.corners);
        assert!((1e3 * found.fill - fill).abs() < 0.03 * fill + 0.05, "{} for {fill}", found.fill);
        assert!((found.turning - turning).abs() < 0.04 * turning, "{} for {turning}", found.turning);
    }
    // Rate times latency: 55 a second, 8.75 ms and the record.
    let load =
        raster(525, 30, &drum).budget(GroundScale { region_size: 200.0, range: 5e3 }).drum.unwrap().load;
    assert!((load - 0.48).abs() < 0.01, "{load}");
    let blocks = raster(525, 30, &[drum[0], drum[1], ("drum.record_words", "576")]);
    assert!(blocks.budget(GroundScale { region_size: 200.0, range: 5e3 }).drum.unwrap().load < load / 40.0);
}

/// What hardware 7 expects of the shipped machines over the ground they are meant for.
#[test]
fn expectations_of_section_7() {
    let of = |name: &str, region_size: f64| {
        let model = HardwareModel::load(&ModelSource::BuiltIn(name.into()), &[], &[]).unwrap().model;
        let ground = GroundScale { region_size, ..model.usual_ground() };
        model.budget(ground)
    };
    let nominal = of("pra-nominal", 300.0);
    assert_printed(1e6 * nominal.crossings.interval, "2.48");
    assert_printed(1e6 * nominal.crossings.axis, "3.16");
    assert_printed(1e9 * nominal.loader.urgent, "250");
    assert_printed(nominal.loader.late, "0.84");
    // Late words are within their grace on the coarse ramp of its own programme, too.
    let grace = 0.1 * 300.0 / nominal.crossings.end_rate;
    assert!(nominal.loader.urgent < grace && grace < nominal.loader.grace && nominal.loader.load < 0.09);
    assert_printed(100.0 * nominal.cpu.sweep_setup, "25");
    assert_printed(100.0 * nominal.cpu.frame_tables, "15");
    let frugal = of("pra-frugal", 500.0);
    assert_printed(1e6 * frugal.sweep.period, "381");
    assert_printed(1e-6 * frugal.crossings.rate, "7.6");
    assert_printed(1e6 * frugal.crossings.interval, "52");
    // 36 x 0.96 + 2 = 37 µs a crossing, 71 % of the time, the urgent set 11 µs behind its fold; 0.96 is 1 by the clock.
    let crossing = frugal.loader.busy / frugal.crossings.mean;
    assert!((crossing - 38e-6).abs() < 1e-12, "{crossing}");
    assert!((0.7..0.75).contains(&frugal.loader.load), "{}", frugal.loader.load);
    assert!((10.6e-6..=11e-6).contains(&frugal.loader.urgent), "{}", frugal.loader.urgent);
    assert!((0.16..0.18).contains(&(frugal.loader.urgent / frugal.crossings.axis)));
    let overloaded = of("pra-overloaded", 200.0);
    assert_printed(overloaded.crossings.mean, "318");
    assert!((440.0..480.0).contains(&overloaded.cpu.interrupts), "{}", overloaded.cpu.interrupts);
    assert!((590.0..630.0).contains(&overloaded.cpu.loads), "{}", overloaded.cpu.loads);
    assert_eq!(of("modern-analog", 100.0).loader.late, 0.0);
}

/// Four drums fill a sector in a quarter of the time of one; on two channels half as fast, and slower ones take their time.
#[test]
fn channels_share_out_what_drums_bring() {
    let fill = |channels: &[(&str, &str)]| {
        let drums = [("drum.rotation_ms", "17.4"), ("drum.rate_mb_s", "1.2"), ("drum.count", "4")];
        let model = raster(525, 30, &[&drums, channels].concat());
        model.budget(model.usual_ground()).drum.unwrap().fill
    };
    let own = fill(&[]);
    assert_eq!(fill(&[("channel.count", "4"), ("channel.rate_mb_s", "3")]), own);
    assert!((fill(&[("channel.count", "2")]) / own - 2.0).abs() < 1e-12);
    assert!((fill(&[("channel.count", "2"), ("channel.rate_mb_s", "0.4")]) / own - 6.0).abs() < 1e-12);
}

/// Steps of the last sample: 5 m, ln(5000 / 1.5) / 999 of 5 km, 1/z linear from 1.5 m to 5 km.
#[test]
fn programmes_end_at_their_own_rates() {
    for (programme, step) in [("constant-rate", 5.0), ("geometric", 40.44), ("constant-elevation", 3846.8)] {
        let model = raster(1000, 30, &[("range.programme", programme)]);
        let budget = model.budget(GroundScale { region_size: 300.0, range: 100.0 });
        let found = budget.crossings.end_rate * budget.sweep.sample;
        assert!((found - step).abs() < 0.01 * step, "{programme}: {found} for {step}");
    }
}

#[test]
fn lines_are_for_people_and_programs() {
    let model = raster(525, 30, &[("drum.rotation_ms", "17.4"), ("drum.rate_mb_s", "1.2")]);
    let budget = model.budget(model.usual_ground());
    let keys: std::collections::BTreeSet<&str> = budget.lines().iter().map(|line| line.key).collect();
    assert_eq!(keys.len(), budget.lines().len());
    assert!(budget.lines().iter().all(|line| line.value.is_finite() && !line.meaning.is_empty()));
    let text = budget.to_string();
    assert!(text.lines().any(|line| line.contains("sweep period") && line.contains("63.49 µs")), "{text}");
    assert_eq!(text.lines().count(), keys.len());
}
