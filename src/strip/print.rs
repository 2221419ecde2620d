//! The kept declarations as one text.

use super::item::Item;
use super::lex::Token;
use super::preprocess::{Directive, Text};

/// Which parts of a text are kept.
pub(super) struct Kept {
    pub(super) items: Vec<bool>,
    /// By definition.
    pub(super) macros: Vec<bool>,
}

impl Kept {
    /// The items that are reached, and the macros that they use.
    pub(super) fn new(text: &Text, items: &[Item], reached: Vec<bool>) -> Self {
        let mut macros = vec![false; text.macros.definitions.len()];
        for (raw, definition) in &text.macros.uses {
            let index = items.partition_point(|item| item.raw.end <= *raw);
            let inside = items.get(index).is_some_and(|item| item.raw.contains(raw));
            let kept = inside && reached.get(index) == Some(&true);
            if let Some(used) = macros.get_mut(*definition).filter(|_| kept) {
                *used = true;
            }
        }
        Self {
            items: reached,
            macros,
        }
    }

    /// Whether a directive is kept.
    pub(super) fn directive(&self, directive: &Directive) -> bool {
        match directive {
            Directive::Define(index) | Directive::Undefine(index, _) => {
                self.macros.get(*index) == Some(&true)
            }
            Directive::Pragma(_) => true,
        }
    }
}

/// The text of what is kept.
pub(super) fn print(text: &Text, items: &[Item], kept: &Kept) -> String {
    let mut printer = Printer {
        text,
        out: format!("#version {}\n", text.version),
        file: None,
        noted: vec![false; text.sources.len()],
        long: true,
    };
    for line in &text.extensions {
        printer.out += line;
        printer.out.push('\n');
    }
    let licence = env!("CARGO_PKG_LICENSE");
    let version = env!("CARGO_PKG_VERSION");
    printer.out += &format!("// corput {version}, {licence}: what main() reaches.\n");
    let mut directives = text.directives.iter().peekable();
    for (item, keep) in items.iter().zip(&kept.items) {
        while let Some((_, directive)) = directives.next_if(|(at, _)| *at <= item.raw.start) {
            printer.directive(directive, kept);
        }
        if *keep {
            let tokens = text.raw.get(item.raw.clone()).unwrap_or_default();
            printer.piece(tokens, text.item(tokens));
        }
    }
    for (_, directive) in directives {
        printer.directive(directive, kept);
    }
    printer.out
}

struct Printer<'a> {
    text: &'a Text,
    out: String,
    /// The file of the last piece.
    file: Option<usize>,
    /// Files that were named.
    noted: Vec<bool>,
    /// Whether the last piece takes several lines.
    long: bool,
}

impl Printer<'_> {
    fn directive(&mut self, directive: &Directive, kept: &Kept) {
        if !kept.directive(directive) {
            return;
        }
        let tokens = match directive {
            Directive::Define(index) => {
                let definition = self.text.macros.definitions.get(*index);
                definition.map_or(&[][..], |definition| &definition.written)
            }
            Directive::Undefine(_, line) | Directive::Pragma(line) => line,
        };
        self.piece(tokens, self.text.written(tokens));
    }

    fn piece(&mut self, tokens: &[Token], written: String) {
        let Some(first) = tokens.first() else {
            return;
        };
        let comments = self.text.above(first);
        let long = written.contains('\n') || !comments.is_empty();
        if self.file != Some(first.file) {
            self.file = Some(first.file);
            self.note(first.file);
        } else if long || self.long {
            self.out.push('\n');
        }
        self.long = long;
        for line in comments {
            self.out += line;
            self.out.push('\n');
        }
        self.out += &written;
        self.out.push('\n');
    }

    /// Says where what follows comes from, and at first what its file says of its licence.
    fn note(&mut self, file: usize) {
        let Some(source) = self.text.sources.get(file) else {
            return;
        };
        self.out += match source.name.as_str() {
            super::MAIN => "\n// The shader itself.",
            super::OUTSIDE => "\n// Macros from outside.",
            _ => "\n// From ",
        };
        if ![super::MAIN, super::OUTSIDE].contains(&source.name.as_str()) {
            self.out += &source.name;
            self.out.push('.');
        }
        let named = self
            .noted
            .get_mut(file)
            .map(|noted| std::mem::replace(noted, true));
        if named == Some(false)
            && let Some(licence) = source.licence()
        {
            self.out.push(' ');
            self.out += licence;
        }
        self.out.push('\n');
    }
}

impl super::lex::Source {
    /// The line of the comments at its head that speaks of a licence.
    fn licence(&self) -> Option<&str> {
        let end = self
            .tokens
            .first()
            .map_or(self.text.len(), |token| token.start);
        let head = self.text.get(..end)?;
        let mut lines = head.lines();
        let line = lines.find(|line| line.contains("licence") || line.contains("License"))?;
        Some(
            line.trim_start_matches(['/', '*', ' '])
                .trim_end_matches(['/', '*', ' ', '\\', '\r']),
        )
    }
}

impl Text {
    /// Tokens of a directive with what stands between them, less comments.
    pub(super) fn written(&self, tokens: &[Token]) -> String {
        self.joined(tokens, |source, between| {
            let mut text = String::new();
            let mut from = between.0;
            for comment in source.comments_in(between.0, between.1) {
                text += source.text.get(from..comment.start).unwrap_or("");
                text.push(' ');
                from = comment.end;
            }
            text += source.text.get(from..between.1).unwrap_or("");
            text
        })
    }

    /// Tokens of a declaration, each on its line, without comments and lines between them.
    pub(super) fn item(&self, tokens: &[Token]) -> String {
        self.joined(tokens, |source, (from, to)| {
            let gap = source.text.get(from..to).unwrap_or("");
            match gap.rsplit_once('\n') {
                Some((_, line)) => {
                    let indent = line.len() - line.trim_start().len();
                    format!("\n{}", line.get(..indent).unwrap_or(""))
                }
                None if source.comments_in(from, to).next().is_some() => " ".to_owned(),
                None => gap.to_owned(),
            }
        })
    }

    fn joined(
        &self,
        tokens: &[Token],
        between: impl Fn(&super::lex::Source, (usize, usize)) -> String,
    ) -> String {
        let mut text = String::new();
        let mut last: Option<&Token> = None;
        for token in tokens {
            match (last, self.sources.get(token.file)) {
                (Some(last), Some(source)) if last.file == token.file => {
                    text += &between(source, (last.end, token.start));
                }
                (Some(_), _) => text.push('\n'),
                _ => {}
            }
            text += self.names.text(token.symbol);
            last = Some(token);
        }
        text
    }

    /// The lines of comment directly above a token that begins its line.
    fn above(&self, token: &Token) -> Vec<&str> {
        let Some(source) = self.sources.get(token.file) else {
            return Vec::new();
        };
        let blank = |from: usize, to: usize| {
            source
                .text
                .get(from..to)
                .is_some_and(|text| text.trim().is_empty())
        };
        let start = |line: usize| source.lines.get(line).copied().unwrap_or(source.text.len());
        let mut line = source.line_of(token.start);
        if !blank(start(line), token.start) {
            return Vec::new();
        }
        let mut found = Vec::new();
        let before = source
            .comments
            .partition_point(|comment| comment.end <= token.start);
        for comment in source
            .comments
            .get(..before)
            .unwrap_or_default()
            .iter()
            .rev()
        {
            let (from, to) = (
                source.line_of(comment.start),
                source.line_of(comment.end - 1),
            );
            let alone = blank(start(from), comment.start) && blank(comment.end, start(to + 1));
            if to + 1 != line || !alone {
                break;
            }
            found.push(
                source
                    .text
                    .get(comment.start..comment.end)
                    .unwrap_or("")
                    .trim_end(),
            );
            line = from;
        }
        found.reverse();
        found
    }
}

impl super::lex::Source {
    fn comments_in(&self, from: usize, to: usize) -> impl Iterator<Item = &super::lex::Comment> {
        let first = self
            .comments
            .partition_point(|comment| comment.start < from);
        let rest = self.comments.get(first..).unwrap_or_default();
        rest.iter().take_while(move |comment| comment.end <= to)
    }
}
