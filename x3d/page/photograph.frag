precision highp float;  // as in X3DOM's own lines: a uniform of both shaders has one precision
uniform sampler2D colour;
varying vec2 place;
void main() { gl_FragColor = vec4(texture2D(colour, place).rgb, 1.0); }
