//! A scene's kernel compiled, and on a device.

use super::{Form, Parameters, Program};
use crate::catalog::Profile as Functions;
use crate::compile::{check, to_spirv, to_spirv_lean};
use crate::interface::Profile;
use crate::scene::PUSH_BYTES;
use crate::spirv::drop_local_names;
use crate::vulkan::{
    Access, Buffer, BufferSlice, Device, Pipeline, PipelineDescription, Recording, Timing,
};
use crate::{Error, Result};
use std::sync::Arc;

impl Program {
    /// The linter's rules for its module.
    #[must_use]
    pub fn rules(&self) -> Profile {
        match (self.form, self.profile) {
            // Of bare numbers, which no map makes.
            (Form::Eight, _) => Profile::Wide,
            (_, Functions::Exact) => Profile::Float,
            (_, Functions::Native) => Profile::Native,
        }
    }

    /// The module as it is shipped: SPIR-V 1.3 of the flattened text, every float result
    /// `NoContraction`, held to the rules of its profile, and without the names that serve a
    /// debugger alone.
    ///
    /// # Errors
    /// Those of [`Program::named`].
    pub fn spirv(&self, text: &str) -> Result<Vec<u32>> {
        let words = self.named(text)?;
        drop_local_names(&words).map_err(|problem| self.wrong(problem.to_string()))
    }

    /// The same with the names of variables, which other languages take over.
    ///
    /// # Errors
    /// [`Error::Shader`] for what the compiler or the linter refuses, which is a defect of this
    /// crate.
    pub fn named(&self, text: &str) -> Result<Vec<u32>> {
        let words = match self.form {
            // What packs 64 bits is not among the fewer declarations.
            Form::Eight => to_spirv(text, &[], &mut |_| None),
            Form::Words | Form::Four => to_spirv_lean(text),
        };
        words
            .and_then(|words| check(&words, self.rules()))
            .map_err(|problem| self.wrong(problem))
    }

    fn wrong(&self, problem: String) -> Error {
        Error::Shader {
            shader: self.name.clone(),
            problem,
        }
    }
}

/// Samples of a scene by its own kernel.
pub struct Sampler {
    device: Arc<Device>,
    pipeline: Arc<Pipeline>,
    program: Program,
    tables: Vec<Buffer>,
}

impl Sampler {
    /// A pipeline of the program's module, and its tables in buffers. `words` need not be the
    /// program's own, so that tests can run others.
    ///
    /// # Errors
    /// [`Error::Arguments`] of [`Form::Eight`] where the device was not opened with integers of
    /// 64 bits; those of the device.
    pub fn new(device: &Arc<Device>, program: &Program, words: &[u32]) -> Result<Self> {
        if program.form == Form::Eight && !device.has_int64() {
            return Err(Error::Arguments {
                asked: format!("{} in stores of 64-bit integers", program.name),
                limit: format!("{} was not opened with them", device.info().name),
                remedy: "strip it without --int64".to_owned(),
            });
        }
        let uniforms: Vec<u32> = program.parameter_binding().into_iter().collect();
        let description = PipelineDescription {
            name: &program.name,
            spirv: words,
            bindings: &program.bindings(),
            push_constant_bytes: match program.parameters {
                Parameters::Push => PUSH_BYTES,
                Parameters::Uniform => 0,
            },
            specialization: &[],
        };
        let table = |words: &[u32]| {
            let mut buffer = Buffer::new(device, 4 * words.len() as u64, Access::Upload)?;
            buffer.write(0, bytemuck::cast_slice(words))?;
            Ok(buffer)
        };
        let tables = program.tables.iter().map(|one| table(&one.words));
        Ok(Self {
            device: Arc::clone(device),
            pipeline: Arc::new(Pipeline::with_uniforms(device, &description, &uniforms)?),
            tables: tables.collect::<Result<_>>()?,
            program: program.clone(),
        })
    }

    /// Makes samples into a buffer of at least [`Program::sample_bytes`].
    ///
    /// # Errors
    /// [`Error::Arguments`] for a smaller buffer, for samples past the scene's last, and for a
    /// first index that is no multiple of [`Program::aligned`]; those of the device.
    pub fn dispatch(&self, results: &Buffer, first: u32, count: u32) -> Result<Timing> {
        self.check_end(first, count)?;
        self.dispatch_any(results, first, count)
    }

    /// Records the same into commands of corput's or of the caller's, and a slice of a buffer of
    /// either, of which whole invocations are written.
    ///
    /// # Errors
    /// Those of [`Self::dispatch`], and [`Error::Arguments`] for a program that has its parameters
    /// in a uniform buffer.
    pub fn record(
        &self,
        recording: &mut Recording,
        target: &BufferSlice,
        first: u32,
        count: u32,
    ) -> Result<()> {
        if self.program.parameter_binding().is_some() {
            return Err(Error::Arguments {
                asked: format!("{} recorded", self.program.name),
                limit: "its parameters are in a uniform buffer".to_owned(),
                remedy: "strip it with push constants, as for SPIR-V".to_owned(),
            });
        }
        self.check_end(first, count)?;
        self.check(target.bytes(), first, count)?;
        let numbers = self.program.tables.iter().map(|table| table.binding);
        let mut slices = vec![(super::SAMPLES, target.clone())];
        slices.extend(numbers.zip(self.tables.iter().map(Buffer::whole)));
        let push = [first, count];
        let groups = self.program.groups(u64::from(count));
        if groups == 0 {
            return Ok(());
        }
        recording.dispatch(&self.pipeline, &slices, bytemuck::cast_slice(&push), groups)
    }

    fn check_end(&self, first: u32, count: u32) -> Result<()> {
        let end = u64::from(first) + u64::from(count);
        if end > self.program.samples {
            return Err(Error::Arguments {
                asked: format!("samples {first} to {}", end.saturating_sub(1)),
                limit: format!("{} has {}", self.program.name, self.program.samples),
                remedy: "ask for fewer, or strip it for more".to_owned(),
            });
        }
        Ok(())
    }

    /// The same also past the last sample, where points are not the sampler's: for times.
    pub(crate) fn dispatch_any(&self, results: &Buffer, first: u32, count: u32) -> Result<Timing> {
        self.check(results.bytes(), first, count)?;
        let parameters = [first, count, 0, 0];
        let mut buffers = vec![(super::SAMPLES, results)];
        let numbers = self.program.tables.iter().map(|table| table.binding);
        buffers.extend(numbers.zip(&self.tables));
        let mut uniform = None;
        if self.program.parameter_binding().is_some() {
            let mut buffer = Buffer::new(&self.device, 16, Access::Upload)?;
            buffer.write(0, bytemuck::cast_slice(&parameters))?;
            uniform = Some(buffer);
        }
        let push: &[u8] = match self.program.parameters {
            Parameters::Push => bytemuck::cast_slice(&parameters[..2]),
            Parameters::Uniform => &[],
        };
        buffers.extend(self.program.parameter_binding().zip(uniform.as_ref()));
        let groups = self.program.groups(u64::from(count));
        self.device.run(&self.pipeline, &buffers, push, groups)
    }

    /// Checks the first sample, and the room for all.
    fn check(&self, bytes: u64, first: u32, count: u32) -> Result<()> {
        let aligned = self.program.aligned;
        if !first.is_multiple_of(aligned) {
            return Err(Error::Arguments {
                asked: format!("samples from {first}"),
                limit: format!("{} begins at multiples of {aligned}", self.program.name),
                remedy: format!(
                    "begin at {}, or strip it without --int64",
                    first - first % aligned
                ),
            });
        }
        let needed = self.program.sample_bytes(count.into());
        if bytes < needed {
            return Err(Error::Arguments {
                asked: format!("{count} samples in {bytes} bytes"),
                limit: format!("they need {needed}"),
                remedy: "give a larger buffer".to_owned(),
            });
        }
        Ok(())
    }

    /// Records of samples, all at once.
    ///
    /// # Errors
    /// Those of the device.
    pub fn run(&self, first: u32, count: u32) -> Result<Vec<u32>> {
        let bytes = self.program.sample_bytes(u64::from(count)).max(16);
        let mut results = Buffer::new(&self.device, bytes, Access::Readback)?;
        self.dispatch(&results, first, count)?;
        let made = 4 * u64::from(self.program.record.words) * u64::from(count);
        results.read(0, made, bytemuck::pod_collect_to_vec)
    }
}
