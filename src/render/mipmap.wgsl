// A level of a texture from the one above it, as GL shrinks: linear between the texels around each centre, which
// for even sizes is the mean of four.
@group(0) @binding(0) var above: texture_2d<f32>;

@fragment
fn shrink(@builtin(position) position: vec4f) -> @location(0) vec4f {
    let size = vec2f(textureDimensions(above));
    let smaller = max(floor(size * 0.5), vec2f(1.0));
    let at = position.xy * size / smaller - 0.5;
    let low = floor(at);
    let part = at - low;
    let last = vec2i(size) - 1;
    let a = clamp(vec2i(low), vec2i(0), last);
    let b = clamp(vec2i(low) + 1, vec2i(0), last);
    let below = mix(textureLoad(above, a, 0), textureLoad(above, vec2i(b.x, a.y), 0), part.x);
    let over = mix(textureLoad(above, vec2i(a.x, b.y), 0), textureLoad(above, b, 0), part.x);
    return mix(below, over, part.y);
}
