// CSV without quotes, by columns: numbers as doubles, texts as numbers of the different ones.
#pragma once
#include <cstdint>
#include <deque>
#include <stdexcept>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

namespace raybundle {

struct TextColumn {
  std::vector<int32_t> codes;            // for each row which text it is
  std::vector<std::string_view> texts;   // in the order in which they come first
  std::unordered_map<std::string_view, int32_t> known;
  std::deque<std::string> kept;          // the texts themselves, in blocks that stay where they are
  void add(std::string_view cell);
};

class Columns {
 public:
  explicit Columns(const std::vector<bool>& is_number) : is_number_(is_number), numbers_(is_number.size()), texts_(is_number.size()) {}

  // Rows, divided by line ends, without one behind the last.  False where a row has another number of cells, a cell is
  // quoted or not the plain number that its column needs: the table is then to be read in another way, and this one is lost.
  bool add(std::string_view rows);

  int64_t rows() const { return rows_; }
  // Throw std::invalid_argument where there is no such column of numbers, or of texts.
  const std::vector<double>& number_column(size_t column) const { return numbers_[checked(column, true)]; }
  const TextColumn& text_column(size_t column) const { return texts_[checked(column, false)]; }

 private:
  size_t checked(size_t column, bool number) const {
    if (column >= is_number_.size() || is_number_[column] != number) throw std::invalid_argument("there is no such column");
    return column;
  }
  std::vector<bool> is_number_;
  std::vector<std::vector<double>> numbers_;
  std::vector<TextColumn> texts_;
  int64_t rows_ = 0;
};

}  // namespace raybundle
