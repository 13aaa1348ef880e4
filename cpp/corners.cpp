// The photometric fit of a corner where four squares meet, compiled once for every instruction set (RB_ARCH); see saddle.py.
#include "corners.hpp"

#include "gauss.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <vector>

namespace raybundle {
namespace RB_ARCH {

constexpr int kN = kCornerUnknowns, kLanes = 8;
constexpr double kSharp = 0.25, kSoft = 6.0;
constexpr double kRoot2 = 1.4142135623730951, kRoot2OverPi = 0.7978845608028654;
enum { CX, CY, A1, A2, BLUR, MEAN, HALF, SX, SY };

// Pixels of a window that count: grey values, offsets from the centre of the pixel of the start.
struct CornerWork {
  std::vector<double> grey, x, y;
  std::vector<double> g1, g2, e1, e2;  // of the two edges
};

static double sign_of(double v) { return double(v > 0) - double(v < 0); }

// False where the window leaves the image or holds too few pixels.
static bool gather(const Grey& g, const double* xy, const double* u, const double* v, const double* band, CornerWork& w) {
  w.grey.clear();
  w.x.clear();
  w.y.clear();
  const double bx = std::floor(xy[0]), by = std::floor(xy[1]), fx = xy[0] - bx - 0.5, fy = xy[1] - by - 0.5;
  double det = u[0] * v[1] - u[1] * v[0];
  if (std::abs(det) < 1e-9) det = 1e-9;
  const double scale = 1 / std::abs(det);
  const double widest = std::max(std::max(std::abs(u[0]), std::abs(u[1])), std::max(std::abs(v[0]), std::abs(v[1])));
  if (!(std::abs(bx) < 1e8 && std::abs(by) < 1e8 && widest < 1e3)) return false;
  const int rx = int(std::ceil(std::abs(u[0]) + std::abs(v[0]))) + 1, ry = int(std::ceil(std::abs(u[1]) + std::abs(v[1]))) + 1;
  bool within = true;
  for (int iy = -ry; iy <= ry; ++iy)
    for (int ix = -rx; ix <= rx; ++ix) {
      const double dx = ix - fx, dy = iy - fy;
      const double a = std::abs(v[1] * dx - v[0] * dy) * scale, b = std::abs(u[0] * dy - u[1] * dx) * scale;
      if (!(a <= 1 && b <= 1 && (a <= band[0] || b <= band[1]))) continue;
      const int px = int(bx) + ix, py = int(by) + iy;
      if (px < 0 || py < 0 || px >= g.width || py >= g.height) {
        within = false;
        continue;
      }
      w.grey.push_back(g.data[int64_t(py) * g.width + px]);
      w.x.push_back(ix);
      w.y.push_back(iy);
    }
  return within && w.grey.size() > size_t(2 * kN);
}

// Approximate unknowns: directions from the arms, levels from the four squares.
static void start_corner(const double* xy, const double* u, const double* v, const CornerWork& w, double* p) {
  std::fill(p, p + kN, 0.0);
  p[CX] = xy[0] - std::floor(xy[0]) - 0.5;
  p[CY] = xy[1] - std::floor(xy[1]) - 0.5;
  const double turn = sign_of(u[0] * v[1] - u[1] * v[0]);
  p[A1] = std::atan2(u[0] * turn, -u[1] * turn);
  p[A2] = std::atan2(-v[0] * turn, v[1] * turn);
  p[BLUR] = 0.8;
  const double c1 = std::cos(p[A1]), q1 = std::sin(p[A1]), c2 = std::cos(p[A2]), q2 = std::sin(p[A2]);
  double up = 0, down = 0;
  int n_up = 0, n_down = 0;
  for (size_t k = 0; k < w.grey.size(); ++k) {
    const double x = w.x[k] - p[CX], y = w.y[k] - p[CY], side = (x * c1 + y * q1) * (x * c2 + y * q2);
    if (side > 0) up += w.grey[k], ++n_up;
    if (side < 0) down += w.grey[k], ++n_down;
  }
  up /= std::max(n_up, 1);
  down /= std::max(n_down, 1);
  p[MEAN] = (up + down) / 2;
  p[HALF] = (up - down) / 2;
}

// Normal equations (lower triangle N, right-hand side b) and sum of squares at p.
static double corner_normals(const double* p, CornerWork& w, double N[kN][kN], double* b) {
  const double c1 = std::cos(p[A1]), q1 = std::sin(p[A1]), c2 = std::cos(p[A2]), q2 = std::sin(p[A2]);
  const double s = p[BLUR], inverse = 1 / (s * kRoot2), k = p[HALF] * kRoot2OverPi / s;
  const int count = int(w.grey.size());
  for (auto* a : {&w.g1, &w.g2, &w.e1, &w.e2}) a->resize(count);
  const double *xs = w.x.data(), *ys = w.y.data(), *greys = w.grey.data();
  double *g1s = w.g1.data(), *g2s = w.g2.data(), *e1s = w.e1.data(), *e2s = w.e2.data();
  const double cx = p[CX], cy = p[CY];
  for (int n = 0; n < count; ++n) {
    const double x = xs[n] - cx, y = ys[n] - cy;
    gauss_erf((x * c1 + y * q1) * inverse, g1s[n], e1s[n]);
    gauss_erf((x * c2 + y * q2) * inverse, g2s[n], e2s[n]);
  }
  // sums of products, kLanes pixels at a time; the last row is the misclosure
  double sums[kN + 1][kN + 1][kLanes] = {}, J[kN + 1][kLanes];
  for (int first = 0; first < count; first += kLanes) {
    const int here = std::min(kLanes, count - first);
    if (here < kLanes) std::memset(J, 0, sizeof J);
    for (int l = 0; l < here; ++l) {
      const int n = first + l;
      const double x = xs[n] - cx, y = ys[n] - cy, d1 = x * c1 + y * q1, d2 = x * c2 + y * q2;
      const double g1 = k * g1s[n] * e2s[n], g2 = k * g2s[n] * e1s[n], both = e1s[n] * e2s[n];
      J[CX][l] = -(g1 * c1 + g2 * c2);
      J[CY][l] = -(g1 * q1 + g2 * q2);
      J[A1][l] = g1 * (y * c1 - x * q1);
      J[A2][l] = g2 * (y * c2 - x * q2);
      J[BLUR][l] = -(g1 * d1 + g2 * d2) / s;
      J[MEAN][l] = 1;
      J[HALF][l] = both;
      J[SX][l] = x;
      J[SY][l] = y;
      J[kN][l] = greys[n] - p[MEAN] - p[HALF] * both - p[SX] * x - p[SY] * y;
    }
    for (int i = 0; i <= kN; ++i)
      for (int j = 0; j <= i; ++j)
        for (int l = 0; l < kLanes; ++l) sums[i][j][l] += J[i][l] * J[j][l];
  }
  const auto total = [&sums](int i, int j) {
    double sum = 0;
    for (double v : sums[i][j]) sum += v;
    return sum;
  };
  for (int i = 0; i < kN; ++i) {
    b[i] = total(kN, i);
    for (int j = 0; j <= i; ++j) N[i][j] = total(i, j);
  }
  return total(kN, kN);
}

// L L' in place (lower triangle); false where the matrix is not positive definite.
static bool corner_cholesky(double N[kN][kN]) {
  for (int i = 0; i < kN; ++i)
    for (int j = 0; j <= i; ++j) {
      double sum = N[i][j];
      for (int k = 0; k < j; ++k) sum -= N[i][k] * N[j][k];
      if (i != j) {
        N[i][j] = sum / N[j][j];
      } else {
        if (!(sum > 0)) return false;
        N[i][i] = std::sqrt(sum);
      }
    }
  return true;
}

static void corner_solve(const double L[kN][kN], double* b) {
  for (int i = 0; i < kN; ++i) {
    for (int k = 0; k < i; ++k) b[i] -= L[i][k] * b[k];
    b[i] /= L[i][i];
  }
  for (int i = kN - 1; i >= 0; --i) {
    for (int k = i + 1; k < kN; ++k) b[i] -= L[k][i] * b[k];
    b[i] /= L[i][i];
  }
}

// Levenberg and Marquardt; whether the iteration came to its end.
static bool iterate_corner(CornerWork& w, int iterations, double half, double* p, double N[kN][kN], double& square) {
  double b[kN], damping = 1e-3;
  square = corner_normals(p, w, N, b);
  for (int iteration = 0; iteration < iterations && damping <= 1e6; ++iteration) {
    double L[kN][kN], d[kN], scale[kN], next[kN], Nn[kN][kN], bn[kN];
    for (int i = 0; i < kN; ++i) scale[i] = std::sqrt(std::max(N[i][i], 1e-12));
    for (int i = 0; i < kN; ++i) {
      d[i] = b[i] / scale[i];
      for (int j = 0; j <= i; ++j) L[i][j] = N[i][j] / (scale[i] * scale[j]);
      L[i][i] += damping + 1e-9;
    }
    if (p[BLUR] <= kSharp && b[BLUR] < 0) L[BLUR][BLUR] += 1e9;  // the least blur allowed is held
    if (!corner_cholesky(L)) {
      damping *= 10;
      continue;
    }
    corner_solve(L, d);
    const double limit[5] = {half / 2, half / 2, 0.3, 0.3, p[BLUR] / 2};
    double shorten = 1;
    for (int i = 0; i < kN; ++i) d[i] /= scale[i];
    for (int i = 0; i < 5; ++i) shorten = std::min(shorten, limit[i] / std::max(std::abs(d[i]), 1e-12));
    for (int i = 0; i < kN; ++i) next[i] = p[i] + (d[i] *= shorten);
    next[BLUR] = std::min(std::max(next[BLUR], kSharp), kSoft);
    const double square_next = corner_normals(next, w, Nn, bn);
    if (!(square_next <= square * (1 + 1e-9))) {
      damping *= 10;
      continue;
    }
    std::memcpy(p, next, sizeof next);
    std::memcpy(N, Nn, sizeof Nn);
    std::memcpy(b, bn, sizeof bn);
    square = square_next;
    damping = std::max(damping / 10, 1e-7);
    if (std::hypot(d[CX], d[CY]) < 1e-3) return true;  // the next step would be its square
  }
  return false;
}

// Cofactors of the corner; false where an unknown is not felt at all.
static bool corner_cofactor(double N[kN][kN], double* cofactor) {
  double scale[kN];
  for (int i = 0; i < kN; ++i) {
    scale[i] = std::sqrt(N[i][i]);
    if (!(scale[i] > 1e-6)) return false;
  }
  for (int i = 0; i < kN; ++i) {
    for (int j = 0; j <= i; ++j) N[i][j] /= scale[i] * scale[j];
    N[i][i] += 1e-12;
  }
  if (!corner_cholesky(N)) return false;
  for (int k = 0; k < 2; ++k) {
    double unit[kN] = {};
    unit[k] = 1;
    corner_solve(N, unit);
    cofactor[k] = unit[k] / (scale[k] * scale[k]);
    if (k == 1) cofactor[2] = unit[0] / (scale[0] * scale[1]);
  }
  return true;
}

static void fit_corners(const Grey& image, int iterations, double least, int begin, int end, const double* xy, const double* u,
                        const double* v, const double* band, const double* half, double* values, double* cofactor, double* variance,
                        uint8_t* ended) {
  CornerWork w;
  for (int n = begin; n < end; ++n) {
    double N[kN][kN], square = 0, *p = values + kN * n;
    const bool whole = gather(image, xy + 2 * n, u + 2 * n, v + 2 * n, band + 2 * n, w);
    start_corner(xy + 2 * n, u + 2 * n, v + 2 * n, w, p);
    ended[n] = 0;
    if (whole && std::abs(p[HALF]) > least) {
      ended[n] = iterate_corner(w, iterations, half[n], p, N, square) && corner_cofactor(N, cofactor + 3 * n);
    }
    variance[n] = std::max(square / std::max(1.0, double(w.grey.size()) - kN), 1.0 / 12);
  }
}

extern const CornerKernels corners;
const CornerKernels corners = {&fit_corners};

}  // namespace RB_ARCH
}  // namespace raybundle
