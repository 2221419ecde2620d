//! The page of `corput converge --report` in a browser: light and dark, wide and on a phone.

use super::{Desk, skips};
use serde_json::Value;
use std::ffi::OsString;
use std::fs;
use std::process::Command;

/// A page that shows another in a frame, and writes down how it is laid out there. A window
/// is never as narrow as a phone, but a frame may be.
const MEASURE: &str = r#"<!DOCTYPE html><meta name="color-scheme" content="light dark">
<iframe width="WIDTH" height="900" style="border:0" srcdoc="PAGE"></iframe><script>
document.querySelector("iframe").addEventListener("load", (event) => {
  const { contentWindow: view, contentDocument: page } = event.target;
  const all = (name) => [...page.querySelectorAll(name)];
  const box = (one) => {
    const { left, right, width, height } = one.getBoundingClientRect();
    return { left, right, width, height, shown: one.checkVisibility() };
  };
  const fill = (name) => all(name).map((one) => view.getComputedStyle(one).fill);
  const found = {
    width: view.innerWidth,
    needs: page.documentElement.scrollWidth,
    figures: all(".view").map((one) => ({
      ...box(one), shown: one.querySelector("svg").checkVisibility(),
    })),
    texts: all(".view text").map((one) => {
      const { left, right } = one.getBoundingClientRect();
      const edge = one.closest(".view").getBoundingClientRect().right;
      const figure = one.ownerSVGElement;
      const scale = figure.getBoundingClientRect().width / figure.viewBox.baseVal.width;
      const size = parseFloat(view.getComputedStyle(one).fontSize) * scale;
      return { text: one.textContent, size, cut: right > edge, gone: left >= edge };
    }),
    keys: all(".key").map((one) => one.checkVisibility()),
    page: view.getComputedStyle(page.body).backgroundColor,
    paper: fill("svg .paper"),
    words: fill("svg .ink text"),
    titles: all("svg > title").map((one) => one.textContent),
  };
  const out = document.createElement("pre");
  out.id = "measured";
  out.textContent = JSON.stringify(found);
  document.body.replaceChildren(out);
});
</script>"#;

/// What the page may ask for: nothing.
const POLICY: &str = "content=\"default-src 'none'; style-src 'unsafe-inline'; img-src data:\"";

/// A way to look at a page.
#[derive(Clone, Copy, Debug)]
struct Look {
    width: u32,
    dark: bool,
}

const WIDE: Look = Look {
    width: 1280,
    dark: false,
};
const PHONE: Look = Look {
    width: 390,
    dark: false,
};

/// The browser, by `CORPUT_CHROMIUM` or on PATH; it is said aloud where there is none.
fn browser() -> Option<OsString> {
    let named = std::env::var_os("CORPUT_CHROMIUM");
    let usual = ["chromium", "chromium-browser", "google-chrome"].map(OsString::from);
    let starts = |name: &OsString| Command::new(name).arg("--version").output().is_ok();
    let found = match named {
        Some(name) => {
            assert!(
                starts(&name),
                "CORPUT_CHROMIUM={} does not start",
                name.display()
            );
            Some(name)
        }
        None => usual.into_iter().find(starts),
    };
    if found.is_none() {
        eprintln!("SKIPPED: no chromium on PATH (package chromium)");
    }
    found
}

/// Opens a page; what its console says, and how it is laid out.
fn open(browser: &OsString, page: &str, look: Look) -> (Vec<String>, Value) {
    assert!(page.contains(POLICY), "the page may ask for something");
    let quoted = page.replace('&', "&amp;").replace('"', "&quot;");
    let measuring = MEASURE
        .replace("WIDTH", &look.width.to_string())
        .replace("PAGE", &quoted);
    let folder = tempfile::tempdir().unwrap();
    let file = folder.path().join("page.html");
    fs::write(&file, measuring).unwrap();
    let output = Command::new(browser)
        .args([
            "--headless",
            "--no-sandbox",
            "--disable-gpu",
            "--no-first-run",
        ])
        .args([
            "--enable-logging=stderr",
            "--v=0",
            "--virtual-time-budget=5000",
        ])
        .arg("--host-resolver-rules=MAP * ~NOTFOUND")
        // 0 is dark, 1 light.
        .arg(format!(
            "--blink-settings=preferredColorScheme={}",
            i32::from(!look.dark)
        ))
        .args(["--window-size=1400,1000", "--hide-scrollbars"])
        .arg(format!(
            "--user-data-dir={}",
            folder.path().join("profile").display()
        ))
        .arg("--dump-dom")
        .arg(format!("file://{}", file.display()))
        .output()
        .unwrap();
    let (page, log) = (
        String::from_utf8_lossy(&output.stdout).into_owned(),
        String::from_utf8_lossy(&output.stderr).into_owned(),
    );
    let found = page
        .split("<pre id=\"measured\">")
        .nth(1)
        .and_then(|rest| rest.split("</pre>").next())
        .unwrap_or_else(|| panic!("{look:?}: the page did not load: {log}"));
    // The text of an element has these in place of their signs.
    let found = [("&lt;", "<"), ("&gt;", ">"), ("&amp;", "&")]
        .iter()
        .fold(found.to_owned(), |text, (name, sign)| {
            text.replace(name, sign)
        });
    let console = log.lines().filter(|line| line.contains(":CONSOLE"));
    (
        console.map(str::to_owned).collect(),
        serde_json::from_str(&found).unwrap(),
    )
}

/// What is wrong with a page of so many figures.
fn faults(browser: &OsString, page: &str, figures: usize, look: Look) -> Vec<String> {
    let (mut faults, found) = open(browser, page, look);
    let number = |value: &Value| value.as_f64().unwrap();
    let list = |name: &str| found[name].as_array().unwrap().clone();
    let width = number(&found["width"]);
    if width != f64::from(look.width) {
        faults.push(format!("the frame is {width} wide"));
    }
    if number(&found["needs"]) > width {
        faults.push(format!("the page is {} wide on {width}", found["needs"]));
    }
    if list("figures").len() != figures || list("titles").len() != figures {
        faults.push(format!("{} figures, not {figures}", list("figures").len()));
    }
    for figure in list("figures") {
        let [left, right] = ["left", "right"].map(|side| number(&figure[side]));
        let large = ["width", "height"].map(|side| number(&figure[side]) > 150.0);
        if figure["shown"] != true || large != [true; 2] || left < 0.0 || right > width {
            faults.push(format!("a figure is not seen: {figure}"));
        }
    }
    // Words are as large as on paper; where names are cut off, a list below has them.
    let (mut least, mut gone) = (f64::MAX, false);
    for text in list("texts") {
        if text["gone"] == true {
            gone = true;
            continue;
        }
        least = least.min(number(&text["size"]));
        if text["cut"] == true {
            faults.push(format!("cut off: {text}"));
        }
    }
    if least < 11.0 {
        faults.push(format!("words of {least} pixels"));
    }
    if list("keys").len() != figures / 2 || list("keys").iter().any(|key| *key != gone) {
        faults.push(format!(
            "names are cut off: {gone}, listed: {:?}",
            list("keys")
        ));
    }
    let (page, ink) = match look.dark {
        true => ("rgb(21, 24, 28)", "rgb(228, 228, 228)"),
        false => ("rgb(255, 255, 255)", "rgb(34, 34, 34)"),
    };
    let mut colours = list("paper");
    colours.push(found["page"].clone());
    if colours.iter().any(|colour| colour != page) {
        faults.push(format!("the page is {colours:?}, not {page}"));
    }
    if list("words").is_empty() || list("words").iter().any(|colour| colour != ink) {
        faults.push(format!("words of figures are not {ink}"));
    }
    faults
}

/// A report of four samplers on two integrands.
fn report(desk: &Desk) -> String {
    let run = desk.run(
        "converge --integrand x-squared --integrand disk-step \
         --sampler random,halton,sobol:owen,stratified --max-count 4096 --report out",
    );
    run.expect(0, &["wrote 11 files"]);
    let names = fs::read_dir(desk.path("out")).unwrap().count();
    assert_eq!(names, 11);
    fs::read_to_string(desk.path("out/report.html")).unwrap()
}

#[test]
fn the_page_is_seen_in_a_browser() {
    if skips() {
        return;
    }
    let desk = Desk::new();
    let page = report(&desk);
    alone(&page);
    let Some(browser) = browser() else { return };
    for width in [WIDE.width, PHONE.width] {
        for dark in [false, true] {
            let look = Look { width, dark };
            let found = faults(&browser, &page, 4, look);
            assert_eq!(found, Vec::<String>::new(), "{look:?}");
        }
    }
    // Each of these is to be found.
    let broken = |from: &str, to: &str| {
        assert!(page.contains(from), "{from}");
        page.replacen(from, to, 1)
    };
    let found = |page: &str, look, words: &str| {
        let found = faults(&browser, page, 4, look);
        assert!(
            found.iter().any(|one| one.contains(words)),
            "{words}: {found:?}"
        );
    };
    let asks = broken("<main>", "<main><img src=\"https://example.org/a.png\">");
    found(&asks, WIDE, "Content Security Policy");
    let hidden = broken("<svg ", "<svg style=\"display:none\" ");
    found(&hidden, WIDE, "a figure is not seen");
    let wide = broken("<main>", "<main><p style=\"width:50rem\">wide</p>");
    found(&wide, PHONE, "wide on 390");
    let small = broken(
        ".view svg { width: calc(100% * var(--across));",
        ".view svg {",
    );
    found(&small, PHONE, "words of ");
    let nameless = broken(".key { display: flex; }", "");
    found(
        &nameless,
        PHONE,
        "names are cut off: true, listed: [Bool(false)",
    );
    let bright = broken("svg .paper{fill:#15181c}", "");
    found(&bright, Look { dark: true, ..WIDE }, "not rgb(21, 24, 28)");
}

/// The page names nothing outside it, and runs nothing.
fn alone(page: &str) {
    let own = page.replace("xmlns=\"http://www.w3.org/2000/svg\"", "");
    for word in [
        "http:", "https:", "<script", " src=", "url(", "@import", "<iframe",
    ] {
        assert!(!own.contains(word), "the page has {word}");
    }
    let links: Vec<&str> = own.split("href=\"").skip(1).collect();
    assert_eq!(links.len(), 1, "the icon alone");
    assert!(links.iter().all(|link| link.starts_with("data:,\"")));
}
