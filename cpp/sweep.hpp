// Approximate depths by census and path aggregation, in the reference's own pixels.
#pragma once
#include <cstdint>

#include "surface.hpp"

namespace raybundle {

// A census image: 62 comparisons a pixel; kUnknown where its window reaches beyond the photograph.
constexpr uint64_t kUnknown = uint64_t(1) << 63;
// Places are whole numbers, so that every processor finds the same pixels.
constexpr int kFraction = 14;
constexpr int32_t kNowhere = INT32_MIN;

// Another photograph's census image, and where each pixel of the reference lies in it at each level.
struct SweepSource {
  const uint64_t* census;  // (height, width)
  int width, height;
  const int32_t* table;  // (levels, rows, columns, 2) [2^-14 px] at nodes of the reference; kNowhere where it does not see the place
};

struct Sweep {
  int width, height, levels;  // of the reference
  int step, rows, columns;    // of the tables: node (r, c) is the middle of pixel (step r, step c)
};

struct Penalties {
  int slope, jump, least;  // for a change of a level, of more levels, and of more levels at an edge of the image
};

struct SweepKernels {
  void (*census)(const uint8_t* image, int width, int height, uint64_t* out);
  // cost (height, width, levels): mean of the two best sources
  void (*costs)(const Sweep& sweep, const uint64_t* reference, const SweepSource* sources, int count, uint8_t* cost);
  // sum (height, width, levels) is what the eight paths add up to; level, margin (height, width)
  void (*aggregate)(const Sweep& sweep, const uint8_t* image, const uint8_t* cost, const Penalties& penalties, uint16_t* sum,
                    float* level, float* margin);
  // Places (count, 2) in a source of pixels xy (count, 2) at depth parameters t; NaN where it does not see them.
  void (*places)(const TransferTable& table, const double* xy, const double* t, int64_t count, double* out);
};

namespace baseline { extern const SweepKernels sweep; }
namespace avx2 { extern const SweepKernels sweep; }
namespace avx512 { extern const SweepKernels sweep; }
const SweepKernels& sweep_kernels();

}  // namespace raybundle
