//! WebGL2's limits of memory and complexity.

use super::Checker;
use crate::glsl::hir::GlobalKind;
use crate::glsl::syntax::ast::Extent;
use crate::glsl::types::Type;

/// A variable must have fewer bytes than this; components count four each.
const MAX_VARIABLE: u64 = 64 << 10;

/// All variables together.
const MAX_TOTAL: u64 = 16 << 20;

/// The largest array that is compiled at all, in components; far beyond what drivers take.
const MAX_COMPONENTS: u64 = 1 << 24;

/// The deepest tree.
const MAX_HEIGHT: u32 = 256;

impl Checker<'_> {
    /// Checks the size of a variable that the program owns.
    pub(super) fn check_size(&mut self, ty: Type, at: Extent) -> bool {
        let components = u64::from(self.hir.value_count(ty));
        let bytes = components.saturating_mul(4);
        if components > MAX_COMPONENTS {
            let message = format!("{} is too large", self.spell_one(ty));
            self.error("too-large", message, at);
            return false;
        }
        if bytes >= MAX_VARIABLE {
            let message = format!(
                "{} has {bytes} bytes, fewer than {MAX_VARIABLE} are allowed",
                self.spell_one(ty)
            );
            self.refused_by_webgl(
                "webgl-limit",
                message,
                at,
                "compute the values, or pack them",
            );
        }
        self.private_bytes = self.private_bytes.saturating_add(bytes);
        true
    }

    /// Checks the memory of all variables.
    pub(super) fn check_total_size(&mut self) {
        if self.private_bytes > MAX_TOTAL {
            let message = format!(
                "all variables have {} bytes, {MAX_TOTAL} are allowed",
                self.private_bytes
            );
            self.refused_by_webgl("webgl-limit", message, Extent::of(0), "use smaller arrays");
        }
    }

    /// Checks how high the tree of the function that ends here is.
    pub(super) fn check_complexity(&mut self, at: Extent) {
        if self.flow.highest > MAX_HEIGHT {
            let message = format!("the function nests more than {MAX_HEIGHT} deep");
            let hint = "split long expressions and `else if` ladders";
            self.refused_by_webgl("webgl-limit", message, at, hint);
        }
    }

    /// Reports outputs without a location beside another.
    pub(super) fn check_outputs(&mut self) {
        if self.outputs.len() < 2 {
            return;
        }
        for (id, location) in self.outputs.clone() {
            let global = &self.hir.globals[id];
            if location.is_none() && global.kind != GlobalKind::FragDepth {
                let at = Extent::of(global.at.unwrap_or(0));
                let name = self.text(global.name).to_owned();
                let message =
                    format!("of several outputs each needs a location, `{name}` has none");
                self.error("qualifier", message, at);
            }
        }
    }
}
