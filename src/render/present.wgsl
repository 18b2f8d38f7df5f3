// Shows the picture in the window. Its row 0 is its bottom row; the window's is its top row.

@group(0) @binding(0) var picture: texture_2d<f32>;
@group(0) @binding(1) var between: sampler;
@group(0) @binding(2) var<uniform> window_size: vec4f;

fn color(position: vec4f) -> vec3f {
    let at = position.xy / window_size.xy;
    return textureSampleLevel(picture, between, vec2f(at.x, 1.0 - at.y), 0.0).rgb;
}

@fragment
fn plain(@builtin(position) position: vec4f) -> @location(0) vec4f {
    return vec4f(color(position), 1.0);
}

// For windows that encode as sRGB whatever they are given: decoded here, the bytes come out as they
// went in (IEC 61966-2-1).
@fragment
fn decoded(@builtin(position) position: vec4f) -> @location(0) vec4f {
    let c = color(position);
    let low = c / 12.92;
    let high = pow((c + 0.055) / 1.055, vec3f(2.4));
    return vec4f(select(high, low, c <= vec3f(0.04045)), 1.0);
}
