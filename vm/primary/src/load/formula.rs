//! Flattens subscripts and expressions into formulas. Nesting is resolved here, on an explicit stack, so that a scan
//! neither recurses nor decodes.

use alloc::vec;
use alloc::vec::Vec;

use twinrung_bytecode::format;
use twinrung_catalog::Element;

use super::Loader;
use super::operand::{Binding, Reference};
use crate::error::LoadError;
use crate::program::{Content, FormulaOperation, Operand, Range};

/// Values that a formula may have open: 32 for each of the 8 levels of nesting that an operand may have.
pub(crate) const VALUES: usize = 512;
/// Addresses that a formula may have open.
pub(crate) const ADDRESSES: usize = 32;
/// Operations of one flattened formula: what a scan can spend on one operand.
const OPERATIONS: usize = 1 << 14;

/// What is still to be flattened.
enum Task {
    /// A word or a literal, in the form that its consumer wants.
    Leaf {
        operand: u32,
        wanted: Wanted,
    },
    /// An integer: a word, or an expression over integers.
    Integer(u32),
    Operation(FormulaOperation),
}

/// The form in which the consumer of a value wants it.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Wanted {
    AsItIs,
    Signed,
    ZeroFilled,
    Real,
}

/// The type of a leaf.
#[derive(Clone, Copy)]
enum LeafType {
    Integer(Element),
    Real,
}

/// One operation of an expression of the image.
#[derive(Clone, Copy)]
enum Token {
    Push(u32),
    Apply(u8),
}

fn is_logical(operator: u8) -> bool {
    matches!(operator, format::OPERATION_NOT | format::OPERATION_AND | format::OPERATION_XOR | format::OPERATION_OR)
}

fn is_relation(operator: u8) -> bool {
    (format::OPERATION_LESS..=format::OPERATION_NOT_EQUAL).contains(&operator)
}

fn takes_one(operator: u8) -> bool {
    operator <= format::OPERATION_SQUARE_ROOT
}

impl Loader<'_> {
    /// A formula that leaves the address of a reference.
    pub(crate) fn address_formula(&mut self, reference: &Reference, binding: &Binding) -> Result<u32, LoadError> {
        let mut tasks = Vec::new();
        push_address(&mut tasks, reference);
        self.flatten(tasks, binding)
    }

    /// A formula that leaves an integer: a subscript's or bit number's operand.
    pub(crate) fn value_formula(&mut self, operand: u32, binding: &Binding) -> Result<u32, LoadError> {
        self.flatten(vec![Task::Integer(operand)], binding)
    }

    /// The expression of CPT, CMP, FAL or FSC. `real_destination`: whether its value is stored into a REAL.
    pub(crate) fn expression(
        &mut self,
        operand: u32,
        binding: &Binding,
        real_destination: bool,
    ) -> Result<Operand, LoadError> {
        if self.entry(operand)?.u8()? != format::EXPRESSION {
            let real = matches!(self.leaf_type(operand, binding)?, LeafType::Real);
            let formula = self.flatten(vec![Task::Leaf { operand, wanted: Wanted::AsItIs }], binding)?;
            return Ok(Operand::Expression { formula, real, overflows: false });
        }
        let tokens = self.tokens(operand)?;
        let mut real_mode = real_destination;
        let mut overflows = false;
        for token in &tokens {
            match token {
                Token::Push(leaf) => {
                    let real = matches!(self.leaf_type(*leaf, binding)?, LeafType::Real);
                    real_mode |= real;
                }
                Token::Apply(operator) => overflows |= !is_relation(*operator) && !is_logical(*operator),
            }
        }
        // Rounding a REAL for AND, OR, XOR or NOT can overflow too.
        overflows |= real_mode;
        let (tasks, real) = self.typed(&tokens, real_mode, binding)?;
        let formula = self.flatten(tasks, binding)?;
        Ok(Operand::Expression { formula, real, overflows })
    }

    fn tokens(&self, operand: u32) -> Result<Vec<Token>, LoadError> {
        let mut reader = self.entry(operand)?;
        if reader.u8()? != format::EXPRESSION {
            return Err(LoadError::Malformed("an operand that should be an expression"));
        }
        let count = usize::from(reader.u16()?);
        let mut tokens = Vec::with_capacity(count);
        for _ in 0..count {
            tokens.push(match reader.u8()? {
                format::OPERATION_PUSH => Token::Push(reader.u32()?),
                operator => Token::Apply(operator),
            });
        }
        Ok(tokens)
    }

    fn leaf_type(&self, operand: u32, binding: &Binding) -> Result<LeafType, LoadError> {
        Ok(match self.entry(operand)?.u8()? {
            format::INTEGER => LeafType::Integer(Element::Dint),
            format::REAL => LeafType::Real,
            format::REFERENCE => match self.reference(operand, binding)?.content {
                Content::Element(Element::Real) => LeafType::Real,
                Content::Element(element) => LeafType::Integer(element),
                Content::Structure(_) => return Err(LoadError::Malformed("a structure in an expression")),
            },
            _ => return Err(LoadError::Malformed("an operand of an expression")),
        })
    }

    /// The tasks of an expression in order, with the conversions between its operators (CPT, CMP, FAL and FSC
    /// expressions: typing), and whether its value is REAL.
    fn typed(&self, tokens: &[Token], real_mode: bool, binding: &Binding) -> Result<(Vec<Task>, bool), LoadError> {
        const MALFORMED: LoadError = LoadError::Malformed("an expression");
        // Which operator takes the value of each token: postfix needs a first pass to know.
        let mut consumers: Vec<Option<u8>> = vec![None; tokens.len()];
        let mut open: Vec<usize> = Vec::new();
        for (position, token) in tokens.iter().enumerate() {
            if let Token::Apply(operator) = token {
                let takes = if takes_one(*operator) { 1 } else { 2 };
                for _ in 0..takes {
                    let producer = open.pop().ok_or(MALFORMED)?;
                    *consumers.get_mut(producer).ok_or(MALFORMED)? = Some(*operator);
                }
            }
            open.push(position);
        }
        if open.len() != 1 {
            return Err(MALFORMED);
        }
        let mut tasks = Vec::with_capacity(tokens.len().saturating_mul(2));
        let mut result_is_real = false;
        for (token, consumer) in tokens.iter().zip(&consumers) {
            match token {
                Token::Push(leaf) => {
                    let real = matches!(self.leaf_type(*leaf, binding)?, LeafType::Real);
                    let wanted = match consumer {
                        Some(operator) if is_logical(*operator) => Wanted::ZeroFilled,
                        Some(_) if real_mode => Wanted::Real,
                        Some(_) => Wanted::Signed,
                        None => Wanted::AsItIs,
                    };
                    result_is_real = real;
                    tasks.push(Task::Leaf { operand: *leaf, wanted });
                }
                Token::Apply(operator) => {
                    let computes_real = real_mode && !is_logical(*operator);
                    tasks.push(Task::Operation(FormulaOperation::Apply { operator: *operator, real: computes_real }));
                    let real = computes_real && !is_relation(*operator);
                    match consumer {
                        Some(next) if is_logical(*next) && real => {
                            tasks.push(Task::Operation(FormulaOperation::ToInteger));
                        }
                        Some(next) if !is_logical(*next) && real_mode && !real => {
                            tasks.push(Task::Operation(FormulaOperation::ToReal));
                        }
                        _ => {}
                    }
                    result_is_real = real;
                }
            }
        }
        Ok((tasks, result_is_real))
    }

    /// Resolves the tasks, in their order, into one formula.
    fn flatten(&mut self, mut tasks: Vec<Task>, binding: &Binding) -> Result<u32, LoadError> {
        let first = self.program.formula_operations.len();
        tasks.reverse();
        while let Some(task) = tasks.pop() {
            match task {
                Task::Operation(operation) => self.program.formula_operations.push(operation),
                Task::Integer(operand) if self.entry(operand)?.u8()? != format::EXPRESSION => {
                    self.leaf(operand, Wanted::Signed, binding, &mut tasks)?;
                }
                Task::Integer(operand) => {
                    let tokens = self.tokens(operand)?;
                    let (mut inner, _) = self.typed(&tokens, false, binding)?;
                    inner.reverse();
                    tasks.append(&mut inner);
                }
                Task::Leaf { operand, wanted } => self.leaf(operand, wanted, binding, &mut tasks)?,
            }
            let size = self.program.formula_operations.len().saturating_sub(first).saturating_add(tasks.len());
            if size > OPERATIONS {
                return Err(LoadError::TooLarge("the subscripts of one operand"));
            }
        }
        let range = Range::since(first, &self.program.formula_operations);
        check_depth(range.of(&self.program.formula_operations))?;
        let index = u32::try_from(self.program.formulas.len()).map_err(|_| LoadError::TooLarge("the formulas"))?;
        self.program.formulas.push(range);
        Ok(index)
    }

    fn leaf(
        &mut self,
        operand: u32,
        wanted: Wanted,
        binding: &Binding,
        tasks: &mut Vec<Task>,
    ) -> Result<(), LoadError> {
        let mut reader = self.entry(operand)?;
        let kind = reader.u8()?;
        let leaf_type = match kind {
            format::INTEGER => {
                let _radix = reader.u8()?;
                let value = reader.i32()?;
                self.program.formula_operations.push(FormulaOperation::Push(value));
                LeafType::Integer(Element::Dint)
            }
            format::REAL => {
                let bits = reader.u32()?;
                self.program.formula_operations.push(FormulaOperation::Push(bits as i32));
                LeafType::Real
            }
            _ => self.leaf_type(operand, binding)?,
        };
        let conversion = match (leaf_type, wanted) {
            (LeafType::Integer(_), Wanted::Real) => Some(FormulaOperation::ToReal),
            (LeafType::Integer(element), Wanted::ZeroFilled) => Some(FormulaOperation::ZeroFill(element)),
            (LeafType::Real, Wanted::ZeroFilled | Wanted::Signed) => Some(FormulaOperation::ToInteger),
            _ => None,
        };
        if let Some(operation) = conversion {
            tasks.push(Task::Operation(operation));
        }
        if kind != format::REFERENCE {
            return Ok(());
        }
        let reference = self.reference(operand, binding)?;
        if reference.shape != format::SHAPE_WORD {
            return Err(LoadError::Malformed("an operand of an expression that is no word"));
        }
        if reference.terms.is_empty() {
            self.program.formula_operations.push(FormulaOperation::Load { word: reference.word });
            return Ok(());
        }
        let mut inner = Vec::new();
        push_address(&mut inner, &reference);
        inner.push(Task::Operation(FormulaOperation::LoadAddress));
        inner.reverse();
        tasks.append(&mut inner);
        Ok(())
    }
}

/// Appends the tasks that leave the address of a reference.
fn push_address(tasks: &mut Vec<Task>, reference: &Reference) {
    tasks.push(Task::Operation(FormulaOperation::Address { bit: reference.bit, word: reference.word }));
    for term in &reference.terms {
        tasks.push(Task::Integer(term.operand));
        tasks.push(Task::Operation(FormulaOperation::Index {
            length: term.length,
            bit_stride: term.bit_stride,
            word_stride: term.word_stride,
            elements: term.elements,
        }));
    }
}

/// Walks the formula as a scan will, so that the stacks of a scan can never run over.
fn check_depth(operations: &[FormulaOperation]) -> Result<(), LoadError> {
    let (mut values, mut addresses) = (0usize, 0usize);
    for operation in operations {
        let (takes, gives) = match operation {
            FormulaOperation::Push(_) | FormulaOperation::Load { .. } => (0, 1),
            FormulaOperation::LoadAddress => {
                addresses = addresses.saturating_sub(1);
                (0, 1)
            }
            FormulaOperation::Address { .. } => {
                addresses = addresses.saturating_add(1);
                (0, 0)
            }
            FormulaOperation::Index { .. } => (1, 0),
            FormulaOperation::ZeroFill(_) | FormulaOperation::ToReal | FormulaOperation::ToInteger => (1, 1),
            FormulaOperation::Apply { operator, .. } => (if takes_one(*operator) { 1 } else { 2 }, 1),
        };
        values = values.saturating_sub(takes).saturating_add(gives);
        if values > VALUES || addresses > ADDRESSES {
            return Err(LoadError::TooLarge("the nesting of one operand"));
        }
    }
    Ok(())
}
