//! `corput headers`.

use super::args::HeadersArgs;
use super::print;
use corput::report::{create_folder, save};

pub fn run(args: &HeadersArgs) -> anyhow::Result<()> {
    let headers = corput::headers();
    for (name, text) in headers {
        let path = args.out.join(name);
        if let Some(folder) = path.parent() {
            create_folder(folder, "--out")?;
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
