// The Gaussian and its integral, several at once.  Included by kernels that are compiled for every instruction set (RB_ARCH).
#pragma once
#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>

namespace raybundle {
namespace RB_ARCH {

// exp(-x^2) and erf(x) without branches, so that the compiler can take several at once; to 2e-13 of 1.
// erfc(x) = exp(-x^2) p(s) / (1 + 2 x), s = 3/2 (x - 3) / (x + 3) + 1/2 in [-1, 1] for x in [0, 6]: p by Chebyshev points.
static inline void gauss_erf(double z, double& gauss, double& erf) {
  constexpr double kExp[12] = {1.0, 1.0, 0.5, 0.16666666666666666, 0.041666666666666664, 0.008333333333333333, 0.001388888888888889, 0.0001984126984126984, 2.48015873015873e-05, 2.7557319223985893e-06, 2.755731922398589e-07, 2.505210838544172e-08};
  constexpr double kErfc[15] = {1.286341665817247, -0.02547188555084244, -0.12735942774007478, 0.11341004772435538, -0.054129044146960674,
                                0.015381523576548567, -0.0019191150886647972, -0.0002755832788123838, 0.00011949946088095429, 3.724681706534875e-06, -6.2121545158005985e-06, -1.5336571679090794e-07, 3.403412970409066e-07, 1.6916401574808446e-08, -1.5785731782333424e-08};
  constexpr double kLog2e = 1.4426950408889634, kLn2 = 0.6931471805599453, kMagic = 6755399441055744.0;  // 1.5 * 2^52
  const double x = std::min(std::abs(z), 6.0), y = -x * x;
  const double shifted = y * kLog2e + kMagic, n = shifted - kMagic, r = y - n * kLn2;
  double e = kExp[11];
  for (int k = 10; k >= 0; --k) e = e * r + kExp[k];
  gauss = e * std::bit_cast<double>((std::bit_cast<int64_t>(shifted) + 1023) << 52);
  const double s = 1.5 * (x - 3) / (x + 3) + 0.5;
  double p = kErfc[14];
  for (int k = 13; k >= 0; --k) p = p * s + kErfc[k];
  erf = std::copysign(1 - gauss * p / (1 + 2 * x), z);
}

}  // namespace RB_ARCH
}  // namespace raybundle
