//! Committed files against the tables that generate them.

use corput::tables::{
    PRIMES, is_prime, lattice_vector, lattice_vector_glsl, nearest_prime, primes_glsl, sobol_glsl,
};

/// A committed header against the text that a table generates.
fn compare(name: &str, generated: &str) {
    compare_file(&format!("shaders/corput/{name}.glsl"), generated);
}

/// A committed file against what is generated.
fn compare_file(name: &str, generated: &str) {
    let path = format!("{}/{name}", env!("CARGO_MANIFEST_DIR"));
    if std::env::var_os("CORPUT_WRITE_TABLES").is_some() {
        std::fs::write(&path, generated).expect("the table is written");
    }
    let committed = std::fs::read_to_string(&path).expect("the file is there");
    assert!(
        committed == generated,
        "{name}: run `CORPUT_WRITE_TABLES=1 cargo test --test tables`"
    );
}

#[test]
fn headers_are_what_the_tables_generate() {
    compare("primes", &primes_glsl());
    compare("lattice_vector", &lattice_vector_glsl());
    compare("sobol_directions", &sobol_glsl());
}

/// Odd and below 2^20, as the vector must be, and the sum of two independent copies of it.
#[test]
fn the_lattice_vector_is_the_published_one() {
    let vector = lattice_vector();
    assert_eq!(vector.len(), 250);
    assert_eq!(
        vector[..6],
        [1, 182_667, 469_891, 498_753, 110_745, 446_247]
    );
    assert_eq!(vector[245..], [40_729, 322_721, 420_175, 430_359, 480_757]);
    assert!(vector.iter().all(|z| z % 2 == 1 && *z < 1 << 20));
    assert_eq!(vector.iter().sum::<u32>(), 63_550_560);
}

#[test]
fn primes_are_the_first_1024() {
    let mut n = 0;
    for p in PRIMES {
        n += 1;
        while !(2..n).take_while(|d| d * d <= n).all(|d| n % d != 0) || n < 2 {
            n += 1;
        }
        assert_eq!(p, n);
        assert!(is_prime(p.into()));
    }
    assert_eq!(n, 8161);
    assert!(!is_prime(1) && !is_prime(0) && !is_prime(8161 * 8161));
    assert_eq!(nearest_prime(9), 7);
    assert_eq!(nearest_prime(0), 2);
    assert_eq!(nearest_prime(u64::MAX), 8161);
}

/// The maps that kernels of points know are functions of the catalogue as well.
#[test]
fn maps_agree_with_their_functions() {
    use corput::catalog::{FUNCTIONS, maps};
    for map in maps() {
        let function = map.name.replace('-', "_");
        let row = FUNCTIONS.iter().find(|row| row.name == function);
        assert_eq!(row.is_some(), map.group.fused(), "{function}");
        if let Some(row) = row {
            assert_eq!(row.bound, Some(map.ulp), "{function}");
            assert_eq!(row.tier, map.tier, "{function}");
        }
    }
}

/// The page of the maps is that of the catalogue, and the README names each of them.
#[test]
fn the_page_of_the_maps_is_generated() {
    use corput::catalog::maps;
    let path = concat!(env!("CARGO_MANIFEST_DIR"), "/README.md");
    let readme = std::fs::read_to_string(path).expect("the README is there");
    let mut page = String::from(MAPS_HEAD);
    for map in maps() {
        assert!(
            readme.contains(&format!("`{}`", map.name)),
            "the README lacks {}",
            map.name
        );
        page += &format!("\n## {}\n\n{}.\n\n", map.name, sentence(map.summary));
        for parameter in map.parameters {
            let default = parameter.default.map_or(String::new(), |numbers| {
                let numbers: Vec<String> = numbers.iter().map(f64::to_string).collect();
                format!("; {} by default", numbers.join(","))
            });
            let (name, size) = (parameter.name, parameter.size);
            let numbers = if size == 1 {
                String::new()
            } else {
                format!(" ({size} numbers)")
            };
            page += &format!(
                "- `{name}`{numbers}: {}; {}{default}.\n",
                parameter.summary, parameter.domain
            );
        }
        let coordinates = ["x", "x, y", "x, y, z"][map.coordinates as usize - 1];
        let dimensions = if map.dimensions == 1 {
            "dimension"
        } else {
            "dimensions"
        };
        page += &format!(
            "- takes {} {dimensions}, makes {coordinates}\n",
            map.dimensions
        );
        page += &format!("- pdf: {}, with respect to {}\n", map.pdf, map.measure);
        page += &format!(
            "- errors: exact (tier {}) {} ULP{}, pdf {} ULP; native {:.1e}, pdf {:.1e} of itself\n",
            map.tier.letter(),
            map.ulp,
            map.counted(),
            map.pdf_ulp,
            map.native,
            map.native_pdf
        );
        page += &format!("- source: {}\n", map.source);
    }
    compare_file("docs/maps.md", &page);
}

/// What stands above the list of maps.
const MAPS_HEAD: &str = "# Maps

Each map takes fractions of 2^32 to a sample of a distribution: `corput generate SEQUENCE --map NAME
--param NAME=X`. In GLSL a map `some-name` is `corput_some_name`, with `_pdf` and `_invert`, and in
Rust the same without `corput_`. +z is the normal or the pole, coordinates are right-handed, angles
are in radians. Errors are worst cases over the parameters that checks try; a header says what more
extreme ones cost. Those of the exact profile are in units of the last place (ULP) of float, held by
`corput check`; those of the native profile are what Vulkan's precision tables allow. This page is
what `corput maps` prints.
";

/// With a capital.
fn sentence(text: &str) -> String {
    let mut letters = text.chars();
    letters.next().map_or(String::new(), |first| {
        first.to_uppercase().collect::<String>() + letters.as_str()
    })
}

/// What the README says of each sequence is what the catalogue says of it.
#[test]
fn sequences_agree_with_the_readme() {
    use corput::catalog::SEQUENCES;
    let path = concat!(env!("CARGO_MANIFEST_DIR"), "/README.md");
    let readme = std::fs::read_to_string(path).expect("the README is there");
    for sequence in SEQUENCES {
        let guide = sequence.guide();
        let line = format!(
            "| `{}` | {} | {} | {} | {} |\n",
            sequence.name(),
            guide.what,
            guide.purpose,
            guide.source,
            guide.points
        );
        assert!(readme.contains(&line), "the README lacks: {line}");
    }
}

/// The numbers of points that the guide names for Korobov lattices are those of the table.
#[test]
fn the_guide_names_every_korobov_lattice() {
    use corput::catalog::Sequence;
    use corput::tables::KOROBOV;
    let counts: Vec<String> = KOROBOV.iter().map(|row| row.0.to_string()).collect();
    let points = Sequence::Korobov.guide().points;
    assert!(points.contains(&counts.join(", ")), "{points}");
}
