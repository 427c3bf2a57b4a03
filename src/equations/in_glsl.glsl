// What the text needs beyond GLSL's own types and builtins. Include before all.glsl.
#define Real float
#define Mask bool

float floor_log2(float a) { return floor(log2(a)); }
float power_of_two(float whole) { return exp2(whole); }
float select(bool m, float yes, float no) { return m ? yes : no; }
vec3 select(bool m, vec3 yes, vec3 no) { return m ? yes : no; }
