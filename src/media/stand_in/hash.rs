//! Numbers that look random and are the same on every machine.

/// Mixes the bits of a number (Chris Wellons' "lowbias32").
pub fn mixed(mut bits: u32) -> u32 {
    bits ^= bits >> 16;
    bits = bits.wrapping_mul(0x7feb_352d);
    bits ^= bits >> 15;
    bits = bits.wrapping_mul(0x846c_a68b);
    bits ^ (bits >> 16)
}

/// A number of its own for each place on a lattice and each seed.
pub fn lattice(place: [i32; 3], seed: u32) -> u32 {
    let [x, y, z] = place.map(|at| at as u32);
    let sum = x
        .wrapping_mul(0x9e37_79b1)
        .wrapping_add(y.wrapping_mul(0x85eb_ca77))
        .wrapping_add(z.wrapping_mul(0xc2b2_ae3d))
        .wrapping_add(seed.wrapping_mul(0x27d4_eb2f));
    mixed(sum)
}

/// From 0 to just below 1: the upper 24 bits, which a float holds exactly.
pub fn unit(bits: u32) -> f32 {
    (bits >> 8) as f32 / 16_777_216.0
}

/// A row of random numbers.
pub struct Random {
    seed: u32,
    drawn: u32,
}

impl Random {
    /// The row that belongs to a seed.
    pub fn new(seed: u32) -> Self {
        Self {
            seed: mixed(seed ^ 0x51ed_270b),
            drawn: 0,
        }
    }

    /// The next 32 bits.
    pub fn bits(&mut self) -> u32 {
        self.drawn = self.drawn.wrapping_add(1);
        mixed(mixed(self.drawn).wrapping_add(self.seed))
    }

    /// The next number, from 0 to just below 1.
    pub fn unit(&mut self) -> f32 {
        unit(self.bits())
    }

    /// The next number between two others.
    pub fn between(&mut self, low: f32, high: f32) -> f32 {
        low + (high - low) * self.unit()
    }
}
