// We run this code in the case where the ray missed any scenery. The sun will
// be drawn at (1.2,1), where (0,0) is the bottom-left of the screen and (1,1)
// is the top-right.

vec3 sunColor = vec3(0.8, 0.75, 0.6);
vec3 skyColor = vec3(0.7, 0.75, 0.85);

float ar = resolution.x / resolution.y;
vec2 p = gl_FragCoord.xy / resolution;
p.x *= ar; // Without this, the sun would look squished

// Distance of p from sun
float gradient = length(p - vec2(1.2, 1.0));

// This makes it so if the distance is less than 0.1, then the pixel is
// yellow (sunColor), otherwise, it is blue (skyColor)
float mixing = smoothstep(0., 0.1, gradient);

gl_FragColor = vec4(mix(sunColor, skyColor, mixing), 1.0);
