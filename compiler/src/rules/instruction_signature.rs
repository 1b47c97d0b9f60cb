//! A sealed safety Add-On Instruction is what its instruction signature says. 1756-RM093 Appendix B.

use std::cell::LazyCell;

use twinrung_bytecode::limits;
use twinrung_bytecode::signature::short_form;
use twinrung_grammar::tree::File;

use crate::diagnostic::{Finding, Findings};
use crate::instruction_signature::{Definitions, safety_add_ons, seal};
use crate::project::Project;

rule! {
    /// A sealed instruction whose content is another.
    "S0801", Error, "a sealed Add-On Instruction was changed",
    "An instruction signature seals a safety Add-On Instruction: nothing in it may change while it is there, comments and descriptions included, nor the types and instructions that it uses. Take back the change; or remove the signature (twinrung signature FILE remove NAME), test and validate the instruction again, and generate a new one.",
    "1756-RM093, Appendix B; what the ID covers is decided",
    good: instruction!(attributes ", InstructionSignature := \"dee0d425430bc51b64aa1ec5f3c4f235b230d5eccfe2e09bdac7cc91979620f3\", InstructionSignatureTimestamp := \"2026-11-22T18:00:00Z\""),
    bad: instruction!(attributes ", InstructionSignature := \"<<0000000000000000000000000000000000000000000000000000000000000000>>\", InstructionSignatureTimestamp := \"2026-11-22T18:00:00Z\"")
}

pub(crate) const WAY_OUT: &str =
    "take back the change; or remove the signature, test and validate the instruction again, and generate a new one";

/// Add-On Instructions that state a signature.
pub(crate) fn check(files: &[&File], project: &Project, findings: &mut Findings) {
    // Each has a type: a project with more is refused for that, and is not gone through for every one of them.
    if project.add_ons.len() > limits::TYPES {
        return;
    }
    let definitions = LazyCell::new(|| Definitions::new(files, project));
    for shown in safety_add_ons(files) {
        match seal(shown) {
            Ok(None) => {}
            Ok(Some(seal)) => {
                let found = definitions.signature(shown);
                if found != seal.id {
                    let (stated, found) = (short_form(&seal.id), short_form(&found));
                    let message = format!("`{}` is sealed as {stated}, and its content is {found}", shown.name);
                    findings.push(Finding::new(&CODE, seal.span, message).help(WAY_OUT));
                }
            }
            Err(broken) => {
                let message = format!("`{}`: {}", shown.name, broken.message);
                findings.push(Finding::new(&CODE, broken.span, message).help(WAY_OUT));
            }
        }
    }
}
