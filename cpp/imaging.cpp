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
#include "nearest.inl"

static inline V load(const float* a) {
  V v;
  std::memcpy(&v, a, sizeof v);
  return v;
}
static inline void store(float* a, V v) { std::memcpy(a, &v, sizeof v); }

// Coefficients of 1, t, t^2, t^3 in the weights of the four neighbours.
typedef double Basis[4][4];
constexpr Basis kConvolution = {{0, 1, 0, 0}, {-0.5, 0, 0.5, 0}, {1, -2.5, 2, -0.5}, {-0.5, 1.5, -1.5, 0.5}};  // Keys 1981, a = -1/2
constexpr Basis kSpline = {{1 / 6.0, 2 / 3.0, 1 / 6.0, 0}, {-0.5, 0, 0.5, 0}, {0.5, -1, 0.5, 0}, {-1 / 6.0, 0.5, -0.5, 1 / 6.0}};  // Unser 1993

static inline double cubic(const Basis& k, double t, int i) { return k[0][i] + t * (k[1][i] + t * (k[2][i] + t * k[3][i])); }
static inline double slope(const Basis& k, double t, int i) { return k[1][i] + t * (2 * k[2][i] + 3 * t * k[3][i]); }

#if defined(__GNUC__)
typedef int32_t Whole __attribute__((vector_size(kBytes)));
constexpr int kFours = kLanes / 4;  // groups of four lanes in a vector

// Of each group of four: lanes a and b of x, lanes c and d of y.
template <int a, int b, int c, int d> static inline V pick(V x, V y) {
  [[maybe_unused]] constexpr int control = a | b << 2 | c << 4 | d << 6;
#if defined(__AVX512F__)
  return _mm512_shuffle_ps(x, y, control);
#elif defined(__AVX2__)
  return _mm256_shuffle_ps(x, y, control);
#elif defined(__SSE2__)
  return _mm_shuffle_ps(x, y, control);
#else
  return V{x[a], x[b], y[c], y[d]};
#endif
}

// Of each group of four: the sums of a, b, c and d.
static inline V across(V a, V b, V c, V d) {
  const V x = pick<0, 1, 0, 1>(a, b) + pick<2, 3, 2, 3>(a, b), y = pick<0, 1, 0, 1>(c, d) + pick<2, 3, 2, 3>(c, d);
  return pick<0, 2, 0, 2>(x, y) + pick<1, 3, 1, 3>(x, y);
}

// Sums of four vectors.
static inline void sums(V a, V b, V c, V d, double* into) {
  float each[kLanes];
  store(each, across(a, b, c, d));
  for (int i = 0; i < 4; ++i) {
    into[i] = 0;
    for (int k = 0; k < kFours; ++k) into[i] += each[4 * k + i];
  }
}

// Four neighbouring grey values from each of these places on, after p, less `base`: small numbers are exact to more digits.
static inline V greys(const uint16_t* p, const int32_t* place, float base) {
#if defined(__SSE2__)
  const auto at = [&](int i) { return _mm_loadl_epi64(reinterpret_cast<const __m128i*>(p + place[i])); };
#if defined(__AVX512F__)
  const __m128i low = _mm_unpacklo_epi64(at(0), at(4)), high = _mm_unpacklo_epi64(at(8), at(12));
  return _mm512_cvtepi32_ps(_mm512_cvtepu16_epi32(_mm256_set_m128i(high, low))) - base;
#elif defined(__AVX2__)
  return _mm256_cvtepi32_ps(_mm256_cvtepu16_epi32(_mm_unpacklo_epi64(at(0), at(4)))) - base;
#else
  return _mm_cvtepi32_ps(_mm_unpacklo_epi16(at(0), _mm_setzero_si128())) - base;
#endif
#else
  const uint16_t* q = p + *place;
  return V{float(q[0]), float(q[1]), float(q[2]), float(q[3])} - base;
#endif
}

struct Repeated {
  V of[4];
  explicit Repeated(const Basis& basis) {
    for (int k = 0; k < 4; ++k)
      for (int i = 0; i < kLanes; ++i) of[k][i] = float(basis[k][i % 4]);
  }
};
static inline V cubic(const Repeated& k, V t) { return k.of[0] + t * (k.of[1] + t * (k.of[2] + t * k.of[3])); }

// Four places, one of each group of four lanes, weighted: the sum of each group is to be formed.
template <int lane> static inline V weighted(const Repeated& basis, const uint16_t* p, int64_t width, const int32_t* place, V tx, V ty, float base) {
  const V wx = cubic(basis, pick<lane, lane, lane, lane>(tx, tx)), wy = cubic(basis, pick<lane, lane, lane, lane>(ty, ty));
  const auto line = [&](int j) { return greys(p + j * width, place + lane, base); };
  return wx * ((pick<0, 0, 0, 0>(wy, wy) * line(0) + pick<1, 1, 1, 1>(wy, wy) * line(1)) +
               (pick<2, 2, 2, 2>(wy, wy) * line(2) + pick<3, 3, 3, 3>(wy, wy) * line(3)));
}

// Grey values after p at places, at tx, ty of the way to their neighbours; two pixels and more away from the border.
static inline V sample(const Repeated& basis, const uint16_t* p, int64_t width, const int32_t* place, V tx, V ty, float base) {
  p -= width + 1;
  return across(weighted<0>(basis, p, width, place, tx, ty, base), weighted<1>(basis, p, width, place, tx, ty, base),
                weighted<2>(basis, p, width, place, tx, ty, base), weighted<3>(basis, p, width, place, tx, ty, base));
}
static inline Whole floored(V x) {
  const Whole i = __builtin_convertvector(x, Whole);
  return i + (x < __builtin_convertvector(i, V));
}
static inline V real(Whole i) { return __builtin_convertvector(i, V); }
#else
static inline void sums(V a, V b, V c, V d, double* into) { into[0] = a, into[1] = b, into[2] = c, into[3] = d; }
struct Repeated {
  const Basis& of;
  explicit Repeated(const Basis& basis) : of(basis) {}
};
static inline V sample(const Repeated& basis, const uint16_t* p, int64_t width, const int32_t* place, V tx, V ty, float base) {
  p += *place - width - 1;
  V sum = 0;
  for (int j = 0; j < 4; ++j)
    for (int i = 0; i < 4; ++i) sum += float(cubic(basis.of, tx, i) * cubic(basis.of, ty, j)) * (p[j * width + i] - base);
  return sum;
}
typedef int32_t Whole;
static inline Whole floored(V x) { return int32_t(std::floor(x)); }
static inline V real(Whole i) { return float(i); }
#endif
static inline double summed(V v) {
  double all[4];
  sums(v, V{}, V{}, V{}, all);
  return all[0];
}
// Sums over n values, a multiple of kLanes, of the products of a with four rows.
static inline void products_of_four(const float* a, const float* rows, int n, double* into) {
  V sum[4] = {};
  for (int i = 0; i < n; i += kLanes)
    for (int k = 0; k < 4; ++k) sum[k] += load(a + i) * load(rows + k * n + i);
  sums(sum[0], sum[1], sum[2], sum[3], into);
}

static inline bool inside(const Grey& g, double x, double y) { return x >= 2.5 && y >= 2.5 && x <= g.width - 2.5 && y <= g.height - 2.5; }

// Corners of the window u = (+-h, +-h) under p + B u, and as far around as curvature C displaces them.
static bool window_inside(const Grey& g, const double* p, const double* B, const double* C, double h) {
  const double r[2] = {h * h * (0.5 * std::abs(C[0]) + std::abs(C[1]) + 0.5 * std::abs(C[2])),
                       h * h * (0.5 * std::abs(C[3]) + std::abs(C[4]) + 0.5 * std::abs(C[5]))};
  if (!((h * (std::abs(B[2]) + std::abs(B[3])) + r[1]) * g.width < 1e9)) return false;  // places are counted with 32 bit
  for (int a = -1; a <= 1; a += 2)
    for (int b = -1; b <= 1; b += 2)
      for (int s = -1; s <= 1; s += 2)
        if (!inside(g, p[0] + h * (B[0] * a + B[1] * b) + s * r[0], p[1] + h * (B[2] * a + B[3] * b) + s * r[1])) return false;
  return true;
}

constexpr int kLight = 4;     // brightness, contrast, slope of the illumination in x and y
constexpr int kAffine = 6;    // shift, affine map
constexpr int kQuadratic = 12;  // and displacements as u^2 / 2, u v, v^2 / 2 along x and y

// L L' = N (lower) with the inverse of its diagonal; false where N, which had `taken` more on its diagonal before
// unknowns were eliminated, is not positive definite beyond rounding.
template <int n> static bool cholesky(const double N[n][n], const double* taken, double L[n][n], double* inverse) {
  for (int i = 0; i < n; ++i)
    for (int j = 0; j <= i; ++j) {
      double s = N[i][j];
      for (int k = 0; k < j; ++k) s -= L[i][k] * L[j][k];
      if (i == j) {
        if (!(s > 1e-9 * (N[i][i] + taken[i])) || !(s > 0)) return false;
        L[i][i] = std::sqrt(s);
        inverse[i] = 1 / L[i][i];
      } else {
        L[i][j] = s * inverse[j];
      }
    }
  return true;
}

template <int n> static void solve(const double L[n][n], const double* inverse, double* b) {
  for (int i = 0; i < n; ++i) {
    for (int k = 0; k < i; ++k) b[i] -= L[i][k] * b[k];
    b[i] *= inverse[i];
  }
  for (int i = n - 1; i >= 0; --i) {
    for (int k = i + 1; k < n; ++k) b[i] -= L[k][i] * b[k];
    b[i] *= inverse[i];
  }
}

// The reference window.  Arrays end with positions of weight 0, so that rows of whole vectors fit in.
// The columns have what the light explains taken from them: of brightness, contrast and slopes the rest is free.
// With kShape unknowns of the shape; an affine one has displacements as (u^2 + v^2) / 2 along x and y in columns that are not adjusted.
template <int kShape> struct Window {
  static constexpr int kColumns = kShape == kAffine ? 8 : kQuadratic, kUnknowns = kLight + kShape;
  const Basis& basis;
  const Repeated repeated;
  int half, side, count, filled;  // positions that count, positions in an array
  double total = 0;
  std::vector<float> room;
  std::vector<int32_t> place;  // of positions in the target
  std::vector<uint8_t> part;  // of the window, by position
  float *u, *v, *w, *T, *e, *tx, *ty, *g, *light, *column, *weighted;  // g (2, filled), light (kLight, filled), column and weighted (kColumns, filled)
  float *patch, *line, *slopes;  // grey values with those around, (side + 3, row); between two lines of them, and the slope there
  int row;
  double contrast, level;               // of the grey values
  float base;                           // near the mean of the target
  double N[kColumns][kColumns];         // of the columns
  double taken[kShape];

  Window(const Basis& basis, int half, double sigma) : basis(basis), repeated(basis), half(half), side(2 * half + 1), count(side * side) {
    const auto whole = [](int n) { return (n + kLanes - 1) / kLanes * kLanes; };
    filled = whole(count - side + whole(side)), row = whole(side + 3);
    place.resize(size_t(filled));
    const int rows = 9 + kLight + 2 * kColumns;
    room.assign(size_t(rows) * filled + size_t(side + 5) * row + 4 * kLanes, 0.0f);
    float* at = room.data();
    while (reinterpret_cast<uintptr_t>(at) % (kLanes * sizeof(float))) ++at;
    u = at, v = u + filled, w = v + filled, T = w + filled, e = T + filled, tx = e + filled, ty = tx + filled, g = ty + filled, light = g + 2 * filled;
    column = light + kLight * filled, weighted = column + kColumns * filled, patch = weighted + kColumns * filled;
    line = patch + (side + 3) * row, slopes = line + row + kLanes;
    for (int i = 0; i < count; ++i) {
      const double x = i % side - half, y = i / side - half;
      u[i] = float(x), v[i] = float(y), w[i] = float(std::exp(-(x * x + y * y) / (2 * sigma * sigma)));
      total += w[i];
      part.push_back(uint8_t(i / side * kParts / side * kParts + i % side * kParts / side));
    }
  }

  // Weighted mean to 0, weighted variance to 1; their scale, 0 where there is no contrast.
  double normalise(float* a, double& mean) const {
    V sum = {};
    for (int i = 0; i < filled; i += kLanes) sum += load(w + i) * load(a + i);
    mean = summed(sum) / total;
    double square = 0;  // of few terms at a time: what the scale is wrong by goes into the residuals
    for (int i = 0; i < filled;) {
      sum = V{};
      for (const int end = std::min(i + 4 * kLanes, filled); i < end; i += kLanes) {
        const V x = load(a + i) - float(mean);
        store(a + i, x);
        sum += load(w + i) * x * x;
      }
      square += summed(sum);
    }
    const double scale = std::sqrt(square / total);
    if (!(scale > 1e-6 * (1 + std::abs(mean)))) return 0;  // weights of neighbours make 1 but for rounding
    const float inverse = float(1 / scale), less = float(1 / scale - inverse);
    for (int i = 0; i < filled; i += kLanes) store(a + i, load(a + i) * inverse + load(a + i) * less);
    return scale;
  }

  // Grey values less their mean, which is returned, and gradients: all positions are at the same place between the pixels.
  double read(const Grey& image, const double* c) {
    const int x = int(c[0] - 0.5), y = int(c[1] - 0.5), wide = side + 3;
    float wx[4], wy[4], dx[4], dy[4];
    for (int k = 0; k < 4; ++k) {
      const double tx = c[0] - 0.5 - x, ty = c[1] - 0.5 - y;
      wx[k] = float(cubic(basis, tx, k)), wy[k] = float(cubic(basis, ty, k));
      dx[k] = float(slope(basis, tx, k)), dy[k] = float(slope(basis, ty, k));
    }
    int64_t sum = 0;
    for (int j = 0; j < wide; ++j) {
      const uint16_t* from = image.data + int64_t(y - half - 1 + j) * image.width + x - half - 1;
      for (int i = 0; i < wide; ++i) patch[j * row + i] = float(from[i]), sum += from[i];
    }
    const float mean = float(sum / (wide * wide));
    for (int i = 0; i < wide * row; i += kLanes) store(patch + i, load(patch + i) - mean);
    for (int j = 0; j < side; ++j) {
      for (int i = 0; i < row; i += kLanes) {
        V value = {}, change = {};
        for (int k = 0; k < 4; ++k) {
          const V p = load(patch + (j + k) * row + i);
          value += wy[k] * p, change += dy[k] * p;
        }
        store(line + i, value), store(slopes + i, change);
      }
      for (int i = 0; i < side; i += kLanes) {
        V value = {}, along = {}, down = {};
        for (int k = 0; k < 4; ++k) {
          const V p = load(line + i + k);
          value += wx[k] * p, along += dx[k] * p, down += wx[k] * load(slopes + i + k);
        }
        store(T + j * side + i, value), store(g + j * side + i, along), store(g + filled + j * side + i, down);
      }
    }
    return mean;
  }

  // What belongs to the place c of the reference; false where it shows nothing.
  bool take(const Grey& image, const double* c) {
    const double base = read(image, c);
    contrast = normalise(T, level);
    if (contrast == 0) return false;
    level += base;
    const float back = float(1 / contrast), bright = float(level / contrast), unit = 1.0f / float(half);
    const int n = filled;
    for (int i = 0; i < n; i += kLanes) {
      const V x = load(u + i), y = load(v + i), t = load(T + i), gx = load(g + i) * back, gy = load(g + n + i) * back;
      const V bent = 0.5f * (x * x + y * y), lit = (t + bright) * unit;
      const V of_light[kLight] = {V{} + 1.0f, t, x * lit, y * lit};
      V of_shape[kColumns] = {gx, gy, gx * x, gx * y, gy * x, gy * y, gx * bent, gy * bent};
      if constexpr (kShape == kQuadratic) {
        const V second[3] = {0.5f * x * x, x * y, 0.5f * y * y};
        for (int k = 0; k < 3; ++k) of_shape[6 + k] = gx * second[k], of_shape[9 + k] = gy * second[k];
      }
      store(g + i, gx), store(g + n + i, gy);
      for (int k = 0; k < kLight; ++k) store(light + k * n + i, of_light[k]), store(weighted + k * n + i, load(w + i) * of_light[k]);
      for (int k = 0; k < kColumns; ++k) store(column + k * n + i, of_shape[k]);
    }
    double M[kLight][kLight], L[kLight][kLight], inverse[kLight];
    for (int k = 0; k < kLight; ++k) products_of_four(light + k * n, weighted, n, M[k]);
    const double none[kLight] = {};
    if (!cholesky<kLight>(M, none, L, inverse)) return false;
    float less[kColumns][kLight];
    for (int k = 0; k < kColumns; ++k) {
      double b[kLight], x[kLight];
      products_of_four(column + k * n, weighted, n, b);
      std::copy_n(b, kLight, x);
      solve<kLight>(L, inverse, x);
      if (k < kShape) taken[k] = b[0] * x[0] + b[1] * x[1] + b[2] * x[2] + b[3] * x[3];
      for (int r = 0; r < kLight; ++r) less[k][r] = float(x[r]);
    }
    for (int i = 0; i < n; i += kLanes) {
      const V l0 = load(light + i), l1 = load(light + n + i), l2 = load(light + 2 * n + i), l3 = load(light + 3 * n + i), of = load(w + i);
      for (int k = 0; k < kColumns; ++k) {
        const V rest = load(column + k * n + i) - (less[k][0] * l0 + less[k][1] * l1 + less[k][2] * l2 + less[k][3] * l3);
        store(column + k * n + i, rest), store(weighted + k * n + i, of * rest);
      }
    }
    for (int k = 0; k < kColumns; ++k)
      for (int j = 0; j <= k; j += 4) products_of_four(column + k * n, weighted + j * n, n, N[k] + j);
    return true;
  }

  // Grey values of the target less those of the reference, both normalised; sums with the weighted columns and the
  // weighted square sum; false where the target has no contrast.
  bool compare(const Grey& target, const double* p, const double* B, const double* C, double* with, double& square) {
    const int x0 = int(p[0] - 0.5), y0 = int(p[1] - 0.5), n = filled;
    const uint16_t* pixel = target.data + int64_t(y0) * target.width + x0;
    const double fx = p[0] - 0.5 - x0, fy = p[1] - 0.5 - y0;
    const float px = float(fx), py = float(fy), qx = float(fx - px), qy = float(fy - py);  // the second is what rounding takes
    const float b0 = float(B[0] - 1), b1 = float(B[1]), b2 = float(B[2]), b3 = float(B[3] - 1);
    for (int i = 0; i < n; i += kLanes) {
      // the places less their own positions in the window: small numbers, as with grey values
      const V a = load(u + i), b = load(v + i);
      V x = px + (qx + b0 * a + b1 * b), y = py + (qy + b2 * a + b3 * b);
      if constexpr (kShape == kQuadratic) {
        const V aa = 0.5f * a * a, ab = a * b, bb = 0.5f * b * b;
        x += float(C[0]) * aa + float(C[1]) * ab + float(C[2]) * bb;
        y += float(C[3]) * aa + float(C[4]) * ab + float(C[5]) * bb;
      }
      const Whole ix = floored(x), iy = floored(y);
      const Whole at = (iy + floored(b)) * target.width + ix + floored(a);
      store(tx + i, x - real(ix)), store(ty + i, y - real(iy));
      std::memcpy(place.data() + i, &at, sizeof at);
    }
    for (int i = 0; i < n; i += kLanes) store(e + i, sample(repeated, pixel, target.width, place.data() + i, load(tx + i), load(ty + i), base));
    double mean;
    if (normalise(e, mean) == 0) return false;
    base += float(std::round(mean));
    V sum[kColumns] = {}, all = {};
    for (int i = 0; i < n; i += kLanes) {
      const V d = load(e + i) - load(T + i);
      store(e + i, d);
      all += load(w + i) * d * d;
      for (int k = 0; k < kColumns; ++k) sum[k] += load(weighted + k * n + i) * d;
    }
    for (int k = 0; k < kColumns; k += 4) sums(sum[k], sum[k + 1], sum[k + 2], sum[k + 3], with + k);
    square = summed(all);
    return true;
  }

  // What the residuals of a match show of displacements of its parts and of curvature: grey^2, displacements in the
  // target. L: factor of the normal matrix of the shape.
  void judge(const double L[kShape][kShape], const double* inverse, const double* with, double square, const double* B, double* found) const {
    double b[kParts * kParts][2] = {}, m[3] = {}, t[4];
    for (int i = 0; i < count; ++i) {
      const float we = w[i] * e[i];
      b[part[size_t(i)]][0] += we * g[i];
      b[part[size_t(i)]][1] += we * g[filled + i];
    }
    for (const auto& of : b) {
      m[0] += of[0] * of[0];
      m[1] += of[0] * of[1];
      m[2] += of[1] * of[1];
    }
    V s[3] = {};
    for (int i = 0; i < filled; i += kLanes) {
      const V x = load(w + i) * load(g + i), y = load(w + i) * load(g + filled + i);
      s[0] += x * x, s[1] += x * y, s[2] += y * y;
    }
    sums(s[0], s[1], s[2], V{}, t);
    double a[2] = {}, bend[3] = {}, c[2][kShape] = {};
    if constexpr (kShape == kAffine) for (int i = 0; i < 2; ++i) {
      std::copy_n(N[kShape + i], kShape, c[i]);
      solve<kShape>(L, inverse, c[i]);
      a[i] = -with[kShape + i];
      for (int k = 0; k < kShape; ++k) a[i] += c[i][k] * with[k];
      for (int j = 0; j <= i; ++j) {
        double& rest = bend[i + j] = N[kShape + i][kShape + j];
        for (int k = 0; k < kShape; ++k) rest -= c[j][k] * N[kShape + i][k];
      }
    }
    const double det = B[0] * B[3] - B[1] * B[2];
    const double C[4] = {B[3] / det, -B[1] / det, -B[2] / det, B[0] / det};  // reference from target
    const double grey = contrast * contrast;
    found[0] = square / total * count / (count - kUnknowns) * grey;
    found[1] = level;
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
};

template <int kShape>
static void match_as(const Grey& reference, const Grey& target, const Patch& patch, int begin, int end, const double* xy_reference,
                     double* xy, double* affine, double* bend, double* covariance, double* correlation, double* residual, int32_t* outcome) {
  Window<kShape> o(patch.spline ? kSpline : kConvolution, patch.half, patch.sigma);
  const int h = patch.half;
  for (int n = begin; n < end; ++n) {
    const double* c = xy_reference + 2 * n;
    double* p = xy + 2 * n;
    double* B = affine + 4 * n;
    double* C = bend + 6 * n;
    const double start[2] = {p[0], p[1]};
    const double given[4] = {B[0], B[1], B[2], B[3]}, size = given[0] * given[3] - given[1] * given[2];
    if (!(std::abs(size) > 1e-3)) {
      outcome[n] = flat;
      continue;
    }
    correlation[n] = 0;
    const double unit[4] = {1, 0, 0, 1}, none[6] = {};
    if (!window_inside(reference, c, unit, none, h)) {
      outcome[n] = outside;
      continue;
    }
    if (!o.take(reference, c)) {
      outcome[n] = flat;
      continue;
    }
    outcome[n] = unsteady;
    o.base = float(std::round(o.level));
    for (int iteration = 0; iteration < patch.iterations; ++iteration) {
      if (!window_inside(target, p, B, C, h)) {
        outcome[n] = outside;
        break;
      }
      double with[Window<kShape>::kColumns], square, d[kShape], N[kShape][kShape], L[kShape][kShape], inverse[kShape];
      if (!o.compare(target, p, B, C, with, square)) {
        outcome[n] = flat;
        break;
      }
      const double product = 1 - square / (2 * o.total);  // correlation of two normalised windows
      // the given affine map is an observation: deviation D = given^-1 B - 1, weight relative to a grey value
      const double weight = std::max(square / o.total, 1e-4) / (patch.loose * patch.loose);
      const double D[4] = {(given[3] * B[0] - given[1] * B[2]) / size - 1, (given[3] * B[1] - given[1] * B[3]) / size,
                           (given[0] * B[2] - given[2] * B[0]) / size, (given[0] * B[3] - given[2] * B[1]) / size - 1};
      for (int k = 0; k < kShape; ++k) std::copy_n(o.N[k], kShape, N[k]);
      std::copy_n(with, kShape, d);
      for (int k = 0; k < 4; ++k) {
        N[2 + k][2 + k] += weight;
        d[2 + k] += weight * D[k];
      }
      if (!cholesky<kShape>(N, o.taken, L, inverse)) {
        outcome[n] = flat;
        break;
      }
      solve<kShape>(L, inverse, d);
      const double limit = 0.25 * h;
      double longest = 0;
      for (int k = 0; k < kShape; ++k) longest = std::max(longest, std::abs(d[k]) * (k < 2 ? 1 : k < kAffine ? h : 0.5 * h * h));
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
      if constexpr (kShape == kQuadratic)  // to first order: at the end nothing is left of d
        for (int k = 0; k < 3; ++k) {
          C[k] -= B[0] * d[6 + k] + B[1] * d[9 + k];
          C[3 + k] -= B[2] * d[6 + k] + B[3] * d[9 + k];
        }
      correlation[n] = product;
      const double x = p[0] - start[0], y = p[1] - start[1];
      if (x * x + y * y > patch.reach * patch.reach) {
        outcome[n] = moved;
        break;
      }
      if (sx * sx + sy * sy < patch.step * patch.step && longest <= limit) {
        outcome[n] = matched;
        // variance of a grey value in units of the normalised window, times the cofactor of the shift, in the target
        double variance = square / o.total * o.count / (o.count - o.kUnknowns), Q[2][2];
        for (int k = 0; k < 2; ++k) {
          double unit_vector[kShape] = {};
          unit_vector[k] = 1;
          solve<kShape>(L, inverse, unit_vector);
          Q[k][0] = unit_vector[0];
          Q[k][1] = unit_vector[1];
        }
        const double q00 = Q[0][0], q01 = Q[0][1], q11 = Q[1][1];
        covariance[3 * n] = variance * (B[0] * (B[0] * q00 + B[1] * q01) + B[1] * (B[0] * q01 + B[1] * q11));
        covariance[3 * n + 1] = variance * (B[2] * (B[2] * q00 + B[3] * q01) + B[3] * (B[2] * q01 + B[3] * q11));
        covariance[3 * n + 2] = variance * (B[2] * (B[0] * q00 + B[1] * q01) + B[3] * (B[0] * q01 + B[1] * q11));
        o.judge(L, inverse, with, square, B, residual + kResidual * n);
        break;
      }
    }
  }
}

static void match(const Grey& reference, const Grey& target, const Patch& patch, int begin, int end, const double* xy_reference,
                  double* xy, double* affine, double* bend, double* covariance, double* correlation, double* residual, int32_t* outcome) {
  const auto kernel = patch.quadratic ? match_as<kQuadratic> : match_as<kAffine>;
  kernel(reference, target, patch, begin, end, xy_reference, xy, affine, bend, covariance, correlation, residual, outcome);
}

extern const ImagingKernels imaging;
const ImagingKernels imaging = {&best, &best_bytes, &match};

}  // namespace RB_ARCH
}  // namespace raybundle
