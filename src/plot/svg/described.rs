//! Figures that say what they show, and whose page may colour them anew.
//!
//! A group's class tells a style sheet what the shapes in it are; without one they have the
//! colours of their attributes, which a style sheet overrules.

use super::Canvas;
use crate::report::escape;
use std::fmt::Write;

// Writing to a String cannot fail, so the results of `write!` are dropped.
impl Canvas {
    /// What `draw` draws, under a class.
    pub fn group(&mut self, class: &str, draw: impl FnOnce(&mut Self)) {
        let _ = writeln!(self.body, r#"<g class="{class}">"#);
        draw(self);
        self.body.push_str("</g>\n");
    }

    /// As `group`, of less weight.
    pub fn faint_group(&mut self, class: &str, draw: impl FnOnce(&mut Self)) {
        let _ = writeln!(self.body, r#"<g class="{class}" opacity="0.45">"#);
        draw(self);
        self.body.push_str("</g>\n");
    }

    /// A small picture within a line of text, which says what it is.
    pub fn finish_mark(self) -> String {
        let Self {
            width,
            height,
            body,
        } = self;
        format!(
            "<svg width=\"{width}\" height=\"{height}\" viewBox=\"0 0 {width} {height}\" \
             aria-hidden=\"true\">{body}</svg>"
        )
    }

    /// A translucent area.
    pub fn band(&mut self, corners: &[(f64, f64)], colour: &str) {
        let corners: Vec<String> = corners
            .iter()
            .map(|(x, y)| format!("{x:.2},{y:.2}"))
            .collect();
        let _ = writeln!(
            self.body,
            r#"<polygon points="{}" fill="{colour}" fill-opacity="0.2"/>"#,
            corners.join(" ")
        );
    }

    /// As `finish`, with a title and a description for those who do not see it.
    pub fn finish_described(self, title: &str, description: &str) -> String {
        let Self {
            width,
            height,
            body,
        } = self;
        format!(
            "<svg xmlns=\"http://www.w3.org/2000/svg\" role=\"img\" width=\"{width}\" \
             height=\"{height}\" viewBox=\"0 0 {width} {height}\" \
             font-family=\"DejaVu Sans, Verdana, sans-serif\">\n<title>{}</title>\n\
             <desc>{}</desc>\n\
             <rect class=\"paper\" width=\"{width}\" height=\"{height}\" fill=\"#ffffff\"/>\n\
             {body}</svg>\n",
            escape(title),
            escape(description)
        )
    }
}
