function distHeightfield(vec3 pos) {
return h(pos.xz) + pos.y;
}
