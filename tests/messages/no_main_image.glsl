float wave(float x) {
    return 0.5 + 0.5 * sin(x);
}
