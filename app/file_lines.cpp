#include "file_lines.hpp"

#include <array>
#include <charconv>
#include <filesystem>
#include <string_view>

#include "error.hpp"
#include "files/input_text.hpp"

namespace cleave::app {
namespace {

std::uint64_t to_number(std::string_view word) {
  std::uint64_t number = 0;
  std::from_chars(word.data(), word.data() + word.size(), number);
  return number;
}

// Goes over the words of a text and knows the line of each.
class Words {
 public:
  Words(std::string_view text, bool comments) : text_(text), comments_(comments) {}

  // The next word; empty at the end.
  std::string_view next() {
    while (at_ < text_.size() && (is_blank() || is_comment())) {
      if (is_comment())
        skip_line();
      else
        step();
    }
    word_line_ = line_;
    const std::size_t begin = at_;
    while (at_ < text_.size() && !is_blank()) ++at_;
    return text_.substr(begin, at_ - begin);
  }

  void skip_line() {
    while (at_ < text_.size() && text_[at_] != '\n') ++at_;
  }

  std::size_t line() const { return word_line_; }  // of the last word

 private:
  bool is_blank() const { return static_cast<unsigned char>(text_[at_]) <= ' '; }
  bool is_comment() const { return comments_ && text_[at_] == '#'; }
  void step() {
    if (text_[at_] == '\n') ++line_;
    ++at_;
  }

  std::string_view text_;
  bool comments_;
  std::size_t at_ = 0, line_ = 1, word_line_ = 1;
};

class Search {
 public:
  Search(std::string_view text, const std::set<std::uint64_t>& cells,
         const std::set<std::uint64_t>& vertices)
      : words_(text, text.substr(0, 1) != "$"), cells_(cells), vertices_(vertices) {}

  // Elements of Medit are numbered by their place in their section.
  FileLines medit(int dimension) {
    constexpr std::array<std::string_view, 4> kSection = {"", "Edges", "Triangles", "Tetrahedra"};
    std::size_t coordinates = 3;
    for (std::string_view word = words_.next(); !word.empty(); word = words_.next()) {
      if (word == "Dimension") coordinates = to_number(words_.next());
      if (word == "Vertices") section(vertices_, found_.vertices, coordinates + 1);
      if (word == kSection[static_cast<std::size_t>(dimension)])
        section(cells_, found_.cells, static_cast<std::size_t>(dimension) + 2);
    }
    return found_;
  }

  // gmsh begins each row with the number.
  FileLines gmsh() {
    bool blocks = false;
    for (std::string_view word = words_.next(); !word.empty(); word = words_.next()) {
      if (word == "$MeshFormat") {
        blocks = words_.next().substr(0, 1) == "4";
        if (words_.next() != "0") return {};  // binary
      }
      if (word == "$Nodes") rows(blocks, true, vertices_, found_.vertices);
      if (word == "$Elements") rows(blocks, false, cells_, found_.cells);
    }
    return found_;
  }

 private:
  using Numbers = std::set<std::uint64_t>;
  using Lines = std::map<std::uint64_t, std::size_t>;

  void section(const Numbers& wanted, Lines& lines, std::size_t words_per_row) {
    const std::uint64_t count = to_number(words_.next());
    for (std::uint64_t i = 1; i <= count; ++i)
      for (std::size_t w = 0; w < words_per_row; ++w) {
        if (words_.next().empty()) return;
        if (w == 0 && wanted.count(i) > 0) lines[i] = words_.line();
      }
  }

  void rows(bool blocks, bool nodes, const Numbers& wanted, Lines& lines) {
    std::uint64_t left = to_number(words_.next());  // rows, or blocks of rows
    words_.skip_line();
    if (!blocks) return row_numbers(left, wanted, lines);
    for (; left > 0; --left) {
      for (int i = 0; i < 3; ++i) words_.next();
      const std::uint64_t count = to_number(words_.next());
      row_numbers(count, wanted, lines);
      for (std::uint64_t i = 0; nodes && i < count; ++i) {  // the coordinates
        if (words_.next().empty()) return;
        words_.skip_line();
      }
    }
  }

  void row_numbers(std::uint64_t count, const Numbers& wanted, Lines& lines) {
    for (std::uint64_t i = 0; i < count; ++i) {
      const std::string_view word = words_.next();
      if (word.empty()) return;
      const std::uint64_t number = to_number(word);
      if (wanted.count(number) > 0) lines[number] = words_.line();
      words_.skip_line();
    }
  }

  Words words_;
  const Numbers &cells_, &vertices_;
  FileLines found_;
};

}  // namespace

FileLines find_lines(const std::string& path, int dimension, const std::set<std::uint64_t>& cells,
                     const std::set<std::uint64_t>& vertices) {
  if (cells.empty() && vertices.empty()) return {};
  std::string extension = std::filesystem::path(path).extension().string();
  for (char& c : extension)
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  if (extension != ".mesh" && extension != ".msh") return {};
  try {
    const InputText text(path);
    Search search(text.bytes(), cells, vertices);
    return extension == ".mesh" ? search.medit(dimension) : search.gmsh();
  } catch (const InputError&) {
    return {};  // gone since it was read
  }
}

}  // namespace cleave::app
