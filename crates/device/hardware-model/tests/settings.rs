//! What a run comes to: wishes, then the model; what does not fit is refused.

use hardware_model::{HardwareModel, Settings, SettingsError, SweepMemoryKind};
use quantities::Rate;
use scenario::{
    Display, FieldOfView, LawWishes, Occlusion, Projection, RangeLaw, RangeProgramme, RasterWishes, Scalar,
};

const FIELD: FieldOfView = FieldOfView { tan_half_width: 0.466_307_658, tan_half_height: 0.267_949_192 };
const DISPLAY: Display = Display { white: 1.0, gamma: 1.0 };

fn hz(rate: u64) -> Option<Rate> {
    Rate::new(rate, 1)
}

fn resolve(model: &HardwareModel, wishes: RasterWishes) -> Result<Settings, SettingsError> {
    Settings::resolve(model, FIELD, wishes, None, LawWishes::default(), Scalar::F32, DISPLAY)
}

#[test]
fn without_wishes_the_model_decides() {
    let model = HardwareModel::ideal();
    let settings = resolve(&model, RasterWishes::default()).unwrap();
    let raster = settings.raster;
    assert_eq!((raster.sweeps, raster.samples, raster.columns), (1000, 1000, 1000));
    // Square pixels: 1000 tan 15 deg / tan 25 deg = 574.6.
    assert_eq!((raster.lines, raster.refresh), (575, model.raster.refresh));
    assert_eq!((settings.range, settings.laws), (model.range, model.laws));
    assert_eq!(settings.timebase.retrace_samples, 0);
    assert_eq!(settings.timebase.sample_rate(), Rate::new(30_000_000, 1).unwrap());
}

#[test]
fn wishes_go_before_the_model() {
    let model = HardwareModel::ideal();
    let wishes = RasterWishes {
        sweeps: Some(525),
        samples: Some(800),
        columns: Some(640),
        lines: Some(480),
        update: hz(10),
        refresh: hz(60),
    };
    let range = RangeProgramme { law: RangeLaw::ConstantRate, start: 1.0, end: 300.0 };
    let laws = LawWishes { projection: Some(Projection::AsReported), ..LawWishes::default() };
    let display = Display { white: 0.4, gamma: 2.2 };
    let settings = Settings::resolve(&model, FIELD, wishes, Some(range), laws, Scalar::F64, display).unwrap();
    let raster = settings.raster;
    assert_eq!((raster.sweeps, raster.samples, raster.columns, raster.lines), (525, 800, 640, 480));
    assert_eq!((Some(settings.timebase.update), Some(raster.refresh)), (hz(10), hz(60)));
    assert_eq!((settings.range, settings.scalar, settings.display), (range, Scalar::F64, display));
    assert_eq!(
        (settings.laws.projection, settings.laws.occlusion),
        (Projection::AsReported, Occlusion::PeakHold)
    );
}

#[test]
fn the_command_line_goes_before_the_scenario() {
    let scenario = RasterWishes { sweeps: Some(525), lines: Some(300), ..RasterWishes::default() };
    let command = RasterWishes { sweeps: Some(100), ..RasterWishes::default() };
    let settings = resolve(&HardwareModel::ideal(), command.or(scenario)).unwrap();
    assert_eq!((settings.raster.sweeps, settings.raster.columns, settings.raster.lines), (100, 100, 300));
}

#[test]
fn retrace_is_the_share_of_the_whole_sweep() {
    let mut model = HardwareModel::ideal();
    model.raster.blanking_fraction = 0.2;
    let timebase = resolve(&model, RasterWishes::default()).unwrap().timebase;
    assert_eq!((timebase.retrace_samples, timebase.sweep_samples()), (250, 1250));
}

#[test]
fn counts_have_bounds() {
    let model = HardwareModel::ideal();
    let wish = RasterWishes::default();
    let cases = [
        ("raster.sweeps", RasterWishes { sweeps: Some(0), ..wish }, 0, 1, 8192),
        ("raster.sweeps", RasterWishes { sweeps: Some(8193), ..wish }, 8193, 1, 8192),
        ("raster.samples", RasterWishes { samples: Some(1), ..wish }, 1, 2, 65_536),
        ("raster.samples", RasterWishes { samples: Some(65_537), ..wish }, 65_537, 2, 65_536),
        ("raster.columns", RasterWishes { columns: Some(0), ..wish }, 0, 1, 8192),
        ("raster.lines", RasterWishes { lines: Some(0), ..wish }, 0, 1, 8192),
        ("raster.lines", RasterWishes { lines: Some(9000), ..wish }, 9000, 1, 8192),
    ];
    for (key, wishes, found, low, high) in cases {
        assert_eq!(resolve(&model, wishes), Err(SettingsError::Count { key, found, low, high }));
    }
    assert!(resolve(&model, RasterWishes { sweeps: Some(8192), samples: Some(2), ..wish }).is_ok());
}

#[test]
fn one_sweep_has_at_least_one_line() {
    let wishes = RasterWishes { sweeps: Some(1), ..RasterWishes::default() };
    assert_eq!(resolve(&HardwareModel::ideal(), wishes).unwrap().raster.lines, 1);
}

#[test]
fn refresh_is_a_multiple_of_update() {
    let wish = |update, refresh| RasterWishes { update, refresh, ..RasterWishes::default() };
    let model = HardwareModel::ideal();
    assert!(resolve(&model, wish(hz(20), hz(60))).is_ok());
    // The scenario's update against the model's refresh of 30.
    let error = resolve(&model, wish(hz(20), None)).unwrap_err();
    assert_eq!(error, SettingsError::Refresh { refresh: hz(30).unwrap(), update: hz(20).unwrap() });
    assert!(
        error.to_string().contains("30 Hz: expected a whole multiple of the update rate 20 Hz"),
        "{error}"
    );
    assert!(resolve(&model, wish(hz(60), hz(30))).is_err());
}

#[test]
fn a_digital_memory_reads_the_raster_it_was_written_in() {
    let model = HardwareModel { sweep_memory: SweepMemoryKind::DigitalMemory, ..HardwareModel::ideal() };
    assert!(resolve(&model, RasterWishes::default()).is_ok());
    let wider = RasterWishes { columns: Some(1200), ..RasterWishes::default() };
    let expected = SettingsError::DigitalRaster { columns: 1200, sweeps: 1000 };
    assert_eq!(resolve(&model, wider), Err(expected));
}

#[test]
fn clocks_must_fit() {
    let wishes = RasterWishes {
        update: Rate::new(u64::MAX, 1),
        refresh: Rate::new(u64::MAX, 1),
        ..RasterWishes::default()
    };
    assert!(matches!(resolve(&HardwareModel::ideal(), wishes), Err(SettingsError::Timebase(_))));
}
