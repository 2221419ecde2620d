//! Bad input: dimensions, numbers and options that a sequence does not have.

use super::refused::assert_refused;

#[test]
fn sequences_that_end_before() {
    for (arguments, words) in [
        (
            "sobol --count 5 --dims 21202",
            &[
                "21202 dimensions",
                "1 to 21201",
                "direction numbers",
                "fewer",
            ][..],
        ),
        (
            "lattice --count 5 --dims 251",
            &["251 dimensions", "1 to 250", "fewer"],
        ),
        ("r2 --count 5 --dims 17", &["17 dimensions", "1 to 16"]),
        (
            "stratified --count 5 --dims 33",
            &["33 dimensions", "1 to 32"],
        ),
        (
            "random --count 5 --dims 65537",
            &["65537 dimensions", "1 to 65536"],
        ),
        (
            "pmj02 --count 5 --dims 3",
            &["3 dimensions; it has 2:", "use sobol"],
        ),
        (
            "cmj --count 4 --dims 3",
            &["3 dimensions; it has 2:", "latin-hypercube or stratified"],
        ),
        (
            "cmj --count 4 --dims 1",
            &["1 dimension; it has 2:", "latin-hypercube"],
        ),
        (
            "sobol --count 5 --dims 0",
            &["0 dimensions", "at least one"],
        ),
        ("sobol --count 0", &["--count is 0"]),
        (
            "sobol --first 1 --count 4294967296",
            &["passes 2^32", "by 1"],
        ),
        (
            "lattice --count 1048577",
            &["up to 1048577", "2^20 = 1048576", "sobol"],
        ),
        (
            "lattice --first 1048576 --count 1",
            &["up to 1048577", "2^20 = 1048576"],
        ),
    ] {
        assert_refused(&format!("generate {arguments} --out p.npy"), words);
    }
}

#[test]
fn sets_of_another_number() {
    let most = "at most 4294967295";
    for (arguments, words) in [
        (
            "cmj --count 1021",
            &["1021 is prime", "use --count 1020 or 1022", "--grid 1x1021"][..],
        ),
        (
            "cmj --first 21 --count 1000",
            &["1021 is prime", "use --total 1022, or"],
        ),
        (
            "cmj --count 10 --total 1021",
            &["1021 is prime", "use --total 1020 or 1022"],
        ),
        (
            "korobov --count 1000",
            &["N = 1000", "1021, 2039, 4093", "use --count 1021,"],
        ),
        (
            "korobov --count 1500",
            &["use --count 1021 or 2039, or give --generator"],
        ),
        (
            "korobov --first 500 --count 1000",
            &["N = 1500", "use --total 2039, or give --generator"],
        ),
        ("korobov --count 70000", &["use --count 65521,"]),
        (
            "korobov --first 60000 --count 10000",
            &["N = 70000", "65521; give --generator"],
        ),
        (
            "korobov --count 1000 --generator 0",
            &["--generator 0", "1 to N - 1", "1 to 999"],
        ),
        (
            "korobov --count 1000 --generator 1000",
            &["--generator 1000", "1 to 999"],
        ),
        (
            "stratified --count 1000 --grid 32x32",
            &["--grid 32x32", "1024 cells", "use --count 1024"],
        ),
        (
            "cmj --count 1000 --grid 32x32",
            &["1024 cells", "use --count 1024"],
        ),
        (
            "stratified --first 500 --count 500 --grid 32x32",
            &["1024 cells", "use --total 1024"],
        ),
        (
            "stratified --first 500 --count 500 --grid 10x10",
            &["100 cells", "; use another grid"],
        ),
        (
            "stratified --count 5 --grid 4294967296x4294967296",
            &["more than 2^64 cells", "another grid"],
        ),
        (
            "stratified --count 5 --grid 65536x65536",
            &["4294967296 cells", "; use another grid"],
        ),
        ("stratified --count 4294967296", &[most]),
        ("latin-hypercube --count 4294967296", &[most, "sobol"]),
        ("cmj --count 4294967296", &[most]),
        ("korobov --count 4294967296", &[most]),
        ("stratified --count 5 --total 4294967296", &[most]),
        (
            "stratified --count 5 --total 4",
            &["--total 4", "between 5 and 4294967295"],
        ),
        (
            "hammersley --count 5 --total 4294967297",
            &["between 5 and 4294967296"],
        ),
        (
            "stratified --count 1024 --dims 3 --grid 32x32",
            &["--dims 3", "2 dimensions", "drop --dims"],
        ),
        ("cmj --count 8 --grid 2x2x2", &["3 dimensions; it has 2:"]),
    ] {
        assert_refused(&format!("generate {arguments} --out p.npy"), words);
    }
    for grid in [
        "0",
        "32x0",
        "32x",
        "x",
        "32*32",
        "-4x4",
        "x32",
        "1.5x2",
        "32X32",
        "99999999999999999999x1",
    ] {
        assert_refused(
            &format!("generate stratified --count 1024 --grid {grid} --out p.npy"),
            &["--grid", &format!("`{grid}` is no grid"), "as 32x16"],
        );
    }
}

#[test]
fn options_of_other_sequences() {
    for (arguments, words) in [
        (
            "halton --order gray",
            &["--order gray with halton", "use sobol"][..],
        ),
        (
            "sobol --bases 2,3",
            &["--bases with sobol", "vdc, halton or hammersley"],
        ),
        (
            "sobol --total 8",
            &[
                "--total with sobol",
                "stratified, latin-hypercube, cmj, hammersley or korobov",
            ],
        ),
        (
            "lattice --generator 3",
            &["--generator with lattice", "use korobov"],
        ),
        (
            "latin-hypercube --grid 5x1",
            &["--grid with latin-hypercube", "stratified or cmj"],
        ),
        (
            "sobol --index-first",
            &["--index-first with sobol", "use hammersley"],
        ),
        (
            "sobol --scramble permute",
            &[
                "--scramble permute with sobol",
                "none, shift, matrix, owen, owen-hash",
            ],
        ),
        (
            "halton --scramble owen-hash",
            &[
                "--scramble owen-hash with halton",
                "none, faure, permute, owen, start",
            ],
        ),
        ("r2 --scramble owen", &["none, rotate"]),
        ("hammersley --scramble owen", &["hammersley has none"]),
        (
            "random --scramble owen",
            &["random already", "drop --scramble"],
        ),
        ("pmj02 --scramble owen", &["random already", "--seed"]),
        (
            "sobol --scramble owwn",
            &[
                "unknown scramble `owwn`",
                "did you mean `owen`",
                "known: none, shift, matrix, owen, owen-hash",
            ],
        ),
        (
            "halton --scramble random",
            &[
                "unknown scramble `random`",
                "known: none, faure, permute, owen, start",
            ],
        ),
        (
            "sobol --order grey",
            &["unknown order `grey`", "did you mean `gray`", "natural"],
        ),
        ("sobol --seed -1", &["--seed", "-1 is negative"]),
        (
            "sobol --seed 18446744073709551616",
            &["18446744073709551616 is too large"],
        ),
        (
            "sobol --dims 3 --map cosine-hemisphere",
            &["takes 2 dimensions", "use --dims 2"],
        ),
    ] {
        assert_refused(
            &format!("generate {arguments} --count 5 --out p.npy"),
            words,
        );
    }
    assert_refused(
        "generate sobl --count 5 --out p.npy",
        &["unknown sequence `sobl`", "did you mean `sobol`", "korobov"],
    );
}
