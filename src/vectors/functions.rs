//! Functions of the headers: calls with critical arguments and random ones.

use super::{Entry, Table, about, thinned};
use crate::Result;
use crate::catalog::FUNCTIONS;
use crate::check::{arguments, function_words};
use crate::interface::KERNELS;

pub fn each(take: &mut dyn FnMut(&Entry) -> Result<()>) -> Result<()> {
    for function in FUNCTIONS {
        let mut words = Vec::new();
        for call in thinned(arguments(function.kind)) {
            words.extend(call);
            words.extend(function_words(function.name, call));
        }
        let kernel = KERNELS.iter().find(|kernel| kernel.name == function.kernel);
        take(&Entry {
            kind: "function",
            name: function.name.to_owned(),
            about: about([
                ("header", format!("corput/{}.glsl", function.header).into()),
                ("tier", function.tier.letter().into()),
                ("kernel", kernel.map_or("", |kernel| kernel.source).into()),
                ("FUNCTION", function.id.into()),
            ]),
            table: Some(Table {
                file: format!("functions/{}.npy", function.name),
                columns: 8,
                words,
                axes: None,
            }),
            tables: Vec::new(),
        })?;
    }
    Ok(())
}
