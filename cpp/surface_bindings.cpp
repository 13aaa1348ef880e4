// Python bindings of the kernels of surfaces: census, costs, paths, places in sources, refinement.
#include <nanobind/stl/array.h>
#include <nanobind/stl/optional.h>
#include <nanobind/stl/vector.h>

#include <array>
#include <optional>

#include "bindings.hpp"
#include "surface.hpp"
#include "sweep.hpp"

using namespace raybundle;

namespace {

constexpr size_t kMostCells = size_t(1) << 40, kLongestSide = 32767;

Sweep sweep_of(const Into<uint8_t, 3>& cost, int step, size_t rows, size_t columns) {
  require(cost.shape(0) >= 1 && cost.shape(1) >= 1 && cost.shape(2) >= 1 && cost.shape(0) <= kLongestSide && cost.shape(1) <= kLongestSide &&
              cost.shape(2) <= kLongestSide && cost.size() < kMostCells,
          "costs have the wrong size");
  return {int(cost.shape(1)), int(cost.shape(0)), int(cost.shape(2)), step, int(rows), int(columns)};
}

void census(In<uint8_t, 2> image, Into<uint64_t, 2> out) {
  require(out.shape(0) == image.shape(0) && out.shape(1) == image.shape(1), "a census is of its image's size");
  require(image.shape(0) <= kLongestSide && image.shape(1) <= kLongestSide, "an image is too large");
  nb::gil_scoped_release release;
  sweep_kernels().census(image.data(), int(image.shape(1)), int(image.shape(0)), out.data());
}

void sweep_costs(In<uint64_t, 2> reference, const std::vector<In<uint64_t, 2>>& sources,
                 const std::vector<In<int32_t, 4>>& tables, int step, Into<uint8_t, 3> cost) {
  require(!tables.empty() && tables.size() == sources.size() && step >= 1, "sources have no tables");
  const size_t rows = tables[0].shape(1), columns = tables[0].shape(2);
  const Sweep sweep = sweep_of(cost, step, rows, columns);
  require(reference.shape(0) == cost.shape(0) && reference.shape(1) == cost.shape(1), "costs are not of the reference's size");
  require(rows >= 2 && columns >= 2 && (rows - 1) * step >= cost.shape(0) && (columns - 1) * step >= cost.shape(1),
          "tables do not cover the reference");
  std::vector<SweepSource> given;
  for (size_t k = 0; k < sources.size(); ++k) {
    const auto& t = tables[k];
    require(t.shape(0) == cost.shape(2) && t.shape(1) == rows && t.shape(2) == columns && t.shape(3) == 2, "a table has the wrong size");
    require(sources[k].shape(0) <= kLongestSide && sources[k].shape(1) <= kLongestSide, "an image is too large");
    given.push_back({sources[k].data(), int(sources[k].shape(1)), int(sources[k].shape(0)), t.data()});
  }
  nb::gil_scoped_release release;
  sweep_kernels().costs(sweep, reference.data(), given.data(), int(given.size()), cost.data());
}

void aggregate(In<uint8_t, 2> image, Into<uint8_t, 3> cost, int slope, int jump, int least, Into<uint16_t, 3> sum,
               Into<float, 2> level, Into<float, 2> margin) {
  const Sweep sweep = sweep_of(cost, 1, 0, 0);
  const auto of_image = [&](const auto& a) { return a.shape(0) == cost.shape(0) && a.shape(1) == cost.shape(1); };
  require(of_image(image) && of_image(sum) && of_image(level) && of_image(margin) && sum.shape(2) == cost.shape(2), "results are not of the image's size");
  require(0 <= slope && slope <= least && least <= jump && jump <= 90, "penalties are not 0 <= slope <= least <= jump <= 90");
  nb::gil_scoped_release release;
  sweep_kernels().aggregate(sweep, image.data(), cost.data(), {slope, jump, least}, sum.data(), level.data(), margin.data());
}

// Rows of a grid of pixels; fit: half, sigma, iterations, step, reach, slope, correlation, contrast, share, apart; grid: x0, y0,
// stride; tables: u0, v0, step, t0, dt of each.  numbers, reason, iterations and views are written where todo says so.
void refine_surface(In<float, 2> reference, const std::vector<In<float, 2>>& grey, const std::vector<In<double, 4>>& places,
                    const std::vector<std::array<double, 5>>& tables, const std::array<double, 10>& fit, const std::array<int, 3>& grid, int begin,
                    int end, int chain, const std::optional<In<float, 3>>& autocovariance, Into<float, 3> numbers, In<uint8_t, 2> todo,
                    Into<uint8_t, 2> reason, Into<uint8_t, 2> iterations, Into<int32_t, 2> views, const std::optional<Into<float, 4>>& shift,
                    const std::optional<Into<float, 3>>& response) {
  const size_t count = grey.size(), rows = todo.shape(0), columns = todo.shape(1);
  const auto of_grid = [&](const auto& a) { return a.shape(0) == rows && a.shape(1) == columns; };
  const auto small = [](size_t n) { return n < (size_t(1) << 30); };
  require(count >= 1 && count <= size_t(kMostSources) && places.size() == count && tables.size() == count, "the number of sources is not from 1 to 16");
  require(fit[0] >= 1 && fit[0] <= kLargestWindow && fit[1] > 0 && fit[2] >= 1 && fit[2] <= 255 && fit[5] > 0 && fit[9] > 0, "a window or its iteration is not as it can be");
  require(small(rows) && small(columns) && grid[0] >= 0 && grid[1] >= 0 && grid[2] >= 1 && (!rows || grid[1] + (double(rows) - 1) * grid[2] < double(reference.shape(0))) &&
            (!columns || grid[0] + (double(columns) - 1) * grid[2] < double(reference.shape(1))),
        "pixels lie beyond the reference image");
  require(begin >= 0 && begin <= end && size_t(end) <= rows && chain >= -1 && chain <= 1, "rows are not those of the grid");
  require(numbers.shape(0) == kSurfaceQuantities && numbers.shape(1) == rows && numbers.shape(2) == columns && of_grid(reason) && of_grid(iterations) && of_grid(views),
        "results have the wrong size");
  require(!autocovariance || (autocovariance->shape(0) == count + 1 && autocovariance->shape(1) == 2 * kLag + 1 && autocovariance->shape(2) == 2 * kLag + 1),
        "autocovariances are not (views, 7, 7)");
  require(!shift || (of_grid(*shift) && shift->shape(2) == count && shift->shape(3) == 2), "shifts have the wrong size");
  const size_t side = 2 * size_t(fit[0]) + 1;
  require(!response || (of_grid(*response) && response->shape(2) == side * side), "responses have the wrong size");
  require(reference.size() < (size_t(1) << 31), "the reference image is too large");
  std::vector<SurfaceSource> sources;
  for (size_t s = 0; s < count; ++s) {
    const auto& [u0, v0, step, t0, dt] = tables[s];
    const auto& p = places[s];
    require(grey[s].size() < (size_t(1) << 31) && p.shape(3) == 2 && step > 0 && dt != 0, "a source has the wrong size");
    require(p.shape(0) >= 4 && p.shape(1) >= 4 && p.shape(2) >= 4 && small(p.shape(0)) && small(p.shape(1)) && small(p.shape(2)), "a table has fewer than 4 nodes in a direction");
    sources.push_back({grey[s].data(), int(grey[s].shape(1)), int(grey[s].shape(0)),
                       {p.data(), int(p.shape(0)), int(p.shape(1)), int(p.shape(2)), u0, v0, step, t0, dt}});
  }
  const SurfaceImages images{reference.data(), int(reference.shape(1)), int(reference.shape(0)), sources.data(), int(count), autocovariance ? autocovariance->data() : nullptr};
  const SurfaceFit settings{int(fit[0]), fit[1], int(fit[2]), fit[3], fit[4], fit[5], fit[6], fit[7], fit[8], fit[9]};
  const SurfaceFound found{numbers.data(), todo.data(), reason.data(), iterations.data(), views.data(), shift ? shift->data() : nullptr, response ? response->data() : nullptr};
  nb::gil_scoped_release release;
  surface_kernels().refine(images, settings, {int(rows), int(columns), grid[0], grid[1], grid[2]}, begin, end, chain, found);
}

// table: u0, v0, step, t0, dt
void transfer_places(In<double, 4> places, const std::array<double, 5>& table, In<double, 2> xy, In<double, 1> t, Into<double, 2> out) {
  require(places.shape(3) == 2 && xy.shape(1) == 2 && out.shape(1) == 2 && t.shape(0) == xy.shape(0) && out.shape(0) == xy.shape(0), "places have the wrong size");
  for (size_t axis = 0; axis < 3; ++axis) require(places.shape(axis) >= 4 && places.shape(axis) < (size_t(1) << 30), "a table has fewer than 4 nodes in a direction");
  require(table[2] > 0 && table[4] != 0, "a table has no steps");
  nb::gil_scoped_release release;
  sweep_kernels().places({places.data(), int(places.shape(0)), int(places.shape(1)), int(places.shape(2)), table[0], table[1], table[2], table[3], table[4]},
                         xy.data(), t.data(), int64_t(t.shape(0)), out.data());
}

}  // namespace

void bind_surfaces(nb::module_& m) {
  m.def("census", &census);
  m.def("sweep_costs", &sweep_costs);
  m.def("aggregate_costs", &aggregate);
  m.def("transfer_places", &transfer_places);
  m.def("refine_surface", &refine_surface, nb::arg(), nb::arg(), nb::arg(), nb::arg(), nb::arg(), nb::arg(), nb::arg(), nb::arg(), nb::arg(),
        nb::arg().none(), nb::arg(), nb::arg(), nb::arg(), nb::arg(), nb::arg(), nb::arg().none(), nb::arg().none());
}
