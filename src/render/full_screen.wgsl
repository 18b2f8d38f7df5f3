// One triangle that covers the whole target.
@vertex
fn full_screen(@builtin(vertex_index) index: u32) -> @builtin(position) vec4f {
    let corner = vec2f(f32(index / 2u), f32(index % 2u));
    return vec4f(corner * 4.0 - 1.0, 0.0, 1.0);
}
