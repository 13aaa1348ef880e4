// The least squares problem as flat arrays, shared by the kernels, the structure and the module.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace raybundle {

constexpr int kMaxParameters = 64;   // interior parameters that one observation touches
constexpr int kMaxNode = 6 + kMaxParameters;
constexpr int kPlainStride = 32;     // of the couplings of nodes that are no larger

// One list of free columns: which of the local parameters (X0 Y0 Z0, rotation, interior) go to the
// image's own node and which to the node of a shared interior orientation.
struct Pattern {
  std::vector<int> own, shared;
};

struct Problem {
  // observations, sorted by point
  int observations = 0;
  std::vector<int32_t> image, point;
  std::vector<double> xy;       // (m, 2) mm, image frame
  std::vector<double> whiten;   // (m, 3) lower triangle of the inverse Cholesky factor of the covariance
  std::vector<int32_t> external_row;  // (m) row in `external`, -1 where the model is compiled
  // (external rows, external_width) columns of the shared node that the derivatives by the interior orientation belong
  // to, padded by columns whose derivatives are zero; -1 first: all parameters, by the pattern
  std::vector<int32_t> touched;
  int external_width = 0;

  // images
  int images = 0;
  std::vector<int32_t> model;      // (n) compiled model, -1 = external
  std::vector<int32_t> corrected;  // (n) 1: residual of the corrected image point
  std::vector<int32_t> interior;   // (n) row of the interior orientation
  std::vector<int32_t> pattern, own_node, shared_node;
  std::vector<int32_t> parameters; // (n) number of interior parameters of its model
  std::vector<Pattern> patterns;
  int interior_stride = 0;

  // points, in the order of their first image (neighbours in memory then share blocks); `id` and `row`
  // are the positions that the caller knows
  int points = 0;
  std::vector<int32_t> id;           // (p)
  std::vector<int64_t> row;          // (m)
  std::vector<int32_t> owner;        // (m) position of the observation's point in this order
  std::vector<int64_t> first;        // (p + 1) observations of each point
  std::vector<int32_t> node_of_point;  // node of a retained point, -1 = eliminated
  std::vector<uint8_t> held;         // bit c: coordinate c is held
  std::vector<double> prior_weight, prior_value;  // (p, 3)

  // nodes: blocks of unknowns that stay in the reduced system
  int nodes = 0, unknowns = 0;
  std::vector<int32_t> size;
  std::vector<int64_t> offset;       // (nodes + 1) first scalar unknown

  // structure: nodes of each point, block of each pair of them
  std::vector<int64_t> point_nodes_first, point_pairs_first;
  std::vector<int32_t> point_nodes, pair_block;
  std::vector<int32_t> slot_own, slot_shared, slot_point;  // (m) positions in the point's node list
  std::vector<int64_t> block_start;  // (blocks + 1) offset of each block's values
  std::vector<int32_t> block_row, block_col;  // row <= col
  std::vector<std::vector<int32_t>> adjacency;  // (nodes) sorted later nodes, itself first
  std::vector<int64_t> column_first;            // (nodes + 1) block index of (a, adjacency[a][0])
  int largest_point_nodes = 0;
  int coupling_stride = kPlainStride;  // the largest node, padded
  // every point touches all parameters of its sensor and the nodes are small: the passes then know the stride
  bool plain() const { return coupling_stride == kPlainStride && external_width == 0; }

  // throw std::invalid_argument or std::out_of_range where an array is too short, or an index leads out of another
  void check(const std::vector<std::pair<int32_t, int32_t>>& extra_pairs) const;
  void check_external(std::size_t rows) const;
  void sort_points();
  void build_structure(const std::vector<std::pair<int32_t, int32_t>>& extra_pairs);
  int64_t block(int32_t row, int32_t col) const;
};

// The values at which the problem is evaluated.
struct State {
  const double* rotation;  // (n, 9)
  const double* centre;    // (n, 3)
  const double* interior;  // (q, stride)
  const double* xyz;       // (p, 3)
  const double* external;  // (rows, 9 + 2 external_width): v, d v / d sensor point, d v / d interior, flags; may be null
  double huber;            // 0: least squares
  double damping;
};

struct Totals {
  double cost = 0;       // half the weighted square sum, robust if asked
  int64_t behind = 0;    // observations whose point lies behind the sensor
  int64_t diverged = 0;  // observations without a projection
  std::vector<int32_t> weak;  // points whose normal matrix is singular
};

struct Kernels {
  const char* name;
  Totals (*reduce)(const Problem&, const State&, int threads, double* values, double* right, double* diagonal);
  // linearised cost returned in totals.cost
  Totals (*back_substitute)(const Problem&, const State&, int threads, const double* step, double* points);
  Totals (*evaluate)(const Problem&, const State&, int threads, double* residuals, uint8_t* behind);
  void (*statistics)(const Problem&, const State&, int threads, const double* inverse, int datum, const double* gauge_nodes,
                     const double* gauge_given, const double* gauge_points, const double* gauge_middle, double* point_cofactor,
                     double* hat, double* effect, double* point_h);
  void (*condense)(const Problem&, const State&, int threads, int columns, const double* given, double* right);
  void (*expand)(const Problem&, const State&, int threads, int columns, const double* nodes, const double* given, double* points);
};

const Kernels& kernels();
const std::vector<const char*>& model_names();
const std::vector<int>& model_parameters();

namespace baseline { extern const Kernels table; }
#ifdef RB_X86
namespace avx2 { extern const Kernels table; }
namespace avx512 { extern const Kernels table; }
#endif

}  // namespace raybundle
