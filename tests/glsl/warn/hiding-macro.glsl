// macros with names that the language has
#define round(x) floor((x) + .5)
#define half .5
#define texture2D texture
void mainImage(out vec4 c, in vec2 p) { c = vec4(round(p.x) * half); }
