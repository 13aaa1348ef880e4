// The surface: depth and slopes of every pixel of a reference image by least-squares matching in several sources at once.
#pragma once
#include <cstdint>

namespace raybundle {

constexpr int kMostSources = 16;
constexpr int kLargestWindow = 16;  // half of it [px]
constexpr int kLag = 3;             // pixels up to which grey values are correlated

// Where a source shows what a pixel of the reference shows, by pixel and depth parameter t: values at the nodes of a grid, of
// which four in each direction are taken at a time (Lagrange).
struct TransferTable {
  const double* xy;  // (rows, columns, levels, 2) pixel frame of the source; NaN where it does not see the place
  int rows, columns, levels;
  double u0, v0, step;  // the node (0, 0) in the pixel frame of the reference, and pixels from node to node
  double t0, dt;        // the first level, and from level to level
};

struct SurfaceSource {
  const float* grey;  // (height, width)
  int width, height;
  TransferTable transfer;
};

struct SurfaceFit {
  int half;            // window of (2 half + 1)^2 pixels
  double sigma;        // of its Gaussian weight [px]
  int iterations;
  double step;         // the iteration ends below this shift in the most sensitive source [px]
  double reach;        // largest shift there from the start [px]
  double slope;        // standard deviation of the given slopes, as shift there per pixel of the reference
  double correlation;  // least of a source with the reference
  double contrast;     // standard deviation of grey values in a window that is no texture yet
  double share;        // least ratio of the observed curvature of the cost to that of the normal matrix
  double apart;        // half the distance over which curvature is observed [px]
};

// Pixels that are asked for: columns x0, x0 + stride, ... and rows y0, y0 + stride, ... of the reference.
struct SurfaceGrid {
  int rows, columns, x0, y0, stride;
};

// What became of a pixel: see refine.py.
enum SurfaceReason : uint8_t { refined = 0, no_start = 1, no_texture = 2, left_image = 3, no_correlation = 4, no_curvature = 5, no_convergence = 6, moved_far = 7 };

// Numbers of a pixel, in this order, each an array (rows, columns).
enum SurfaceQuantity { kT, kA, kB, kFirstOrder, kNoise, kInflation, kGreyVariance, kCorrelation, kContrast, kSurfaceQuantities };

struct SurfaceImages {
  const float* reference;  // (height, width)
  int width, height;
  const SurfaceSource* sources;
  int count;
  const float* autocovariance;  // (count + 1, 7, 7) of grey values by lag, the reference first, 1 in the middle; null: white
};

struct SurfaceFound {
  float* numbers;       // (kSurfaceQuantities, rows, columns); t, a, b hold the start
  const uint8_t* todo;  // (rows, columns)
  uint8_t* reason;      // (rows, columns)
  uint8_t* iterations;  // (rows, columns)
  int32_t* views;       // (rows, columns) bit s: source s was used
  float* shift;         // (rows, columns, count, 2): how t changes with the place that a source's table says; or null
  float* response;      // (rows, columns, window): how t reacts to the surface at each pixel of the window; or null
};

struct SurfaceKernels {
  // Rows from begin to end; chain 1 or -1: a pixel without a start goes on from its left or right neighbour.
  void (*refine)(const SurfaceImages& images, const SurfaceFit& fit, const SurfaceGrid& grid, int begin, int end, int chain, const SurfaceFound& found);
};

namespace baseline { extern const SurfaceKernels surface; }
namespace avx2 { extern const SurfaceKernels surface; }
namespace avx512 { extern const SurfaceKernels surface; }
const SurfaceKernels& surface_kernels();

}  // namespace raybundle
