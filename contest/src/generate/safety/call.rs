//! One call: which operands are literals, which are tags that the driver moves.

use std::fmt::Write;

use twinrung_catalog::{Element, Instruction, OperandKind, Relation};
use twinrung_safety_vectors::Vector;

use crate::generate::Random;

use super::knowledge::{Knowledge, knowledge};

/// What stands in an operand's place.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Given {
    /// This value: a choice, a DINT, or the bits of a REAL.
    Literal(i32),
    /// A tag of its own.
    Tag,
}

/// One call; the operands are those after the backing tag.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Call {
    /// What is called.
    pub instruction: &'static Instruction,
    /// What stands in each operand's place.
    pub operands: Vec<Given>,
}

impl Call {
    /// A call with the configuration of a vector, a changed one, or any that the catalog admits.
    pub fn random(random: &mut Random, instruction: &'static Instruction) -> Call {
        let known = knowledge(instruction.opcode);
        let like = (!known.admissible.is_empty() && random.percent(75)).then(|| random.of(&known.admissible));
        loop {
            let call = Call { instruction, operands: operands(random, instruction, known, like) };
            if call.keeps_relations() {
                return call;
            }
        }
    }

    /// Its operand number `index` (after the backing tag).
    pub fn kind(&self, index: usize) -> OperandKind {
        self.instruction.operands[index + 1].kind
    }

    /// The member that mirrors an operand.
    pub fn member(&self, index: usize) -> &'static str {
        self.instruction.safety.map_or("", |safety| safety.mirrored[index])
    }

    /// The literal with this mirrored member.
    pub fn literal(&self, member: &str) -> Option<i32> {
        let index = (0..self.operands.len()).find(|index| self.member(*index) == member)?;
        match self.operands[index] {
            Given::Literal(value) => Some(value),
            Given::Tag => None,
        }
    }

    fn operand_named(&self, name: &str) -> Option<Given> {
        let index = self.instruction.operands.iter().position(|operand| operand.name == name)?;
        self.operands.get(index.checked_sub(1)?).copied()
    }

    fn keeps_relations(&self) -> bool {
        let value = |name: &str| match self.operand_named(name) {
            Some(Given::Literal(value)) => Some(value),
            _ => None,
        };
        let relations = self.instruction.safety.map_or(&[][..], |safety| safety.relations);
        relations.iter().all(|relation| match relation {
            Relation::DifferentTags(..) | Relation::PeriodAtMost(_) => true,
            Relation::NotZeroWhen(time, choice, when) => value(choice) != Some(*when) || value(time) != Some(0),
            Relation::BelowUnlessZero(low, high) => match (value(low), value(high)) {
                (Some(low), Some(high)) => high == 0 || low < high,
                _ => true,
            },
            Relation::NotAbove(low, high) => match (value(low), value(high)) {
                (Some(low), Some(high)) if self.has_reals() => {
                    f32::from_bits(low as u32) <= f32::from_bits(high as u32)
                }
                (Some(low), Some(high)) => low <= high,
                _ => true,
            },
        })
    }

    fn has_reals(&self) -> bool {
        (0..self.operands.len()).any(|index| self.is_real(index))
    }

    /// Whether an operand is a REAL.
    pub fn is_real(&self, index: usize) -> bool {
        matches!(self.kind(index), OperandKind::SafetyReal { .. })
    }

    /// The longest period in ms that the instruction admits.
    pub fn longest_period_ms(&self) -> u32 {
        let relations = self.instruction.safety.map_or(&[][..], |safety| safety.relations);
        let bound = relations.iter().find_map(|relation| match relation {
            Relation::PeriodAtMost(period) => Some(*period),
            _ => None,
        });
        bound.unwrap_or(500)
    }

    /// The configuration as a vector writes it.
    pub fn configuration(&self) -> String {
        let mut text = String::new();
        for (index, given) in self.operands.iter().enumerate() {
            if let Given::Literal(value) = given {
                let _ = write!(text, " {}={}", self.member(index), value_text(self.kind(index), *value));
            }
        }
        text
    }
}

/// A value as text.
pub fn value_text(kind: OperandKind, value: i32) -> String {
    match kind {
        OperandKind::SafetyReal { .. } => format!("{:?}", f32::from_bits(value as u32)),
        OperandKind::Choice(list) => list.word(value).map_or_else(|| value.to_string(), |word| word.replace(' ', "_")),
        _ => value.to_string(),
    }
}

fn operands(
    random: &mut Random,
    instruction: &'static Instruction,
    knowledge: &Knowledge,
    like: Option<&Vector>,
) -> Vec<Given> {
    let list = instruction.operands.iter().skip(1).enumerate();
    list.map(|(index, operand)| {
        let known = knowledge.values(index);
        let configured = like.and_then(|one| one.configuration.iter().find(|setting| setting.operand == index));
        if let Some(value) = configured.map(|setting| setting.value).filter(|value| is_admitted(operand.kind, *value))
            && random.percent(92)
        {
            return Given::Literal(value);
        }
        let immediate = match operand.kind {
            OperandKind::SafetyBit { immediate } => immediate && random.percent(12),
            OperandKind::SafetyInteger { immediate, .. } => immediate.is_some() && random.percent(35),
            OperandKind::SafetyReal { immediate, .. } => immediate && random.percent(35),
            _ => true,
        };
        if immediate { Given::Literal(literal(random, operand.kind, known)) } else { Given::Tag }
    })
    .collect()
}

fn is_admitted(kind: OperandKind, value: i32) -> bool {
    match kind {
        OperandKind::Choice(list) => list.word(value).is_some(),
        OperandKind::Literal { or_zero, least, greatest, step, .. } => {
            (least..=greatest).contains(&value) && value % step.max(1) == 0 || or_zero && value == 0
        }
        OperandKind::SafetyBit { immediate } => immediate && (0..=1).contains(&value),
        OperandKind::SafetyInteger { immediate, .. } => {
            immediate.is_some_and(|(least, greatest)| (least..=greatest).contains(&value))
        }
        OperandKind::SafetyReal { immediate, not_negative } => {
            let real = f32::from_bits(value as u32);
            immediate && real.is_finite() && (!not_negative || real >= 0.0)
        }
        _ => false,
    }
}

/// A literal that the catalog admits: a limit, a value of a vector, or anything, short times more often.
fn literal(random: &mut Random, kind: OperandKind, known: &[i32]) -> i32 {
    let known: Vec<i32> = known.iter().copied().filter(|value| is_admitted(kind, *value)).collect();
    match kind {
        OperandKind::Choice(list) => random.of(list.words).1,
        OperandKind::Literal { least, greatest, step, .. } => match random.below(8) {
            0 => least,
            1 => greatest,
            2..=4 if !known.is_empty() => *random.of(&known),
            5 if is_admitted(kind, 0) => 0,
            _ => in_range(random, least, greatest) / step.max(1) * step.max(1),
        },
        OperandKind::SafetyInteger { immediate: Some((least, greatest)), .. } => match random.below(8) {
            0 => least,
            1 => greatest,
            2..=5 if !known.is_empty() => *random.of(&known),
            _ => in_range(random, least, greatest),
        },
        OperandKind::SafetyReal { .. } => {
            if known.is_empty() {
                random.between(0, 100) as f32 as i32
            } else {
                *random.of(&known)
            }
        }
        _ => random.below(2) as i32,
    }
}

/// Small values as often as each power of two above them.
fn in_range(random: &mut Random, least: i32, greatest: i32) -> i32 {
    let width = (i64::from(greatest) - i64::from(least)) as u64;
    let bits = 64 - width.leading_zeros() as usize;
    let shift = random.between(64 - bits.max(1), 63);
    let offset = (random.bits() >> shift).min(width);
    (i64::from(least) + offset as i64) as i32
}

/// The type of an operand that is a tag.
pub fn element(kind: OperandKind) -> Element {
    match kind {
        OperandKind::SafetyBit { .. } => Element::Bool,
        OperandKind::SafetyReal { .. } => Element::Real,
        _ => Element::Dint,
    }
}
