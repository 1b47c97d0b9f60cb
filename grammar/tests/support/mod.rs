//! What the tests share.
#![allow(dead_code)]

pub mod trees;

/// The debug form of a tree with every span (`@0:12..15`) taken out.
pub fn without_spans(tree: &impl std::fmt::Debug) -> String {
    let text = format!("{tree:#?}");
    let mut out = String::with_capacity(text.len());
    let mut rest = text.as_str();
    while let Some((before, after)) = rest.split_once('@') {
        out.push_str(before);
        out.push('@');
        rest = after.trim_start_matches(|character: char| character.is_ascii_digit() || ":.".contains(character));
    }
    out.push_str(rest);
    out
}
