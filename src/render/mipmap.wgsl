// A level of a texture from the one above it, as GL drivers shrink: through the linear filter, which for even sizes
// gives the mean of four, or of eight in a volume, rounded as the device rounds.
@group(0) @binding(0) var above: texture_2d<f32>;
@group(0) @binding(1) var volume_above: texture_3d<f32>;
@group(0) @binding(2) var linear: sampler;

@fragment
fn shrink(@builtin(position) position: vec4f) -> @location(0) vec4f {
    let size = max(textureDimensions(above) / 2, vec2u(1));
    return textureSampleLevel(above, linear, position.xy / vec2f(size), 0.0);
}

// The viewport's depth is the middle of the layer that is drawn.
@fragment
fn shrink_volume(@builtin(position) position: vec4f) -> @location(0) vec4f {
    let size = max(textureDimensions(volume_above).xy / 2, vec2u(1));
    return textureSampleLevel(volume_above, linear, vec3f(position.xy / vec2f(size), position.z), 0.0);
}
