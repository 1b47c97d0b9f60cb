//! Rungs in the exporter's style (reference C.1): elements adjoin, inside a leg there is a blank
//! behind each, `XIC(a)[XIC(b) XIO(c) ,XIC(d) ]OTE(e);`

use super::attributes::quoted;
use super::layout::Layout;
use crate::tree::{Element, Rung};

/// The neutral text of a rung, `;` included, without its comment.
pub fn print_rung(rung: &Rung) -> String {
    let mut out = String::new();
    for element in &rung.elements {
        push(element, &mut out);
    }
    out.push(';');
    out
}

/// The neutral text of one element.
pub fn print_element(element: &Element) -> String {
    let mut out = String::new();
    push(element, &mut out);
    out
}

/// Recurses as deep as branches nest, which has a limit.
fn push(element: &Element, out: &mut String) {
    match element {
        Element::Instruction(instruction) => {
            out.push_str(&instruction.mnemonic.text);
            out.push('(');
            for (index, operand) in instruction.operands.iter().enumerate() {
                if index > 0 {
                    out.push(',');
                }
                out.push_str(&operand.text);
            }
            out.push(')');
        }
        Element::Branch(branch) => {
            out.push('[');
            for (index, leg) in branch.legs.iter().enumerate() {
                if index > 0 {
                    out.push(',');
                }
                for element in &leg.elements {
                    push(element, out);
                    out.push(' ');
                }
            }
            out.push(']');
        }
    }
}

/// A rung of a routine: comments of the source, its own comment, its kind and text.
pub(super) fn rung(layout: &mut Layout, rung: &Rung) {
    layout.leading(&rung.trivia);
    if let Some(comment) = &rung.comment {
        let mut lines = comment.text.split_inclusive('\n').peekable();
        let mut first = true;
        if lines.peek().is_none() {
            layout.line("RC: \"\";");
        }
        while let Some(line) = lines.next() {
            let end = if lines.peek().is_none() { ";" } else { "" };
            let begin = if first { "RC: " } else { "    " };
            layout.line(&format!("{begin}{}{end}", quoted(line)));
            first = false;
        }
    }
    let mut text = format!("{}: {}", rung.kind.value.letters(), print_rung(rung));
    for comment in rung.trivia.trailing() {
        text.push(' ');
        text.push_str(comment);
    }
    layout.line(&text);
}
