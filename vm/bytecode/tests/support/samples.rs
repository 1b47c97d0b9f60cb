//! Images that hold one of everything.

use super::*;

/// Two bits and a coil: the smallest application that does something.
pub fn small() -> Build {
    let mut b = build();
    let (a, c, e) = (b.bit("A"), b.bit("B"), b.bit("C"));
    b.rung(&[op(Opcode::Xic, &[a]), op(Opcode::Xio, &[c]), op(Opcode::Ote, &[e])]);
    b
}
