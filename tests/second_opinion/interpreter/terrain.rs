//! Function generators, products, sums and light (sections 5.2, 6.1, 6.4, 7).

use crate::interpreter::registers::CORNERS;

/// Outputs of the three kinds of function generator at z, and of their derivative generators.
#[derive(Debug, Clone, Copy)]
struct Generators {
    value: [f64; 3],
    slope: [f64; 3],
}

fn generators(z: f64) -> Generators {
    let (z2, z3) = (z * z, z * z * z);
    let (z4, z5) = (z2 * z2, z2 * z3);
    Generators {
        value: [
            1.0 - 10.0 * z3 + 15.0 * z4 - 6.0 * z5,
            z - 6.0 * z3 + 8.0 * z4 - 3.0 * z5,
            (z2 - 3.0 * z3 + 3.0 * z4 - z5) / 2.0,
        ],
        slope: [
            -30.0 * z2 + 60.0 * z3 - 30.0 * z4,
            1.0 - 18.0 * z2 + 32.0 * z3 - 15.0 * z4,
            (2.0 * z - 9.0 * z2 + 12.0 * z3 - 5.0 * z4) / 2.0,
        ],
    }
}

/// Height and its derivatives in u and v (all metres) from what is in the hold registers: the sums of 6.4.
pub fn sums(hold: &[[f64; 9]; 4], ramps: [f64; 2], polarity: [f64; 2]) -> [f64; 3] {
    let [of_x, of_one_minus_x] = [generators(ramps[0]), generators(1.0 - ramps[0])];
    let [of_y, of_one_minus_y] = [generators(ramps[1]), generators(1.0 - ramps[1])];
    let [mut h, mut h_u, mut h_v] = [0.0; 3];
    for (colour, [a, b]) in CORNERS.into_iter().enumerate() {
        let (gx, ex) = if a == 0 { (of_x, polarity[0]) } else { (of_one_minus_x, -polarity[0]) };
        let (gy, ey) = if b == 0 { (of_y, polarity[1]) } else { (of_one_minus_y, -polarity[1]) };
        for p in 0..3 {
            for q in 0..3 {
                let odd_x = if p == 1 { ex } else { 1.0 };
                let odd_y = if q == 1 { ey } else { 1.0 };
                let word = odd_x * odd_y * hold[colour][3 * p + q];
                h += gx.value[p] * gy.value[q] * word;
                h_u += ex * gx.slope[p] * gy.value[q] * word;
                h_v += ey * gx.value[p] * gy.slope[q] * word;
            }
        }
    }
    [h, h_u, h_v]
}

/// Coefficient multipliers of the light, set once a mission.
#[derive(Debug, Clone, Copy)]
pub struct Light {
    /// `cos e cos a`, `cos e sin a`.
    pub level: [f64; 2],
    /// `sin e`.
    pub up: f64,
    /// Share of the light that is returned.
    pub albedo: f64,
}

impl Light {
    /// Reflectivity of ground with slopes (hx, hy); local shadow is 0.
    pub fn reflectivity(&self, hx: f64, hy: f64) -> f64 {
        let towards_sun = self.up - hx * self.level[0] - hy * self.level[1];
        let lambert = towards_sun / (1.0 + hx * hx + hy * hy).sqrt();
        if lambert > 0.0 { self.albedo * lambert } else { 0.0 }
    }
}
