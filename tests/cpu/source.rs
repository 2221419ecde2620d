//! Reads GLSL and Rust source as far as the structure tests need it: declarations at
//! file level, includes, header comments. No parser: it relies on rustfmt and on the
//! style of `shaders/`.

#![allow(dead_code, reason = "each test uses a part")]

use std::collections::BTreeSet;
use std::fs;
use std::path::{Path, PathBuf};

/// A type and a name: a parameter or a member.
pub type Variable = (String, String);

/// A function at file level.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Function {
    pub name: String,
    pub result: String,
    pub parameters: Vec<Variable>,
}

/// A struct at file level.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Struct {
    pub name: String,
    pub members: Vec<Variable>,
}

/// What a file declares, in order.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Declarations {
    pub functions: Vec<Function>,
    pub structs: Vec<Struct>,
    /// Constants and variables of a GLSL file.
    pub globals: Vec<String>,
    /// Macros that a GLSL file defines.
    pub macros: Vec<String>,
}

/// A path from the crate's root.
pub fn root(path: &str) -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join(path)
}

/// The text of a file, by its path from the crate's root.
pub fn read(path: &str) -> String {
    fs::read_to_string(root(path)).unwrap_or_else(|error| panic!("{path}: {error}"))
}

/// Files below a folder with one of these endings, as sorted paths from that folder.
pub fn files(folder: &str, endings: &[&str]) -> Vec<String> {
    fn walk(folder: &Path, prefix: &str, found: &mut Vec<String>) {
        for entry in fs::read_dir(folder).expect("the folder is there") {
            let entry = entry.expect("the entry is readable");
            let name = format!("{prefix}{}", entry.file_name().to_string_lossy());
            if entry.path().is_dir() {
                walk(&entry.path(), &format!("{name}/"), found);
            } else {
                found.push(name);
            }
        }
    }
    let mut found = Vec::new();
    walk(&root(folder), "", &mut found);
    found.retain(|name| endings.iter().any(|ending| name.ends_with(ending)));
    found.sort();
    found
}

/// The text without `//` comments. (No string of the sources read here has a `//`.)
pub fn without_comments(text: &str) -> String {
    let code = |line: &str| line.split("//").next().unwrap_or("").trim_end().to_owned();
    text.lines().map(|line| code(line) + "\n").collect()
}

/// The names of `#include` lines.
pub fn includes(glsl: &str) -> Vec<String> {
    let named = |line: &str| {
        let rest = line
            .trim()
            .strip_prefix('#')?
            .trim()
            .strip_prefix("include")?;
        Some(rest.trim().trim_matches(['"', '<', '>']).to_owned())
    };
    without_comments(glsl).lines().filter_map(named).collect()
}

/// The include names that a header reaches, itself not among them.
pub fn reached(name: &str, text: &dyn Fn(&str) -> Option<String>) -> BTreeSet<String> {
    let mut found = BTreeSet::new();
    let mut left = includes(&text(name).unwrap_or_default());
    while let Some(next) = left.pop() {
        if found.insert(next.clone()) {
            left.extend(includes(&text(&next).unwrap_or_default()));
        }
    }
    found
}

/// Declarations of a GLSL file.
pub fn glsl(text: &str) -> Declarations {
    let mut found = Declarations::default();
    let mut code = String::new();
    let mut continued = false;
    for line in without_comments(text).lines() {
        let directive = line.trim_start().strip_prefix('#');
        if let Some(rest) = directive.and_then(|rest| rest.trim_start().strip_prefix("define ")) {
            found.macros.push(first_name(rest));
        }
        if directive.is_none() && !continued {
            code += line;
            code.push('\n');
        }
        continued = (directive.is_some() || continued) && line.ends_with('\\');
    }
    for (head, body) in pieces(&code) {
        let head = head.trim();
        if let Some(name) = head.strip_prefix("struct ") {
            let members = body.split(';').filter(|member| !member.trim().is_empty());
            found.structs.push(Struct {
                name: name.trim().to_owned(),
                members: members.map(glsl_variable).collect(),
            });
        } else if body.is_empty() {
            let declared = head.split('=').next().unwrap_or("").split('[').next();
            found.globals.push(glsl_variable(declared.unwrap_or("")).1);
        } else if let Some((before, rest)) = head.split_once('(') {
            let (result, name) = glsl_variable(before);
            let parameters = rest.rsplit_once(')').map_or("", |(inside, _)| inside);
            found.functions.push(Function {
                name,
                result,
                parameters: split_commas(parameters)
                    .iter()
                    .map(|p| glsl_variable(p))
                    .collect(),
            });
        }
    }
    found
}

/// Public functions and structs of a Rust file, its tests left out.
pub fn rust(text: &str) -> Declarations {
    let mut found = Declarations::default();
    let code = without_comments(text);
    let code = code.split("#[cfg(test)]").next().unwrap_or("");
    for (head, body) in pieces(code) {
        let head = head.replace("pub const fn ", "pub fn ");
        if let Some((_, rest)) = head.split_once("pub fn ") {
            let (inside, result) = match rest.rsplit_once("->") {
                Some((before, result)) => (before, result.trim()),
                None => (rest, "()"),
            };
            let (_, inside) = inside.split_once('(').unwrap_or_default();
            let inside = inside.rsplit_once(')').map_or("", |(inside, _)| inside);
            found.functions.push(Function {
                name: first_name(rest),
                result: result.to_owned(),
                parameters: split_commas(inside)
                    .iter()
                    .map(|p| rust_variable(p))
                    .collect(),
            });
        } else if let Some((_, rest)) = head.split_once("pub struct ") {
            found.structs.push(Struct {
                name: first_name(rest),
                members: split_commas(&body)
                    .iter()
                    .map(|m| rust_variable(m))
                    .collect(),
            });
        }
    }
    found
}

/// The identifier at the start of a text.
pub fn first_name(text: &str) -> String {
    let end = text.find(|c: char| !c.is_alphanumeric() && c != '_');
    text[..end.unwrap_or(text.len())].to_owned()
}

/// Every identifier.
pub fn words(text: &str) -> impl Iterator<Item = &str> {
    text.split(|c: char| !c.is_alphanumeric() && c != '_')
        .filter(|word| !word.is_empty())
}

/// Splits at commas outside brackets; drops what is empty.
pub fn split_commas(text: &str) -> Vec<String> {
    let mut parts = vec![String::new()];
    let mut depth = 0;
    for c in text.chars() {
        depth += i32::from("([{<".contains(c)) - i32::from(")]}>".contains(c));
        match parts.last_mut() {
            Some(last) if c != ',' || depth > 0 => last.push(c),
            _ => parts.push(String::new()),
        }
    }
    parts.retain(|part| !part.trim().is_empty());
    parts
}

/// Code at file level as (head, body in braces); the body is empty after a `;`.
fn pieces(code: &str) -> Vec<(String, String)> {
    let mut found = Vec::new();
    let (mut head, mut body, mut depth) = (String::new(), String::new(), 0);
    for c in code.chars() {
        match (c, depth) {
            ('{', 0) => depth = 1,
            ('}', 1) => {
                depth = 0;
                found.push((std::mem::take(&mut head), std::mem::take(&mut body) + " "));
            }
            (';', 0) => {
                // The `;` after a struct has no head.
                if !head.trim().is_empty() {
                    found.push((std::mem::take(&mut head), String::new()));
                }
                head.clear();
            }
            (c, 0) => head.push(c),
            (c, _) => {
                depth += i32::from(c == '{') - i32::from(c == '}');
                body.push(c);
            }
        }
    }
    found
}

fn glsl_variable(text: &str) -> Variable {
    let (before, name) = text.trim().rsplit_once(' ').unwrap_or_default();
    let kind = before.split_whitespace().last().unwrap_or("");
    (kind.to_owned(), name.to_owned())
}

fn rust_variable(text: &str) -> Variable {
    let (name, kind) = text.split_once(':').unwrap_or_default();
    let name = name.split_whitespace().last().unwrap_or("");
    (kind.trim().to_owned(), name.to_owned())
}
