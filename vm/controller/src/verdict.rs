//! The permission to publish. It is no flag: it is a number of 64 bits that only a scan gives whose steps were all taken, in
//! their order, and found nothing wrong. Each half of the controller computes its own, in its own arithmetic, from a
//! challenge that is another in every scan; a flag that flips, a step left out and the verdict of an earlier scan all give
//! another number.

/// What must have happened before outputs are published, in this order.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Step {
    /// The time is plausible.
    Time,
    /// Inputs were copied into the channel.
    Freeze,
    /// The channel has executed something.
    Execution,
    /// The comparison went over everything and found no difference.
    Comparison,
    /// The comparison finds a difference where there is one.
    SelfTest,
    /// The next piece of the image was hashed.
    Image,
    /// The watchdog has not expired.
    Watchdog,
}

impl Step {
    const ALL: [Step; 7] =
        [Step::Time, Step::Freeze, Step::Execution, Step::Comparison, Step::SelfTest, Step::Image, Step::Watchdog];
}

/// A chain of steps.
pub(crate) trait Verdict: Copy {
    /// Nothing has happened in the scan with this challenge.
    fn begin(challenge: u64) -> Self;

    /// A step was taken; `remainder` is what it found wrong, 0 where that is nothing.
    #[must_use]
    fn after(self, step: Step, remainder: u64) -> Self;

    /// All bits where every step was taken and found nothing wrong, none otherwise: what outputs are masked with.
    fn gate(self, challenge: u64) -> u32;

    /// For fault injection.
    #[cfg(feature = "injection")]
    fn number(&mut self) -> &mut u64;
}

/// All bits for 0, none for any other number, without a decision in between.
const fn all_where_zero(number: u64) -> u32 {
    let folded = number | number.wrapping_neg();
    ((folded >> 63) as u32).wrapping_sub(1)
}

/// The first half's: multiplication. What it must come to is computed by taking the steps again.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Multiplied(u64);

impl Multiplied {
    /// Odd, so that each step maps different numbers to different numbers (the golden ratio's fraction, as in Fibonacci hashing).
    const FACTOR: u64 = 0x9E37_79B9_7F4A_7C15;
    const STEPS: [u64; 7] = [
        0x243F_6A88_85A3_08D3,
        0x1319_8A2E_0370_7344,
        0xA409_3822_299F_31D0,
        0x082E_FA98_EC4E_6C89,
        0x4528_21E6_38D0_1377,
        0xBE54_66CF_34E9_0C6C,
        0xC0AC_29B7_C97C_50DD,
    ];
}

impl Verdict for Multiplied {
    fn begin(challenge: u64) -> Multiplied {
        Multiplied(challenge)
    }

    fn after(self, step: Step, remainder: u64) -> Multiplied {
        let constant = Multiplied::STEPS.get(step as usize).copied().unwrap_or_default();
        let mixed = (self.0.rotate_left(23) ^ constant).wrapping_mul(Multiplied::FACTOR);
        Multiplied(mixed.wrapping_add(remainder.wrapping_mul(Multiplied::FACTOR)))
    }

    fn gate(self, challenge: u64) -> u32 {
        let expected = Step::ALL.into_iter().fold(Multiplied::begin(challenge), |chain, step| chain.after(step, 0));
        all_where_zero(self.0 ^ expected.0)
    }

    #[cfg(feature = "injection")]
    fn number(&mut self) -> &mut u64 {
        &mut self.0
    }
}

/// The second half's: rotation and exclusive or. What it must come to was computed when this was compiled.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Rotated(u64);

impl Rotated {
    const STEP_BITS: u32 = 7;
    const STEPS: [u64; 7] = [
        0x3F84_D5B5_B547_0917,
        0x9216_D5D9_8979_FB1B,
        0xD131_0BA6_98DF_B5AC,
        0x2FFD_72DB_D01A_DFB7,
        0xB8E1_AFED_6A26_7E96,
        0xBA7C_9045_F12C_7F99,
        0x24A1_9947_B391_6CF7,
    ];
    /// What the steps come to from the challenge 0; a challenge is turned and added.
    const TOTAL: u64 = {
        let [a, b, c, d, e, f, g] = Rotated::STEPS;
        a.rotate_left(6 * Rotated::STEP_BITS)
            ^ b.rotate_left(5 * Rotated::STEP_BITS)
            ^ c.rotate_left(4 * Rotated::STEP_BITS)
            ^ d.rotate_left(3 * Rotated::STEP_BITS)
            ^ e.rotate_left(2 * Rotated::STEP_BITS)
            ^ f.rotate_left(Rotated::STEP_BITS)
            ^ g
    };
}

impl Verdict for Rotated {
    fn begin(challenge: u64) -> Rotated {
        Rotated(challenge)
    }

    fn after(self, step: Step, remainder: u64) -> Rotated {
        let constant = match step {
            Step::Time => Rotated::STEPS[0],
            Step::Freeze => Rotated::STEPS[1],
            Step::Execution => Rotated::STEPS[2],
            Step::Comparison => Rotated::STEPS[3],
            Step::SelfTest => Rotated::STEPS[4],
            Step::Image => Rotated::STEPS[5],
            Step::Watchdog => Rotated::STEPS[6],
        };
        Rotated(self.0.rotate_left(Rotated::STEP_BITS) ^ constant ^ remainder)
    }

    fn gate(self, challenge: u64) -> u32 {
        all_where_zero(self.0 ^ challenge.rotate_left(7 * Rotated::STEP_BITS) ^ Rotated::TOTAL)
    }

    #[cfg(feature = "injection")]
    fn number(&mut self) -> &mut u64 {
        &mut self.0
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const CHALLENGE: u64 = 0x0123_4567_89AB_CDEF;

    fn all_taken<V: Verdict>(remainder_of: impl Fn(Step) -> u64) -> V {
        Step::ALL.into_iter().fold(V::begin(CHALLENGE), |chain, step| chain.after(step, remainder_of(step)))
    }

    fn without<V: Verdict>(left_out: usize) -> V {
        let taken = Step::ALL.into_iter().enumerate().filter(|(index, _)| *index != left_out);
        taken.fold(V::begin(CHALLENGE), |chain, (_, step)| chain.after(step, 0))
    }

    fn gates(first: Multiplied, second: Rotated) -> [u32; 2] {
        [first.gate(CHALLENGE), second.gate(CHALLENGE)]
    }

    /// REQ-SCAN-012
    #[test]
    fn verdict_when_every_step_found_nothing_then_both_gates_open() {
        assert_eq!(gates(all_taken(|_| 0), all_taken(|_| 0)), [u32::MAX; 2]);
    }

    /// REQ-SCAN-012
    #[test]
    fn verdict_when_one_bit_of_a_remainder_is_set_then_neither_gate_opens() {
        for (step, bit) in Step::ALL.into_iter().flat_map(|step| (0..64).map(move |bit| (step, bit))) {
            let remainder = |at| u64::from(at == step) << bit;
            assert_eq!(gates(all_taken(remainder), all_taken(remainder)), [0; 2], "{step:?} {bit}");
        }
    }

    /// REQ-SCAN-012
    #[test]
    fn verdict_when_a_step_is_left_out_then_neither_gate_opens() {
        for step in 0..7 {
            assert_eq!(gates(without(step), without(step)), [0; 2], "{step}");
        }
    }

    /// REQ-SCAN-012
    #[test]
    fn verdict_when_one_or_two_bits_of_it_flip_then_neither_gate_opens() {
        let (first, second): (Multiplied, Rotated) = (all_taken(|_| 0), all_taken(|_| 0));
        for (a, b) in (0..64).flat_map(|a| (a..64).map(move |b| (a, b))) {
            let mask = (1_u64 << a) | (1 << b);
            assert_eq!(gates(Multiplied(first.0 ^ mask), Rotated(second.0 ^ mask)), [0; 2]);
        }
    }

    /// REQ-SCAN-012
    #[test]
    fn verdict_when_it_is_of_the_scan_before_then_neither_gate_opens() {
        let (first, second): (Multiplied, Rotated) = (all_taken(|_| 0), all_taken(|_| 0));
        assert_eq!([first.gate(CHALLENGE + 1), second.gate(CHALLENGE + 1)], [0; 2]);
    }
}
