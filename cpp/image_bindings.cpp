// Python bindings of kernels on image contents: features, descriptors, windows, dots, corners.
#include <algorithm>
#include <cmath>

#include "bindings.hpp"
#include "corners.hpp"
#include "features.hpp"
#include "imaging.hpp"
#include "targets.hpp"

using namespace raybundle;

namespace {

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
                        int iterations, double step, double reach, double loose, bool spline, bool quadratic) {
  const size_t n = xy_reference.size() / 2;
  if (xy_start.size() != 2 * n || affine_start.size() != 4 * n) throw std::invalid_argument("windows have the wrong size");
  if (xy_reference.size() % 2 || half < 2 || half > kLargestHalf) throw std::invalid_argument("half a window is not from 2 to 256 pixels");
  auto xy = make({n, 2}), affine = make({n, 2, 2}), bend = make({n, 2, 3}), covariance = make({n, 3}), correlation = make({n});
  auto residual = make({n, size_t(kResidual)});
  auto outcome = array<int32_t>({n});
  std::fill_n(residual.data(), kResidual * n, 0.0);
  std::fill_n(bend.data(), 6 * n, 0.0);
  std::copy_n(xy_start.data(), 2 * n, xy.data());
  std::copy_n(affine_start.data(), 4 * n, affine.data());
  const Grey from{reference.data(), int(reference.shape(1)), int(reference.shape(0))};
  const Grey to{target.data(), int(target.shape(1)), int(target.shape(0))};
  const double* c = xy_reference.data();
  double *p = xy.data(), *B = affine.data(), *C = bend.data(), *Q = covariance.data(), *r = correlation.data(), *e = residual.data();
  int32_t* o = outcome.data();
  {
    nb::gil_scoped_release release;
    imaging_kernels().match(from, to, {half, sigma, iterations, step, reach, loose, spline, quadratic}, 0, int(n), c, p, B, C, Q, r, e, o);
  }
  return nb::make_tuple(xy, affine, bend, covariance, correlation, residual, outcome);
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

constexpr size_t kLongestSide = 1 << 23, kMostPixels = 1u << 31;  // a float holds every place, 32 bits every pixel

// Of each extremum: x and y in the pixel frame of the image, scale [px], strength [grey levels].
Doubles table_of(const ScaleSpace& space) {
  auto table = make({space.extrema.size(), 4});
  double* t = table.data();
  for (const Extremum& e : space.extrema) {
    const double pixel = space.levels[size_t(e.level)].pixel;
    *t++ = e.x * pixel + 0.5, *t++ = e.y * pixel + 0.5, *t++ = e.sigma * pixel, *t++ = e.strength;
  }
  return table;
}

ScaleSpace* search_features(ByteRows grey, double least, bool doubled) {
  if (grey.shape(0) > kLongestSide || grey.shape(1) > kLongestSide || grey.size() >= kMostPixels || !(least > 0)) throw std::invalid_argument("an image is too large, or no limit is given");
  nb::gil_scoped_release release;
  auto found = std::make_unique<ScaleSpace>();
  feature_kernels().search(grey.data(), int(grey.shape(1)), int(grey.shape(0)), float(least), doubled, *found);
  return found.release();
}

void check_chosen(const ScaleSpace& space, const Longs& chosen) {
  for (size_t i = 0; i < chosen.size(); ++i)
    if (chosen.data()[i] < 0 || size_t(chosen.data()[i]) >= space.extrema.size()) throw std::invalid_argument("there is no such extremum");
}

nb::tuple orient_features(const ScaleSpace& space, Longs chosen) {
  check_chosen(space, chosen);
  std::vector<int64_t> owner;
  std::vector<double> angle;
  {
    nb::gil_scoped_release release;
    feature_kernels().orient(space, chosen.data(), int64_t(chosen.size()), owner, angle);
  }
  auto o = array<int64_t>({owner.size()});
  auto a = make({angle.size()});
  std::copy(owner.begin(), owner.end(), o.data());
  std::copy(angle.begin(), angle.end(), a.data());
  return nb::make_tuple(o, a);
}

Bytes describe_features(const ScaleSpace& space, Longs chosen, Const angle) {
  check_chosen(space, chosen);
  const double* a = angle.data();
  if (angle.size() != chosen.size() || !std::all_of(a, a + angle.size(), [](double v) { return std::abs(v) <= 7; }))
    throw std::invalid_argument("not as many directions as extrema, or directions beyond a turn");
  auto descriptors = array<uint8_t>({chosen.size(), size_t(kDescriptor)});
  uint8_t* d = descriptors.data();
  {
    nb::gil_scoped_release release;
    feature_kernels().describe(space, chosen.data(), a, int64_t(chosen.size()), d);
  }
  return descriptors;
}

}  // namespace

void bind_images(nb::module_& m) {
  nb::class_<ScaleSpace>(m, "ScaleSpace").def("table", &table_of).def("orient", &orient_features).def("describe", &describe_features);
  m.def("search_features", &search_features);
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
}
