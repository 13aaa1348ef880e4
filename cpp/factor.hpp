// Sparse Cholesky factor of the reduced normal matrix, its solutions and its selected inverse.
#pragma once

#include <cstdint>
#include <vector>

#include "problem.hpp"

namespace raybundle {

// Dense kernels, taken from SciPy's BLAS and LAPACK at run time (Fortran calling convention).
struct Dense {
  void (*potrf)(const char*, const int*, double*, const int*, int*) = nullptr;
  void (*potri)(const char*, const int*, double*, const int*, int*) = nullptr;
  void (*trsm)(const char*, const char*, const char*, const char*, const int*, const int*, const double*, const double*, const int*,
               double*, const int*) = nullptr;
  void (*syrk)(const char*, const char*, const int*, const int*, const double*, const double*, const int*, const double*, double*,
               const int*) = nullptr;
  void (*gemm)(const char*, const char*, const int*, const int*, const int*, const double*, const double*, const int*, const double*,
               const int*, const double*, double*, const int*) = nullptr;
};

Dense& dense();

class Factor {
 public:
  // Orders the nodes (minimum degree on the image graph) and finds the supernodes.
  explicit Factor(const Problem& problem);

  // 0, or 1 + the scalar unknown at which the matrix stops being positive definite.  `added` is added to the diagonal.
  int64_t factorise(const double* values, const double* added);

  // x (N, columns), row-major, in place
  void solve(double* x, int columns) const;

  // Blocks of the inverse at the places of the matrix's own blocks.
  void selected_inverse(double* values) const;

  double smallest_pivot() const { return smallest_pivot_; }
  int64_t smallest_pivot_at() const { return smallest_pivot_at_; }
  // (N) of the matrix itself, not of the scaled one: what is left of each unknown's diagonal after those eliminated before
  const std::vector<double>& pivots() const { return pivots_; }
  int64_t entries() const { return entries_; }
  double operations() const { return operations_; }

 private:
  struct Entry { int64_t block; int row, col; bool transposed; };
  struct Supernode {
    int columns = 0, rows = 0;           // scalars: own, below
    std::vector<int> nodes, below;       // node ids
    std::vector<int> local;              // scalar start of each node of `nodes`, then of `below`
    int64_t position = 0;                // first scalar in the elimination order
    int parent = -1;
    std::vector<int> children;
    std::vector<int> map;                // start of each node of `below` in the parent's front
    std::vector<Entry> entries;
    std::vector<double> panel;           // (columns + rows, columns), column-major
  };
  const Problem& problem_;
  std::vector<Supernode> supernodes_;
  std::vector<double> scale_, pivots_;
  double smallest_pivot_ = 0, operations_ = 0;
  int64_t smallest_pivot_at_ = -1, entries_ = 0;
};

}  // namespace raybundle
