//! scratch
use landscape::relief::*;
use landscape::*;
use plots::*;
fn main() {
    let d = 20.0; let ext = 4000.0;
    let u = Undulation { rms_height: 12.0, hurst: 0.85, longest: 3000.0, shortest: 3.0*d, waves: 600 };
    let c = Craters { smallest_radius: 1.5*d, largest_radius: 400.0, density: 0.08, subdued: 0.02, fresh: 0.18 };
    let m = |x: f64, y: f64, h: f64, r: f64| Massif { at: [x, y], height: h, radius: r, detail: 60.0, ruggedness: 0.7 };
    let massifs = vec![m(3300.0, 1500.0, 350.0, 1500.0), m(3600.0, 3200.0, 280.0, 1100.0), m(2900.0, 300.0, 200.0, 900.0)];
    let rilles = vec![Rille { through: [2000.0, 2000.0], azimuth: 1.2, width: 250.0, depth: 50.0, meander: Some(Meander { swing: 150.0, length: 1500.0 }) }];
    let l = Relief { undulation: Some(u), craters: Some(c), massifs, rilles, ..Relief::flat(1, [ext; 2], d) }.build().unwrap();
    let sun = Sun { azimuth: 1.4, elevation: 0.36 };
    let mut look = BankLook::titled("Front of the Apennines, seed 1");
    look.facts = vec!["height −51 to 352 m, 40 401 corners, 363 609 words (2.9 MB), content b8237a5e".into()];
    let t = std::time::Instant::now();
    bank_picture(&l, sun, &look).unwrap().write("/tmp/ground-bank.png").unwrap();
    println!("{:?}", t.elapsed());
    let small = Relief { undulation: Some(Undulation { rms_height: 2.0, hurst: 0.8, longest: 500.0, shortest: 150.0, waves: 200 }), ..Relief::flat(1, [300.0, 1500.0], 50.0) }.build().unwrap();
    let mut look = BankLook::titled("A strip of ground with its regions"); look.regions = true;
    bank_picture(&small, sun, &look).unwrap().write("/tmp/ground-strip.png").unwrap();
    let flat = Relief::flat(1, [100.0; 2], 50.0).build().unwrap();
    bank_picture(&flat, sun, &BankLook { longest: 300, ..BankLook::titled("flat") }).unwrap().write("/tmp/ground-flat.png").unwrap();
    // residuals
    let n = 400; let mut v = vec![];
    for r in 0..n { for c in 0..n {
        let (x, y) = (ext - (r as f64 + 0.5)*10.0, (c as f64 + 0.5)*10.0);
        let dd = ((x-2600.0).powi(2) + (y-1200.0).powi(2)).sqrt();
        let g = (0..12).map(|k| quantities::unit_interval(3, &[r, c, k])).sum::<f64>() - 6.0;
        v.push(if dd < 300.0 || x < 400.0 && y > 3000.0 { f64::NAN } else { 0.4*g + (x/150.0).sin()*(y/230.0).cos()*0.8 });
    }}
    let res = Residuals { first: [ext - 5.0, 5.0], spacing: [-10.0, 10.0], samples: [n as usize, n as usize], values: &v };
    let mut look = SurveyLook::titled("Survey of Kepler (LOLA 512 px/deg), 200 m regions");
    look.facts = vec!["400 × 400 samples of 10 m, 40 401 corners, 363 609 coefficients, 2.27 samples fewer than coefficients; regularisation 1e-4, 41 iterations".into()];
    let t = std::time::Instant::now();
    survey_picture(&l, sun, &res, &look).unwrap().write("/tmp/ground-survey.png").unwrap();
    println!("{:?}", t.elapsed());
    // traces
    let land = Landscape::new(Bank::new("x", vec![l], None).unwrap(), 1.0);
    let xs: Vec<f64> = (0..1000).map(|i| 2.0 * 1.00766f64.powi(i)).collect();
    let p: Vec<_> = xs.iter().map(|r| land.at(200.0 + r, 2000.0)).collect();
    let h: Vec<f64> = p.iter().map(|p| p.map_or(f64::NAN, |p| p.height)).collect();
    let s: Vec<f64> = p.iter().map(|p| p.map_or(f64::NAN, |p| sun.reflectivity(p.slopes))).collect();
    let u: Vec<f64> = xs.iter().map(|r| ((200.0 + r)/200.0).fract()).collect();
    let u2: Vec<f64> = xs.iter().map(|r| { let z = (200.0 + r)/200.0; if z as i64 % 2 == 0 { z.fract() } else { 1.0 - z.fract() } }).collect();
    let states: Vec<bool> = (0..999).map(|i| i / 90 % 2 == 0).collect();
    let st2: Vec<bool> = (0..999).map(|i| i / 37 % 3 == 0).collect();
    let panels = [
        Panel { axis: Axis::new("height (m)"), traces: vec![Trace { name: "tg.height", x: &xs, y: &h }] },
        Panel { axis: Axis::new("reflectivity").over([0.0, 1.0]), traces: vec![Trace { name: "tg.reflectivity", x: &xs, y: &s }] },
        Panel { axis: Axis::new("X, Y"), traces: vec![Trace { name: "sweep.x", x: &xs, y: &u2 }, Trace { name: "unfolded", x: &xs, y: &u }] },
    ];
    let lanes = [Lane { name: "fold x", x: &xs, high: &states }, Lane { name: "red.hold", x: &xs, high: &st2 }];
    let mut tl = TraceLook::titled("One sweep: height, reflectivity and folds against ground range"); tl.height = 180;
    tl.facts = vec!["frame 0, sweep 262, azimuth 0.0°, geometric range programme, 1000 samples".into()];
    trace_picture(&Axis::new("ground range (m)").logarithmic(), &panels, &lanes, &tl).unwrap().write("/tmp/ground-traces.png").unwrap();
    trace_picture(&Axis::new("ground range (m)"), &panels[..2], &[], &tl).unwrap().write("/tmp/ground-traces2.png").unwrap();
}
