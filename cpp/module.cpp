// Python bindings.
#include <nanobind/nanobind.h>
#include <nanobind/ndarray.h>
#include <nanobind/stl/array.h>
#include <nanobind/stl/optional.h>
#include <nanobind/stl/pair.h>
#include <nanobind/stl/string.h>
#include <nanobind/stl/vector.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>

#include "corners.hpp"
#include "factor.hpp"
#include "imaging.hpp"
#include "problem.hpp"
#include "sweep.hpp"
#include "surface.hpp"
#include "tables.hpp"
#include "targets.hpp"

namespace nb = nanobind;
using namespace raybundle;

namespace raybundle {

// The widest instruction set of this processor; RAYBUNDLE_NATIVE=avx2 or =baseline stays below it.
enum class Width { baseline, avx2, avx512 };

static Width width() {
#ifdef RB_X86
  const char* text = std::getenv("RAYBUNDLE_NATIVE");
  const std::string limit = text ? text : "";
  const bool avx2_here = __builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma");
  const bool avx512_here = avx2_here && __builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512dq") &&
                           __builtin_cpu_supports("avx512vl") && __builtin_cpu_supports("avx512bw");
  if (avx512_here && limit != "avx2" && limit != "baseline") return Width::avx512;
  if (avx2_here && limit != "baseline") return Width::avx2;
#endif
  return Width::baseline;
}

const Kernels& kernels() {
  static const Width chosen = width();
#ifdef RB_X86
  if (chosen == Width::avx512) return avx512::table;
  if (chosen == Width::avx2) return avx2::table;
#endif
  return baseline::table;
}

const ImagingKernels& imaging_kernels() {
  static const Width chosen = width();
#ifdef RB_X86
  if (chosen == Width::avx512) return avx512::imaging;
  if (chosen == Width::avx2) return avx2::imaging;
#endif
  return baseline::imaging;
}

const TargetKernels& target_kernels() {
  static const Width chosen = width();
#ifdef RB_X86
  if (chosen == Width::avx512) return avx512::targets;
  if (chosen == Width::avx2) return avx2::targets;
#endif
  return baseline::targets;
}

const SweepKernels& sweep_kernels() {
  static const Width chosen = width();
#ifdef RB_X86
  if (chosen == Width::avx512) return avx512::sweep;
  if (chosen == Width::avx2) return avx2::sweep;
#endif
  return baseline::sweep;
}

const CornerKernels& corner_kernels() {
  static const Width chosen = width();
#ifdef RB_X86
  if (chosen == Width::avx512) return avx512::corners;
  if (chosen == Width::avx2) return avx2::corners;
#endif
  return baseline::corners;
}

const SurfaceKernels& surface_kernels() {
  static const Width chosen = width();
#ifdef RB_X86
  if (chosen == Width::avx512) return avx512::surface;
  if (chosen == Width::avx2) return avx2::surface;
#endif
  return baseline::surface;
}

}  // namespace raybundle

namespace {

using Doubles = nb::ndarray<double, nb::numpy, nb::c_contig, nb::device::cpu>;
using Ints = nb::ndarray<const int32_t, nb::numpy, nb::c_contig, nb::device::cpu>;
using Longs = nb::ndarray<const int64_t, nb::numpy, nb::c_contig, nb::device::cpu>;
using Bytes = nb::ndarray<uint8_t, nb::numpy, nb::c_contig, nb::device::cpu>;
using Const = nb::ndarray<const double, nb::numpy, nb::c_contig, nb::device::cpu>;

template <class T, class A> std::vector<T> copy(const A& a) { return std::vector<T>(a.data(), a.data() + a.size()); }

template <class T> nb::ndarray<T, nb::numpy, nb::c_contig, nb::device::cpu> array(std::vector<size_t> shape) {
  size_t n = 1;
  for (size_t s : shape) n *= s;
  T* data = new T[n]();
  nb::capsule owner(data, [](void* p) noexcept { delete[] static_cast<T*>(p); });
  return {data, shape.size(), shape.data(), owner};
}
Doubles make(std::vector<size_t> shape) { return array<double>(std::move(shape)); }

using Floats = nb::ndarray<const float, nb::ndim<2>, nb::numpy, nb::c_contig, nb::device::cpu>;
using Image = nb::ndarray<const uint16_t, nb::ndim<2>, nb::numpy, nb::c_contig, nb::device::cpu>;

constexpr size_t kLongestBytes = 16384;  // whole numbers of 32 bit hold their products
using ByteRows = nb::ndarray<const uint8_t, nb::ndim<2>, nb::numpy, nb::c_contig, nb::device::cpu>;

template <class Rows, class Kernel> nb::tuple best(const Rows& a, const Rows& b, Kernel kernel) {
  if (a.shape(1) != b.shape(1)) throw std::invalid_argument("descriptors have different lengths");
  const int n = int(a.shape(0)), m = int(b.shape(0)), k = int(a.shape(1));
  auto first = array<int32_t>({a.shape(0)}), reverse = array<int32_t>({b.shape(0)});
  auto value = array<float>({a.shape(0)}), second = array<float>({a.shape(0)});
  const auto *da = a.data(), *db = b.data();
  int32_t *f = first.data(), *r = reverse.data();
  float *v = value.data(), *s = second.data();
  {
    nb::gil_scoped_release release;
    kernel(da, n, db, m, k, f, v, s, r);
  }
  return nb::make_tuple(first, value, second, reverse);
}

constexpr int kLargestHalf = 256;  // pixels

nb::tuple match_windows(Image reference, Image target, Const xy_reference, Const xy_start, Const affine_start, int half, double sigma,
                        int iterations, double step, double reach, double loose) {
  const size_t n = xy_reference.size() / 2;
  if (xy_start.size() != 2 * n || affine_start.size() != 4 * n) throw std::invalid_argument("windows have the wrong size");
  if (xy_reference.size() % 2 || half < 2 || half > kLargestHalf) throw std::invalid_argument("half a window is not from 2 to 256 pixels");
  auto xy = make({n, 2}), affine = make({n, 2, 2}), covariance = make({n, 3}), correlation = make({n});
  auto outcome = array<int32_t>({n});
  std::copy_n(xy_start.data(), 2 * n, xy.data());
  std::copy_n(affine_start.data(), 4 * n, affine.data());
  const Grey from{reference.data(), int(reference.shape(1)), int(reference.shape(0))};
  const Grey to{target.data(), int(target.shape(1)), int(target.shape(0))};
  const double* c = xy_reference.data();
  double *p = xy.data(), *B = affine.data(), *Q = covariance.data(), *r = correlation.data();
  int32_t* o = outcome.data();
  {
    nb::gil_scoped_release release;
    imaging_kernels().match(from, to, {half, sigma, iterations, step, reach, loose}, 0, int(n), c, p, B, Q, r, o);
  }
  return nb::make_tuple(xy, affine, covariance, correlation, outcome);
}

nb::tuple fit_dots(Image image, Const xy, Const shape, Const window, int iterations, double step, double reach, double slope) {
  const size_t n = window.size();
  if (xy.size() != 2 * n || shape.size() != 3 * n || !(slope > 0)) throw std::invalid_argument("dots have the wrong size");
  auto values = make({n, size_t(kDotUnknowns)}), covariance = make({n, 3}), residual = make({n}), doubts = make({n, size_t(kDotDoubts)});
  auto outcome = array<int32_t>({n});
  for (size_t i = 0; i < n; ++i) {
    std::copy_n(xy.data() + 2 * i, 2, values.data() + kDotUnknowns * i);
    std::copy_n(shape.data() + 3 * i, 3, values.data() + kDotUnknowns * i + 2);
  }
  const Grey grey{image.data(), int(image.shape(1)), int(image.shape(0))};
  const double* w = window.data();
  double *v = values.data(), *Q = covariance.data(), *r = residual.data(), *d = doubts.data();
  int32_t* o = outcome.data();
  {
    nb::gil_scoped_release release;
    target_kernels().fit_dots(grey, {iterations, step, reach, slope}, 0, int(n), w, v, Q, r, d, o);
  }
  return nb::make_tuple(values, covariance, residual, doubts, outcome);
}

nb::tuple fit_masked_dots(Image image, Const start, Ints box, Longs offset, Bytes free, int iterations, double step, double reach,
                          double slope) {
  const size_t n = start.size() / kDotUnknowns;
  const int64_t height = int64_t(image.shape(0)), width = int64_t(image.shape(1));
  if (start.size() != n * kDotUnknowns || box.size() != 4 * n || offset.size() != n + 1 || !(slope > 0))
    throw std::invalid_argument("dots have the wrong size");
  bool fine = offset.data()[0] == 0 && offset.data()[n] == int64_t(free.size());
  for (size_t i = 0; i < n && fine; ++i) {
    const int32_t* b = box.data() + 4 * i;
    fine = b[0] >= 0 && b[1] >= 0 && b[0] < b[2] && b[1] < b[3] && b[2] <= width && b[3] <= height &&
           offset.data()[i + 1] - offset.data()[i] == int64_t(b[2] - b[0]) * (b[3] - b[1]);
  }
  if (!fine) throw std::invalid_argument("boxes of dots leave the image, or are not as large as their pixels");
  auto values = make({n, size_t(kDotUnknowns)}), covariance = make({n, size_t(kDotUnknowns), size_t(kDotUnknowns)}), residual = make({n});
  auto e = make({free.size()}), J = make({free.size(), size_t(kDotUnknowns)});
  auto outcome = array<int32_t>({n});
  std::copy_n(start.data(), start.size(), values.data());
  const Grey grey{image.data(), int(width), int(height)};
  const DotMasks masks{box.data(), offset.data(), free.data(), e.data(), J.data()};
  double *v = values.data(), *Q = covariance.data(), *r = residual.data();
  int32_t* o = outcome.data();
  {
    nb::gil_scoped_release release;
    target_kernels().fit_masked(grey, {iterations, step, reach, slope}, 0, int(n), masks, v, Q, r, o);
  }
  return nb::make_tuple(values, covariance, residual, outcome, e, J);
}

// Pixels of dots on which something lies; limits (n, 4): pixel, edge, halo [px], strict.
nb::object cover_dots(Const values, Const cov, Ints box, Longs offset, Bytes free, Const e, Const J, Const limits) {
  const size_t n = values.size() / kDotUnknowns, m = free.size();
  if (values.size() != n * kDotUnknowns || cov.size() != n * kDotUnknowns * kDotUnknowns || box.size() != 4 * n || offset.size() != n + 1 ||
      limits.size() != 4 * n || e.size() != m || J.size() != m * kDotUnknowns)
    throw std::invalid_argument("dots have the wrong size");
  bool fine = offset.data()[0] == 0 && offset.data()[n] == int64_t(m);
  std::vector<CoverLimits> each(n);
  for (size_t i = 0; i < n && fine; ++i) {
    const int32_t* b = box.data() + 4 * i;
    const double *v = values.data() + kDotUnknowns * i, *l = limits.data() + 4 * i;
    each[i] = {l[0], l[1], l[2], l[3] != 0};
    fine = b[0] >= 0 && b[1] >= 0 && b[0] < b[2] && b[1] < b[3] && l[2] >= 0 && l[2] < 1e3 && v[2] > 1e-3 && v[4] > 1e-3 &&
           std::all_of(v, v + 5, [](double a) { return std::abs(a) < 1e9; }) &&
           offset.data()[i + 1] - offset.data()[i] == int64_t(b[2] - b[0]) * (b[3] - b[1]);
  }
  const auto number = [](double a) { return std::isfinite(a); };
  fine = fine && std::all_of(e.data(), e.data() + e.size(), number) && std::all_of(J.data(), J.data() + J.size(), number);
  if (!fine) throw std::invalid_argument("boxes of dots are not as large as their pixels, or dots have no size, or are no numbers");
  auto covered = array<uint8_t>({m});
  uint8_t* c = covered.data();
  {
    nb::gil_scoped_release release;
    target_kernels().cover(int(n), values.data(), cov.data(), box.data(), offset.data(), free.data(), e.data(), J.data(), each.data(), c);
  }
  return nb::cast(covered);
}

nb::tuple fit_corners(Image image, Const xy, Const u, Const v, Const band, Const half, double least, int iterations) {
  const size_t n = half.size();
  if (xy.size() != 2 * n || u.size() != 2 * n || v.size() != 2 * n || band.size() != 2 * n)
    throw std::invalid_argument("corners have the wrong size");
  auto values = make({n, size_t(kCornerUnknowns)}), cofactor = make({n, 3}), variance = make({n});
  auto ended = array<uint8_t>({n});
  const Grey grey{image.data(), int(image.shape(1)), int(image.shape(0))};
  const double *c = xy.data(), *a = u.data(), *b = v.data(), *w = band.data(), *h = half.data();
  double *p = values.data(), *Q = cofactor.data(), *s = variance.data();
  uint8_t* e = ended.data();
  {
    nb::gil_scoped_release release;
    corner_kernels().fit_corners(grey, iterations, least, 0, int(n), c, a, b, w, h, p, Q, s, e);
  }
  return nb::make_tuple(values, cofactor, variance, ended);
}

template <class T, int dimensions> using In = nb::ndarray<const T, nb::ndim<dimensions>, nb::numpy, nb::c_contig, nb::device::cpu>;
template <class T, int dimensions> using Into = nb::ndarray<T, nb::ndim<dimensions>, nb::numpy, nb::c_contig, nb::device::cpu>;

void require(bool fine, const char* what) {
  if (!fine) throw std::invalid_argument(what);
}

constexpr size_t kMostCells = size_t(1) << 40, kLongestSide = 32767;

Sweep sweep_of(const Into<uint8_t, 3>& cost, int step, size_t rows, size_t columns) {
  require(cost.shape(0) >= 1 && cost.shape(1) >= 1 && cost.shape(2) >= 1 && cost.shape(0) <= kLongestSide && cost.shape(1) <= kLongestSide &&
              cost.shape(2) <= kLongestSide && cost.size() < kMostCells,
          "costs have the wrong size");
  return {int(cost.shape(1)), int(cost.shape(0)), int(cost.shape(2)), step, int(rows), int(columns)};
}

void census(In<uint8_t, 2> image, Into<uint64_t, 2> out) {
  require(out.shape(0) == image.shape(0) && out.shape(1) == image.shape(1), "a census is of its image's size");
  require(image.shape(0) <= kLongestSide && image.shape(1) <= kLongestSide, "an image is too large");
  nb::gil_scoped_release release;
  sweep_kernels().census(image.data(), int(image.shape(1)), int(image.shape(0)), out.data());
}

void sweep_costs(In<uint64_t, 2> reference, const std::vector<In<uint64_t, 2>>& sources,
                 const std::vector<In<int32_t, 4>>& tables, int step, Into<uint8_t, 3> cost) {
  require(!tables.empty() && tables.size() == sources.size() && step >= 1, "sources have no tables");
  const size_t rows = tables[0].shape(1), columns = tables[0].shape(2);
  const Sweep sweep = sweep_of(cost, step, rows, columns);
  require(reference.shape(0) == cost.shape(0) && reference.shape(1) == cost.shape(1), "costs are not of the reference's size");
  require(rows >= 2 && columns >= 2 && (rows - 1) * step >= cost.shape(0) && (columns - 1) * step >= cost.shape(1),
          "tables do not cover the reference");
  std::vector<SweepSource> given;
  for (size_t k = 0; k < sources.size(); ++k) {
    const auto& t = tables[k];
    require(t.shape(0) == cost.shape(2) && t.shape(1) == rows && t.shape(2) == columns && t.shape(3) == 2, "a table has the wrong size");
    require(sources[k].shape(0) <= kLongestSide && sources[k].shape(1) <= kLongestSide, "an image is too large");
    given.push_back({sources[k].data(), int(sources[k].shape(1)), int(sources[k].shape(0)), t.data()});
  }
  nb::gil_scoped_release release;
  sweep_kernels().costs(sweep, reference.data(), given.data(), int(given.size()), cost.data());
}

void aggregate(In<uint8_t, 2> image, Into<uint8_t, 3> cost, int slope, int jump, int least, Into<uint16_t, 3> sum,
               Into<float, 2> level, Into<float, 2> margin) {
  const Sweep sweep = sweep_of(cost, 1, 0, 0);
  const auto of_image = [&](const auto& a) { return a.shape(0) == cost.shape(0) && a.shape(1) == cost.shape(1); };
  require(of_image(image) && of_image(sum) && of_image(level) && of_image(margin) && sum.shape(2) == cost.shape(2), "results are not of the image's size");
  require(0 <= slope && slope <= least && least <= jump && jump <= 90, "penalties are not 0 <= slope <= least <= jump <= 90");
  nb::gil_scoped_release release;
  sweep_kernels().aggregate(sweep, image.data(), cost.data(), {slope, jump, least}, sum.data(), level.data(), margin.data());
}

// Rows of a grid of pixels; fit: half, sigma, iterations, step, reach, slope, correlation, contrast, share, apart; grid: x0, y0,
// stride; tables: u0, v0, step, t0, dt of each.  numbers, reason, iterations and views are written where todo says so.
void refine_surface(In<float, 2> reference, const std::vector<In<float, 2>>& grey, const std::vector<In<double, 4>>& places,
                    const std::vector<std::array<double, 5>>& tables, const std::array<double, 10>& fit, const std::array<int, 3>& grid, int begin,
                    int end, int chain, const std::optional<In<float, 3>>& autocovariance, Into<float, 3> numbers, In<uint8_t, 2> todo,
                    Into<uint8_t, 2> reason, Into<uint8_t, 2> iterations, Into<int32_t, 2> views, const std::optional<Into<float, 4>>& shift,
                    const std::optional<Into<float, 3>>& response) {
  const size_t count = grey.size(), rows = todo.shape(0), columns = todo.shape(1);
  const auto of_grid = [&](const auto& a) { return a.shape(0) == rows && a.shape(1) == columns; };
  const auto small = [](size_t n) { return n < (size_t(1) << 30); };
  require(count >= 1 && count <= size_t(kMostSources) && places.size() == count && tables.size() == count, "the number of sources is not from 1 to 16");
  require(fit[0] >= 1 && fit[0] <= kLargestWindow && fit[1] > 0 && fit[2] >= 1 && fit[2] <= 255 && fit[5] > 0 && fit[9] > 0, "a window or its iteration is not as it can be");
  require(small(rows) && small(columns) && grid[0] >= 0 && grid[1] >= 0 && grid[2] >= 1 && (!rows || grid[1] + (double(rows) - 1) * grid[2] < double(reference.shape(0))) &&
            (!columns || grid[0] + (double(columns) - 1) * grid[2] < double(reference.shape(1))),
        "pixels lie beyond the reference image");
  require(begin >= 0 && begin <= end && size_t(end) <= rows && chain >= -1 && chain <= 1, "rows are not those of the grid");
  require(numbers.shape(0) == kSurfaceQuantities && numbers.shape(1) == rows && numbers.shape(2) == columns && of_grid(reason) && of_grid(iterations) && of_grid(views),
        "results have the wrong size");
  require(!autocovariance || (autocovariance->shape(0) == count + 1 && autocovariance->shape(1) == 2 * kLag + 1 && autocovariance->shape(2) == 2 * kLag + 1),
        "autocovariances are not (views, 7, 7)");
  require(!shift || (of_grid(*shift) && shift->shape(2) == count && shift->shape(3) == 2), "shifts have the wrong size");
  const size_t side = 2 * size_t(fit[0]) + 1;
  require(!response || (of_grid(*response) && response->shape(2) == side * side), "responses have the wrong size");
  require(reference.size() < (size_t(1) << 31), "the reference image is too large");
  std::vector<SurfaceSource> sources;
  for (size_t s = 0; s < count; ++s) {
    const auto& [u0, v0, step, t0, dt] = tables[s];
    const auto& p = places[s];
    require(grey[s].size() < (size_t(1) << 31) && p.shape(3) == 2 && step > 0 && dt != 0, "a source has the wrong size");
    require(p.shape(0) >= 4 && p.shape(1) >= 4 && p.shape(2) >= 4 && small(p.shape(0)) && small(p.shape(1)) && small(p.shape(2)), "a table has fewer than 4 nodes in a direction");
    sources.push_back({grey[s].data(), int(grey[s].shape(1)), int(grey[s].shape(0)),
                       {p.data(), int(p.shape(0)), int(p.shape(1)), int(p.shape(2)), u0, v0, step, t0, dt}});
  }
  const SurfaceImages images{reference.data(), int(reference.shape(1)), int(reference.shape(0)), sources.data(), int(count), autocovariance ? autocovariance->data() : nullptr};
  const SurfaceFit settings{int(fit[0]), fit[1], int(fit[2]), fit[3], fit[4], fit[5], fit[6], fit[7], fit[8], fit[9]};
  const SurfaceFound found{numbers.data(), todo.data(), reason.data(), iterations.data(), views.data(), shift ? shift->data() : nullptr, response ? response->data() : nullptr};
  nb::gil_scoped_release release;
  surface_kernels().refine(images, settings, {int(rows), int(columns), grid[0], grid[1], grid[2]}, begin, end, chain, found);
}

// table: u0, v0, step, t0, dt
void transfer_places(In<double, 4> places, const std::array<double, 5>& table, In<double, 2> xy, In<double, 1> t, Into<double, 2> out) {
  require(places.shape(3) == 2 && xy.shape(1) == 2 && out.shape(1) == 2 && t.shape(0) == xy.shape(0) && out.shape(0) == xy.shape(0), "places have the wrong size");
  for (size_t axis = 0; axis < 3; ++axis) require(places.shape(axis) >= 4 && places.shape(axis) < (size_t(1) << 30), "a table has fewer than 4 nodes in a direction");
  require(table[2] > 0 && table[4] != 0, "a table has no steps");
  nb::gil_scoped_release release;
  sweep_kernels().places({places.data(), int(places.shape(0)), int(places.shape(1)), int(places.shape(2)), table[0], table[1], table[2], table[3], table[4]},
                         xy.data(), t.data(), int64_t(t.shape(0)), out.data());
}

struct Solver {
  Problem q;
  mutable std::unique_ptr<Factor> factor;  // ordered when it is first asked for
  std::vector<double> external;
  bool complete = false, factorised = false;
  int64_t interior_rows = 0;
  bool external_needed = false;

  static void check(bool fine, const char* what) {
    if (!fine) throw std::invalid_argument(what);
  }
  // What is set anew counts from the next set_nodes on.
  void begin() {
    complete = factorised = false;
    factor.reset();
    external.clear();
  }
  void ready() const { check(complete, "the problem is not complete: call set_nodes after set_observations, set_images, set_patterns, set_points"); }
  Factor& ordered() const {
    ready();
    if (!factor) factor = std::make_unique<Factor>(q);
    return *factor;
  }
  const Factor& solved() const {
    ready();
    require(factorised, "the matrix is not factorised: call factorise first, and solve only where it returns 0");
    return *factor;
  }
  static void count(int threads) { check(threads >= 1 && threads <= 4096, "the number of threads is not from 1 to 4096"); }
  State state(const Const& rotation, const Const& centre, const Const& interior, const Const& xyz, double huber, double damping, int threads) const {
    ready();
    count(threads);
    require(rotation.size() == size_t(9 * q.images) && centre.size() == size_t(3 * q.images), "exterior orientations have the wrong size");
    require(xyz.size() == size_t(3 * q.points), "object points have the wrong size");
    require(q.interior_stride == 0 || interior.size() % q.interior_stride == 0, "interior orientations have the wrong size");
    require(interior.size() >= size_t(interior_rows * q.interior_stride), "there are fewer interior orientations than images name");
    require(!external_needed || !external.empty(), "rows of models that are not compiled are missing: call set_external");
    return {rotation.data(), centre.data(), interior.data(), xyz.data(), external.empty() ? nullptr : external.data(), huber, damping};
  }
};

}  // namespace

NB_MODULE(_native, m) {
#ifndef RAYBUNDLE_LEAKS_TOLD
  // What is still alive when the interpreter ends is kept by it, as the frames of a last traceback are; that errors
  // leave nothing behind while it runs is for a test to say (tests/native).
  nb::set_leak_warnings(false);
#endif
  m.doc() = "Compiled kernels: observations, reduced normal matrix, sparse factor, selected inverse.";
  m.def("best_matches", [](Floats a, Floats b) { return best(a, b, imaging_kernels().best); });
  m.def("best_matches_of_bytes", [](ByteRows a, ByteRows b) {
    if (a.shape(1) % 4 || a.shape(1) > kLongestBytes) throw std::invalid_argument("descriptors of bytes have a length that is no multiple of 4, or too large");
    return best(a, b, imaging_kernels().best_bytes);
  });
  m.def("match_windows", &match_windows);
  m.def("fit_dots", &fit_dots);
  m.def("fit_masked_dots", &fit_masked_dots);
  m.def("cover_dots", &cover_dots);
  m.def("fit_corners", &fit_corners);
  m.def("census", &census);
  m.def("sweep_costs", &sweep_costs);
  m.def("aggregate_costs", &aggregate);
  m.def("transfer_places", &transfer_places);
  m.def("refine_surface", &refine_surface, nb::arg(), nb::arg(), nb::arg(), nb::arg(), nb::arg(), nb::arg(), nb::arg(), nb::arg(), nb::arg(),
        nb::arg().none(), nb::arg(), nb::arg(), nb::arg(), nb::arg(), nb::arg(), nb::arg().none(), nb::arg().none());
  m.def("instruction_set", [] { return std::string(kernels().name); });
  m.def("sensor_models", [] {
    std::vector<std::string> names;
    for (const char* name : model_names()) names.emplace_back(name);
    return names;
  });
  m.def("set_dense", [](uint64_t potrf, uint64_t potri, uint64_t trsm, uint64_t syrk, uint64_t gemm) {
    Dense& d = dense();
    d.potrf = reinterpret_cast<decltype(d.potrf)>(potrf);
    d.potri = reinterpret_cast<decltype(d.potri)>(potri);
    d.trsm = reinterpret_cast<decltype(d.trsm)>(trsm);
    d.syrk = reinterpret_cast<decltype(d.syrk)>(syrk);
    d.gemm = reinterpret_cast<decltype(d.gemm)>(gemm);
  });

  nb::class_<Columns>(m, "Columns")
      .def("__init__", [](Columns* c, const std::vector<bool>& is_number) {
        if (is_number.empty() || is_number.size() > 4096) throw std::invalid_argument("the number of columns is not from 1 to 4096");
        new (c) Columns(is_number);
      })
      .def("add", [](Columns& c, nb::bytes rows) { return c.add({rows.c_str(), rows.size()}); })
      .def_prop_ro("rows", &Columns::rows)
      .def("different", [](const Columns& c, size_t column) { return c.text_column(column).texts.size(); })
      .def("number", [](const Columns& c, size_t column) {
        const auto& values = c.number_column(column);
        auto found = array<double>({values.size()});
        std::copy(values.begin(), values.end(), found.data());
        return found;
      })
      .def("text", [](const Columns& c, size_t column) {
        const TextColumn& text = c.text_column(column);
        auto codes = array<int32_t>({text.codes.size()});
        std::copy(text.codes.begin(), text.codes.end(), codes.data());
        std::string texts;  // divided by line ends, which none of them holds
        for (const auto& t : text.texts) (texts += t) += '\n';
        return nb::make_tuple(codes, nb::bytes(texts.data(), texts.size()));
      });

  nb::class_<Solver>(m, "Solver")
      .def(nb::init<>())
      .def("set_observations",
           [](Solver& s, Ints image, Ints point, Const xy, Const whiten, Ints external_row) {
             Problem& q = s.q;
             s.check(image.size() <= INT32_MAX, "too many observations");
             s.check(point.size() == image.size() && xy.size() == 2 * image.size() && whiten.size() == 3 * image.size() &&
                         external_row.size() == image.size(),
                     "observation arrays differ in length");
             s.begin();
             q.observations = int(image.size());
             q.image = copy<int32_t>(image);
             q.point = copy<int32_t>(point);
             q.xy = copy<double>(xy);
             q.whiten = copy<double>(whiten);
             q.external_row = copy<int32_t>(external_row);
           })
      .def("set_images",
           [](Solver& s, Ints model, Ints corrected, Ints interior, Ints pattern, Ints own, Ints shared, Ints parameters, int stride) {
             Problem& q = s.q;
             const size_t n = model.size();
             s.check(corrected.size() == n && interior.size() == n && pattern.size() == n && own.size() == n && shared.size() == n &&
                         parameters.size() == n, "image arrays differ in length");
             s.check(stride >= 0 && stride <= 4096, "the stride of interior orientations is not from 0 to 4096");
             s.begin();
             q.images = int(n);
             q.model = copy<int32_t>(model);
             q.corrected = copy<int32_t>(corrected);
             q.interior = copy<int32_t>(interior);
             q.pattern = copy<int32_t>(pattern);
             q.own_node = copy<int32_t>(own);
             q.shared_node = copy<int32_t>(shared);
             q.parameters = copy<int32_t>(parameters);
             q.interior_stride = stride;
           })
      .def("set_patterns",
           [](Solver& s, const std::vector<std::pair<std::vector<int>, std::vector<int>>>& patterns) {
             s.begin();
             s.q.patterns.clear();
             for (const auto& [own, shared] : patterns) s.q.patterns.push_back({own, shared});
           })
      .def("set_points",
           [](Solver& s, Longs first, Ints node, Bytes held, Const weight, Const value) {
             Problem& q = s.q;
             const size_t p = node.size();
             s.check(first.size() == p + 1 && held.size() == p && weight.size() == 3 * p && value.size() == 3 * p,
                     "point arrays differ in length");
             s.begin();
             q.points = int(p);
             q.first = copy<int64_t>(first);
             q.node_of_point = copy<int32_t>(node);
             q.held = copy<uint8_t>(held);
             q.prior_weight = copy<double>(weight);
             q.prior_value = copy<double>(value);
           })
      .def("set_nodes",
           [](Solver& s, Ints size, const std::vector<std::pair<int32_t, int32_t>>& extra) {
             s.check(!s.complete, "set_nodes orders the problem: set observations, images, patterns and points again before it");
             s.q.nodes = int(size.size());
             s.q.size = copy<int32_t>(size);
             nb::gil_scoped_release release;
             s.q.check(extra);
             s.interior_rows = 0;
             s.external_needed = false;
             for (const int32_t f : s.q.image) {
               s.interior_rows = std::max(s.interior_rows, int64_t(s.q.interior[f]) + 1);
               s.external_needed = s.external_needed || s.q.model[f] < 0;
             }
             s.q.sort_points();
             s.q.build_structure(extra);
             s.complete = true;
           })
      .def("set_held",
           [](Solver& s, Bytes held) {
             s.ready();
             s.check(held.size() == size_t(s.q.points), "point arrays differ in length");
             for (int p = 0; p < s.q.points; ++p) s.q.held[p] = held.data()[s.q.id[p]];
           })
      .def("set_external",
           [](Solver& s, Const rows, Ints touched, int width) {
             s.ready();
             s.check(width <= kMaxParameters, "an image point touches more than 64 parameters of its sensor model");
             s.check(width > 0 && rows.size() % (9 + 2 * width) == 0 && touched.size() == rows.size() / (9 + 2 * width) * width,
                     "rows of models that are not compiled have the wrong size");
             s.external.clear();
             s.q.external_width = width;
             s.q.touched = copy<int32_t>(touched);
             s.q.check_external(rows.size() / (9 + 2 * width));
             s.external = copy<double>(rows);
           })
      .def("block", [](const Solver& s, int a, int b) {
             s.ready();
             if (a < 0 || b < 0 || a >= s.q.nodes || b >= s.q.nodes) throw std::out_of_range("there is no such node");
             return s.q.block(a, b);
           })
      .def("block_start", [](const Solver& s, int64_t k) {
             s.ready();
             if (k < 0 || size_t(k) >= s.q.block_start.size()) throw std::out_of_range("there is no such block");
             return s.q.block_start[k];
           })
      .def("blocks",
           [](const Solver& s) {
             s.ready();
             const size_t count = s.q.block_row.size();
             auto rows = array<int64_t>({count}), cols = array<int64_t>({count}), starts = array<int64_t>({count});
             std::copy(s.q.block_row.begin(), s.q.block_row.end(), rows.data());
             std::copy(s.q.block_col.begin(), s.q.block_col.end(), cols.data());
             std::copy(s.q.block_start.begin(), s.q.block_start.begin() + count, starts.data());
             return nb::make_tuple(rows, cols, starts);
           })
      .def_prop_ro("unknowns", [](const Solver& s) { return s.q.unknowns; })
      .def_prop_ro("values_size", [](const Solver& s) { s.ready(); return s.q.block_start.back(); })
      .def_prop_ro("factor_entries", [](const Solver& s) { return s.ordered().entries(); })
      .def_prop_ro("factor_operations", [](const Solver& s) { return s.ordered().operations(); })
      .def_prop_ro("smallest_pivot", [](const Solver& s) { return s.solved().smallest_pivot(); })
      .def_prop_ro("smallest_pivot_at", [](const Solver& s) { return s.solved().smallest_pivot_at(); })
      .def("pivots", [](const Solver& s, Doubles out) {
             const std::vector<double>& pivots = s.solved().pivots();
             s.check(out.size() == pivots.size(), "pivots have the wrong size");
             std::copy(pivots.begin(), pivots.end(), out.data());
           })
      .def("reduce",
           [](Solver& s, Const R, Const C, Const I, Const X, double huber, double damping, int threads, Doubles values, Doubles right,
              Doubles diagonal) {
             const State state = s.state(R, C, I, X, huber, damping, threads);
             s.check(values.size() == size_t(s.q.block_start.back()) && right.size() == size_t(s.q.unknowns) &&
                         diagonal.size() == size_t(s.q.unknowns), "normal matrix has the wrong size");
             double *v = values.data(), *r = right.data(), *d = diagonal.data();
             Totals t;
             {
               nb::gil_scoped_release release;
               t = kernels().reduce(s.q, state, threads, v, r, d);
             }
             return nb::make_tuple(t.cost, t.behind, t.diverged, t.weak);
           })
      .def("back_substitute",
           [](Solver& s, Const R, Const C, Const I, Const X, double huber, double damping, int threads, Const step, Doubles points) {
             const State state = s.state(R, C, I, X, huber, damping, threads);
             s.check(step.size() == size_t(s.q.unknowns) && points.size() == size_t(3 * s.q.points), "step has the wrong size");
             const double* d = step.data();
             double* p = points.data();
             nb::gil_scoped_release release;
             return kernels().back_substitute(s.q, state, threads, d, p).cost;
           })
      .def("evaluate",
           [](Solver& s, Const R, Const C, Const I, Const X, double huber, int threads, Doubles residuals, Bytes behind) {
             const State state = s.state(R, C, I, X, huber, 0, threads);
             double* v = residuals.size() ? residuals.data() : nullptr;
             uint8_t* b = behind.size() ? behind.data() : nullptr;
             s.check((!v || residuals.size() == size_t(2 * s.q.observations)) && (!b || behind.size() == size_t(s.q.observations)),
                     "residuals have the wrong size");
             Totals t;
             {
               nb::gil_scoped_release release;
               t = kernels().evaluate(s.q, state, threads, v, b);
             }
             return nb::make_tuple(t.cost, t.behind, t.diverged);
           })
      .def("factorise",
           [](Solver& s, Const values, Const added) {
             const Dense& d = dense();
             s.check(d.potrf && d.potri && d.trsm && d.syrk && d.gemm, "dense kernels are not set");
             s.ready();
             s.check(values.size() == size_t(s.q.block_start.back()), "normal matrix has the wrong size");
             s.check(!added.size() || added.size() == size_t(s.q.unknowns), "what is added to the diagonal has the wrong size");
             s.factorised = false;  // what a factorisation that stops has written is no factor, nor is the one before it left
             const double *v = values.data(), *a = added.size() ? added.data() : nullptr;
             int64_t stopped;
             {
               nb::gil_scoped_release release;
               stopped = s.ordered().factorise(v, a);
             }
             s.factorised = stopped == 0;
             return stopped;
           })
      .def("solve",
           [](const Solver& s, Doubles x, int columns) {
             const Factor& factor = s.solved();
             s.check(columns >= 1 && x.size() == size_t(s.q.unknowns) * columns, "right side has the wrong size");
             double* d = x.data();
             nb::gil_scoped_release release;
             factor.solve(d, columns);
           })
      .def("selected_inverse",
           [](const Solver& s, Doubles values) {
             const Factor& factor = s.solved();
             s.check(values.size() == size_t(s.q.block_start.back()), "normal matrix has the wrong size");
             double* v = values.data();
             nb::gil_scoped_release release;
             factor.selected_inverse(v);
           })
      .def("condense",
           [](Solver& s, Const R, Const C, Const I, Const X, int threads, Const given, int columns) {
             const State state = s.state(R, C, I, X, 0, 0, threads);
             s.check(columns >= 1 && columns <= 16 && given.size() == size_t(3 * s.q.points) * columns, "right side has the wrong size");
             Doubles right = make({size_t(s.q.unknowns), size_t(columns)});
             double* r = right.data();
             const double* g = given.data();
             {
               nb::gil_scoped_release release;
               kernels().condense(s.q, state, threads, columns, g, r);
             }
             return right;
           })
      .def("expand",
           [](Solver& s, Const R, Const C, Const I, Const X, int threads, Const nodes, Const given, int columns) {
             const State state = s.state(R, C, I, X, 0, 0, threads);
             s.check(columns >= 1 && columns <= 16 && nodes.size() == size_t(s.q.unknowns) * columns && (!given.size() || given.size() == size_t(3 * s.q.points) * columns),
                     "right side has the wrong size");
             Doubles points = make({size_t(s.q.points), 3, size_t(columns)});
             double* p = points.data();
             const double *n = nodes.data(), *g = given.size() ? given.data() : nullptr;
             {
               nb::gil_scoped_release release;
               kernels().expand(s.q, state, threads, columns, n, g, p);
             }
             return points;
           })
      .def("statistics", [](Solver& s, Const R, Const C, Const I, Const X, int threads, Const inverse, int datum, Const gauge_nodes,
                            Const gauge_given, Const gauge_points, Const gauge_middle) {
        const State state = s.state(R, C, I, X, 0, 0, threads);
        s.check(datum >= 0 && datum <= 7, "a datum has 0 to 7 unknowns");
        const size_t rows = size_t(3 * s.q.points) * datum;
        s.check(inverse.size() == size_t(s.q.block_start.back()), "inverse has the wrong size");
        s.check(gauge_nodes.size() == size_t(s.q.unknowns) * datum && gauge_given.size() == rows && gauge_points.size() == rows &&
                    gauge_middle.size() == size_t(datum) * datum && datum <= 7,
                "datum arrays have the wrong size");
        Doubles cofactor = make({size_t(s.q.points), 3, 3}), hat = make({size_t(s.q.observations), 3}),
                effect = make({size_t(s.q.observations), 3, 2}), point_h = make({size_t(s.q.points), 3, size_t(datum)});
        double *c = cofactor.data(), *h = hat.data(), *e = effect.data(), *p = point_h.data();
        const double *z = inverse.data(), *gn = gauge_nodes.data(), *gg = gauge_given.data(), *gp = gauge_points.data(),
                     *gm = gauge_middle.data();
        {
          nb::gil_scoped_release release;
          kernels().statistics(s.q, state, threads, z, datum, gn, gg, gp, gm, c, h, e, p);
        }
        return nb::make_tuple(cofactor, hat, effect, point_h);
      });
}
