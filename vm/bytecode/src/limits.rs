//! Every bound of an image and of its execution, with its reason. Compiler, verifier and both interpreters read these;
//! each is tested at the limit and one past it.

/// Bytes of an image: room for 100,000 rungs with their texts, and a bound on what a loader reads.
pub const IMAGE_BYTES: usize = 256 << 20;
/// Cells of the bit space: 24 bits of index leave 8 for flags in an interpreter's own table.
pub const BIT_CELLS: u32 = 1 << 24;
/// Cells of the word space, for the same reason.
pub const WORD_CELLS: u32 = 1 << 24;
/// Structure types.
pub const TYPES: usize = 4096;
/// Members of a structure.
pub const MEMBERS: usize = 4096;
/// Depth of structures within structures: the verifier walks them on a bounded stack.
pub const TYPE_DEPTH: usize = 16;
/// Tags.
pub const TAGS: usize = 1 << 21;
/// Programs: what one safety task of the real controller schedules at most.
pub const PROGRAMS: usize = 100;
/// Routines of the image.
pub const ROUTINES: usize = 1 << 15;
/// Rungs of the image.
pub const RUNGS: usize = 1 << 20;
/// Instructions on one rung.
pub const INSTRUCTIONS_PER_RUNG: usize = 4096;
/// Branches within branches (decided in the reference: 64; the editor's own limit is near 6).
pub const BRANCH_DEPTH: usize = 64;
/// Legs of one branch.
pub const BRANCH_LEGS: usize = 1024;
/// Operands of one instruction: a JSR with 40 inputs and 40 returns is the longest.
pub const OPERANDS_PER_INSTRUCTION: usize = 84;
/// Entries of the operand table.
pub const OPERANDS: usize = 1 << 22;
/// Steps in the path of a reference (members, subscripts, a bit).
pub const PATH_STEPS: usize = 64;
/// Subscripts whose value is a tag or an expression, in one reference.
pub const SUBSCRIPT_TERMS: usize = 16;
/// Operations of one expression.
pub const EXPRESSION_OPERATIONS: usize = 256;
/// Values that an expression may have open at once.
pub const EXPRESSION_DEPTH: usize = 32;
/// References and expressions within the subscripts of one operand.
pub const SUBSCRIPT_DEPTH: usize = 8;
/// Subroutines within subroutines (recalled: 25).
pub const CALL_DEPTH: usize = 25;
/// Parameters of one JSR in each direction (recalled: 40).
pub const JSR_PARAMETERS: usize = 40;
/// Add-On Instructions within Add-On Instructions.
pub const ADD_ON_DEPTH: usize = 16;
/// Parameters of an Add-On Instruction.
pub const ADD_ON_PARAMETERS: usize = 512;
/// Instructions after every Add-On Instruction call has been replaced by its body: interpreters specialise bodies for each call.
pub const EXPANDED_INSTRUCTIONS: usize = 1 << 23;
/// How often one JMP may jump backward in one execution of its routine before it is a major fault (decided).
pub const BACKWARD_JUMPS: u32 = 1000;
/// Bytes that one COP moves.
pub const COPY_BYTES: u32 = 1 << 16;
/// Elements of one array tag.
pub const ARRAY_ELEMENTS: u32 = 1 << 20;
/// Settings of one declaration.
pub const ATTRIBUTES: usize = 256;
/// Safety modules: a rack or network of the real controller holds far fewer.
pub const MODULES: usize = 4096;
/// Lines of the tag map.
pub const MAP_LINES: usize = 1 << 16;
/// Attributes that GSV and SSV name.
pub const SYSTEM_VALUES: usize = 4096;
/// Event tasks that EVENT names: the real controller has at most 32 tasks.
pub const EVENT_TASKS: usize = 32;
/// Instructions that one scan can execute without a backward jump, subroutines counted at each call: the budget of a
/// scan is compared only at backward jumps and at its end, so this bounds how late that may be.
pub const STRAIGHT_INSTRUCTIONS: u64 = 1 << 24;
/// Calls with a backing tag, counted at every place where an Add-On Instruction that holds one is called.
pub const BACKING_CALLS: usize = 1 << 20;
/// Longest name in an image: 40 characters for a component, more for module tags and hidden members.
pub const NAME_BYTES: usize = 255;
/// Longest period of a safety task in microseconds (1756-RM093: 500 ms).
pub const PERIOD_US: u32 = 500_000;
/// Shortest period of a safety task in microseconds (decided: 1 ms).
pub const PERIOD_US_LEAST: u32 = 1_000;
/// Instructions per microsecond of watchdog that a scan may execute in simulated time (decided: a rate that either
/// interpreter exceeds many times over, so that the budget only stops loops).
pub const BUDGET_PER_MICROSECOND: u64 = 100;
