// Scale-invariant features of a grey image (Lowe 2004) with square-root descriptors (Arandjelovic and Zisserman 2012).
#pragma once
#include <cstdint>
#include <memory>
#include <vector>

namespace raybundle {

constexpr int kLevels = 3;  // of an octave in which extrema are found
constexpr int kDescriptor = 128;

// A smoothed image that features are described from: grey values in 256ths.
struct Level {
  int width, height;
  double pixel;  // of the image, in a pixel of the level; the centres of both first pixels coincide
  std::unique_ptr<uint16_t[]> values;
};

// An extremum of the differences of smoothed images.
struct Extremum {
  float x, y;      // relative to the centre of the first pixel of its level
  float sigma;     // in pixels of its level
  float strength;  // absolute value of the difference [grey levels]
  int32_t level;
};

struct ScaleSpace {
  std::vector<Level> levels;
  std::vector<Extremum> extrema;
  ScaleSpace() = default;
  ScaleSpace(ScaleSpace&&) = default;
};

struct FeatureKernels {
  // Extrema stronger than `least` [grey levels] of an image (height, width), from its own size or from twice its size downwards.
  void (*search)(const uint8_t* grey, int width, int height, float least, bool doubled, ScaleSpace& found);
  // Directions of the gradients around extrema [rad, clockwise in the pixel frame]: the strongest of each of `chosen`, then
  // all others of at least 0.8 of it, with the positions of their owners in `chosen`.
  void (*orient)(const ScaleSpace& space, const int64_t* chosen, int64_t n, std::vector<int64_t>& owner, std::vector<double>& angle);
  // Descriptors (n, 128) of extrema turned by `angle`.
  void (*describe)(const ScaleSpace& space, const int64_t* chosen, const double* angle, int64_t n, uint8_t* descriptors);
};

namespace baseline { extern const FeatureKernels features; }
namespace avx2 { extern const FeatureKernels features; }
namespace avx512 { extern const FeatureKernels features; }
const FeatureKernels& feature_kernels();

}  // namespace raybundle
