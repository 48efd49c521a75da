# How Eigen computes: one thread, no instructions beyond the base set, so that numbers and frames are equal on every machine.
# (Wider registers are used where the numbers stay the same: core/numerics/triples.hpp.) Vectors of three are not taken
# in pairs: a pair that was written as single numbers is waited for. Products of large matrices are sums of blocks, of
# the size that one cache has and not that of the machine at hand.
set(JW_EIGEN_DEFINITIONS
  EIGEN_DONT_PARALLELIZE EIGEN_UNALIGNED_VECTORIZE=0
  EIGEN_NO_CPUID EIGEN_DEFAULT_L1_CACHE_SIZE=32768 EIGEN_DEFAULT_L2_CACHE_SIZE=262144
  EIGEN_DEFAULT_L3_CACHE_SIZE=2097152)
# what Eigen knows of x86, for WebAssembly: vectors in memory are aligned to pairs, and products take blocks of the same
# shape
set(JW_EIGEN_WEB_DEFINITIONS EIGEN_MAX_STATIC_ALIGN_BYTES=16 EIGEN_ARCH_DEFAULT_NUMBER_OF_REGISTERS=16)
