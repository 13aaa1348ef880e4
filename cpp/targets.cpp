// The photometric fit of a dot, compiled once for every instruction set (RB_ARCH).
//
// The image of a disc blurred by a Gaussian is an integral along its edge (Green's theorem), and so are its derivatives:
// for edge points r(t) with r' = (dx, dy) and Phi, phi of mean r and standard deviation s,
//   f = sum Phi(x) phi(y) dy,   df/dp = sum phi(x) phi(y) (dr/dp x r').
// The trapezoidal rule is exact to rounding on a closed smooth curve, and the sums separate into rows and columns.
#include "targets.hpp"

#include "gauss.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <vector>

namespace raybundle {
namespace RB_ARCH {

constexpr int kU = kDotUnknowns;
constexpr double kFar = 5.5;          // standard deviations beyond which an edge is not felt
constexpr double kNodes = 1.1;        // largest distance of edge points, in standard deviations
constexpr double kSharpest = 0.3, kSoftest = 12.0;
constexpr int kSectors = 32;
constexpr int kPasses = 2;            // the window follows the fitted ellipse once
enum { X0, Y0, A, B, D, S, GROUND, CONTRAST, GX, GY };

struct DotWork {
  int x0 = 0, x1 = 0, y0 = 0, y1 = 0;   // pixels of the window, ends excluded
  std::vector<int> left, right;         // of each row
  std::vector<double> co, si, rx, ry, dx, dy, P, E, sums, steps;
  std::vector<int> from, to;            // columns at which a piece of the edge is felt
  std::vector<double> e, J;             // of each pixel of the box: residual, derivatives of the model
  const uint8_t* free = nullptr;        // of each pixel of the box, where not all of them take part
  int nodes = 0, count = 0;
};

// Pixels whose centres lie within `window` radii of the ellipse; false where they leave the image.
static bool place_window(const Grey& g, const double* v, double window, DotWork& w) {
  const double c11 = v[A] * v[A], c22 = v[B] * v[B] + v[D] * v[D];
  const double hx = window * std::sqrt(c11), hy = window * std::sqrt(c22);
  if (!(v[X0] - hx > 0 && v[Y0] - hy > 0 && v[X0] + hx < g.width && v[Y0] + hy < g.height)) return false;
  w.y0 = int(std::ceil(v[Y0] - hy - 0.5));
  w.y1 = int(std::floor(v[Y0] + hy - 0.5)) + 1;
  w.left.resize(std::max(0, w.y1 - w.y0));
  w.right.resize(w.left.size());
  w.x0 = g.width;
  w.x1 = 0;
  w.count = 0;
  for (int y = w.y0; y < w.y1; ++y) {
    // L^-1 (x, y): p = x / a, q = (y - b p) / d
    const double q = y + 0.5 - v[Y0];
    // p^2 + (q - b p)^2 / d^2 <= window^2
    const double aa = 1 + v[B] * v[B] / (v[D] * v[D]), bb = -v[B] * q / (v[D] * v[D]), cc = q * q / (v[D] * v[D]) - window * window;
    const double root = bb * bb - aa * cc;
    int l = 0, r = 0;
    if (root > 0) {
      l = int(std::ceil(v[X0] + v[A] * (-bb - std::sqrt(root)) / aa - 0.5));
      r = int(std::floor(v[X0] + v[A] * (-bb + std::sqrt(root)) / aa - 0.5)) + 1;
      l = std::max(l, 0);
      r = std::min(r, g.width);
    }
    if (r <= l) l = r = 0;
    w.left[y - w.y0] = l;
    w.right[y - w.y0] = r;
    if (r > l) {
      w.x0 = std::min(w.x0, l);
      w.x1 = std::max(w.x1, r);
      w.count += r - l;
    }
  }
  return w.count > 0;
}

// Ground and contrast for a start: means of the outermost and the innermost pixels.
static void start_levels(const Grey& g, double window, double* v, const DotWork& w) {
  double in = 0, out = 0;
  int n_in = 0, n_out = 0;
  const double limit = 0.5 * (1 + window);
  for (int y = w.y0; y < w.y1; ++y)
    for (int x = w.left[y - w.y0]; x < w.right[y - w.y0]; ++x) {
      const double p = (x + 0.5 - v[X0]) / v[A], q = (y + 0.5 - v[Y0] - v[B] * p) / v[D], r2 = p * p + q * q;
      const double grey = g.data[int64_t(y) * g.width + x];
      if (r2 < 0.36) in += grey, ++n_in;
      if (r2 > limit * limit) out += grey, ++n_out;
    }
  v[GROUND] = n_out ? out / n_out : 0;
  v[CONTRAST] = (n_in ? in / n_in : 0) - v[GROUND];
}

// Normal equations (lower triangle N, right-hand side b) and sum of squares at v.
static double evaluate(const Grey& g, const double* v, DotWork& w, double N[kU][kU], double* b) {
  constexpr double kRoot2Pi = 2.5066282746310002, kRoot2 = 1.4142135623730951, kPi = 3.141592653589793;
  const double s = v[S];
  const double trace = v[A] * v[A] + v[B] * v[B] + v[D] * v[D], det = v[A] * v[D];
  const double major = std::sqrt(0.5 * (trace + std::sqrt(std::max(0.0, trace * trace - 4 * det * det))));
  const int n = w.nodes = std::max(24, int(std::ceil(2 * kPi * major / (kNodes * s))));
  const int width = w.x1 - w.x0;
  for (auto* a : {&w.co, &w.si, &w.rx, &w.ry, &w.dx, &w.dy}) a->resize(n);
  w.from.resize(n);
  w.to.resize(n);
  w.steps.resize(width + 1);
  w.P.resize(size_t(n) * width);
  w.E.resize(size_t(n) * width);
  w.e.resize(size_t(w.y1 - w.y0) * width);
  w.J.resize(size_t(kU) * w.e.size());
  w.sums.resize(size_t(7) * width);
  const double step = 2 * kPi / n;
  for (int k = 0; k < n; ++k) {
    const double c = w.co[k] = std::cos((k + 0.5) * step), q = w.si[k] = std::sin((k + 0.5) * step);
    w.rx[k] = v[A] * c;
    w.ry[k] = v[B] * c + v[D] * q;
    w.dx[k] = -v[A] * q * step;
    w.dy[k] = (-v[B] * q + v[D] * c) * step;
    // left of `from` all of the edge lies to the right, from `to` on nothing of it is felt
    const double at = w.rx[k] - (w.x0 + 0.5 - v[X0]);
    const int from = w.from[k] = std::clamp(int(std::ceil(at - kFar * s)), 0, width);
    const int to = w.to[k] = std::clamp(int(std::floor(at + kFar * s)) + 1, from, width);
    double *P = w.P.data() + size_t(k) * width, *E = w.E.data() + size_t(k) * width;
    const double inverse = 1 / (s * kRoot2), unit = 1 / (s * kRoot2Pi);
    for (int x = from; x < to; ++x) {
      double gauss, erf;
      gauss_erf((at - x) * inverse, gauss, erf);
      P[x] = 0.5 + 0.5 * erf;
      E[x] = gauss * unit;
    }
  }
  for (int i = 0; i < kU; ++i) {
    b[i] = 0;
    for (int j = 0; j < kU; ++j) N[i][j] = 0;
  }
  double square = 0;
  for (int y = w.y0; y < w.y1; ++y) {
    const int l = w.left[y - w.y0] - w.x0, r = w.right[y - w.y0] - w.x0;
    if (r <= l) continue;
    const double v_ = y + 0.5 - v[Y0];
    double* sums[7];
    for (int i = 0; i < 7; ++i) {
      sums[i] = w.sums.data() + size_t(i) * width;
      std::fill(sums[i] + l, sums[i] + r, 0.0);
    }
    std::fill(w.steps.begin(), w.steps.end(), 0.0);
    double *f = sums[0], *s1 = sums[1], *s2 = sums[2], *s3 = sums[3], *s4 = sums[4], *s5 = sums[5], *s6 = sums[6];
    for (int k = 0; k < n; ++k) {
      const double t = (w.ry[k] - v_) / s;
      if (std::abs(t) >= kFar) continue;
      const double e = std::exp(-0.5 * t * t) / (s * kRoot2Pi);
      const double u = e * w.dy[k], o = -e * w.dx[k], ua = u * w.co[k], ob = o * w.co[k], od = o * w.si[k];
      const double m = u * w.rx[k] + o * w.ry[k];
      const double *P = w.P.data() + size_t(k) * width, *E = w.E.data() + size_t(k) * width;
      const int from = std::max(l, w.from[k]), to = std::min(r, w.to[k]);
      w.steps[std::min(w.from[k], r)] += u;  // 1 in all columns before
      for (int x = from; x < to; ++x) {
        f[x] += u * P[x];
        s1[x] += u * E[x];
        s2[x] += o * E[x];
        s3[x] += ua * E[x];
        s4[x] += ob * E[x];
        s5[x] += od * E[x];
        s6[x] += m * E[x];
      }
    }
    double before = 0;
    for (int x = width; x >= l; --x) {
      if (x < r) f[x] += before;
      before += w.steps[x];
    }
    const uint16_t* row = g.data + int64_t(y) * g.width + w.x0;
    double *row_e = w.e.data() + size_t(y - w.y0) * width, *row_J = w.J.data() + size_t(kU) * (y - w.y0) * width;
    const uint8_t* row_free = w.free ? w.free + size_t(y - w.y0) * width : nullptr;
    for (int x = l; x < r; ++x) {
      const double u_ = w.x0 + x + 0.5 - v[X0];
      const double light = 1 + v[GX] * u_ + v[GY] * v_, level = v[GROUND] + v[CONTRAST] * f[x], k = v[CONTRAST] * light;
      double* J = row_J + kU * x;
      J[X0] = k * s1[x] - level * v[GX];
      J[Y0] = k * s2[x] - level * v[GY];
      J[A] = k * s3[x];
      J[B] = k * s4[x];
      J[D] = k * s5[x];
      J[S] = -k * (s6[x] - u_ * s1[x] - v_ * s2[x]) / s;
      J[GROUND] = light;
      J[CONTRAST] = light * f[x];
      J[GX] = level * u_;
      J[GY] = level * v_;
      const double e = row_e[x] = row[x] - level * light;
      if (row_free && !row_free[x]) continue;
      square += e * e;
      for (int i = 0; i < kU; ++i) {
        b[i] += J[i] * e;
        for (int j = 0; j <= i; ++j) N[i][j] += J[i] * J[j];
      }
    }
  }
  return square;
}

// L L' = N scaled to a unit diagonal (lower triangle, in place); false where N is not positive definite beyond rounding.
static bool dot_cholesky(double N[kU][kU], double* scale) {
  for (int i = 0; i < kU; ++i) {
    if (!(N[i][i] > 0)) return false;
    scale[i] = 1 / std::sqrt(N[i][i]);
  }
  for (int i = 0; i < kU; ++i)
    for (int j = 0; j <= i; ++j) {
      double sum = N[i][j] * scale[i] * scale[j];
      for (int k = 0; k < j; ++k) sum -= N[i][k] * N[j][k];
      if (i == j) {
        if (!(sum > 1e-11)) return false;
        N[i][i] = std::sqrt(sum);
      } else {
        N[i][j] = sum / N[j][j];
      }
    }
  return true;
}

static void dot_solve(const double L[kU][kU], const double* scale, double* b) {
  for (int i = 0; i < kU; ++i) {
    b[i] *= scale[i];
    for (int k = 0; k < i; ++k) b[i] -= L[i][k] * b[k];
    b[i] /= L[i][i];
  }
  for (int i = kU - 1; i >= 0; --i) {
    for (int k = i + 1; k < kU; ++k) b[i] -= L[k][i] * b[k];
    b[i] /= L[i][i];
  }
  for (int i = 0; i < kU; ++i) b[i] *= scale[i];
}

// Levenberg and Marquardt within one window.  On success N holds the factor and `variance` that of a grey value.
static DotOutcome iterate(const Grey& g, const DotFit& fit, double step, double* v, DotWork& w, double N[kU][kU], double* scale,
                          double& variance) {
  double b[kU], next[kU], Nn[kU][kU], bn[kU], damping = 1e-3;
  double square = evaluate(g, v, w, N, b);
  const double freedom = std::max(1, w.count - kU);
  for (int iteration = 0; iteration < fit.iterations; ++iteration) {
    variance = std::max(square / freedom, 1.0 / 12);
    const double prior = variance / (fit.slope * fit.slope);
    double L[kU][kU], d[kU];
    std::memcpy(L, N, sizeof L);
    std::memcpy(d, b, sizeof d);
    for (int i : {GX, GY}) {
      L[i][i] += prior;
      d[i] -= prior * v[i];
    }
    for (int i = 0; i < kU; ++i) L[i][i] *= 1 + damping;
    if (!dot_cholesky(L, scale)) return dot_flat;
    dot_solve(L, scale, d);
    const double minor = std::min(v[A], v[D]);
    double shorten = 1;
    for (int i : {X0, Y0, A, B, D}) shorten = std::min(shorten, 0.4 * minor / std::max(std::abs(d[i]), 1e-12));
    shorten = std::min(shorten, 0.5 * v[S] / std::max(std::abs(d[S]), 1e-12));
    for (int i = 0; i < kU; ++i) next[i] = v[i] + shorten * d[i];
    next[S] = std::min(std::max(next[S], kSharpest), kSoftest);
    const double before = square + prior * (v[GX] * v[GX] + v[GY] * v[GY]);
    const double square_next = evaluate(g, next, w, Nn, bn);
    const double after = square_next + prior * (next[GX] * next[GX] + next[GY] * next[GY]);
    const double shift = std::hypot(next[X0] - v[X0], next[Y0] - v[Y0]);
    const double growth = std::max({std::abs(next[A] - v[A]), std::abs(next[B] - v[B]), std::abs(next[D] - v[D])});
    if (!(after <= before * (1 + 1e-6))) {
      damping *= 10;
      if (!(damping < 1e8)) return dot_unsteady;
      continue;
    }
    std::memcpy(v, next, sizeof next);
    std::memcpy(N, Nn, sizeof Nn);
    std::memcpy(b, bn, sizeof bn);
    square = square_next;
    if (shift < step && growth < 10 * step && damping < 1e-2) {
      variance = std::max(square / freedom, 1.0 / 12);
      for (int i : {GX, GY}) N[i][i] += variance / (fit.slope * fit.slope);
      return dot_cholesky(N, scale) ? dot_measured : dot_flat;
    }
    damping = std::max(damping * 0.1, 1e-9);
  }
  return dot_unsteady;
}

// Normal deviate of a sum of squares of n standard normal deviates.  Wilson, Hilferty 1931.
static double chi_deviate(double square, double n) { return (std::cbrt(square / n) - (1 - 2 / (9 * n))) / std::sqrt(2 / (9 * n)); }

static double median(double* a, int n) {
  std::nth_element(a, a + n / 2, a + n);
  return n % 2 ? a[n / 2] : 0.5 * (*std::max_element(a, a + n / 2) + a[n / 2]);
}

#include "covered.inl"

// Signs of something that lies on a dot, from the residuals of the last evaluation and the factor of the normal equations:
// see centre.doubts_of.
static void doubts_of(const double* v, const DotWork& w, const double N[kU][kU], const double* scale, std::vector<double>& differences,
                      double* doubt) {
  constexpr double kTurn = 6.283185307179586;
  EdgeSums edge;
  double ee[kSectors] = {}, count[kSectors] = {}, Q[kU][kU];
  for (int i = 0; i < kU; ++i) {
    std::fill(Q[i], Q[i] + kU, 0.0);
    Q[i][i] = 1;
    dot_solve(N, scale, Q[i]);
  }
  const int width = w.x1 - w.x0;
  double total = 0;
  differences.clear();
  for (int y = w.y0; y < w.y1; ++y) {
    const int l = w.left[y - w.y0], r = w.right[y - w.y0];
    const int below_l = y + 1 < w.y1 ? w.left[y + 1 - w.y0] : 0, below_r = y + 1 < w.y1 ? w.right[y + 1 - w.y0] : 0;
    for (int x = l; x < r; ++x) {
      const size_t i = size_t(y - w.y0) * width + x - w.x0;
      const double* J = w.J.data() + kU * i;
      const double e = w.e[i], h = v[A] * J[A] + v[B] * J[B] + v[D] * J[D];
      const double p = (x + 0.5 - v[X0]) / v[A], q = (y + 0.5 - v[Y0] - v[B] * p) / v[D];
      const double turn = std::atan2(q, p) / kTurn;
      const int k = std::clamp(int((turn < 0 ? turn + 1 : turn) * kSectors), 0, kSectors - 1);
      edge.add(k, h, e, J);
      ee[k] += e * e, count[k] += 1;
      total += e * e;
      if (x + 1 < r) differences.push_back(std::abs(w.e[i + 1] - e));
      if (x >= below_l && x < below_r) differences.push_back(std::abs(w.e[i + width] - e));
    }
  }
  double sorted[kSectors], square[kSectors], most = 0;
  int n = 0;
  for (int k = 0; k < kSectors; ++k) {
    const int l = (k + 1) % kSectors;
    if (count[k] + count[l] > 0) sorted[n++] = (ee[k] + ee[l]) / (count[k] + count[l]);
  }
  const double variance = n ? std::max(median(sorted, n), kRoundingVariance) : kRoundingVariance;
  n = 0;
  for (int k = 0; k < kSectors; ++k) {
    const int l = (k + 1) % kSectors;
    if (count[k] + count[l] > 0) square[n++] = chi_deviate((ee[k] + ee[l]) / variance, count[k] + count[l]);
  }
  doubt[0] = doubt[1] = 0;
  if (n) {
    most = *std::max_element(square, square + n);
    for (int k = 0; k < n; ++k) sorted[k] = std::abs(square[k]);
    doubt[1] = most / std::max(1.0, median(sorted, n) / kNormalMedian);
  }
  // shifts of parts of the edge: see centre.edge_shifts
  most = 0;
  for (int m : kPartWidths)
    for (int k = 0; k < kSectors; ++k) most = std::max(most, edge.deviate(Q[0], m, k, -1));
  double noise = std::sqrt(kRoundingVariance);
  if (!differences.empty()) noise = std::max(noise, median(differences.data(), int(differences.size())) / (kNormalMedian * std::sqrt(2.0)));
  doubt[2] = std::sqrt(std::max(total / w.count, kRoundingVariance)) / noise;
  doubt[0] = most / std::sqrt(variance) / std::max(1.0, doubt[2]);
}

static DotOutcome fit_dot(const Grey& g, const DotFit& fit, double window, double* v, double* covariance, double& residual, double* doubt,
                          DotWork& w) {
  doubt[0] = doubt[1] = 0;
  doubt[2] = 1;
  const double start[2] = {v[X0], v[Y0]}, minor = std::min(v[A], v[D]);
  if (!(minor > 0.5)) return dot_flat;
  // no dot is larger than its image, and no window much larger than its dot
  const double largest = std::max(std::abs(v[A]), std::max(std::abs(v[B]), std::abs(v[D])));
  if (!(window > 0 && window < 1e3 && largest < 4.0 * std::max(g.width, g.height))) return dot_outside;
  double N[kU][kU], scale[kU], variance = 0;
  for (int pass = 0; pass < kPasses; ++pass) {
    if (!place_window(g, v, window, w)) return dot_outside;
    if (w.count < 2 * kU) return dot_flat;
    if (pass == 0) {
      start_levels(g, window, v, w);
      if (!(std::abs(v[CONTRAST]) > 1)) return dot_flat;
      v[S] = 0.8;
      v[GX] = v[GY] = 0;
    }
    const DotOutcome outcome = iterate(g, fit, pass + 1 < kPasses ? 0.02 : fit.step, v, w, N, scale, variance);
    if (outcome != dot_measured) return outcome;
    if (!(std::min(v[A], v[D]) > 0.5)) return dot_flat;
    if (std::hypot(v[X0] - start[0], v[Y0] - start[1]) > fit.reach * minor) return dot_moved;
  }
  residual = std::sqrt(variance);
  doubts_of(v, w, N, scale, w.sums, doubt);
  for (int k = 0; k < 2; ++k) {
    double unit[kU] = {};
    unit[k] = 1;
    dot_solve(N, scale, unit);
    covariance[k] = variance * unit[k];
    covariance[2] = variance * unit[0];
  }
  return dot_measured;
}

static void fit_dots(const Grey& image, const DotFit& fit, int begin, int end, const double* window, double* values, double* covariance,
                     double* residual, double* doubts, int32_t* outcome) {
  DotWork work;
  for (int n = begin; n < end; ++n)
    outcome[n] = fit_dot(image, fit, window[n], values + kU * n, covariance + 3 * n, residual[n], doubts + kDotDoubts * n, work);
}

// One pass with the pixels that take part given.
static DotOutcome fit_masked_dot(const Grey& g, const DotFit& fit, double* v, double* covariance, double& residual, DotWork& w) {
  const double largest = std::max({std::abs(v[A]), std::abs(v[B]), std::abs(v[D])});
  if (!(std::min(v[A], v[D]) > 0.5 && v[S] >= kSharpest && v[S] <= kSoftest && w.count >= 2 * kU)) return dot_flat;
  const double side = std::max(g.width, g.height);
  if (!(largest < 4 * side && std::abs(v[X0]) < 4 * side && std::abs(v[Y0]) < 4 * side)) return dot_outside;
  for (int i = GROUND; i < kU; ++i)
    if (!std::isfinite(v[i])) return dot_flat;
  const double start[2] = {v[X0], v[Y0]}, minor = std::min(v[A], v[D]);
  double N[kU][kU], scale[kU], variance = 0;
  const DotOutcome outcome = iterate(g, fit, fit.step, v, w, N, scale, variance);
  if (outcome != dot_measured) return outcome;
  if (!(std::min(v[A], v[D]) > 0.5)) return dot_flat;
  if (std::hypot(v[X0] - start[0], v[Y0] - start[1]) > fit.reach * minor) return dot_moved;
  residual = std::sqrt(variance);
  for (int k = 0; k < kU; ++k) {
    double* unit = covariance + kU * k;
    std::fill(unit, unit + kU, 0.0);
    unit[k] = 1;
    dot_solve(N, scale, unit);
    for (int i = 0; i < kU; ++i) unit[i] *= variance;
  }
  return dot_measured;
}

static void fit_masked(const Grey& image, const DotFit& fit, int begin, int end, const DotMasks& masks, double* values,
                       double* covariance, double* residual, int32_t* outcome) {
  DotWork w;
  for (int n = begin; n < end; ++n) {
    const int32_t* box = masks.box + 4 * n;
    w.x0 = box[0], w.y0 = box[1], w.x1 = box[2], w.y1 = box[3];
    const size_t size = size_t(masks.offset[n + 1] - masks.offset[n]);
    w.free = masks.free + masks.offset[n];
    w.left.assign(w.y1 - w.y0, w.x0);
    w.right.assign(w.y1 - w.y0, w.x1);
    w.count = int(std::count_if(w.free, w.free + size, [](uint8_t f) { return f != 0; }));
    w.e.assign(size, 0.0);
    w.J.assign(kU * size, 0.0);
    outcome[n] = fit_masked_dot(image, fit, values + kU * n, covariance + kU * kU * n, residual[n], w);
    std::copy_n(w.e.data(), size, masks.residuals + masks.offset[n]);
    std::copy_n(w.J.data(), kU * size, masks.derivatives + kU * masks.offset[n]);
  }
}

extern const TargetKernels targets;
const TargetKernels targets = {&fit_dots, &fit_masked, &cover_dots};

}  // namespace RB_ARCH
}  // namespace raybundle
