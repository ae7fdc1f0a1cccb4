//! Scratch: hillshade and a view.
use landscape::relief::*;
use landscape::*;
use std::io::Write;
fn pgm(path: &str, w: usize, h: usize, px: &[u8]) { let mut f = std::fs::File::create(path).unwrap(); write!(f, "P5\n{w} {h}\n255\n").unwrap(); f.write_all(px).unwrap(); }
fn view(path: &str, land: &Landscape, at: [f64;2], az: f64, eye: f64, sun: Sun) {
    let (w, h, f) = (1000usize, 480usize, 900.0);
    let top = 0.30; // tan elevation at the top row
    let mut px = vec![0u8; w*h];
    let e = land.height(at[0], at[1]).unwrap() + eye;
    for c in 0..w {
        let a = az + libm::atan((c as f64 - w as f64/2.0)/f);
        let (s, co) = libm::sincos(a);
        let cosb = libm::cos(a-az);
        let mut row = h as f64; let mut r = 1.0;
        while let Some(p) = land.at(at[0]+r*co, at[1]+r*s) {
            let el = (p.height - r*r/2.0/1.7374e6 - e)/(r*cosb);
            let y = ((top - el)*f).max(0.0);
            if y < row {
                let v = (255.0*libm::pow(sun.reflectivity(p.slopes).min(1.0), 1.0/1.8)) as u8;
                for k in (y.ceil() as usize).min(h)..(row.ceil() as usize).min(h) { px[k*w+c]=v; }
                row = y;
            }
            r *= 1.002;
        }
    }
    pgm(path, w, h, &px);
}
fn shade(path: &str, land: &Landscape, sun: Sun) {
    let [s0,w0,n1,e1] = land.level().extent();
    let n = 900; let mut px = vec![];
    for r in 0..n { for c in 0..n {
        let p = land.at(n1-(n1-s0)*r as f64/n as f64, w0+(e1-w0)*c as f64/n as f64).unwrap();
        px.push((255.0*sun.reflectivity(p.slopes).min(1.0)) as u8);
    }}
    pgm(path, n, n, &px);
}
fn main() {
    let d = 10.0; let ext = 4000.0;
    let u = Undulation { rms_height: 12.0, hurst: 0.85, longest: 3000.0, shortest: 3.0*d, waves: 800 };
    println!("slope {}", u.rms_slope());
    let c = Craters { smallest_radius: 1.5*d, largest_radius: 400.0, density: 0.08, subdued: 0.02, fresh: 0.18 };
    let m = |x: f64, y: f64, h: f64, r: f64| Massif { at: [x, y], height: h, radius: r, detail: 60.0, ruggedness: 0.7 };
    let massifs = vec![m(3300.0, 1500.0, 350.0, 1500.0), m(3600.0, 3200.0, 280.0, 1100.0), m(2900.0, 300.0, 200.0, 900.0)];
    let rilles = vec![Rille { through: [2000.0, 2000.0], azimuth: 1.2, width: 250.0, depth: 50.0, meander: Some(Meander { swing: 150.0, length: 1500.0 }) }];
    let r = Relief { undulation: Some(u), craters: Some(c), massifs, rilles, ..Relief::flat(1, [ext; 2], d) };
    let t = std::time::Instant::now();
    let l = r.build().unwrap();
    println!("{:?} {:?}", l.corners(), t.elapsed());
    let land = Landscape::new(Bank::new("x", vec![l], None).unwrap(), 1.0);
    let sun = Sun { azimuth: 1.4, elevation: 0.26 };
    shade("/tmp/ground-shade.pgm", &land, sun);
    view("/tmp/ground-view1.pgm", &land, [600.0, 2000.0], 0.0, 1.6, sun);
    view("/tmp/ground-view2.pgm", &land, [600.0, 2000.0], 0.0, 30.0, sun);
    view("/tmp/ground-view3.pgm", &land, [1000.0, 1000.0], 0.4, 3.0, sun);
}
