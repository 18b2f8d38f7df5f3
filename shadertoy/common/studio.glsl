// Not in the seed: where the eye is and what it sees, unless a scene says otherwise.
uniform float uTime;
uniform vec2 uResolution;
#define EYE vec3(0.0, 0.0, 5.0)
#define AIM vec3(0.0)
#define LIGHT 1
#define PAINT vec3(0.85, 0.36, 0.24)
