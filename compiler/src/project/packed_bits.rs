//! BIT members of a data type and the hidden SINTs that host them: that they lie where the layout puts them.
//! neutral-text-and-l5x.md D.4.
//!
//! The layout of an image packs consecutive BOOLs, eight to a byte, and needs no numbers for that. It is the one that a
//! type means only where every host is full before the next one begins and its bits are numbered without a gap, as
//! Studio numbers them. Anything else would let COP find another bit, so it is refused.

use twinrung_grammar::tree::{DataType, Member, Span};

/// Bits of a SINT.
const HOST_BITS: u32 = 8;

/// The hidden member that the BIT members after it name.
struct Host<'a> {
    member: &'a Member,
    bits: u32,
}

/// The first member that lies elsewhere than the layout puts it, and why.
pub(super) fn fault(data_type: &DataType) -> Option<(Span, &'static str)> {
    let mut host: Option<Host<'_>> = None;
    // Consecutive scalar BOOLs so far, as the layout packs them.
    let mut packed = 0;
    for member in &data_type.members {
        match &member.bit {
            Some(place) => {
                let Some(host) = host.as_mut().filter(|host| host.member.name.is(place.target.as_str())) else {
                    return Some((place.target.span, "a BIT stands behind the hidden SINT that it names as its host"));
                };
                if place.number.value != host.bits || host.bits >= HOST_BITS {
                    let why = "the BITs of a host are numbered 0, 1, 2, ... to 7 without a gap; other numbers are not supported";
                    return Some((place.number.span, why));
                }
                host.bits += 1;
                packed += 1;
                continue;
            }
            None => {
                if let Some(fault) = unused(host.take()) {
                    return Some(fault);
                }
            }
        }
        let scalar = member.dimensions.is_scalar();
        if member.hidden {
            if !scalar || !member.data_type.is("SINT") {
                return Some((member.data_type.span, "a hidden member is a SINT that hosts BITs"));
            }
            if packed % HOST_BITS != 0 {
                let why = "a host stands behind a full one, or behind a member that is no BOOL; another layout is not supported";
                return Some((member.name.span, why));
            }
            host = Some(Host { member, bits: 0 });
        } else if scalar && (member.data_type.is("BOOL") || member.data_type.is("BIT")) {
            packed += 1;
        } else {
            packed = 0;
        }
    }
    unused(host)
}

fn unused(host: Option<Host<'_>>) -> Option<(Span, &'static str)> {
    let host = host.filter(|host| host.bits == 0)?;
    Some((host.member.name.span, "no BIT names this hidden member, so that nothing shows what it holds"))
}
