//! Binding the members of a backing tag by name, once, while the crate is compiled.
//!
//! A member that the catalog renames, drops or gives another role no longer compiles here, and so does an output
//! member that an instruction forgets.

use twinrung_catalog::{MemberRole, PredefinedType};

/// Set by the interpreter around a call, never by an instruction: `EnableOut` is the rung condition.
const ENABLE_OUT: &str = "EnableOut";

/// Position of the member `name` that mirrors an operand.
pub(crate) const fn input(backing: &PredefinedType, name: &str) -> usize {
    let (position, role) = find(backing, name);
    assert!(matches!(role, MemberRole::Input | MemberRole::Configuration), "not a member that mirrors an operand");
    position
}

/// Position of the member `name` that holds a result.
pub(crate) const fn output(backing: &PredefinedType, name: &str) -> usize {
    let (position, role) = find(backing, name);
    assert!(matches!(role, MemberRole::Output), "not a member that holds a result");
    position
}

/// How many results an instruction with this backing type has to write.
pub(crate) const fn outputs(backing: &PredefinedType) -> usize {
    let mut rest = backing.members;
    let mut count = 0usize;
    while let [member, tail @ ..] = rest {
        if matches!(member.role, MemberRole::Output) && !same(member.name, ENABLE_OUT) {
            count = count.wrapping_add(1);
        }
        rest = tail;
    }
    count
}

const fn find(backing: &PredefinedType, name: &str) -> (usize, MemberRole) {
    let mut rest = backing.members;
    let mut position = 0usize;
    loop {
        assert!(!rest.is_empty(), "the backing type has no member of that name");
        if let [member, tail @ ..] = rest {
            if same(member.name, name) {
                return (position, member.role);
            }
            rest = tail;
        }
        position = position.wrapping_add(1);
    }
}

const fn same(left: &str, right: &str) -> bool {
    let (mut left, mut right) = (left.as_bytes(), right.as_bytes());
    loop {
        match (left, right) {
            ([], []) => return true,
            ([a, left_tail @ ..], [b, right_tail @ ..]) if *a == *b => {
                left = left_tail;
                right = right_tail;
            }
            _ => return false,
        }
    }
}

/// Declares which members of a backing type an instruction reads and writes: a constant position for each, the type
/// `Members` of the whole tag, and `clear_outputs`.
macro_rules! members {
    (
        $backing:path;
        inputs { $($input:ident = $input_name:literal),* $(,)? }
        outputs { $($output:ident = $output_name:literal),* $(,)? }
    ) => {
        /// The members of the backing tag in the catalog's order, each as 32 bits.
        pub(crate) type Members = [i32; $backing.members.len()];

        $(const $input: usize = $crate::members::input(&$backing, $input_name);)*
        $(const $output: usize = $crate::members::output(&$backing, $output_name);)*

        const _: () = assert!(
            [$($output),*].len() == $crate::members::outputs(&$backing),
            "an output member of the backing type is not written"
        );

        /// De-energizes every output and clears every code.
        fn clear_outputs(members: &mut Members) {
            $(members[$output] = 0;)*
        }
    };
}

pub(crate) use members;
