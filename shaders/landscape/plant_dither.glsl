// A pattern of thresholds 0..1 over the screen (interleaved gradient noise, Jimenez 2014).
float dither() { return fract(52.9829189 * fract(dot(gl_FragCoord.xy + vec2(frame.horizon.w, frame.zenith.w), vec2(0.06711056, 0.00583715)))); }
