//! What the digital side cannot do in time.

use super::{Check, Grade, short};
use crate::budget::sector_corners;
use crate::{BankPlace, CrossingServer, LatePolicy, LoadDelay};

pub(super) fn check(check: &mut Check) {
    late_words(check);
    loader_switched_off(check);
    idle_policy(check);
    idle_delays(check);
    processor(check);
    drums(check);
    update(check);
}

fn late_words(check: &mut Check) {
    let (loader, model) = (check.budget.loader, check.model);
    let artefact = match model.loader.late_policy {
        LatePolicy::StrobeThrough => "A1",
        LatePolicy::Latched => "A2",
    };
    let is_late = loader.urgent > loader.grace && !model.loader.diagonal_register;
    let keys = ["loader.access_ns", "loader.pointer_ns", "loader.strobe_ns"];
    check.warn_if(is_late, artefact, &keys, || {
        format!(
            "the urgent set comes up to {} ns after its fold and may be {} ns late unseen; {} late sets a sweep",
            short(1e9 * loader.urgent),
            short(1e9 * loader.grace),
            short(loader.late)
        )
    });
    check.warn_if(loader.load > 1.0, artefact, &["loader.access_ns", "loader.words_per_access"], || {
        format!("the sets of a sweep keep the buffer busy for {} its drawn time", times(loader.load))
    });
}

fn loader_switched_off(check: &mut Check) {
    let Some(last) = check.model.loader.stop_after_crossings else { return };
    check.warn_if(true, "A3", &["loader.stop_after_crossings"], || {
        format!("nothing is transferred after {last} crossings of a sweep")
    });
}

fn idle_policy(check: &mut Check) {
    let loader = &check.model.loader;
    let is_so = loader.diagonal_register && loader.late_policy == LatePolicy::Latched;
    check.push_if(is_so, Grade::Warn(None), &["loader.late_policy", "loader.diagonal_register"], || {
        "latches for late words beside a register that leaves no urgent word late: the policy is of no use".into()
    });
}

fn idle_delays(check: &mut Check) {
    let sweeps = check.model.raster.sweeps;
    for delay in &check.model.loader.delays {
        let LoadDelay { sweep, word, ticks, .. } = *delay;
        let [p, q] = [word / 3, word % 3];
        check.push_if(sweep >= sweeps, Grade::Warn(None), &["loader.delay", "raster.sweeps"], || {
            format!(
                "word [{p}, {q}] is held back in sweep {sweep}, and a frame has sweeps 0..{sweeps}: the delay never meets \
                 its word"
            )
        });
        check.push_if(ticks == 0, Grade::Warn(None), &["loader.delay"], || {
            format!(
                "word [{p}, {q}] of sweep {sweep} is held back by no tick: it comes as if there were no delay"
            )
        });
    }
}

fn processor(check: &mut Check) {
    let (cpu, model, period) = (check.budget.cpu, check.model, check.budget.sweep.period);
    check.warn_if(cpu.sweep_setup > 1.0, "A26", &["cpu.sweep_setup_us"], || {
        format!("a sweep is set up in {} its period of {} µs", times(cpu.sweep_setup), short(1e6 * period))
    });
    let others = cpu.total - cpu.sweep_setup;
    check.warn_if(cpu.sweep_setup <= 1.0 && cpu.total > 1.0, "A26", &["cpu.frame_tables_ms"], || {
        format!(
            "beside sweeps ({}) the processor is busy for {} its time",
            times(cpu.sweep_setup),
            times(others)
        )
    });
    let is_interrupted = model.loader.served_by == CrossingServer::CpuInterrupt;
    let waits = is_interrupted && model.cpu.priority_levels == Some(1) && model.cpu.sweep_setup > 0;
    check.warn_if(waits, "A1", &["cpu.priority_levels", "loader.served_by"], || {
        "with one level the interrupt of a crossing waits until the next sweep is set up".into()
    });
}

fn drums(check: &mut Check) {
    let (frame, buffer) = (check.budget.sweep.frame, check.model.data_banks.buffer_words);
    let Some(drum) = check.budget.drum else { return };
    check.warn_if(drum.fill > frame, "A5", &["drum.rate_mb_s"], || {
        let (fill, frame) = (short(1e3 * drum.fill), short(1e3 * frame));
        format!("after a snap turn the drums need {fill} ms for one sector, a frame has {frame} ms")
    });
    // Features, shadows and bodies have records of their own: half is too much for the terrain (hardware 4.7).
    check.warn_if(drum.load > 0.5, "A5", &["drum.rotation_ms", "drum.record_words"], || {
        format!(
            "a turn at 10 degrees/s keeps the drums busy for {} their time with terrain alone",
            times(drum.load)
        )
    });
    let kinds = check.model.kind_banks.kinds();
    let beside = kinds.iter().filter(|(_, bank)| bank.place == BankPlace::Together).count();
    let load = drum.load * (1 + beside) as f64;
    check.warn_if(beside > 0 && load > 1.0, "A5", &["drum.rotation_ms", "drum.record_words"], || {
        format!(
            "a turn at 10 degrees/s asks the drums for {} their time with {} kinds of data on them, if each region has a \
             record of each kind",
            times(load),
            1 + beside
        )
    });
    let words = 9.0 * sector_corners(check.budget.ground);
    check.warn_if(buffer.is_some_and(|held| f64::from(held) < words), "A5", &["buffer.words"], || {
        format!("a sector has {} words, the buffer holds {}", words.round(), buffer.unwrap_or_default())
    });
}

/// Ten new pictures a second are the report's floor (II.C).
fn update(check: &mut Check) {
    let raster = &check.model.raster;
    let shows = raster.refresh.hertz() / raster.update.hertz();
    let is_slow = raster.update.hertz() < 10.0 || shows >= 4.0;
    check.warn_if(is_slow, "A24", &["raster.update_hz", "raster.refresh_hz"], || {
        format!(
            "each picture is shown {} times, {} new ones a second; the report's floor is 10",
            short(shows),
            short(raster.update.hertz())
        )
    });
}

/// A share as a multiple: `0.6 times`.
fn times(share: f64) -> String {
    format!("{share:.2} times")
}
