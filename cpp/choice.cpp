// Which of the kernels that were compiled for several instruction sets are used.
#include <cstdlib>
#include <string>

#include "corners.hpp"
#include "features.hpp"
#include "imaging.hpp"
#include "problem.hpp"
#include "surface.hpp"
#include "sweep.hpp"
#include "targets.hpp"

namespace raybundle {

// The widest instruction set of this processor; RAYBUNDLE_NATIVE=avx2 or =baseline stays below it.
enum class Width { baseline, avx2, avx512 };

static Width width() {
#ifdef RB_X86
  const char* text = std::getenv("RAYBUNDLE_NATIVE");
  const std::string limit = text ? text : "";
  const bool avx2_here = __builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma");
  const bool avx512_here = avx2_here && __builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512dq") &&
                           __builtin_cpu_supports("avx512vl") && __builtin_cpu_supports("avx512bw");
  if (avx512_here && limit != "avx2" && limit != "baseline") return Width::avx512;
  if (avx2_here && limit != "baseline") return Width::avx2;
#endif
  return Width::baseline;
}

static Width chosen() {
  static const Width found = width();
  return found;
}

#ifdef RB_X86
#define RB_WIDEST(name) (chosen() == Width::avx512 ? avx512::name : chosen() == Width::avx2 ? avx2::name : baseline::name)
#else
#define RB_WIDEST(name) (static_cast<void>(chosen()), baseline::name)
#endif

const Kernels& kernels() { return RB_WIDEST(table); }
const ImagingKernels& imaging_kernels() { return RB_WIDEST(imaging); }
const TargetKernels& target_kernels() { return RB_WIDEST(targets); }
const CornerKernels& corner_kernels() { return RB_WIDEST(corners); }
const FeatureKernels& feature_kernels() { return RB_WIDEST(features); }
const SweepKernels& sweep_kernels() { return RB_WIDEST(sweep); }
const SurfaceKernels& surface_kernels() { return RB_WIDEST(surface); }

}  // namespace raybundle
