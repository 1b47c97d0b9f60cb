//! The signatures of the safety Add-On Instructions of a project.

use std::io;

use twinrung_bytecode::AdmittedImage;
use twinrung_bytecode::signature::safety_instruction_signatures;
use twinrung_commission::SealedInstruction;
use twinrung_compiler::instruction_signature::{safety_add_ons, seal};
use twinrung_grammar::tree::{File, HistoryEntry};

use crate::failed;

/// Every one, in the order of the image. The project was checked: a seal in it fits its content.
pub fn listing(trees: &[File], image: &AdmittedImage) -> io::Result<Vec<SealedInstruction>> {
    let trees: Vec<&File> = trees.iter().collect();
    let mut list = Vec::new();
    let signatures = safety_instruction_signatures(image.image()).map_err(failed)?;
    for (add_on, safety) in image.image().add_ons.iter().zip(signatures) {
        let shown = safety_add_ons(&trees).find(|shown| shown.name.is(&add_on.name));
        let seal = shown.and_then(|shown| seal(shown).ok().flatten());
        list.push(SealedInstruction {
            name: add_on.name.clone(),
            instruction: seal.as_ref().map(|seal| seal.id),
            generated: seal.map(|seal| seal.timestamp.to_string()),
            safety,
            history: shown.iter().flat_map(|shown| &shown.history).map(words).collect(),
        });
    }
    Ok(list)
}

/// An entry of a history in one line.
fn words(entry: &HistoryEntry) -> String {
    let texts = entry.attributes.iter().filter_map(|one| one.value.text().map(|text| (&one.key, text)));
    texts
        .map(|(key, text)| format!("{key} {}", attribute_text(key.as_str(), &text.text)))
        .collect::<Vec<_>>()
        .join(", ")
}

/// A signature is shown by its first digits, as everywhere.
fn attribute_text<'t>(key: &str, text: &'t str) -> &'t str {
    if key.ends_with("Signature") { text.get(..8).unwrap_or(text) } else { text }
}
