//! The table's place in README.md, between two comments.

use std::error::Error;

const PATH: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/../../README.md");
const BEGIN: &str = "<!-- made by benches/peers/run --python --write -->\n";
const END: &str = "<!-- end -->\n";

/// Writes the table there.
pub fn write(table: &str) -> Result<(), Box<dyn Error>> {
    std::fs::write(PATH, with(table)?)?;
    Ok(())
}

/// README.md with this table for the one that it has.
pub fn with(table: &str) -> Result<String, Box<dyn Error>> {
    let page = std::fs::read_to_string(PATH)?;
    let none = || format!("README.md has no `{}` with its end", BEGIN.trim_end());
    Ok(replaced(&page, table).ok_or_else(none)?)
}

fn replaced(page: &str, table: &str) -> Option<String> {
    let (before, rest) = page.split_once(BEGIN)?;
    let (_, after) = rest.split_once(END)?;
    Some(format!("{before}{BEGIN}\n{}\n\n{END}{after}", table.trim()))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_is_around_the_table_stays() {
        let page = format!("a\n{END}b\n{BEGIN}\nold\n\n{END}c\n{END}");
        let expected = format!("a\n{END}b\n{BEGIN}\nnew\n\n{END}c\n{END}");
        assert_eq!(replaced(&page, "new\n"), Some(expected));
        assert_eq!(replaced("a\n", "new\n"), None);
    }

    #[test]
    fn the_readme_has_the_place() {
        with("").expect("a place");
    }
}
