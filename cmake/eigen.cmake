# Settings of Eigen: one thread, only the base instruction set, so that numbers and frames are equal on every machine.
# (Wider registers are used where the numbers stay the same: core/numerics/triples.hpp.) Vectors of three are not loaded
# in pairs: the load of a pair that was written as single numbers has to wait. Products of large matrices are sums of
# blocks, whose size follows from fixed cache sizes, not from those of the machine.
set(JW_EIGEN_DEFINITIONS
  EIGEN_DONT_PARALLELIZE EIGEN_UNALIGNED_VECTORIZE=0
  EIGEN_NO_CPUID EIGEN_DEFAULT_L1_CACHE_SIZE=32768 EIGEN_DEFAULT_L2_CACHE_SIZE=262144
  EIGEN_DEFAULT_L3_CACHE_SIZE=2097152)
# for WebAssembly, settings that Eigen has for x86: vectors in memory are aligned to pairs, and products take blocks of
# the same shape
set(JW_EIGEN_WEB_DEFINITIONS EIGEN_MAX_STATIC_ALIGN_BYTES=16 EIGEN_ARCH_DEFAULT_NUMBER_OF_REGISTERS=16)
