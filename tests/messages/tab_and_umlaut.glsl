	/* grüße 🌉 */	float a = 1.0;

void mainImage(out vec4 fragColor, in vec2 fragCoord) {
		fragColor = vec4(/* äö */ unknown);
}
