//! Errors of the sweeps that were checked, in the order of time.

use maud::{Markup, html};

use run_record::CheckedSweep;

/// Size of the plot (pixels), and from its lower edge to its axis.
const WIDE: f64 = 720.0;
const TALL: f64 = 90.0;
const FOOT: f64 = 14.0;
/// Decades below the worst sweep that are drawn.
const DECADES: f64 = 3.0;

/// Root mean square of the picture's column of every sweep, on a logarithmic axis whose lines are decades; a mark leads to
/// its sweep.
pub(crate) fn plot(checked: &[CheckedSweep]) -> Markup {
    let rms = |sweep: &CheckedSweep| sweep.rms_and_max[0].map_or(0.0, |[rms, _]| rms);
    let most = checked.iter().map(rms).fold(0.0, f64::max);
    if checked.len() < 2 || most <= 0.0 {
        return html! {};
    }
    let top = libm::ceil(libm::log10(most));
    let height = |share: f64| FOOT / 2.0 + (TALL - FOOT) * (1.0 - share.clamp(0.0, 1.0));
    let y = |value: f64| height(1.0 + (libm::log10(value) - top) / DECADES);
    let x = |index: usize| 60.0 + (WIDE - 70.0) * (index as f64 + 0.5) / checked.len() as f64;
    html! {
        svg.errors viewBox=(format!("0 0 {WIDE} {TALL}")) role="group"
            aria-label="Error of the picture of every sweep that was checked, in the order of time" {
            @for decade in 0..=DECADES as i32 {
                @let level = format!("{:.2}", height(1.0 - f64::from(decade) / DECADES));
                line x1="56" x2=(WIDE) y1=(level) y2=(level) {}
                text x="50" y=(level) { "1e" (top as i32 - decade) }
            }
            @for (index, sweep) in checked.iter().enumerate() {
                @let words = format!("frame {}, sweep {}: {:.2e}", sweep.frame, sweep.sweep, rms(sweep));
                a href=(format!("#frame={}&sweep={}", sweep.frame, sweep.sweep)) aria-label=(words) {
                    circle cx=(format!("{:.2}", x(index))) cy=(format!("{:.2}", y(rms(sweep)))) r="4" { title { (words) } }
                }
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::plot;
    use run_record::CheckedSweep;

    fn sweep(frame: u64, rms: f64) -> CheckedSweep {
        CheckedSweep { frame, sweep: 7, column: 7, rms_and_max: [Some([rms, rms]), None, None, None] }
    }

    /// Heights of the marks.
    fn heights(html: &str) -> Vec<f64> {
        let parts = html.split("cy=\"").skip(1);
        parts.map(|part| part.split('"').next().unwrap().parse().unwrap()).collect()
    }

    #[test]
    fn a_mark_stands_where_its_error_is() {
        let html = plot(&[sweep(0, 0.01), sweep(3, 0.001), sweep(9, 0.0)]).into_string();
        // Of 76 pixels for three decades from 0.01 down; no error at all lies at the foot.
        assert_eq!(heights(&html), [7.0, 32.33, 83.0]);
        assert!(html.contains("href=\"#frame=3&amp;sweep=7\"") && html.contains("frame 3, sweep 7: 1.00e-3"));
        assert!(html.contains(">1e-2<") && html.contains(">1e-5<"));
    }

    #[test]
    fn one_sweep_and_no_error_need_no_plot() {
        assert_eq!(plot(&[sweep(0, 0.01)]).into_string(), "");
        assert_eq!(plot(&[sweep(0, 0.0), sweep(1, 0.0)]).into_string(), "");
    }
}
