//! Times a build; scratch.
use landscape::relief::*;
fn main() {
    let u = Undulation { rms_height: 15.0, hurst: 0.85, longest: 6000.0, shortest: 300.0, waves: 600 };
    let c =
        Craters { smallest_radius: 150.0, largest_radius: 1500.0, density: 0.3, subdued: 0.03, fresh: 0.2 };
    let m = (0..12)
        .map(|i| Massif {
            at: [9000.0 + 500.0 * i as f64, 1000.0 * i as f64],
            height: 1800.0,
            radius: 5000.0,
            detail: 300.0,
            ruggedness: 0.7,
        })
        .collect();
    let r = Relief {
        undulation: Some(u),
        craters: Some(c),
        massifs: m,
        ..Relief::flat(1, [14900.0, 14900.0], 100.0)
    };
    println!("slope deg {}", u.rms_slope()*1.0 * 57.3);
    for _ in 0..3 {
        let t = std::time::Instant::now();
        let l = r.build().unwrap();
        println!("{:?} {:?}", l.corners(), t.elapsed());
    }
}
