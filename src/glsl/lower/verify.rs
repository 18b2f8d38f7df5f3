//! Holds lowered IR against what naga's writers need beyond what naga's validator asks: an operand
//! that was never emitted, or only where control may not have come by, passes the validator and
//! panics the writers, or comes out as code that drivers misread.

use std::fmt;

use naga::{Block, Expression, Function, Handle, ImageQuery, SampleLevel, Statement};

type H = Handle<Expression>;

/// What is wrong, and where.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Fault {
    function: String,
    what: String,
}

impl fmt::Display for Fault {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "in {}: {}", self.function, self.what)
    }
}

/// Checks every function of a module.
pub fn verify(module: &naga::Module) -> Result<(), Fault> {
    let entries = module.entry_points.iter().map(|entry| &entry.function);
    let functions = module.functions.iter().map(|(_, function)| function);
    for function in functions.chain(entries) {
        verify_function(module, function).map_err(|what| Fault {
            function: function.name.clone().unwrap_or_default(),
            what,
        })?;
    }
    Ok(())
}

fn verify_function(module: &naga::Module, function: &Function) -> Result<(), String> {
    for (_, variable) in function.local_variables.iter() {
        if variable.init.is_some() {
            return Err("a variable has an initial value instead of a store".to_owned());
        }
    }
    let mut scope = Scope {
        module,
        function,
        known: vec![false; function.expressions.len()],
    };
    for (handle, expression) in function.expressions.iter() {
        scope.known[handle.index()] = expression.needs_pre_emit();
    }
    scope.block(&function.body)?;
    if !ends(&function.body) {
        return Err("control gets to the end without a return".to_owned());
    }
    Ok(())
}

struct Scope<'a> {
    module: &'a naga::Module,
    function: &'a Function,
    known: Vec<bool>,
}

impl Scope<'_> {
    /// Checks a block; what it introduces is not known behind it.
    fn block(&mut self, block: &Block) -> Result<(), String> {
        let mut introduced = Vec::new();
        for statement in block {
            self.statement(statement, &mut introduced)?;
        }
        self.forget(introduced);
        Ok(())
    }

    fn forget(&mut self, introduced: Vec<H>) {
        for handle in introduced {
            self.known[handle.index()] = false;
        }
    }

    fn introduce(&mut self, handle: H, introduced: &mut Vec<H>) -> Result<(), String> {
        if std::mem::replace(&mut self.known[handle.index()], true) {
            return Err(format!("{handle:?} is introduced twice"));
        }
        introduced.push(handle);
        Ok(())
    }

    fn need(&self, handle: H) -> Result<(), String> {
        if self.known[handle.index()] {
            return Ok(());
        }
        let expression = &self.function.expressions[handle];
        Err(format!(
            "{handle:?} is used where it is not known: {expression:?}"
        ))
    }

    fn statement(&mut self, statement: &Statement, introduced: &mut Vec<H>) -> Result<(), String> {
        match statement {
            Statement::Emit(range) => {
                for handle in range.clone() {
                    self.expression(handle)?;
                    self.introduce(handle, introduced)?;
                }
                Ok(())
            }
            Statement::Block(block) => self.block(block),
            Statement::If {
                condition,
                accept,
                reject,
            } => {
                self.need(*condition)?;
                self.block(accept)?;
                self.block(reject)
            }
            Statement::Switch { selector, cases } => {
                self.need(*selector)?;
                for (i, case) in cases.iter().enumerate() {
                    if case.fall_through && (!case.body.is_empty() || i + 1 == cases.len()) {
                        return Err("statements of a switch fall through".to_owned());
                    }
                    self.block(&case.body)?;
                }
                Ok(())
            }
            Statement::Loop {
                body,
                continuing,
                break_if,
            } => {
                // A `continue` may skip what the body introduces.
                self.block(body)?;
                let mut own = Vec::new();
                for statement in continuing {
                    self.statement(statement, &mut own)?;
                }
                if let Some(condition) = break_if {
                    self.need(*condition)?;
                }
                self.forget(own);
                Ok(())
            }
            Statement::Break | Statement::Continue | Statement::Kill => Ok(()),
            Statement::Return { value } => value.map_or(Ok(()), |value| self.need(value)),
            Statement::Atomic { pointer, value, .. } => {
                self.need(*pointer)?;
                self.need(*value)
            }
            Statement::Store { pointer, value } => {
                self.need(*pointer)?;
                self.need(*value)
            }
            Statement::Call {
                arguments, result, ..
            } => {
                for &argument in arguments {
                    self.need(argument)?;
                    self.argument(argument)?;
                }
                match result {
                    Some(result) => self.introduce(*result, introduced),
                    None => Ok(()),
                }
            }
            other => Err(format!("GLSL has nothing that becomes {other:?}")),
        }
    }

    /// Pointers that are passed must be to whole variables.
    fn argument(&self, argument: H) -> Result<(), String> {
        let expressions = &self.function.expressions;
        let mut root = argument;
        while let Expression::Access { base, .. } | Expression::AccessIndex { base, .. } =
            expressions[root]
        {
            root = base;
        }
        let is_part = root != argument;
        match expressions[root] {
            Expression::LocalVariable(_) if is_part => {
                Err(format!("{argument:?} points into a variable and is passed"))
            }
            _ => Ok(()),
        }
    }

    fn expression(&self, handle: H) -> Result<(), String> {
        let expression = &self.function.expressions[handle];
        if expression.needs_pre_emit() || matches!(expression, Expression::CallResult(_)) {
            return Err(format!("{handle:?} must not be emitted: {expression:?}"));
        }
        let mut result = Ok(());
        operands(expression, &mut |operand| {
            if result.is_ok() {
                result = self.need(operand);
                if operand >= handle {
                    result = Err(format!("{operand:?} comes behind its use"));
                }
            }
        });
        if let Expression::Compose { ty, components } = expression
            && matches!(self.module.types[*ty].inner, naga::TypeInner::Vector { .. })
            && components.len() > 1
            && components
                .iter()
                .any(|&component| self.is_zero_vector(component))
        {
            return Err(format!(
                "{handle:?} is made of a zero vector, which no writer takes apart"
            ));
        }
        if let Expression::ImageSample {
            offset: Some(offset),
            ..
        } = expression
            && !self.is_literal(*offset)
        {
            return Err(format!("the offset of {handle:?} is no literal"));
        }
        result
    }

    fn is_zero_vector(&self, handle: H) -> bool {
        match self.function.expressions[handle] {
            Expression::ZeroValue(ty) => {
                matches!(self.module.types[ty].inner, naga::TypeInner::Vector { .. })
            }
            _ => false,
        }
    }

    fn is_literal(&self, handle: H) -> bool {
        match &self.function.expressions[handle] {
            Expression::Literal(_) | Expression::ZeroValue(_) | Expression::Constant(_) => true,
            Expression::Compose { components, .. } => components
                .iter()
                .all(|&component| self.is_literal(component)),
            Expression::Splat { value, .. } => self.is_literal(*value),
            _ => false,
        }
    }
}

/// Whether control never gets behind a block.
fn ends(block: &Block) -> bool {
    block.iter().any(|statement| match statement {
        Statement::Return { .. } | Statement::Kill | Statement::Break | Statement::Continue => true,
        Statement::Block(block) => ends(block),
        Statement::If { accept, reject, .. } => ends(accept) && ends(reject),
        _ => false,
    })
}

/// Calls back with every operand of an expression.
fn operands(expression: &Expression, each: &mut dyn FnMut(H)) {
    match expression {
        Expression::Literal(_)
        | Expression::Constant(_)
        | Expression::ZeroValue(_)
        | Expression::FunctionArgument(_)
        | Expression::GlobalVariable(_)
        | Expression::LocalVariable(_)
        | Expression::CallResult(_) => {}
        Expression::Compose { components, .. } => components.iter().copied().for_each(each),
        Expression::Access { base, index } => {
            each(*base);
            each(*index);
        }
        Expression::AccessIndex { base: one, .. }
        | Expression::Splat { value: one, .. }
        | Expression::Swizzle { vector: one, .. }
        | Expression::Load { pointer: one }
        | Expression::Unary { expr: one, .. }
        | Expression::Derivative { expr: one, .. }
        | Expression::Relational { argument: one, .. }
        | Expression::As { expr: one, .. } => each(*one),
        Expression::Binary { left, right, .. } => {
            each(*left);
            each(*right);
        }
        Expression::Select {
            condition,
            accept,
            reject,
        } => {
            each(*condition);
            each(*accept);
            each(*reject);
        }
        Expression::Math {
            arg,
            arg1,
            arg2,
            arg3,
            ..
        } => {
            each(*arg);
            [arg1, arg2, arg3]
                .into_iter()
                .flatten()
                .copied()
                .for_each(each);
        }
        Expression::ImageSample {
            image,
            sampler,
            coordinate,
            array_index,
            offset,
            level,
            depth_ref,
            ..
        } => {
            [image, sampler, coordinate]
                .into_iter()
                .copied()
                .for_each(&mut *each);
            let optional = [array_index, offset, depth_ref];
            optional.into_iter().flatten().copied().for_each(&mut *each);
            match level {
                SampleLevel::Auto | SampleLevel::Zero => {}
                SampleLevel::Exact(level) | SampleLevel::Bias(level) => each(*level),
                SampleLevel::Gradient { x, y } => {
                    each(*x);
                    each(*y);
                }
            }
        }
        Expression::ImageLoad {
            image,
            coordinate,
            array_index,
            sample,
            level,
        } => {
            each(*image);
            each(*coordinate);
            let optional = [array_index, sample, level];
            optional.into_iter().flatten().copied().for_each(each);
        }
        Expression::ImageQuery { image, query } => {
            each(*image);
            if let ImageQuery::Size { level: Some(level) } = query {
                each(*level);
            }
        }
        other => unreachable!("GLSL has nothing that becomes {other:?}"),
    }
}
