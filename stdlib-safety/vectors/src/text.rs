//! The files.

use twinrung_catalog::Opcode;

/// The text of an instruction's vector file.
pub(crate) fn of(opcode: Opcode) -> Option<&'static str> {
    Some(match opcode {
        Opcode::Avc => include_str!("../vectors/avc.vectors"),
        Opcode::Cbcm => include_str!("../vectors/cbcm.vectors"),
        Opcode::Cbim => include_str!("../vectors/cbim.vectors"),
        Opcode::Cbssm => include_str!("../vectors/cbssm.vectors"),
        Opcode::Cpm => include_str!("../vectors/cpm.vectors"),
        Opcode::Crout => include_str!("../vectors/crout.vectors"),
        Opcode::Csm => include_str!("../vectors/csm.vectors"),
        Opcode::Dca => include_str!("../vectors/dca.vectors"),
        Opcode::Dcaf => include_str!("../vectors/dcaf.vectors"),
        Opcode::Dcm => include_str!("../vectors/dcm.vectors"),
        Opcode::Dcs => include_str!("../vectors/dcs.vectors"),
        Opcode::Dcsrt => include_str!("../vectors/dcsrt.vectors"),
        Opcode::Dcst => include_str!("../vectors/dcst.vectors"),
        Opcode::Dcstl => include_str!("../vectors/dcstl.vectors"),
        Opcode::Dcstm => include_str!("../vectors/dcstm.vectors"),
        Opcode::Din => include_str!("../vectors/din.vectors"),
        Opcode::Enpend => include_str!("../vectors/enpend.vectors"),
        Opcode::Epms => include_str!("../vectors/epms.vectors"),
        Opcode::Estop => include_str!("../vectors/estop.vectors"),
        Opcode::Fpms => include_str!("../vectors/fpms.vectors"),
        Opcode::Fsbm => include_str!("../vectors/fsbm.vectors"),
        Opcode::Lc => include_str!("../vectors/lc.vectors"),
        Opcode::Mmvc => include_str!("../vectors/mmvc.vectors"),
        Opcode::Mvc => include_str!("../vectors/mvc.vectors"),
        Opcode::Rin => include_str!("../vectors/rin.vectors"),
        Opcode::Rout => include_str!("../vectors/rout.vectors"),
        Opcode::Smat => include_str!("../vectors/smat.vectors"),
        Opcode::Thrs => include_str!("../vectors/thrs.vectors"),
        Opcode::Thrse => include_str!("../vectors/thrse.vectors"),
        Opcode::Tsam => include_str!("../vectors/tsam.vectors"),
        Opcode::Tssm => include_str!("../vectors/tssm.vectors"),
        _ => return None,
    })
}
