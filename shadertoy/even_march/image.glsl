uniform vec2 resolution;
uniform float time;

// The seed's main cannot be compiled: a bracket with commas is one number, the dots stand for
// something, and its sky is nine times as blue as white.
#if 0
void main() {
    gl_FragColor = (0, 0, 0, 1);

    vec3 PWorld = ...;
    vec3 rd = normalize(PWorld);
    vec3 ro = vec3(0.);

    float t;
    if (castRay(ro, rd, t)) {
        vec3 p = ro + rd * t;
        gl_FragColor = vec4(computeShadingForPoint(p), 1.);
    } else {
        gl_FragColor = vec4(0.8, 0.85, 9.);
    }
}
#endif

// The same with what it lacks, and with the seed's fog and sun.
void main() {
    vec2 uv = (2.0 * gl_FragCoord.xy - resolution) / resolution.y;
    eye = vec3(3.0 + 0.12 * time, 2.1, 0.35 * time) / MODEL_SCALE;
    vec3 ro = eye;
    vec3 rd = normalize(vec3(uv.x - 0.1, uv.y - 0.22, 1.4));
    float t;
    bool isHit = castRay(ro, rd, t);
    vec3 p = ro + rd * t;
    if (!isHit || length(p.xz - eye.xz) > 0.98 * MODEL_RANGE) t = -1.0;
    if (t > 0.0) {
        vec3 hazy = vec3(0.7, 0.75, 0.85);
        vec3 colour = computeShadingForPoint(p);
        // An unlit picture would be dark: what is linear up to here is shown as the eye has it.
        colour = pow(1.0 - exp(-1.8 * colour), vec3(1.0 / 2.2));
        gl_FragColor = vec4(mix(hazy, colour, fogFactor(t * MODEL_SCALE)), 1.0);
    } else {
        vec3 sunColor = vec3(0.8, 0.75, 0.6);
        vec3 skyColor = vec3(0.7, 0.75, 0.85);
        float ar = resolution.x / resolution.y;
        vec2 p = gl_FragCoord.xy / resolution;
        p.x *= ar;
        float gradient = length(p - vec2(1.2, 1.0));
        float mixing = smoothstep(0., 0.1, gradient);
        gl_FragColor = vec4(mix(sunColor, skyColor, mixing), 1.0);
    }
}
