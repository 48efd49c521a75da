// Eigen includes this beside the headers of SSE2. Registers of MMX are not there on WebAssembly, nor are they
// used.
