// What the bindings of all areas share: arrays of NumPy, and what each area adds to the module.
#pragma once
#include <nanobind/nanobind.h>
#include <nanobind/ndarray.h>

#include <cstdint>
#include <stdexcept>
#include <utility>
#include <vector>

namespace nb = nanobind;

using Doubles = nb::ndarray<double, nb::numpy, nb::c_contig, nb::device::cpu>;
using Ints = nb::ndarray<const int32_t, nb::numpy, nb::c_contig, nb::device::cpu>;
using Longs = nb::ndarray<const int64_t, nb::numpy, nb::c_contig, nb::device::cpu>;
using Bytes = nb::ndarray<uint8_t, nb::numpy, nb::c_contig, nb::device::cpu>;
using Const = nb::ndarray<const double, nb::numpy, nb::c_contig, nb::device::cpu>;

template <class T, class A> std::vector<T> copy(const A& a) { return std::vector<T>(a.data(), a.data() + a.size()); }

template <class T> nb::ndarray<T, nb::numpy, nb::c_contig, nb::device::cpu> array(std::vector<size_t> shape) {
  size_t n = 1;
  for (size_t s : shape) n *= s;
  T* data = new T[n]();
  nb::capsule owner(data, [](void* p) noexcept { delete[] static_cast<T*>(p); });
  return {data, shape.size(), shape.data(), owner};
}
inline Doubles make(std::vector<size_t> shape) { return array<double>(std::move(shape)); }

template <class T, int dimensions> using In = nb::ndarray<const T, nb::ndim<dimensions>, nb::numpy, nb::c_contig, nb::device::cpu>;
template <class T, int dimensions> using Into = nb::ndarray<T, nb::ndim<dimensions>, nb::numpy, nb::c_contig, nb::device::cpu>;

inline void require(bool fine, const char* what) {
  if (!fine) throw std::invalid_argument(what);
}

void bind_images(nb::module_& m);    // features, descriptors, windows, dots, corners
void bind_surfaces(nb::module_& m);  // approximate depths, refinement
