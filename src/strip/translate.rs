//! A module in other shading languages, by naga.
//!
//! naga knows neither carries nor extended products, so compile with `CORPUT_PORTABLE`. It drops
//! `NoContraction`, so tier F promises nothing in its outputs; tier I, which is integers, does.

use naga::back::{hlsl, msl, wgsl};
use naga::valid::{Capabilities, ModuleInfo, ValidationFlags, Validator};

use crate::{Error, Result};

/// A module to translate.
#[derive(Clone, Copy, Debug)]
pub enum Shader<'a> {
    /// GLSL without includes and attributes, as naga reads it.
    Glsl(&'a str),
    /// SPIR-V.
    Spirv(&'a [u32]),
}

/// What the comment at the head of each output says.
#[derive(Clone, Copy, Debug)]
pub struct About<'a> {
    /// What the module is.
    pub what: &'a str,
    /// The scene that it was made for, by its file's name.
    pub scene: &'a str,
}

/// The languages.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Translations {
    /// WGSL, read again and validated.
    pub wgsl: String,
    /// HLSL, shader model 5.1; no compiler has seen it.
    pub hlsl: String,
    /// Metal 2.1; no compiler has seen it.
    pub msl: String,
}

/// Writes a compute shader with entry point `main` as WGSL, HLSL and MSL. These know no
/// specialization constants, or naga does not: [`bake`](super::bake) them first.
///
/// # Errors
/// Those of [`Translator::new`] and of each language.
pub fn translate(shader: Shader, about: &About) -> Result<Translations> {
    let translator = Translator::new(shader, *about)?;
    Ok(Translations {
        wgsl: translator.wgsl()?,
        hlsl: translator.hlsl()?,
        msl: translator.msl()?,
    })
}

/// A compute shader with entry point `main`, read once, to write in the languages that are
/// wanted.
#[derive(Debug)]
pub struct Translator<'a> {
    module: naga::Module,
    info: ModuleInfo,
    about: About<'a>,
}

impl<'a> Translator<'a> {
    /// Reads a shader.
    ///
    /// # Errors
    /// [`Error::Arguments`] with what naga says, of a shader that it does not read, that has
    /// specialization constants, or that no language can have: such as numbers of 64 bits and
    /// literals that are infinite or NaN.
    pub fn new(shader: Shader, about: About<'a>) -> Result<Self> {
        let refused = |language, limit| refused(&about, language, limit);
        let (module, source) = match shader {
            Shader::Glsl(text) => {
                let parsed = naga::front::glsl::Frontend::default()
                    .parse(&naga::ShaderStage::Compute.into(), text);
                let module = parsed.map_err(|error| refused("GLSL", error.emit_to_string(text)))?;
                (module, text)
            }
            Shader::Spirv(words) => {
                let bytes: Vec<u8> = words.iter().flat_map(|word| word.to_le_bytes()).collect();
                let options = naga::front::spv::Options::default();
                let parsed = naga::front::spv::parse_u8_slice(&bytes, &options);
                let mut module = parsed.map_err(|error| refused("SPIR-V", error.to_string()))?;
                plain_names(&mut module);
                (module, "")
            }
        };
        if !module.overrides.is_empty() {
            let left = format!(
                "{} specialization constants are left",
                module.overrides.len()
            );
            return Err(refused("any language", left));
        }
        let info = valid(&module, source).map_err(|error| refused("any language", error))?;
        Ok(Self {
            module,
            info,
            about,
        })
    }

    /// WGSL, read again and validated.
    ///
    /// # Errors
    /// [`Error::Arguments`] with what naga says that the language lacks.
    pub fn wgsl(&self) -> Result<String> {
        let text = to_wgsl(&self.module, &self.info);
        let text = text.map_err(|error| refused(&self.about, "WGSL", error))?;
        Ok(head(&self.about, "") + &text)
    }

    /// HLSL, shader model 5.1; no compiler has seen it.
    ///
    /// # Errors
    /// [`Error::Arguments`] with what naga says that the language lacks.
    pub fn hlsl(&self) -> Result<String> {
        let text = to_hlsl(&self.module, &self.info);
        let text = text.map_err(|error| refused(&self.about, "HLSL", error))?;
        Ok(head(&self.about, UNSEEN) + &text)
    }

    /// Metal 2.1; no compiler has seen it.
    ///
    /// # Errors
    /// [`Error::Arguments`] with what naga says that the language lacks.
    pub fn msl(&self) -> Result<String> {
        let text = to_msl(&self.module, &self.info);
        let text = text.map_err(|error| refused(&self.about, "MSL", error))?;
        Ok(head(&self.about, UNSEEN) + &text)
    }
}

/// Takes from the names of functions what glslang adds: the types of their parameters, of which
/// languages would make names of a thousand letters. naga numbers those that are then equal.
fn plain_names(module: &mut naga::Module) {
    for (_, function) in module.functions.iter_mut() {
        if let Some(name) = &mut function.name {
            name.truncate(name.find('(').unwrap_or(name.len()));
        }
    }
}

fn refused(about: &About, language: &str, limit: String) -> Error {
    Error::Arguments {
        asked: format!("{} in {language}", about.what),
        limit: format!("naga: {}", limit.trim()),
        remedy: "define CORPUT_PORTABLE, and bake its specialization constants, before it is \
                 compiled; or do without that language"
            .to_owned(),
    }
}

/// What the languages that nothing here can compile say.
const UNSEEN: &str = "// generated, not compiled here\n";

fn head(about: &About, more: &str) -> String {
    let line = |text: &str| text.replace(|c: char| c.is_control() || c == '\\', " ");
    format!(
        "// {}, for {}.\n// Generated by corput {} through naga, {}.\n{more}\
         // Tier I gives the same bits here; tier F has no guarantee: naga drops NoContraction.\n",
        line(about.what),
        line(about.scene),
        env!("CARGO_PKG_VERSION"),
        env!("CARGO_PKG_LICENSE"),
    )
}

fn valid(module: &naga::Module, source: &str) -> std::result::Result<ModuleInfo, String> {
    Validator::new(ValidationFlags::all(), Capabilities::IMMEDIATES)
        .validate(module)
        .map_err(|error| error.emit_to_string(source))
}

fn to_wgsl(module: &naga::Module, info: &ModuleInfo) -> std::result::Result<String, String> {
    let text = wgsl::write_string(module, info, wgsl::WriterFlags::empty())
        .map_err(|error| error.to_string())?;
    // What was written must be read again.
    let again = naga::front::wgsl::parse_str(&text).map_err(|e| e.emit_to_string(&text))?;
    valid(&again, &text)?;
    Ok(text)
}

fn to_hlsl(module: &naga::Module, info: &ModuleInfo) -> std::result::Result<String, String> {
    let mut text = String::new();
    // Spaces of their own for what is no descriptor.
    let target = |register| hlsl::BindTarget {
        space: 1,
        register,
        ..hlsl::BindTarget::default()
    };
    let options = hlsl::Options {
        immediates_target: Some(target(0)),
        special_constants_binding: Some(target(1)),
        ..hlsl::Options::default()
    };
    let pipeline = hlsl::PipelineOptions::default();
    hlsl::Writer::new(&mut text, &options, &pipeline)
        .write(module, info, None)
        .map_err(|error| error.to_string())?;
    Ok(text)
}

fn to_msl(module: &naga::Module, info: &ModuleInfo) -> std::result::Result<String, String> {
    let options = msl::Options {
        // reverse_bits came with Metal 2.1.
        lang_version: (2, 1),
        ..msl::Options::default()
    };
    let written = msl::write_string(module, info, &options, &msl::PipelineOptions::default());
    Ok(written.map_err(|error| error.to_string())?.0)
}
