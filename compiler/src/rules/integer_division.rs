//! An integer division beside REAL. general-instructions.md A.9.

use twinrung_catalog::{Element, Opcode};

use crate::diagnostic::{Finding, Findings};
use crate::operand::{BinaryOperator, Expression, Operand};
use crate::project::Project;
use crate::rules::usage;

rule! {
    /// A division of integers in an expression that holds REAL.
    "W0114", Warning, "a division of integers stands in a REAL expression",
    "Because one operand of the expression is REAL, every operand is converted first: 1 / 2 gives 0.5 here and 0 where all are integers. Write the literals as REAL, or divide on a rung of its own.",
    "general-instructions.md A.9",
    good: sample!("    A, B : REAL (Class := Safety);\n", "      N: CPT(B,A + 1.0 / 2.0);\n"),
    bad: sample!("    A, B : REAL (Class := Safety);\n", "      N: CPT(B,<<A + 1 / 2>>);\n")
}

/// Expressions with both.
pub(crate) fn check(project: &Project, findings: &mut Findings) {
    if !project.opcodes.any(&[Opcode::Cpt, Opcode::Cmp, Opcode::Fal, Opcode::Fsc]) {
        return;
    }
    usage::instructions(project, &mut |_, instruction| {
        let destination = instruction.operands.iter().any(|one| {
            project.operand(one.id).reference().is_some_and(|one| one.element() == Some(Element::Real))
        });
        for one in &instruction.operands {
            let Operand::Expression(expression) = project.operand(one.id) else { continue };
            if (destination || expression.holds_real()) && divides_integers(expression) {
                let finding = Finding::new(&CODE, one.span, "this division of integers is computed as REAL");
                findings.push(finding.help("write the literals as REAL (1.0), or divide in an instruction of its own"));
            }
        }
    });
}

fn divides_integers(expression: &Expression) -> bool {
    match expression {
        Expression::Integer { .. } | Expression::Real(_) | Expression::Reference(_) => false,
        Expression::Unary(_, operand) => divides_integers(operand),
        Expression::Binary(operator, left, right) => {
            let own = *operator == BinaryOperator::Divide && !left.holds_real() && !right.holds_real();
            own || divides_integers(left) || divides_integers(right)
        }
    }
}
