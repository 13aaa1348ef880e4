// What lies on a dot, judged by the residuals of its grey values: see covered.covered_pixels, its twin.  Included by
// targets.cpp for every instruction set.

constexpr double kRoundingVariance = 1.0 / 12, kNormalMedian = 0.6744897501960817, kFlat = 0.01, kEdge = 0.1;
constexpr int kPartWidths[3] = {2, 4, 6};

struct CoverWork {
  std::vector<double> t, u, h, radius, loose, mean_t, mean_q, mean_u, row, deviate, sorted;
  std::vector<int> sector;
  std::vector<uint8_t> flagged;
};

static double median_of(std::vector<double>& a) { return median(a.data(), int(a.size())); }

// x' Q x of ten values.
static double quadratic(const double* Q, const double* x) {
  double sum = 0;
  for (int i = 0; i < kU; ++i) {
    double s = 0.5 * Q[kU * i + i] * x[i];
    for (int j = 0; j < i; ++j) s += Q[kU * i + j] * x[j];
    sum += 2 * s * x[i];
  }
  return sum;
}

// Means of 3 x 3 pixels of `k` channels; beyond the border stands what stands at it.
static void means(const double* a, int width, int height, int k, std::vector<double>& row, double* out) {
  row.resize(size_t(width) * k);
  for (int y = 0; y < height; ++y) {
    const double *above = a + size_t(std::max(y - 1, 0)) * width * k, *here = a + size_t(y) * width * k,
                 *below = a + size_t(std::min(y + 1, height - 1)) * width * k;
    for (int i = 0; i < width * k; ++i) row[i] = above[i] + here[i] + below[i];
    for (int x = 0; x < width; ++x) {
      const double *l = row.data() + size_t(std::max(x - 1, 0)) * k, *m = row.data() + size_t(x) * k,
                   *r = row.data() + size_t(std::min(x + 1, width - 1)) * k;
      double* to = out + (size_t(y) * width + x) * k;
      for (int i = 0; i < k; ++i) to[i] = (l[i] + m[i] + r[i]) / 9;
    }
  }
}

struct EdgeSums {
  double ht[kSectors] = {}, hh[kSectors] = {}, hJ[kSectors][kU] = {};
  void add(int k, double h, double t, const double* u) {
    ht[k] += h * t, hh[k] += h * h;
    for (int i = 0; i < kU; ++i) hJ[k][i] += h * u[i];
  }
  // Absolute normal deviate of the part of m sectors from k on: see centre.edge_shifts.
  double deviate(const double* Q, int m, int k, double sign) const {
    double a = 0, b = 0, G[kU] = {};
    for (int j = 0; j < m; ++j) {
      const int l = (k + j) % kSectors;
      a += ht[l], b += hh[l];
      for (int i = 0; i < kU; ++i) G[i] += hJ[l][i];
    }
    if (!(b > 0)) return 0;
    const double left = b + sign * quadratic(Q, G);
    return left > 0.1 * b ? std::abs(a) / std::sqrt(left) : 0;
  }
};

static double roughness(const CoverWork& w, const uint8_t* free, std::vector<double>& sorted) {
  sorted.clear();
  for (size_t i = 0; i < w.deviate.size(); ++i)
    if (free[i] && std::isfinite(w.deviate[i])) sorted.push_back(std::abs(w.deviate[i]));
  return sorted.empty() ? 1 : std::max(1.0, median_of(sorted) / kNormalMedian);
}

// Residuals in standard deviations of a grey value, which that within the dot and that around it tell where they are more.
static void standardise(const uint8_t* free, const double* e, const double* J, int width, int height, CoverWork& w) {
  const size_t size = size_t(width) * height;
  double most = 0;
  for (size_t i = 0; i < size; ++i) most = std::max(most, std::abs(w.h[i]));
  w.sorted.clear();
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) {
      const size_t i = size_t(y) * width + x;
      if (!free[i]) continue;
      if (x + 1 < width && free[i + 1]) w.sorted.push_back(std::abs(e[i + 1] - e[i]));
      if (y + 1 < height && free[i + width]) w.sorted.push_back(std::abs(e[i + width] - e[i]));
    }
  double all = std::sqrt(kRoundingVariance), noise[2];
  if (!w.sorted.empty()) all = std::max(all, median_of(w.sorted) / (kNormalMedian * std::sqrt(2.0)));
  for (int side = 0; side < 2; ++side) {
    w.sorted.clear();
    for (size_t i = 0; i < size; ++i)
      if (free[i] && std::abs(w.h[i]) < kFlat * most && (w.radius[i] < 1) == (side == 0)) w.sorted.push_back(std::abs(e[i]));
    noise[side] = int(w.sorted.size()) > 2 * kU ? std::max(all, median_of(w.sorted) / kNormalMedian) : all;
  }
  for (size_t i = 0; i < size; ++i) {
    const double n = w.radius[i] < 1 ? noise[0] : noise[1];
    w.t[i] = e[i] / n;
    for (int j = 0; j < kU; ++j) w.u[kU * i + j] = J[kU * i + j] / n;
    w.h[i] /= n;
  }
}

// Parts of the edge that lie elsewhere than on the ellipse are flagged.
static void flag_moved_edge(const double* Q, const uint8_t* free, double limit, bool strict, CoverWork& w) {
  EdgeSums seen, hidden;
  double square = 0, most = 0;
  size_t count = 0;
  for (size_t i = 0; i < w.t.size(); ++i) {
    const bool some = free[i] && !w.flagged[i];
    (some ? seen : hidden).add(w.sector[i], w.h[i], w.t[i], w.u.data() + kU * i);
    if (some) square += w.t[i] * w.t[i], ++count;
    most = std::max(most, std::abs(w.h[i]));
  }
  if (!strict && count) limit *= std::max(1.0, std::sqrt(square / double(count)));
  bool parts[kSectors] = {};
  double largest = -1;
  int width = 0, at = 0;
  for (int m : kPartWidths)
    for (int k = 0; k < kSectors; ++k) {
      const double z = seen.deviate(Q, m, k, -1);
      if (z > largest) largest = z, width = m, at = k;
    }
  // what has moved bends the ellipse beside it: the worst part alone, and what is left out already and still is off
  if (largest > limit)
    for (int j = 0; j < width; ++j) parts[(at + j) % kSectors] = true;
  for (int k = 0; k < kSectors; ++k)
    if (hidden.deviate(Q, kPartWidths[0], k, 1) > limit)
      for (int j = 0; j < kPartWidths[0]; ++j) parts[(k + j) % kSectors] = true;
  for (size_t i = 0; i < w.t.size(); ++i)
    if (parts[w.sector[i]] && std::abs(w.h[i]) > kEdge * most) w.flagged[i] = 1;
}

static void cover(const double* v, const double* Q, const int32_t* box, const uint8_t* free, const double* e, const double* J,
                  const CoverLimits& limits, uint8_t* covered, CoverWork& w) {
  constexpr double kTurn = 6.283185307179586;
  const int width = box[2] - box[0], height = box[3] - box[1];
  const size_t size = size_t(width) * height;
  for (auto* a : {&w.t, &w.h, &w.radius, &w.loose, &w.mean_t, &w.mean_q, &w.deviate}) a->resize(size);
  w.u.resize(kU * size);
  w.mean_u.resize(kU * size);
  w.sector.resize(size);
  w.flagged.assign(size, 0);
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) {
      const size_t i = size_t(y) * width + x;
      const double p = (box[0] + x + 0.5 - v[X0]) / v[A], q = (box[1] + y + 0.5 - v[Y0] - v[B] * p) / v[D];
      const double turn = std::atan2(q, p) / kTurn;
      w.radius[i] = std::hypot(p, q);
      w.sector[i] = std::clamp(int((turn < 0 ? turn + 1 : turn) * kSectors), 0, kSectors - 1);
      w.h[i] = v[A] * J[kU * i + A] + v[B] * J[kU * i + B] + v[D] * J[kU * i + D];
    }
  standardise(free, e, J, width, height, w);
  // squares where the fit does not rest on the pixel: what the ellipse is wrong by there is taken off
  for (size_t i = 0; i < size; ++i)
    w.loose[i] = w.t[i] * w.t[i] / (free[i] ? 1 : 1 + 9 * quadratic(Q, w.u.data() + kU * i));
  means(w.t.data(), width, height, 1, w.row, w.mean_t.data());
  means(w.loose.data(), width, height, 1, w.row, w.mean_q.data());
  means(w.u.data(), width, height, kU, w.row, w.mean_u.data());
  for (size_t i = 0; i < size; ++i)
    w.deviate[i] = 3 * std::abs(w.mean_t[i]) / std::sqrt(free[i] ? 1 : 1 + 9 * quadratic(Q, w.mean_u.data() + kU * i));
  for (int kind = 0; kind < 2; ++kind) {
    if (kind)
      for (size_t i = 0; i < size; ++i) w.deviate[i] = chi_deviate(9 * w.mean_q[i], 9);
    const double limit = limits.pixel * (limits.strict ? 1 : roughness(w, free, w.sorted));
    for (size_t i = 0; i < size; ++i) w.flagged[i] |= w.deviate[i] > limit;
  }
  flag_moved_edge(Q, free, limits.edge, limits.strict, w);
  const int k = int(limits.halo);
  std::fill(covered, covered + size, 0);
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) {
      if (!w.flagged[size_t(y) * width + x]) continue;
      for (int b = std::max(-k, -y); b <= std::min(k, height - 1 - y); ++b)
        for (int a = std::max(-k, -x); a <= std::min(k, width - 1 - x); ++a)
          if (std::hypot(a, b) <= limits.halo) covered[size_t(y + b) * width + x + a] = 1;
    }
}

static void cover_dots(int n, const double* values, const double* cov, const int32_t* box, const int64_t* offset, const uint8_t* free,
                       const double* e, const double* J, const CoverLimits* limits, uint8_t* covered) {
  CoverWork w;
  for (int i = 0; i < n; ++i)
    cover(values + kU * i, cov + kU * kU * i, box + 4 * i, free + offset[i], e + offset[i], J + kU * offset[i], limits[i],
          covered + offset[i], w);
}
