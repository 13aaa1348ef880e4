// Observations linearised in lanes of V, whitened.  Included by kernels.cpp within its namespace.

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

// Each is compiled once, however many combinations of sensors and platforms call it.
template <class T> static RB_APART void evaluated(const double (*in)[V], const double (*own)[V], double (*out)[V]) {
  T::evaluate(in, own, out);
}
template <class T> static RB_APART void by_its_image(const double (*in)[V], const double (*own)[V], double (*out)[V]) {
  T::by_image(in, own, out);
}
template <class T> static RB_APART void by_its_point(const double (*in)[V], const double (*own)[V], double (*out)[V]) {
  T::by_point(in, own, out);
}

// A sensor on a platform: the sensor's condition at the point where the platform puts it, by the chain rule.
// in: image and object point; own: the parameters, the sensor's, then the platform's.
template <class S, class P> struct carried {
  using sensor = S;
  using platform = P;
  static constexpr int K = S::parameters, M = P::parameters, parameters = K + M;
  static constexpr bool explicit_image = S::explicit_image && !P::uses_image;

  // Image and object point as the sensor has them.
  static RB_INLINE void seen(const double (*in)[V], const double (*p)[V], double (*to)[V]) {
    for (int e = 0; e < 2; ++e) std::copy_n(in[e], V, to[e]);
    for (int e = 0; e < 3; ++e) std::copy_n(p[e], V, to[2 + e]);
  }
  static void evaluate(const double (*in)[V], const double (*own)[V], double (*out)[V]) {
    constexpr int A = 5 + K + M, B = 5 + K, C = 5 + M;
    alignas(64) double p[3 + 3 * C][V], at_sensor[5][V], s[2 + 2 * B][V];
    evaluated<P>(in, own + K, p);
    seen(in, p, at_sensor);
    evaluated<S>(at_sensor, own, s);
    for (int g = 0; g < 2; ++g) {
      const double(*J)[V] = s + 2 + B * g;
      double(*to)[V] = out + 2 + A * g;
      std::copy_n(s[g], V, out[g]);
      for (int e = 0; e < C; ++e) {
        double* sum = to[e < 5 ? e : K + e];
        RB_SIMD
        for (int l = 0; l < V; ++l)
          sum[l] = J[2][l] * p[3 + e][l] + J[3][l] * p[3 + C + e][l] + J[4][l] * p[3 + 2 * C + e][l] + (e < 2 ? J[e][l] : 0.0);
      }
      for (int e = 0; e < K; ++e) std::copy_n(J[5 + e], V, to[5 + e]);
    }
  }
  // g1, g2, dg1/dx, dg1/dy, dg2/dx, dg2/dy
  static void by_image(const double (*in)[V], const double (*own)[V], double (*out)[V]) {
    alignas(64) double at_sensor[5][V];
    if constexpr (P::uses_image) {
      alignas(64) double p[9][V], s[12][V];  // the point and its, g and its partial derivatives
      by_its_image<P>(in, own + K, p);
      seen(in, p, at_sensor);
      by_its_point<S>(at_sensor, own, s);
      for (int g = 0; g < 2; ++g) {
        const double(*J)[V] = s + 2 + 5 * g;
        std::copy_n(s[g], V, out[g]);
        for (int e = 0; e < 2; ++e) {
          double* sum = out[2 + 2 * g + e];
          RB_SIMD
          for (int l = 0; l < V; ++l) sum[l] = J[e][l] + J[2][l] * p[3 + e][l] + J[3][l] * p[5 + e][l] + J[4][l] * p[7 + e][l];
        }
      }
    } else {
      alignas(64) double p[3][V];
      P::place(in, own + K, p);
      seen(in, p, at_sensor);
      by_its_image<S>(at_sensor, own, out);
    }
  }
};

#include "generated_models.inl"

}  // namespace models

// Linearised observations of one chunk, whitened.
struct Chunk {
  std::vector<double> v;  // (2)
  std::vector<double> x;  // (2, 3) by the object point
  std::vector<double> j;  // (2, stride) by the selected columns: own node, then shared node
  std::vector<uint8_t> behind, diverged;
  std::vector<double> rho;  // robust cost of the observation
  std::vector<const int32_t*> at;  // columns of the shared node that it touches; null: all of them in their order
  std::vector<int32_t> shared;     // how many
  int stride = 0;

  void resize(int64_t n, int columns) {
    stride = columns;
    if (static_cast<int64_t>(behind.size()) < n) {
      v.resize(2 * n);
      x.resize(6 * n);
      behind.resize(n);
      diverged.resize(n);
      rho.resize(n);
      at.resize(n);
      shared.resize(n);
    }
    if (static_cast<int64_t>(j.size()) < 2 * n * columns) j.resize(2 * n * columns);
  }
};

enum class Want { value, jacobian };

// Whether the sensor-frame point lies on the side that the sensor sees, as `in_front` of the Python model: along -Z,
// everywhere but at the projection centre, or in front of the line at the turn at which it was measured.
template <class M, class = void> struct Side {
  static bool in_front(const double* P, const double*, const double*) {
    if constexpr (M::all_round) return P[0] != 0 || P[1] != 0 || P[2] != 0;
    return P[2] < 0;
  }
};
template <> struct Side<models::panorama> {
  static bool in_front(const double* P, const double* xy, const double* io) {
    const double turn = xy[0] / io[0];
    return std::sin(turn) * P[0] - std::cos(turn) * P[2] - io[2] > 0;
  }
};

template <> struct Side<models::spherical> {
  static bool in_front(const double* P, const double* xy, const double* io) {
    const double turn = xy[0] / io[0];
    return std::sin(turn) * P[0] - std::cos(turn) * P[2] > 0;
  }
};
// of a sensor on a platform: where the platform puts the point
template <class M> struct Side<M, std::void_t<typename M::platform>> {
  static bool in_front(const double* P, const double* xy, const double* io) {
    const double in[5] = {xy[0], xy[1], P[0], P[1], P[2]};
    double own[3];
    M::platform::place_one(in, io + M::K, own);
    return Side<typename M::sensor>::in_front(own, xy, io);
  }
};

// Held coordinates are no unknowns: their partial derivatives vanish.
static inline void hold(uint8_t held, double* x) {
  if (held)
    for (int e = 0; e < 3; ++e)
      if (held & (1 << e)) x[e] = x[3 + e] = 0;
}

// What is compiled of each model; lanes that are not filled repeat the first one.
struct Compiled {
  int parameters;
  bool explicit_image;
  void (*by_image)(const double (*)[V], const double (*)[V], double (*)[V]);
  void (*evaluate)(const double (*)[V], const double (*)[V], double (*)[V]);
  void (*in_front)(const double (*)[V], const double (*)[V], bool*);
};

template <class M> static void in_front(const double (*in)[V], const double (*measured)[V], bool* front) {
  constexpr int K = M::parameters;
  for (int l = 0; l < V; ++l) {
    const double P[3] = {in[2][l], in[3][l], in[4][l]}, xy[2] = {measured[0][l], measured[1][l]};
    double own[K + 1];
    for (int e = 0; e < K; ++e) own[e] = in[5 + e][l];
    front[l] = Side<M>::in_front(P, xy, own);
  }
}

static const Compiled* compiled() {
#define RB_ENTRY(name) \
  {models::name::parameters, models::name::explicit_image, &models::by_its_image<models::name>, &models::evaluated<models::name>, \
   &in_front<models::name>},
  static const Compiled table[] = {RB_MODELS(RB_ENTRY)};
#undef RB_ENTRY
  return table;
}

// Moves the image points of the lanes to where the condition holds; lost: lanes in which none does, at the measured one.
static void onto_condition(const Compiled& m, double (*in)[V], const double (*measured)[V], double (*g)[V], bool* lost) {
  alignas(64) double relative[V], found[V];  // found: one, or zero once a lane is lost
  std::fill_n(found, V, 1.0);
  double worst = 1;
  for (int it = 0; it < 25 && worst >= 1e-14; ++it) {
    m.by_image(in, in + 5, g);
    RB_SIMD
    for (int l = 0; l < V; ++l) {
      const double det = g[2][l] * g[5][l] - g[3][l] * g[4][l];
      const double dx = (g[5][l] * g[0][l] - g[3][l] * g[1][l]) / det, dy = (g[2][l] * g[1][l] - g[4][l] * g[0][l]) / det;
      const double size = std::abs(dx) + std::abs(dy), scale = std::abs(in[0][l]) + std::abs(in[1][l]) + 1;
      const double kept = size < 1e3 * scale && det > 0 ? found[l] : 0.0;
      in[0][l] = kept > 0 ? in[0][l] - dx : measured[0][l];
      in[1][l] = kept > 0 ? in[1][l] - dy : measured[1][l];
      relative[l] = kept > 0 ? size / scale : 0.0;
      found[l] = kept;
    }
    worst = *std::max_element(relative, relative + V);
  }
  for (int l = 0; l < V; ++l) {
    lost[l] = found[l] == 0 || (worst >= 1e-14 && relative[l] > 1e-9);
    if (lost[l])
      for (int e = 0; e < 2; ++e) in[e][l] = measured[e][l];
  }
}

// Observations first ... first + count - 1, all of one model.
template <Want W> static void linearise_lanes(const Compiled& m, const Problem& q, const State& s, int64_t first, int count, int64_t base, Chunk& out) {
  const int K = m.parameters, A = 5 + K;
  alignas(64) double in[5 + kMaxParameters][V], o[2 + 2 * (5 + kMaxParameters)][V], R[9][V], w[3][V], measured[2][V], v[2][V], weight[V];
  alignas(64) int64_t row[V], image[V], point[V], interior[V];
  for (int l = 0; l < V; ++l) {
    row[l] = first + std::min(l, count - 1);
    image[l] = q.image[row[l]];
    point[l] = 3 * int64_t(q.point[row[l]]);
    interior[l] = int64_t(q.interior[image[l]]) * q.interior_stride;
  }
  const auto gathered = [](const double* from, const int64_t* at, int64_t width, double* to) {
    RB_SIMD
    for (int l = 0; l < V; ++l) to[l] = from[width * at[l]];
  };
  for (int e = 0; e < 9; ++e) gathered(s.rotation + e, image, 9, R[e]);
  for (int e = 0; e < 3; ++e) {
    gathered(q.whiten.data() + e, row, 3, w[e]);
    gathered(s.xyz + e, point, 1, o[e]);
    gathered(s.centre + e, image, 3, o[3 + e]);
  }
  for (int e = 0; e < 2; ++e) {
    gathered(q.xy.data() + e, row, 2, measured[e]);
    std::copy_n(measured[e], V, in[e]);
  }
  for (int e = 0; e < K; ++e) gathered(s.interior + e, interior, 1, in[5 + e]);
  for (int e = 0; e < 3; ++e)
    for (int l = 0; l < V; ++l) o[e][l] -= o[3 + e][l];
  for (int e = 0; e < 3; ++e)
    for (int l = 0; l < V; ++l) in[2 + e][l] = R[3 * e][l] * o[0][l] + R[3 * e + 1][l] * o[1][l] + R[3 * e + 2][l] * o[2][l];

  const bool direct = m.explicit_image || q.corrected[image[0]] != 0;
  bool lost[V] = {}, front[V];
  if (!direct) onto_condition(m, in, measured, o, lost);
  m.in_front(in, measured, front);
  if constexpr (W == Want::jacobian)
    m.evaluate(in, in + 5, o);
  else if (direct || std::any_of(lost, lost + V, [](bool l) { return l; }))
    m.by_image(in, in + 5, o);
  // lost: no image point fulfils the condition; the linearised one stands in until the state has moved
  for (int c = 0; c < 2; ++c)
    for (int l = 0; l < V; ++l) v[c][l] = direct || lost[l] ? -o[c][l] : in[c][l] - measured[c][l];
  for (int l = 0; l < V; ++l) {
    const double v0 = w[0][l] * v[0][l], v1 = w[1][l] * v[0][l] + w[2][l] * v[1][l];
    v[0][l] = v0;
    v[1][l] = v1;
    weight[l] = 1;
  }
  for (int l = 0; l < count; ++l) {
    const int64_t n = first - base + l;
    const double square = v[0][l] * v[0][l] + v[1][l] * v[1][l];
    double rho = 0.5 * square;
    if (s.huber > 0 && square > s.huber * s.huber) {
      const double length = std::sqrt(square);
      weight[l] = std::sqrt(s.huber / length);
      rho = s.huber * (length - 0.5 * s.huber);
    }
    out.diverged[n] = lost[l];
    out.behind[n] = !front[l];
    out.rho[n] = rho;
    for (int c = 0; c < 2; ++c) out.v[2 * n + c] = weight[l] * v[c][l];
  }
  if constexpr (W == Want::value) return;

  // partial derivatives of v by the point in the sensor's frame and by the parameters, whitened: T of x, then of y
  alignas(64) double full[2][kMaxNode][V], x[2][3][V];
  const double(*J[2])[V] = {o + 4, o + 4 + A};
  alignas(64) double inverse[4][V];  // - (d g / d image)^-1; minus one where the condition itself is observed
  for (int l = 0; l < V; ++l) {
    inverse[0][l] = inverse[3][l] = -1;
    inverse[1][l] = inverse[2][l] = 0;
  }
  for (int l = 0; l < V && !direct; ++l) {
    const double a = o[2][l], b = o[3][l], c0 = o[2 + A][l], d0 = o[3 + A][l], by = lost[l] ? 0 : 1 / (a * d0 - b * c0);
    inverse[0][l] = lost[l] ? -1 : -d0 * by;
    inverse[1][l] = b * by;
    inverse[2][l] = c0 * by;
    inverse[3][l] = lost[l] ? -1 : -a * by;
  }
  alignas(64) double u[4][V];  // whitened by weight W times that
  for (int l = 0; l < V; ++l) {
    const double w0 = weight[l] * w[0][l], w1 = weight[l] * w[1][l], w2 = weight[l] * w[2][l];
    u[0][l] = w0 * inverse[0][l];
    u[1][l] = w0 * inverse[1][l];
    u[2][l] = w1 * inverse[0][l] + w2 * inverse[2][l];
    u[3][l] = w1 * inverse[1][l] + w2 * inverse[3][l];
  }
  for (int e = 0; e < 3 + K; ++e)
    for (int c = 0; c < 2; ++c) {
      double* to = full[c][3 + e];
      RB_SIMD
      for (int l = 0; l < V; ++l) to[l] = u[2 * c][l] * J[0][e][l] + u[2 * c + 1][l] * J[1][e][l];
    }
  for (int c = 0; c < 2; ++c) {
    double(*T)[V] = full[c] + 3;
    for (int e = 0; e < 3; ++e) {
      RB_SIMD
      for (int l = 0; l < V; ++l) {
        x[c][e][l] = T[0][l] * R[e][l] + T[1][l] * R[3 + e][l] + T[2][l] * R[6 + e][l];
        full[c][e][l] = -x[c][e][l];
      }
    }
    RB_SIMD
    for (int l = 0; l < V; ++l) {
      const double t0 = T[0][l], t1 = T[1][l], t2 = T[2][l], px = in[2][l], py = in[3][l], pz = in[4][l];
      T[0][l] = py * t2 - pz * t1;
      T[1][l] = pz * t0 - px * t2;
      T[2][l] = px * t1 - py * t0;
    }
  }
  for (int l = 0; l < count; ++l) {
    const int64_t n = first - base + l;
    const Pattern& pattern = q.patterns[q.pattern[image[l]]];
    const int *own = pattern.own.data(), *shared = pattern.shared.data(), owns = int(pattern.own.size()), shares = int(pattern.shared.size());
    for (int c = 0; c < 2; ++c) {
      for (int e = 0; e < 3; ++e) out.x[6 * n + 3 * c + e] = x[c][e][l];
      const double* from = &full[c][0][l];
      double* RB_RESTRICT j = &out.j[(2 * n + c) * out.stride];
      for (int k = 0; k < owns; ++k) j[k] = from[own[k] * V];
      for (int k = 0; k < shares; ++k) j[owns + k] = from[shared[k] * V];
    }
    hold(q.held[q.owner[first + l]], &out.x[6 * n]);
  }
}

// A model that is not compiled: v and the partial derivatives were computed outside.
static void linearise_external(const Problem& q, const State& s, int64_t i, int64_t base, Want want, Chunk& out) {
  const int64_t n = i - base;
  const int f = q.image[i];
  const int32_t* touched = q.touched.data() + int64_t(q.external_row[i]) * q.external_width;
  const bool few = q.external_width > 0 && touched[0] >= 0;
  const int K = few ? q.external_width : q.parameters[f], width = 9 + 2 * q.external_width;
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
  const double* I[2] = {e + 8, e + 8 + q.external_width};
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
    if (few)
      for (int a = 0; a < K; ++a) *j++ = full[c][6 + a];
    else
      for (int a : pattern.shared) *j++ = full[c][a];
  }
  if (few) {
    out.at[n] = touched;
    out.shared[n] = K;
  }
}

template <Want W> static void linearise(const Problem& q, const State& s, int64_t begin, int64_t end, Chunk& out) {
  int stride = 0;
  for (const Pattern& p : q.patterns) stride = std::max(stride, int(p.own.size() + p.shared.size()));
  if (q.external_width) stride = std::max(stride, kMaxNode);
  out.resize(end - begin, std::max(stride, 1));
  for (int64_t i = begin; i < end; ++i) {
    out.at[i - begin] = nullptr;
    out.shared[i - begin] = int32_t(q.patterns[q.pattern[q.image[i]]].shared.size());
  }
  const Compiled* models = compiled();
  for (int64_t i = begin; i < end;) {
    const int f = q.image[i], model = q.model[f], corrected = q.corrected[f];
    if (model < 0) {
      linearise_external(q, s, i++, begin, W, out);
      continue;
    }
    int n = 1;
    while (i + n < end && n < V && q.model[q.image[i + n]] == model && q.corrected[q.image[i + n]] == corrected) ++n;
    linearise_lanes<W>(models[model], q, s, i, n, begin, out);
    i += n;
  }
}
