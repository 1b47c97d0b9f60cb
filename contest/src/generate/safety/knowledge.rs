//! What the vectors know of an instruction: configurations, sequences and values that mean something to it.

use std::collections::BTreeMap;
use std::sync::OnceLock;

use twinrung_catalog::instructions::ALL;
use twinrung_catalog::{Instruction, Opcode};
use twinrung_safety_vectors::{Vector, for_instruction};

/// Of one instruction.
#[derive(Debug, Clone, Default)]
pub struct Knowledge {
    /// Its vectors.
    pub vectors: Vec<Vector>,
    /// Those whose configuration the compiler admits.
    pub admissible: Vec<Vector>,
    /// The values that they give to each operand behind the backing tag.
    values: Vec<Vec<i32>>,
}

impl Knowledge {
    fn of(instruction: &Instruction) -> Knowledge {
        let vectors = for_instruction(instruction.opcode).unwrap_or_else(|error| panic!("a vector of ours: {error}"));
        let admissible = vectors.iter().filter(|vector| vector.is_admissible()).cloned().collect();
        let operands = instruction.safety.map_or(0, |safety| safety.mirrored.len());
        let values = (0..operands).map(|index| values(&vectors, index)).collect();
        Knowledge { vectors, admissible, values }
    }

    /// The values that the vectors give to an operand.
    pub fn values(&self, index: usize) -> &[i32] {
        self.values.get(index).map_or(&[], Vec::as_slice)
    }
}

fn values(vectors: &[Vector], index: usize) -> Vec<i32> {
    let of = |vector: &Vector| {
        let steps = vector.steps.iter().flat_map(|step| &step.inputs);
        let all = steps.chain(&vector.configuration).filter(|setting| setting.operand == index);
        all.map(|setting| setting.value).collect::<Vec<i32>>()
    };
    let mut values: Vec<i32> = vectors.iter().flat_map(of).collect();
    values.sort_unstable();
    values.dedup();
    values
}

/// What is known of a safety application instruction, read once; nothing of any other.
pub fn knowledge(opcode: Opcode) -> &'static Knowledge {
    static ALL_KNOWN: OnceLock<BTreeMap<u8, Knowledge>> = OnceLock::new();
    static NOTHING: OnceLock<Knowledge> = OnceLock::new();
    let all = ALL_KNOWN.get_or_init(|| {
        let safety = ALL.iter().filter(|instruction| instruction.safety.is_some());
        safety.map(|instruction| (instruction.opcode as u8, Knowledge::of(instruction))).collect()
    });
    all.get(&(opcode as u8)).unwrap_or_else(|| NOTHING.get_or_init(Knowledge::default))
}
