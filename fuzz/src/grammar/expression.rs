//! Expressions of a wanted type.

use arbitrary::Result;

use super::types::{BOOL, FLOAT, INT, Scalar, Type};
use super::{Variable, Writer, builtins};

impl Writer<'_, '_> {
    /// An expression of a type, or now and then of another.
    pub fn expression(&mut self, ty: &Type, depth: u32) -> Result<()> {
        if self.once_in(200)? {
            let other = self.any_type()?;
            return self.right_expression(&other, depth);
        }
        self.right_expression(ty, depth)
    }

    fn right_expression(&mut self, ty: &Type, depth: u32) -> Result<()> {
        if depth == 0 || self.u.is_empty() {
            return self.leaf(ty);
        }
        match self.below(16)? {
            0 | 1 => self.leaf(ty)?,
            2..=5 => self.operator(ty, depth - 1)?,
            6 | 7 => self.builtin(ty, depth - 1)?,
            8 => {
                self.put("(");
                self.expression(&BOOL, depth - 1)?;
                self.put(" ? ");
                self.expression(ty, depth - 1)?;
                self.put(" : ");
                self.expression(ty, depth - 1)?;
                self.put(")");
            }
            9 => self.construct(ty, depth - 1)?,
            10 => self.call(ty, depth - 1)?,
            11 if !self.constant => {
                self.put("(");
                self.assign(ty, depth - 1)?;
                self.put(")");
            }
            12 => self.part(ty, depth - 1)?,
            13 if !self.constant => {
                self.put("(");
                let first = self.any_type()?;
                self.expression(&first, depth - 1)?;
                self.put(", ");
                self.expression(ty, depth - 1)?;
                self.put(")");
            }
            14 => self.expand(ty, depth - 1)?,
            _ => {
                self.put("(");
                self.expression(ty, depth - 1)?;
                self.put(")");
            }
        }
        Ok(())
    }

    /// A variable or a constant.
    fn leaf(&mut self, ty: &Type) -> Result<()> {
        if self.below(3)? > 0
            && let Some(variable) = self.variable(ty, false)?
        {
            self.put(&variable);
            return Ok(());
        }
        match ty {
            Type::Vector(scalar, 1) => self.number(*scalar),
            Type::Vector(scalar, _) => {
                let text = format!("{}(", self.spell(ty));
                self.put(&text);
                self.number(*scalar)?;
                self.put(")");
                Ok(())
            }
            Type::Matrix(..) => {
                let text = format!("{}(", self.spell(ty));
                self.put(&text);
                self.number(Scalar::Float)?;
                self.put(")");
                Ok(())
            }
            _ => self.construct(ty, 0),
        }
    }

    fn number(&mut self, scalar: Scalar) -> Result<()> {
        let number = match scalar {
            Scalar::Float => self.pick(&[
                "1.0", "0.0", "2.5", "-1.5", "1e9", "3.4e38", "1e-40", ".5", "7.", "1e39",
            ])?,
            Scalar::Int => self.pick(&[
                "1",
                "0",
                "2",
                "-1",
                "31",
                "0x7fffffff",
                "(-2147483647 - 1)",
                "017",
                "5",
            ])?,
            Scalar::Uint => self.pick(&["1u", "0u", "3u", "0xffffffffu", "32u"])?,
            Scalar::Bool => self.pick(&["true", "false"])?,
        };
        self.put(number);
        Ok(())
    }

    /// A variable of a type, or a part of one.
    fn variable(&mut self, ty: &Type, written: bool) -> Result<Option<String>> {
        let mut found: Vec<String> = Vec::new();
        for Variable {
            name,
            ty: own,
            written: can,
            constant,
        } in &self.variables
        {
            if (written && !can) || (self.constant && !constant) {
                continue;
            }
            if own == ty {
                found.push(name.clone());
                continue;
            }
            match (own, ty) {
                (Type::Array(element, length), _) if **element == *ty => {
                    found.push(format!("{name}[{}]", length - 1));
                    if !self.constant {
                        found.push(format!("{name}[iFrame]"));
                    }
                }
                (Type::Vector(a, size), Type::Vector(b, wanted)) if a == b && size >= wanted => {
                    let parts = ["y", "yx", "xyz"];
                    found.push(format!("{name}.{}", parts[usize::from(*wanted) - 1]));
                }
                (Type::Matrix(columns, rows), Type::Vector(Scalar::Float, size))
                    if rows == size =>
                {
                    found.push(format!("{name}[{}]", columns - 1));
                }
                (Type::Struct(id), _) => {
                    let fields = &self.structures[*id].fields;
                    let fitting = fields.iter().filter(|(_, field)| field == ty);
                    found.extend(fitting.map(|(field, _)| format!("{name}.{field}")));
                }
                _ => {}
            }
        }
        match found.is_empty() {
            true => Ok(None),
            false => Ok(Some(self.pick(&found)?)),
        }
    }

    /// The type of a variable that can be written.
    pub fn any_written_type(&mut self) -> Result<Type> {
        let types = self.variables.iter().filter(|variable| variable.written);
        let types: Vec<_> = types.map(|variable| variable.ty.clone()).collect();
        match types.is_empty() {
            true => self.any_type(),
            false => self.pick(&types),
        }
    }

    /// An assignment to some variable of a type.
    pub fn assign(&mut self, ty: &Type, depth: u32) -> Result<()> {
        let Some(place) = self.variable(ty, true)? else {
            return self.expression(ty, depth);
        };
        let is_number = matches!(ty, Type::Vector(scalar, _) if *scalar != Scalar::Bool);
        match self.below(5)? {
            0 if is_number => {
                let text = self.pick(&["++", "--"])?;
                match self.below(2)? {
                    0 => self.put(&format!("{place}{text}")),
                    _ => self.put(&format!("{text}{place}")),
                }
            }
            1 | 2 if is_number => {
                let op = self.pick(&["+=", "*=", "-=", "/="])?;
                self.put(&format!("{place} {op} "));
                self.expression(ty, depth)?;
            }
            _ => {
                self.put(&format!("{place} = "));
                self.expression(ty, depth)?;
            }
        }
        Ok(())
    }

    fn operator(&mut self, ty: &Type, depth: u32) -> Result<()> {
        let vec = |size| Type::Vector(Scalar::Float, size);
        let (op, left, right) = match *ty {
            Type::Vector(Scalar::Bool, 1) => match self.below(6)? {
                0 | 1 => (self.pick(&["&&", "||", "^^"])?, BOOL, BOOL),
                2 | 3 => {
                    let of = self.pick(&[FLOAT, INT, Type::Vector(Scalar::Uint, 1)])?;
                    (self.pick(&["<", ">", "<=", ">="])?, of.clone(), of)
                }
                4 => {
                    let of = self.any_type()?;
                    (self.pick(&["==", "!="])?, of.clone(), of)
                }
                _ => {
                    self.put("!(");
                    self.expression(ty, depth)?;
                    self.put(")");
                    return Ok(());
                }
            },
            Type::Vector(Scalar::Float, size) => match self.below(8)? {
                0..=2 => (self.pick(&["+", "-", "*", "/"])?, ty.clone(), ty.clone()),
                3 => (self.pick(&["+", "-", "*", "/"])?, ty.clone(), FLOAT),
                4 => (self.pick(&["+", "-", "*", "/"])?, FLOAT, ty.clone()),
                5 if size > 1 => ("*", Type::Matrix(3, size), vec(3)),
                6 if size > 1 => ("*", vec(2), Type::Matrix(size, 2)),
                _ => return self.negated(ty, "-", depth),
            },
            Type::Vector(scalar @ (Scalar::Int | Scalar::Uint), _) => match self.below(5)? {
                0 | 1 => {
                    let op = self.pick(&["+", "-", "*", "/", "%", "&", "|", "^"])?;
                    (op, ty.clone(), ty.clone())
                }
                2 => (self.pick(&["<<", ">>"])?, ty.clone(), ty.clone()),
                3 => (
                    self.pick(&["<<", "/", "%"])?,
                    ty.clone(),
                    Type::Vector(scalar, 1),
                ),
                _ => {
                    let op = self.pick(&["-", "~"])?;
                    return self.negated(ty, op, depth);
                }
            },
            Type::Matrix(columns, rows) => match self.below(4)? {
                0 | 1 => (self.pick(&["+", "-", "/"])?, ty.clone(), ty.clone()),
                2 => ("*", Type::Matrix(2, rows), Type::Matrix(columns, 2)),
                _ => (self.pick(&["+", "-", "*", "/"])?, FLOAT, ty.clone()),
            },
            _ => return self.construct(ty, depth),
        };
        self.put("(");
        self.expression(&left, depth)?;
        self.put(&format!(" {op} "));
        self.expression(&right, depth)?;
        self.put(")");
        Ok(())
    }

    fn negated(&mut self, ty: &Type, op: &str, depth: u32) -> Result<()> {
        self.put(&format!("{op}("));
        self.expression(ty, depth)?;
        self.put(")");
        Ok(())
    }

    fn list(&mut self, name: &str, types: &[Type], depth: u32) -> Result<()> {
        self.put(&format!("{name}("));
        for (i, ty) in types.iter().enumerate() {
            if i > 0 {
                self.put(", ");
            }
            self.expression(ty, depth)?;
        }
        self.put(")");
        Ok(())
    }

    fn builtin(&mut self, ty: &Type, depth: u32) -> Result<()> {
        if !self.constant && *ty == Type::Vector(Scalar::Float, 4) && self.below(4)? == 0 {
            let channel = self.pick(&["texture(iChannel0, ", "textureLod(iChannel1, "])?;
            self.put(channel);
            self.expression(&Type::Vector(Scalar::Float, 2), depth)?;
            self.put(if channel.contains("Lod") {
                ", 0.0)"
            } else {
                ")"
            });
            return Ok(());
        }
        let found = builtins::of(ty);
        if found.is_empty() {
            return self.construct(ty, depth);
        }
        let (name, operands) = self.pick(&found)?;
        self.list(name, &operands, depth)
    }

    fn construct(&mut self, ty: &Type, depth: u32) -> Result<()> {
        let name = self.spell(ty);
        match ty {
            Type::Vector(_, size) => {
                let scalar = self.scalar()?;
                let split = self.below(usize::from(*size))? as u8;
                match split {
                    0 => self.list(&name, &[Type::Vector(scalar, 1)], depth),
                    _ => {
                        let parts = [split, size - split].map(|size| Type::Vector(scalar, size));
                        self.list(&name, &parts, depth)
                    }
                }
            }
            Type::Matrix(columns, rows) => match self.below(3)? {
                0 => self.list(&name, &[FLOAT], depth),
                1 => self.list(&name, &[Type::Matrix(3, 2)], depth),
                _ => {
                    let column = Type::Vector(Scalar::Float, *rows);
                    self.list(&name, &vec![column; usize::from(*columns)], depth)
                }
            },
            Type::Struct(id) => {
                let fields = self.structures[*id].fields.clone();
                let types: Vec<_> = fields.into_iter().map(|(_, ty)| ty).collect();
                self.list(&name, &types, depth)
            }
            Type::Array(element, length) => self.list(
                &name,
                &vec![(**element).clone(); *length as usize],
                depth.min(1),
            ),
        }
    }

    fn call(&mut self, ty: &Type, depth: u32) -> Result<()> {
        let fitting = self.functions.iter();
        let fitting: Vec<_> = fitting
            .filter(|function| function.result.as_ref() == Some(ty))
            .cloned()
            .collect();
        if self.constant || fitting.is_empty() {
            return self.operator(ty, depth);
        }
        let function = self.pick(&fitting)?;
        self.put(&format!("{}(", function.name));
        for (i, (ty, written)) in function.parameters.iter().enumerate() {
            if i > 0 {
                self.put(", ");
            }
            match written {
                true => match self.variable(ty, true)? {
                    Some(place) => self.put(&place),
                    None => self.leaf(ty)?,
                },
                false => self.expression(ty, depth)?,
            }
        }
        self.put(")");
        Ok(())
    }

    /// A part of something larger.
    fn part(&mut self, ty: &Type, depth: u32) -> Result<()> {
        let Type::Vector(scalar, size) = *ty else {
            let array = Type::Array(Box::new(ty.clone()), 3);
            if ty.is_array() {
                return self.construct(ty, depth);
            }
            self.expression(&array, depth.min(1))?;
            self.put("[");
            self.expression(&INT, depth)?;
            self.put("]");
            return Ok(());
        };
        let of = Type::Vector(scalar, 2 + self.below(3)? as u8);
        self.put("(");
        self.expression(&of, depth)?;
        self.put(").");
        for _ in 0..size {
            let component = self.pick(&["x", "y"])?;
            self.put(component);
        }
        Ok(())
    }

    /// A call of a macro.
    fn expand(&mut self, ty: &Type, depth: u32) -> Result<()> {
        if *ty != FLOAT || self.macros.is_empty() {
            return self.operator(ty, depth);
        }
        let macros = self.macros.clone();
        let (name, has_parameter) = self.pick(&macros)?;
        match has_parameter {
            true => self.list(&name, &[FLOAT], depth),
            false => {
                self.put(&name);
                Ok(())
            }
        }
    }
}
