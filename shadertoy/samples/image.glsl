// Not in the seed: the template with several rays through each pixel, which is what `temporal` gathers over time.
#define SAMPLES 2 // Rays each way in a pixel; 1 is the template (1~8)

void mainImage(out vec4 fragColor, in vec2 fragCoord) {
    View now = viewAt(iTime);
    vec3 sum = vec3(0.0);
    for (int i = 0; i < SAMPLES * SAMPLES; i++) {
        vec2 at = (vec2(i % SAMPLES, i / SAMPLES) + 0.5) / float(SAMPLES) - 0.5;
        vec3 rd = rayThrough(now, fragCoord + at);
        sum += shade(now.ro, rd, raymarch(now.ro, rd));
    }
    fragColor = vec4(display(sum / float(SAMPLES * SAMPLES)), 1.0);
}
