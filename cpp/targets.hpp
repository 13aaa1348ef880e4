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

struct TargetKernels {
  // values (n, 10) begin with centre and shape (a, b, d); window (n) in radii; covariance (n, 3); residual (n) [grey].
  void (*fit_dots)(const Grey& image, const DotFit& fit, int begin, int end, const double* window, double* values, double* covariance,
                   double* residual, int32_t* outcome);
};

namespace baseline { extern const TargetKernels targets; }
namespace avx2 { extern const TargetKernels targets; }
namespace avx512 { extern const TargetKernels targets; }
const TargetKernels& target_kernels();

}  // namespace raybundle
