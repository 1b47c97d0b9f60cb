//! The safety application instructions: one file each, the shared words in `choices`, the shared codes in `codes`.
//!
//! Operand 0 is the backing tag; `mirrored` gives the member of the backing tag for each operand after it.

pub mod avc;
pub mod cbcm;
pub mod cbim;
pub mod cbssm;
pub mod choices;
pub mod codes;
pub mod cpm;
pub mod crout;
pub mod csm;
pub mod dca;
pub mod dcaf;
pub mod dcm;
pub mod dcs;
pub mod dcsrt;
pub mod dcst;
pub mod dcstl;
pub mod dcstm;
pub mod din;
pub mod enpend;
pub mod epms;
pub mod estop;
pub mod fpms;
pub mod fsbm;
pub mod lc;
pub mod mmvc;
pub mod mvc;
pub mod rin;
pub mod rout;
pub mod smat;
pub mod thrs;
pub mod thrse;
pub mod tsam;
pub mod tssm;
