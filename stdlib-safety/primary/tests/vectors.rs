//! Every vector of every safety application instruction, run on the primary half.

use twinrung_catalog::Opcode;
use twinrung_safety_primary::State;
use twinrung_safety_vectors::{Half, Vector, for_instruction, run};

/// The primary half as the vectors see it.
struct Primary(State);

impl Half for Primary {
    fn prescan(&mut self, operands: &[i32], members: &mut [i32]) {
        self.0.prescan(operands, members);
    }

    fn scan(&mut self, rung: bool, now_ms: i64, operands: &[i32], members: &mut [i32]) {
        self.0.scan(rung, now_ms, operands, members);
    }
}

fn mismatch(vector: &Vector, period_ms: u32) -> Option<String> {
    let mut half = Primary(State::new(vector.opcode).unwrap());
    run(vector, period_ms, &mut half).err().map(|mismatch| mismatch.to_string())
}

/// The first difference of each vector, at each of its periods.
fn mismatches(opcode: Opcode) -> Vec<String> {
    let vectors = for_instruction(opcode).unwrap();
    assert!(!vectors.is_empty(), "no vectors");
    vectors
        .iter()
        .flat_map(|vector| vector.periods_ms.iter().filter_map(|period_ms| mismatch(vector, *period_ms)))
        .collect()
}

macro_rules! vector_tests {
    ($($name:ident => $opcode:ident;)*) => {
        $(
            #[test]
            fn $name() {
                assert_eq!(mismatches(Opcode::$opcode), Vec::<String>::new());
            }
        )*
    };
}

vector_tests! {
    dcs_when_its_vectors_run_then_every_member_agrees => Dcs;
    dcst_when_its_vectors_run_then_every_member_agrees => Dcst;
    dcstl_when_its_vectors_run_then_every_member_agrees => Dcstl;
    dcstm_when_its_vectors_run_then_every_member_agrees => Dcstm;
    dcm_when_its_vectors_run_then_every_member_agrees => Dcm;
    dcsrt_when_its_vectors_run_then_every_member_agrees => Dcsrt;
    smat_when_its_vectors_run_then_every_member_agrees => Smat;
    thrse_when_its_vectors_run_then_every_member_agrees => Thrse;
    tsam_when_its_vectors_run_then_every_member_agrees => Tsam;
    tssm_when_its_vectors_run_then_every_member_agrees => Tssm;
    fsbm_when_its_vectors_run_then_every_member_agrees => Fsbm;
    crout_when_its_vectors_run_then_every_member_agrees => Crout;
    rout_when_its_vectors_run_then_every_member_agrees => Rout;
    dca_when_its_vectors_run_then_every_member_agrees => Dca;
    dcaf_when_its_vectors_run_then_every_member_agrees => Dcaf;
    din_when_its_vectors_run_then_every_member_agrees => Din;
    rin_when_its_vectors_run_then_every_member_agrees => Rin;
    enpend_when_its_vectors_run_then_every_member_agrees => Enpend;
    estop_when_its_vectors_run_then_every_member_agrees => Estop;
    lc_when_its_vectors_run_then_every_member_agrees => Lc;
    fpms_when_its_vectors_run_then_every_member_agrees => Fpms;
    thrs_when_its_vectors_run_then_every_member_agrees => Thrs;
    epms_when_its_vectors_run_then_every_member_agrees => Epms;
    cpm_when_its_vectors_run_then_every_member_agrees => Cpm;
    csm_when_its_vectors_run_then_every_member_agrees => Csm;
    avc_when_its_vectors_run_then_every_member_agrees => Avc;
    mvc_when_its_vectors_run_then_every_member_agrees => Mvc;
    mmvc_when_its_vectors_run_then_every_member_agrees => Mmvc;
    cbim_when_its_vectors_run_then_every_member_agrees => Cbim;
    cbssm_when_its_vectors_run_then_every_member_agrees => Cbssm;
    cbcm_when_its_vectors_run_then_every_member_agrees => Cbcm;
}
