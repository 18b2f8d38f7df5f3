//! What the host binds, by name, and what it has to bind for a lowered program.

/// What the host binds. Every other uniform is zero, every other sampler reads (0, 0, 0, 1).
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Interface {
    /// The bind group of everything.
    pub group: u32,
    /// The binding of the uniform block.
    pub block: u32,
    /// The names of the uniforms in the block, in its order.
    pub uniforms: Vec<String>,
    /// The most bytes that the block may have. As many of the program's own uniforms as there is room
    /// for are in it too, behind the host's, who leaves them zero: compilers shall not know it, for
    /// they take a division by a zero that they know for anything.
    pub block_size: u32,
    /// The samplers.
    pub samplers: Vec<HostSampler>,
    /// The binding of the buffer of constant tables.
    pub tables: u32,
    /// The binding of the buffer that findings go to.
    pub findings: u32,
}

/// A sampler uniform that the host gives a texture.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct HostSampler {
    /// The uniform's name.
    pub name: String,
    /// The binding of its texture.
    pub texture: u32,
    /// The binding of the sampler that it is read through.
    pub sampler: u32,
}

/// The uniform block: laid out like std140, so that arrays have strides of 16 bytes.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct UniformBlock {
    /// Its size in bytes, a multiple of 16.
    pub size: u32,
    /// Those of [`Interface::uniforms`] that the program names, in the same order.
    pub members: Vec<UniformMember>,
}

/// A member of the uniform block.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct UniformMember {
    /// Its name.
    pub name: String,
    /// Where it begins, in bytes.
    pub offset: u32,
}

/// The values of large constant arrays. Drivers take seconds to minutes to compile them in.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Tables {
    /// The content of the buffer, a multiple of 16 bytes.
    pub words: Vec<u32>,
    /// Whether they are too many for a uniform buffer, so that it is a read-only storage buffer.
    pub in_storage: bool,
}
