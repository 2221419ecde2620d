//! Macros: definitions, and what a run of tokens expands to.
//!
//! Expansion only serves to see what an item declares and uses. What is printed keeps its
//! macros. The method is Prosser's, that of the C standard: a token carries the macros that
//! must not expand it again.

use std::collections::HashMap;

use super::Fault;
use super::lex::{Kind, Names, Symbol, Token};

/// One `#define`.
#[derive(Clone, Debug)]
pub(super) struct Definition {
    pub(super) name: Symbol,
    /// None without parentheses.
    pub(super) parameters: Option<Vec<Symbol>>,
    pub(super) body: Vec<Token>,
    /// The tokens of its line from `#` on; none of the compiler's own.
    pub(super) written: Vec<Token>,
    /// Whether it guards its file against being included twice.
    pub(super) guard: bool,
}

impl Definition {
    /// Whether another defines the same, as a repeated definition must.
    pub(super) fn same(&self, other: &Self) -> bool {
        let symbols = |d: &Self| d.body.iter().map(|t| t.symbol).collect::<Vec<_>>();
        self.parameters == other.parameters && symbols(self) == symbols(other)
    }
}

/// A token after expansion.
#[derive(Clone, Copy, Debug)]
pub(super) struct Live {
    pub(super) kind: Kind,
    pub(super) symbol: Symbol,
    /// The token of the text that it comes from: itself, or the macro's name.
    pub(super) raw: usize,
    /// Which set of macros must leave it alone.
    hide: usize,
}

/// The macros that are defined at a place, and what expansion has met.
#[derive(Debug)]
pub(super) struct Macros {
    pub(super) definitions: Vec<Definition>,
    pub(super) defined: HashMap<Symbol, usize>,
    /// Uses: token of the text, definition.
    pub(super) uses: Vec<(usize, usize)>,
    /// Of a macro's name in the text, the last token of its arguments.
    pub(super) ends: HashMap<usize, usize>,
    hidden: Vec<Vec<Symbol>>,
    open: Symbol,
    close: Symbol,
    comma: Symbol,
    paste: Symbol,
    hash: Symbol,
}

impl Macros {
    pub(super) fn new(names: &mut Names) -> Self {
        Self {
            definitions: Vec::new(),
            defined: HashMap::new(),
            uses: Vec::new(),
            ends: HashMap::new(),
            hidden: vec![Vec::new()],
            open: names.symbol("("),
            close: names.symbol(")"),
            comma: names.symbol(","),
            paste: names.symbol("##"),
            hash: names.symbol("#"),
        }
    }

    /// Defines a macro of the compiler's as 1; the token only says where.
    pub(super) fn define_one(&mut self, name: &str, token: &Token, names: &mut Names) {
        let name = names.symbol(name);
        let one = Token {
            kind: Kind::Number,
            symbol: names.symbol("1"),
            ..*token
        };
        self.defined.insert(name, self.definitions.len());
        self.definitions.push(Definition {
            name,
            parameters: None,
            body: vec![one],
            written: Vec::new(),
            guard: false,
        });
    }

    /// The tokens of a run, the first of which is token `raw` of the text, as they expand.
    pub(super) fn expand_run(
        &mut self,
        run: &[Token],
        raw: usize,
        names: &mut Names,
    ) -> Result<Vec<Live>, Fault> {
        let input = run.iter().zip(raw..).map(|(token, raw)| Live {
            kind: token.kind,
            symbol: token.symbol,
            raw,
            hide: 0,
        });
        self.expand(input.collect(), names)
    }

    fn expand(&mut self, mut input: Vec<Live>, names: &mut Names) -> Result<Vec<Live>, Fault> {
        input.reverse();
        let mut output = Vec::with_capacity(input.len());
        while let Some(token) = input.pop() {
            let visible =
                token.kind == Kind::Name && !self.hidden[token.hide].contains(&token.symbol);
            let found = self.defined.get(&token.symbol).filter(|_| visible).copied();
            let Some(index) = found else {
                output.push(token);
                continue;
            };
            let definition = self.definitions[index].clone();
            let mut hide = self.hidden[token.hide].clone();
            let mut arguments = Vec::new();
            if let Some(parameters) = &definition.parameters {
                if input.last().is_none_or(|next| next.symbol != self.open) {
                    output.push(token);
                    continue;
                }
                let close = self.arguments(&token, &mut input, &mut arguments)?;
                if parameters.is_empty() && arguments.len() == 1 && arguments[0].is_empty() {
                    arguments.clear();
                }
                if arguments.len() != parameters.len() {
                    return Err(Fault::arguments(token.raw, parameters.len()));
                }
                let after = &self.hidden[close.hide];
                hide.retain(|name| after.contains(name));
                let end = self.ends.entry(token.raw).or_insert(close.raw);
                *end = close.raw.max(*end);
            }
            hide.push(token.symbol);
            self.uses.push((token.raw, index));
            self.hidden.push(hide);
            let hide = self.hidden.len() - 1;
            let made = self.substitute(&definition, &arguments, token.raw, hide, names)?;
            input.extend(made.into_iter().rev());
        }
        Ok(output)
    }

    /// Takes a call's arguments from the input, and gives the parenthesis that closes it.
    fn arguments(
        &self,
        name: &Live,
        input: &mut Vec<Live>,
        arguments: &mut Vec<Vec<Live>>,
    ) -> Result<Live, Fault> {
        input.pop();
        let mut depth = 0;
        let mut argument = Vec::new();
        while let Some(token) = input.pop() {
            if depth == 0 && token.symbol == self.close {
                arguments.push(argument);
                return Ok(token);
            }
            if depth == 0 && token.symbol == self.comma {
                arguments.push(std::mem::take(&mut argument));
                continue;
            }
            depth += i32::from(token.symbol == self.open) - i32::from(token.symbol == self.close);
            argument.push(token);
        }
        Err(Fault::at(
            name.raw,
            "the arguments of a macro do not end before the next directive",
            "close the parenthesis, and write no directive among the arguments",
        ))
    }

    /// The body with arguments in place of parameters, and pasted names.
    fn substitute(
        &mut self,
        definition: &Definition,
        arguments: &[Vec<Live>],
        raw: usize,
        hide: usize,
        names: &mut Names,
    ) -> Result<Vec<Live>, Fault> {
        let parameters = definition.parameters.as_deref().unwrap_or_default();
        let mut made: Vec<Live> = Vec::with_capacity(definition.body.len());
        let mut pasting = false;
        for (at, token) in definition.body.iter().enumerate() {
            if token.symbol == self.paste {
                pasting = true;
                continue;
            }
            if token.symbol == self.hash {
                return Err(Fault::at(
                    raw,
                    "a macro makes a string; GLSL has none",
                    "remove the `#` of its body",
                ));
            }
            let next = definition.body.get(at + 1);
            let pasted = pasting || next.is_some_and(|next| next.symbol == self.paste);
            let parameter = parameters.iter().position(|name| *name == token.symbol);
            let mut part = match parameter.and_then(|number| arguments.get(number)) {
                Some(argument) if pasted => argument.clone(),
                Some(argument) => self.expand(argument.clone(), names)?,
                None => vec![Live {
                    kind: token.kind,
                    symbol: token.symbol,
                    raw,
                    hide: 0,
                }],
            };
            if pasted && part.is_empty() {
                return Err(Fault::at(
                    raw,
                    "a macro pastes an empty argument",
                    "give it a name",
                ));
            }
            for token in &mut part {
                token.hide = self.union(token.hide, hide);
            }
            if std::mem::take(&mut pasting)
                && let (Some(left), Some(right)) = (made.pop(), part.first_mut())
            {
                right.symbol = joined(&left, right, names)?;
                right.kind = left.kind;
                right.raw = left.raw;
            }
            made.extend(part);
        }
        Ok(made)
    }

    /// The set of macros that are in one of two sets.
    fn union(&mut self, a: usize, b: usize) -> usize {
        if a == 0 || a == b {
            return b;
        }
        let mut all = self.hidden[a].clone();
        all.extend(&self.hidden[b]);
        self.hidden.push(all);
        self.hidden.len() - 1
    }
}

/// The symbol of two tokens pasted: a name, since GLSL pastes nothing else of use.
fn joined(left: &Live, right: &Live, names: &mut Names) -> Result<Symbol, Fault> {
    let word = |token: &Live| matches!(token.kind, Kind::Name | Kind::Number);
    if left.kind != Kind::Name || !word(right) {
        return Err(Fault::at(
            left.raw,
            "a macro pastes what is no name",
            "paste names and digits only",
        ));
    }
    let text = format!("{}{}", names.text(left.symbol), names.text(right.symbol));
    if !text.bytes().all(|c| c.is_ascii_alphanumeric() || c == b'_') {
        return Err(Fault::at(
            left.raw,
            "a macro pastes what is no name",
            "paste names and digits only",
        ));
    }
    Ok(names.symbol(&text))
}
