// Nearest neighbours of descriptors by inner products.  Included by imaging.cpp within its namespace.

constexpr int kRows = 6, kWide = 2 * kLanes;

// sums (kRows, kWide) of products of kRows rows of a (stride k) and a panel of b (k, kWide).
static inline void products(const float* a, int k, const float* panel, float* sums) {
  V acc[kRows][2] = {};
  for (int i = 0; i < k; ++i) {
    V b0, b1;
    std::memcpy(&b0, panel + i * kWide, sizeof b0);
    std::memcpy(&b1, panel + i * kWide + kLanes, sizeof b1);
    for (int r = 0; r < kRows; ++r) {
      const float f = a[r * k + i];
      acc[r][0] += f * b0;
      acc[r][1] += f * b1;
    }
  }
  std::memcpy(sums, acc, sizeof acc);
}

// The search of `best`: products(block, p, sums) gives sums (kRows, kWide) of a block of rows and a panel of columns.
template <class Products>
static void search(int n, int m, const Products& products, int32_t* first, float* value, float* second, int32_t* reverse) {
  constexpr float low = -std::numeric_limits<float>::max();
  const int panels = (m + kWide - 1) / kWide, blocks = (n + kRows - 1) / kRows;
  std::vector<float> top(blocks * kRows, low), next(blocks * kRows, low), column(panels * kWide, low);
  std::vector<int32_t> where(blocks * kRows, -1), row(panels * kWide, -1);
  alignas(64) float sums[kRows * kWide];
  // a strip of blocks stays in the second-level cache while the panels pass by
  constexpr int kStrip = 64;
  for (int strip = 0; strip < blocks; strip += kStrip)
    for (int p = 0; p < panels; ++p) {
      const int wide = std::min(kWide, m - p * kWide);
      float* c = column.data() + p * kWide;
      int32_t* cr = row.data() + p * kWide;
      for (int block = strip; block < std::min(blocks, strip + kStrip); ++block) {
        products(block, p, sums);
        for (int r = 0; r < kRows; ++r) {
          const int at = block * kRows + r;
          if (at >= n) break;
          const float* s = sums + r * kWide;
          const float bound = next[at];
          int32_t any = 0;
          for (int x = 0; x < kWide; ++x) any |= s[x] > bound;
          if (any)
            for (int x = 0; x < wide; ++x) {
              if (s[x] > top[at]) {
                next[at] = top[at];
                top[at] = s[x];
                where[at] = p * kWide + x;
              } else if (s[x] > next[at]) {
                next[at] = s[x];
              }
            }
          for (int x = 0; x < kWide; ++x) {
            const bool more = s[x] > c[x];
            c[x] = more ? s[x] : c[x];
            cr[x] = more ? at : cr[x];
          }
        }
      }
    }
  std::copy_n(where.data(), n, first);
  std::copy_n(top.data(), n, value);
  std::copy_n(next.data(), n, second);
  std::copy_n(row.data(), m, reverse);
}

static void best(const float* a, int n, const float* b, int m, int k, int32_t* first, float* value, float* second, int32_t* reverse) {
  const int panels = (m + kWide - 1) / kWide, blocks = (n + kRows - 1) / kRows;
  std::vector<float> packed(size_t(panels) * k * kWide, 0.0f), rows(size_t(blocks) * kRows * k, 0.0f);
  std::copy_n(a, size_t(n) * k, rows.data());
  for (int j = 0; j < m; ++j)
    for (int i = 0; i < k; ++i) packed[(size_t(j / kWide) * k + i) * kWide + j % kWide] = b[size_t(j) * k + i];
  const auto of = [&](int block, int p, float* sums) {
    products(rows.data() + size_t(block) * kRows * k, k, packed.data() + size_t(p) * k * kWide, sums);
  };
  search(n, m, of, first, value, second, reverse);
}

// Products of bytes are exact in whole numbers.  In a panel the values of `Group` neighbouring places stand together for
// each column, as the instructions want them: pairs of 16 bit, or four of 8 bit.
constexpr int kPair = 2, kFour = 4;

// Whole numbers of 32 bit in a vector: one in all lanes; sums that products of pairs are added to.
#if defined(__AVX512BW__)
#define RB_INTS
typedef __m512i Ints;
static inline Ints everywhere(int32_t x) { return _mm512_set1_epi32(x); }
static inline Ints with_pairs(Ints sum, Ints a, Ints b) { return _mm512_add_epi32(sum, _mm512_madd_epi16(a, b)); }
#elif defined(__AVX2__)
#define RB_INTS
typedef __m256i Ints;
static inline Ints everywhere(int32_t x) { return _mm256_set1_epi32(x); }
static inline Ints with_pairs(Ints sum, Ints a, Ints b) { return _mm256_add_epi32(sum, _mm256_madd_epi16(a, b)); }
#elif defined(__SSE2__)
#define RB_INTS
typedef __m128i Ints;
static inline Ints everywhere(int32_t x) { return _mm_set1_epi32(x); }
static inline Ints with_pairs(Ints sum, Ints a, Ints b) { return _mm_add_epi32(sum, _mm_madd_epi16(a, b)); }
#endif

// sums (kRows, kWide) of products of kRows rows (length k) and a panel of pairs.
static inline void pair_products(const int16_t* a, int k, const int16_t* panel, int32_t* sums) {
#if defined(RB_INTS)
  Ints acc[kRows][2] = {};
  for (int i = 0; i < k; i += kPair, panel += kPair * kWide) {
    Ints b0, b1;
    std::memcpy(&b0, panel, sizeof b0);
    std::memcpy(&b1, panel + kPair * kLanes, sizeof b1);
    for (int r = 0; r < kRows; ++r) {
      int32_t two;
      std::memcpy(&two, a + r * k + i, sizeof two);
      const Ints f = everywhere(two);
      acc[r][0] = with_pairs(acc[r][0], f, b0);
      acc[r][1] = with_pairs(acc[r][1], f, b1);
    }
  }
  std::memcpy(sums, acc, sizeof acc);
#else
  std::fill_n(sums, kRows * kWide, 0);
  for (int i = 0; i < k; i += kPair, panel += kPair * kWide)
    for (int r = 0; r < kRows; ++r)
      for (int x = 0; x < kWide; ++x)
        sums[r * kWide + x] += int32_t(a[r * k + i]) * panel[kPair * x] + int32_t(a[r * k + i + 1]) * panel[kPair * x + 1];
#endif
}

#if defined(__AVX512BW__)
#define RB_FOURS
// The same of bytes, four at a time; those of the panel are 128 less, for the instruction wants them signed.  Written
// out once more, since a function for other processors than its caller is not inlined.
__attribute__((target("avx512vnni"))) static void four_products(const uint8_t* a, int k, const int8_t* panel, int32_t* sums) {
  __m512i acc[kRows][2] = {};
  for (int i = 0; i < k; i += kFour, panel += kFour * kWide) {
    const __m512i b0 = _mm512_loadu_si512(panel), b1 = _mm512_loadu_si512(panel + kFour * kLanes);
    for (int r = 0; r < kRows; ++r) {
      int32_t four;
      std::memcpy(&four, a + r * k + i, sizeof four);
      const __m512i f = _mm512_set1_epi32(four);
      acc[r][0] = _mm512_dpbusd_epi32(acc[r][0], f, b0);
      acc[r][1] = _mm512_dpbusd_epi32(acc[r][1], f, b1);
    }
  }
  std::memcpy(sums, acc, sizeof acc);
}
#endif

// 1 / length of each row of a (n, k), and the sum of its elements.
static void lengths(const uint8_t* a, int n, int k, float* inverse, int32_t* sum) {
  for (int i = 0; i < n; ++i) {
    int32_t square = 0, all = 0;
    for (int j = 0; j < k; ++j) {
      square += int32_t(a[size_t(i) * k + j]) * a[size_t(i) * k + j];
      all += a[size_t(i) * k + j];
    }
    inverse[i] = square ? float(1 / std::sqrt(double(square))) : 0.0f;
    sum[i] = all;
  }
}

static void best_bytes(const uint8_t* a, int n, const uint8_t* b, int m, int k, int32_t* first, float* value, float* second,
                       int32_t* reverse) {
  const int panels = (m + kWide - 1) / kWide, blocks = (n + kRows - 1) / kRows;
  std::vector<float> length_a(blocks * kRows, 0.0f), length_b(panels * kWide, 0.0f);
  std::vector<int32_t> sum_a(blocks * kRows, 0), sum_b(panels * kWide, 0);
  lengths(a, n, k, length_a.data(), sum_a.data());
  lengths(b, m, k, length_b.data(), sum_b.data());
  alignas(64) int32_t whole[kRows * kWide];
  const auto scaled = [&](int block, int p, int more, float* sums) {
    for (int r = 0; r < kRows; ++r) {
      const int32_t back = more * sum_a[block * kRows + r];
      const float l = length_a[block * kRows + r];
      for (int x = 0; x < kWide; ++x) sums[r * kWide + x] = float(whole[r * kWide + x] + back) * l * length_b[p * kWide + x];
    }
  };
  const auto packed = [&](auto* panel, int group, int less) {
    for (int j = 0; j < m; ++j)
      for (int i = 0; i < k; ++i)
        panel[((size_t(j / kWide) * (k / group) + i / group) * kWide + j % kWide) * group + i % group] =
            static_cast<std::remove_reference_t<decltype(*panel)>>(b[size_t(j) * k + i] - less);
  };
#if defined(RB_FOURS)
  static const bool fours = __builtin_cpu_supports("avx512vnni");
  if (fours) {
    std::vector<uint8_t> rows(size_t(blocks) * kRows * k, 0);
    std::vector<int8_t> panel(size_t(panels) * k * kWide, 0);
    std::copy_n(a, size_t(n) * k, rows.data());
    packed(panel.data(), kFour, 128);
    const auto of = [&](int block, int p, float* sums) {
      four_products(rows.data() + size_t(block) * kRows * k, k, panel.data() + size_t(p) * k * kWide, whole);
      scaled(block, p, 128, sums);
    };
    search(n, m, of, first, value, second, reverse);
    return;
  }
#endif
  std::vector<int16_t> rows(size_t(blocks) * kRows * k, 0), panel(size_t(panels) * k * kWide, 0);
  std::copy_n(a, size_t(n) * k, rows.data());
  packed(panel.data(), kPair, 0);
  const auto of = [&](int block, int p, float* sums) {
    pair_products(rows.data() + size_t(block) * kRows * k, k, panel.data() + size_t(p) * k * kWide, whole);
    scaled(block, p, 0, sums);
  };
  search(n, m, of, first, value, second, reverse);
}
