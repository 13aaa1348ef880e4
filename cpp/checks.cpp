// What is handed over from Python is held against itself before anything is read through an index of it.
#include <algorithm>
#include <climits>
#include <stdexcept>
#include <string>

#include "problem.hpp"

namespace raybundle {

namespace {

void need(bool fine, const char* what) {
  if (!fine) throw std::invalid_argument(what);
}

// All values lie from `low` up to, not including, `high`.
void range(const std::vector<int32_t>& values, int64_t low, int64_t high, const char* what) {
  for (const int32_t v : values)
    if (v < low || v >= high)
      throw std::out_of_range(std::string(what) + " " + std::to_string(v) + " is not from " + std::to_string(low) + " to " +
                              std::to_string(high - 1));
}

void check_columns(const std::vector<int>& columns, int least, int most) {
  for (const int c : columns)
    if (c < least || c >= most) throw std::out_of_range("a pattern names column " + std::to_string(c) + " that its sensor model lacks");
}

}  // namespace

void Problem::check(const std::vector<std::pair<int32_t, int32_t>>& extra_pairs) const {
  const size_t n = images, m = observations, p = points;
  need(image.size() == m && point.size() == m && xy.size() == 2 * m && whiten.size() == 3 * m && external_row.size() == m,
       "observation arrays differ in length; call set_observations again before set_nodes");
  need(model.size() == n && corrected.size() == n && interior.size() == n && pattern.size() == n && own_node.size() == n &&
           shared_node.size() == n && parameters.size() == n, "image arrays differ in length");
  need(first.size() == p + 1 && node_of_point.size() == p && held.size() == p && prior_weight.size() == 3 * p &&
           prior_value.size() == 3 * p, "point arrays differ in length");
  need(interior_stride >= 0, "the stride of interior orientations is negative");
  range(image, 0, images, "image");
  range(point, 0, points, "point");
  const auto& widths = model_parameters();
  range(model, -1, int64_t(widths.size()), "sensor model");
  range(interior, 0, INT32_MAX, "interior orientation");
  range(pattern, 0, int64_t(patterns.size()), "pattern");
  range(own_node, -1, nodes, "node");
  range(shared_node, -1, nodes, "shared node");
  range(node_of_point, -1, nodes, "node of a point");
  range(parameters, 0, kMaxParameters + 1, "number of parameters");
  need(first.front() == 0 && first.back() == observations && std::is_sorted(first.begin(), first.end()),
       "the observations of points do not follow each other");
  int64_t sum = 0;
  for (const int32_t s : size) {
    need(s >= 0, "a node has a negative size");
    sum += s;
  }
  need(sum <= INT32_MAX, "too many unknowns");
  for (const auto& [a, b] : extra_pairs) need(a >= 0 && b >= 0 && a < nodes && b < nodes, "an extra pair names a node that there is not");
  std::vector<uint8_t> seen(n, 0);
  for (size_t i = 0; i < m; ++i) {
    const int32_t f = image[i];
    seen[f] = 1;
    need(model[f] >= 0 || external_row[i] >= 0, "an observation of a model that is not compiled has no row");
  }
  for (size_t f = 0; f < n; ++f) {
    if (!seen[f]) continue;
    const Pattern& c = patterns[pattern[f]];
    const int width = model[f] >= 0 ? widths[model[f]] : parameters[f];
    need(model[f] < 0 || width <= interior_stride, "the stride of interior orientations is shorter than a sensor model's parameters");
    check_columns(c.own, 0, 6 + width);
    // of a model that is not compiled a row may name the columns that it touches: those are held in check_external
    check_columns(c.shared, 6, model[f] >= 0 ? 6 + width : INT_MAX);
    need(c.own.empty() || (own_node[f] >= 0 && int(c.own.size()) <= size[own_node[f]]), "a pattern has more columns than its image's node");
    need(c.shared.empty() || (shared_node[f] >= 0 && int(c.shared.size()) <= size[shared_node[f]]),
         "a pattern has more columns than its shared node");
    need(model[f] < 0 || int(c.own.size() + c.shared.size()) <= kMaxNode, "a pattern has more columns than a sensor model can have");
  }
  for (size_t k = 0; k < p; ++k)
    need(node_of_point[k] < 0 || size[node_of_point[k]] >= 3, "the node of a point has fewer than three unknowns");
}

void Problem::check_external(std::size_t rows) const {
  for (int i = 0; i < observations; ++i) {
    const int32_t f = image[i];
    if (model[f] >= 0) continue;
    need(external_width > 0 && size_t(external_row[i]) < rows, "rows of models that are not compiled are missing");
    const int32_t* columns = touched.data() + int64_t(external_row[i]) * external_width;
    const Pattern& c = patterns[pattern[f]];
    if (columns[0] < 0) {
      need(parameters[f] <= external_width, "rows of models that are not compiled are too short");
      check_columns(c.shared, 6, 6 + parameters[f]);
      need(int(c.own.size() + c.shared.size()) <= kMaxNode, "a pattern has more columns than a sensor model can have");
      continue;
    }
    need(shared_node[f] >= 0 && int(c.own.size()) + external_width <= kMaxNode, "a row touches parameters that its image does not have");
    for (int k = 0; k < external_width; ++k)
      need(columns[k] >= 0 && columns[k] < size[shared_node[f]], "a row touches a column that its shared node does not have");
  }
}

}  // namespace raybundle
