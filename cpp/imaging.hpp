// Kernels on image contents: descriptor matching and least-squares matching.
#pragma once
#include <cstdint>

namespace raybundle {

// A grey image: 16 bit, rows of `width` values.
struct Grey {
  const uint16_t* data;
  int width, height;
};

// How a patch is matched.
struct Patch {
  int half;           // window of (2 half + 1)^2 positions
  double sigma;       // of the Gaussian weight [px]
  int iterations;
  double step;        // the iteration ends below this shift [px]
  double reach;       // largest shift from the start [px]
  double loose;       // standard deviation of the affine map that is given
  bool spline;        // the images are coefficients of a cubic B-spline; false: grey values, interpolated by convolution
  bool quadratic;     // the shape has curvature
};

// What became of a point: see least_squares.py.
enum Outcome : int32_t { matched = 0, outside = 1, flat = 2, moved = 3, unsteady = 4 };

constexpr int kResidual = 14;  // figures of the residuals of a match: see least_squares.py
constexpr int kParts = 3;     // of a window along a side, each of which may be displaced by itself

struct ImagingKernels {
  // For rows of a (n, k): position and value of the largest inner product with rows of b (m, k), the second
  // largest; for rows of b: position of the largest.  k a multiple of 4.
  void (*best)(const float* a, int n, const float* b, int m, int k, int32_t* first, float* value, float* second, int32_t* reverse);
  // The same of the directions of vectors of bytes: products divided by both lengths.
  void (*best_bytes)(const uint8_t* a, int n, const uint8_t* b, int m, int k, int32_t* first, float* value, float* second,
                     int32_t* reverse);
  // Least-squares matching of points of a reference image in a target image; bend: curvature, u^2 / 2, u v, v^2 / 2 of x, then y.
  void (*match)(const Grey& reference, const Grey& target, const Patch& patch, int begin, int end, const double* xy_reference,
                double* xy, double* affine, double* bend, double* covariance, double* correlation, double* residual, int32_t* outcome);
};

namespace baseline { extern const ImagingKernels imaging; }
namespace avx2 { extern const ImagingKernels imaging; }
namespace avx512 { extern const ImagingKernels imaging; }
const ImagingKernels& imaging_kernels();

}  // namespace raybundle
