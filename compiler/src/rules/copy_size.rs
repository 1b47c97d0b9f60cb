//! Both sides of a copy have the same length. 1756-RM093 Table 12, footnote 3.

use twinrung_bytecode::image::TypeReference;
use twinrung_bytecode::limits;
use twinrung_catalog::{Element, Opcode};

use crate::diagnostic::{Finding, Findings};
use crate::operand::{LocationBase, Operand, Reference};
use crate::project::{Call, Project};
use crate::rules::usage;

rule! {
    /// Source and destination of a copy differ in length.
    "S0106", Error, "source and destination of a copy do not have the same length",
    "COP copies as many elements as its length says, of equal size on both sides, and both arrays have that many from there on; the two do not overlap. BOOLs, instances of Add-On Instructions and backing tags of safety instructions are not copied. FLL and SIZE are held to the same bounds.",
    "1756-RM093 Table 12, footnote 3; general-instructions.md A.6 (decided)",
    good: sample!("    A, B : DINT[8] (Class := Safety);\n", "      N: COP(A[0],B[0],8);\n"),
    bad: sample!("    A : DINT[8] (Class := Safety);\n    B : DINT[4] (Class := Safety);\n", "      N: COP(A[0],<<B[0]>>,8);\n")
}

/// Bytes of one element; nothing for what is not copied.
fn bytes(project: &Project, reference: &Reference) -> Option<u32> {
    match reference.type_reference {
        TypeReference::Element(Element::Bool) => None,
        TypeReference::Element(element) => Some(element.bytes()),
        TypeReference::Structure(index) => {
            let layout = project.types.layout(index);
            (layout.bytes > 0 && !layout.holds_backing).then_some(layout.bytes)
        }
    }
}

/// COP and FLL.
pub(crate) fn check(project: &Project, findings: &mut Findings) {
    if !project.opcodes.any(&[Opcode::Cop, Opcode::Fll]) {
        return;
    }
    usage::instructions(project, &mut |_, instruction| {
        let Call::Catalog(declaration) = instruction.call else { return };
        if !matches!(declaration.opcode, Opcode::Cop | Opcode::Fll) {
            return;
        }
        let [source_use, destination_use, length_use] = &*instruction.operands else { return };
        let Operand::Integer { value: length, .. } = project.operand(length_use.id) else { return };
        let length = u32::try_from(*length).unwrap_or(u32::MAX);
        let source = project.operand(source_use.id).reference().filter(|_| declaration.opcode == Opcode::Cop);
        let Some(destination) = project.operand(destination_use.id).reference() else { return };
        let mut sizes = [None, None];
        for (slot, reference, one) in [(0, source, source_use), (1, Some(destination), destination_use)] {
            let Some(reference) = reference else { continue };
            let Some(size) = bytes(project, reference) else {
                let message = format!("{} cannot be copied byte by byte", project.types.name(reference.type_reference));
                let help = "move its members one by one";
                findings.push(Finding::new(&CODE, one.span, message).help(help));
                return;
            };
            sizes[slot] = Some(size);
            if length > reference.location.count {
                let message =
                    format!("{length} elements are meant, and there are {} from here on", reference.location.count);
                findings.push(Finding::new(&CODE, one.span, message).help("shorten the length, or lengthen the array"));
                return;
            }
        }
        if let [Some(source), Some(destination)] = sizes
            && source != destination {
                let message = format!("an element of the source has {source} bytes, one of the destination {destination}");
                let help = "copy between data of the same type";
                findings.push(Finding::new(&CODE, destination_use.span, message).help(help));
                return;
            }
        if sizes[1].unwrap_or(0).saturating_mul(length) > limits::COPY_BYTES {
            let message = format!("a copy moves at most {} bytes", limits::COPY_BYTES);
            findings.push(Finding::new(&CODE, length_use.span, message).help("copy in several steps"));
            return;
        }
        if let Some(source) = source.filter(|source| overlap(project, source, destination, length)) {
            let message = format!("the copy writes into its own source `{}`", usage::name_of(project, source));
            findings.push(Finding::new(&CODE, destination_use.span, message).help("copy to other data"));
        }
    });
}

/// Whether two runs of elements share a cell for certain.
fn overlap(project: &Project, source: &Reference, destination: &Reference, length: u32) -> bool {
    let same = source.location.base == destination.location.base
        && matches!(source.location.base, LocationBase::Tag(_))
        && source.location.terms.is_empty()
        && destination.location.terms.is_empty();
    let (bits, words) = project.types.cells(source.type_reference);
    let meet = |a: u32, b: u32, each: u32| each > 0 && a < b + each * length && b < a + each * length;
    same && (meet(source.location.word_cell, destination.location.word_cell, words)
        || meet(source.location.bit_cell, destination.location.bit_cell, bits))
}
