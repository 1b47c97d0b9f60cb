//! Instructions of rungs, and the tags that their operands name.

use twinrung_grammar::read_expression;
use twinrung_grammar::tree::{Element, Expression, Instruction, Operand, Part, TagReference};

/// All instructions of a rung, from left to right.
pub fn instructions(elements: &[Element]) -> Vec<&Instruction> {
    let mut found = Vec::new();
    for element in elements {
        match element {
            Element::Instruction(instruction) => found.push(instruction),
            Element::Branch(branch) => found.extend(branch.legs.iter().flat_map(|leg| instructions(&leg.elements))),
        }
    }
    found
}

/// The same, to change them.
pub fn instructions_mut(elements: &mut [Element]) -> Vec<&mut Instruction> {
    let mut found = Vec::new();
    for element in elements {
        match element {
            Element::Instruction(instruction) => found.push(instruction),
            Element::Branch(branch) => {
                found.extend(branch.legs.iter_mut().flat_map(|leg| instructions_mut(&mut leg.elements)));
            }
        }
    }
    found
}

/// Every tag that an operand names, within subscripts too; none where it is no tag and no expression.
pub fn references(operand: &Operand) -> Vec<TagReference> {
    let mut found = Vec::new();
    let mut open: Vec<Expression> = read_expression(operand).into_iter().collect();
    while let Some(expression) = open.pop() {
        match expression {
            Expression::Immediate(_) => {}
            Expression::Unary { operand, .. } => open.push(*operand),
            Expression::Binary { left, right, .. } => open.extend([*left, *right]),
            Expression::Call { arguments, .. } => open.extend(arguments),
            Expression::Tag(tag) => {
                for part in &tag.parts {
                    match part {
                        Part::Subscripts { subscripts, .. } => open.extend(subscripts.iter().cloned()),
                        Part::BitSubscript { index, .. } => open.push((**index).clone()),
                        Part::Member(_) | Part::Bit { .. } => {}
                    }
                }
                found.push(tag);
            }
        }
    }
    found
}

/// What an expression uses that is no arithmetic, bitwise logic, relation, ABS or SQR.
pub fn uncertified_operators(operand: &Operand) -> Vec<String> {
    use twinrung_grammar::tree::BinaryOperator;
    let mut found = Vec::new();
    let mut open: Vec<Expression> = read_expression(operand).into_iter().collect();
    while let Some(expression) = open.pop() {
        match expression {
            Expression::Unary { operand, .. } => open.push(*operand),
            Expression::Binary { operator, left, right, .. } => {
                if operator == BinaryOperator::Power {
                    found.push("**".to_owned());
                }
                open.extend([*left, *right]);
            }
            Expression::Call { function, arguments, .. } => {
                if !["ABS", "SQR"].iter().any(|known| function.is(known)) {
                    found.push(function.text.to_uppercase().to_string());
                }
                open.extend(arguments);
            }
            Expression::Immediate(_) | Expression::Tag(_) => {}
        }
    }
    found
}
