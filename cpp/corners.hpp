// Kernels on chessboards: the photometric fit of a corner where four squares meet.
#pragma once
#include <cstdint>

#include "imaging.hpp"

namespace raybundle {

constexpr int kCornerUnknowns = 9;  // corner, directions of both normals, blur, mean, half the contrast, slope of the light

struct CornerKernels {
  // xy (n, 2) start; u, v (n, 2) arms of the windows; band (n, 2) of what counts, in arms; half (n) limits of steps; `least`
  // half the contrast below which nothing is fitted.  values (n, 9), the corner relative to the centre of the pixel of the
  // start; cofactor (n, 3); variance (n) of a grey value; ended (n) whether the iteration came to its end.  See saddle.py.
  void (*fit_corners)(const Grey& image, int iterations, double least, int begin, int end, const double* xy, const double* u,
                      const double* v, const double* band, const double* half, double* values, double* cofactor, double* variance,
                      uint8_t* ended);
};

namespace baseline { extern const CornerKernels corners; }
namespace avx2 { extern const CornerKernels corners; }
namespace avx512 { extern const CornerKernels corners; }
const CornerKernels& corner_kernels();

}  // namespace raybundle
