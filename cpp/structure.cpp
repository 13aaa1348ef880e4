// Which unknowns meet in which block of the reduced normal matrix.
#include <algorithm>
#include <stdexcept>

#include "problem.hpp"

namespace raybundle {

void Problem::sort_points() {
  std::vector<int64_t> key(points);
  for (int p = 0; p < points; ++p) {
    int32_t low = INT32_MAX, high = 0;
    for (int64_t i = first[p]; i < first[p + 1]; ++i) {
      low = std::min(low, image[i]);
      high = std::max(high, image[i]);
    }
    key[p] = (int64_t(low) << 32) | high;
  }
  id.resize(points);
  for (int p = 0; p < points; ++p) id[p] = p;
  std::stable_sort(id.begin(), id.end(), [&](int32_t a, int32_t b) { return key[a] < key[b]; });
  row.resize(observations);
  std::vector<int64_t> start(points + 1, 0);
  for (int p = 0; p < points; ++p) {
    start[p + 1] = start[p] + first[id[p] + 1] - first[id[p]];
    for (int64_t i = 0; i < start[p + 1] - start[p]; ++i) row[start[p] + i] = first[id[p]] + i;
  }
  const auto permute = [](auto& values, const auto& from, size_t width) {
    auto copy = values;
    for (size_t i = 0; i < from.size(); ++i)
      for (size_t e = 0; e < width; ++e) values[i * width + e] = copy[size_t(from[i]) * width + e];
  };
  permute(image, row, 1);
  permute(point, row, 1);
  permute(xy, row, 2);
  permute(whiten, row, 3);
  permute(external_row, row, 1);
  permute(node_of_point, id, 1);
  permute(held, id, 1);
  permute(prior_weight, id, 3);
  permute(prior_value, id, 3);
  first = start;
  owner.resize(observations);
  for (int p = 0; p < points; ++p)
    for (int64_t i = first[p]; i < first[p + 1]; ++i) owner[i] = p;
}

void Problem::build_structure(const std::vector<std::pair<int32_t, int32_t>>& extra_pairs) {
  offset.assign(nodes + 1, 0);
  for (int a = 0; a < nodes; ++a) offset[a + 1] = offset[a] + size[a];
  unknowns = static_cast<int>(offset[nodes]);
  coupling_stride = kPlainStride;
  for (int a = 0; a < nodes; ++a) coupling_stride = std::max(coupling_stride, (size[a] + 7) / 8 * 8);

  point_nodes_first.assign(points + 1, 0);
  point_nodes.clear();
  slot_own.assign(observations, -1);
  slot_shared.assign(observations, -1);
  slot_point.assign(observations, -1);
  std::vector<int32_t> list;
  largest_point_nodes = 0;
  for (int p = 0; p < points; ++p) {
    list.clear();
    for (int64_t i = first[p]; i < first[p + 1]; ++i) {
      const int f = image[i];
      if (own_node[f] >= 0) list.push_back(own_node[f]);
      if (shared_node[f] >= 0) list.push_back(shared_node[f]);
    }
    if (node_of_point[p] >= 0 && first[p + 1] > first[p]) list.push_back(node_of_point[p]);
    std::sort(list.begin(), list.end());
    list.erase(std::unique(list.begin(), list.end()), list.end());
    const auto slot = [&](int32_t node) {
      return node < 0 ? -1 : static_cast<int32_t>(std::lower_bound(list.begin(), list.end(), node) - list.begin());
    };
    for (int64_t i = first[p]; i < first[p + 1]; ++i) {
      slot_own[i] = slot(own_node[image[i]]);
      slot_shared[i] = slot(shared_node[image[i]]);
      slot_point[i] = slot(node_of_point[p]);
    }
    point_nodes.insert(point_nodes.end(), list.begin(), list.end());
    point_nodes_first[p + 1] = static_cast<int64_t>(point_nodes.size());
    largest_point_nodes = std::max(largest_point_nodes, static_cast<int>(list.size()));
  }

  // points of each node, then the later nodes that it meets
  std::vector<int64_t> node_first(nodes + 1, 0);
  for (int32_t a : point_nodes) ++node_first[a + 1];
  for (int a = 0; a < nodes; ++a) node_first[a + 1] += node_first[a];
  std::vector<int32_t> node_points(point_nodes.size());
  {
    std::vector<int64_t> fill(node_first.begin(), node_first.end() - 1);
    for (int p = 0; p < points; ++p)
      for (int64_t q = point_nodes_first[p]; q < point_nodes_first[p + 1]; ++q) node_points[fill[point_nodes[q]]++] = p;
  }
  adjacency.assign(nodes, {});
  for (const auto& [a, b] : extra_pairs) adjacency[std::min(a, b)].push_back(std::max(a, b));
  std::vector<int32_t> mark(nodes, -1);
  for (int a = 0; a < nodes; ++a) {
    std::vector<int32_t> extra = std::move(adjacency[a]);
    std::vector<int32_t>& later = adjacency[a];
    later.clear();
    later.push_back(a);
    mark[a] = a;
    for (int32_t b : extra)
      if (mark[b] != a) { mark[b] = a; later.push_back(b); }
    for (int64_t q = node_first[a]; q < node_first[a + 1]; ++q) {
      const int p = node_points[q];
      for (int64_t s = point_nodes_first[p + 1] - 1; s >= point_nodes_first[p] && point_nodes[s] > a; --s) {
        const int32_t b = point_nodes[s];
        if (mark[b] != a) { mark[b] = a; later.push_back(b); }
      }
    }
    std::sort(later.begin(), later.end());
  }

  column_first.assign(nodes + 1, 0);
  for (int a = 0; a < nodes; ++a) column_first[a + 1] = column_first[a] + static_cast<int64_t>(adjacency[a].size());
  block_start.assign(1, 0);
  block_row.clear();
  block_col.clear();
  for (int a = 0; a < nodes; ++a)
    for (int32_t b : adjacency[a]) {
      block_row.push_back(a);
      block_col.push_back(b);
      block_start.push_back(block_start.back() + int64_t(size[a]) * size[b]);
    }

  point_pairs_first.assign(points + 1, 0);
  for (int p = 0; p < points; ++p) {
    const int64_t k = point_nodes_first[p + 1] - point_nodes_first[p];
    point_pairs_first[p + 1] = point_pairs_first[p] + k * (k + 1) / 2;
  }
  pair_block.resize(point_pairs_first[points]);
  // node by node, so that one row of positions serves all points of the node
  std::vector<int32_t> where(nodes, -1);
  std::vector<int64_t> done(points, 0);  // pairs of the point written so far: nodes come in ascending order
  for (int a = 0; a < nodes; ++a) {
    for (size_t s = 0; s < adjacency[a].size(); ++s) where[adjacency[a][s]] = static_cast<int32_t>(column_first[a] + s);
    for (int64_t q = node_first[a]; q < node_first[a + 1]; ++q) {
      const int p = node_points[q];
      const int64_t begin = point_nodes_first[p], end = point_nodes_first[p + 1];
      int64_t s = std::lower_bound(point_nodes.begin() + begin, point_nodes.begin() + end, a) - point_nodes.begin();
      int64_t out = point_pairs_first[p] + done[p];
      for (; s < end; ++s) pair_block[out++] = where[point_nodes[s]];
      done[p] = out - point_pairs_first[p];
    }
  }
}

int64_t Problem::block(int32_t row, int32_t col) const {
  if (row > col) std::swap(row, col);
  const auto& list = adjacency.at(row);
  const auto it = std::lower_bound(list.begin(), list.end(), col);
  if (it == list.end() || *it != col) return -1;
  return column_first[row] + (it - list.begin());
}

}  // namespace raybundle
