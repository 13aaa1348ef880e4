// Statistics from the selected inverse.  Included by kernels.cpp within its namespace.

// t += Z' y for a block Z (rows, C); three columns, kStride apart.
template <int C>
static RB_INLINE void multiply_fixed(const double* RB_RESTRICT z, int rows, const double* RB_RESTRICT y, double* RB_RESTRICT t, int kStride) {
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

static RB_INLINE void multiply(const double* z, int rows, int cols, const double* y, double* t, int kStride) {
  switch (cols) {
#define RB_CASE(n) case n: multiply_fixed<n>(z, rows, y, t, kStride); return;
    RB_CASE(1) RB_CASE(2) RB_CASE(3) RB_CASE(4) RB_CASE(5) RB_CASE(6) RB_CASE(7) RB_CASE(8)
    RB_CASE(9) RB_CASE(10) RB_CASE(11) RB_CASE(12) RB_CASE(13) RB_CASE(14) RB_CASE(15) RB_CASE(16)
#undef RB_CASE
    default:
      for (int r = 0; r < rows; ++r)
        for (int e = 0; e < 3; ++e)
          for (int x = 0; x < cols; ++x) t[e * kStride + x] += z[r * cols + x] * y[e * kStride + r];
  }
}

// a' b of n numbers, a multiple of V.
static RB_INLINE double dot(const double* RB_RESTRICT a, const double* RB_RESTRICT b, int n) {
  alignas(64) double sum[V] = {};
  for (int i = 0; i < n; i += V) {
    RB_SIMD
    for (int l = 0; l < V; ++l) sum[l] += a[i + l] * b[i + l];
  }
  return ((sum[0] + sum[4]) + (sum[2] + sum[6])) + ((sum[1] + sum[5]) + (sum[3] + sum[7]));
}

// From the selected inverse Z of the reduced normal matrix: cofactors of the object points, the 2 x 2
// diagonal blocks A Q A' of every observation, and the effect of a unit blunder on its own point.
// gauge_*: of the S-transformation, datum columns: H = Q B G of the nodes, B G and G of the points, M = (G'BG)^-1;
// datum = 0 without.  H of the points comes back in point_h.
// D the number of datum columns where it is known when compiled, or -1; Plain as Problem::plain.
template <int D, bool Plain>
static void statistics_of(const Problem& q, const State& s, int threads, const double* inverse, int columns, const double* gauge_nodes,
                       const double* gauge_given, const double* gauge_points, const double* gauge_middle, double* point_cofactor,
                       double* hat, double* effect, double* point_h) {
  const int datum = D >= 0 ? D : columns;
  std::vector<double> turned(q.block_start.back());  // every block transposed, so that both products run along memory
  for (size_t k = 0; k < q.block_row.size(); ++k) {
    const int rows = q.size[q.block_row[k]], cols = q.size[q.block_col[k]];
    const double* from = inverse + q.block_start[k];
    double* to = turned.data() + q.block_start[k];
    for (int r = 0; r < rows; ++r)
      for (int x = 0; x < cols; ++x) to[x * rows + r] = from[r * cols + x];
  }
  for_pieces(threads, pieces_of(q), q, [&](std::vector<double>&, int, int begin, int end) {
    Chunk c;
    const int64_t room = int64_t(q.largest_point_nodes) * 3 * q.coupling_stride;
    std::vector<double> y(room), tt(room);
    for_runs(q, begin, end, [&](int pb, int pe, int64_t base) {
      const int kStride = Plain ? kPlainStride : q.coupling_stride;
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
          if (datum > 0)
            std::memcpy(point_h + 3 * int64_t(q.id[p]) * datum, gauge_nodes + q.offset[q.node_of_point[p]] * datum,
                        sizeof(double) * 3 * datum);
        } else {
          PointNormal n;
          gather_point(q, s, p, base, c, n);
          gather_couplings<Plain>(q, p, base, c, y.data());
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
          std::fill_n(tt.data(), k * 3 * kStride, 0.0);
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
              multiply(z, rows, cols, ya, tb, kStride);
              if (a != b) multiply(turned.data() + q.block_start[*block], cols, rows, yb, ta, kStride);
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
          if (datum > 0) {
            const double* given = gauge_given + 3 * int64_t(q.id[p]) * datum;
            double* out = point_h + 3 * int64_t(q.id[p]) * datum;
            for (int e = 0; e < 3; ++e)
              for (int g = 0; g < datum; ++g)
                out[e * datum + g] = I[e][0] * given[g] + I[e][1] * given[datum + g] + I[e][2] * given[2 * datum + g];
            for (int64_t a = 0; a < k; ++a) {
              const int node = q.point_nodes[nb + a];
              const double* row = gauge_nodes + q.offset[node] * datum;
              const double* ya = &y[a * 3 * kStride];
              for (int x = 0; x < q.size[node]; ++x, row += datum)
                for (int e = 0; e < 3; ++e) {
                  const double factor = ya[e * kStride + x];
                  RB_SIMD
                  for (int g = 0; g < datum; ++g) out[e * datum + g] -= factor * row[g];
                }
            }
          }
          for (int e = 0; e < 3; ++e)
            if (q.held[p] & (1 << e))
              for (int f = 0; f < 3; ++f) Q[3 * e + f] = Q[3 * f + e] = 0;
        }
        std::memcpy(point_cofactor + 9 * int64_t(q.id[p]), Q, sizeof Q);
        for (int e = 0; e < 3; ++e)
          if (q.held[p] & (1 << e))
            for (int g = 0; g < datum; ++g) point_h[(3 * int64_t(q.id[p]) + e) * datum + g] = 0;
        double moved[3][8] = {};  // G_p M
        for (int e = 0; e < 3 && datum > 0; ++e)
          for (int h = 0; h < datum; ++h) {
            const double factor = gauge_points[(3 * int64_t(q.id[p]) + e) * datum + h];
            for (int g = 0; g < datum; ++g) moved[e][g] += factor * gauge_middle[h * datum + g];
          }

        for (int64_t i = q.first[p]; i < q.first[p + 1]; ++i) {
          const int64_t n = i - base;
          const int f = q.image[i];
          const Pattern& pattern = q.patterns[q.pattern[f]];
          const int own = int(pattern.own.size()), shared = c.shared[n], size = own + shared;
          const int32_t* at = Plain ? nullptr : c.at[n];  // columns of the shared node
          double x[2][3];
          for (int r = 0; r < 2; ++r)
            for (int e = 0; e < 3; ++e) x[r][e] = c.x[6 * n + 3 * r + e];
          const double* j[2] = {&c.j[2 * n * c.stride], &c.j[(2 * n + 1) * c.stride]};
          // local cofactor of (own, shared) and their covariance with the point; filled up with zeros to whole lanes
          const int filled = (size + V - 1) / V * V;
          double H[2][2];
          alignas(64) double J[2][kMaxNode + V], QJ[2][kMaxNode + V], CP[3][kMaxNode + V];  // cov(local, l), cov(point, local)
          double QX[3][2];                                                                 // cov(point, l)
          for (int r = 0; r < 2; ++r) {
            std::copy_n(j[r], size, J[r]);
            std::fill_n(J[r] + size, filled - size, 0.0);
            std::fill_n(QJ[r], filled, 0.0);
          }
          for (int e = 0; e < 3; ++e) std::fill_n(CP[e] + size, filled - size, 0.0);
          const int32_t slots[3] = {q.slot_own[i], q.slot_shared[i], q.slot_point[i]};
          const int sizes[2] = {own, shared}, starts[2] = {0, own};
          const auto width = [&](int32_t slot) { return q.size[q.point_nodes[nb + slot]]; };
          for (int sa = 0; sa < 2; ++sa) {
            if (!sizes[sa]) continue;
            for (int sb = 0; sb < 2; ++sb) {
              if (!sizes[sb]) continue;
              // symmetric: rows of the block of sb and sa run along memory in it or in the turned one
              const int32_t low = std::min(slots[sa], slots[sb]), high = std::max(slots[sa], slots[sb]);
              const double* z = (slots[sb] <= slots[sa] ? inverse : turned.data()) + q.block_start[blocks[pair_index(k, low, high)]];
              const int columns_of_a = width(slots[sa]);
              for (int b = 0; b < sizes[sb]; ++b) {
                const double j0 = J[0][starts[sb] + b], j1 = J[1][starts[sb] + b];
                const double* row = z + int64_t(sb == 1 && at ? at[b] : b) * columns_of_a;
                double *to0 = QJ[0] + starts[sa], *to1 = QJ[1] + starts[sa];
                if (sa == 1 && at) {
                  for (int a = 0; a < shared; ++a) {
                    to0[a] += row[at[a]] * j0;
                    to1[a] += row[at[a]] * j1;
                  }
                  continue;
                }
                RB_SIMD
                for (int a = 0; a < sizes[sa]; ++a) {
                  to0[a] += row[a] * j0;
                  to1[a] += row[a] * j1;
                }
              }
            }
            const double* of_point = nullptr;  // rows the node's: the block itself or the turned one
            if (kept) {
              const int32_t low = std::min(slots[sa], slots[2]), high = std::max(slots[sa], slots[2]);
              of_point = (slots[sa] <= slots[2] ? inverse : turned.data()) + q.block_start[blocks[pair_index(k, low, high)]];
            }
            for (int e = 0; e < 3; ++e)
              for (int a = 0; a < sizes[sa]; ++a) {
                const int64_t to = sa == 1 && at ? at[a] : a;
                CP[e][starts[sa] + a] = kept ? of_point[3 * to + e] : -tt[(3 * int64_t(slots[sa]) + e) * kStride + to];
              }
          }
          for (int a = 0; a < filled; a += V)
            for (int r = 0; r < 2; ++r) {
              RB_SIMD
              for (int l = a; l < a + V; ++l) QJ[r][l] += CP[0][l] * x[r][0] + CP[1][l] * x[r][1] + CP[2][l] * x[r][2];
            }
          for (int e = 0; e < 3; ++e)
            for (int r = 0; r < 2; ++r)
              QX[e][r] = Q[3 * e] * x[r][0] + Q[3 * e + 1] * x[r][1] + Q[3 * e + 2] * x[r][2] + dot(CP[e], J[r], filled);
          for (int r = 0; r < 2; ++r)
            for (int t = 0; t < 2; ++t)
              H[r][t] = dot(J[r], QJ[t], filled) + x[r][0] * QX[0][t] + x[r][1] * QX[1][t] + x[r][2] * QX[2][t];
          double* h = hat + 3 * q.row[i];
          h[0] = H[0][0];
          h[1] = H[1][1];
          h[2] = 0.5 * (H[0][1] + H[1][0]);
          if (datum > 0) {
            // S-transformation: minus G_p M (A_i H)'
            for (int r = 0; r < 2; ++r) {
              double u[8] = {};
              const auto add = [&](double factor, const double* row) {
                RB_SIMD
                for (int g = 0; g < datum; ++g) u[g] += factor * row[g];
              };
              if (own)
                for (int a = 0; a < own; ++a) add(j[r][a], gauge_nodes + (q.offset[q.own_node[f]] + a) * datum);
              if (shared)
                for (int a = 0; a < shared; ++a)
                  add(j[r][own + a], gauge_nodes + (q.offset[q.shared_node[f]] + (at ? at[a] : a)) * datum);
              for (int e = 0; e < 3; ++e) add(x[r][e], point_h + (3 * int64_t(q.id[p]) + e) * datum);
              for (int e = 0; e < 3; ++e) {
                double sum = 0;
                for (int g = 0; g < datum; ++g) sum += moved[e][g] * u[g];
                QX[e][r] -= sum;
              }
            }
          }
          for (int e = 0; e < 3; ++e)
            for (int r = 0; r < 2; ++r) effect[6 * q.row[i] + 2 * e + r] = QX[e][r];
        }
      }
    });
  });
}

static void statistics(const Problem& q, const State& s, int threads, const double* inverse, int datum, const double* gauge_nodes,
                       const double* gauge_given, const double* gauge_points, const double* gauge_middle, double* point_cofactor,
                       double* hat, double* effect, double* point_h) {
  const auto run = !q.plain()  ? &statistics_of<-1, false>
                   : datum == 0 ? &statistics_of<0, true>
                   : datum == 7 ? &statistics_of<7, true>
                                : &statistics_of<-1, true>;
  run(q, s, threads, inverse, datum, gauge_nodes, gauge_given, gauge_points, gauge_middle, point_cofactor, hat, effect, point_h);
}
