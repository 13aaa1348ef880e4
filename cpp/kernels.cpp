// The passes over all observations.  Compiled once per instruction set (RB_ARCH names the namespace).
#include <algorithm>
#include <cmath>
#include <cstring>
#include <thread>

#include "problem.hpp"

#ifndef RB_ARCH
#define RB_ARCH baseline
#endif
#if defined(__GNUC__) || defined(__clang__)
#define RB_INLINE inline __attribute__((always_inline))
#define RB_RESTRICT __restrict__
#else
#define RB_INLINE inline
#define RB_RESTRICT __restrict
#endif
#if defined(__GNUC__) && !defined(__clang__)
#define RB_SIMD _Pragma("GCC ivdep")
#elif defined(__clang__)
#define RB_SIMD _Pragma("clang loop vectorize(enable)")
#else
#define RB_SIMD
#endif

namespace raybundle::RB_ARCH {

constexpr int V = 8;  // observations evaluated side by side

namespace models {

static RB_INLINE double angle_ratio(double r2, double w) {
  if (r2 < 1e-8 * w * w && w > 0) return (1 - r2 / (3 * w * w)) / w;
  const double r = std::sqrt(r2);
  return std::atan2(r, w) / r;
}

static RB_INLINE double angle_ratio_slope(double r2, double w) {
  if (r2 < 1e-4 * w * w && w > 0) {
    const double q = r2 / (w * w);
    return (-1.0 / 3 + q * (2.0 / 5 - q * (3.0 / 7 - q * (4.0 / 9 - q * 5.0 / 11)))) / (w * w * w);
  }
  return (w / (r2 + w * w) - angle_ratio(r2, w)) / (2 * r2);
}

using std::cos;
using std::sin;
#include "generated_models.inl"

}  // namespace models

constexpr int kStride = 32;  // of the couplings: kMaxNode padded
static_assert(kStride >= kMaxNode);

// Linearised observations of one chunk, whitened.
struct Chunk {
  std::vector<double> v;  // (2)
  std::vector<double> x;  // (2, 3) by the object point
  std::vector<double> j;  // (2, stride) by the selected columns: own node, then shared node
  std::vector<uint8_t> behind, diverged;
  std::vector<double> rho;  // robust cost of the observation
  int stride = 0;

  void resize(int64_t n, int columns) {
    stride = columns;
    if (static_cast<int64_t>(behind.size()) < n) {
      v.resize(2 * n);
      x.resize(6 * n);
      behind.resize(n);
      diverged.resize(n);
      rho.resize(n);
    }
    if (static_cast<int64_t>(j.size()) < 2 * n * columns) j.resize(2 * n * columns);
  }
};

enum class Want { value, jacobian };

// Whether the sensor-frame point lies on the side that the sensor sees, as `in_front` of the Python model: along -Z,
// everywhere but at the projection centre, or in front of the line at the turn at which it was measured.
template <class M> struct Side {
  static bool in_front(const double* P, const double*, const double*) { return P[2] < 0; }
};
template <> struct Side<models::fisheye> {
  static bool in_front(const double* P, const double*, const double*) { return P[0] != 0 || P[1] != 0 || P[2] != 0; }
};
template <> struct Side<models::panorama> {
  static bool in_front(const double* P, const double* xy, const double* io) {
    const double turn = xy[0] / io[0];
    return std::sin(turn) * P[0] - std::cos(turn) * P[2] - io[2] > 0;
  }
};

// Held coordinates are no unknowns: their partial derivatives vanish.
static inline void hold(uint8_t held, double* x) {
  if (held)
    for (int e = 0; e < 3; ++e)
      if (held & (1 << e)) x[e] = x[3 + e] = 0;
}

template <class M, Want W>
static void linearise_lanes(const Problem& q, const State& s, const int64_t* row, int count, int64_t base, Chunk& out) {
  constexpr int K = M::parameters, A = 5 + K;
  alignas(64) double in[A][V], o[2 + 2 * A][V], measured[2][V], d[3][V];
  const double* R[V];
  for (int l = 0; l < V; ++l) {
    const int64_t i = row[l < count ? l : 0];
    const int f = q.image[i];
    R[l] = s.rotation + 9 * int64_t(f);
    const double* C = s.centre + 3 * int64_t(f);
    const double* P = s.xyz + 3 * int64_t(q.point[i]);
    measured[0][l] = in[0][l] = q.xy[2 * i];
    measured[1][l] = in[1][l] = q.xy[2 * i + 1];
    for (int e = 0; e < 3; ++e) d[e][l] = P[e] - C[e];
    const double* io = s.interior + int64_t(q.interior[f]) * q.interior_stride;
    for (int e = 0; e < K; ++e) in[5 + e][l] = io[e];
  }
  for (int l = 0; l < V; ++l)
    for (int e = 0; e < 3; ++e) in[2 + e][l] = R[l][3 * e] * d[0][l] + R[l][3 * e + 1] * d[1][l] + R[l][3 * e + 2] * d[2][l];

  const bool direct = M::explicit_image || q.corrected[q.image[row[0]]] != 0;
  bool lost[V] = {};
  if (!direct) {
    alignas(64) double g[6][V], relative[V] = {};
    for (int it = 0; it < 25; ++it) {
      M::by_image(in, g);
      double worst = 0;
      for (int l = 0; l < V; ++l) {
        const double det = g[2][l] * g[5][l] - g[3][l] * g[4][l];
        double dx = (g[5][l] * g[0][l] - g[3][l] * g[1][l]) / det, dy = (g[2][l] * g[1][l] - g[4][l] * g[0][l]) / det;
        const double size = std::abs(dx) + std::abs(dy), scale = std::abs(in[0][l]) + std::abs(in[1][l]) + 1;
        if (!(size < 1e3 * scale) || !(det > 0)) {
          lost[l] = true;
          in[0][l] = measured[0][l];
          in[1][l] = measured[1][l];
          continue;
        }
        if (lost[l]) continue;
        in[0][l] -= dx;
        in[1][l] -= dy;
        relative[l] = size / scale;
        worst = std::max(worst, relative[l]);
      }
      if (worst < 1e-14) break;
      if (it == 24)
        for (int l = 0; l < V; ++l)
          if (!lost[l] && relative[l] > 1e-9) {
            lost[l] = true;
            in[0][l] = measured[0][l];
            in[1][l] = measured[1][l];
          }
    }
  }
  M::evaluate(in, o);

  for (int l = 0; l < count; ++l) {
    const int64_t i = row[l], n = i - base;
    const int f = q.image[i];
    const Pattern& pattern = q.patterns[q.pattern[f]];
    double v[2], D[2][3 + K];
    if (direct || lost[l]) {
      // lost: no image point fulfils the condition; the linearised one stands in until the state has moved
      for (int c = 0; c < 2; ++c) {
        v[c] = -o[c][l];
        for (int e = 0; e < 3 + K; ++e) D[c][e] = -o[2 + A * c + 2 + e][l];
      }
    } else {
      const double a = o[2][l], b = o[3][l], c0 = o[2 + A][l], d0 = o[3 + A][l], det = a * d0 - b * c0;
      v[0] = in[0][l] - measured[0][l];
      v[1] = in[1][l] - measured[1][l];
      for (int e = 0; e < 3 + K; ++e) {
        const double g0 = o[4 + e][l], g1 = o[4 + A + e][l];
        D[0][e] = -(d0 * g0 - b * g1) / det;
        D[1][e] = -(a * g1 - c0 * g0) / det;
      }
    }
    out.diverged[n] = lost[l];
    const double P[3] = {in[2][l], in[3][l], in[4][l]};
    out.behind[n] = !Side<M>::in_front(P, &q.xy[2 * i], s.interior + int64_t(q.interior[f]) * q.interior_stride);
    const double* w = &q.whiten[3 * i];
    const double v0 = w[0] * v[0], v1 = w[1] * v[0] + w[2] * v[1];
    double weight = 1, rho = 0.5 * (v0 * v0 + v1 * v1);
    if (s.huber > 0) {
      const double length = std::sqrt(v0 * v0 + v1 * v1);
      if (length > s.huber) {
        weight = std::sqrt(s.huber / length);
        rho = s.huber * (length - 0.5 * s.huber);
      }
    }
    out.rho[n] = rho;
    out.v[2 * n] = weight * v0;
    out.v[2 * n + 1] = weight * v1;
    if constexpr (W == Want::jacobian) {
      double full[2][6 + K];
      for (int c = 0; c < 2; ++c) {
        double T[3 + K];
        if (c == 0)
          for (int e = 0; e < 3 + K; ++e) T[e] = weight * w[0] * D[0][e];
        else
          for (int e = 0; e < 3 + K; ++e) T[e] = weight * (w[1] * D[0][e] + w[2] * D[1][e]);
        const double px = in[2][l], py = in[3][l], pz = in[4][l];
        for (int e = 0; e < 3; ++e) {
          const double by = T[0] * R[l][e] + T[1] * R[l][3 + e] + T[2] * R[l][6 + e];
          out.x[6 * n + 3 * c + e] = by;
          full[c][e] = -by;
        }
        full[c][3] = py * T[2] - pz * T[1];
        full[c][4] = pz * T[0] - px * T[2];
        full[c][5] = px * T[1] - py * T[0];
        for (int e = 0; e < K; ++e) full[c][6 + e] = T[3 + e];
      }
      hold(q.held[q.owner[i]], &out.x[6 * n]);
      for (int c = 0; c < 2; ++c) {
        double* j = &out.j[(2 * n + c) * out.stride];
        for (int e : pattern.own) *j++ = full[c][e];
        for (int e : pattern.shared) *j++ = full[c][e];
      }
    }
  }
}

// A model that is not compiled: v and the partial derivatives were computed outside.
static void linearise_external(const Problem& q, const State& s, int64_t i, int64_t base, Want want, Chunk& out) {
  const int64_t n = i - base;
  const int f = q.image[i];
  const int K = q.parameters[f], width = 9 + 2 * q.interior_stride;
  const double* e = s.external + int64_t(q.external_row[i]) * width;
  const double* R = s.rotation + 9 * int64_t(f);
  const double* C = s.centre + 3 * int64_t(f);
  const double* X = s.xyz + 3 * int64_t(q.point[i]);
  const double* w = &q.whiten[3 * i];
  double P[3];
  for (int a = 0; a < 3; ++a) P[a] = R[3 * a] * (X[0] - C[0]) + R[3 * a + 1] * (X[1] - C[1]) + R[3 * a + 2] * (X[2] - C[2]);
  const int flags = static_cast<int>(e[width - 1]);
  out.behind[n] = flags & 1;
  out.diverged[n] = (flags >> 1) & 1;
  const double v0 = w[0] * e[0], v1 = w[1] * e[0] + w[2] * e[1];
  double weight = 1, rho = 0.5 * (v0 * v0 + v1 * v1);
  if (s.huber > 0) {
    const double length = std::sqrt(v0 * v0 + v1 * v1);
    if (length > s.huber) {
      weight = std::sqrt(s.huber / length);
      rho = s.huber * (length - 0.5 * s.huber);
    }
  }
  out.rho[n] = rho;
  out.v[2 * n] = weight * v0;
  out.v[2 * n + 1] = weight * v1;
  if (want == Want::value) return;
  const double* D[2] = {e + 2, e + 5};
  const double* I[2] = {e + 8, e + 8 + q.interior_stride};
  double full[2][kMaxNode];
  for (int c = 0; c < 2; ++c) {
    double T[3 + kMaxParameters];
    for (int a = 0; a < 3 + K; ++a) {
      const double t0 = a < 3 ? D[0][a] : I[0][a - 3], t1 = a < 3 ? D[1][a] : I[1][a - 3];
      T[a] = weight * (c == 0 ? w[0] * t0 : w[1] * t0 + w[2] * t1);
    }
    for (int a = 0; a < 3; ++a) {
      const double by = T[0] * R[a] + T[1] * R[3 + a] + T[2] * R[6 + a];
      out.x[6 * n + 3 * c + a] = by;
      full[c][a] = -by;
    }
    full[c][3] = P[1] * T[2] - P[2] * T[1];
    full[c][4] = P[2] * T[0] - P[0] * T[2];
    full[c][5] = P[0] * T[1] - P[1] * T[0];
    for (int a = 0; a < K; ++a) full[c][6 + a] = T[3 + a];
  }
  hold(q.held[q.owner[i]], &out.x[6 * n]);
  const Pattern& pattern = q.patterns[q.pattern[f]];
  for (int c = 0; c < 2; ++c) {
    double* j = &out.j[(2 * n + c) * out.stride];
    for (int a : pattern.own) *j++ = full[c][a];
    for (int a : pattern.shared) *j++ = full[c][a];
  }
}

using Lanes = void (*)(const Problem&, const State&, const int64_t*, int, int64_t, Chunk&);

template <Want W> static const Lanes* lanes_table() {
#define RB_ENTRY(name) &linearise_lanes<models::name, W>,
  static const Lanes table[] = {RB_MODELS(RB_ENTRY)};
#undef RB_ENTRY
  return table;
}

template <Want W> static void linearise(const Problem& q, const State& s, int64_t begin, int64_t end, Chunk& out) {
  int stride = 0;
  for (const Pattern& p : q.patterns) stride = std::max(stride, int(p.own.size() + p.shared.size()));
  out.resize(end - begin, std::max(stride, 1));
  const Lanes* table = lanes_table<W>();
  int64_t row[V];
  int64_t i = begin;
  while (i < end) {
    const int f = q.image[i], model = q.model[f], corrected = q.corrected[f];
    if (model < 0) {
      linearise_external(q, s, i++, begin, W, out);
      continue;
    }
    int n = 0;
    while (i < end && n < V && q.model[q.image[i]] == model && q.corrected[q.image[i]] == corrected) row[n++] = i++;
    table[model](q, s, row, n, begin, out);
  }
}

// out (rows, SB) += sum over r of a_r (rows) b_r (SB); sign by the caller through a
template <int SB, int RANK>
static RB_INLINE void rank_update_fixed(double* RB_RESTRICT out, int rows, const double* RB_RESTRICT a, int astride,
                                        const double* RB_RESTRICT b, int bstride) {
  double c[RANK][SB];
  for (int r = 0; r < RANK; ++r)
    for (int e = 0; e < SB; ++e) c[r][e] = b[r * bstride + e];
  for (int x = 0; x < rows; ++x, out += SB) {
    double f[RANK];
    for (int r = 0; r < RANK; ++r) f[r] = a[r * astride + x];
    RB_SIMD
    for (int e = 0; e < SB; ++e) {
      double t = out[e];
      for (int r = 0; r < RANK; ++r) t += f[r] * c[r][e];
      out[e] = t;
    }
  }
}

template <int RANK>
static RB_INLINE void rank_update(double* out, int rows, int cols, const double* a, int astride, const double* b, int bstride) {
  switch (cols) {
#define RB_CASE(n) case n: rank_update_fixed<n, RANK>(out, rows, a, astride, b, bstride); return;
    RB_CASE(1) RB_CASE(2) RB_CASE(3) RB_CASE(4) RB_CASE(5) RB_CASE(6) RB_CASE(7) RB_CASE(8)
    RB_CASE(9) RB_CASE(10) RB_CASE(11) RB_CASE(12) RB_CASE(13) RB_CASE(14) RB_CASE(15) RB_CASE(16)
#undef RB_CASE
    default:
      for (int x = 0; x < rows; ++x, out += cols)
        for (int r = 0; r < RANK; ++r) {
          const double f = a[r * astride + x];
          for (int e = 0; e < cols; ++e) out[e] += f * b[r * bstride + e];
        }
  }
}

// t += Z' y for a block Z (rows, C); three columns, kStride apart.
template <int C>
static RB_INLINE void multiply_fixed(const double* RB_RESTRICT z, int rows, const double* RB_RESTRICT y, double* RB_RESTRICT t) {
  double sum[3][C] = {};
  for (int r = 0; r < rows; ++r, z += C) {
    const double f0 = y[r], f1 = y[kStride + r], f2 = y[2 * kStride + r];
    RB_SIMD
    for (int x = 0; x < C; ++x) sum[0][x] += f0 * z[x];
    RB_SIMD
    for (int x = 0; x < C; ++x) sum[1][x] += f1 * z[x];
    RB_SIMD
    for (int x = 0; x < C; ++x) sum[2][x] += f2 * z[x];
  }
  for (int e = 0; e < 3; ++e)
    for (int x = 0; x < C; ++x) t[e * kStride + x] += sum[e][x];
}

static RB_INLINE void multiply(const double* z, int rows, int cols, const double* y, double* t) {
  switch (cols) {
#define RB_CASE(n) case n: multiply_fixed<n>(z, rows, y, t); return;
    RB_CASE(1) RB_CASE(2) RB_CASE(3) RB_CASE(4) RB_CASE(5) RB_CASE(6) RB_CASE(7) RB_CASE(8)
    RB_CASE(9) RB_CASE(10) RB_CASE(11) RB_CASE(12) RB_CASE(13) RB_CASE(14) RB_CASE(15) RB_CASE(16)
#undef RB_CASE
    default:
      for (int r = 0; r < rows; ++r)
        for (int e = 0; e < 3; ++e)
          for (int x = 0; x < cols; ++x) t[e * kStride + x] += z[r * cols + x] * y[e * kStride + r];
  }
}

static inline int64_t pair_index(int64_t k, int64_t s, int64_t t) { return s * k - s * (s - 1) / 2 + (t - s); }

// Normal matrix of one object point and its couplings with the nodes.
struct PointNormal {
  double v[6];  // 00 10 20 11 21 22
  double b[3];
  double l[6];  // Cholesky factor, same order; diagonal inverted
  bool weak;

  void solve(double b0, double b1, double b2, double* x) const {
    const double y0 = b0 * l[0], y1 = (b1 - l[1] * y0) * l[3], y2 = (b2 - l[2] * y0 - l[4] * y1) * l[5];
    x[2] = y2 * l[5];
    x[1] = (y1 - l[4] * x[2]) * l[3];
    x[0] = (y0 - l[1] * x[1] - l[2] * x[2]) * l[0];
  }
};


// Damping along and across the ray of the point's first image: the depth of a far point is weakly
// determined, and damped in proportion to its own weight it stays free to move.
static void damp(const Problem& q, const State& s, int p, double* v) {
  if (q.held[p] || q.first[p + 1] == q.first[p]) {
    v[0] *= 1 + s.damping;
    v[3] *= 1 + s.damping;
    v[5] *= 1 + s.damping;
    return;
  }
  const double* C = s.centre + 3 * int64_t(q.image[q.first[p]]);
  const double* X = s.xyz + 3 * int64_t(q.id[p]);
  double u[3] = {X[0] - C[0], X[1] - C[1], X[2] - C[2]};
  const double length = std::sqrt(u[0] * u[0] + u[1] * u[1] + u[2] * u[2]);
  for (double& e : u) e /= length > 0 ? length : 1;
  const double along = u[0] * (v[0] * u[0] + 2 * (v[1] * u[1] + v[2] * u[2])) + u[1] * (v[3] * u[1] + 2 * v[4] * u[2]) + v[5] * u[2] * u[2];
  const double across = 0.5 * (v[0] + v[3] + v[5] - along);
  const double a = s.damping * (std::max(along, 0.0) - across), b = s.damping * across;
  v[0] += a * u[0] * u[0] + b;
  v[1] += a * u[0] * u[1];
  v[2] += a * u[0] * u[2];
  v[3] += a * u[1] * u[1] + b;
  v[4] += a * u[1] * u[2];
  v[5] += a * u[2] * u[2] + b;
}

static void gather_point(const Problem& q, const State& s, int p, int64_t base, const Chunk& c, PointNormal& n) {
  double v0 = 0, v1 = 0, v2 = 0, v3 = 0, v4 = 0, v5 = 0, b0 = 0, b1 = 0, b2 = 0;
  for (int64_t i = q.first[p]; i < q.first[p + 1]; ++i)
    for (int r = 0; r < 2; ++r) {
      const double* x = &c.x[6 * (i - base) + 3 * r];
      const double v = c.v[2 * (i - base) + r];
      v0 += x[0] * x[0]; v1 += x[0] * x[1]; v2 += x[0] * x[2];
      v3 += x[1] * x[1]; v4 += x[1] * x[2]; v5 += x[2] * x[2];
      b0 += x[0] * v; b1 += x[1] * v; b2 += x[2] * v;
    }
  double v[6] = {v0, v1, v2, v3, v4, v5}, b[3] = {b0, b1, b2};
  const double* w = &q.prior_weight[3 * int64_t(p)];
  const int diagonal[3] = {0, 3, 5};
  for (int e = 0; e < 3; ++e)
    if (w[e] > 0) {
      v[diagonal[e]] += w[e];
      b[e] += w[e] * (s.xyz[3 * int64_t(q.id[p]) + e] - q.prior_value[3 * int64_t(p) + e]);
    }
  const uint8_t held = q.held[p];
  if (held) {
    if (held & 1) { v[0] = 1; v[1] = v[2] = b[0] = 0; }
    if (held & 2) { v[3] = 1; v[1] = v[4] = b[1] = 0; }
    if (held & 4) { v[5] = 1; v[2] = v[4] = b[2] = 0; }
  }
  std::memcpy(n.v, v, sizeof v);
  std::memcpy(n.b, b, sizeof b);
  if (s.damping > 0) damp(q, s, p, v);
  n.weak = false;
  const auto pivot = [&](double value, double whole) {
    if (value > 1e-13 * whole && value > 0) return 1 / std::sqrt(value);
    n.weak = true;
    return 1 / std::sqrt(whole > 0 ? whole : 1);
  };
  const double i0 = pivot(v[0], v[0]);
  const double l10 = v[1] * i0, l20 = v[2] * i0;
  const double i1 = pivot(v[3] - l10 * l10, v[3]);
  const double l21 = (v[4] - l20 * l10) * i1;
  const double i2 = pivot(v[5] - l20 * l20 - l21 * l21, v[5]);
  n.l[0] = i0; n.l[1] = l10; n.l[2] = l20; n.l[3] = i1; n.l[4] = l21; n.l[5] = i2;
}

// Couplings W (slots, 3, kStride) of the point with its nodes.
static void gather_couplings(const Problem& q, int p, int64_t base, const Chunk& c, double* w) {
  const int64_t k = q.point_nodes_first[p + 1] - q.point_nodes_first[p];
  std::memset(w, 0, sizeof(double) * k * 3 * kStride);
  for (int64_t i = q.first[p]; i < q.first[p + 1]; ++i) {
    const Pattern& pattern = q.patterns[q.pattern[q.image[i]]];
    const int own = int(pattern.own.size()), shared = int(pattern.shared.size());
    const double* x = &c.x[6 * (i - base)];
    const double* j0 = &c.j[2 * (i - base) * c.stride];
    const double* j1 = j0 + c.stride;
    for (int e = 0; e < 3; ++e) {
      const double x0 = x[e], x1 = x[3 + e];
      if (own) {
        double* t = w + (3 * int64_t(q.slot_own[i]) + e) * kStride;
        RB_SIMD
        for (int a = 0; a < own; ++a) t[a] += j0[a] * x0 + j1[a] * x1;
      }
      if (shared) {
        double* t = w + (3 * int64_t(q.slot_shared[i]) + e) * kStride;
        RB_SIMD
        for (int a = 0; a < shared; ++a) t[a] += j0[own + a] * x0 + j1[own + a] * x1;
      }
    }
  }
}

static void for_threads(int threads, const Problem& q, const auto& work) {
  // equal shares of observations, cut between points: the same cut gives the same sums
  std::vector<int> cut(threads + 1, q.points);
  cut[0] = 0;
  for (int t = 1; t < threads; ++t)
    cut[t] = int(std::upper_bound(q.first.begin(), q.first.end(), int64_t(q.observations) * t / threads) - q.first.begin()) - 1;
  for (int t = 1; t <= threads; ++t) cut[t] = std::max(cut[t], cut[t - 1]);
  std::vector<std::thread> pool;
  for (int t = 1; t < threads; ++t) pool.emplace_back([&, t] { work(t, cut[t], cut[t + 1]); });
  work(0, cut[0], cut[1]);
  for (auto& thread : pool) thread.join();
}

// Calls work(first point, last point, first observation) for runs of points of a bounded number of observations.
static void for_runs(const Problem& q, int begin, int end, const auto& work) {
  for (int p = begin; p < end;) {
    int e = p + 1;
    while (e < end && q.first[e + 1] - q.first[p] <= 512) ++e;
    work(p, e, q.first[p]);
    p = e;
  }
}

static double prior_cost(const Problem& q, const State& s, int p, const double* shift = nullptr) {
  double sum = 0;
  for (int e = 0; e < 3; ++e) {
    const double w = q.prior_weight[3 * int64_t(p) + e];
    if (w > 0) {
      const double d = s.xyz[3 * int64_t(q.id[p]) + e] + (shift ? shift[e] : 0) - q.prior_value[3 * int64_t(p) + e];
      sum += 0.5 * w * d * d;
    }
  }
  return sum;
}

static Totals reduce(const Problem& q, const State& s, int threads, double* values, double* right, double* diagonal) {
  const int64_t length = q.block_start.back();
  const int64_t N = q.unknowns;
  std::vector<Totals> totals(threads);
  std::vector<std::vector<double>> own(threads);
  for_threads(threads, q, [&](int t, int begin, int end) {
    double *S = values, *g = right, *U = diagonal;
    if (t > 0) {
      own[t].assign(length + 2 * N, 0.0);
      S = own[t].data();
      g = S + length;
      U = g + N;
    } else {
      std::memset(values, 0, sizeof(double) * length);
      std::memset(right, 0, sizeof(double) * N);
      std::memset(diagonal, 0, sizeof(double) * N);
    }
    Totals& total = totals[t];
    Chunk c;
    std::vector<double> w(int64_t(q.largest_point_nodes) * 3 * kStride), z(w.size());
    for_runs(q, begin, end, [&](int pb, int pe, int64_t base) {
      linearise<Want::jacobian>(q, s, base, q.first[pe], c);
      for (int p = pb; p < pe; ++p) {
        const int64_t nb = q.point_nodes_first[p], k = q.point_nodes_first[p + 1] - nb;
        const int32_t* blocks = q.pair_block.data() + q.point_pairs_first[p];
        const bool kept = q.node_of_point[p] >= 0;
        if (!kept) total.cost += prior_cost(q, s, p);
        for (int64_t i = q.first[p]; i < q.first[p + 1]; ++i) {
          const int64_t n = i - base;
          total.cost += c.rho[n];
          total.behind += c.behind[n];
          total.diverged += c.diverged[n];
          const Pattern& pattern = q.patterns[q.pattern[q.image[i]]];
          const int size[3] = {int(pattern.own.size()), int(pattern.shared.size()), kept ? 3 : 0};
          const int32_t slot[3] = {q.slot_own[i], q.slot_shared[i], q.slot_point[i]};
          const double* j = &c.j[2 * n * c.stride];
          const double* rows[3] = {j, j + size[0], &c.x[6 * n]};
          const int strides[3] = {c.stride, c.stride, 3};
          for (int a = 0; a < 3; ++a) {
            if (!size[a]) continue;
            const int64_t at = q.offset[q.point_nodes[nb + slot[a]]];
            const double v0 = c.v[2 * n], v1 = c.v[2 * n + 1];
            for (int e = 0; e < size[a]; ++e) {
              const double r0 = rows[a][e], r1 = rows[a][strides[a] + e];
              g[at + e] -= r0 * v0 + r1 * v1;
              U[at + e] += r0 * r0 + r1 * r1;
            }
            for (int b = 0; b < 3; ++b) {
              if (!size[b] || slot[b] < slot[a]) continue;
              rank_update<2>(S + q.block_start[blocks[pair_index(k, slot[a], slot[b])]], size[a], size[b], rows[a], strides[a],
                             rows[b], strides[b]);
            }
          }
        }
        if (kept || q.first[p + 1] == q.first[p]) continue;
        PointNormal n;
        gather_point(q, s, p, base, c, n);
        if (n.weak && total.weak.size() < 1000) total.weak.push_back(q.id[p]);
        gather_couplings(q, p, base, c, w.data());
        const double y0 = n.b[0] * n.l[0], y1 = (n.b[1] - n.l[1] * y0) * n.l[3], y2 = (n.b[2] - n.l[2] * y0 - n.l[4] * y1) * n.l[5];
        for (int64_t a = 0; a < k; ++a) {
          const int node = q.point_nodes[nb + a], size = q.size[node];
          double *w0 = &w[a * 3 * kStride], *w1 = w0 + kStride, *w2 = w1 + kStride;
          double *z0 = &z[a * 3 * kStride], *z1 = z0 + kStride, *z2 = z1 + kStride;
          double* at = g + q.offset[node];
          RB_SIMD
          for (int e = 0; e < size; ++e) {
            const double t0 = w0[e] * n.l[0], t1 = (w1[e] - n.l[1] * t0) * n.l[3], t2 = (w2[e] - n.l[2] * t0 - n.l[4] * t1) * n.l[5];
            w0[e] = t0; w1[e] = t1; w2[e] = t2;
            z0[e] = -t0; z1[e] = -t1; z2[e] = -t2;
            at[e] += t0 * y0 + t1 * y1 + t2 * y2;
          }
        }
        const int32_t* block = blocks;
        for (int64_t a = 0; a < k; ++a) {
          const int rows = q.size[q.point_nodes[nb + a]];
          for (int64_t b = a; b < k; ++b, ++block)
            rank_update<3>(S + q.block_start[*block], rows, q.size[q.point_nodes[nb + b]], &z[a * 3 * kStride], kStride,
                           &w[b * 3 * kStride], kStride);
        }
      }
    });
  });
  Totals sum = std::move(totals[0]);
  for (int t = 1; t < threads; ++t) {
    sum.cost += totals[t].cost;
    sum.behind += totals[t].behind;
    sum.diverged += totals[t].diverged;
    sum.weak.insert(sum.weak.end(), totals[t].weak.begin(), totals[t].weak.end());
  }
  if (threads > 1) {
    std::vector<std::thread> pool;
    const auto add = [&](int part) {
      const int64_t b = length * part / threads, e = length * (part + 1) / threads;
      for (int t = 1; t < threads; ++t)
        for (int64_t i = b; i < e; ++i) values[i] += own[t][i];
    };
    for (int t = 1; t < threads; ++t) pool.emplace_back(add, t);
    add(0);
    for (auto& thread : pool) thread.join();
    for (int t = 1; t < threads; ++t)
      for (int64_t i = 0; i < N; ++i) {
        right[i] += own[t][length + i];
        diagonal[i] += own[t][length + N + i];
      }
  }
  return sum;
}

static Totals back_substitute(const Problem& q, const State& s, int threads, const double* step, double* points) {
  std::vector<Totals> totals(threads);
  for_threads(threads, q, [&](int t, int begin, int end) {
    Totals& total = totals[t];
    Chunk c;
    std::vector<double> u;
    for_runs(q, begin, end, [&](int pb, int pe, int64_t base) {
      linearise<Want::jacobian>(q, s, base, q.first[pe], c);
      for (int p = pb; p < pe; ++p) {
        double* dp = points + 3 * int64_t(q.id[p]);
        // v + Jc dc takes the place of v
        for (int64_t i = q.first[p]; i < q.first[p + 1]; ++i) {
          const int64_t n = i - base;
          const int f = q.image[i];
          const Pattern& pattern = q.patterns[q.pattern[f]];
          const int own = int(pattern.own.size()), shared = int(pattern.shared.size());
          const double* j = &c.j[2 * n * c.stride];
          for (int r = 0; r < 2; ++r, j += c.stride) {
            double sum = 0;
            if (own) {
              const double* d = step + q.offset[q.own_node[f]];
              for (int e = 0; e < own; ++e) sum += j[e] * d[e];
            }
            if (shared) {
              const double* d = step + q.offset[q.shared_node[f]];
              for (int e = 0; e < shared; ++e) sum += j[own + e] * d[e];
            }
            c.v[2 * n + r] += sum;
          }
        }
        if (q.node_of_point[p] >= 0) {
          for (int e = 0; e < 3; ++e) dp[e] = step[q.offset[q.node_of_point[p]] + e];
        } else {
          PointNormal n;
          gather_point(q, s, p, base, c, n);
          n.solve(-n.b[0], -n.b[1], -n.b[2], dp);
          total.cost += prior_cost(q, s, p, dp);
        }
        for (int64_t i = q.first[p]; i < q.first[p + 1]; ++i)
          for (int r = 0; r < 2; ++r) {
            const double* x = &c.x[6 * (i - base) + 3 * r];
            const double v = c.v[2 * (i - base) + r] + x[0] * dp[0] + x[1] * dp[1] + x[2] * dp[2];
            total.cost += 0.5 * v * v;
          }
      }
    });
  });
  Totals sum;
  for (const Totals& t : totals) sum.cost += t.cost;
  return sum;
}

static Totals evaluate(const Problem& q, const State& s, int threads, double* residuals, uint8_t* behind) {
  std::vector<Totals> totals(threads);
  for_threads(threads, q, [&](int t, int begin, int end) {
    Totals& total = totals[t];
    Chunk c;
    for_runs(q, begin, end, [&](int pb, int pe, int64_t base) {
      linearise<Want::value>(q, s, base, q.first[pe], c);
      for (int p = pb; p < pe; ++p)
        if (q.node_of_point[p] < 0) total.cost += prior_cost(q, s, p);
      for (int64_t i = base; i < q.first[pe]; ++i) {
        const int64_t n = i - base;
        total.cost += c.rho[n];
        total.behind += c.behind[n];
        total.diverged += c.diverged[n];
        if (residuals) { residuals[2 * q.row[i]] = c.v[2 * n]; residuals[2 * q.row[i] + 1] = c.v[2 * n + 1]; }
        if (behind) behind[q.row[i]] = uint8_t(c.behind[n] | (c.diverged[n] << 1));
      }
    });
  });
  Totals sum;
  for (const Totals& t : totals) { sum.cost += t.cost; sum.behind += t.behind; sum.diverged += t.diverged; }
  return sum;
}

constexpr int kColumns = 16;  // right sides solved together

// right (N, columns) -= W V^-1 given (p, 3, columns): the reduced right side of right sides given for the points.
static void condense(const Problem& q, const State& s, int threads, int columns, const double* given, double* right) {
  std::vector<std::vector<double>> own(threads);
  for_threads(threads, q, [&](int t, int begin, int end) {
    if (t > 0) own[t].assign(size_t(q.unknowns) * columns, 0.0);
    double* out = t > 0 ? own[t].data() : right;
    Chunk c;
    std::vector<double> w(int64_t(q.largest_point_nodes) * 3 * kStride);
    for_runs(q, begin, end, [&](int pb, int pe, int64_t base) {
      linearise<Want::jacobian>(q, s, base, q.first[pe], c);
      for (int p = pb; p < pe; ++p) {
        if (q.node_of_point[p] >= 0) {
          const int64_t at = q.offset[q.node_of_point[p]] * columns;
          for (int e = 0; e < 3 * columns; ++e) out[at + e] += given[3 * int64_t(q.id[p]) * columns + e];
          continue;
        }
        PointNormal n;
        gather_point(q, s, p, base, c, n);
        gather_couplings(q, p, base, c, w.data());
        const int64_t nb = q.point_nodes_first[p], k = q.point_nodes_first[p + 1] - nb;
        double x[3][kColumns];
        const double* b = given + 3 * int64_t(q.id[p]) * columns;
        for (int col = 0; col < columns; ++col) {
          double one[3];
          n.solve(b[col], b[columns + col], b[2 * columns + col], one);
          for (int e = 0; e < 3; ++e) x[e][col] = one[e];
        }
        for (int64_t a = 0; a < k; ++a) {
          const int node = q.point_nodes[nb + a];
          double* d = out + q.offset[node] * columns;
          const double* t = &w[3 * a * kStride];
          for (int i = 0; i < q.size[node]; ++i, d += columns)
            for (int col = 0; col < columns; ++col)
              d[col] -= t[i] * x[0][col] + t[kStride + i] * x[1][col] + t[2 * kStride + i] * x[2][col];
        }
      }
    });
  });
  for (int t = 1; t < threads; ++t)
    for (size_t i = 0; i < own[t].size(); ++i) right[i] += own[t][i];
}

// points (p, 3, columns) = V^-1 (given - W' nodes (N, columns)): the eliminated part of a solution;
// retained points are copied.
static void expand(const Problem& q, const State& s, int threads, int columns, const double* nodes, const double* given, double* points) {
  for_threads(threads, q, [&](int, int begin, int end) {
    Chunk c;
    std::vector<double> w(int64_t(q.largest_point_nodes) * 3 * kStride);
    for_runs(q, begin, end, [&](int pb, int pe, int64_t base) {
      linearise<Want::jacobian>(q, s, base, q.first[pe], c);
      for (int p = pb; p < pe; ++p) {
        double* out = points + 3 * int64_t(q.id[p]) * columns;
        if (q.node_of_point[p] >= 0) {
          std::memcpy(out, nodes + q.offset[q.node_of_point[p]] * columns, sizeof(double) * 3 * columns);
          continue;
        }
        PointNormal n;
        gather_point(q, s, p, base, c, n);
        gather_couplings(q, p, base, c, w.data());
        const int64_t nb = q.point_nodes_first[p], k = q.point_nodes_first[p + 1] - nb;
        double b[3][kColumns] = {};
        if (given)
          for (int e = 0; e < 3; ++e)
            for (int col = 0; col < columns; ++col) b[e][col] = given[(3 * int64_t(q.id[p]) + e) * columns + col];
        for (int64_t a = 0; a < k; ++a) {
          const int node = q.point_nodes[nb + a];
          const double* d = nodes + q.offset[node] * columns;
          const double* t = &w[3 * a * kStride];
          for (int i = 0; i < q.size[node]; ++i, d += columns)
            for (int col = 0; col < columns; ++col) {
              b[0][col] -= t[i] * d[col];
              b[1][col] -= t[kStride + i] * d[col];
              b[2][col] -= t[2 * kStride + i] * d[col];
            }
        }
        for (int col = 0; col < columns; ++col) {
          double x[3];
          n.solve(b[0][col], b[1][col], b[2][col], x);
          for (int e = 0; e < 3; ++e) out[e * columns + col] = q.held[p] & (1 << e) ? 0 : x[e];
        }
      }
    });
  });
}

// From the selected inverse Z of the reduced normal matrix: cofactors of the object points, the 2 x 2
// diagonal blocks A Q A' of every observation, and the effect of a unit blunder on its own point.
// gauge_*: H = Q B G and M = (G'BG)^-1 of the S-transformation, datum columns; datum = 0 without.
static void statistics(const Problem& q, const State& s, int threads, const double* inverse, int datum, const double* gauge_nodes,
                       const double* gauge_points, const double* gauge_middle, double* point_cofactor, double* hat, double* effect,
                       double* point_gauge) {
  std::vector<double> turned(q.block_start.back());  // every block transposed, so that both products run along memory
  for (size_t k = 0; k < q.block_row.size(); ++k) {
    const int rows = q.size[q.block_row[k]], cols = q.size[q.block_col[k]];
    const double* from = inverse + q.block_start[k];
    double* to = turned.data() + q.block_start[k];
    for (int r = 0; r < rows; ++r)
      for (int x = 0; x < cols; ++x) to[x * rows + r] = from[r * cols + x];
  }
  for_threads(threads, q, [&](int, int begin, int end) {
    Chunk c;
    const int64_t room = int64_t(q.largest_point_nodes) * 3 * kStride;
    std::vector<double> y(room), tt(room);
    for_runs(q, begin, end, [&](int pb, int pe, int64_t base) {
      linearise<Want::jacobian>(q, s, base, q.first[pe], c);
      for (int p = pb; p < pe; ++p) {
        const int64_t nb = q.point_nodes_first[p], k = q.point_nodes_first[p + 1] - nb;
        const int32_t* blocks = q.pair_block.data() + q.point_pairs_first[p];
        const bool kept = q.node_of_point[p] >= 0;
        double Q[9] = {};
        if (kept) {
          if (q.first[p + 1] > q.first[p]) {
            const int64_t slot = q.slot_point[q.first[p]];
            std::memcpy(Q, inverse + q.block_start[blocks[pair_index(k, slot, slot)]], sizeof Q);
          }
        } else {
          PointNormal n;
          gather_point(q, s, p, base, c, n);
          gather_couplings(q, p, base, c, y.data());
          // V^-1 from the factor
          double I[3][3];
          for (int e = 0; e < 3; ++e) {
            double column[3];
            n.solve(e == 0, e == 1, e == 2, column);
            for (int f = 0; f < 3; ++f) I[f][e] = column[f];
          }
          for (int64_t a = 0; a < k; ++a) {
            double *y0 = &y[a * 3 * kStride], *y1 = y0 + kStride, *y2 = y1 + kStride;
            const int size = q.size[q.point_nodes[nb + a]];
            RB_SIMD
            for (int e = 0; e < size; ++e) {
              const double w0 = y0[e], w1 = y1[e], w2 = y2[e];
              y0[e] = w0 * I[0][0] + w1 * I[1][0] + w2 * I[2][0];
              y1[e] = w0 * I[0][1] + w1 * I[1][1] + w2 * I[2][1];
              y2[e] = w0 * I[0][2] + w1 * I[1][2] + w2 * I[2][2];
            }
          }
          std::memset(tt.data(), 0, sizeof(double) * k * 3 * kStride);
          const int32_t* block = blocks;
          for (int64_t a = 0; a < k; ++a) {
            const int rows = q.size[q.point_nodes[nb + a]];
            double* ta = &tt[a * 3 * kStride];
            const double* ya = &y[a * 3 * kStride];
            for (int64_t b = a; b < k; ++b, ++block) {
              const int cols = q.size[q.point_nodes[nb + b]];
              const double* z = inverse + q.block_start[*block];
              const double* yb = &y[b * 3 * kStride];
              double* tb = &tt[b * 3 * kStride];
              multiply(z, rows, cols, ya, tb);
              if (a != b) multiply(turned.data() + q.block_start[*block], cols, rows, yb, ta);
            }
          }
          for (int e = 0; e < 3; ++e)
            for (int f = 0; f < 3; ++f) {
              double sum = I[e][f];
              for (int64_t a = 0; a < k; ++a) {
                const double *ye = &y[(3 * a + e) * kStride], *tf = &tt[(3 * a + f) * kStride];
                const int size = q.size[q.point_nodes[nb + a]];
                for (int x = 0; x < size; ++x) sum += ye[x] * tf[x];
              }
              Q[3 * e + f] = sum;
            }
          for (int e = 0; e < 3; ++e)
            if (q.held[p] & (1 << e))
              for (int f = 0; f < 3; ++f) Q[3 * e + f] = Q[3 * f + e] = 0;
        }
        std::memcpy(point_cofactor + 9 * int64_t(q.id[p]), Q, sizeof Q);

        for (int64_t i = q.first[p]; i < q.first[p + 1]; ++i) {
          const int64_t n = i - base;
          const int f = q.image[i];
          const Pattern& pattern = q.patterns[q.pattern[f]];
          const int own = int(pattern.own.size()), shared = int(pattern.shared.size()), size = own + shared;
          double x[2][3];
          for (int r = 0; r < 2; ++r)
            for (int e = 0; e < 3; ++e) x[r][e] = c.x[6 * n + 3 * r + e];
          const double* j[2] = {&c.j[2 * n * c.stride], &c.j[(2 * n + 1) * c.stride]};
          // local cofactor of (own, shared) and their covariance with the point
          double H[2][2] = {}, E[3][2];
          double QJ[kMaxNode][2] = {}, QX[3][2];  // cov(local, l), cov(point, l)
          double CP[kMaxNode][3];                 // cov(local, point)
          const int32_t slots[3] = {q.slot_own[i], q.slot_shared[i], q.slot_point[i]};
          const int sizes[2] = {own, shared}, starts[2] = {0, own};
          // element (r, c) of the block between two slots: p[r * rows + c * cols]
          struct View { const double* p; int rows, cols; };
          const auto view = [&](int32_t sa, int32_t sb) -> View {
            const int32_t low = std::min(sa, sb), high = std::max(sa, sb);
            const double* block = inverse + q.block_start[blocks[pair_index(k, low, high)]];
            const int width = q.size[q.point_nodes[nb + high]];
            return sa <= sb ? View{block, width, 1} : View{block, 1, width};
          };
          for (int sa = 0; sa < 2; ++sa) {
            if (!sizes[sa]) continue;
            for (int sb = 0; sb < 2; ++sb) {
              if (!sizes[sb]) continue;
              // symmetric: rows run along memory
              const View z = view(slots[sb], slots[sa]);
              for (int b = 0; b < sizes[sb]; ++b) {
                const double j0 = j[0][starts[sb] + b], j1 = j[1][starts[sb] + b];
                const double* row = z.p + b * z.rows;
                for (int a = 0; a < sizes[sa]; ++a) {
                  QJ[starts[sa] + a][0] += row[a * z.cols] * j0;
                  QJ[starts[sa] + a][1] += row[a * z.cols] * j1;
                }
              }
            }
            const View point = kept ? view(slots[sa], slots[2]) : View{};
            for (int a = 0; a < sizes[sa]; ++a)
              for (int e = 0; e < 3; ++e) {
                const double c_ae = kept ? point.p[a * point.rows + e * point.cols] : -tt[(3 * int64_t(slots[sa]) + e) * kStride + a];
                CP[starts[sa] + a][e] = c_ae;
                QJ[starts[sa] + a][0] += c_ae * x[0][e];
                QJ[starts[sa] + a][1] += c_ae * x[1][e];
              }
          }
          for (int e = 0; e < 3; ++e)
            for (int r = 0; r < 2; ++r) {
              double sum = Q[3 * e] * x[r][0] + Q[3 * e + 1] * x[r][1] + Q[3 * e + 2] * x[r][2];
              for (int a = 0; a < size; ++a) sum += CP[a][e] * j[r][a];
              QX[e][r] = sum;
            }
          for (int r = 0; r < 2; ++r)
            for (int t = 0; t < 2; ++t) {
              double sum = 0;
              for (int a = 0; a < size; ++a) sum += j[r][a] * QJ[a][t];
              for (int e = 0; e < 3; ++e) sum += x[r][e] * QX[e][t];
              H[r][t] = sum;
            }
          double* h = hat + 3 * q.row[i];
          h[0] = H[0][0];
          h[1] = H[1][1];
          h[2] = 0.5 * (H[0][1] + H[1][0]);
          for (int e = 0; e < 3; ++e)
            for (int r = 0; r < 2; ++r) E[e][r] = QX[e][r];
          if (datum > 0) {
            // S-transformation: minus G_p M (A_i H)'
            for (int r = 0; r < 2; ++r) {
              double u[7];
              for (int g = 0; g < datum; ++g) {
                double sum = 0;
                for (int a = 0; a < own; ++a) sum += j[r][a] * gauge_nodes[(q.offset[q.own_node[f]] + a) * datum + g];
                for (int a = 0; a < shared; ++a) sum += j[r][own + a] * gauge_nodes[(q.offset[q.shared_node[f]] + a) * datum + g];
                for (int e = 0; e < 3; ++e) sum += x[r][e] * gauge_points[(3 * int64_t(q.id[p]) + e) * datum + g];
                u[g] = sum;
              }
              for (int e = 0; e < 3; ++e)
                for (int g = 0; g < datum; ++g) {
                  double m = 0;
                  for (int h = 0; h < datum; ++h) m += gauge_middle[g * datum + h] * u[h];
                  E[e][r] -= point_gauge[(3 * int64_t(q.id[p]) + e) * datum + g] * m;
                }
            }
          }
          for (int e = 0; e < 3; ++e)
            for (int r = 0; r < 2; ++r) effect[6 * q.row[i] + 2 * e + r] = E[e][r];
        }
      }
    });
  });
}

#define RB_STRING2(x) #x
#define RB_STRING(x) RB_STRING2(x)
extern const Kernels table;
const Kernels table = {RB_STRING(RB_ARCH), &reduce, &back_substitute, &evaluate, &statistics, &condense, &expand};

#ifdef RB_LIST_MODELS
const std::vector<const char*>& names() {
#define RB_ENTRY(name) models::name::label,
  static const std::vector<const char*> list = {RB_MODELS(RB_ENTRY)};
#undef RB_ENTRY
  return list;
}
#endif

}  // namespace raybundle::RB_ARCH

#ifdef RB_LIST_MODELS
namespace raybundle {
const std::vector<const char*>& model_names() { return RB_ARCH::names(); }
}  // namespace raybundle
#endif
