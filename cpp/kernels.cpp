// The passes over all observations.  Compiled once per instruction set (RB_ARCH names the namespace).
#include <algorithm>
#include <atomic>
#include <cmath>
#include <condition_variable>
#include <cstring>
#include <mutex>
#include <thread>
#include <type_traits>

#include "problem.hpp"

#ifndef RB_ARCH
#define RB_ARCH baseline
#endif
#if defined(__GNUC__) || defined(__clang__)
#define RB_INLINE inline __attribute__((always_inline))
#define RB_RESTRICT __restrict__
#define RB_APART __attribute__((noinline))
#else
#define RB_INLINE inline
#define RB_RESTRICT __restrict
#define RB_APART
#endif
#if defined(__GNUC__) && !defined(__clang__)
#define RB_SIMD _Pragma("GCC ivdep")
#elif defined(__clang__)
#define RB_SIMD _Pragma("clang loop vectorize(enable)")
#else
#define RB_SIMD
#endif

namespace raybundle::RB_ARCH {

#include "linearise.inl"

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

// The same where rows or columns stand at given positions; null: in their order.
static void rank_update_at(double* out, int width, const int32_t* row, int rows, const double* a, int astride, const int32_t* col,
                           int cols, const double* b, int bstride) {
  for (int x = 0; x < rows; ++x) {
    double* to = out + int64_t(row ? row[x] : x) * width;
    const double f0 = a[x], f1 = a[astride + x];
    if (col)
      for (int e = 0; e < cols; ++e) to[col[e]] += f0 * b[e] + f1 * b[bstride + e];
    else
      for (int e = 0; e < cols; ++e) to[e] += f0 * b[e] + f1 * b[bstride + e];
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
template <bool Plain> static void gather_couplings(const Problem& q, int p, int64_t base, const Chunk& c, double* w) {
  const int64_t k = q.point_nodes_first[p + 1] - q.point_nodes_first[p];
  const int kStride = Plain ? kPlainStride : q.coupling_stride;
  std::fill_n(w, k * 3 * kStride, 0.0);
  for (int64_t i = q.first[p]; i < q.first[p + 1]; ++i) {
    const Pattern& pattern = q.patterns[q.pattern[q.image[i]]];
    const int own = int(pattern.own.size()), shared = c.shared[i - base];
    const int32_t* at = Plain ? nullptr : c.at[i - base];
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
        if (at) {
          for (int a = 0; a < shared; ++a) t[at[a]] += j0[own + a] * x0 + j1[own + a] * x1;
          continue;
        }
        RB_SIMD
        for (int a = 0; a < shared; ++a) t[a] += j0[own + a] * x0 + j1[own + a] * x1;
      }
    }
  }
}

// The points are cut into pieces by the problem alone: sums over them, one piece after the other, have the same bits
// whatever the number of threads.  A piece has so many observations at least, and where each has sums of its own, of
// `length` numbers, there are only as many as keep setting these to zero and adding them a small part of the work.
constexpr int64_t kLeast = 2000, kWorth = 34;
constexpr int kMostPieces = 8;

static int pieces_of(const Problem& q, int64_t length = 0) {
  int64_t n = std::min<int64_t>(q.observations / kLeast, kMostPieces);
  if (length > 0) n = std::min(n, 1 + kWorth * q.observations / length);
  return int(std::max<int64_t>(n, 1));
}

// Pieces whose sums are added in their order, whoever has them ready first.
class Turns {
 public:
  void wait(int piece) {
    std::unique_lock lock(mutex_);
    ready_.wait(lock, [&] { return now_ == piece; });
  }
  void done() {
    {
      std::lock_guard lock(mutex_);
      ++now_;
    }
    ready_.notify_all();
  }

 private:
  std::mutex mutex_;
  std::condition_variable ready_;
  int now_ = 0;
};

// Calls work(own, piece, first point, last point) for all pieces; `own` are numbers of the thread.
static void for_pieces(int threads, int pieces, const Problem& q, const auto& work) {
  // equal shares of observations, cut between points
  std::vector<int> cut(pieces + 1, q.points);
  cut[0] = 0;
  for (int k = 1; k < pieces; ++k)
    cut[k] = int(std::upper_bound(q.first.begin(), q.first.end(), int64_t(q.observations) * k / pieces) - q.first.begin()) - 1;
  for (int k = 1; k <= pieces; ++k) cut[k] = std::max(cut[k], cut[k - 1]);
  std::atomic<int> next{0};
  const auto some = [&] {
    std::vector<double> own;
    for (int k = next++; k < pieces; k = next++) work(own, k, cut[k], cut[k + 1]);
  };
  std::vector<std::thread> pool;
  for (int t = 1; t < std::min(threads, pieces); ++t) pool.emplace_back(some);
  some();
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

template <bool Plain>
static Totals reduce_as(const Problem& q, const State& s, int threads, double* values, double* right, double* diagonal) {
  const int64_t length = q.block_start.back();
  const int64_t N = q.unknowns;
  const int pieces = pieces_of(q, length);
  std::vector<Totals> totals(pieces);
  Turns turns;
  for_pieces(threads, pieces, q, [&](std::vector<double>& own, int piece, int begin, int end) {
    double *S = values, *g = right, *U = diagonal;
    if (piece > 0) {
      own.assign(length + 2 * N, 0.0);
      S = own.data();
      g = S + length;
      U = g + N;
    } else {
      std::fill_n(values, length, 0.0);
      std::fill_n(right, N, 0.0);
      std::fill_n(diagonal, N, 0.0);
    }
    Totals& total = totals[piece];
    Chunk c;
    std::vector<double> w(int64_t(q.largest_point_nodes) * 3 * q.coupling_stride), z(w.size());
    for_runs(q, begin, end, [&](int pb, int pe, int64_t base) {
      const int kStride = Plain ? kPlainStride : q.coupling_stride;
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
          const int size[3] = {int(pattern.own.size()), c.shared[n], kept ? 3 : 0};
          const int32_t* place[3] = {nullptr, Plain ? nullptr : c.at[n], nullptr};
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
              const int64_t to = at + (!Plain && place[a] ? place[a][e] : e);
              g[to] -= r0 * v0 + r1 * v1;
              U[to] += r0 * r0 + r1 * r1;
            }
            for (int b = 0; b < 3; ++b) {
              if (!size[b] || slot[b] < slot[a]) continue;
              double* out = S + q.block_start[blocks[pair_index(k, slot[a], slot[b])]];
              if (!Plain && place[1] && (a == 1 || b == 1))
                rank_update_at(out, q.size[q.point_nodes[nb + slot[b]]], place[a], size[a], rows[a], strides[a], place[b], size[b],
                               rows[b], strides[b]);
              else
                rank_update<2>(out, size[a], size[b], rows[a], strides[a], rows[b], strides[b]);
            }
          }
        }
        if (kept || q.first[p + 1] == q.first[p]) continue;
        PointNormal n;
        gather_point(q, s, p, base, c, n);
        if (n.weak && total.weak.size() < 1000) total.weak.push_back(q.id[p]);
        gather_couplings<Plain>(q, p, base, c, w.data());
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
    if (piece > 0) {
      turns.wait(piece);
      for (int64_t i = 0; i < length; ++i) values[i] += S[i];
      for (int64_t i = 0; i < N; ++i) {
        right[i] += g[i];
        diagonal[i] += U[i];
      }
    }
    turns.done();
  });
  Totals sum = std::move(totals[0]);
  for (int k = 1; k < pieces; ++k) {
    sum.cost += totals[k].cost;
    sum.behind += totals[k].behind;
    sum.diverged += totals[k].diverged;
    sum.weak.insert(sum.weak.end(), totals[k].weak.begin(), totals[k].weak.end());
  }
  return sum;
}

static Totals reduce(const Problem& q, const State& s, int threads, double* values, double* right, double* diagonal) {
  return (q.plain() ? reduce_as<true> : reduce_as<false>)(q, s, threads, values, right, diagonal);
}

static Totals back_substitute(const Problem& q, const State& s, int threads, const double* step, double* points) {
  const int pieces = pieces_of(q);
  std::vector<Totals> totals(pieces);
  for_pieces(threads, pieces, q, [&](std::vector<double>&, int piece, int begin, int end) {
    Totals& total = totals[piece];
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
          const int own = int(pattern.own.size()), shared = c.shared[n];
          const int32_t* at = c.at[n];
          const double* j = &c.j[2 * n * c.stride];
          for (int r = 0; r < 2; ++r, j += c.stride) {
            double sum = 0;
            if (own) {
              const double* d = step + q.offset[q.own_node[f]];
              for (int e = 0; e < own; ++e) sum += j[e] * d[e];
            }
            if (shared) {
              const double* d = step + q.offset[q.shared_node[f]];
              if (at)
                for (int e = 0; e < shared; ++e) sum += j[own + e] * d[at[e]];
              else
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
  const int pieces = pieces_of(q);
  std::vector<Totals> totals(pieces);
  for_pieces(threads, pieces, q, [&](std::vector<double>&, int piece, int begin, int end) {
    Totals& total = totals[piece];
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
  const int kStride = q.coupling_stride;
  const int64_t length = int64_t(q.unknowns) * columns;
  Turns turns;
  for_pieces(threads, pieces_of(q, length), q, [&](std::vector<double>& own, int piece, int begin, int end) {
    if (piece > 0) own.assign(length, 0.0);
    double* out = piece > 0 ? own.data() : right;
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
        gather_couplings<false>(q, p, base, c, w.data());
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
    if (piece > 0) {
      turns.wait(piece);
      for (int64_t i = 0; i < length; ++i) right[i] += own[i];
    }
    turns.done();
  });
}

// points (p, 3, columns) = V^-1 (given - W' nodes (N, columns)): the eliminated part of a solution;
// retained points are copied.
static void expand(const Problem& q, const State& s, int threads, int columns, const double* nodes, const double* given, double* points) {
  const int kStride = q.coupling_stride;
  for_pieces(threads, pieces_of(q), q, [&](std::vector<double>&, int, int begin, int end) {
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
        gather_couplings<false>(q, p, base, c, w.data());
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

#include "statistics.inl"

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
const std::vector<int>& widths() {
#define RB_ENTRY(name) models::name::parameters,
  static const std::vector<int> list = {RB_MODELS(RB_ENTRY)};
#undef RB_ENTRY
  return list;
}
#endif

}  // namespace raybundle::RB_ARCH

#ifdef RB_LIST_MODELS
namespace raybundle {
const std::vector<const char*>& model_names() { return RB_ARCH::names(); }
const std::vector<int>& model_parameters() { return RB_ARCH::widths(); }
}  // namespace raybundle
#endif
