//! `corput vectors`.

use super::args::VectorsArgs;
use super::{interrupt, print, progress};
use corput::vectors;

pub fn run(args: &VectorsArgs) -> anyhow::Result<()> {
    let total = vectors::number()?;
    let bar = progress::cells(total);
    interrupt::clean_up();
    let files = vectors::write(&args.out, &mut |entry| {
        bar.inc(1);
        bar.set_message(entry.name.clone());
        interrupt::stop(bar.position(), total)
    })?;
    bar.finish_and_clear();
    print(&format!(
        "{} files in {}; vectors.json says what they are, and their SHA-256",
        files.len(),
        args.out.display()
    ));
    Ok(())
}
