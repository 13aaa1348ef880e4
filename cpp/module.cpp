// Python bindings.
#include <nanobind/stl/pair.h>
#include <nanobind/stl/string.h>
#include <nanobind/stl/vector.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <memory>
#include <stdexcept>
#include <string>

#include "bindings.hpp"
#include "factor.hpp"
#include "problem.hpp"
#include "tables.hpp"

using namespace raybundle;

namespace {

struct Solver {
  Problem q;
  mutable std::unique_ptr<Factor> factor;  // ordered when it is first asked for
  std::vector<double> external;
  bool complete = false, factorised = false;
  int64_t interior_rows = 0;
  bool external_needed = false;

  static void check(bool fine, const char* what) {
    if (!fine) throw std::invalid_argument(what);
  }
  // What is set anew counts from the next set_nodes on.
  void begin() {
    complete = factorised = false;
    factor.reset();
    external.clear();
  }
  void ready() const { check(complete, "the problem is not complete: call set_nodes after set_observations, set_images, set_patterns, set_points"); }
  Factor& ordered() const {
    ready();
    if (!factor) factor = std::make_unique<Factor>(q);
    return *factor;
  }
  const Factor& solved() const {
    ready();
    require(factorised, "the matrix is not factorised: call factorise first, and solve only where it returns 0");
    return *factor;
  }
  static void count(int threads) { check(threads >= 1 && threads <= 4096, "the number of threads is not from 1 to 4096"); }
  State state(const Const& rotation, const Const& centre, const Const& interior, const Const& xyz, double huber, double damping, int threads) const {
    ready();
    count(threads);
    require(rotation.size() == size_t(9 * q.images) && centre.size() == size_t(3 * q.images), "exterior orientations have the wrong size");
    require(xyz.size() == size_t(3 * q.points), "object points have the wrong size");
    require(q.interior_stride == 0 || interior.size() % q.interior_stride == 0, "interior orientations have the wrong size");
    require(interior.size() >= size_t(interior_rows * q.interior_stride), "there are fewer interior orientations than images name");
    require(!external_needed || !external.empty(), "rows of models that are not compiled are missing: call set_external");
    return {rotation.data(), centre.data(), interior.data(), xyz.data(), external.empty() ? nullptr : external.data(), huber, damping};
  }
};

}  // namespace

NB_MODULE(_native, m) {
#ifndef RAYBUNDLE_LEAKS_TOLD
  // What is still alive when the interpreter ends is kept by it, as the frames of a last traceback are; that errors
  // leave nothing behind while it runs is for a test to say (tests/native).
  nb::set_leak_warnings(false);
#endif
  m.doc() = "Compiled kernels: observations, reduced normal matrix, sparse factor, selected inverse.";
  bind_images(m);
  bind_surfaces(m);
  m.def("instruction_set", [] { return std::string(kernels().name); });
  m.def("sensor_models", [] {
    std::vector<std::string> names;
    for (const char* name : model_names()) names.emplace_back(name);
    return names;
  });
  m.def("set_dense", [](uint64_t potrf, uint64_t potri, uint64_t trsm, uint64_t syrk, uint64_t gemm) {
    Dense& d = dense();
    d.potrf = reinterpret_cast<decltype(d.potrf)>(potrf);
    d.potri = reinterpret_cast<decltype(d.potri)>(potri);
    d.trsm = reinterpret_cast<decltype(d.trsm)>(trsm);
    d.syrk = reinterpret_cast<decltype(d.syrk)>(syrk);
    d.gemm = reinterpret_cast<decltype(d.gemm)>(gemm);
  });

  nb::class_<Columns>(m, "Columns")
      .def("__init__", [](Columns* c, const std::vector<bool>& is_number) {
        if (is_number.empty() || is_number.size() > 4096) throw std::invalid_argument("the number of columns is not from 1 to 4096");
        new (c) Columns(is_number);
      })
      .def("add", [](Columns& c, nb::bytes rows) { return c.add({rows.c_str(), rows.size()}); })
      .def_prop_ro("rows", &Columns::rows)
      .def("different", [](const Columns& c, size_t column) { return c.text_column(column).texts.size(); })
      .def("number", [](const Columns& c, size_t column) {
        const auto& values = c.number_column(column);
        auto found = array<double>({values.size()});
        std::copy(values.begin(), values.end(), found.data());
        return found;
      })
      .def("text", [](const Columns& c, size_t column) {
        const TextColumn& text = c.text_column(column);
        auto codes = array<int32_t>({text.codes.size()});
        std::copy(text.codes.begin(), text.codes.end(), codes.data());
        std::string texts;  // divided by line ends, which none of them holds
        for (const auto& t : text.texts) (texts += t) += '\n';
        return nb::make_tuple(codes, nb::bytes(texts.data(), texts.size()));
      });

  nb::class_<Solver>(m, "Solver")
      .def(nb::init<>())
      .def("set_observations",
           [](Solver& s, Ints image, Ints point, Const xy, Const whiten, Ints external_row) {
             Problem& q = s.q;
             s.check(image.size() <= INT32_MAX, "too many observations");
             s.check(point.size() == image.size() && xy.size() == 2 * image.size() && whiten.size() == 3 * image.size() &&
                         external_row.size() == image.size(),
                     "observation arrays differ in length");
             s.begin();
             q.observations = int(image.size());
             q.image = copy<int32_t>(image);
             q.point = copy<int32_t>(point);
             q.xy = copy<double>(xy);
             q.whiten = copy<double>(whiten);
             q.external_row = copy<int32_t>(external_row);
           })
      .def("set_images",
           [](Solver& s, Ints model, Ints corrected, Ints interior, Ints pattern, Ints own, Ints shared, Ints parameters, int stride) {
             Problem& q = s.q;
             const size_t n = model.size();
             s.check(corrected.size() == n && interior.size() == n && pattern.size() == n && own.size() == n && shared.size() == n &&
                         parameters.size() == n, "image arrays differ in length");
             s.check(stride >= 0 && stride <= 4096, "the stride of interior orientations is not from 0 to 4096");
             s.begin();
             q.images = int(n);
             q.model = copy<int32_t>(model);
             q.corrected = copy<int32_t>(corrected);
             q.interior = copy<int32_t>(interior);
             q.pattern = copy<int32_t>(pattern);
             q.own_node = copy<int32_t>(own);
             q.shared_node = copy<int32_t>(shared);
             q.parameters = copy<int32_t>(parameters);
             q.interior_stride = stride;
           })
      .def("set_patterns",
           [](Solver& s, const std::vector<std::pair<std::vector<int>, std::vector<int>>>& patterns) {
             s.begin();
             s.q.patterns.clear();
             for (const auto& [own, shared] : patterns) s.q.patterns.push_back({own, shared});
           })
      .def("set_points",
           [](Solver& s, Longs first, Ints node, Bytes held, Const weight, Const value) {
             Problem& q = s.q;
             const size_t p = node.size();
             s.check(first.size() == p + 1 && held.size() == p && weight.size() == 3 * p && value.size() == 3 * p,
                     "point arrays differ in length");
             s.begin();
             q.points = int(p);
             q.first = copy<int64_t>(first);
             q.node_of_point = copy<int32_t>(node);
             q.held = copy<uint8_t>(held);
             q.prior_weight = copy<double>(weight);
             q.prior_value = copy<double>(value);
           })
      .def("set_nodes",
           [](Solver& s, Ints size, const std::vector<std::pair<int32_t, int32_t>>& extra) {
             s.check(!s.complete, "set_nodes orders the problem: set observations, images, patterns and points again before it");
             s.q.nodes = int(size.size());
             s.q.size = copy<int32_t>(size);
             nb::gil_scoped_release release;
             s.q.check(extra);
             s.interior_rows = 0;
             s.external_needed = false;
             for (const int32_t f : s.q.image) {
               s.interior_rows = std::max(s.interior_rows, int64_t(s.q.interior[f]) + 1);
               s.external_needed = s.external_needed || s.q.model[f] < 0;
             }
             s.q.sort_points();
             s.q.build_structure(extra);
             s.complete = true;
           })
      .def("set_held",
           [](Solver& s, Bytes held) {
             s.ready();
             s.check(held.size() == size_t(s.q.points), "point arrays differ in length");
             for (int p = 0; p < s.q.points; ++p) s.q.held[p] = held.data()[s.q.id[p]];
           })
      .def("set_external",
           [](Solver& s, Const rows, Ints touched, int width) {
             s.ready();
             s.check(width <= kMaxParameters, "an image point touches more than 64 parameters of its sensor model");
             s.check(width > 0 && rows.size() % (9 + 2 * width) == 0 && touched.size() == rows.size() / (9 + 2 * width) * width,
                     "rows of models that are not compiled have the wrong size");
             s.external.clear();
             s.q.external_width = width;
             s.q.touched = copy<int32_t>(touched);
             s.q.check_external(rows.size() / (9 + 2 * width));
             s.external = copy<double>(rows);
           })
      .def("block", [](const Solver& s, int a, int b) {
             s.ready();
             if (a < 0 || b < 0 || a >= s.q.nodes || b >= s.q.nodes) throw std::out_of_range("there is no such node");
             return s.q.block(a, b);
           })
      .def("block_start", [](const Solver& s, int64_t k) {
             s.ready();
             if (k < 0 || size_t(k) >= s.q.block_start.size()) throw std::out_of_range("there is no such block");
             return s.q.block_start[k];
           })
      .def("blocks",
           [](const Solver& s) {
             s.ready();
             const size_t count = s.q.block_row.size();
             auto rows = array<int64_t>({count}), cols = array<int64_t>({count}), starts = array<int64_t>({count});
             std::copy(s.q.block_row.begin(), s.q.block_row.end(), rows.data());
             std::copy(s.q.block_col.begin(), s.q.block_col.end(), cols.data());
             std::copy(s.q.block_start.begin(), s.q.block_start.begin() + count, starts.data());
             return nb::make_tuple(rows, cols, starts);
           })
      .def_prop_ro("unknowns", [](const Solver& s) { return s.q.unknowns; })
      .def_prop_ro("values_size", [](const Solver& s) { s.ready(); return s.q.block_start.back(); })
      .def_prop_ro("factor_entries", [](const Solver& s) { return s.ordered().entries(); })
      .def_prop_ro("factor_operations", [](const Solver& s) { return s.ordered().operations(); })
      .def_prop_ro("smallest_pivot", [](const Solver& s) { return s.solved().smallest_pivot(); })
      .def_prop_ro("smallest_pivot_at", [](const Solver& s) { return s.solved().smallest_pivot_at(); })
      .def("pivots", [](const Solver& s, Doubles out) {
             const std::vector<double>& pivots = s.solved().pivots();
             s.check(out.size() == pivots.size(), "pivots have the wrong size");
             std::copy(pivots.begin(), pivots.end(), out.data());
           })
      .def("reduce",
           [](Solver& s, Const R, Const C, Const I, Const X, double huber, double damping, int threads, Doubles values, Doubles right,
              Doubles diagonal) {
             const State state = s.state(R, C, I, X, huber, damping, threads);
             s.check(values.size() == size_t(s.q.block_start.back()) && right.size() == size_t(s.q.unknowns) &&
                         diagonal.size() == size_t(s.q.unknowns), "normal matrix has the wrong size");
             double *v = values.data(), *r = right.data(), *d = diagonal.data();
             Totals t;
             {
               nb::gil_scoped_release release;
               t = kernels().reduce(s.q, state, threads, v, r, d);
             }
             return nb::make_tuple(t.cost, t.behind, t.diverged, t.weak);
           })
      .def("back_substitute",
           [](Solver& s, Const R, Const C, Const I, Const X, double huber, double damping, int threads, Const step, Doubles points) {
             const State state = s.state(R, C, I, X, huber, damping, threads);
             s.check(step.size() == size_t(s.q.unknowns) && points.size() == size_t(3 * s.q.points), "step has the wrong size");
             const double* d = step.data();
             double* p = points.data();
             nb::gil_scoped_release release;
             return kernels().back_substitute(s.q, state, threads, d, p).cost;
           })
      .def("evaluate",
           [](Solver& s, Const R, Const C, Const I, Const X, double huber, int threads, Doubles residuals, Bytes behind) {
             const State state = s.state(R, C, I, X, huber, 0, threads);
             double* v = residuals.size() ? residuals.data() : nullptr;
             uint8_t* b = behind.size() ? behind.data() : nullptr;
             s.check((!v || residuals.size() == size_t(2 * s.q.observations)) && (!b || behind.size() == size_t(s.q.observations)),
                     "residuals have the wrong size");
             Totals t;
             {
               nb::gil_scoped_release release;
               t = kernels().evaluate(s.q, state, threads, v, b);
             }
             return nb::make_tuple(t.cost, t.behind, t.diverged);
           })
      .def("factorise",
           [](Solver& s, Const values, Const added) {
             const Dense& d = dense();
             s.check(d.potrf && d.potri && d.trsm && d.syrk && d.gemm, "dense kernels are not set");
             s.ready();
             s.check(values.size() == size_t(s.q.block_start.back()), "normal matrix has the wrong size");
             s.check(!added.size() || added.size() == size_t(s.q.unknowns), "what is added to the diagonal has the wrong size");
             s.factorised = false;  // what a factorisation that stops has written is no factor, nor is the one before it left
             const double *v = values.data(), *a = added.size() ? added.data() : nullptr;
             int64_t stopped;
             {
               nb::gil_scoped_release release;
               stopped = s.ordered().factorise(v, a);
             }
             s.factorised = stopped == 0;
             return stopped;
           })
      .def("solve",
           [](const Solver& s, Doubles x, int columns) {
             const Factor& factor = s.solved();
             s.check(columns >= 1 && x.size() == size_t(s.q.unknowns) * columns, "right side has the wrong size");
             double* d = x.data();
             nb::gil_scoped_release release;
             factor.solve(d, columns);
           })
      .def("selected_inverse",
           [](const Solver& s, Doubles values) {
             const Factor& factor = s.solved();
             s.check(values.size() == size_t(s.q.block_start.back()), "normal matrix has the wrong size");
             double* v = values.data();
             nb::gil_scoped_release release;
             factor.selected_inverse(v);
           })
      .def("condense",
           [](Solver& s, Const R, Const C, Const I, Const X, int threads, Const given, int columns) {
             const State state = s.state(R, C, I, X, 0, 0, threads);
             s.check(columns >= 1 && columns <= 16 && given.size() == size_t(3 * s.q.points) * columns, "right side has the wrong size");
             Doubles right = make({size_t(s.q.unknowns), size_t(columns)});
             double* r = right.data();
             const double* g = given.data();
             {
               nb::gil_scoped_release release;
               kernels().condense(s.q, state, threads, columns, g, r);
             }
             return right;
           })
      .def("expand",
           [](Solver& s, Const R, Const C, Const I, Const X, int threads, Const nodes, Const given, int columns) {
             const State state = s.state(R, C, I, X, 0, 0, threads);
             s.check(columns >= 1 && columns <= 16 && nodes.size() == size_t(s.q.unknowns) * columns && (!given.size() || given.size() == size_t(3 * s.q.points) * columns),
                     "right side has the wrong size");
             Doubles points = make({size_t(s.q.points), 3, size_t(columns)});
             double* p = points.data();
             const double *n = nodes.data(), *g = given.size() ? given.data() : nullptr;
             {
               nb::gil_scoped_release release;
               kernels().expand(s.q, state, threads, columns, n, g, p);
             }
             return points;
           })
      .def("statistics", [](Solver& s, Const R, Const C, Const I, Const X, int threads, Const inverse, int datum, Const gauge_nodes,
                            Const gauge_given, Const gauge_points, Const gauge_middle) {
        const State state = s.state(R, C, I, X, 0, 0, threads);
        s.check(datum >= 0 && datum <= 7, "a datum has 0 to 7 unknowns");
        const size_t rows = size_t(3 * s.q.points) * datum;
        s.check(inverse.size() == size_t(s.q.block_start.back()), "inverse has the wrong size");
        s.check(gauge_nodes.size() == size_t(s.q.unknowns) * datum && gauge_given.size() == rows && gauge_points.size() == rows &&
                    gauge_middle.size() == size_t(datum) * datum && datum <= 7,
                "datum arrays have the wrong size");
        Doubles cofactor = make({size_t(s.q.points), 3, 3}), hat = make({size_t(s.q.observations), 3}),
                effect = make({size_t(s.q.observations), 3, 2}), point_h = make({size_t(s.q.points), 3, size_t(datum)});
        double *c = cofactor.data(), *h = hat.data(), *e = effect.data(), *p = point_h.data();
        const double *z = inverse.data(), *gn = gauge_nodes.data(), *gg = gauge_given.data(), *gp = gauge_points.data(),
                     *gm = gauge_middle.data();
        {
          nb::gil_scoped_release release;
          kernels().statistics(s.q, state, threads, z, datum, gn, gg, gp, gm, c, h, e, p);
        }
        return nb::make_tuple(cofactor, hat, effect, point_h);
      });
}
