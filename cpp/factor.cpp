#include "factor.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>
#include <functional>
#include <queue>

namespace raybundle {

Dense& dense() {
  static Dense table;
  return table;
}

namespace {

constexpr int kBitRows = 16384;  // nodes of which rows of bits take 32 MB; more are lists until so many are left

// Minimum degree by explicit elimination; of equal degrees the first node.
struct Elimination {
  std::vector<int> order;
  std::vector<std::vector<int>> below;  // of each node: later neighbours at its elimination
};

Elimination eliminate(const Problem& q) {
  const int n = q.nodes;
  std::vector<std::vector<int>> list(n);  // ascending; a node that went leaves a list when the list next grows
  for (int a = 0; a < n; ++a)
    for (int b : q.adjacency[a])
      if (b != a) {
        list[a].push_back(b);
        list[b].push_back(a);
      }
  std::vector<int64_t> degree(n, 0);
  using Weighed = std::pair<int64_t, int>;
  std::priority_queue<Weighed, std::vector<Weighed>, std::greater<Weighed>> least;  // with earlier degrees, too
  for (int a = 0; a < n; ++a) {
    std::sort(list[a].begin(), list[a].end());
    list[a].erase(std::unique(list[a].begin(), list[a].end()), list[a].end());
    for (int b : list[a]) degree[a] += q.size[b];
    least.push({degree[a], a});
  }
  std::vector<char> gone(n, 0);
  Elimination result;
  result.order.reserve(n);
  result.below.resize(n);
  const auto next = [&]() {
    while (gone[least.top().second] || least.top().first != degree[least.top().second]) least.pop();
    const int best = least.top().second;
    gone[best] = 1;
    result.order.push_back(best);
    return best;
  };
  // a clique is left: once all that remain are connected, any order is as good
  const auto clique = [&]() {
    if (int(result.below[result.order.back()].size()) != n - int(result.order.size())) return false;
    const size_t first = result.order.size();
    for (int a = 0; a < n; ++a)
      if (!gone[a]) result.order.push_back(a);
    for (size_t s = first; s < result.order.size(); ++s)
      result.below[result.order[s]].assign(result.order.begin() + s + 1, result.order.end());
    return true;
  };
  const auto leaves = [&](int b, int best, int64_t added) {
    degree[b] += added - q.size[best];
    least.push({degree[b], b});
  };

  std::vector<int> fresh, grown, seen(n, -1);
  while (n - int(result.order.size()) > kBitRows) {
    const int best = next();
    std::vector<int>& below = result.below[best];
    for (int b : list[best])
      if (!gone[b]) below.push_back(b);
    std::vector<int>().swap(list[best]);
    for (int b : below) {
      std::vector<int>& own = list[b];
      fresh.clear();
      int64_t added = 0;
      for (int x : own) seen[x] = b;
      seen[b] = b;
      for (int x : below)
        if (seen[x] != b) {
          fresh.push_back(x);
          added += q.size[x];
        }
      if (!fresh.empty()) {
        own.erase(std::remove_if(own.begin(), own.end(), [&](int x) { return gone[x]; }), own.end());
        grown.resize(own.size() + fresh.size());
        std::merge(own.begin(), own.end(), fresh.begin(), fresh.end(), grown.begin());
        own = grown;
      }
      leaves(b, best, added);
    }
    if (clique()) return result;
  }

  std::vector<int> rest, place(n, -1);
  for (int a = 0; a < n; ++a)
    if (!gone[a]) {
      place[a] = int(rest.size());
      rest.push_back(a);
    }
  const size_t words = (rest.size() + 63) / 64;
  std::vector<uint64_t> adjacent(words * rest.size(), 0);
  const auto row = [&](int a) { return adjacent.data() + words * place[a]; };
  for (int a : rest)
    for (int b : list[a])
      if (!gone[b]) row(a)[place[b] / 64] |= uint64_t(1) << (place[b] % 64);
  const auto for_each = [&](size_t w, uint64_t bits, const auto& work) {
    for (; bits; bits &= bits - 1) work(rest[64 * w + std::countr_zero(bits)]);
  };
  while (result.order.size() < size_t(n)) {
    const int best = next();
    std::vector<int>& below = result.below[best];
    uint64_t* e = row(best);
    for (size_t w = 0; w < words; ++w) for_each(w, e[w], [&](int b) { below.push_back(b); });
    const auto flip = [&](uint64_t* r, int b) { r[place[b] / 64] ^= uint64_t(1) << (place[b] % 64); };
    for (int b : below) {
      uint64_t* r = row(b);
      int64_t added = 0;
      flip(r, best);
      flip(e, b);
      for (size_t w = 0; w < words; ++w) {
        for_each(w, e[w] & ~r[w], [&](int x) { added += q.size[x]; });
        r[w] |= e[w];
      }
      flip(e, b);
      leaves(b, best, added);
    }
    if (clique()) return result;
  }
  return result;
}

}  // namespace

Factor::Factor(const Problem& problem) : problem_(problem) {
  const int n = problem.nodes;
  Elimination elimination = eliminate(problem);
  const std::vector<int>& order = elimination.order;
  std::vector<int> when(n);
  for (int s = 0; s < n; ++s) when[order[s]] = s;
  for (auto& below : elimination.below)
    std::sort(below.begin(), below.end(), [&](int a, int b) { return when[a] < when[b]; });

  // merge a node into its parent's supernode where that adds few zeros
  std::vector<std::vector<int>> members(n);
  std::vector<int64_t> columns(n), rows(n), zeros(n, 0);
  std::vector<int> merged(n, 0);
  for (int a = 0; a < n; ++a) {
    members[a] = {a};
    columns[a] = problem.size[a];
    for (int b : elimination.below[a]) rows[a] += problem.size[b];
  }
  for (int s = 0; s < n; ++s) {
    const int a = order[s];
    if (elimination.below[a].empty()) continue;
    const int u = elimination.below[a].front();
    const int64_t extra = columns[a] * (columns[u] + rows[u] - rows[a]) + zeros[a] + zeros[u];
    const int64_t c = columns[a] + columns[u], whole = c * (c + 1) / 2 + c * rows[u];
    const double share = double(extra) / double(std::max<int64_t>(whole, 1));
    if (share > (c < 48 ? 0.5 : c < 128 ? 0.2 : 0.05)) continue;
    merged[a] = 1;
    columns[u] = c;
    zeros[u] = extra;
    members[u].insert(members[u].end(), members[a].begin(), members[a].end());
    members[a].clear();
  }
  std::vector<int> supernode_of(n, -1);
  for (int s = 0; s < n; ++s) {
    const int a = order[s];
    if (merged[a]) continue;
    Supernode node;
    node.nodes = members[a];
    std::sort(node.nodes.begin(), node.nodes.end(), [&](int x, int y) { return when[x] < when[y]; });
    for (int x : node.nodes) supernode_of[x] = static_cast<int>(supernodes_.size());
    node.below = elimination.below[a];
    supernodes_.push_back(std::move(node));
  }
  int64_t position = 0;
  std::vector<int64_t> rank(n);  // final elimination order of the nodes
  int64_t count = 0;
  for (auto& node : supernodes_)
    for (int x : node.nodes) rank[x] = count++;
  std::vector<int> local(n, -1);
  for (size_t s = 0; s < supernodes_.size(); ++s) {
    Supernode& node = supernodes_[s];
    std::sort(node.below.begin(), node.below.end(), [&](int a, int b) { return rank[a] < rank[b]; });
    int at = 0;
    for (int x : node.nodes) { node.local.push_back(at); local[x] = at; at += problem.size[x]; }
    node.columns = at;
    for (int x : node.below) { node.local.push_back(at); local[x] = at; at += problem.size[x]; }
    node.rows = at - node.columns;
    node.position = position;
    position += node.columns;
    entries_ += int64_t(node.columns) * (node.columns + 1) / 2 + int64_t(node.columns) * node.rows;
    const double c = node.columns, r = node.rows;
    operations_ += c * c * c / 3 + c * c * r + c * r * r;
    if (!node.below.empty()) {
      node.parent = supernode_of[node.below.front()];
      supernodes_[node.parent].children.push_back(static_cast<int>(s));
    }
    for (int x : node.nodes) {
      for (int64_t k = problem.column_first[x]; k < problem.column_first[x + 1]; ++k) {
        const int b = problem.block_col[k];
        // the block is (x, b) with x <= b; it belongs here if x goes first
        if (rank[b] < rank[x]) continue;
        node.entries.push_back({k, local[b], local[x], true});
      }
    }
  }
  // blocks (a, x) with a < x whose later index x is eliminated first
  for (int64_t k = 0; k < static_cast<int64_t>(problem.block_row.size()); ++k) {
    const int a = problem.block_row[k], x = problem.block_col[k];
    if (a == x || rank[x] > rank[a]) continue;
    Supernode& node = supernodes_[supernode_of[x]];
    const auto start = [&](int id) {
      const auto it = std::find(node.nodes.begin(), node.nodes.end(), id);
      if (it != node.nodes.end()) return node.local[it - node.nodes.begin()];
      const auto lo = std::lower_bound(node.below.begin(), node.below.end(), id, [&](int p, int q) { return rank[p] < rank[q]; });
      return node.local[node.nodes.size() + (lo - node.below.begin())];
    };
    node.entries.push_back({k, start(a), start(x), false});
  }
  for (auto& node : supernodes_) {
    if (node.parent < 0) continue;
    const Supernode& up = supernodes_[node.parent];
    std::vector<int> all = up.nodes;
    all.insert(all.end(), up.below.begin(), up.below.end());
    size_t at = 0;
    for (int x : node.below) {
      while (all[at] != x) ++at;
      node.map.push_back(up.local[at]);
    }
  }
  scale_.assign(problem.unknowns, 1.0);
}

int64_t Factor::factorise(const double* values, const double* added) {
  const Problem& q = problem_;
  for (int a = 0; a < q.nodes; ++a) {
    const double* block = values + q.block_start[q.column_first[a]];
    for (int e = 0; e < q.size[a]; ++e) {
      const double d = block[e * q.size[a] + e] + (added ? added[q.offset[a] + e] : 0);
      if (!(d > 0)) return q.offset[a] + e + 1;
      scale_[q.offset[a] + e] = 1 / std::sqrt(d);
    }
  }
  smallest_pivot_ = 1;
  smallest_pivot_at_ = -1;
  pivots_.assign(scale_.size(), 0.0);
  const Dense& blas = dense();
  std::vector<std::vector<double>> update(supernodes_.size());
  std::vector<double> u;
  for (size_t s = 0; s < supernodes_.size(); ++s) {
    Supernode& node = supernodes_[s];
    const int c = node.columns, r = node.rows, m = c + r;
    node.panel.assign(size_t(m) * c, 0.0);
    std::vector<double>& up = update[s];
    up.assign(size_t(r) * r, 0.0);
    double* F = node.panel.data();
    for (const Entry& entry : node.entries) {
      const int a = q.block_row[entry.block], b = q.block_col[entry.block], sa = q.size[a], sb = q.size[b];
      const double* v = values + q.block_start[entry.block];
      const double *da = &scale_[q.offset[a]], *db = &scale_[q.offset[b]];
      for (int x = 0; x < sa; ++x)
        for (int y = 0; y < sb; ++y) {
          const double value = v[x * sb + y] * da[x] * db[y];
          // transposed: the block's columns are the front's rows
          if (entry.transposed) F[size_t(entry.col + x) * m + entry.row + y] = value;
          else F[size_t(entry.col + y) * m + entry.row + x] = value;
        }
      if (a == b && added)
        for (int x = 0; x < sa; ++x) F[size_t(entry.col + x) * m + entry.row + x] += added[q.offset[a] + x] * da[x] * da[x];
    }
    for (int child : node.children) {
      const Supernode& kid = supernodes_[child];
      std::vector<double>& from = update[child];
      const int kr = kid.rows;
      for (size_t j = 0; j < kid.below.size(); ++j) {
        const int wj = q.size[kid.below[j]], cj = kid.local[kid.nodes.size() + j] - kid.columns, tj = kid.map[j];
        for (int y = 0; y < wj; ++y) {
          const double* source = &from[size_t(cj + y) * kr];
          const int col = tj + y;
          double* target = col < c ? F + size_t(col) * m : up.data() + size_t(col - c) * r - c;
          for (size_t i = j; i < kid.below.size(); ++i) {
            const int wi = q.size[kid.below[i]], ci = kid.local[kid.nodes.size() + i] - kid.columns, ti = kid.map[i];
            for (int x = (i == j ? y : 0); x < wi; ++x) target[ti + x] += source[ci + x];
          }
        }
      }
      std::vector<double>().swap(from);
    }
    int info = 0;
    blas.potrf("L", &c, F, &m, &info);
    const auto unknown = [&](int scalar) {
      size_t k = 0;
      while (k + 1 < node.nodes.size() && node.local[k + 1] <= scalar) ++k;
      return q.offset[node.nodes[k]] + scalar - node.local[k];
    };
    if (info != 0) return unknown(info - 1) + 1;
    for (int e = 0; e < c; ++e) {
      const double pivot = F[size_t(e) * m + e] * F[size_t(e) * m + e];
      const int64_t at = unknown(e);
      if (!std::isfinite(pivot)) return at + 1;  // whether potrf itself stops at a NaN is the library's choice
      pivots_[at] = pivot / (scale_[at] * scale_[at]);
      if (pivot < smallest_pivot_) {
        smallest_pivot_ = pivot;
        smallest_pivot_at_ = at;
      }
    }
    if (r > 0) {
      const double one = 1, minus = -1;
      blas.trsm("R", "L", "T", "N", &r, &c, &one, F, &m, F + c, &m);
      blas.syrk("L", "N", &r, &c, &minus, F + c, &m, &one, up.data(), &r);
    }
  }
  return 0;
}

void Factor::solve(double* x, int columns) const {
  const Problem& q = problem_;
  const Dense& blas = dense();
  const double one = 1, minus = -1;
  std::vector<double> top, low;
  const auto load = [&](const std::vector<int>& nodes, int count, std::vector<double>& to) {
    to.resize(size_t(count) * columns);
    int at = 0;
    for (int a : nodes)
      for (int e = 0; e < q.size[a]; ++e, ++at)
        for (int k = 0; k < columns; ++k) to[size_t(k) * count + at] = x[(q.offset[a] + e) * columns + k];
  };
  const auto store = [&](const std::vector<int>& nodes, int count, const std::vector<double>& from) {
    int at = 0;
    for (int a : nodes)
      for (int e = 0; e < q.size[a]; ++e, ++at)
        for (int k = 0; k < columns; ++k) x[(q.offset[a] + e) * columns + k] = from[size_t(k) * count + at];
  };
  for (int64_t i = 0; i < q.unknowns; ++i)
    for (int k = 0; k < columns; ++k) x[i * columns + k] *= scale_[i];
  for (const Supernode& node : supernodes_) {
    const int c = node.columns, r = node.rows, m = c + r;
    load(node.nodes, c, top);
    blas.trsm("L", "L", "N", "N", &c, &columns, &one, node.panel.data(), &m, top.data(), &c);
    store(node.nodes, c, top);
    if (r > 0) {
      load(node.below, r, low);
      blas.gemm("N", "N", &r, &columns, &c, &minus, node.panel.data() + c, &m, top.data(), &c, &one, low.data(), &r);
      store(node.below, r, low);
    }
  }
  for (size_t s = supernodes_.size(); s-- > 0;) {
    const Supernode& node = supernodes_[s];
    const int c = node.columns, r = node.rows, m = c + r;
    load(node.nodes, c, top);
    if (r > 0) {
      load(node.below, r, low);
      blas.gemm("T", "N", &c, &columns, &r, &minus, node.panel.data() + c, &m, low.data(), &r, &one, top.data(), &c);
    }
    blas.trsm("L", "L", "T", "N", &c, &columns, &one, node.panel.data(), &m, top.data(), &c);
    store(node.nodes, c, top);
  }
  for (int64_t i = 0; i < q.unknowns; ++i)
    for (int k = 0; k < columns; ++k) x[i * columns + k] *= scale_[i];
}

void Factor::selected_inverse(double* values) const {
  const Problem& q = problem_;
  const Dense& blas = dense();
  const double one = 1, minus = -1, zero = 0;
  std::vector<std::vector<double>> front(supernodes_.size());
  std::vector<int> waiting(supernodes_.size());
  for (size_t s = 0; s < supernodes_.size(); ++s) waiting[s] = static_cast<int>(supernodes_[s].children.size());
  std::vector<double> G, B;
  for (size_t s = supernodes_.size(); s-- > 0;) {
    const Supernode& node = supernodes_[s];
    const int c = node.columns, r = node.rows, m = c + r;
    std::vector<double>& Z = front[s];
    Z.assign(size_t(m) * m, 0.0);  // column-major, symmetric, full
    if (r > 0) {
      const std::vector<double>& P = front[node.parent];
      const Supernode& up = supernodes_[node.parent];
      const int pm = up.columns + up.rows;
      for (size_t j = 0; j < node.below.size(); ++j)
        for (int y = 0; y < q.size[node.below[j]]; ++y) {
          const double* source = &P[size_t(node.map[j] + y) * pm];
          double* target = &Z[size_t(node.local[node.nodes.size() + j] + y) * m];
          for (size_t i = 0; i < node.below.size(); ++i)
            std::memcpy(target + node.local[node.nodes.size() + i], source + node.map[i], sizeof(double) * q.size[node.below[i]]);
        }
      G.resize(size_t(r) * c);
      for (int y = 0; r && y < c; ++y) std::memcpy(&G[size_t(y) * r], &node.panel[size_t(y) * m + c], sizeof(double) * r);
      blas.trsm("R", "L", "N", "N", &r, &c, &one, node.panel.data(), &m, G.data(), &r);
      // Z21 = -Z22 G
      blas.gemm("N", "N", &r, &c, &r, &minus, &Z[size_t(c) * m + c], &m, G.data(), &r, &zero, &Z[c], &m);
      if (--waiting[node.parent] == 0) std::vector<double>().swap(front[node.parent]);
    }
    B.resize(size_t(c) * c);
    for (int y = 0; y < c; ++y) std::memcpy(&B[size_t(y) * c], &node.panel[size_t(y) * m], sizeof(double) * c);
    int info = 0;
    blas.potri("L", &c, B.data(), &c, &info);
    for (int y = 0; y < c; ++y)
      for (int x = y; x < c; ++x) Z[size_t(y) * m + x] = Z[size_t(x) * m + y] = B[size_t(y) * c + x];
    if (r > 0) {
      blas.gemm("T", "N", &c, &c, &r, &minus, G.data(), &r, &Z[c], &m, &one, Z.data(), &m);
      for (int y = 0; y < c; ++y)
        for (int x = 0; x < r; ++x) Z[size_t(c + x) * m + y] = Z[size_t(y) * m + c + x];
    }
    for (const Entry& entry : node.entries) {
      const int a = q.block_row[entry.block], b = q.block_col[entry.block], sa = q.size[a], sb = q.size[b];
      double* v = values + q.block_start[entry.block];
      const double *da = &scale_[q.offset[a]], *db = &scale_[q.offset[b]];
      for (int x = 0; x < sa; ++x)
        for (int y = 0; y < sb; ++y)
          v[x * sb + y] = da[x] * db[y] * (entry.transposed ? Z[size_t(entry.col + x) * m + entry.row + y] : Z[size_t(entry.col + y) * m + entry.row + x]);
    }
    if (node.children.empty()) std::vector<double>().swap(Z);
  }
}

}  // namespace raybundle
