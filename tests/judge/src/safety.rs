//! Safety application instructions, executed from the ladder half of the library: REQ-EXEC-060 to REQ-EXEC-062.

use twinrung_bytecode::image::Usage;
use twinrung_catalog::{Element, Instruction as Declaration, MemberRole, OperandKind};
use twinrung_compiler::operand::{Operand, Root};
use twinrung_compiler::project::{AddOn, Call, Instruction, OperandUse};

use crate::evaluator::{Exit, Judge};
use crate::memory::{Base, Frame, Instance, Target};
use crate::value::Value;

impl<'p> Judge<'p> {
    pub(crate) fn safety_application(
        &mut self,
        frame: &Frame<'p>,
        declaration: &Declaration,
        operands: &[OperandUse],
        condition: bool,
    ) -> Result<bool, Exit> {
        let safety = declaration.safety.unwrap_or_else(|| panic!("no safety application"));
        let backing = self.target(frame, operands[0])?;
        let member = |name: &str| backing.part(safety.backing.member(name).map_or(0, |(index, _)| index as u32));
        let mut values = Vec::with_capacity(operands.len());
        for (operand, declared) in operands.iter().zip(declaration.operands).skip(1) {
            values.push(self.safety_operand(frame, *operand, declared.kind)?);
        }
        for (name, value) in safety.mirrored.iter().zip(&values) {
            let Some((_, declared)) = safety.backing.member(name) else { continue };
            if !frame.prescanning || declared.role == MemberRole::Configuration {
                self.put(&member(name), *value);
            }
        }
        let runs = condition && !frame.prescanning;
        for name in ["EnableIn", "EnableOut"] {
            self.memory.set_bit(&member(name), runs);
        }
        self.run_library(frame, declaration, &backing, &values, condition)?;
        Ok(runs)
    }

    fn safety_operand(&mut self, frame: &Frame<'p>, operand: OperandUse, kind: OperandKind) -> Result<i32, Exit> {
        match self.operand(frame, operand) {
            Operand::Choice(value) | Operand::Integer { value, .. } => Ok(*value),
            Operand::Real(bits) => Ok(*bits as i32),
            _ if matches!(kind, OperandKind::SafetyBit { .. }) => self.bit(frame, operand).map(i32::from),
            _ => {
                let target = self.target(frame, operand)?;
                Ok(match self.memory.get(&target) {
                    Value::Bit(value) => i32::from(*value),
                    Value::Structure(_) => 0,
                    _ => self.memory.integer(&target),
                })
            }
        }
    }

    fn put(&mut self, target: &Target, value: i32) {
        match self.memory.get_mut(target) {
            Value::Bit(to) => *to = value != 0,
            Value::Integer(Element::Dint, to) => *to = value,
            // A NaN takes its one form, as wherever a number is stored (REQ-EXEC-003).
            Value::Real(to) => *to = crate::arithmetic::canonical(value as u32),
            other => panic!("not a member of a backing tag: {other:?}"),
        }
    }

    /// Runs the ladder of the instruction on its private instance, between the members of the backing tag.
    fn run_library(
        &mut self,
        frame: &Frame<'p>,
        declaration: &Declaration,
        backing: &Target,
        values: &[i32],
        condition: bool,
    ) -> Result<(), Exit> {
        let safety = declaration.safety.unwrap_or_else(|| panic!("no safety application"));
        let name = format!("Safety_{}", declaration.mnemonic);
        let library = self.library;
        let definition: &AddOn = library
            .add_ons
            .iter()
            .find(|known| known.name.eq_ignore_ascii_case(&name))
            .unwrap_or_else(|| panic!("the ladder library has no {name}"));
        let instance_type = definition.instance_type.unwrap_or_else(|| panic!("{name} has no type"));
        let zero =
            || Value::zero(&library.types, twinrung_bytecode::image::TypeReference::Structure(instance_type), [0; 3]);
        let made = self.memory.library.len();
        let instance = self.library_instance(backing, zero);
        if self.memory.library.len() > made {
            self.initialise(definition, &instance);
        }
        for (index, name) in safety.mirrored.iter().enumerate() {
            let parameter = if name.is_empty() { declaration.operands[index + 1].name } else { name };
            let inner = self.parameter(definition, &instance, parameter);
            let mirrored = safety.backing.member(name).map(|(at, _)| backing.part(at as u32));
            let value = match mirrored {
                Some(member) => self.memory.integer(&member),
                None => values[index],
            };
            self.put(&inner, value);
        }
        for (name, value) in [("EnableIn", condition), ("EnableOut", condition)] {
            let inner = self.parameter(definition, &instance, name);
            self.memory.set_bit(&inner, value && !frame.prescanning);
        }
        let inner = Frame {
            project: library,
            instance: Some(Instance { target: instance.clone(), in_out: Default::default() }),
            in_add_on: true,
            counts: false,
            ..frame.clone()
        };
        let flags = self.flags;
        // One that no prescan has reached begins as if one just had.
        if self.library_prescanned.insert(instance.clone()) || frame.prescanning {
            self.prescan_library(definition, &inner)?;
        }
        if !frame.prescanning
            && let Some(routine) = if condition { definition.logic } else { definition.enable_in_false }
        {
            self.routine(&inner, routine)?;
        }
        self.flags = flags;
        for parameter in definition.parameters.iter().filter(|parameter| parameter.usage == Usage::Output) {
            let Some((at, declared)) = safety.backing.member(&parameter.name) else { continue };
            if declared.role == MemberRole::Output {
                let inner = self.parameter(definition, &instance, &parameter.name);
                let value = self.memory.integer(&inner);
                self.put(&backing.part(at as u32), value);
            }
        }
        Ok(())
    }

    /// Prescans the ladder of an instruction; its timers have timed nothing.
    fn prescan_library(&mut self, definition: &AddOn, inner: &Frame<'p>) -> Result<(), Exit> {
        let instance = inner.instance.as_ref().map(|instance| &instance.target.base);
        self.memory.last_time.retain(|timer, _| Some(&timer.base) != instance);
        if let Some(routine) = definition.logic {
            self.routine(&Frame { prescanning: true, ..inner.clone() }, routine)?;
        }
        if let Some(routine) = definition.prescan {
            self.routine(&Frame { prescanning: false, ..inner.clone() }, routine)?;
        }
        Ok(())
    }

    /// Presets and accumulators that the ladder writes as literals are the initial values of their structures, in nested
    /// instances too.
    fn initialise(&mut self, definition: &AddOn, instance: &Target) {
        let library = self.library;
        let routines = [definition.logic, definition.prescan, definition.enable_in_false];
        for rung in routines.into_iter().flatten().flat_map(|routine| &library.routine(routine).rungs) {
            rung.visit(&mut |instruction| self.initialise_from(instruction, instance));
        }
    }

    fn initialise_from(&mut self, instruction: &Instruction, instance: &Target) {
        let library = self.library;
        let Some(Operand::Reference(structure)) = instruction.operands.first().map(|first| library.operand(first.id))
        else {
            return;
        };
        let Root::Member(_, member) = structure.root else { return };
        let target = instance.part(u32::from(member));
        match instruction.call {
            Call::AddOn(id) => self.initialise(&library.add_ons[usize::from(id.0)], &target),
            Call::Catalog(declaration) => {
                let Some(OperandKind::Structure(layout, _)) = declaration.operand(0).map(|first| first.kind) else {
                    return;
                };
                for (operand, declared) in instruction.operands.iter().zip(declaration.operands) {
                    if let (OperandKind::Pseudo(name), Operand::Integer { value, .. }) =
                        (declared.kind, library.operand(operand.id))
                    {
                        self.memory.set_integer(&target.part(crate::memory::member(layout, name)), *value);
                    }
                }
            }
        }
    }

    fn parameter(&self, definition: &AddOn, instance: &Target, name: &str) -> Target {
        let plain =
            |text: &str| text.chars().filter(char::is_ascii_alphanumeric).collect::<String>().to_ascii_lowercase();
        let parameter = definition
            .parameters
            .iter()
            .find(|known| plain(&known.name) == plain(name))
            .unwrap_or_else(|| panic!("{} has no parameter {name}", definition.name));
        debug_assert!(matches!(instance.base, Base::Library(_)));
        instance.part(u32::from(parameter.member.unwrap_or_else(|| panic!("{name} is InOut"))))
    }
}
