//! Constants of one sweep that turn elevation into deflection (section 15.3).

use quantities::sin_cos;
use scenario::Projection;

/// `Y/D = (a - b t) / (c + e t)`, positive down, with `t` the tangent of the elevation.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Deflection {
    /// Constant of the numerator.
    pub a: f64,
    /// Share of the elevation in the numerator.
    pub b: f64,
    /// Constant of the denominator.
    pub c: f64,
    /// Share of the elevation in the denominator.
    pub e: f64,
}

impl Deflection {
    /// Constants of a sweep at `tan_beta` from the heading, under a projection law and pitch (rad).
    pub fn new(projection: Projection, pitch: f64, tan_beta: f64) -> Self {
        let (sin, cos) = sin_cos(pitch);
        let cos_beta = 1.0 / (1.0 + tan_beta * tan_beta).sqrt();
        match projection {
            Projection::AsReported => Self { a: sin, b: cos, c: cos, e: sin },
            Projection::Corrected => Self { a: 0.0, b: 1.0, c: cos_beta, e: 0.0 },
            Projection::Exact => Self { a: sin * cos_beta, b: cos, c: cos * cos_beta, e: sin },
        }
    }

    /// The same in display lines from the top of a picture of `lines` lines over `tan_half_height`.
    pub fn in_lines(self, lines: f64, tan_half_height: f64) -> Self {
        let scale = 0.5 * lines / tan_half_height;
        let middle = 0.5 * lines;
        Self {
            a: self.a * scale + middle * self.c,
            b: self.b * scale - middle * self.e,
            c: self.c,
            e: self.e,
        }
    }

    /// Deflection of an elevation.
    pub fn at(&self, tangent: f64) -> f64 {
        (self.a - self.b * tangent) / (self.c + self.e * tangent)
    }
}

#[cfg(test)]
mod tests {
    use super::Deflection;
    use quantities::radians;
    use scenario::Projection;

    #[test]
    fn check_table_23_5() {
        // pitch, beta, eta (deg), Y/D exact, Y/D as reported.
        let rows = [
            (0.0, 25.0, -10.0, 0.1945552970310455, 0.176326980708465),
            (10.0, 20.0, -15.0, 0.4859032142836099, 0.4663076581549986),
            (-60.0, 15.0, -50.0, -0.158832528061934, -0.176326980708465),
            (10.0, -25.0, 5.0, 0.07845844989550805, 0.08748866352592401),
        ];
        for (pitch, beta, eta, exact, reported) in rows {
            let (pitch, tan_beta, t) = (radians(pitch), libm::tan(radians(beta)), libm::tan(radians(eta)));
            let found = Deflection::new(Projection::Exact, pitch, tan_beta).at(t);
            assert!((found - exact).abs() < 1e-14, "exact {found} against {exact}");
            let found = Deflection::new(Projection::AsReported, pitch, tan_beta).at(t);
            assert!((found - reported).abs() < 1e-14, "as reported {found} against {reported}");
        }
    }

    /// At no pitch it is the exact law, and pitch is not in it.
    #[test]
    fn the_corrected_law_leaves_pitch_out() {
        let of = |projection, pitch| Deflection::new(projection, pitch, 0.4).at(-0.15);
        let level = of(Projection::Corrected, 0.0);
        assert!(
            (level - of(Projection::Exact, 0.0)).abs() < 1e-15 && level != of(Projection::AsReported, 0.0)
        );
        assert_eq!(of(Projection::Corrected, 0.3), level);
    }

    #[test]
    fn lines_run_from_the_top() {
        let level = Deflection::new(Projection::Exact, 0.0, 0.0).in_lines(500.0, 0.25);
        assert!((level.at(0.25)).abs() < 1e-12);
        assert!((level.at(0.0) - 250.0).abs() < 1e-12);
        assert!((level.at(-0.25) - 500.0).abs() < 1e-12);
        let pitched = Deflection::new(Projection::Exact, 0.2, 0.3);
        let lines = pitched.in_lines(575.0, 0.268);
        let expected = (pitched.at(-0.1) / 0.268 + 1.0) * 287.5;
        assert!((lines.at(-0.1) - expected).abs() < 1e-10);
    }
}
