//! The bytes of code and of operands. All numbers are little-endian.
//!
//! # Code of a routine
//!
//! ```text
//! routine  = rung*
//! rung     = RUNG element* END_RUNG
//! element  = opcode:u8 count:u8 operand:u32 * count          an instruction of the catalog (opcodes 16 and up)
//!          | ADD_ON count:u8 operand:u32 * count             a call: operand 0 is the instance, then one operand for each
//!                                                            parameter that has an argument, in declared order
//!          | BRANCH leg (NEXT_LEG leg)* END_BRANCH
//! leg      = element*                                        an empty leg is a short
//! ```
//!
//! Operands are indices into the operand table. Elements are counted from 0 within a rung, instructions and Add-On
//! calls only, in the order of the code; that number is an element's place.
//!
//! # An entry of the operand table
//!
//! First byte: the kind.
//!
//! ```text
//! INTEGER        radix:u8 (10, 16, 8, 2)  value:i32
//! REAL           bits:u32
//! CHOICE         value:i32                the word of a choice list, file mode, byte order; which list: by the declaration
//! UNASSIGNED                              `?`
//! TEXT           length:u16 bytes         a label, a system class or instance
//! ROUTINE        routine:u32
//! STATUS         keyword:u8               see STATUS_*
//! SYSTEM_VALUE   index:u16
//! EVENT_TASK     index:u16
//! EXPRESSION     count:u16 operation*     postfix; operation = PUSH operand:u32 | one byte, see OPERATION_*
//! REFERENCE      path_length:u16 path access
//! ```
//!
//! # The path of a reference: what the text says
//!
//! ```text
//! path  = root step*
//! root  = ROOT_TAG tag:u32 | ROOT_MEMBER add_on:u16 member:u16 | ROOT_IN_OUT add_on:u16 parameter:u16
//! step  = STEP_MEMBER member:u16
//!       | STEP_SUBSCRIPT count:u8 (SUBSCRIPT_CONSTANT value:u32 | SUBSCRIPT_OPERAND operand:u32) * count
//!       | STEP_BIT bit:u8
//!       | STEP_BIT_OPERAND operand:u32
//! ```
//!
//! ROOT_MEMBER and ROOT_IN_OUT occur only in routines of that Add-On Instruction. A subscript operand is a REFERENCE
//! to a word or an EXPRESSION over integers, and stands earlier in the table than the entry that uses it.
//!
//! # The access of a reference: where the data is
//!
//! ```text
//! access = shape:u8 element:u8 type:u16 base:u8 parameter:u16 bit_cell:u32 word_cell:u32 count:u32
//!          terms:u8 (operand:u32 length:u32 bit_stride:u32 word_stride:u32) * terms
//!          bit:u8 bit_operand:u32 bit_length:u8
//! ```
//!
//! - shape: SHAPE_BIT (one bit cell), SHAPE_WORD (one word cell), SHAPE_WORD_BIT (one bit of a word cell), SHAPE_REGION
//!   (a structure, or a whole array);
//! - element: the elementary type (of the element for an array of an elementary type, of the word for SHAPE_WORD_BIT);
//!   0xFF for structures; type: the structure's index, 0xFFFF for elementary types;
//! - base: BASE_ABSOLUTE, BASE_INSTANCE (cells count from the instance of the Add-On Instruction whose routine this
//!   is), BASE_IN_OUT (cells count from the argument of `parameter`); parameter is 0xFFFF otherwise;
//! - count: how many elements of that type lie from here to the end of the innermost array that holds them, 1 for a
//!   scalar. For an array designated as a whole, the number of its elements. Where a variable subscript selects the
//!   first element the count is that of the whole array, less what constant subscripts skip;
//!   1 for a bit of a word. A reference to an alias counts as its target's path does;
//! - terms: variable subscripts. The cell is `bit_cell + sum(value * bit_stride)` (likewise words). Each value must be
//!   0 .. length - 1, else the major fault 4/20; constant subscripts are already in bit_cell and word_cell;
//! - bit, bit_operand, bit_length: for SHAPE_WORD_BIT the bit number, or NO_BIT and the operand that gives it, which
//!   must be 0 .. bit_length - 1, else 4/20. bit_length is 8, 16 or 32. Unused: NO_BIT, NO_OPERAND, 0.

/// Begins a rung.
pub const RUNG: u8 = 1;
/// Ends a rung.
pub const END_RUNG: u8 = 2;
/// Begins a branch and its first leg.
pub const BRANCH: u8 = 3;
/// Ends a leg and begins the next.
pub const NEXT_LEG: u8 = 4;
/// Ends a branch.
pub const END_BRANCH: u8 = 5;
/// Calls an Add-On Instruction.
pub const ADD_ON: u8 = 8;

/// Operand kind: integer literal.
pub const INTEGER: u8 = 1;
/// Operand kind: REAL literal.
pub const REAL: u8 = 2;
/// Operand kind: a word out of a list.
pub const CHOICE: u8 = 3;
/// Operand kind: `?`.
pub const UNASSIGNED: u8 = 4;
/// Operand kind: text.
pub const TEXT: u8 = 5;
/// Operand kind: a routine of the same program.
pub const ROUTINE: u8 = 6;
/// Operand kind: a status keyword.
pub const STATUS: u8 = 7;
/// Operand kind: a system value.
pub const SYSTEM_VALUE: u8 = 8;
/// Operand kind: an event task.
pub const EVENT_TASK: u8 = 9;
/// Operand kind: an expression.
pub const EXPRESSION: u8 = 10;
/// Operand kind: a reference to data.
pub const REFERENCE: u8 = 11;

/// S:FS, first scan.
pub const STATUS_FIRST_SCAN: u8 = 0;
/// S:V, overflow.
pub const STATUS_OVERFLOW: u8 = 1;
/// S:Z, zero.
pub const STATUS_ZERO: u8 = 2;
/// S:N, negative.
pub const STATUS_NEGATIVE: u8 = 3;
/// S:C, carry.
pub const STATUS_CARRY: u8 = 4;
/// S:MINOR, a minor fault was logged.
pub const STATUS_MINOR: u8 = 5;
/// The keywords as text writes them, by number.
pub const STATUS_KEYWORDS: [&str; 6] = ["S:FS", "S:V", "S:Z", "S:N", "S:C", "S:MINOR"];

/// Expression: push an operand (INTEGER, REAL or a REFERENCE to a word).
pub const OPERATION_PUSH: u8 = 0;
/// Expression: - value.
pub const OPERATION_NEGATE: u8 = 1;
/// Expression: NOT value.
pub const OPERATION_NOT: u8 = 2;
/// Expression: ABS(value).
pub const OPERATION_ABSOLUTE: u8 = 3;
/// Expression: SQR(value).
pub const OPERATION_SQUARE_ROOT: u8 = 4;
/// Expression: left * right.
pub const OPERATION_MULTIPLY: u8 = 8;
/// Expression: left / right.
pub const OPERATION_DIVIDE: u8 = 9;
/// Expression: left MOD right.
pub const OPERATION_MODULO: u8 = 10;
/// Expression: left + right.
pub const OPERATION_ADD: u8 = 11;
/// Expression: left - right.
pub const OPERATION_SUBTRACT: u8 = 12;
/// Expression: left AND right.
pub const OPERATION_AND: u8 = 13;
/// Expression: left XOR right.
pub const OPERATION_XOR: u8 = 14;
/// Expression: left OR right.
pub const OPERATION_OR: u8 = 15;
/// Expression: left < right.
pub const OPERATION_LESS: u8 = 16;
/// Expression: left <= right.
pub const OPERATION_LESS_OR_EQUAL: u8 = 17;
/// Expression: left > right.
pub const OPERATION_GREATER: u8 = 18;
/// Expression: left >= right.
pub const OPERATION_GREATER_OR_EQUAL: u8 = 19;
/// Expression: left = right.
pub const OPERATION_EQUAL: u8 = 20;
/// Expression: left <> right.
pub const OPERATION_NOT_EQUAL: u8 = 21;

/// Path root: a tag.
pub const ROOT_TAG: u8 = 0;
/// Path root: a parameter or local tag of the Add-On Instruction.
pub const ROOT_MEMBER: u8 = 1;
/// Path root: an InOut parameter of the Add-On Instruction.
pub const ROOT_IN_OUT: u8 = 2;
/// Path step: a member.
pub const STEP_MEMBER: u8 = 3;
/// Path step: one to three subscripts.
pub const STEP_SUBSCRIPT: u8 = 4;
/// Path step: a bit by number.
pub const STEP_BIT: u8 = 5;
/// Path step: a bit by operand.
pub const STEP_BIT_OPERAND: u8 = 6;
/// Subscript: a number.
pub const SUBSCRIPT_CONSTANT: u8 = 0;
/// Subscript: an operand.
pub const SUBSCRIPT_OPERAND: u8 = 1;

/// Access shape: one bit cell.
pub const SHAPE_BIT: u8 = 0;
/// Access shape: one word cell.
pub const SHAPE_WORD: u8 = 1;
/// Access shape: one bit of a word cell.
pub const SHAPE_WORD_BIT: u8 = 2;
/// Access shape: a structure or a whole array.
pub const SHAPE_REGION: u8 = 3;
/// Access base: the image's own cells.
pub const BASE_ABSOLUTE: u8 = 0;
/// Access base: the instance of the Add-On Instruction.
pub const BASE_INSTANCE: u8 = 1;
/// Access base: the argument of an InOut parameter.
pub const BASE_IN_OUT: u8 = 2;
/// No elementary type.
pub const NO_ELEMENT: u8 = 0xFF;
/// No structure type, or no parameter.
pub const NO_INDEX: u16 = 0xFFFF;
/// No bit number.
pub const NO_BIT: u8 = 0xFF;
/// No operand.
pub const NO_OPERAND: u32 = u32::MAX;
