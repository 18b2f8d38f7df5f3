vec3 fog(vec3 ro, vec3 rd, vec3 col, float d){
    vec3 pos = ro + rd * d;
    float sunAmount = max(dot(rd, lightPosition), 0.0);

    float b = 1.3;
    float fogAmount = 0.2 * exp(-ro.y * b) * (1.0 - exp(-d * rd.y * b)) / rd.y;
    vec3 fogColor = mix(vec3(0.5,0.2,0.15), vec3(1.1,0.6,0.45), pow(sunAmount,2.0));

    return mix(col, fogColor, clamp(fogAmount,0.0,1.0));
}
