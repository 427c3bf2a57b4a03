// The headers are all there is to compile.
