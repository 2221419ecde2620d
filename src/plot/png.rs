//! SVG text to PNG bytes.

use std::sync::{Arc, OnceLock};

use resvg::tiny_skia::{Pixmap, Transform};
use resvg::usvg::{Options, Tree, fontdb::Database};

use crate::error::Result;
use crate::plot::refuse;

/// The most pixels along a side of a PNG.
const MAX_SIDE: f32 = 16_384.0;

static FONT: &[u8] = include_bytes!("../../assets/fonts/DejaVuSans-subset.ttf");

/// The only font, whatever the machine has: figures are the same everywhere.
fn fonts() -> Arc<Database> {
    static FONTS: OnceLock<Arc<Database>> = OnceLock::new();
    let load = || {
        let mut fonts = Database::new();
        fonts.load_font_data(FONT.to_vec());
        fonts.set_sans_serif_family("DejaVu Sans");
        Arc::new(fonts)
    };
    Arc::clone(FONTS.get_or_init(load))
}

/// How SVG is read: in that font.
pub fn options() -> Options<'static> {
    Options {
        font_family: "DejaVu Sans".to_owned(),
        fontdb: fonts(),
        ..Options::default()
    }
}

/// Renders an SVG at `scale` pixels per unit to PNG.
///
/// # Errors
///
/// [`Error::Arguments`](crate::Error::Arguments) for text that is no SVG, or a scale that
/// gives a side of no pixel or of more than 16,384.
pub fn to_png(svg: &str, scale: f32) -> Result<Vec<u8>> {
    let tree = match Tree::from_str(svg, &options()) {
        Ok(tree) => tree,
        Err(error) => {
            return refuse(
                "a PNG of a text that is no SVG".to_owned(),
                &error.to_string(),
                "give the text that a plot returned",
            );
        }
    };
    let (width, height) = (tree.size().width() * scale, tree.size().height() * scale);
    let possible = |side: f32| side > 0.0 && side <= MAX_SIDE;
    if !(possible(width) && possible(height)) {
        return refuse(
            format!("a PNG of {width} x {height} pixels"),
            &format!("a side has 1 to {MAX_SIDE} pixels"),
            "choose another scale",
        );
    }
    let image = Pixmap::new(width.ceil() as u32, height.ceil() as u32).map(|mut pixels| {
        resvg::render(
            &tree,
            Transform::from_scale(scale, scale),
            &mut pixels.as_mut(),
        );
        pixels.encode_png()
    });
    match image {
        Some(Ok(bytes)) => Ok(bytes),
        Some(Err(error)) => refuse(
            "a PNG".to_owned(),
            &error.to_string(),
            "keep the SVG, and report this",
        ),
        None => refuse(
            format!("a PNG of {width} x {height} pixels"),
            "there is no memory for it",
            "choose a smaller scale",
        ),
    }
}
