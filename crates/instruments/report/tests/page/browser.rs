//! The page in a real browser, from a file.

use crate::run_folder::{RunFolder, SWEEPS};
use std::sync::MutexGuard;

use crate::webdriver::{Browser, turn};

const LEFT: &str = "\u{e012}";
const RIGHT: &str = "\u{e014}";
const HOME: &str = "\u{e011}";
const END: &str = "\u{e010}";
const ENTER: &str = "\u{e007}";
const ESCAPE: &str = "\u{e00c}";

/// A run of 30 frames with recorded sweeps, its page, and a browser that shows it.
fn shown(size: [u32; 2]) -> Option<(RunFolder, Browser, MutexGuard<'static, ()>)> {
    let turn = turn();
    let browser = Browser::open(size, false)?;
    let run = RunFolder::new(5, 30);
    run.beside(&[(6, 16), (7, 3)]);
    report::write_page(run.path()).unwrap();
    browser.go(&address(&run));
    Some((run, browser, turn))
}

fn address(run: &RunFolder) -> String {
    format!("file://{}", run.join("index.html").display())
}

fn source(browser: &Browser) -> String {
    let source = browser.value("document.getElementById('frame').getAttribute('src')");
    source.as_str().unwrap().to_owned()
}

/// Index of the picture that is shown.
fn shown_picture(browser: &Browser) -> u64 {
    let picture = browser.value("document.getElementById('frame').dataset.picture");
    picture.as_str().unwrap().parse().unwrap()
}

/// Grey of the middle of the picture that is shown: every frame has another.
fn grey(browser: &Browser) -> u64 {
    let script = "(image => { const canvas = document.createElement('canvas'); canvas.width = 64; canvas.height = 36; \
                  const context = canvas.getContext('2d'); context.drawImage(image, 0, 0); \
                  return context.getImageData(0, 18, 1, 1).data[0]; })(document.getElementById('frame'))";
    browser.value(script).as_u64().unwrap()
}

#[test]
fn keys_step_frames() {
    let Some((_run, browser, _turn)) = shown([1280, 900]) else { return };
    let at = || browser.text("number").parse::<u64>().unwrap();
    assert_eq!((at(), shown_picture(&browser), grey(&browser)), (5, 5, 5));
    browser.press(RIGHT);
    browser.press(RIGHT);
    assert_eq!((at(), shown_picture(&browser), grey(&browser)), (7, 7, 7));
    assert_eq!([browser.text("time"), browser.text("north")], ["0.700 s", "107.00 m"]);
    assert_eq!(browser.text("pitch"), "\u{2212}2.50°");
    browser.press(LEFT);
    assert_eq!(at(), 6);
    browser.press(END);
    assert_eq!((at(), shown_picture(&browser), grey(&browser)), (34, 34, 34));
    browser.press(RIGHT);
    assert_eq!(at(), 34);
    browser.press(HOME);
    browser.press(LEFT);
    assert_eq!(at(), 5);
    assert_eq!(browser.value("document.getElementById('at').value"), "5");
    assert_eq!(browser.value("location.hash"), "#frame=5");
    browser.press("+");
    assert_eq!(browser.value("document.getElementById('speed').value"), "4");
    browser.press("--");
    assert_eq!(browser.value("document.getElementById('speed').value"), "2");
    browser.press("  ");
    assert_eq!(browser.text("play"), "Play");
    browser.press("+++ ");
    assert_eq!(browser.text("play"), "Pause");
    // However busy the computer is, frames go by until it stops.
    let patience = std::time::Instant::now() + std::time::Duration::from_secs(20);
    while at() <= 5 && std::time::Instant::now() < patience {
        std::thread::sleep(std::time::Duration::from_millis(50));
    }
    browser.press(" ");
    assert!(at() > 5, "{}", at());
    // The slider has the keys that the page has, and no step is counted twice.
    browser.press(HOME);
    browser.value("document.getElementById('at').focus()");
    browser.press(RIGHT);
    assert_eq!(at(), 6);
    quiet(&browser);
}

/// No complaint, and no request but for files.
pub fn quiet(browser: &Browser) {
    let (complaints, asked) = browser.logs();
    assert!(complaints.is_empty(), "{complaints:?}");
    assert!(!asked.is_empty(), "the log of requests is kept");
    let strange: Vec<&String> =
        asked.iter().filter(|url| !url.starts_with("file:") && !url.starts_with("data:")).collect();
    assert!(strange.is_empty(), "{strange:?}");
}

#[test]
fn a_column_leads_to_its_sweep() {
    let Some((run, browser, _turn)) = shown([1280, 900]) else { return };
    let sight = run.beside(&[(6, 16), (7, 3)]).sight.unwrap();
    browser.press(RIGHT);
    assert_eq!(browser.value("document.querySelectorAll('#marks line').length"), 1);
    for (column, line) in [(33, 17), (33, 2), (10, 30), (60, 8)] {
        let share = [(f64::from(column) + 0.5) / 64.0, (f64::from(line) + 0.5) / 36.0];
        let sweep = sight.sweep_at(6, share.map(|share| 2.0 * share - 1.0)).unwrap();
        let sweep = sweep.round().clamp(0.0, f64::from(SWEEPS - 1)) as u32;
        browser.click("#screen", share);
        assert_eq!(browser.text("look-title"), format!("Sweep {sweep} of frame 6"));
        assert_eq!(browser.value("location.hash"), format!("#frame=6&sweep={sweep}"));
        let commands = browser.text("commands");
        if sweep == 16 {
            assert_eq!(browser.value("document.activeElement.id"), "scope-6-16");
        } else {
            assert_eq!(browser.text("place"), format!("{column}, {line}"));
            assert_eq!(browser.text("under"), sweep.to_string());
            let stage = "'scenarios/it'\\''s.toml' --sweeps 32 --frame 6";
            assert!(commands.contains(&format!("lunoid probe {stage} --sweep {sweep} --out")), "{commands}");
            assert!(
                commands.contains(&format!("lunoid explain {stage} --pixel {column},{line}")),
                "{commands}"
            );
            assert!(commands.contains(&format!("--probe 6:{sweep}")), "{commands}");
        }
    }
    let [x, y] = [0, 1].map(|end| {
        let get = |name: &str| {
            browser.value(&format!("document.getElementById('chosen').getAttribute('{name}{}')", end + 1))
        };
        [get("x"), get("y")].map(|value| value.as_str().unwrap().parse::<f64>().unwrap())
    });
    let middle = |share: f64| [0, 1].map(|axis| x[axis] + share * (y[axis] - x[axis]));
    let chosen: f64 = browser.value("Number(location.hash.split('sweep=')[1])").as_f64().unwrap();
    for share in [0.4, 0.5, 0.6] {
        assert!(
            (sight.sweep_at(6, middle(share)).unwrap() - chosen).abs() < 1e-6,
            "the cursor lies on its sweep"
        );
    }
    quiet(&browser);
}

#[test]
fn the_sweep_cursor_has_keys() {
    let Some((_run, browser, _turn)) = shown([1280, 900]) else { return };
    browser.press(".");
    assert_eq!(browser.text("look-title"), "Sweep 16 of frame 5");
    browser.press(".");
    browser.press("<");
    assert_eq!(browser.text("look-title"), "Sweep 7 of frame 5");
    browser.press(RIGHT);
    browser.press(RIGHT);
    browser.press(",,,,");
    assert_eq!(browser.text("look-title"), "Sweep 3 of frame 7");
    browser.press(ENTER);
    assert_eq!(browser.value("document.activeElement.id"), "scope-7-3");
    browser.press(ESCAPE);
    assert_eq!(browser.value("document.getElementById('look').hidden"), true);
    // Back from the plot to its column.
    browser.value("document.querySelector('#scope-6-16 button').click()");
    assert_eq!([browser.text("number"), browser.text("look-title")], ["6", "Sweep 16 of frame 6"]);
    quiet(&browser);
}

#[test]
fn a_link_leads_to_frame_and_sweep() {
    let Some((run, browser, _turn)) = shown([1280, 900]) else { return };
    browser.go("about:blank");
    browser.go(&format!("{}#frame=9&sweep=30", address(&run)));
    assert_eq!([browser.text("number"), browser.text("look-title")], ["9", "Sweep 30 of frame 9"]);
    browser.click(".sheet [data-picture=\"34\"]", [0.5, 0.5]);
    assert_eq!(browser.text("number"), "34");
    assert_eq!(browser.value("document.querySelector('.sheet [aria-current]').dataset.picture"), "34");
    browser.value("document.querySelector('#timing td a').click()");
    browser.press(" ");
    quiet(&browser);
}

#[test]
fn dark_and_light() {
    let Some((run, browser, _turn)) = shown([1280, 900]) else { return };
    let paper =
        |browser: &Browser| browser.value("getComputedStyle(document.documentElement).backgroundColor");
    let light = paper(&browser);
    browser.click("#theme", [0.5, 0.5]);
    assert_eq!(browser.value("document.documentElement.dataset.theme"), "dark");
    let dark = paper(&browser);
    assert_ne!(light, dark);
    browser.press("d");
    assert_eq!(
        (browser.value("document.documentElement.dataset.theme"), paper(&browser)),
        ("light".into(), light)
    );
    let Some(other) = Browser::open([1280, 900], true) else { return };
    other.go(&address(&run));
    assert!(other.value("document.documentElement.dataset.theme").is_null());
    assert_eq!(other.value("matchMedia('(prefers-color-scheme: dark)').matches"), true);
    assert_eq!(paper(&other), dark);
    quiet(&browser);
}

/// The page of `run`, changed, in a folder of its own.
fn mailed(run: &RunFolder, change: impl Fn(String) -> String) -> (tempfile::TempDir, String) {
    let alone = tempfile::tempdir().unwrap();
    let page = alone.path().join("mailed.html");
    std::fs::write(&page, change(std::fs::read_to_string(run.join("index.html")).unwrap())).unwrap();
    let address = format!("file://{}", page.display());
    (alone, address)
}

#[test]
fn alone_it_has_every_frame() {
    let Some((run, browser, _turn)) = shown([1280, 900]) else { return };
    let (_alone, address) = mailed(&run, |page| page);
    browser.go(&address);
    for picture in 5..35 {
        assert_eq!((shown_picture(&browser), grey(&browser)), (picture, picture));
        browser.press(RIGHT);
    }
    assert_eq!(browser.value("document.getElementById('reduced').hidden"), true);
    let plot = browser.value("document.querySelector('.scope img').src");
    assert!(plot.as_str().unwrap().starts_with("data:image/svg"));
    quiet(&browser);
}

/// What the element at `selector` says.
fn said(browser: &Browser, selector: &str) -> String {
    let text = browser.value(&format!("document.querySelector('{selector}').textContent"));
    text.as_str().unwrap().to_owned()
}

#[test]
fn a_recorded_sweep_has_values_under_the_pointer_zoom_and_x_y() {
    let Some((_run, browser, _turn)) = shown([1280, 900]) else { return };
    let own = "#scope-6-16 .live";
    assert_eq!(browser.value(&format!("document.querySelector('{own} canvas')")), serde_json::Value::Null);
    browser.value(&format!("document.querySelector('{own}').open = true"));
    browser.press("");
    let canvas = format!("{own} canvas");
    browser.value(&format!(
        "(canvas => {{ const {{ left, top, width, height }} = canvas.getBoundingClientRect(); \
         for (const type of ['pointermove', 'pointerdown', 'pointerup']) \
         canvas.dispatchEvent(new PointerEvent(type, {{ clientX: left + width / 2, clientY: top + height / 2 }})); \
         }})(document.querySelector('{canvas}'))"
    ));
    let words = said(&browser, &format!("{own} p"));
    let sample = |words: &str, whose: &str| -> f64 {
        let rest = words.split(&format!("{whose} at sample ")).nth(1).expect(whose);
        rest.split(',').next().unwrap().parse().unwrap()
    };
    // The pointer is where the click was: one sample is under both, and the table has its values by the closed form.
    let at = sample(&words, "Cursor A");
    assert_eq!(sample(&words, "Pointer"), at, "{words}");
    assert!((20.0..60.0).contains(&at) && words.contains(&format!("{at}, {:.3} µs", 0.5 * at)), "{words}");
    let rows = said(&browser, &format!("{own} tbody"));
    let [height, twice] = [10.0 + 2.0 * at, 20.0 + 4.0 * at];
    for row in [
        format!("sweep.range{0}{0}", 3.0 * at),
        format!("tg.height{height} m{height} m"),
        format!("mu.height{twice} m{twice} m"),
    ] {
        assert!(rows.contains(&row), "{row}: {rows}");
    }
    let ticks = || said_of(&browser, &canvas, "ticks");
    let whole = ticks();
    for _ in 0..60 {
        browser.value(&format!(
            "document.querySelector('{canvas}').dispatchEvent(new KeyboardEvent('keydown', {{ key: '+' }}))"
        ));
    }
    let near: Vec<u32> = ticks().split(' ').map(|tick| tick.parse().unwrap()).collect();
    assert!(
        near.len() < whole.split(' ').count() && near.windows(2).all(|pair| pair[1] == pair[0] + 1),
        "{near:?}"
    );
    browser.value(&format!(
        "(box => {{ box.value = 'xy'; box.onchange(); }})(document.querySelectorAll('{own} select')[1])"
    ));
    assert!(said(&browser, &format!("{own} p")).contains("Cursor A"), "X-Y of two wires is drawn");
    browser.value(&format!(
        "(wires => {{ wires.options[1].selected = false; wires.onchange(); }})(document.querySelector('{own} select'))"
    ));
    assert!(said(&browser, &format!("{own} p")).contains("name two"));
    quiet(&browser);
}

/// An entry of the data of an element.
fn said_of(browser: &Browser, selector: &str, key: &str) -> String {
    let value = browser.value(&format!("document.querySelector('{selector}').dataset.{key}"));
    value.as_str().unwrap().to_owned()
}

#[test]
fn late_sweeps_are_marked_in_the_picture_of_their_frame() {
    let Some((run, browser, _turn)) = shown([1280, 900]) else { return };
    let sight = run.beside(&[]).sight.unwrap();
    assert_eq!(browser.text("late-says"), format!("1 of {SWEEPS}"));
    let path = browser.value("document.getElementById('late').getAttribute('d')");
    let places: Vec<f64> =
        path.as_str().unwrap().split(['M', 'L', ' ']).filter_map(|number| number.parse().ok()).collect();
    assert_eq!(places.len(), 8, "{path}");
    for place in places.chunks(2) {
        let sweep = sight.sweep_at(5, [place[0], place[1]]).unwrap();
        assert!((sweep - 7.0).abs() < 0.01 && place[1].abs() > 0.9, "{place:?} is of sweep {sweep}");
    }
    browser.press(RIGHT);
    assert_eq!(browser.text("late-says"), "not timed");
    assert_eq!(browser.value("document.getElementById('late').getAttribute('d')"), "");
    quiet(&browser);
}

/// A click has whole coordinates, and the pointer has not: both name the pixel that the readings name.
#[test]
fn pointer_and_click_name_the_same_pixel() {
    let Some((_run, browser, _turn)) = shown([1280, 900]) else { return };
    let place = browser.value(
        "(screen => { const { left, top, width, height } = screen.getBoundingClientRect(); \
         const x = left + width * 33 / 64 + 0.4, y = top + height * 17 / 36 + 0.4; \
         screen.dispatchEvent(new PointerEvent('pointermove', { clientX: x, clientY: y, bubbles: true })); \
         screen.dispatchEvent(new MouseEvent('click', { clientX: Math.floor(x) - 1, clientY: Math.floor(y) - 1, bubbles: true })); \
         return document.getElementById('place').textContent; })(document.getElementById('screen'))",
    );
    assert_eq!(place, "33, 17");
    let commands = browser.text("commands");
    assert!(commands.contains("--pixel 33,17"), "{commands}");
}

#[test]
fn side_by_side_enlarges_and_blinks() {
    let turn = turn();
    let Some(browser) = Browser::open([1280, 900], false) else { return };
    let folder = tempfile::tempdir().unwrap();
    let names = ["ideal", "coarse", "exact"].map(str::to_owned);
    for name in &names {
        let run = RunFolder::new(0, 2);
        std::fs::rename(run.path(), folder.path().join(name)).unwrap();
    }
    report::write_side_by_side(folder.path(), &names, Some("exact")).unwrap();
    browser.go(&format!("file://{}", folder.path().join("index.html").display()));
    browser.click(".side a[data-machine=coarse] img", [0.5, 0.5]);
    let machine = || said_of(&browser, "#large-picture", "machine");
    assert_eq!(
        (browser.value("document.getElementById('large').open"), machine()),
        (true.into(), "coarse".into())
    );
    assert_eq!(browser.text("large-says"), "Frame 0, coarse");
    let source = browser.value("document.getElementById('large-picture').src");
    assert!(
        source.as_str().unwrap().ends_with("coarse/frames/frame-000000.png"),
        "the whole picture: {source}"
    );
    browser.press(RIGHT);
    browser.press(RIGHT);
    assert_eq!(machine(), "ideal");
    browser.click("#large-picture", [33.5 / 64.0, 17.5 / 36.0]);
    assert_eq!(browser.text("large-place"), "33, 17 (kept: 33, 17)");
    assert_eq!(browser.text("large-blink"), "Blink with exact");
    browser.press("b");
    let mut seen = std::collections::BTreeSet::new();
    for _ in 0..60 {
        seen.insert(machine());
        std::thread::sleep(std::time::Duration::from_millis(50));
    }
    assert_eq!(seen.into_iter().collect::<Vec<_>>(), ["exact", "ideal"]);
    browser.press("b");
    assert_eq!(machine(), "ideal");
    browser.press(ESCAPE);
    assert_eq!(browser.value("document.getElementById('large').open"), false);
    quiet(&browser);
    drop(turn);
}

/// As if the frames were too large: a page that has every tenth of them.
#[test]
fn frames_that_it_does_not_have_are_read_from_beside_it() {
    let Some((run, browser, _turn)) = shown([1280, 900]) else { return };
    let all: Vec<u64> = (5..35).collect();
    let some = |page: String| {
        let all = format!("\"film\":{}", serde_json::json!(all));
        assert!(page.contains(&all));
        page.replace(&all, "\"film\":[5,15,25]")
    };
    let page = std::fs::read_to_string(run.join("index.html")).unwrap();
    std::fs::write(run.join("index.html"), some(page)).unwrap();
    browser.go("about:blank");
    browser.go(&address(&run));
    browser.press(RIGHT);
    assert_eq!((source(&browser).as_str(), shown_picture(&browser)), ("frames/frame-000006.png", 6));
    let (_alone, address) = mailed(&run, |page| page);
    browser.go(&format!("{address}#frame=12"));
    assert_eq!((browser.text("number").as_str(), grey(&browser)), ("12", 15));
    assert_eq!(browser.value("document.getElementById('reduced').hidden"), false);
    browser.press(&RIGHT.repeat(3));
    assert_eq!(
        (grey(&browser), browser.value("document.getElementById('reduced').hidden")),
        (15, true.into())
    );
}

/// What the plots say of themselves in the dark is what the page asks for.
#[test]
fn plots_are_dark_on_a_dark_page() {
    let Some((run, browser, _turn)) = shown([1280, 900]) else { return };
    // The plot is an image: what it looks like is known once it is drawn again.
    let corner = || {
        let script = "(image => { const canvas = document.createElement('canvas'); canvas.width = 9; canvas.height = 4; \
                      const context = canvas.getContext('2d'); context.drawImage(image, 0, 0, 9, 4); \
                      return context.getImageData(8, 3, 1, 1).data[0]; })(document.querySelector('.scope img'))";
        browser.value(script).as_u64().unwrap()
    };
    browser.value("document.querySelectorAll('.scope img').forEach(image => { image.loading = 'eager'; })");
    browser.press("");
    assert_eq!(corner(), 255);
    browser.press("d");
    assert_eq!(corner(), 18);
    browser.press("d");
    assert_eq!(corner(), 255);
    drop(run);
}

/// Nothing sticks out at any width, and what is shown does not move when frames come.
#[test]
fn it_fits_a_phone_and_does_not_jump() {
    let Some((_run, browser, _turn)) = shown([500, 900]) else { return };
    for width in [320, 375, 500] {
        let script = format!(
            "(() => {{ document.documentElement.style.width = '{width}px'; \
             return [...document.querySelectorAll('body *')].filter(part => !part.closest('.wide, .plate, .contents, .unseen, .skip, svg')) \
             .filter(part => part.getBoundingClientRect().right > {width} + 1).map(part => part.tagName + '.' + part.className).slice(0, 5); }})()"
        );
        assert_eq!(browser.value(&script), serde_json::json!([]), "at {width}");
    }
    let place =
        || browser.value("document.getElementById('contact-sheet').getBoundingClientRect().top + scrollY");
    let before = place();
    for key in [RIGHT, END, HOME] {
        browser.press(key);
        assert_eq!(place(), before);
    }
    quiet(&browser);
}
