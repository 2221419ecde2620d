//! Where the texts of a figure lie, in the font that draws them.

use resvg::usvg::{Group, Node, Options, Rect, Tree, fontdb::Database};
use std::sync::Arc;

static FONT: &[u8] = include_bytes!("../../../assets/fonts/DejaVuSans-subset.ttf");

fn tree(svg: &str) -> Tree {
    let mut fonts = Database::new();
    fonts.load_font_data(FONT.to_vec());
    let options = Options {
        font_family: "DejaVu Sans".to_owned(),
        fontdb: Arc::new(fonts),
        ..Options::default()
    };
    Tree::from_str(svg, &options).unwrap()
}

/// Every text with its box on the page.
pub fn texts(svg: &str) -> Vec<(String, Rect)> {
    fn collect(group: &Group, found: &mut Vec<(String, Rect)>) {
        for node in group.children() {
            match node {
                Node::Group(group) => collect(group, found),
                Node::Text(text) => found.push((
                    text.chunks().iter().map(|chunk| chunk.text()).collect(),
                    text.abs_bounding_box(),
                )),
                _ => {}
            }
        }
    }
    let mut found = Vec::new();
    collect(tree(svg).root(), &mut found);
    found
}

/// Pairs of texts of which one lies on the other, and texts that leave the page.
pub fn collisions(svg: &str) -> Vec<String> {
    let texts = texts(svg);
    let page = tree(svg).size();
    let mut found = Vec::new();
    for (i, (text, area)) in texts.iter().enumerate() {
        if area.left() < 0.0
            || area.top() < 0.0
            || area.right() > page.width()
            || area.bottom() > page.height()
        {
            found.push(format!("`{text}` leaves the page: {area:?}"));
        }
        for (other, beside) in &texts[..i] {
            let across = area.left().max(beside.left()) < area.right().min(beside.right());
            // Lines of a paragraph may share the room that accents and descenders take.
            let down = area.bottom().min(beside.bottom()) - area.top().max(beside.top());
            if across && down > 0.2 * area.height().min(beside.height()) {
                found.push(format!("`{text}` lies on `{other}`"));
            }
        }
    }
    found
}

pub fn assert_apart(svg: &str) {
    let found = collisions(svg);
    assert!(found.is_empty(), "{found:#?}");
}

#[test]
fn texts_on_each_other_or_off_the_page_are_found() {
    let page = |body: &str| {
        format!(
            "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"200\" height=\"60\" \
             font-family=\"DejaVu Sans\" font-size=\"12\">{body}</svg>"
        )
    };
    let count = |body: &str| collisions(&page(body)).len();
    let word = "<text x=\"20\" y=\"20\">word</text>";
    assert_eq!(count(word), 0);
    assert_eq!(
        count(&format!("{word}<text x=\"20\" y=\"36\">word</text>")),
        0
    );
    assert_eq!(
        count(&format!("{word}<text x=\"25\" y=\"24\">word</text>")),
        1
    );
    assert_eq!(count("<text x=\"190\" y=\"20\">word</text>"), 1);
    assert_eq!(count("<text x=\"20\" y=\"5\">word</text>"), 1);
    let turned = "<g transform=\"translate(20 20) rotate(-90)\"><text>upwards</text></g>";
    assert_eq!(count(turned), 1);
}
