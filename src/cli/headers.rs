//! `corput headers`.

use super::args::HeadersArgs;
use super::print;
use corput::Error;
use corput::report::save;
use std::path::Path;

pub fn run(args: &HeadersArgs) -> anyhow::Result<()> {
    let refused = |path: &Path, source: std::io::Error| Error::Output {
        path: path.to_owned(),
        problem: source.to_string(),
        remedy: "choose a folder that can be made and written".into(),
    };
    let headers = corput::headers();
    for (name, text) in headers {
        let path = args.out.join(name);
        if let Some(folder) = path.parent() {
            std::fs::create_dir_all(folder).map_err(|source| refused(folder, source))?;
        }
        save(&path, text.as_bytes())?;
    }
    print(&format!(
        "{} headers in {}; include them as \"corput/NAME.glsl\" with {} in the include path",
        headers.len(),
        args.out.join("corput").display(),
        args.out.display()
    ));
    Ok(())
}
