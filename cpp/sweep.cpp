// Census, costs over levels of depth and path aggregation (Hirschmueller 2008), compiled once for every instruction set.
#include "sweep.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdlib>
#include <vector>

namespace raybundle {
namespace RB_ARCH {

constexpr int kAcross = 4, kDown = 3;  // the window of the census: 9 x 7
constexpr uint8_t kNobody = 255, kNeutral = 28, kWall = 200;

static void census(const uint8_t* image, int width, int height, uint64_t* out) {
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) {
      uint64_t bits = kUnknown;
      if (x >= kAcross && x < width - kAcross && y >= kDown && y < height - kDown) {
        const uint8_t* p = image + int64_t(y) * width + x;
        bits = 0;
        for (int j = -kDown; j <= kDown; ++j)
          for (int i = -kAcross; i <= kAcross; ++i)
            if (i || j) bits = bits << 1 | uint64_t(p[int64_t(j) * width + i] < *p);
      }
      out[int64_t(y) * width + x] = bits;
    }
}

// The smallest and the second smallest cost (levels, step, step) over the sources, of one cell of the tables.
struct Cell {
  int x, y, columns, rows;  // its first pixel, and how many
  uint8_t *first, *second;
};

constexpr int kTogether = 16;  // pixels whose comparisons are counted together

// One row of pixels of a cell at one level, whose places go on from (px, py) by (dx, dy).
static inline void row_costs(const uint64_t* reference, const SweepSource& o, int64_t px, int64_t py, int64_t dx, int64_t dy, int count, uint8_t* first,
                             uint8_t* second) {
  const auto outside = [&](int64_t x, int64_t y) { return uint64_t(x >> kFraction) >= uint64_t(o.width) || uint64_t(y >> kFraction) >= uint64_t(o.height); };
  for (int begin = 0; begin < count; begin += kTogether, first += kTogether, second += kTogether, reference += kTogether) {
    const int n = std::min(kTogether, count - begin);
    const bool whole = !outside(px, py) && !outside(px + (n - 1) * dx, py + (n - 1) * dy);
    uint64_t differ[kTogether];
    uint8_t cost[kTogether];
    for (int i = 0; i < n; ++i, px += dx, py += dy)
      differ[i] = !whole && outside(px, py) ? kUnknown : reference[i] ^ o.census[(py >> kFraction) * o.width + (px >> kFraction)];
    // what is not known counts more than all comparisons
    for (int i = 0; i < n; ++i) cost[i] = uint8_t(std::popcount(differ[i]) | -int(differ[i] >> 63));
    for (int i = 0; i < n; ++i) {
      const uint8_t worse = std::max(first[i], cost[i]);
      first[i] = std::min(first[i], cost[i]);
      second[i] = std::min(second[i], worse);
    }
  }
}

// A / step towards zero; a division proper takes longer than all comparisons of a row of pixels.
struct Shared {
  int64_t step;
  int bits;  // of a step that is a power of two; else -1
  explicit Shared(int of) : step(of), bits(std::has_single_bit(unsigned(of)) ? std::countr_zero(unsigned(of)) : -1) {}
  int64_t operator()(int64_t a) const { return bits < 0 ? a / step : (a + ((a >> 63) & (step - 1))) >> bits; }
};

static void cell_costs(const Sweep& s, const uint64_t* reference, const SweepSource& o, const Cell& cell) {
  const int r = cell.y / s.step, c = cell.x / s.step;
  const Shared shared(s.step);
  for (int l = 0; l < s.levels; ++l) {
    const int32_t* top = o.table + ((int64_t(l) * s.rows + r) * s.columns + c) * 2;
    const int32_t* low = top + int64_t(s.columns) * 2;
    bool seen = true;
    for (int i = 0; i < 4; ++i) seen = seen && top[i] != kNowhere && low[i] != kNowhere;
    if (!seen) continue;
    for (int below = 0; below < cell.rows; ++below) {
      int32_t at[4];
      for (int i = 0; i < 4; ++i) at[i] = int32_t(top[i] + shared((int64_t(low[i]) - top[i]) * below));
      const int64_t dx = shared(int64_t(at[2]) - at[0]), dy = shared(int64_t(at[3]) - at[1]);
      const size_t here = (size_t(l) * s.step + below) * s.step;
      row_costs(reference + int64_t(cell.y + below) * s.width + cell.x, o, at[0], at[1], dx, dy, cell.columns, cell.first + here, cell.second + here);
    }
  }
}

static void costs(const Sweep& s, const uint64_t* reference, const SweepSource* sources, int count, uint8_t* cost) {
  const size_t size = size_t(s.levels) * size_t(s.step) * size_t(s.step);
  std::vector<uint8_t> first(size), second(size);
  for (int y = 0; y < s.height; y += s.step)
    for (int x = 0; x < s.width; x += s.step) {
      const Cell cell{x, y, std::min(s.step, s.width - x), std::min(s.step, s.height - y), first.data(), second.data()};
      std::fill(first.begin(), first.end(), kNobody);
      std::fill(second.begin(), second.end(), kNobody);
      for (int k = 0; k < count; ++k) cell_costs(s, reference, sources[k], cell);
      for (size_t i = 0; i < size; ++i) {
        const uint8_t a = first[i], b = second[i];
        first[i] = a == kNobody ? kNeutral : b == kNobody ? a : uint8_t((int(a) + int(b) + 1) / 2);
      }
      for (int j = 0; j < cell.rows; ++j) {
        uint8_t* out = cost + (int64_t(y + j) * s.width + x) * s.levels;
        for (int l = 0; l < s.levels; ++l)
          for (int i = 0; i < cell.columns; ++i) out[int64_t(i) * s.levels + l] = first[(size_t(l) * s.step + j) * s.step + i];
      }
    }
}

// A pixel of a path: cost + min(before, neighbours + slope, least + jump) - least; its smallest value.
static inline uint8_t along(const uint8_t* cost, const uint8_t* before, uint8_t least, int levels, uint8_t slope, uint8_t jump,
                            uint8_t* now, uint16_t* sum) {
  uint8_t smallest = 255;
  const uint8_t any = uint8_t(least + jump);
  for (int l = 0; l < levels; ++l) {
    const uint8_t beside = uint8_t(std::min(before[l - 1], before[l + 1]) + slope);
    const uint8_t v = uint8_t(std::min(std::min(before[l], beside), any) - least + cost[l]);
    now[l] = v;
    sum[l] = uint16_t(sum[l] + v);
    smallest = std::min(smallest, v);
  }
  return smallest;
}

// A path begins: its smallest value.
static inline uint8_t begun(const uint8_t* cost, int levels, uint8_t* now, uint16_t* sum) {
  for (int l = 0; l < levels; ++l) {
    now[l] = cost[l];
    sum[l] = uint16_t(sum[l] + cost[l]);
  }
  return *std::min_element(cost, cost + levels);
}

// The best level of a pixel, between levels by a parabola, and how much worse the best is that is no neighbour of it.
static inline void chosen(const uint16_t* sum, int levels, float* level, float* margin) {
  const int best = int(std::min_element(sum, sum + levels) - sum);
  uint16_t other = 65535;
  for (int l = 0; l < best - 2; ++l) other = std::min(other, sum[l]);
  for (int l = best + 3; l < levels; ++l) other = std::min(other, sum[l]);
  float at = float(best);
  if (best > 0 && best + 1 < levels) {
    const int before = sum[best - 1], behind = sum[best + 1], bend = before + behind - 2 * sum[best];
    if (bend > 0) at += 0.5f * float(before - behind) / float(bend);
  }
  *level = at;
  *margin = float(other) / float(std::max<int>(sum[best], 1));
}

static void aggregate(const Sweep& s, const uint8_t* image, const uint8_t* cost, const Penalties& p, uint16_t* sum, float* level,
                      float* margin) {
  const int w = s.width, h = s.height, levels = s.levels;
  const size_t stride = size_t(levels) + 2;  // a wall on both sides
  std::fill(sum, sum + size_t(w) * h * levels, uint16_t(0));
  for (int way = 0; way < 2; ++way) {
    const int forward = way ? -1 : 1;
    std::vector<uint8_t> rows[2], least[2], side[2];
    for (int i = 0; i < 2; ++i) {
      rows[i].assign(stride * w * 3, kWall);
      least[i].assign(size_t(w) * 3, 0);
      side[i].assign(stride, kWall);
    }
    for (int n = 0; n < h; ++n) {
      const int y = way ? h - 1 - n : n;
      uint8_t least_beside = 0;
      for (int m = 0; m < w; ++m) {
        const int x = way ? w - 1 - m : m;
        const int64_t at = int64_t(y) * w + x;
        const uint8_t* c = cost + at * levels;
        uint16_t* total = sum + at * levels;
        const auto jump = [&](int64_t from) { return uint8_t(std::max(p.least, p.jump - std::abs(int(image[at]) - int(image[from])))); };
        uint8_t* now = side[m & 1].data() + 1;
        least_beside = m == 0 ? begun(c, levels, now, total)
                              : along(c, side[(m + 1) & 1].data() + 1, least_beside, levels, uint8_t(p.slope), jump(at - forward), now, total);
        for (int k = 0; k < 3; ++k) {
          const int from = x + k - 1;
          const size_t here = size_t(k) * w + x, there = size_t(k) * w + size_t(from);
          uint8_t* to = rows[n & 1].data() + stride * here + 1;
          least[n & 1][here] = n == 0 || from < 0 || from >= w
                                   ? begun(c, levels, to, total)
                                   : along(c, rows[(n + 1) & 1].data() + stride * there + 1, least[(n + 1) & 1][there], levels,
                                           uint8_t(p.slope), jump(int64_t(y - forward) * w + from), to, total);
        }
        if (way) chosen(total, levels, level + at, margin + at);
      }
    }
  }
}

// Weights of four nodes (Lagrange) at a place between them, and the first of them.
static inline int nodes(double at, int count, double* weight) {
  const double first = std::min(std::max(std::floor(at) - 1, 0.0), double(count - 4));
  const double p = at - first, q = p - 1, r = p - 2, s = p - 3;
  weight[0] = -q * r * s / 6;
  weight[1] = p * r * s / 2;
  weight[2] = -p * q * s / 2;
  weight[3] = p * q * r / 6;
  return int(first);
}

static void places(const TransferTable& table, const double* xy, const double* t, int64_t count, double* out) {
  for (int64_t n = 0; n < count; ++n) {
    const double at[3] = {(xy[2 * n + 1] - table.v0) / table.step, (xy[2 * n] - table.u0) / table.step, (t[n] - table.t0) / table.dt};
    double x = NAN, y = NAN;
    if (std::isfinite(at[0]) && std::isfinite(at[1]) && std::isfinite(at[2])) {
      double down[4], across[4], deep[4];
      const int j = nodes(at[0], table.rows, down), i = nodes(at[1], table.columns, across), k = nodes(at[2], table.levels, deep);
      x = y = 0;
      for (int a = 0; a < 4; ++a)
        for (int b = 0; b < 4; ++b) {
          const double* node = table.xy + ((int64_t(j + a) * table.columns + i + b) * table.levels + k) * 2;
          const double w = down[a] * across[b];
          for (int c = 0; c < 4; ++c) {
            x += w * deep[c] * node[2 * c];
            y += w * deep[c] * node[2 * c + 1];
          }
        }
    }
    out[2 * n] = x;
    out[2 * n + 1] = y;
  }
}

extern const SweepKernels sweep;
const SweepKernels sweep = {&census, &costs, &aggregate, &places};

}  // namespace RB_ARCH
}  // namespace raybundle
