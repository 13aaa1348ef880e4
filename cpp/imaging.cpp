// Descriptor matching and least-squares matching, compiled once for every instruction set (RB_ARCH).
#include "imaging.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>
#include <type_traits>
#include <vector>

#if defined(__SSE2__)
#include <immintrin.h>
#endif

namespace raybundle {
namespace RB_ARCH {

#include "lanes.inl"
constexpr int kRows = 6, kWide = 2 * kLanes;

// Doubles in vectors with sums of their own: without them a sum waits for each of its terms.
#if defined(__GNUC__)
typedef double D __attribute__((vector_size(kBytes)));
constexpr int kDoubles = kBytes / 8;
#else
typedef double D;
constexpr int kDoubles = 1;
#endif
static inline D load(const double* a) {
  D v;
  std::memcpy(&v, a, sizeof v);
  return v;
}
static inline void store(double* a, D v) { std::memcpy(a, &v, sizeof v); }
static inline double summed(D v) {
  double a[kDoubles], sum = 0;
  std::memcpy(a, &v, sizeof v);
  for (double x : a) sum += x;
  return sum;
}
// Sum of a b over n values, a multiple of kDoubles.
static inline double dot(const double* a, const double* b, int n) {
  D sum = {};
  for (int i = 0; i < n; i += kDoubles) sum += load(a + i) * load(b + i);
  return summed(sum);
}

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

// The search of `best`: products(block, p, sums) gives sums (kRows, kWide) of a block of rows and a panel of columns.
template <class Products>
static void search(int n, int m, const Products& products, int32_t* first, float* value, float* second, int32_t* reverse) {
  constexpr float low = -std::numeric_limits<float>::max();
  const int panels = (m + kWide - 1) / kWide, blocks = (n + kRows - 1) / kRows;
  std::vector<float> top(blocks * kRows, low), next(blocks * kRows, low), column(panels * kWide, low);
  std::vector<int32_t> where(blocks * kRows, -1), row(panels * kWide, -1);
  alignas(64) float sums[kRows * kWide];
  // a strip of blocks stays in the second-level cache while the panels pass by
  constexpr int kStrip = 64;
  for (int strip = 0; strip < blocks; strip += kStrip)
    for (int p = 0; p < panels; ++p) {
      const int wide = std::min(kWide, m - p * kWide);
      float* c = column.data() + p * kWide;
      int32_t* cr = row.data() + p * kWide;
      for (int block = strip; block < std::min(blocks, strip + kStrip); ++block) {
        products(block, p, sums);
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

static void best(const float* a, int n, const float* b, int m, int k, int32_t* first, float* value, float* second, int32_t* reverse) {
  const int panels = (m + kWide - 1) / kWide, blocks = (n + kRows - 1) / kRows;
  std::vector<float> packed(size_t(panels) * k * kWide, 0.0f), rows(size_t(blocks) * kRows * k, 0.0f);
  std::copy_n(a, size_t(n) * k, rows.data());
  for (int j = 0; j < m; ++j)
    for (int i = 0; i < k; ++i) packed[(size_t(j / kWide) * k + i) * kWide + j % kWide] = b[size_t(j) * k + i];
  const auto of = [&](int block, int p, float* sums) {
    products(rows.data() + size_t(block) * kRows * k, k, packed.data() + size_t(p) * k * kWide, sums);
  };
  search(n, m, of, first, value, second, reverse);
}

// Products of bytes are exact in whole numbers.  In a panel the values of `Group` neighbouring places stand together for
// each column, as the instructions want them: pairs of 16 bit, or four of 8 bit.
constexpr int kPair = 2, kFour = 4;

// Whole numbers of 32 bit in a vector: one in all lanes; sums that products of pairs are added to.
#if defined(__AVX512BW__)
#define RB_INTS
typedef __m512i Ints;
static inline Ints everywhere(int32_t x) { return _mm512_set1_epi32(x); }
static inline Ints with_pairs(Ints sum, Ints a, Ints b) { return _mm512_add_epi32(sum, _mm512_madd_epi16(a, b)); }
#elif defined(__AVX2__)
#define RB_INTS
typedef __m256i Ints;
static inline Ints everywhere(int32_t x) { return _mm256_set1_epi32(x); }
static inline Ints with_pairs(Ints sum, Ints a, Ints b) { return _mm256_add_epi32(sum, _mm256_madd_epi16(a, b)); }
#elif defined(__SSE2__)
#define RB_INTS
typedef __m128i Ints;
static inline Ints everywhere(int32_t x) { return _mm_set1_epi32(x); }
static inline Ints with_pairs(Ints sum, Ints a, Ints b) { return _mm_add_epi32(sum, _mm_madd_epi16(a, b)); }
#endif

// sums (kRows, kWide) of products of kRows rows (length k) and a panel of pairs.
static inline void pair_products(const int16_t* a, int k, const int16_t* panel, int32_t* sums) {
#if defined(RB_INTS)
  Ints acc[kRows][2] = {};
  for (int i = 0; i < k; i += kPair, panel += kPair * kWide) {
    Ints b0, b1;
    std::memcpy(&b0, panel, sizeof b0);
    std::memcpy(&b1, panel + kPair * kLanes, sizeof b1);
    for (int r = 0; r < kRows; ++r) {
      int32_t two;
      std::memcpy(&two, a + r * k + i, sizeof two);
      const Ints f = everywhere(two);
      acc[r][0] = with_pairs(acc[r][0], f, b0);
      acc[r][1] = with_pairs(acc[r][1], f, b1);
    }
  }
  std::memcpy(sums, acc, sizeof acc);
#else
  std::fill_n(sums, kRows * kWide, 0);
  for (int i = 0; i < k; i += kPair, panel += kPair * kWide)
    for (int r = 0; r < kRows; ++r)
      for (int x = 0; x < kWide; ++x)
        sums[r * kWide + x] += int32_t(a[r * k + i]) * panel[kPair * x] + int32_t(a[r * k + i + 1]) * panel[kPair * x + 1];
#endif
}

#if defined(__AVX512BW__)
#define RB_FOURS
// The same of bytes, four at a time; those of the panel are 128 less, for the instruction wants them signed.  Written
// out once more, since a function for other processors than its caller is not inlined.
__attribute__((target("avx512vnni"))) static void four_products(const uint8_t* a, int k, const int8_t* panel, int32_t* sums) {
  __m512i acc[kRows][2] = {};
  for (int i = 0; i < k; i += kFour, panel += kFour * kWide) {
    const __m512i b0 = _mm512_loadu_si512(panel), b1 = _mm512_loadu_si512(panel + kFour * kLanes);
    for (int r = 0; r < kRows; ++r) {
      int32_t four;
      std::memcpy(&four, a + r * k + i, sizeof four);
      const __m512i f = _mm512_set1_epi32(four);
      acc[r][0] = _mm512_dpbusd_epi32(acc[r][0], f, b0);
      acc[r][1] = _mm512_dpbusd_epi32(acc[r][1], f, b1);
    }
  }
  std::memcpy(sums, acc, sizeof acc);
}
#endif

// 1 / length of each row of a (n, k), and the sum of its elements.
static void lengths(const uint8_t* a, int n, int k, float* inverse, int32_t* sum) {
  for (int i = 0; i < n; ++i) {
    int32_t square = 0, all = 0;
    for (int j = 0; j < k; ++j) {
      square += int32_t(a[size_t(i) * k + j]) * a[size_t(i) * k + j];
      all += a[size_t(i) * k + j];
    }
    inverse[i] = square ? float(1 / std::sqrt(double(square))) : 0.0f;
    sum[i] = all;
  }
}

static void best_bytes(const uint8_t* a, int n, const uint8_t* b, int m, int k, int32_t* first, float* value, float* second,
                       int32_t* reverse) {
  const int panels = (m + kWide - 1) / kWide, blocks = (n + kRows - 1) / kRows;
  std::vector<float> length_a(blocks * kRows, 0.0f), length_b(panels * kWide, 0.0f);
  std::vector<int32_t> sum_a(blocks * kRows, 0), sum_b(panels * kWide, 0);
  lengths(a, n, k, length_a.data(), sum_a.data());
  lengths(b, m, k, length_b.data(), sum_b.data());
  alignas(64) int32_t whole[kRows * kWide];
  const auto scaled = [&](int block, int p, int more, float* sums) {
    for (int r = 0; r < kRows; ++r) {
      const int32_t back = more * sum_a[block * kRows + r];
      const float l = length_a[block * kRows + r];
      for (int x = 0; x < kWide; ++x) sums[r * kWide + x] = float(whole[r * kWide + x] + back) * l * length_b[p * kWide + x];
    }
  };
  const auto packed = [&](auto* panel, int group, int less) {
    for (int j = 0; j < m; ++j)
      for (int i = 0; i < k; ++i)
        panel[((size_t(j / kWide) * (k / group) + i / group) * kWide + j % kWide) * group + i % group] =
            static_cast<std::remove_reference_t<decltype(*panel)>>(b[size_t(j) * k + i] - less);
  };
#if defined(RB_FOURS)
  static const bool fours = __builtin_cpu_supports("avx512vnni");
  if (fours) {
    std::vector<uint8_t> rows(size_t(blocks) * kRows * k, 0);
    std::vector<int8_t> panel(size_t(panels) * k * kWide, 0);
    std::copy_n(a, size_t(n) * k, rows.data());
    packed(panel.data(), kFour, 128);
    const auto of = [&](int block, int p, float* sums) {
      four_products(rows.data() + size_t(block) * kRows * k, k, panel.data() + size_t(p) * k * kWide, whole);
      scaled(block, p, 128, sums);
    };
    search(n, m, of, first, value, second, reverse);
    return;
  }
#endif
  std::vector<int16_t> rows(size_t(blocks) * kRows * k, 0), panel(size_t(panels) * k * kWide, 0);
  std::copy_n(a, size_t(n) * k, rows.data());
  packed(panel.data(), kPair, 0);
  const auto of = [&](int block, int p, float* sums) {
    pair_products(rows.data() + size_t(block) * kRows * k, k, panel.data() + size_t(p) * k * kWide, whole);
    scaled(block, p, 0, sums);
  };
  search(n, m, of, first, value, second, reverse);
}

#if defined(__GNUC__)
typedef double Four __attribute__((vector_size(32)));
typedef int32_t FourInts __attribute__((vector_size(16)));
typedef uint16_t FourGreys __attribute__((vector_size(8)));
static inline Four greys(const uint16_t* p) {
#if defined(__AVX2__)  // compilers make four times as many instructions of the conversions below
  return _mm256_cvtepi32_pd(_mm_cvtepu16_epi32(_mm_loadl_epi64(reinterpret_cast<const __m128i*>(p))));
#endif
  FourGreys g;
  std::memcpy(&g, p, sizeof g);
  return __builtin_convertvector(__builtin_convertvector(g, FourInts), Four);
}
#else
struct Four {
  double a[4];
  double operator[](int i) const { return a[i]; }
};
static inline Four operator*(const Four& x, const Four& y) { return {x.a[0] * y.a[0], x.a[1] * y.a[1], x.a[2] * y.a[2], x.a[3] * y.a[3]}; }
static inline Four operator*(double x, const Four& y) { return {x * y.a[0], x * y.a[1], x * y.a[2], x * y.a[3]}; }
static inline Four operator+(const Four& x, const Four& y) { return {x.a[0] + y.a[0], x.a[1] + y.a[1], x.a[2] + y.a[2], x.a[3] + y.a[3]}; }
static inline Four greys(const uint16_t* p) { return {double(p[0]), double(p[1]), double(p[2]), double(p[3])}; }
#endif
static inline double across(const Four& v) { return (v[0] + v[1]) + (v[2] + v[3]); }

// Weights of the four neighbours for a fraction t, cubic convolution (Keys 1981, a = -1/2), and their derivatives.
constexpr Four kCubic[4] = {{0, 1, 0, 0}, {-0.5, 0, 0.5, 0}, {1, -2.5, 2, -0.5}, {-0.5, 1.5, -1.5, 0.5}};
static inline Four cubic(double t) { return kCubic[0] + t * (kCubic[1] + t * (kCubic[2] + t * kCubic[3])); }
static inline Four cubic_slope(double t) { return kCubic[1] + t * (2.0 * kCubic[2] + (3.0 * t) * kCubic[3]); }

// Value at x, y of the pixel frame (centre of the first pixel 0.5, 0.5), 2 px away from the border; gradient on request.
static inline double sample(const Grey& g, double x, double y, double* gx = nullptr, double* gy = nullptr) {
  x -= 0.5;
  y -= 0.5;
  const int ix = int(x), iy = int(y);  // both positive
  const Four wx = cubic(x - ix), wy = cubic(y - iy);
  const uint16_t* p = g.data + int64_t(iy - 1) * g.width + ix - 1;
  const Four line[4] = {greys(p), greys(p + g.width), greys(p + 2 * int64_t(g.width)), greys(p + 3 * int64_t(g.width))};
  const Four column = wy[0] * line[0] + wy[1] * line[1] + (wy[2] * line[2] + wy[3] * line[3]);
  if (gx) {
    const Four dy = cubic_slope(y - iy);
    *gx = across(cubic_slope(x - ix) * column);
    *gy = across(wx * (dy[0] * line[0] + dy[1] * line[1] + (dy[2] * line[2] + dy[3] * line[3])));
  }
  return across(wx * column);
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

// Arrays end with positions of weight 0, so that they fill vectors.
struct Window {
  int count;                                 // positions that count
  int filled;                                // positions in an array
  std::vector<double> u, v, w, T, G, J, WJ;  // J, WJ (kUnknowns, filled); WJ weighted
  double total;
};

// What the residuals e of a match show of displacements of its parts and of curvature: grey^2, displacements in the
// target. L: factor of the normal matrix.
static void judge(const Window& o, int side, const double* e, const double L[kUnknowns][kUnknowns], double square,
                  double contrast, double mean, const double* B, double* found) {
  double b[kParts * kParts][2] = {}, t[3] = {};
  for (int i = 0; i < o.count; ++i) {
    double* of = b[i / side * kParts / side * kParts + i % side * kParts / side];
    const double gx = o.J[i], gy = o.J[o.filled + i], w = o.w[i];
    of[0] += w * gx * e[i];
    of[1] += w * gy * e[i];
    t[0] += w * w * gx * gx;
    t[1] += w * w * gx * gy;
    t[2] += w * w * gy * gy;
  }
  double m[3] = {};
  for (const auto& of : b) {
    m[0] += of[0] * of[0];
    m[1] += of[0] * of[1];
    m[2] += of[1] * of[1];
  }
  // displacements as (u^2 + v^2) / 2 along x and y: less what the unknowns take of them
  double a[2] = {}, s[2][2] = {}, h[2][kUnknowns] = {}, c[2][kUnknowns];
  for (int i = 0; i < o.count; ++i) {
    const double q = 0.5 * (o.u[i] * o.u[i] + o.v[i] * o.v[i]), x = q * o.J[i], y = q * o.J[o.filled + i], w = o.w[i];
    a[0] -= w * x * e[i];
    a[1] -= w * y * e[i];
    s[0][0] += w * x * x;
    s[0][1] += w * x * y;
    s[1][1] += w * y * y;
    for (int k = 0; k < kUnknowns; ++k) {
      h[0][k] += x * o.WJ[k * o.filled + i];
      h[1][k] += y * o.WJ[k * o.filled + i];
    }
  }
  std::memcpy(c, h, sizeof c);
  for (int i = 0; i < 2; ++i) {
    solve(L, c[i]);
    for (int k = 0; k < kUnknowns; ++k) a[i] += c[i][k] * dot(o.WJ.data() + k * o.filled, e, o.filled);
    for (int j = i; j < 2; ++j)
      for (int k = 0; k < kUnknowns; ++k) s[i][j] -= c[i][k] * h[j][k];
  }
  const double bend[3] = {s[0][0], s[0][1], s[1][1]};
  const double det = B[0] * B[3] - B[1] * B[2];
  const double C[4] = {B[3] / det, -B[1] / det, -B[2] / det, B[0] / det};  // reference from target
  const double grey = contrast * contrast;
  found[0] = square / o.total * o.count / (o.count - kUnknowns) * grey;
  found[1] = mean;
  const auto in_target = [&](const double* s, double unit, double* to) {
    to[0] = unit * (C[0] * (C[0] * s[0] + C[2] * s[1]) + C[2] * (C[0] * s[1] + C[2] * s[2]));
    to[1] = unit * (C[0] * (C[1] * s[0] + C[3] * s[1]) + C[2] * (C[1] * s[1] + C[3] * s[2]));
    to[2] = unit * (C[1] * (C[1] * s[0] + C[3] * s[1]) + C[3] * (C[1] * s[1] + C[3] * s[2]));
  };
  in_target(m, grey, found + 2);
  in_target(t, 1, found + 5);
  found[8] = grey * (C[0] * a[0] + C[2] * a[1]);
  found[9] = grey * (C[1] * a[0] + C[3] * a[1]);
  in_target(bend, grey, found + 10);
  found[13] = 0.5 * (c[0][0] + c[1][1]);
}

static void match(const Grey& reference, const Grey& target, const Patch& patch, int begin, int end, const double* xy_reference,
                  double* xy, double* affine, double* covariance, double* correlation, double* residual, int32_t* outcome) {
  const int h = patch.half, side = 2 * h + 1, count = side * side, filled = (count + kDoubles - 1) / kDoubles * kDoubles;
  Window o;
  o.count = count;
  o.filled = filled;
  for (auto* a : {&o.u, &o.v, &o.w, &o.T, &o.G}) a->assign(filled, 0);
  for (auto* a : {&o.J, &o.WJ}) a->assign(kUnknowns * filled, 0);
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
    mean = dot(w, a, filled) / o.total;
    D sum = {};
    for (int i = 0; i < filled; i += kDoubles) {
      const D x = load(a + i) - mean;
      store(a + i, x);
      sum += load(w + i) * x * x;
    }
    const double scale = std::sqrt(summed(sum) / o.total);
    if (!(scale > 1e-6)) return 0.0;
    const double inverse = 1 / scale;
    for (int i = 0; i < filled; i += kDoubles) store(a + i, load(a + i) * inverse);
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
    double *T = o.T.data(), *G = o.G.data(), *J = o.J.data(), *WJ = o.WJ.data();
    for (int i = 0; i < count; ++i) {
      double gx, gy;
      T[i] = sample(reference, c[0] + o.u[i], c[1] + o.v[i], &gx, &gy);
      J[i] = gx;
      J[filled + i] = gy;
    }
    const double contrast = normalise(T);
    if (contrast == 0) {
      outcome[n] = flat;
      continue;
    }
    const double grey_level = mean, level = mean / contrast;
    for (int i = 0; i < count; ++i) {
      const double gx = J[i] /= contrast, gy = J[filled + i] /= contrast;
      J[2 * filled + i] = gx * o.u[i];
      J[3 * filled + i] = gx * o.v[i];
      J[4 * filled + i] = gy * o.u[i];
      J[5 * filled + i] = gy * o.v[i];
      J[6 * filled + i] = 1;
      J[7 * filled + i] = T[i];
      J[8 * filled + i] = o.u[i] * (T[i] + level) / h;
      J[9 * filled + i] = o.v[i] * (T[i] + level) / h;
    }
    for (int a = 0; a < kUnknowns; ++a)
      for (int i = 0; i < filled; i += kDoubles) store(WJ + a * filled + i, load(w + i) * load(J + a * filled + i));
    double N[kUnknowns][kUnknowns];
    for (int a = 0; a < kUnknowns; ++a)
      for (int b = 0; b <= a; ++b) N[a][b] = dot(WJ + a * filled, J + b * filled, filled);
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
      double d[kUnknowns];
      D sum = {};
      for (int i = 0; i < filled; i += kDoubles) {
        const D e = load(G + i) - load(T + i);
        store(G + i, e);
        sum += load(w + i) * e * e;
      }
      const double square = summed(sum);
      const double product = 1 - square / (2 * o.total);  // correlation of two normalised windows
      for (int a = 0; a < kUnknowns; ++a) d[a] = dot(WJ + a * filled, G, filled);
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
        judge(o, side, G, L, square, contrast, grey_level, B, residual + kResidual * n);
        break;
      }
    }
  }
}

extern const ImagingKernels imaging;
const ImagingKernels imaging = {&best, &best_bytes, &match};

}  // namespace RB_ARCH
}  // namespace raybundle
