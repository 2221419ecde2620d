//! How much room a text takes in the one font of the figures.

use super::png::options;
use resvg::usvg::{Node, Tree};

/// The width of a line of text: its advance, as the rasteriser sets it.
pub fn width(text: &str, size: f64) -> f64 {
    // Measured at a large size, where nothing is rounded, and scaled.
    const LARGE: f64 = 100.0;
    let svg = format!(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"1\" height=\"1\">\
         <text font-size=\"{LARGE}\">{}</text></svg>",
        crate::report::escape(text)
    );
    let tree = Tree::from_str(&svg, &options());
    let measured = tree.ok().and_then(|tree| {
        tree.root().children().iter().find_map(|node| match node {
            Node::Text(text) => Some(f64::from(text.bounding_box().width())),
            _ => None,
        })
    });
    measured.unwrap_or(0.0) * size / LARGE
}

/// Breaks a text at spaces into lines of at most `room`; a longer word is cut.
pub fn wrap(text: &str, size: f64, room: f64) -> Vec<String> {
    let mut lines: Vec<String> = Vec::new();
    for word in text.split_whitespace() {
        let word = shorten(word, size, room);
        let longer = lines.last().map(|line| format!("{line} {word}"));
        match longer.filter(|line| width(line, size) <= room) {
            Some(line) => {
                lines.pop();
                lines.push(line);
            }
            None => lines.push(word),
        }
    }
    lines
}

/// The text, or its beginning and an ellipsis where it is wider than `room`.
pub fn shorten(text: &str, size: f64, room: f64) -> String {
    if width(text, size) <= room {
        return text.to_owned();
    }
    let characters: Vec<char> = text.chars().collect();
    let cut = |length: usize| characters[..length].iter().collect::<String>() + "…";
    // The longest beginning that fits, by halving.
    let (mut fits, mut wide) = (0, characters.len());
    while wide - fits > 1 {
        let middle = usize::midpoint(fits, wide);
        if width(&cut(middle), size) <= room {
            fits = middle;
        } else {
            wide = middle;
        }
    }
    cut(fits)
}
