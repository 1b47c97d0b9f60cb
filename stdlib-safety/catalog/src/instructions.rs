//! The list of all admitted instructions, from which the opcodes are made.
//!
//! An opcode's number is part of the image format and never changes or moves to another instruction.

pub mod array;
pub mod bit;
pub mod compare;
pub mod logical;
pub mod math;
pub mod move_;
pub mod program_control;
pub mod safety;
pub mod system;
pub mod timer_counter;

use crate::instruction::Instruction;

macro_rules! instructions {
    ($($(#[$doc:meta])* $name:ident = $number:literal => $declaration:path;)*) => {
        /// The number that stands for an instruction in an image, and the name by which code matches on it.
        #[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
        #[repr(u8)]
        pub enum Opcode {
            $(
                #[doc = concat!("See [`", stringify!($declaration), "`].")]
                $name = $number,
            )*
        }

        impl Opcode {
            /// Every opcode, in ascending order of the number.
            pub const ALL: &[Opcode] = &[$(Opcode::$name,)*];

            /// The opcode with this number.
            pub const fn from_number(number: u8) -> Option<Opcode> {
                match number {
                    $($number => Some(Opcode::$name),)*
                    _ => None,
                }
            }
        }

        /// Every declaration, in ascending order of the opcode.
        pub static ALL: &[&Instruction] = &[$(&$declaration,)*];

        pub(crate) fn declaration(opcode: Opcode) -> &'static Instruction {
            match opcode {
                $(Opcode::$name => &$declaration,)*
            }
        }
    };
}

instructions! {
    Xic = 16 => bit::XIC;
    Xio = 17 => bit::XIO;
    Ote = 18 => bit::OTE;
    Otl = 19 => bit::OTL;
    Otu = 20 => bit::OTU;
    Ons = 21 => bit::ONS;
    Osr = 22 => bit::OSR;
    Osf = 23 => bit::OSF;
    Ton = 24 => timer_counter::TON;
    Tof = 25 => timer_counter::TOF;
    Rto = 26 => timer_counter::RTO;
    Ctu = 27 => timer_counter::CTU;
    Ctd = 28 => timer_counter::CTD;
    Res = 29 => timer_counter::RES;
    Equ = 32 => compare::EQU;
    Neq = 33 => compare::NEQ;
    Grt = 34 => compare::GRT;
    Geq = 35 => compare::GEQ;
    Les = 36 => compare::LES;
    Leq = 37 => compare::LEQ;
    Lim = 38 => compare::LIM;
    Meq = 39 => compare::MEQ;
    Cmp = 40 => compare::CMP;
    Mov = 48 => move_::MOV;
    Mvm = 49 => move_::MVM;
    Clr = 50 => move_::CLR;
    Cop = 51 => move_::COP;
    Swpb = 52 => move_::SWPB;
    And = 56 => logical::AND;
    Or = 57 => logical::OR;
    Xor = 58 => logical::XOR;
    Not = 59 => logical::NOT;
    Add = 64 => math::ADD;
    Sub = 65 => math::SUB;
    Mul = 66 => math::MUL;
    Div = 67 => math::DIV;
    Mod = 68 => math::MOD;
    Sqr = 69 => math::SQR;
    Neg = 70 => math::NEG;
    Abs = 71 => math::ABS;
    Cpt = 72 => math::CPT;
    Fal = 80 => array::FAL;
    Fsc = 81 => array::FSC;
    Fll = 82 => array::FLL;
    Size = 83 => array::SIZE;
    Jmp = 88 => program_control::JMP;
    Lbl = 89 => program_control::LBL;
    Jsr = 90 => program_control::JSR;
    Sbr = 91 => program_control::SBR;
    Ret = 92 => program_control::RET;
    Tnd = 93 => program_control::TND;
    Mcr = 94 => program_control::MCR;
    Afi = 95 => program_control::AFI;
    Nop = 96 => program_control::NOP;
    Event = 97 => program_control::EVENT;
    Gsv = 104 => system::GSV;
    Ssv = 105 => system::SSV;
    Dcs = 128 => safety::dcs::DCS;
    Crout = 129 => safety::crout::CROUT;
    Dca = 130 => safety::dca::DCA;
    Dcaf = 131 => safety::dcaf::DCAF;
    Dcst = 132 => safety::dcst::DCST;
    Dcstl = 133 => safety::dcstl::DCSTL;
    Dcstm = 134 => safety::dcstm::DCSTM;
    Dcm = 135 => safety::dcm::DCM;
    Dcsrt = 136 => safety::dcsrt::DCSRT;
    Smat = 137 => safety::smat::SMAT;
    Thrse = 138 => safety::thrse::THRSE;
    Tsam = 139 => safety::tsam::TSAM;
    Tssm = 140 => safety::tssm::TSSM;
    Fsbm = 141 => safety::fsbm::FSBM;
    Rout = 142 => safety::rout::ROUT;
    Cbcm = 144 => safety::cbcm::CBCM;
    Cbim = 145 => safety::cbim::CBIM;
    Cbssm = 146 => safety::cbssm::CBSSM;
    Cpm = 147 => safety::cpm::CPM;
    Csm = 148 => safety::csm::CSM;
    Epms = 149 => safety::epms::EPMS;
    Avc = 150 => safety::avc::AVC;
    Mvc = 151 => safety::mvc::MVC;
    Mmvc = 152 => safety::mmvc::MMVC;
    Din = 160 => safety::din::DIN;
    Rin = 161 => safety::rin::RIN;
    Enpend = 162 => safety::enpend::ENPEND;
    Estop = 163 => safety::estop::ESTOP;
    Lc = 164 => safety::lc::LC;
    Fpms = 165 => safety::fpms::FPMS;
    Thrs = 166 => safety::thrs::THRS;
}
