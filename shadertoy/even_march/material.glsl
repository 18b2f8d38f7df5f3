// Not in the seed, which calls it: where snow lies, in the seed's own heights.
float snowPresenceAtHeight(float height) {
    return smoothstep(-75.0, -50.0, height) - 0.5;
}

vec3 material(vec3 p, vec3 n) {



    float flatness = n.y;
    vec3 snowColor = vec3(2.8);
    vec3 rockColor = vec3(0.6);
    float randMixing = fbm(vec2(p.x, p.z), 2);
    float rockSnowMix = snowPresenceAtHeight(p.y) * flatness + randMixing;
    vec3 rockAndSnow = mix(rockColor, snowColor, rockSnowMix);



    vec3 grassColor = vec3(0.70, 0.85, 0.40);
    vec3 dirtColor = vec3(0.7, 0.7, 0.4);
    float grassDirtMix = fbm(vec2(p.x, p.z), 2);
    vec3 girt = mix(grassColor, dirtColor, grassDirtMix);





    float rockGradientStart = -100.;

    float rockGradientEnd = -60.;
    float rockPresenceAtHeight = smoothstep(rockGradientStart, rockGradientEnd, p.y);
    vec3 girtAndRock = mix(girt, rockAndSnow,
                           rockPresenceAtHeight * (1. - flatness));

    return girtAndRock;
}
