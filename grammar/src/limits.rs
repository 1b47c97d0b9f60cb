//! Every limit of reading, with its reason. A file beyond one is refused with an error that names
//! it; nothing here panics, recurses without a limit, or takes more than linear time.

/// Bytes of one file. The largest exports known are below this; spans are 32-bit offsets.
pub const FILE_BYTES_MAX: usize = 64 << 20;

/// Bytes that the tree of one file may take, as counted roughly while reading. Few bytes of text can
/// be many of tree (`[,,,,]`, `a,b,c : X`); reading stops with an error where the count is reached.
/// A project of 100,000 rungs counts about a third of it.
pub const TREE_BYTES_MAX: usize = 2 << 30;

/// Tags that one declaration declares.
pub const NAMES_MAX: usize = 64;

/// Bytes of a declaration that declares more than one tag: each of them has a copy of its attributes
/// and value.
pub const JOINED_BYTES_MAX: usize = 8 << 10;

/// Branches in branches. Studio warns at 6; walkers of the tree may recurse this deep.
pub const BRANCH_DEPTH_MAX: usize = 64;

/// Parentheses, subscripts and signs in each other. Walkers of an expression recurse this deep,
/// beside [`EXPRESSION_OPERATORS_MAX`] for a chain such as `a+b+c`.
pub const EXPRESSION_DEPTH_MAX: usize = 64;

/// Operators in one expression: `a+b+c+...` is a tree as deep as it is long.
pub const EXPRESSION_OPERATORS_MAX: usize = 256;

/// Operands of one instruction. The longest real ones are calls with 40 parameters.
pub const OPERANDS_MAX: usize = 256;

/// Bytes of one operand. An expression in the editor has far fewer.
pub const OPERAND_BYTES_MAX: usize = 64 << 10;

/// Lists in lists of a tag's value, and structures in structures of decorated data. User-defined
/// types nest a few levels; walkers of a value may recurse this deep.
pub const VALUE_DEPTH_MAX: usize = 64;

/// Subscripts between one pair of brackets: Logix arrays have up to three dimensions.
pub const SUBSCRIPTS_MAX: usize = 3;

/// Elements of XML in elements. Real exports stay below 20.
pub const XML_DEPTH_MAX: usize = 256;

/// XML attributes of one element. Real exports stay below 100 (alarms).
pub const XML_ATTRIBUTES_MAX: usize = 512;

/// Errors that one reading reports; after that it goes on in silence, so that a megabyte of noise
/// does not become a gigabyte of errors.
pub const ERRORS_MAX: usize = 1_000;

/// Files of one folder.
pub const FOLDER_FILES_MAX: usize = 4_096;
