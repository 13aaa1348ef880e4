#include "tables.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdlib>
#include <cstring>
#include <limits>

namespace raybundle {

namespace {

constexpr size_t kBlock = 1 << 16;

// A number as Python's float() reads it, of plain signs only; false: it is none, or too large or small for a double.
bool number(std::string_view cell, double& value) {
  if (cell.empty()) {
    value = std::numeric_limits<double>::quiet_NaN();
    return true;
  }
  const char *at = cell.data(), *end = at + cell.size();
  for (const char* c = at; c != end; ++c)
    if (!((*c >= '0' && *c <= '9') || *c == '.' || *c == '-' || *c == '+' || *c == 'e' || *c == 'E')) return false;
  if (*at == '+') {
    ++at;
    if (at == end || *at == '-' || *at == '+') return false;
  }
#ifdef __cpp_lib_to_chars
  const auto found = std::from_chars(at, end, value);
  return found.ec == std::errc() && found.ptr == end;
#else  // standard libraries without it for doubles
  char text[64];
  if (size_t(end - at) >= sizeof text) return false;
  std::memcpy(text, at, end - at);
  text[end - at] = 0;
  char* stop;
  value = std::strtod(text, &stop);
  return stop == text + (end - at) && std::isfinite(value);
#endif
}

}  // namespace

void TextColumn::add(std::string_view cell) {
  if (!codes.empty() && texts[codes.back()] == cell) {
    codes.push_back(codes.back());
    return;
  }
  const auto found = known.find(cell);
  if (found != known.end()) {
    codes.push_back(found->second);
    return;
  }
  if (kept.empty() || kept.back().size() + cell.size() > kept.back().capacity()) {
    kept.emplace_back();
    kept.back().reserve(std::max(kBlock, cell.size()));
  }
  std::string& block = kept.back();
  const size_t begin = block.size();
  block.append(cell);
  const std::string_view mine(block.data() + begin, cell.size());
  const int32_t code = int32_t(texts.size());
  texts.push_back(mine);
  known.emplace(mine, code);
  codes.push_back(code);
}

bool Columns::add(std::string_view rows) {
  const size_t width = is_number_.size();
  const char *at = rows.data(), *end = at + rows.size();
  if (std::memchr(at, '"', rows.size()) != nullptr) return false;
  while (true) {
    const char* line_end = static_cast<const char*>(std::memchr(at, '\n', end - at));
    const bool last = line_end == nullptr;
    if (last) line_end = end;
    const char* stop = line_end;
    if (stop != at && stop[-1] == '\r' && !last) --stop;
    if (std::memchr(at, '\r', stop - at) != nullptr) return false;
    for (size_t k = 0; k < width; ++k) {
      const char* cell_end = static_cast<const char*>(std::memchr(at, ',', stop - at));
      if ((cell_end == nullptr) != (k + 1 == width)) return false;
      if (cell_end == nullptr) cell_end = stop;
      const std::string_view cell(at, cell_end - at);
      if (is_number_[k]) {
        double value;
        if (!number(cell, value)) return false;
        numbers_[k].push_back(value);
      } else {
        texts_[k].add(cell);
      }
      at = cell_end + 1;
    }
    ++rows_;
    if (last) return rows_ <= std::numeric_limits<int32_t>::max();
    at = line_end + 1;
  }
}

}  // namespace raybundle
