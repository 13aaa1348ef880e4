// Multi-image least-squares matching of depth and slopes, compiled once for every instruction set (RB_ARCH).
//
// Unknowns of a pixel: the depth parameter t in the window's middle and its slopes a, b; brightness and contrast of every
// source; and the patch itself, which is the mean of all views, the reference included (Gruen and Baltsavias 1988; Agouris
// and Schenk 1996).  Where a source shows a pixel of the window is a quadratic polynomial about the window's middle.
#include "surface.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <vector>

namespace raybundle {
namespace RB_ARCH {

#if defined(__GNUC__)
#if defined(__AVX2__)
constexpr int kBytes = 32;  // windows of 49 pixels fill vectors of 8 better than those of 16
#else
constexpr int kBytes = 16;
#endif
constexpr int kLanes = kBytes / 4;
typedef float V __attribute__((vector_size(kBytes)));
typedef int32_t Whole __attribute__((vector_size(kBytes)));
typedef float Quad __attribute__((vector_size(16)));
static inline Whole floored(V x) {
  const Whole i = __builtin_convertvector(x, Whole);
  return i + (x < __builtin_convertvector(i, V));
}
static inline V real(Whole i) { return __builtin_convertvector(i, V); }

static inline float lane(const V& v, int i) { return v[i]; }
#else
constexpr int kLanes = 1;
typedef float V;
typedef int32_t Whole;
static inline Whole floored(V x) { return int32_t(std::floor(x)); }
static inline V real(Whole i) { return float(i); }

static inline float lane(const V& v, int) { return v; }
struct Quad {
  float a[4];
  float operator[](int i) const { return a[i]; }
};
static inline Quad operator+(const Quad& x, const Quad& y) { return {x.a[0] + y.a[0], x.a[1] + y.a[1], x.a[2] + y.a[2], x.a[3] + y.a[3]}; }
static inline Quad operator*(const Quad& x, const Quad& y) { return {x.a[0] * y.a[0], x.a[1] * y.a[1], x.a[2] * y.a[2], x.a[3] * y.a[3]}; }
static inline Quad operator*(float x, const Quad& y) { return {x * y.a[0], x * y.a[1], x * y.a[2], x * y.a[3]}; }
#endif
constexpr int kPad = kLanes < 4 ? 4 : kLanes;  // arrays are a multiple of this long

template <class T> static inline T load(const float* a) {
  T v;
  std::memcpy(&v, a, sizeof v);
  return v;
}
template <class T> static inline void store(float* a, const T& v) { std::memcpy(a, &v, sizeof v); }
static inline float summed(const V& v) {
  float a[kLanes];
  std::memcpy(a, &v, sizeof v);
  for (int n = kLanes / 2; n; n /= 2)
    for (int i = 0; i < n; ++i) a[i] += a[i + n];
  return a[0];
}
static inline void transpose(Quad& a, Quad& b, Quad& c, Quad& d) {
#if defined(__GNUC__) && !defined(__clang__)
  typedef int32_t Four __attribute__((vector_size(16)));
  const Quad p = __builtin_shuffle(a, b, Four{0, 4, 1, 5}), q = __builtin_shuffle(a, b, Four{2, 6, 3, 7});
  const Quad r = __builtin_shuffle(c, d, Four{0, 4, 1, 5}), s = __builtin_shuffle(c, d, Four{2, 6, 3, 7});
  a = __builtin_shuffle(p, r, Four{0, 1, 4, 5});
  b = __builtin_shuffle(p, r, Four{2, 3, 6, 7});
  c = __builtin_shuffle(q, s, Four{0, 1, 4, 5});
  d = __builtin_shuffle(q, s, Four{2, 3, 6, 7});
#else
  const Quad w = a, x = b, y = c, z = d;
  a = Quad{w[0], x[0], y[0], z[0]};
  b = Quad{w[1], x[1], y[1], z[1]};
  c = Quad{w[2], x[2], y[2], z[2]};
  d = Quad{w[3], x[3], y[3], z[3]};
#endif
}

// Quad of the sums of four vectors.
static inline Quad folded(const V& v) {
  float a[kPad] = {};
  std::memcpy(a, &v, sizeof v);
  Quad sum = load<Quad>(a);
  for (int i = 4; i < kPad; i += 4) sum = sum + load<Quad>(a + i);
  return sum;
}
static inline void sums(const V& a, const V& b, const V& c, const V& d, double* into) {
  Quad p = folded(a), q = folded(b), r = folded(c), s = folded(d);
  transpose(p, q, r, s);
  const Quad all = (p + q) + (r + s);
  for (int i = 0; i < 4; ++i) into[i] = all[i];
}

// ---- where a source shows a window

// Weights of four nodes 0..3 at f, and of the first and second derivative by f (Lagrange).
static inline void lagrange(double f, double w[3][4]) {
  const double p = f, q = f - 1, r = f - 2, s = f - 3;
  w[0][0] = -q * r * s / 6, w[0][1] = p * r * s / 2, w[0][2] = -p * q * s / 2, w[0][3] = p * q * r / 6;
  w[1][0] = -(r * s + q * s + q * r) / 6, w[1][1] = (r * s + p * s + p * r) / 2;
  w[1][2] = -(q * s + p * s + p * q) / 2, w[1][3] = (q * r + p * r + p * q) / 6;
  w[2][0] = -(q + r + s) / 3, w[2][1] = p + r + s, w[2][2] = -(p + q + s), w[2][3] = (p + q + r) / 3;
}

// x and y at four levels.
#if defined(__GNUC__)
typedef double Eight __attribute__((vector_size(64)));
struct Levels {
  Eight a;
  static Levels of(const double* p) {
    Levels v;
    std::memcpy(&v.a, p, sizeof v.a);
    return v;
  }
  void add(double w, const Levels& x) { a += w * x.a; }
  double operator[](int i) const { return a[i]; }
};
#else
struct Levels {
  double a[8];
  static Levels of(const double* p) {
    Levels v;
    std::memcpy(v.a, p, sizeof v.a);
    return v;
  }
  void add(double w, const Levels& x) {
    for (int i = 0; i < 8; ++i) a[i] += w * x.a[i];
  }
  double operator[](int i) const { return a[i]; }
};
#endif

enum Derivative { kValue, kU, kV, kUU, kUV, kVV, kDerivatives };

// The table at one pixel of the reference: place and its derivatives by u and v as cubics of f = (t - level) / dt.
struct Column {
  double c[4][2 * kDerivatives];  // coefficients of 1, f, f^2, f^3, by derivative and x, y
  int level = -1;
  bool seen = false;

  void take(const TransferTable& table, double u, double v, double t) {
    const double where = (t - table.t0) / table.dt;
    if (!(where >= 0 && where <= table.levels - 1)) {
      level = -1, seen = false;
      return;
    }
    const int fresh = int(std::clamp(std::floor(where) - 1, 0.0, double(table.levels - 4)));
    if (fresh == level) return;
    level = fresh;
    const double gu = (u - table.u0) / table.step, gv = (v - table.v0) / table.step;
    const int iu = int(std::clamp(std::floor(gu) - 1, 0.0, double(table.columns - 4)));
    const int iv = int(std::clamp(std::floor(gv) - 1, 0.0, double(table.rows - 4)));
    double wu[3][4], wv[3][4];
    lagrange(gu - iu, wu);
    lagrange(gv - iv, wv);
    Levels sums[kDerivatives] = {};
    for (int j = 0; j < 4; ++j) {
      Levels line[3] = {};
      for (int i = 0; i < 4; ++i) {
        const Levels p = Levels::of(table.xy + ((int64_t(iv + j) * table.columns + iu + i) * table.levels + level) * 2);
        for (int d = 0; d < 3; ++d) line[d].add(wu[d][i], p);
      }
      sums[kValue].add(wv[0][j], line[0]);
      sums[kU].add(wv[0][j], line[1]);
      sums[kV].add(wv[1][j], line[0]);
      sums[kUU].add(wv[0][j], line[2]);
      sums[kUV].add(wv[1][j], line[1]);
      sums[kVV].add(wv[2][j], line[0]);
    }
    const double scale[kDerivatives] = {1, 1 / table.step, 1 / table.step, 1 / (table.step * table.step), 1 / (table.step * table.step), 1 / (table.step * table.step)};
    seen = true;
    for (int d = 0; d < kDerivatives; ++d)
      for (int k = 0; k < 2; ++k) {
        const double y0 = sums[d][k] * scale[d], y1 = sums[d][2 + k] * scale[d], y2 = sums[d][4 + k] * scale[d], y3 = sums[d][6 + k] * scale[d];
        const int e = 2 * d + k;
        c[0][e] = y0;
        c[1][e] = -11.0 / 6 * y0 + 3 * y1 - 1.5 * y2 + y3 / 3;
        c[2][e] = y0 - 2.5 * y1 + 2 * y2 - 0.5 * y3;
        c[3][e] = (y3 - y0) / 6 + (y1 - y2) / 2;
        seen = seen && std::isfinite(c[0][e] + c[3][e]);
      }
  }
};

// Place (x, y) = c0 + cu u + cv v + cuu u^2 + cuv u v + cvv v^2 in a window, and its derivative by t, t0 + tu u + tv v.
struct Local {
  double middle[2];
  float cu[2], cv[2], cuu[2], cuv[2], cvv[2], t0[2], tu[2], tv[2];
  double reach;  // length of t0

  Local(const Column& column, const TransferTable& table, double t, double a, double b) {
    const double f = (t - table.t0) / table.dt - column.level, by = 1 / table.dt;
    constexpr int n = 2 * kDerivatives;
    double value[n], slope[n];
    for (int e = 0; e < n; ++e) {
      value[e] = column.c[0][e] + f * (column.c[1][e] + f * (column.c[2][e] + f * column.c[3][e]));
      slope[e] = by * (column.c[1][e] + f * (2 * column.c[2][e] + 3 * f * column.c[3][e]));
    }
    for (int k = 0; k < 2; ++k) {
      const double Ft = slope[k], Ftt = by * by * (2 * column.c[2][k] + 6 * f * column.c[3][k]), Fut = slope[2 * kU + k], Fvt = slope[2 * kV + k];
      middle[k] = value[k];
      cu[k] = float(value[2 * kU + k] + a * Ft);
      cv[k] = float(value[2 * kV + k] + b * Ft);
      cuu[k] = float(0.5 * value[2 * kUU + k] + a * Fut + 0.5 * a * a * Ftt);
      cuv[k] = float(value[2 * kUV + k] + b * Fut + a * Fvt + a * b * Ftt);
      cvv[k] = float(0.5 * value[2 * kVV + k] + b * Fvt + 0.5 * b * b * Ftt);
      t0[k] = float(Ft);
      tu[k] = float(Fut + a * Ftt);
      tv[k] = float(Fvt + b * Ftt);
    }
    reach = std::sqrt(slope[0] * slope[0] + slope[1] * slope[1]);
  }
};

// ---- grey values of a window in a source

// Arrays of the window's length, one after the other.
struct Scratch {
  int side, count, filled;
  double total, effective;  // sum of the weights, and how many equal ones are worth as much
  std::vector<float> memory;
  float *u, *v, *w, *T, *S, *gm, *mean, *padded;
  float *g[kMostSources], *gx[kMostSources], *gy[kMostSources], *J[kMostSources], *a[kMostSources + 1];

  Scratch(int half, double sigma) : side(2 * half + 1), count(side * side), filled((count + kPad - 1) / kPad * kPad) {
    const int arrays = 7 + 5 * kMostSources + 1, wide = (side + kLag) * (side + 2 * kLag) + 2 * kPad;
    memory.assign(size_t(arrays) * filled + wide, 0.0f);
    float* next = memory.data();
    for (float** p : {&u, &v, &w, &T, &S, &gm, &mean}) *p = next, next += filled;
    for (auto* all : {&g, &gx, &gy, &J})
      for (float*& p : *all) p = next, next += filled;
    for (float*& p : a) p = next, next += filled;
    padded = next;
    double squares = 0;
    total = 0;
    for (int i = 0; i < count; ++i) {
      u[i] = float(i % side - half);
      v[i] = float(i / side - half);
      w[i] = float(std::exp(-(double(u[i]) * u[i] + double(v[i]) * v[i]) / (2 * sigma * sigma)));
      total += w[i];
      squares += double(w[i]) * w[i];
    }
    effective = total * total / squares;
  }
};

// Weights of the four neighbours for a fraction, cubic convolution (Keys 1981, a = -1/2), and their derivatives: four
// vectors one behind the other.
static inline void cubic(V f, float* w) {
  store(w, f * (-0.5f + f * (1.0f - 0.5f * f)));
  store(w + kPad, 1.0f + f * f * (-2.5f + 1.5f * f));
  store(w + 2 * kPad, f * (0.5f + f * (2.0f - 1.5f * f)));
  store(w + 3 * kPad, f * f * (-0.5f + 0.5f * f));
}
static inline void cubic_slope(V f, float* d) {
  store(d, -0.5f + f * (2.0f - 1.5f * f));
  store(d + kPad, f * (-5.0f + 4.5f * f));
  store(d + 2 * kPad, 0.5f + f * (4.0f - 4.5f * f));
  store(d + 3 * kPad, f * (-1.0f + 1.5f * f));
}
static inline Quad along(const float* w, const Quad* c) {
  return (load<Quad>(w) * c[0] + load<Quad>(w + kPad) * c[1]) + (load<Quad>(w + 2 * kPad) * c[2] + load<Quad>(w + 3 * kPad) * c[3]);
}

// Where windows lie about the whole pixel (bx, by): x, y of a position in the window.
struct Placed {
  const Local& at;
  int bx, by;
  float fx, fy;
  V x(V u, V v) const { return fx + u * (at.cu[0] + at.cuu[0] * u + at.cuv[0] * v) + v * (at.cv[0] + at.cvv[0] * v); }
  V y(V u, V v) const { return fy + u * (at.cu[1] + at.cuu[1] * u + at.cuv[1] * v) + v * (at.cv[1] + at.cvv[1] * v); }
};

// Whether all of the window is so far within an image that four neighbours are there.
static bool within(const Scratch& o, const SurfaceSource& source, const Placed& place) {
  const float low[2] = {float(1 - place.bx), float(1 - place.by)};
  const float high[2] = {float(source.width - 2 - place.bx), float(source.height - 2 - place.by)};
  const float f[2] = {place.fx, place.fy}, h = 0.5f * float(o.side - 1);
  bool surely = true;
  for (int k = 0; k < 2; ++k) {
    const Local& at = place.at;
    const float most = h * (std::abs(at.cu[k]) + std::abs(at.cv[k])) + h * h * (std::abs(at.cuu[k]) + std::abs(at.cuv[k]) + std::abs(at.cvv[k]));
    surely = surely && f[k] - most > low[k] + 0.01f && f[k] + most < high[k] - 0.01f;
  }
  if (surely) return true;
  for (int i = 0; i < o.filled; i += kLanes) {
    const V u = load<V>(o.u + i), v = load<V>(o.v + i), x = place.x(u, v), y = place.y(u, v);
    for (int k = 0; k < kLanes; ++k)
      if (!(lane(x, k) >= low[0] && lane(y, k) >= low[1] && lane(x, k) < high[0] && lane(y, k) < high[1])) return false;
  }
  return true;
}

// Grey values g of the window in a source, with mean 0, and gradients on request; false where it leaves the image.
template <bool gradients> static bool sample(const Scratch& o, const SurfaceSource& source, const Local& at, float* g, float* gx, float* gy) {
  const double mx = at.middle[0] - 0.5, my = at.middle[1] - 0.5;
  if (!(mx >= 1 && my >= 1 && mx < source.width - 2 && my < source.height - 2)) return false;
  const int bx = int(mx), by = int(my);
  const Placed place{at, bx, by, float(mx - bx), float(my - by)};
  if (!within(o, source, place)) return false;
  const int64_t width = source.width;
  const float* const base = source.grey + int64_t(by - 1) * width + bx - 1;
  const float level = base[width + 1];  // differences of grey values keep more digits
  const float *us = o.u, *vs = o.v, *ws = o.w;
  const int filled = o.filled, whole = source.width;
  alignas(64) float wx[4 * kPad], wy[4 * kPad], dx[4 * kPad], dy[4 * kPad];
  alignas(64) int32_t offsets[kPad];
  Quad sum = {};
  const Quad back = {-level, -level, -level, -level};
  for (int i = 0; i < filled; i += kPad) {
    for (int part = 0; part < kPad; part += kLanes) {
      const V u = load<V>(us + i + part), v = load<V>(vs + i + part), x = place.x(u, v), y = place.y(u, v);
      const Whole ix = floored(x), iy = floored(y);
      const V px = x - real(ix), py = y - real(iy);
      cubic(px, wx + part);
      cubic(py, wy + part);
      if (gradients) {
        cubic_slope(px, dx + part);
        cubic_slope(py, dy + part);
      }
      const Whole offset = iy * whole + ix;
      std::memcpy(offsets + part, &offset, sizeof offset);
    }
    for (int q = 0; q < kPad; q += 4) {
      Quad c[4], e[4];
      for (int k = 0; k < 4; ++k) {
        const float *p = base + offsets[q + k], *w = wy + q + k, *d = dy + q + k;
        const Quad r0 = load<Quad>(p), r1 = load<Quad>(p + width), r2 = load<Quad>(p + 2 * width), r3 = load<Quad>(p + 3 * width);
        c[k] = (w[0] * r0 + w[kPad] * r1) + (w[2 * kPad] * r2 + w[3 * kPad] * r3);
        if (gradients) e[k] = (d[0] * r0 + d[kPad] * r1) + (d[2 * kPad] * r2 + d[3 * kPad] * r3);
      }
      transpose(c[0], c[1], c[2], c[3]);
      const Quad value = along(wx + q, c) + back;
      store(g + i + q, value);
      sum = sum + load<Quad>(ws + i + q) * value;
      if (gradients) {
        transpose(e[0], e[1], e[2], e[3]);
        store(gy + i + q, along(wx + q, e));
        store(gx + i + q, along(dx + q, c));
      }
    }
  }
  const float mean = float(double((sum[0] + sum[1]) + (sum[2] + sum[3])) / o.total);
  for (int i = 0; i < filled; i += kLanes) store(g + i, load<V>(g + i) - mean);
  return true;
}

// ---- the adjustment of one pixel

// A source as it enters the normal equations: weights times grey values are scaled to variance 1.
struct View {
  double scale;       // 1 / standard deviation of its grey values
  double mean[3];     // of the columns of J, scaled
  double on_grey[3];  // their parts along the grey values
  double correlation;
};

struct Normal {
  double N[6];  // tt ta aa tb ab bb
  double B[3];
  double s2;    // variance of a normalised grey value
};

// Sums of a source over the window; false where it shows no texture.
static bool sums_of(Scratch& o, const Local& at, int s, double contrast, View& view, double N[6]) {
  const float *g = o.g[s], *gx = o.gx[s], *gy = o.gy[s], *us = o.u, *vs = o.v, *ws = o.w, *T = o.T;
  float* J = o.J[s];
  const int filled = o.filled;
  V gg = {}, gT = {}, j0 = {}, ju = {}, jv = {}, k0 = {}, ku = {}, kv = {}, n0 = {}, nu = {}, nv = {}, nuu = {}, nuv = {}, nvv = {};
  for (int i = 0; i < filled; i += kLanes) {
    const V u = load<V>(us + i), v = load<V>(vs + i), w = load<V>(ws + i), x = load<V>(g + i), wx = w * x;
    const V j = load<V>(gx + i) * (at.t0[0] + at.tu[0] * u + at.tv[0] * v) + load<V>(gy + i) * (at.t0[1] + at.tu[1] * u + at.tv[1] * v);
    store(J + i, j);
    const V wj = w * j, wju = wj * u, wjv = wj * v, p = wj * j, pu = p * u, pv = p * v;
    gg += wx * x;
    gT += wx * load<V>(T + i);
    j0 += wj, ju += wju, jv += wjv;
    k0 += wj * x, ku += wju * x, kv += wjv * x;
    n0 += p, nu += pu, nv += pv, nuu += pu * u, nuv += pu * v, nvv += pv * v;
  }
  double m[4], q[4], n[8];
  sums(gg, gT, j0, ju, m);
  const double variance = m[0] / o.total;
  if (!(variance > contrast * contrast)) return false;
  const double k = 1 / std::sqrt(variance), k2 = k * k;
  view.scale = k;
  view.correlation = m[1] * k / o.total;
  sums(jv, k0, ku, kv, q);
  sums(n0, nu, nuu, nv, n);
  sums(nuv, nvv, nuv, nvv, n + 4);
  const double means[3] = {m[2], m[3], q[0]};
  for (int i = 0; i < 3; ++i) view.mean[i] = means[i] * k / o.total, view.on_grey[i] = q[i + 1] * k2 / o.total;
  for (int i = 0, e = 0; i < 3; ++i)
    for (int j = 0; j <= i; ++j, ++e) N[e] = n[e] * k2 - o.total * (view.mean[i] * view.mean[j] + view.on_grey[i] * view.on_grey[j]);
  return true;
}

// The patch is the mean of the views: what is left of the sums of single sources (in n) when it is taken out.
static void without_patch(Scratch& o, const View* views, uint32_t used, int count, int nv, Normal& n) {
  V t0 = {}, t1 = {}, t2 = {}, t3 = {}, t4 = {}, t5 = {}, b0 = {}, b1 = {}, b2 = {}, square = {};
  double m[3] = {};
  struct {
    const float *g, *J;
    float scale, on_grey[3];
  } of[kMostSources];
  int n_of = 0;
  for (int s = 0; s < count; ++s)
    if (used >> s & 1) {
      for (int p = 0; p < 3; ++p) m[p] += views[s].mean[p];
      const double k = views[s].scale;
      of[n_of++] = {o.g[s], o.J[s], float(k), {float(k * views[s].on_grey[0]), float(k * views[s].on_grey[1]), float(k * views[s].on_grey[2])}};
    }
  const float m0 = float(m[0]), m1 = float(m[1]), m2 = float(m[2]);
  const double inverse = 1.0 / (nv + 1);
  const float *us = o.u, *vs = o.v, *ws = o.w, *T = o.T;
  const int filled = o.filled;
  for (int i = 0; i < filled; i += kLanes) {
    V patch = load<V>(T + i), j = {}, c0 = {}, c1 = {}, c2 = {};
    for (int s = 0; s < n_of; ++s) {
      const V g = load<V>(of[s].g + i);
      patch += g * of[s].scale;
      j += load<V>(of[s].J + i) * of[s].scale;
      c0 += g * of[s].on_grey[0], c1 += g * of[s].on_grey[1], c2 += g * of[s].on_grey[2];
    }
    const V w = load<V>(ws + i);
    c0 = (j - m0 - c0), c1 = (j * load<V>(us + i) - m1 - c1), c2 = (j * load<V>(vs + i) - m2 - c2);
    const V w0 = w * c0, w1 = w * c1, w2 = w * c2;
    t0 += w0 * c0, t1 += w1 * c0, t2 += w1 * c1, t3 += w2 * c0, t4 += w2 * c1, t5 += w2 * c2;
    b0 += w0 * patch, b1 += w1 * patch, b2 += w2 * patch;
    square += w * patch * patch;
  }
  double t[8], b[4];
  sums(t0, t1, t2, t3, t);
  sums(t4, t5, t4, t5, t + 4);
  sums(b0, b1, b2, square, b);
  for (int e = 0; e < 6; ++e) n.N[e] -= t[e] * inverse;
  for (int p = 0; p < 3; ++p) n.B[p] = -b[p] * inverse;
  const double left = (nv + 1) * o.total - b[3] * inverse;  // weighted squares of the residuals
  const double worth = nv * o.effective;
  n.s2 = std::max(left, 0.0) / o.total / nv * worth / std::max(worth - 2 * nv - 3, 1.0);
}

// Inverse of a symmetric 3 x 3 matrix, both as tt ta aa tb ab bb; false where it is singular.
static bool inverse(const double N[6], double Q[6]) {
  const double a = N[0], b = N[1], d = N[2], c = N[3], e = N[4], f = N[5];
  const double A = d * f - e * e, B = c * e - b * f, C = b * e - c * d, det = a * A + b * B + c * C;
  if (!(det > 1e-12 * a * d * f)) return false;
  Q[0] = A / det, Q[1] = B / det, Q[3] = C / det, Q[2] = (a * f - c * c) / det, Q[4] = (b * c - a * e) / det, Q[5] = (a * d - b * b) / det;
  return true;
}

// Variance of a gradient in units of that of a grey value: 2.9 for white noise through cubic convolution, less the smoother it
// is.  How fast the iteration goes depends on it, not where to.
constexpr double kGradientNoise = 1.2, kLeastShare = 0.4;
constexpr double kLongest = 2;  // most that acceleration adds to a step, in steps
constexpr double kUnknown = 40;  // by how much less is known of slopes that are not given
constexpr double kLoose = 0.2;  // by how much less a source may correlate in the first iteration, far from its place yet

class Pixel {
 public:
  Pixel(const SurfaceImages& images, const SurfaceFit& fit, Scratch& scratch) : images_(images), fit_(fit), o_(scratch) {}

  double t, a, b;
  double Q[6], inflation, noise, s2, correlation, contrast;
  int iterations;
  uint32_t used;

  // slopes: whether they are known.
  SurfaceReason refine(int x, int y, bool slopes) {
    x_ = x, y_ = y;
    if (const SurfaceReason bad = reference()) return bad;
    for (int s = 0; s < images_.count; ++s) columns_[s].level = -1;
    used = (1u << images_.count) - 1;
    const double start = t, given_a = a, given_b = b;
    double before[3] = {}, made[3] = {};  // correction and step of the last iteration
    uint32_t with = 0;                    // and its sources; 0: none to go on from
    for (iterations = 1; iterations <= fit_.iterations; ++iterations) {
      if (const SurfaceReason bad = evaluate()) return bad;
      // the slopes are observations, too
      const double known = slopes ? fit_.slope : kUnknown * fit_.slope, prior = std::max(normal_.s2, 1e-4) * reach_ * reach_ / (known * known);
      normal_.N[2] += prior, normal_.N[5] += prior;
      normal_.B[1] += prior * (a - given_a), normal_.B[2] += prior * (b - given_b);
      if (!inverse(normal_.N, Q)) return no_texture;
      const double* B = normal_.B;
      double d[3] = {-(Q[0] * B[0] + Q[1] * B[1] + Q[3] * B[2]), -(Q[1] * B[0] + Q[2] * B[1] + Q[4] * B[2]), -(Q[3] * B[0] + Q[4] * B[1] + Q[5] * B[2])};
      // what noise adds to the normal matrix makes corrections too short
      const double noisy = kGradientNoise * normal_.s2 * o_.total * squares_ / normal_.N[0], longer = 1 / std::max(1 - noisy, kLeastShare);
      const double move = longer * length(d);
      if (!(move < 1e9)) return no_convergence;
      if (move < fit_.step) {
        const SurfaceReason bad = observe_curvature();
        last_[0] = d[0], last_[1] = d[1], last_[2] = d[2];
        return bad;
      }
      // noise in the gradients makes corrections too small, one after the other by the same share: Anderson's acceleration
      for (double& x : d) x *= longer;
      double step[3] = {d[0], d[1], d[2]};
      if (with == used) {
        double change = 0, along = 0;
        for (int p = 0; p < 3; ++p) {
          const double size = p ? fit_.sigma * fit_.sigma : 1.0, difference = d[p] - before[p];
          change += size * difference * difference, along += size * d[p] * difference;
        }
        const double gamma = change > 0 ? std::clamp(along / change, -kLongest, 0.5) : 0.0;
        for (int p = 0; p < 3; ++p) step[p] -= gamma * (made[p] + d[p] - before[p]);
      }
      const double far = length(step), part = far > 1 ? 1 / far : 1;
      for (int p = 0; p < 3; ++p) before[p] = d[p], made[p] = part * step[p];
      with = used;
      t += made[0], a += made[1], b += made[2];
      if (!(std::abs(t - start) * reach_ <= fit_.reach)) return moved_far;
    }
    return no_convergence;
  }

  // Variances and what goes with them; the last step is taken here, as the observed curvature has it.
  void finish(float* shift, float* response) {
    combine(shift, response);
    s2 = normal_.s2;
    correlation = 0;
    int nv = 0;
    for (int s = 0; s < images_.count; ++s)
      if (used >> s & 1) correlation += views_[s].correlation, ++nv;
    correlation /= nv;
    t += last_[0] * inflation, a += last_[1] * inflation, b += last_[2] * inflation;
  }

 private:
  const SurfaceImages& images_;
  const SurfaceFit& fit_;
  Scratch& o_;
  Column columns_[kMostSources];
  View views_[kMostSources];
  double steep_[kMostSources][4];  // derivatives of place by u and v
  Normal normal_;
  double reach_ = 0, squares_ = 0, last_[3];
  int x_ = 0, y_ = 0;

  // Shift of a step in the most sensitive source, about where the window's weight stands [px].
  double length(const double d[3]) const { return reach_ * std::sqrt(d[0] * d[0] + fit_.sigma * fit_.sigma * (d[1] * d[1] + d[2] * d[2])); }

  SurfaceReason reference() {
    const int half = fit_.half;
    if (x_ < half || y_ < half || x_ + half >= images_.width || y_ + half >= images_.height) return left_image;
    const float* middle = images_.reference + int64_t(y_) * images_.width + x_;
    for (int i = 0, v = -half; v <= half; ++v)
      for (int u = -half; u <= half; ++u, ++i) o_.T[i] = middle[int64_t(v) * images_.width + u] - middle[0];
    for (int i = o_.count; i < o_.filled; ++i) o_.T[i] = 0;
    V sum = {}, square = {};
    for (int i = 0; i < o_.filled; i += kLanes) sum += load<V>(o_.w + i) * load<V>(o_.T + i);
    const float mean = float(summed(sum) / o_.total);
    for (int i = 0; i < o_.filled; i += kLanes) {
      const V x = load<V>(o_.T + i) - mean;
      store(o_.T + i, x);
      square += load<V>(o_.w + i) * x * x;
    }
    contrast = std::sqrt(summed(square) / o_.total);
    if (!(contrast > fit_.contrast)) return no_texture;
    const float k = float(1 / contrast);
    for (int i = 0; i < o_.filled; i += kLanes) store(o_.T + i, load<V>(o_.T + i) * k);
    return refined;
  }

  // Normal equations at t, a, b; sources that leave or look otherwise are used no more.
  SurfaceReason evaluate() {
    normal_ = {};
    reach_ = squares_ = 0;
    int nv = 0;
    SurfaceReason bad = left_image;
    for (int s = 0; s < images_.count; ++s) {
      if (!(used >> s & 1)) continue;
      const SurfaceSource& source = images_.sources[s];
      columns_[s].take(source.transfer, x_ + 0.5, y_ + 0.5, t);
      double N[6];
      bool fine = false;
      if (columns_[s].seen) {
        const Local at(columns_[s], source.transfer, t, a, b);
        if (sample<true>(o_, source, at, o_.g[s], o_.gx[s], o_.gy[s])) {
          fine = sums_of(o_, at, s, fit_.contrast, views_[s], N);
          if (!fine && bad == left_image) bad = no_texture;
          if (fine && views_[s].correlation < fit_.correlation - (iterations == 1 ? kLoose : 0.0)) fine = false, bad = no_correlation;
          steep_[s][0] = at.cu[0], steep_[s][1] = at.cv[0], steep_[s][2] = at.cu[1], steep_[s][3] = at.cv[1];
          if (fine) reach_ = std::max(reach_, at.reach), squares_ += at.reach * at.reach;
        }
      }
      if (!fine) {
        used &= ~(1u << s);
        continue;
      }
      ++nv;
      for (int e = 0; e < 6; ++e) normal_.N[e] += N[e];
    }
    if (!nv) return bad;
    without_patch(o_, views_, used, images_.count, nv, normal_);
    return refined;
  }

  // Noise in the gradients makes the normal matrix larger than the curvature that the cost has: observed here, by its second
  // difference along the line on which the slopes follow t.
  SurfaceReason observe_curvature() {
    const double apart = fit_.apart / reach_;
    double cost[3];
    int nv = 0;
    for (int s = 0; s < images_.count; ++s) nv += used >> s & 1;
    for (int side = -1; side <= 1; ++side) {
      const double along = side * apart;
      std::copy_n(o_.T, o_.filled, o_.S);
      for (int s = 0; s < images_.count; ++s) {
        if (!(used >> s & 1)) continue;
        const SurfaceSource& source = images_.sources[s];
        float* g = o_.g[s];
        float scale = float(views_[s].scale);
        if (side) {
          const Local at(columns_[s], source.transfer, t + along, a + along * Q[1] / Q[0], b + along * Q[3] / Q[0]);
          const bool inside = sample<false>(o_, source, at, o_.mean, nullptr, nullptr);
          if (!inside) return left_image;
          g = o_.mean;
          V square = {};
          for (int i = 0; i < o_.filled; i += kLanes) square += load<V>(o_.w + i) * load<V>(g + i) * load<V>(g + i);
          scale = float(1 / std::sqrt(std::max(summed(square) / o_.total, 1e-30)));
        }
        for (int i = 0; i < o_.filled; i += kLanes) store(o_.S + i, load<V>(o_.S + i) + load<V>(g + i) * scale);
      }
      V square = {};
      for (int i = 0; i < o_.filled; i += kLanes) square += load<V>(o_.w + i) * load<V>(o_.S + i) * load<V>(o_.S + i);
      cost[side + 1] = -0.5 * double(summed(square)) / (nv + 1);
    }
    const double curvature = (cost[0] - 2 * cost[1] + cost[2]) / (apart * apart), promised = 1 / Q[0];
    if (!(curvature > fit_.share * promised)) return no_curvature;
    inflation = promised / curvature;
    return refined;
  }

  // How t follows from single grey values, and what that makes of their noise.  A source's row of Q J is a; that of view v in
  // the solution is w (a - mean of a), without its parts along brightness and contrast of that view.
  void combine(float* shift, float* response) {
    const int count = images_.count;
    int nv = 0;
    std::fill_n(o_.mean, o_.filled, 0.0f);
    const float q0 = float(Q[0]), q1 = float(Q[1]), q2 = float(Q[3]);
    for (int s = 0; s < count; ++s) {
      if (!(used >> s & 1)) continue;
      ++nv;
      const View& view = views_[s];
      const float k = float(view.scale), m = float(Q[0] * view.mean[0] + Q[1] * view.mean[1] + Q[3] * view.mean[2]);
      const float g = float((Q[0] * view.on_grey[0] + Q[1] * view.on_grey[1] + Q[3] * view.on_grey[2]) * view.scale);
      for (int i = 0; i < o_.filled; i += kLanes) {
        const V j = load<V>(o_.J[s] + i) * k;
        store(o_.J[s] + i, j);
        const V row = j * (q0 + q1 * load<V>(o_.u + i) + q2 * load<V>(o_.v + i)) - m - g * load<V>(o_.g[s] + i);
        store(o_.a[s + 1] + i, row);
        store(o_.mean + i, load<V>(o_.mean + i) + row);
      }
    }
    const float part = 1.0f / float(nv + 1);
    for (int i = 0; i < o_.filled; i += kLanes) store(o_.mean + i, load<V>(o_.mean + i) * part);
    noise = 0;
    if (response) std::fill_n(o_.S, o_.filled, 0.0f);
    for (int s = -1; s < count; ++s) {
      if (s >= 0 && !(used >> s & 1)) {
        if (shift) shift[2 * s] = shift[2 * s + 1] = 0;
        continue;
      }
      const float* g = s < 0 ? o_.T : o_.g[s];
      const float scale = s < 0 ? 1.0f : float(views_[s].scale);
      V along = {};
      for (int i = 0; i < o_.filled; i += kLanes) along += load<V>(o_.w + i) * load<V>(o_.mean + i) * load<V>(g + i);
      const float back = float(summed(along) * scale / o_.total) * scale;
      float* row = o_.a[s + 1];
      V square = {}, sx = {}, sy = {};
      for (int i = 0; i < o_.filled; i += kLanes) {
        V r = s < 0 ? V{} : load<V>(row + i);
        r = load<V>(o_.w + i) * (r - load<V>(o_.mean + i) + back * load<V>(g + i));
        store(row + i, r);
        square += r * r;
        if (s >= 0) {
          sx += r * load<V>(o_.gx[s] + i), sy += r * load<V>(o_.gy[s] + i);
          if (response) store(o_.S + i, load<V>(o_.S + i) + r * load<V>(o_.J[s] + i));
        }
      }
      noise += images_.autocovariance ? correlated(row, s) : double(summed(square));
      if (s >= 0 && shift) shift[2 * s] = -summed(sx) * scale, shift[2 * s + 1] = -summed(sy) * scale;
    }
    if (response) std::copy_n(o_.S, o_.count, response);
  }

  // Variance of the sum of row times grey values whose autocovariance is given by lag in the view's own pixels.
  double correlated(const float* row, int s) {
    const int side = o_.side, wide = side + kLag;
    const float* table = images_.autocovariance + int64_t(s + 1) * (2 * kLag + 1) * (2 * kLag + 1);
    float* k = o_.padded;
    for (int j = 0; j < side; ++j) std::copy_n(row + j * side, side, k + j * wide);
    const int length = side * wide;  // zeros follow
    double sum = 0;
    for (int dy = 0; dy <= kLag; ++dy)
      for (int dx = dy ? -kLag : 0; dx <= kLag; ++dx) {
        double lx = dx, ly = dy;
        if (s >= 0) lx = steep_[s][0] * dx + steep_[s][1] * dy, ly = steep_[s][2] * dx + steep_[s][3] * dy;
        if (!(std::abs(lx) < kLag && std::abs(ly) < kLag) && !(std::abs(lx) <= kLag && std::abs(ly) <= kLag && s < 0)) continue;
        const int ix = std::min(int(std::floor(lx)), kLag - 1), iy = std::min(int(std::floor(ly)), kLag - 1);
        const double fx = lx - ix, fy = ly - iy;
        const float* c = table + (iy + kLag) * (2 * kLag + 1) + ix + kLag;
        const double covariance = (1 - fy) * ((1 - fx) * c[0] + fx * c[1]) + fy * ((1 - fx) * c[2 * kLag + 1] + fx * c[2 * kLag + 2]);
        if (covariance == 0) continue;
        const float* other = k + dy * wide + dx;
        V products = {};
        int i = std::max(0, -(dy * wide + dx));
        for (; i < length; i += kLanes) products += load<V>(k + i) * load<V>(other + i);
        sum += (dx || dy ? 2 : 1) * covariance * summed(products);
      }
    return sum;
  }
};

static void refine(const SurfaceImages& images, const SurfaceFit& fit, const SurfaceGrid& grid, int begin, int end, int chain, const SurfaceFound& found) {
  Scratch scratch(fit.half, fit.sigma);
  Pixel pixel(images, fit, scratch);
  const int64_t size = int64_t(grid.rows) * grid.columns;
  float* const out = found.numbers;
  for (int row = begin; row < end; ++row)
    for (int step = 0; step < grid.columns; ++step) {
      const int column = chain < 0 ? grid.columns - 1 - step : step;
      const int64_t at = int64_t(row) * grid.columns + column;
      if (!found.todo[at]) continue;
      double t = out[kT * size + at], a = out[kA * size + at], b = out[kB * size + at];
      const int64_t before = at - chain;
      if (std::isnan(t) && chain && step && found.reason[before] == refined) {
        a = out[kA * size + before], b = out[kB * size + before];
        t = out[kT * size + before] + chain * grid.stride * a;
      }
      found.views[at] = 0;
      found.iterations[at] = 0;
      if (std::isnan(t)) {
        found.reason[at] = no_start;
        continue;
      }
      pixel.t = t;
      pixel.a = std::isnan(a) ? 0 : a;
      pixel.b = std::isnan(b) ? 0 : b;
      const SurfaceReason reason = pixel.refine(grid.x0 + column * grid.stride, grid.y0 + row * grid.stride, !std::isnan(a) && !std::isnan(b));
      found.reason[at] = reason;
      found.iterations[at] = uint8_t(std::min(pixel.iterations, 255));
      if (reason != refined) continue;
      pixel.finish(found.shift ? found.shift + at * images.count * 2 : nullptr, found.response ? found.response + at * scratch.count : nullptr);
      const double numbers[kSurfaceQuantities] = {pixel.t, pixel.a, pixel.b, pixel.Q[0], pixel.noise, pixel.inflation, pixel.s2, pixel.correlation, pixel.contrast};
      for (int q = 0; q < kSurfaceQuantities; ++q) out[q * size + at] = float(numbers[q]);
      found.views[at] = int32_t(pixel.used);
    }
}

const SurfaceKernels surface = {refine};

}  // namespace RB_ARCH
}  // namespace raybundle
