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

#if defined(__AVX2__)
#include <immintrin.h>
#endif

namespace raybundle {
namespace RB_ARCH {

#include "surface_window.inl"

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
constexpr int kLags = (kLag + 1) + kLag * (2 * kLag + 1);  // half of those of an autocovariance, which is symmetric
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
    int apart[kLags], lags = 0;
    float of[kLags];
    for (int dy = 0; dy <= kLag; ++dy)
      for (int dx = dy ? -kLag : 0; dx <= kLag; ++dx) {
        double lx = dx, ly = dy;
        if (s >= 0) lx = steep_[s][0] * dx + steep_[s][1] * dy, ly = steep_[s][2] * dx + steep_[s][3] * dy;
        if (!(std::abs(lx) < kLag && std::abs(ly) < kLag) && !(std::abs(lx) <= kLag && std::abs(ly) <= kLag && s < 0)) continue;
        const int ix = std::min(int(lx + kLag), 2 * kLag - 1), iy = std::min(int(ly + kLag), 2 * kLag - 1);
        const double fx = lx + kLag - ix, fy = ly + kLag - iy;
        const float* c = table + iy * (2 * kLag + 1) + ix;
        const double covariance = (1 - fy) * ((1 - fx) * c[0] + fx * c[1]) + fy * ((1 - fx) * c[2 * kLag + 1] + fx * c[2 * kLag + 2]);
        if (covariance == 0) continue;
        of[lags] = float(dx || dy ? 2 * covariance : covariance);
        apart[lags++] = dy * wide + dx;
      }
    V sum = {};
    for (int i = 0; i < side * wide; i += kLanes) {  // zeros follow
      V around = {};
      for (int l = 0; l < lags; ++l) around += of[l] * load<V>(k + i + apart[l]);
      sum += load<V>(k + i) * around;
    }
    return summed(sum);
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
