// Scale space, extrema, directions and descriptors of features, compiled once for every instruction set (RB_ARCH).
#include "features.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <numbers>

namespace raybundle {
namespace RB_ARCH {

#include "lanes.inl"
constexpr int kTogether = 4;                  // vectors that are summed side by side
constexpr int kBlock = kTogether * kLanes;    // columns of a step

static inline V load(const float* a) {
  V v;
  std::memcpy(&v, a, sizeof v);
  return v;
}
static inline void store(float* a, V v) { std::memcpy(a, &v, sizeof v); }

constexpr float kSigma = 1.6f;    // of the first level of an octave [px]
constexpr float kReach = 3.5f;    // of a Gaussian filter, in its standard deviations
constexpr int kSide = 16;         // columns beside a row, more than the widest filter reaches
constexpr int kBorder = 5;        // pixels of a level in which nothing is found
constexpr int kSmallest = 2 * kBorder + 3;
constexpr int kMove = 2;          // pixels from an extremum to the place where its parabola has one
constexpr int kAside = kMove + 2;     // rows and columns about an extremum that are looked at
constexpr int kStrip = 1024;      // columns of a strip: its rows stay in the cache
constexpr float kEdge = 10.0f;    // ratio of curvatures of an edge
constexpr float kGrey = 256.0f;   // units of a level in a grey level
constexpr int kGaussians = kLevels + 3, kDifferences = kLevels + 2;

struct Filter {
  int radius;
  std::array<float, kSide> weight;  // of the pixel itself and of those at each distance
  explicit Filter(double sigma) : radius(std::max(1, int(std::ceil(kReach * sigma)))), weight{} {
    double sum = 0;
    for (int i = 0; i <= radius; ++i) sum += (i ? 2 : 1) * std::exp(-0.5 * i * i / (sigma * sigma));
    for (int i = 0; i <= radius; ++i) weight[size_t(i)] = float(std::exp(-0.5 * i * i / (sigma * sigma)) / sum);
  }
};

// The place of a pixel outside of 0 ... n - 1 in the image mirrored at its outermost pixels.
static inline int mirrored(int i, int n) {
  if (n == 1) return 0;
  while (i < 0 || i >= n) i = i < 0 ? -i : 2 * n - 2 - i;
  return i;
}

// The newest rows of a picture; columns up to the next block are computed and not used.
struct Rows {
  int depth = 0;
  size_t stride = 0;
  std::vector<float> values;
  void reset(int rows, size_t columns) {
    depth = rows;
    stride = columns;
    values.assign(size_t(rows) * columns, 0.0f);
  }
  float* row(int y) { return values.data() + size_t(y % depth) * stride; }
  const float* row(int y) const { return values.data() + size_t(y % depth) * stride; }
};

// Row y of a picture of h rows and w columns, smoothed; and its difference to the row before, if there is a place for it.
static void smooth(const Rows& from, int y, int h, int w, const Filter& f, float* line, float* out, float* difference) {
  const float *up[kSide], *down[kSide];
  const int r = f.radius, columns = int(from.stride);
  for (int i = 0; i <= r; ++i) up[i] = from.row(mirrored(y - i, h)), down[i] = from.row(mirrored(y + i, h));
  for (int x = 0; x < columns; x += kBlock) {
    V sum[kTogether];
    for (int j = 0; j < kTogether; ++j) sum[j] = f.weight[0] * load(up[0] + x + j * kLanes);
    for (int i = 1; i <= r; ++i)
      for (int j = 0; j < kTogether; ++j) sum[j] += f.weight[size_t(i)] * (load(up[i] + x + j * kLanes) + load(down[i] + x + j * kLanes));
    for (int j = 0; j < kTogether; ++j) store(line + x + j * kLanes, sum[j]);
  }
  for (int i = 1; i <= r; ++i) line[-i] = line[mirrored(-i, w)], line[w - 1 + i] = line[mirrored(w - 1 + i, w)];
  for (int x = 0; x < columns; x += kBlock) {
    V sum[kTogether];
    for (int j = 0; j < kTogether; ++j) sum[j] = f.weight[0] * load(line + x + j * kLanes);
    for (int i = 1; i <= r; ++i)
      for (int j = 0; j < kTogether; ++j) sum[j] += f.weight[size_t(i)] * (load(line + x + j * kLanes - i) + load(line + x + j * kLanes + i));
    for (int j = 0; j < kTogether; ++j) store(out + x + j * kLanes, sum[j]);
    if (difference)
      for (int j = 0; j < kTogether; ++j) store(difference + x + j * kLanes, sum[j] - load(up[0] + x + j * kLanes));
  }
}

// What an octave is made from: the image, or every second pixel of a level of the octave before.
struct Source {
  const uint8_t* grey;     // null where an octave came before
  const uint16_t* before;  // that level, which has every pixel or, of the octave of double size, every second one
  int row, step;           // its width, and its pixels from one that is taken to the next
  int width, height;       // of the octave
  bool doubled;            // the image is half as large

  // Columns from `begin` to `end` of row y.
  void read(int y, int begin, int end, float* out) const {
    if (!grey) {
      const uint16_t* p = before + size_t(y) * size_t(step) * size_t(row);
      for (int x = begin; x < end; ++x) out[x - begin] = float(p[x * step]) / kGrey;
    } else if (!doubled) {
      const uint8_t* p = grey + size_t(y) * width;
      for (int x = begin; x < end; ++x) out[x - begin] = float(p[x]);
    } else {
      // between two pixels stands their mean; the centres of the first pixels coincide
      const int w = (width + 1) / 2;
      const uint8_t *p = grey + size_t(y / 2) * w, *q = grey + size_t((y + 1) / 2) * w;
      for (int x = begin; x < end; ++x) out[x - begin] = 0.25f * float(p[x / 2] + p[(x + 1) / 2] + q[x / 2] + q[(x + 1) / 2]);
    }
  }
};

struct Octave {
  Source source;
  Level* levels;    // of kLevels
  int32_t number;   // of the first of them
  int thinned;      // of the octave's pixels the levels have every first or every second
  float least;
};

// Weights of n values at ..., -1, 0, 1, ... in the polynomial through them, and in its slope (Lagrange).
template <int n> struct Through {
  float value[n], slope[n];
  explicit Through(float x) {
    for (int i = 0; i < n; ++i) {
      float product = 1, sum = 0;
      for (int j = 0; j < n; ++j)
        if (j != i) sum = sum * (x - float(j - n / 2)) + product, product *= x - float(j - n / 2), sum /= float(i - j), product /= float(i - j);
      value[i] = product, slope[i] = sum;
    }
  }
};

// The place and strength of an extremum; false for edges, weak ones, and where the parabola of its differences lies elsewhere.
static bool refine(const std::array<Rows, kDifferences>& D, int x, int y, int level, float least, Extremum& e) {
  int X = x, Y = y, L = level;
  for (int turn = 0; turn < 5; ++turn) {
    const float *r[3][3];
    for (int l = 0; l < 3; ++l)
      for (int j = 0; j < 3; ++j) r[l][j] = D[size_t(L + l - 1)].row(Y + j - 1) + X;
    const float v = r[1][1][0];
    const float gx = 0.5f * (r[1][1][1] - r[1][1][-1]), gy = 0.5f * (r[1][2][0] - r[1][0][0]), gs = 0.5f * (r[2][1][0] - r[0][1][0]);
    const float xx = r[1][1][1] + r[1][1][-1] - 2 * v, yy = r[1][2][0] + r[1][0][0] - 2 * v, ss = r[2][1][0] + r[0][1][0] - 2 * v;
    const float xy = 0.25f * (r[1][2][1] + r[1][0][-1] - r[1][0][1] - r[1][2][-1]);
    const float xs = 0.25f * (r[2][1][1] + r[0][1][-1] - r[2][1][-1] - r[0][1][1]);
    const float ys = 0.25f * (r[2][2][0] + r[0][0][0] - r[2][0][0] - r[0][2][0]);
    const float a = yy * ss - ys * ys, b = xs * ys - xy * ss, c = xy * ys - yy * xs;  // cofactors
    const float det = xx * a + xy * b + xs * c;
    if (!(std::abs(det) > 1e-12f)) return false;
    const float bc = xx * ss - xs * xs, bs = xy * xs - xx * ys, cc = xx * yy - xy * xy;
    float dx = -(a * gx + b * gy + c * gs) / det;
    float dy = -(b * gx + bc * gy + bs * gs) / det;
    float ds = -(c * gx + bs * gy + cc * gs) / det;
    if (std::max({std::abs(dx), std::abs(dy), std::abs(ds)}) < 0.6f) {
      const float value = v + 0.5f * (gx * dx + gy * dy + gs * ds), trace = xx + yy;
      if (!(std::abs(value) > least) || !(trace * trace * kEdge < (kEdge + 1) * (kEdge + 1) * cc)) return false;
      // the parabola draws places to the middle of a pixel or away from it; the polynomial through all differences does not
      for (int step = 0; step < 3; ++step) {
        const Through<3> s(ds);
        const Through<5> p(dx), q(dy);
        float ex = 0, ey = 0, es = 0;
        for (int l = 0; l < 3; ++l)
          for (int j = 0; j < 5; ++j) {
            const float* row = D[size_t(L + l - 1)].row(Y + j - 2) + X - 2;
            float sum = 0, slope = 0;
            for (int i = 0; i < 5; ++i) sum += p.value[i] * row[i], slope += p.slope[i] * row[i];
            ex += s.value[l] * q.value[j] * slope;
            ey += s.value[l] * q.slope[j] * sum;
            es += s.slope[l] * q.value[j] * sum;
          }
        dx -= (a * ex + b * ey + c * es) / det;
        dy -= (b * ex + bc * ey + bs * es) / det;
        ds -= (c * ex + bs * ey + cc * es) / det;
      }
      if (!(std::max({std::abs(dx), std::abs(dy), std::abs(ds)}) < 1.0f)) return false;
      e = {float(X) + dx, float(Y) + dy, kSigma * std::exp2((float(L) + ds) / kLevels), std::abs(value), L};
      return true;
    }
    if (!(std::max({std::abs(dx), std::abs(dy), std::abs(ds)}) < 8.0f)) return false;
    X += int(std::lround(dx)), Y += int(std::lround(dy)), L += int(std::lround(ds));
    if (std::abs(X - x) > kMove || std::abs(Y - y) > kMove || L < 1 || L > kLevels) return false;
  }
  return false;
}

// Columns from `begin` to `end` of a row of differences that are larger, or smaller, than their eight neighbours there.
static void candidates(const float* above, const float* row, const float* below, int begin, int end, float least, uint8_t* found) {
  for (int x = begin; x < end; ++x) {
    const float v = row[x];
    const float m0 = std::max(std::max(above[x - 1], above[x]), std::max(above[x + 1], row[x - 1]));
    const float m1 = std::max(std::max(below[x - 1], below[x]), std::max(below[x + 1], row[x + 1]));
    const float n0 = std::min(std::min(above[x - 1], above[x]), std::min(above[x + 1], row[x - 1]));
    const float n1 = std::min(std::min(below[x - 1], below[x]), std::min(below[x + 1], row[x + 1]));
    found[x] = uint8_t(((v > least) & (v > m0) & (v >= m1)) | ((v < -least) & (v < n0) & (v <= n1)));
  }
}

// Whether a difference is beyond those of a neighbouring level; of equal ones the one of the lower level.
static bool beyond(const Rows& D, int x, int y, float v, bool lower) {
  for (int j = -1; j <= 1; ++j) {
    const float* r = D.row(y + j) + x;
    for (int i = -1; i <= 1; ++i)
      if (v > 0 ? (lower ? r[i] >= v : r[i] > v) : (lower ? r[i] <= v : r[i] < v)) return false;
  }
  return true;
}

// Columns from `begin` to `end` of an octave: row by row through all its filters, so that what they need is in the cache.
static void strip(const Octave& o, const Filter* first, const std::vector<Filter>& filters, int begin, int end, std::vector<Extremum>& found) {
  const int w = o.source.width, h = o.source.height;
  std::array<int, kGaussians> lag;
  lag[0] = first ? first->radius : 0;
  for (int l = 1; l < kGaussians; ++l) lag[size_t(l)] = lag[size_t(l - 1)] + filters[size_t(l)].radius;
  const int last = lag[kGaussians - 1], beside = last + kAside;
  const int x0 = std::max(0, begin - beside), x1 = std::min(w, end + beside), columns = x1 - x0;
  const size_t stride = size_t((columns + kBlock - 1) / kBlock * kBlock);
  Rows image;
  std::array<Rows, kGaussians> G;
  std::array<Rows, kDifferences> D;
  if (first) image.reset(2 * lag[0] + 1, stride);
  for (int l = 0; l < kGaussians; ++l) G[size_t(l)].reset(l + 1 < kGaussians ? 2 * filters[size_t(l + 1)].radius + 1 : 1, stride);
  for (int l = 0; l < kDifferences; ++l) D[size_t(l)].reset(last - lag[size_t(l + 1)] + 2 * kAside + 1, stride);
  std::vector<float> buffer(stride + 2 * kSide);
  float* line = buffer.data() + kSide;
  std::vector<uint8_t> marks(stride + 8, 0);
  const int low = std::max(begin, kBorder) - x0, high = std::min(end, w - kBorder) - x0;

  for (int t = 0; t < h + last + kAside; ++t) {
    if (t < h) o.source.read(t, x0, x1, (first ? image : G[0]).row(t));
    if (first && t >= lag[0] && t - lag[0] < h) smooth(image, t - lag[0], h, columns, *first, line, G[0].row(t - lag[0]), nullptr);
    for (int l = 1; l < kGaussians; ++l) {
      const int y = t - lag[size_t(l)];
      if (y < 0 || y >= h) continue;
      float* out = G[size_t(l)].row(y);
      smooth(G[size_t(l - 1)], y, h, columns, filters[size_t(l)], line, out, D[size_t(l - 1)].row(y));
      if (l <= kLevels && y % o.thinned == 0) {
        Level& level = o.levels[l - 1];
        uint16_t* to = level.values.get() + size_t(y / o.thinned) * size_t(level.width) + begin / o.thinned;
        const float* p = out + begin - x0;
        if (o.thinned == 1)
          for (int x = 0; x < end - begin; ++x) to[x] = uint16_t(int(kGrey * p[x] + 0.5f));
        else
          for (int x = 0; x < (end - begin + 1) / 2; ++x) to[x] = uint16_t(int(kGrey * p[2 * x] + 0.5f));
      }
    }
    const int y = t - last - kAside;
    if (y < kBorder || y >= h - kBorder || low >= high) continue;
    for (int l = 1; l <= kLevels; ++l) {
      const Rows& mine = D[size_t(l)];
      candidates(mine.row(y - 1), mine.row(y), mine.row(y + 1), low, high, 0.5f * o.least, marks.data());
      for (int x = low; x < high; ++x) {
        uint64_t eight;
        std::memcpy(&eight, marks.data() + x, 8);
        if (!eight) {
          x += 7;
          continue;
        }
        if (!marks[size_t(x)]) continue;
        const float v = mine.row(y)[x];
        Extremum e;
        if (!beyond(D[size_t(l - 1)], x, y, v, true) || !beyond(D[size_t(l + 1)], x, y, v, false) || !refine(D, x, y, l, o.least, e)) continue;
        e.x = (e.x + float(x0)) / float(o.thinned);
        e.y /= float(o.thinned);
        e.sigma /= float(o.thinned);
        e.level += o.number - 1;
        found.push_back(e);
      }
    }
  }
}

static void search(const uint8_t* grey, int width, int height, float least, bool doubled, ScaleSpace& space) {
  std::vector<Filter> filters{Filter(1.0)};
  for (int l = 1; l < kGaussians; ++l) {
    const double a = kSigma * std::exp2((l - 1.0) / kLevels), b = kSigma * std::exp2(double(l) / kLevels);
    filters.emplace_back(std::sqrt(b * b - a * a));
  }
  const Filter first(kSigma);  // the image is taken as it is: with less of a filter fewer features are found again
  int w = doubled ? 2 * width - 1 : width, h = doubled ? 2 * height - 1 : height;
  double pixel = doubled ? 0.5 : 1.0;
  Source source{grey, nullptr, 0, 0, w, h, doubled};
  for (bool here = true; std::min(w, h) >= kSmallest; here = false) {
    const int thinned = here && doubled ? 2 : 1;
    const size_t number = space.levels.size();
    for (int l = 0; l < kLevels; ++l) {
      Level level{(w + thinned - 1) / thinned, (h + thinned - 1) / thinned, pixel * thinned, nullptr};
      level.values.reset(new uint16_t[size_t(level.width) * size_t(level.height)]);
      space.levels.push_back(std::move(level));
    }
    const Octave o{source, &space.levels[number], int32_t(number), thinned, least};
    for (int x = 0; x < w; x += kStrip) strip(o, here ? &first : nullptr, filters, x, std::min(w, x + kStrip), space.extrema);
    const Level& last = space.levels.back();
    w = (w + 1) / 2, h = (h + 1) / 2, pixel *= 2;
    source = {nullptr, last.values.get(), last.width, 2 / thinned, w, h, false};
  }
}

constexpr int kPatch = 400;  // places at most at which gradients are taken

// Angles of gradients [rad], to 2e-4.
static inline float angle_of(float y, float x) {
  const float ax = std::abs(x), ay = std::abs(y), a = std::min(ax, ay) / (std::max(ax, ay) + 1e-20f), s = a * a;
  float r = ((-0.0464964749f * s + 0.15931422f) * s - 0.327622764f) * s * a + a;
  r = ay > ax ? float(std::numbers::pi / 2) - r : r;
  r = x < 0 ? float(std::numbers::pi) - r : r;
  return y < 0 ? -r : r;
}

// Magnitudes, weighted, and angles of the gradients at n places (u, v) relative to an extremum in pixels of its level, each
// at the nearest pixel.
static void gradients(const Level& level, const Extremum& e, const float* u, const float* v, const float* weight, int n, float* magnitude,
                      float* angle) {
  int32_t at[kPatch];
  float gx[kPatch], gy[kPatch], inside[kPatch];
  const float cx = e.x + 0.5f, cy = e.y + 0.5f, right = float(level.width - 1), low = float(level.height - 1);
  for (int k = 0; k < n; ++k) {
    const float x = cx + u[k], y = cy + v[k];
    const bool in = (x >= 1) & (y >= 1) & (x < right) & (y < low);
    inside[k] = in ? weight[k] : 0.0f;
    at[k] = in ? int32_t(y) * level.width + int32_t(x) : level.width + 1;
  }
  const uint16_t* values = level.values.get();
  const int down = level.width;
  for (int k = 0; k < n; ++k) {
    const uint16_t* p = values + at[k];
    gx[k] = float(int(p[1]) - int(p[-1]));
    gy[k] = float(int(p[down]) - int(p[-down]));
  }
  for (int k = 0; k < n; ++k) {
    magnitude[k] = inside[k] * std::sqrt(gx[k] * gx[k] + gy[k] * gy[k]);
    angle[k] = angle_of(gy[k], gx[k]);
  }
}

constexpr int kDirections = 36, kAcross = 16, kAround = kAcross * kAcross;
constexpr double kTurn = 2 * std::numbers::pi;

// Places of a square grid with their weights, in standard deviations of an extremum.
struct Grid {
  std::array<float, kPatch> u, v, weight;
  Grid(int across, double step, double sigma, double radius) : u{}, v{}, weight{} {
    for (int j = 0; j < across; ++j)
      for (int i = 0; i < across; ++i) {
        const double a = (i + 0.5 - 0.5 * across) * step, b = (j + 0.5 - 0.5 * across) * step;
        const size_t k = size_t(j * across + i);
        u[k] = float(a), v[k] = float(b);
        weight[k] = a * a + b * b <= radius * radius ? float(std::exp(-0.5 * (a * a + b * b) / (sigma * sigma))) : 0.0f;
      }
  }
};

static void orient(const ScaleSpace& space, const int64_t* chosen, int64_t n, std::vector<int64_t>& owner, std::vector<double>& angle) {
  static const Grid grid(kAcross, 9.0 / kAcross, 1.5, 4.5);
  float u[kAround], v[kAround], m[kAround], a[kAround];
  int32_t bin[kAround];
  owner.resize(size_t(n)), angle.resize(size_t(n));
  for (int64_t i = 0; i < n; ++i) {
    const Extremum& e = space.extrema[size_t(chosen[i])];
    for (int k = 0; k < kAround; ++k) u[k] = e.sigma * grid.u[size_t(k)], v[k] = e.sigma * grid.v[size_t(k)];
    gradients(space.levels[size_t(e.level)], e, u, v, grid.weight.data(), kAround, m, a);
    for (int k = 0; k < kAround; ++k) {
      const int32_t b = int32_t(a[k] * float(kDirections / kTurn) + (kDirections + 0.5f));
      bin[k] = b >= kDirections ? b - kDirections : b;
    }
    float parts[4][kDirections] = {}, sum[kDirections + 4], smooth[kDirections + 2];
    for (int k = 0; k < kAround; k += 4)
      for (int j = 0; j < 4; ++j) parts[j][bin[k + j]] += m[k + j];
    for (int b = 0; b < kDirections; ++b) sum[b + 2] = (parts[0][b] + parts[1][b]) + (parts[2][b] + parts[3][b]);
    sum[0] = sum[kDirections], sum[1] = sum[kDirections + 1], sum[kDirections + 2] = sum[2], sum[kDirections + 3] = sum[3];
    for (int b = 0; b < kDirections; ++b) smooth[b + 1] = (sum[b] + sum[b + 4]) + 4 * (sum[b + 1] + sum[b + 3]) + 6 * sum[b + 2];
    smooth[0] = smooth[kDirections], smooth[kDirections + 1] = smooth[1];
    const int top = int(std::max_element(smooth + 1, smooth + kDirections + 1) - smooth);
    for (int b = 1; b <= kDirections; ++b) {
      const float l = smooth[b - 1], c = smooth[b], r = smooth[b + 1];
      if (b != top && !(c > l && c > r && c >= 0.8f * smooth[top])) continue;
      const float bend = l - 2 * c + r;
      const double found = (b - 1 + (bend < 0 ? 0.5 * double(l - r) / double(bend) : 0.0)) * (kTurn / kDirections);
      if (b == top) {
        owner[size_t(i)] = i, angle[size_t(i)] = found;
      } else {
        owner.push_back(i), angle.push_back(found);
      }
    }
  }
}

constexpr int kCells = 4, kParts = 4, kLine = (kCells + 1) * kParts, kBins = 8;
static_assert(kLine * kLine == kPatch);

static void describe(const ScaleSpace& space, const int64_t* chosen, const double* angle, int64_t n, uint8_t* descriptors) {
  // cells of 3 sigma; of the outer ones half
  static const Grid grid(kLine, 3.0 / kParts, 6.0, 1e3);
  float u[kPatch], v[kPatch], m[kPatch], a[kPatch];
  for (int64_t i = 0; i < n; ++i) {
    const Extremum& e = space.extrema[size_t(chosen[i])];
    const float c = float(std::cos(angle[i])) * e.sigma, s = float(std::sin(angle[i])) * e.sigma, turn = float(angle[i]);
    for (int k = 0; k < kPatch; ++k) {
      u[k] = c * grid.u[size_t(k)] - s * grid.v[size_t(k)];
      v[k] = s * grid.u[size_t(k)] + c * grid.v[size_t(k)];
    }
    gradients(space.levels[size_t(e.level)], e, u, v, grid.weight.data(), kPatch, m, a);
    for (int k = 0; k < kPatch; ++k) {
      const float b = (turn - a[k]) * float(kBins / kTurn) + 2 * kBins;
      a[k] = b - float(kBins * (int32_t(b) / kBins));
    }
    // every place shares its magnitude among two columns, two rows and two directions of cells
    alignas(64) float cells[kCells + 2][kCells + 2][kBins] = {};
    for (int j = 0; j < kLine; ++j) {
      alignas(64) float row[kCells + 2][kBins] = {};
      for (int g = 0; g <= kCells; ++g)
        for (int p = 0; p < kParts; ++p) {
          const int k = j * kLine + g * kParts + p;
          const float right = (p + 0.5f) / kParts * m[k], left = m[k] - right;
          for (int b = 0; b < kBins; ++b) {
            const float d = std::abs(a[k] - float(b)), near = std::max(0.0f, 1.0f - std::min(d, kBins - d));
            row[g][b] += left * near;
            row[g + 1][b] += right * near;
          }
        }
      const float low = (j % kParts + 0.5f) / kParts;
      for (int g = 0; g < kCells + 2; ++g)
        for (int b = 0; b < kBins; ++b) {
          cells[j / kParts][g][b] += (1 - low) * row[g][b];
          cells[j / kParts + 1][g][b] += low * row[g][b];
        }
    }
    float f[kDescriptor], squares = 0, sum = 0;
    for (int j = 0; j < kCells; ++j)
      for (int g = 0; g < kCells; ++g) std::copy_n(cells[j + 1][g + 1], kBins, f + (j * kCells + g) * kBins);
    for (float x : f) squares += x * x;
    const float most = 0.2f * std::sqrt(squares);
    for (float& x : f) x = std::min(x, most), sum += x;
    const float scale = 1.0f / std::max(sum, 1e-9f);
    for (int k = 0; k < kDescriptor; ++k) descriptors[i * kDescriptor + k] = uint8_t(std::min(255.0f, 512.0f * std::sqrt(scale * f[k]) + 0.5f));
  }
}

extern const FeatureKernels features;
const FeatureKernels features = {search, orient, describe};

}  // namespace RB_ARCH
}  // namespace raybundle
