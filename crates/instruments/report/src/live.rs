//! The pages that a program serves: the run while it is drawn, and scripts of the page whose sweeps are computed on a click.

use maud::{DOCTYPE, html};

use crate::page::head_with;

/// Name of the page that is opened first.
pub const LIVE_FIRST: &str = "live.html";

/// Scripts of the served pages, by name. `live-sweep.js` asks for `lunoid.js` and what that needs beside it.
pub const LIVE_FILES: [(&str, &[u8]); 2] = [
    ("live.js", include_bytes!("live.js").as_slice()),
    ("live-sweep.js", include_bytes!("live-sweep.js").as_slice()),
];

/// Nothing from anywhere but the program that serves the page.
pub(crate) const LIVE_POLICY: &str = "default-src 'none'; img-src 'self' data:; style-src 'unsafe-inline'; \
                                      script-src 'self' 'unsafe-inline'; connect-src 'self'; base-uri 'none'; form-action 'none'";

const STYLE: &str = include_str!("live.css");

/// The page of a run that is drawn: its newest picture and how far it is. It goes on to the page of the run when that is there.
/// `aspect` is the width of the picture in its heights, as a person sees it.
pub fn waiting_page(title: &str, shows: &str, aspect: f64) -> String {
    let style = format!("aspect-ratio:{aspect:.6}");
    let page = html! {
        (DOCTYPE)
        html lang="en" {
            (head_with(&format!("{title} – a run of lunoid, being drawn"), STYLE, LIVE_POLICY))
            body {
                header.masthead {
                    div.running { span.house { "lunoid" } span { "A run that is being drawn" } }
                    h1 { (title) }
                    p.abstract { (shows) }
                }
                main {
                    section #picture aria-labelledby="picture-title" {
                        h2 #picture-title { "Picture" }
                        figure.drawn {
                            p #said role="status" { "Waiting for the program." }
                            progress #bar aria-label="Frames drawn" {}
                            img #frame style=(style) alt="No picture yet" hidden;
                        }
                        noscript { p.notice { "Without script this page does not follow the run. Load index.html when the run is finished." } }
                    }
                }
                script src="live.js" {}
            }
        }
    };
    text::visible(&page.into_string()).into_owned()
}

#[cfg(test)]
mod tests {
    use super::waiting_page;

    #[test]
    fn words_of_a_scenario_end_no_element() {
        let page = waiting_page("</title><script>a", "<b>\u{1b}", 1.5);
        assert!(page.contains("&lt;/title&gt;&lt;script&gt;a") && !page.contains("<script>a"), "{page}");
        assert!(page.contains("&lt;b&gt;\\u{1b}"), "{page}");
        assert!(page.contains("style=\"aspect-ratio:1.500000\""), "{page}");
    }
}
