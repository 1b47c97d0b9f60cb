//! The bits of each record of the decoded program.

use twinrung_catalog::Element;
use twinrung_safety_primary::bits;
use twinrung_safety_primary::injection::{Coded, Few};

use crate::lower::table::{
    ArithmeticRecord, CompareRecord, Gate, GeneralRecord, Kind, TimerRecord, WordBitRecord, WorkRun,
};
use crate::number::{Binary, Relation};
use crate::program::{
    AddOnCall, Argument, BitNumber, Body, Code, Content, CopyPlan, FormulaOperation, Instruction, Jump, Label,
    Location, Operand, ProgramEntry, Range, SafetyCall, Side, Single, Step, SystemValue,
};

bits!(Range { first, count });
bits!(Location { bit, word, formula });
bits!(Instruction { opcode, operands, element, extra });
bits!(Body { routine, codes, steps, of_program, stepped, parameters, jumps });
bits!(Label { code, rung, step });
bits!(Jump { label, backward });
bits!(AddOnCall { element, enable_in, enable_out, inputs, outputs, varying, logic, prescan, enable_in_false });
bits!(Argument { outside, inside });
bits!(CopyPlan { length, source, destination });
bits!(Side { bytes, bit_cells, word_cells, fields, content, count });
bits!(SafetyCall { opcode, state, bit, word });
bits!(ProgramEntry { main, fault, disabled });
bits!(SystemValue { record_of, first, length, element_bytes });
bits!(Single { code, rung, input, output, depth, resume });
bits!(WorkRun { kind, range });
bits!(Gate<T> where (T) { inputs, out, table });
bits!(TimerRecord { input, word, bit });
bits!(CompareRecord { left, right, out });
bits!(WordBitRecord { word, bit, out });
bits!(ArithmeticRecord { input, left, right, destination, order });
bits!(GeneralRecord { instruction, input, output, order });
bits!(
    enum Relation {
        Equal,
        NotEqual,
        Greater,
        GreaterOrEqual,
        Less,
        LessOrEqual,
    }
);
bits!(
    enum Binary {
        Add,
        Subtract,
        Multiply,
        Divide,
        Modulo,
        And,
        Or,
        Xor,
    }
);
bits!(coded Kind);
bits!(coded Content);
bits!(coded BitNumber);
bits!(coded Code);
bits!(coded Step);
bits!(coded Operand);
bits!(coded FormulaOperation);

/// The rank of a kind is its number.
impl Coded for Kind {
    type Code = Few<5>;
    const FIRST: Kind = Kind::Gates;

    fn code(&self) -> Few<5> {
        Few(self.rank() as u32)
    }

    fn of(Few(number): Few<5>) -> Option<Kind> {
        let relations = Relation::LISTED.iter().copied().map(Kind::Compares);
        let operators = Binary::LISTED.iter().copied().map(Kind::Arithmetic);
        [Kind::Gates, Kind::WordBits, Kind::OnDelays, Kind::OffDelays, Kind::Retentives, Kind::General, Kind::Moves]
            .into_iter()
            .chain(relations)
            .chain(operators)
            .find(|kind| kind.rank() as u32 == number)
    }
}

impl Coded for Content {
    type Code = (bool, u16);
    const FIRST: Content = Content::Element(Element::Bool);

    fn code(&self) -> Self::Code {
        match *self {
            Content::Element(element) => (false, element as u16),
            Content::Structure(index) => (true, index),
        }
    }

    fn of((structure, number): Self::Code) -> Option<Content> {
        if structure {
            return Some(Content::Structure(number));
        }
        Element::ALL.into_iter().find(|element| *element as u16 == number).map(Content::Element)
    }
}

impl Coded for BitNumber {
    /// Whether it varies; the formula; the number or the length.
    type Code = (bool, u32, u8);
    const FIRST: BitNumber = BitNumber::Constant(0);

    fn code(&self) -> Self::Code {
        match *self {
            BitNumber::Constant(bit) => (false, 0, bit),
            BitNumber::Variable { formula, length } => (true, formula, length),
        }
    }

    fn of((varies, formula, number): Self::Code) -> Option<BitNumber> {
        Some(if varies { BitNumber::Variable { formula, length: number } } else { BitNumber::Constant(number) })
    }
}

impl Coded for Code {
    type Code = (Few<3>, u32);
    const FIRST: Code = Code::Rung;

    fn code(&self) -> Self::Code {
        let (number, index) = match *self {
            Code::Rung => (0, 0),
            Code::EndRung => (1, 0),
            Code::Branch => (2, 0),
            Code::NextLeg => (3, 0),
            Code::EndBranch => (4, 0),
            Code::Instruction(index) => (5, index),
            Code::AddOn(index) => (6, index),
        };
        (Few(number), index)
    }

    fn of((Few(number), index): Self::Code) -> Option<Code> {
        Some(match number {
            0 => Code::Rung,
            1 => Code::EndRung,
            2 => Code::Branch,
            3 => Code::NextLeg,
            4 => Code::EndBranch,
            5 => Code::Instruction(index),
            6 => Code::AddOn(index),
            _ => return None,
        })
    }
}

impl Coded for Step {
    type Code = (Few<2>, [u32; 6]);
    const FIRST: Step = Step::Block { runs: Range { first: 0, count: 0 }, instructions: 0 };

    fn code(&self) -> Self::Code {
        match *self {
            Step::Block { runs: Range { first, count }, instructions } => {
                (Few(0), [first, count, instructions, 0, 0, 0])
            }
            Step::Single(Single { code, rung, input, output, depth, resume }) => {
                (Few(1), [code, rung, input, output, depth, resume])
            }
            Step::End { rungs } => (Few(2), [rungs, 0, 0, 0, 0, 0]),
        }
    }

    fn of((Few(number), [a, b, c, d, e, f]): Self::Code) -> Option<Step> {
        Some(match number {
            0 => Step::Block { runs: Range { first: a, count: b }, instructions: c },
            1 => Step::Single(Single { code: a, rung: b, input: c, output: d, depth: e, resume: f }),
            2 => Step::End { rungs: a },
            _ => return None,
        })
    }
}

/// No data.
const NOWHERE: Location = Location { bit: 0, word: 0, formula: 0 };

impl Coded for Operand {
    /// The variant, the location, numbers, the type of an element, what a region or a bit number is.
    type Code = (Few<4>, Location, [u32; 3], Element, (Content, BitNumber));
    const FIRST: Operand = Operand::Nothing;

    fn code(&self) -> Self::Code {
        let value = |number: u32, value: u32| {
            (Few(number), NOWHERE, [value, 0, 0], Element::Bool, (Content::FIRST, BitNumber::FIRST))
        };
        match *self {
            Operand::Nothing => value(0, 0),
            Operand::Integer(integer) => value(1, integer as u32),
            Operand::Real(real) => value(2, real.to_bits()),
            Operand::Routine(body) => value(3, body),
            Operand::Status(keyword) => value(4, u32::from(keyword)),
            Operand::SystemValue(index) => value(5, u32::from(index)),
            Operand::EventTask(index) => value(6, u32::from(index)),
            Operand::Expression { formula, real, overflows } => {
                let numbers = [formula, u32::from(real), u32::from(overflows)];
                (Few(7), NOWHERE, numbers, Element::Bool, (Content::FIRST, BitNumber::FIRST))
            }
            Operand::Bit(location) => (Few(8), location, [0; 3], Element::Bool, (Content::FIRST, BitNumber::FIRST)),
            Operand::Word { location, element, count } => {
                (Few(9), location, [count, 0, 0], element, (Content::FIRST, BitNumber::FIRST))
            }
            Operand::WordBit { location, number, element } => {
                (Few(10), location, [0; 3], element, (Content::FIRST, number))
            }
            Operand::Region { location, content, count, bit_cells, word_cells } => {
                (Few(11), location, [count, bit_cells, word_cells], Element::Bool, (content, BitNumber::FIRST))
            }
        }
    }

    fn of((Few(number), location, [a, b, c], element, (content, bit_number)): Self::Code) -> Option<Operand> {
        let flag = |number: u32| (number < 2).then_some(number == 1);
        Some(match number {
            0 => Operand::Nothing,
            1 => Operand::Integer(a as i32),
            2 => Operand::Real(f32::from_bits(a)),
            3 => Operand::Routine(a),
            4 => Operand::Status(u8::try_from(a).ok()?),
            5 => Operand::SystemValue(u16::try_from(a).ok()?),
            6 => Operand::EventTask(u16::try_from(a).ok()?),
            7 => Operand::Expression { formula: a, real: flag(b)?, overflows: flag(c)? },
            8 => Operand::Bit(location),
            9 => Operand::Word { location, element, count: a },
            10 => Operand::WordBit { location, number: bit_number, element },
            11 => Operand::Region { location, content, count: a, bit_cells: b, word_cells: c },
            _ => return None,
        })
    }
}

impl Coded for FormulaOperation {
    /// The variant, numbers, the type to fill, an operator, whether on REAL.
    type Code = (Few<4>, [u32; 4], Element, u8, bool);
    const FIRST: FormulaOperation = FormulaOperation::Push(0);

    fn code(&self) -> Self::Code {
        let numbers = |number: u32, numbers: [u32; 4]| (Few(number), numbers, Element::Bool, 0, false);
        match *self {
            FormulaOperation::Push(value) => numbers(0, [value as u32, 0, 0, 0]),
            FormulaOperation::Load { word } => numbers(1, [word, 0, 0, 0]),
            FormulaOperation::LoadAddress => numbers(2, [0; 4]),
            FormulaOperation::Address { bit, word } => numbers(3, [bit, word, 0, 0]),
            FormulaOperation::Index { length, bit_stride, word_stride, elements } => {
                numbers(4, [length, bit_stride, word_stride, elements])
            }
            FormulaOperation::ZeroFill(element) => (Few(5), [0; 4], element, 0, false),
            FormulaOperation::ToReal => numbers(6, [0; 4]),
            FormulaOperation::ToInteger => numbers(7, [0; 4]),
            FormulaOperation::Apply { operator, real } => (Few(8), [0; 4], Element::Bool, operator, real),
        }
    }

    fn of((Few(number), [a, b, c, d], element, operator, real): Self::Code) -> Option<FormulaOperation> {
        Some(match number {
            0 => FormulaOperation::Push(a as i32),
            1 => FormulaOperation::Load { word: a },
            2 => FormulaOperation::LoadAddress,
            3 => FormulaOperation::Address { bit: a, word: b },
            4 => FormulaOperation::Index { length: a, bit_stride: b, word_stride: c, elements: d },
            5 => FormulaOperation::ZeroFill(element),
            6 => FormulaOperation::ToReal,
            7 => FormulaOperation::ToInteger,
            8 => FormulaOperation::Apply { operator, real },
            _ => return None,
        })
    }
}
