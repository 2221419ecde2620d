//! What a host needs to know of a scene's module.

use super::{Form, GROUP, Parameters, Program, SAMPLES};
use crate::strip::host::{Field, Interface, Number, Resource, identifier};
use crate::{Error, Result};

impl Program {
    /// The interface of its module.
    ///
    /// # Errors
    /// [`Error::Shader`] for words that are no module, or one with other bindings.
    pub fn interface(&self, words: &[u32]) -> Result<Interface> {
        let wrong = |problem: String| Error::Shader {
            shader: self.name.clone(),
            problem,
        };
        let facts = crate::spirv::describe(words).map_err(|error| wrong(error.to_string()))?;
        let found = facts.bindings;
        let known: Vec<(u32, u32)> = self.bindings().into_iter().map(|b| (0, b)).collect();
        if found != known {
            return Err(wrong(format!("it binds {found:?}, not {known:?}")));
        }
        let buffer = |binding, name: &str, stride, read_only| Resource {
            set: 0,
            binding,
            name: name.to_owned(),
            uniform_bytes: None,
            stride,
            read_only,
        };
        let stride = 4 * self.record.words;
        let mut resources = vec![buffer(SAMPLES, "samples", stride, false)];
        let tables = self.tables.iter();
        resources.extend(tables.map(|table| buffer(table.binding, &table.name, 4, true)));
        resources.extend(self.parameter_binding().map(|binding| Resource {
            uniform_bytes: Some(16),
            ..buffer(binding, "parameters", 16, true)
        }));
        let field = |name: &str, offset, doc: &str| Field {
            name: name.to_owned(),
            offset,
            doc: doc.to_owned(),
        };
        let push = match self.parameters {
            Parameters::Uniform => Vec::new(),
            Parameters::Push => vec![
                field("first", 0, "Index of the first sample."),
                field("count", 4, "Samples to make."),
            ],
        };
        let number = |name: String, value: u64, doc: String| Number { name, value, doc };
        let mut numbers = vec![
            number(
                "record_words".into(),
                self.record.words.into(),
                "Words of a sample".into(),
            ),
            number(
                "samples_multiple".into(),
                self.multiple().into(),
                "The buffer holds the count of samples rounded up to a multiple of this".into(),
            ),
            number(
                "first_multiple".into(),
                self.aligned.into(),
                "The index of the first sample is a multiple of this".into(),
            ),
            number(
                "needs_int64".into(),
                (self.form == Form::Eight).into(),
                "Whether the device must be opened with shaderInt64".into(),
            ),
            number(
                "run".into(),
                self.run.into(),
                "Samples of an invocation".into(),
            ),
            number(
                "samples_most".into(),
                self.samples,
                "No sample has this index or more".into(),
            ),
        ];
        numbers.extend(self.record.fields.iter().map(|field| {
            let doc = format!(
                "First word of {} in a sample: {}",
                field.key,
                field.values.join(", ")
            );
            number(format!("word_{}", field.name), field.first.into(), doc)
        }));
        Ok(Interface {
            name: identifier(&self.name),
            entry_point: "main".to_owned(),
            workgroup: [GROUP, 1, 1],
            resources,
            push,
            constants: Vec::new(),
            spirv_words: words.len(),
            numbers,
        })
    }
}
