//! What drivers compute with 32 bits only, for programs of 64.

use super::function::{Builder, H};
use crate::glsl::Precision;
use crate::glsl::builtins::Builtin;
use crate::glsl::types::Type;

impl Builder<'_, '_> {
    /// Angles, exponentials and the like, of operands that are of the result's type.
    pub(super) fn transcendental(&mut self, builtin: Builtin, values: &[H], ty: Type) -> H {
        let size = ty.vector_size().expect("these are for scalars and vectors");
        if self.context.options.precision == Precision::Double {
            let functions = self.context.options.double_functions;
            if let Some(function) = functions.get(builtin, values.len()) {
                return self.call_by_component(function, values, ty);
            }
            let narrow: Vec<_> = values.iter().map(|&value| self.narrow(value)).collect();
            let result = self.in_single(builtin, &narrow, size);
            return self.widen(result);
        }
        self.in_single(builtin, values, size)
    }

    fn in_single(&mut self, builtin: Builtin, values: &[H], size: u8) -> H {
        if builtin == Builtin::Tanh {
            let value = self.tanh_operand(values[0], size);
            return self.transcendental_in_single(builtin, &[value]);
        }
        self.transcendental_in_single(builtin, values)
    }
}
