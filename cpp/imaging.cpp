// Descriptor matching and least-squares matching, compiled once for every instruction set (RB_ARCH).
#include "imaging.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>
#include <vector>

namespace raybundle {
namespace RB_ARCH {

#if defined(__GNUC__)
#if defined(__AVX512F__)
constexpr int kBytes = 64;
#elif defined(__AVX2__)
constexpr int kBytes = 32;
#else
constexpr int kBytes = 16;
#endif
typedef float V __attribute__((vector_size(kBytes)));
constexpr int kLanes = kBytes / 4;
#else
typedef float V;
constexpr int kLanes = 1;
#endif
constexpr int kRows = 6, kWide = 2 * kLanes;

// sums (kRows, kWide) of products of kRows rows of a (stride k) and a panel of b (k, kWide).
static inline void products(const float* a, int k, const float* panel, float* sums) {
  V acc[kRows][2] = {};
  for (int i = 0; i < k; ++i) {
    V b0, b1;
    std::memcpy(&b0, panel + i * kWide, sizeof b0);
    std::memcpy(&b1, panel + i * kWide + kLanes, sizeof b1);
    for (int r = 0; r < kRows; ++r) {
      const float f = a[r * k + i];
      acc[r][0] += f * b0;
      acc[r][1] += f * b1;
    }
  }
  std::memcpy(sums, acc, sizeof acc);
}

static void best(const float* a, int n, const float* b, int m, int k, int32_t* first, float* value, float* second, int32_t* reverse) {
  constexpr float low = -std::numeric_limits<float>::max();
  const int panels = (m + kWide - 1) / kWide, blocks = (n + kRows - 1) / kRows;
  std::vector<float> packed(size_t(panels) * k * kWide, 0.0f), rows(size_t(blocks) * kRows * k, 0.0f);
  std::copy_n(a, size_t(n) * k, rows.data());
  for (int j = 0; j < m; ++j)
    for (int i = 0; i < k; ++i) packed[(size_t(j / kWide) * k + i) * kWide + j % kWide] = b[size_t(j) * k + i];
  std::vector<float> top(blocks * kRows, low), next(blocks * kRows, low), column(panels * kWide, low);
  std::vector<int32_t> where(blocks * kRows, -1), row(panels * kWide, -1);
  alignas(64) float sums[kRows * kWide];
  // a strip of blocks stays in the second-level cache while the panels pass by
  constexpr int kStrip = 64;
  for (int strip = 0; strip < blocks; strip += kStrip)
    for (int p = 0; p < panels; ++p) {
      const float* panel = packed.data() + size_t(p) * k * kWide;
      const int wide = std::min(kWide, m - p * kWide);
      float* c = column.data() + p * kWide;
      int32_t* cr = row.data() + p * kWide;
      for (int block = strip; block < std::min(blocks, strip + kStrip); ++block) {
        products(rows.data() + size_t(block) * kRows * k, k, panel, sums);
        for (int r = 0; r < kRows; ++r) {
          const int at = block * kRows + r;
          if (at >= n) break;
          const float* s = sums + r * kWide;
          const float bound = next[at];
          int32_t any = 0;
          for (int x = 0; x < kWide; ++x) any |= s[x] > bound;
          if (any)
            for (int x = 0; x < wide; ++x) {
              if (s[x] > top[at]) {
                next[at] = top[at];
                top[at] = s[x];
                where[at] = p * kWide + x;
              } else if (s[x] > next[at]) {
                next[at] = s[x];
              }
            }
          for (int x = 0; x < kWide; ++x) {
            const bool more = s[x] > c[x];
            c[x] = more ? s[x] : c[x];
            cr[x] = more ? at : cr[x];
          }
        }
      }
    }
  std::copy_n(where.data(), n, first);
  std::copy_n(top.data(), n, value);
  std::copy_n(next.data(), n, second);
  std::copy_n(row.data(), m, reverse);
}

// Weights of the four neighbours for a fraction t, cubic convolution (Keys 1981, a = -1/2), and their derivatives.
static inline void cubic(double t, double* w, double* d) {
  const double t2 = t * t, t3 = t2 * t;
  w[0] = -0.5 * t3 + t2 - 0.5 * t;
  w[1] = 1.5 * t3 - 2.5 * t2 + 1;
  w[2] = -1.5 * t3 + 2 * t2 + 0.5 * t;
  w[3] = 0.5 * t3 - 0.5 * t2;
  if (d) {
    d[0] = -1.5 * t2 + 2 * t - 0.5;
    d[1] = 4.5 * t2 - 5 * t;
    d[2] = -4.5 * t2 + 4 * t + 0.5;
    d[3] = 1.5 * t2 - t;
  }
}

// Value at x, y of the pixel frame (centre of the first pixel 0.5, 0.5), 2 px away from the border; gradient on request.
static inline double sample(const Grey& g, double x, double y, double* gx = nullptr, double* gy = nullptr) {
  x -= 0.5;
  y -= 0.5;
  const int ix = int(std::floor(x)), iy = int(std::floor(y));
  double wx[4], wy[4], dx[4], dy[4];
  cubic(x - ix, wx, gx ? dx : nullptr);
  cubic(y - iy, wy, gx ? dy : nullptr);
  const uint16_t* p = g.data + int64_t(iy - 1) * g.width + ix - 1;
  double value = 0, vx = 0, vy = 0;
  for (int j = 0; j < 4; ++j, p += g.width) {
    const double line = wx[0] * p[0] + wx[1] * p[1] + wx[2] * p[2] + wx[3] * p[3];
    value += wy[j] * line;
    if (gx) {
      vx += wy[j] * (dx[0] * p[0] + dx[1] * p[1] + dx[2] * p[2] + dx[3] * p[3]);
      vy += dy[j] * line;
    }
  }
  if (gx) {
    *gx = vx;
    *gy = vy;
  }
  return value;
}

static inline bool inside(const Grey& g, double x, double y) { return x >= 2.5 && y >= 2.5 && x <= g.width - 2.5 && y <= g.height - 2.5; }

// Corners of the window u = (+-h, +-h) under p + B u.
static bool window_inside(const Grey& g, const double* p, const double* B, double h) {
  for (int a = -1; a <= 1; a += 2)
    for (int b = -1; b <= 1; b += 2)
      if (!inside(g, p[0] + h * (B[0] * a + B[1] * b), p[1] + h * (B[2] * a + B[3] * b))) return false;
  return true;
}

constexpr int kUnknowns = 10;  // shift, affine map, brightness, contrast, slope of the illumination in x and y

// L L' = N in place (lower); false where N is not positive definite beyond rounding.
static bool cholesky(double N[kUnknowns][kUnknowns]) {
  for (int i = 0; i < kUnknowns; ++i) {
    const double whole = N[i][i];
    for (int j = 0; j <= i; ++j) {
      double s = N[i][j];
      for (int k = 0; k < j; ++k) s -= N[i][k] * N[j][k];
      if (i == j) {
        if (!(s > 1e-9 * whole) || !(s > 0)) return false;
        N[i][i] = std::sqrt(s);
      } else {
        N[i][j] = s / N[j][j];
      }
    }
  }
  return true;
}

static void solve(const double L[kUnknowns][kUnknowns], double* b) {
  for (int i = 0; i < kUnknowns; ++i) {
    for (int k = 0; k < i; ++k) b[i] -= L[i][k] * b[k];
    b[i] /= L[i][i];
  }
  for (int i = kUnknowns - 1; i >= 0; --i) {
    for (int k = i + 1; k < kUnknowns; ++k) b[i] -= L[k][i] * b[k];
    b[i] /= L[i][i];
  }
}

struct Window {
  int count;
  std::vector<double> u, v, w, T, G, J;  // J (kUnknowns, count)
  double total;
};

static void match(const Grey& reference, const Grey& target, const Patch& patch, int begin, int end, const double* xy_reference,
                  double* xy, double* affine, double* covariance, double* correlation, int32_t* outcome) {
  const int h = patch.half, side = 2 * h + 1, count = side * side;
  Window o;
  o.count = count;
  for (auto* a : {&o.u, &o.v, &o.w, &o.T, &o.G}) a->assign(count, 0);
  o.J.assign(kUnknowns * count, 0);
  o.total = 0;
  for (int i = 0; i < count; ++i) {
    o.u[i] = i % side - h;
    o.v[i] = i / side - h;
    o.w[i] = std::exp(-(o.u[i] * o.u[i] + o.v[i] * o.v[i]) / (2 * patch.sigma * patch.sigma));
    o.total += o.w[i];
  }
  const double* w = o.w.data();
  // weighted mean to 0, weighted variance to 1; 0 where there is no contrast
  double mean = 0;
  const auto normalise = [&](double* a) {
    double square = 0;
    mean = 0;
    for (int i = 0; i < count; ++i) mean += w[i] * a[i];
    mean /= o.total;
    for (int i = 0; i < count; ++i) {
      a[i] -= mean;
      square += w[i] * a[i] * a[i];
    }
    const double scale = std::sqrt(square / o.total);
    if (!(scale > 1e-6)) return 0.0;
    for (int i = 0; i < count; ++i) a[i] /= scale;
    return scale;
  };
  for (int n = begin; n < end; ++n) {
    const double* c = xy_reference + 2 * n;
    double* p = xy + 2 * n;
    double* B = affine + 4 * n;
    const double start[2] = {p[0], p[1]};
    const double given[4] = {B[0], B[1], B[2], B[3]}, size = given[0] * given[3] - given[1] * given[2];
    if (!(std::abs(size) > 1e-3)) {
      outcome[n] = flat;
      continue;
    }
    correlation[n] = 0;
    const double unit[4] = {1, 0, 0, 1};
    if (!window_inside(reference, c, unit, h)) {
      outcome[n] = outside;
      continue;
    }
    double *T = o.T.data(), *G = o.G.data(), *J = o.J.data();
    for (int i = 0; i < count; ++i) {
      double gx, gy;
      T[i] = sample(reference, c[0] + o.u[i], c[1] + o.v[i], &gx, &gy);
      J[i] = gx;
      J[count + i] = gy;
    }
    const double contrast = normalise(T);
    if (contrast == 0) {
      outcome[n] = flat;
      continue;
    }
    const double level = mean / contrast;
    for (int i = 0; i < count; ++i) {
      const double gx = J[i] /= contrast, gy = J[count + i] /= contrast;
      J[2 * count + i] = gx * o.u[i];
      J[3 * count + i] = gx * o.v[i];
      J[4 * count + i] = gy * o.u[i];
      J[5 * count + i] = gy * o.v[i];
      J[6 * count + i] = 1;
      J[7 * count + i] = T[i];
      J[8 * count + i] = o.u[i] * (T[i] + level) / h;
      J[9 * count + i] = o.v[i] * (T[i] + level) / h;
    }
    double N[kUnknowns][kUnknowns];
    for (int a = 0; a < kUnknowns; ++a)
      for (int b = 0; b <= a; ++b) {
        double sum = 0;
        for (int i = 0; i < count; ++i) sum += w[i] * J[a * count + i] * J[b * count + i];
        N[a][b] = sum;
      }
    double L[kUnknowns][kUnknowns];
    outcome[n] = unsteady;
    for (int iteration = 0; iteration < patch.iterations; ++iteration) {
      if (!window_inside(target, p, B, h)) {
        outcome[n] = outside;
        break;
      }
      for (int i = 0; i < count; ++i)
        G[i] = sample(target, p[0] + B[0] * o.u[i] + B[1] * o.v[i], p[1] + B[2] * o.u[i] + B[3] * o.v[i]);
      if (normalise(G) == 0) {
        outcome[n] = flat;
        break;
      }
      double d[kUnknowns], square = 0;
      for (int i = 0; i < count; ++i) G[i] -= T[i];
      for (int i = 0; i < count; ++i) square += w[i] * G[i] * G[i];
      const double product = 1 - square / (2 * o.total);  // correlation of two normalised windows
      for (int a = 0; a < kUnknowns; ++a) {
        double sum = 0;
        for (int i = 0; i < count; ++i) sum += w[i] * J[a * count + i] * G[i];
        d[a] = sum;
      }
      // the given affine map is an observation: deviation D = given^-1 B - 1, weight relative to a grey value
      const double weight = std::max(square / o.total, 1e-4) / (patch.loose * patch.loose);
      const double D[4] = {(given[3] * B[0] - given[1] * B[2]) / size - 1, (given[3] * B[1] - given[1] * B[3]) / size,
                           (given[0] * B[2] - given[2] * B[0]) / size, (given[0] * B[3] - given[2] * B[1]) / size - 1};
      std::memcpy(L, N, sizeof L);
      for (int k = 0; k < 4; ++k) {
        L[2 + k][2 + k] += weight;
        d[2 + k] += weight * D[k];
      }
      if (!cholesky(L)) {
        outcome[n] = flat;
        break;
      }
      solve(L, d);
      const double limit = 0.25 * h;
      const double longest = std::max({std::abs(d[0]), std::abs(d[1]), h * std::abs(d[2]), h * std::abs(d[3]), h * std::abs(d[4]),
                                       h * std::abs(d[5])});
      if (longest > limit)
        for (double& x : d) x *= limit / longest;
      // W <- W o M^-1 with M(u) = u + t + A u (Baker and Matthews 2004)
      const double a = 1 + d[2], b = d[3], e = d[4], f = 1 + d[5], det = a * f - b * e;
      if (!(std::abs(det) > 0.1)) break;
      const double i0 = f / det, i1 = -b / det, i2 = -e / det, i3 = a / det;
      const double n0 = B[0] * i0 + B[1] * i2, n1 = B[0] * i1 + B[1] * i3, n2 = B[2] * i0 + B[3] * i2, n3 = B[2] * i1 + B[3] * i3;
      B[0] = n0, B[1] = n1, B[2] = n2, B[3] = n3;
      const double sx = B[0] * d[0] + B[1] * d[1], sy = B[2] * d[0] + B[3] * d[1];
      p[0] -= sx;
      p[1] -= sy;
      correlation[n] = product;
      if (std::hypot(p[0] - start[0], p[1] - start[1]) > patch.reach) {
        outcome[n] = moved;
        break;
      }
      if (std::hypot(sx, sy) < patch.step && longest <= limit) {
        outcome[n] = matched;
        // variance of a grey value in units of the normalised window, times the cofactor of the shift, in the target
        double variance = square / o.total * count / (count - kUnknowns), Q[2][2];
        for (int k = 0; k < 2; ++k) {
          double unit_vector[kUnknowns] = {};
          unit_vector[k] = 1;
          solve(L, unit_vector);
          Q[k][0] = unit_vector[0];
          Q[k][1] = unit_vector[1];
        }
        const double q00 = Q[0][0], q01 = Q[0][1], q11 = Q[1][1];
        covariance[3 * n] = variance * (B[0] * (B[0] * q00 + B[1] * q01) + B[1] * (B[0] * q01 + B[1] * q11));
        covariance[3 * n + 1] = variance * (B[2] * (B[2] * q00 + B[3] * q01) + B[3] * (B[2] * q01 + B[3] * q11));
        covariance[3 * n + 2] = variance * (B[2] * (B[0] * q00 + B[1] * q01) + B[3] * (B[0] * q01 + B[1] * q11));
        break;
      }
    }
  }
}

extern const ImagingKernels imaging;
const ImagingKernels imaging = {&best, &match};

}  // namespace RB_ARCH
}  // namespace raybundle
