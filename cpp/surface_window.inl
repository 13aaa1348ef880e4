// Windows of a reference in a source: where the table puts them, and their grey values.  Included by surface.cpp.

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

// Neighbours of as many window pixels as a vector has fours, and a weight of each of these pixels spread over its four.
#if defined(__AVX2__)
typedef V Group;
static inline Group gathered(const float* a, const float* b) { return _mm256_insertf128_ps(_mm256_castps128_ps256(_mm_loadu_ps(a)), _mm_loadu_ps(b), 1); }
template <int k> static inline Group spread(Group w) { return _mm256_shuffle_ps(w, w, k * 0x55); }
static inline void transpose(Group& a, Group& b, Group& c, Group& d) {
  const __m256 p = _mm256_unpacklo_ps(a, b), q = _mm256_unpackhi_ps(a, b), r = _mm256_unpacklo_ps(c, d), s = _mm256_unpackhi_ps(c, d);
  a = _mm256_shuffle_ps(p, r, 0x44);
  b = _mm256_shuffle_ps(p, r, 0xee);
  c = _mm256_shuffle_ps(q, s, 0x44);
  d = _mm256_shuffle_ps(q, s, 0xee);
}
#else
typedef Quad Group;
static inline Group gathered(const float* a, const float*) { return load<Quad>(a); }
template <int k> static inline Group spread(const Group& w) { return Quad{w[k], w[k], w[k], w[k]}; }
#endif

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
static inline Group along(const float* w, const Group* c) {
  return (load<Group>(w) * c[0] + load<Group>(w + kPad) * c[1]) + (load<Group>(w + 2 * kPad) * c[2] + load<Group>(w + 3 * kPad) * c[3]);
}
template <int k> static inline Group across(const float* w, const Group* r) {
  return (spread<k>(load<Group>(w)) * r[0] + spread<k>(load<Group>(w + kPad)) * r[1]) +
         (spread<k>(load<Group>(w + 2 * kPad)) * r[2] + spread<k>(load<Group>(w + 3 * kPad)) * r[3]);
}
// The k-th neighbours of a group: their rows, interpolated along the columns by weights w and, on request, d.
template <int k, bool gradients>
static inline void column(const float* base, const int32_t* offsets, int64_t width, const float* w, const float* d, Group* c, Group* e) {
  const float *p = base + offsets[k], *q = base + offsets[kPad - 4 + k];
  const Group r[4] = {gathered(p, q), gathered(p + width, q + width), gathered(p + 2 * width, q + 2 * width), gathered(p + 3 * width, q + 3 * width)};
  c[k] = across<k>(w, r);
  if (gradients) e[k] = across<k>(d, r);
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
  float sums[kPad];
  std::fill_n(sums, kPad, -level);
  Group sum = {};
  const Group back = load<Group>(sums);
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
    Group c[4], e[4];
    column<0, gradients>(base, offsets, width, wy, dy, c, e);
    column<1, gradients>(base, offsets, width, wy, dy, c, e);
    column<2, gradients>(base, offsets, width, wy, dy, c, e);
    column<3, gradients>(base, offsets, width, wy, dy, c, e);
    transpose(c[0], c[1], c[2], c[3]);
    const Group value = along(wx, c) + back;
    store(g + i, value);
    sum = sum + load<Group>(ws + i) * value;
    if (gradients) {
      transpose(e[0], e[1], e[2], e[3]);
      store(gy + i, along(wx, e));
      store(gx + i, along(dx, c));
    }
  }
  store(sums, sum);
  for (int n = kPad / 2; n; n /= 2)
    for (int k = 0; k < n; ++k) sums[k] += sums[k + n];
  const float mean = float(sums[0] / o.total);
  for (int i = 0; i < filled; i += kLanes) store(g + i, load<V>(g + i) - mean);
  return true;
}
