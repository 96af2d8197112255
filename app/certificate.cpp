#include "certificate.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <system_error>
#include <utility>

namespace cleave::app {
namespace {

constexpr std::size_t kBlock = std::size_t{1} << 16;

// Goes over the words of a text: what is between blanks and ends of lines, outside of comments.
class Words {
 public:
  explicit Words(const InputText& text) : text_(text), at_(text.begin()) {}

  // The next word; empty at the end.
  std::string_view next() {
    while (at_ != text_.end() && (is_blank(*at_) || is_comment()))
      at_ = is_comment() ? std::find(at_, text_.end(), '\n') : at_ + 1;
    const char* from = at_;
    at_ = std::find_if(from, text_.end(), is_blank);
    return word_ = {from, static_cast<std::size_t>(at_ - from)};
  }

  void expect(std::string_view word) {
    if (next() != word) fail("here should be '" + std::string(word) + "'");
  }

  std::uint32_t number(const char* what) {
    next();
    return to_number(what);
  }

  // The word that next() gave last, as a number.
  std::uint32_t to_number(const char* what) const {
    std::uint32_t number = 0;
    const char* end = word_.data() + word_.size();
    const auto [rest, error] = std::from_chars(word_.data(), end, number);
    if (error == std::errc::result_out_of_range && rest == end) fail("numbers go up to 4294967295");
    if (error != std::errc{} || rest != end) fail("here should be " + std::string(what));
    return number;
  }

  // Requires `count` rows and appends them.
  void rows(std::size_t count, std::size_t width, const char* what,
            std::vector<std::uint32_t>& to) {
    to.reserve(std::min(count, text_.bytes().size() / 2 / width) * width);  // a count may lie
    for (std::size_t i = 0; i < count * width; ++i) to.push_back(number(what));
  }

  // About the word that next() gave last.
  [[noreturn]] void fail(const std::string& message) const {
    text_.fail(word_.data(), message + (word_.empty() ? ", and the file ends"
                                                      : ", not '" + printable(word_, 40) + "'"));
  }

 private:
  static bool is_blank(char c) { return c == ' ' || c == '\n' || c == '\t' || c == '\r'; }
  bool is_comment() const { return *at_ == '#' && (at_ == text_.begin() || at_[-1] == '\n'); }

  const InputText& text_;
  const char* at_;
  std::string_view word_;
};

constexpr std::size_t kWordsBeforeCells = 7;  // cleave-certificate 1 dimension D cells N before

Certificate read(const InputText& text) {
  Words words(text);
  if (words.next() != "cleave-certificate")
    text.fail(text.begin(), "this is no certificate, which begins with 'cleave-certificate 1'");
  if (words.number("the version of the format, 1") != 1) words.fail("the version should be 1");
  Certificate certificate;
  words.expect("dimension");
  const std::uint32_t dimension = words.number("the dimension");
  if (dimension < 1 || dimension > 4) words.fail("the dimension should be 1 to 4");
  certificate.dimension = static_cast<int>(dimension);

  words.expect("cells");
  const std::uint32_t cells = words.number("the number of cells");
  words.expect("before");
  words.rows(cells, certificate.corners(), "a vertex of a cell", certificate.before);
  words.expect("cut");
  const std::uint32_t facets = words.number("the number of facets");
  words.rows(facets, certificate.facet_size(), "a vertex of a facet", certificate.cut);
  words.expect("after");
  certificate.after.reserve(certificate.before.size());
  while (words.next() != "end") certificate.after.push_back(words.to_number("a vertex or 'end'"));
  if (certificate.after.size() % certificate.corners() != 0)
    words.fail("here should be a further vertex: a cell has " +
               std::to_string(certificate.corners()));
  if (!words.next().empty()) words.fail("after 'end' there should be nothing");
  return certificate;
}

// Lines of numbers, handed on in blocks.
class Lines {
 public:
  explicit Lines(const std::function<void(std::string_view)>& put) : put_(put) {}

  void line(std::string_view text) { (block_ += text) += '\n'; }

  void rows(const std::vector<std::uint32_t>& numbers, std::size_t width) {
    for (std::size_t i = 0; i < numbers.size(); ++i) {
      std::array<char, 16> digits;
      char* end = std::to_chars(digits.begin(), digits.end(), numbers[i]).ptr;
      block_.append(digits.begin(), end);
      block_ += (i + 1) % width == 0 ? '\n' : ' ';
      if (block_.size() >= kBlock) flush();
    }
  }

  void flush() {
    put_(block_);
    block_.clear();
  }

 private:
  const std::function<void(std::string_view)>& put_;
  std::string block_;
};

}  // namespace

void write_certificate(const Certificate& certificate,
                       const std::function<void(std::string_view)>& put) {
  Lines out(put);
  out.line("cleave-certificate 1");
  out.line("dimension " + std::to_string(certificate.dimension));
  out.line("cells " + std::to_string(certificate.cell_count()));
  out.line("before");
  out.rows(certificate.before, certificate.corners());
  out.line("cut " + std::to_string(certificate.facet_count()));
  out.rows(certificate.cut, certificate.facet_size());
  out.line("after");
  out.rows(certificate.after, certificate.corners());
  out.line("end");
  out.flush();
}

CertificateFile::CertificateFile(InputText text)
    : text_(std::move(text)), certificate_(read(text_)) {}

void CertificateFile::fail_at_cell(std::size_t cell, const std::string& message) const {
  fail_at_word(kWordsBeforeCells + cell * certificate_.corners(), message);
}

void CertificateFile::fail_at_facet(std::size_t facet, const std::string& message) const {
  const std::size_t words_before = kWordsBeforeCells + certificate_.before.size() + 2;
  fail_at_word(words_before + facet * certificate_.facet_size(), message);
}

void CertificateFile::fail_at_word(std::size_t word, const std::string& message) const {
  Words words(text_);
  for (std::size_t i = 0; i < word; ++i) words.next();
  text_.fail(words.next().data(), message);
}

}  // namespace cleave::app
