// Kernels on coded targets: the photometric fit of a dot.
#pragma once
#include <cstdint>

#include "imaging.hpp"

namespace raybundle {

// How a dot is fitted: see centre.py.
struct DotFit {
  int iterations;
  double step;      // the iteration ends below this shift of the centre [px]
  double reach;     // largest shift from the start, in semi-minor axes
  double slope;     // standard deviation of the relative change of the light [1/px]
};

// What became of a dot: see centre.py.
enum DotOutcome : int32_t { dot_measured = 0, dot_outside = 1, dot_flat = 2, dot_moved = 3, dot_unsteady = 4 };

constexpr int kDotUnknowns = 10;  // centre, lower triangle of the shape, blur, ground, contrast, slope of the light
constexpr int kDotDoubts = 3;     // signs of something that lies on a dot: see centre.py

// Dots of which only some pixels are looked at.  The boxes (x0, y0, x1, y1; ends excluded) of n dots, their pixels one after the
// other from offset[n] on, 1 where a pixel takes part; residuals and their derivatives (10, with the
// sign of the model) of all pixels of the boxes come back.
struct DotMasks {
  const int32_t* box;
  const int64_t* offset;
  const uint8_t* free;
  double *residuals, *derivatives;
};

// When something is said to lie on a dot: limits of normal deviates, how far around it nothing is trusted, whether roughness
// of the whole is no excuse.  See covered.py.
struct CoverLimits {
  double pixel, edge, halo;  // halo in pixels
  bool strict;
};

struct TargetKernels {
  // values (n, 10) begin with centre and shape (a, b, d); window (n) in radii; covariance (n, 3); residual (n) [grey]; doubts (n, 3).
  void (*fit_dots)(const Grey& image, const DotFit& fit, int begin, int end, const double* window, double* values, double* covariance,
                   double* residual, double* doubts, int32_t* outcome);
  // values (n, 10) are all given; covariance (n, 10, 10).
  void (*fit_masked)(const Grey& image, const DotFit& fit, int begin, int end, const DotMasks& masks, double* values, double* covariance,
                     double* residual, int32_t* outcome);
  // values (n, 10), covariances (n, 10, 10), residuals and derivatives of the pixels of the boxes; covered: 1 where something lies.
  void (*cover)(int n, const double* values, const double* cov, const int32_t* box, const int64_t* offset, const uint8_t* free,
                const double* residuals, const double* derivatives, const CoverLimits* limits, uint8_t* covered);
};

namespace baseline { extern const TargetKernels targets; }
namespace avx2 { extern const TargetKernels targets; }
namespace avx512 { extern const TargetKernels targets; }
const TargetKernels& target_kernels();

}  // namespace raybundle
