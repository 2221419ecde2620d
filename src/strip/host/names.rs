//! Names that C, C++ and Rust all take.

/// Keywords of any of the three that consist of small letters.
const KEYWORDS: &str = "abstract alignas alignof and and_eq as asm async atomic_cancel \
    atomic_commit atomic_noexcept auto await become bitand bitor bool box break case catch char \
    char8_t char16_t char32_t class compl concept const const_cast consteval constexpr constinit \
    continue co_await co_return co_yield crate decltype default delete do double dyn dynamic_cast \
    else enum explicit export extern false final float fn for friend gen goto if impl import in \
    inline int let long loop macro match mod module move mut mutable namespace new noexcept not \
    not_eq nullptr operator or or_eq override priv private protected pub public ref reflexpr \
    register reinterpret_cast requires restrict return self short signed sizeof static \
    static_assert static_cast struct super switch synchronized template this thread_local throw \
    trait true try type typedef typeid typename typeof typeof_unqual union unsafe unsized unsigned \
    use using virtual void volatile wchar_t where while xor xor_eq yield _ Self";

/// Whether a text is a name in all three.
pub(super) fn is_name(text: &str) -> bool {
    let first = text.bytes().next().is_some_and(|c| c.is_ascii_alphabetic());
    let word = text.bytes().all(|c| c.is_ascii_alphanumeric() || c == b'_');
    // Two underscores are C++'s own.
    first && word && !text.contains("__") && !KEYWORDS.split_whitespace().any(|key| key == text)
}

/// A name in all three that is like the text: other signs are `_`, and what is a keyword or
/// begins with no letter has `scene_` before it.
#[must_use]
pub fn identifier(text: &str) -> String {
    let words = text.split(|c: char| !c.is_ascii_alphanumeric());
    let words: Vec<&str> = words.filter(|word| !word.is_empty()).collect();
    let name = words.join("_");
    match is_name(&name) {
        true => name,
        false if name.is_empty() => "scene".to_owned(),
        false => format!("scene_{name}"),
    }
}

/// A name as a type has it: `map_ggx` is `MapGgx`.
pub(super) fn type_name(text: &str) -> String {
    let word = |word: &str| {
        let (first, rest) = word.split_at(word.len().min(1));
        first.to_ascii_uppercase() + rest
    };
    text.split('_').map(word).collect()
}
