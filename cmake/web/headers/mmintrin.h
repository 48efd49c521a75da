// Eigen includes this header with those of SSE2. WebAssembly has no MMX registers, and they are not used.
