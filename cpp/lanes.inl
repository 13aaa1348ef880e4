// Vectors of floats as wide as the instruction set.  Included by kernels within their namespace.

#if defined(__GNUC__)
#if defined(__AVX512F__)
constexpr int kBytes = 64;
#elif defined(__AVX2__)
constexpr int kBytes = 32;
#else
constexpr int kBytes = 16;
#endif
typedef float V __attribute__((vector_size(kBytes)));
constexpr int kLanes = kBytes / 4;
#else
typedef float V;
constexpr int kLanes = 1;
#endif
