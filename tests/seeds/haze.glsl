void main(){
vec2 uv = gl_FragCoord.xy/uResolution.xy;
uv -= 0.5;
uv.x *= uResolution.x / uResolution.y;

vec3 color = vec3(0.0);
vec3 ro = vec3(0.0, 18.0, 5.0);
vec3 rd = normalize(vec3(uv, 1.0));

float d = raymarch(ro,rd);
vec3 p = ro + rd * d;

vec3 lightDirection = normalize(lightPosition-p);

if (d<MAX_DIST){
vec3 normal = getNormal(p);

float amb = clamp(0.5 + 0.5 * normal.y, 0.0, 1.0);
float diffuse = clamp(dot(normal, lightDirection), 0.0, 1.0);
float shadow = softShadows(p, lightDirection, 0.1, 3.0, 64.0);

color = vec3(1.0) * diffuse * shadow;
// apply fog to raymarched landscape
color = fog(ro, rd, color, d);
} else {
// color the background of the scene
color = vec3(0.5,0.6,0.7);
}

gl_FragColor = vec4(color, 1.0);
}
