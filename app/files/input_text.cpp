#include "files/input_text.hpp"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <system_error>

#include "error.hpp"
#include "files/gzip.hpp"

namespace cleave::app {
namespace {

[[noreturn]] void cannot_read(const std::filesystem::path& path, int error_number) {
  std::string what =
      "cannot read '" + path.string() + "': " + std::generic_category().message(error_number);
  if (error_number == EISDIR) what += "; give the name of a file in it";
  if (error_number == ENOENT) what += "; check the name and the current folder";
  throw InputError(what);
}

/// An open file that closes itself.
struct Descriptor {
  explicit Descriptor(const std::filesystem::path& path)
      : value(open(path.c_str(), O_RDONLY | O_CLOEXEC)) {
    if (value < 0) cannot_read(path, errno);
    struct stat status {};
    if (fstat(value, &status) != 0) cannot_read(path, errno);
    if (S_ISDIR(status.st_mode)) cannot_read(path, EISDIR);
    if (S_ISREG(status.st_mode)) size = static_cast<std::size_t>(status.st_size);
    regular = S_ISREG(status.st_mode);
  }
  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;
  ~Descriptor() { close(value); }
  int value;
  std::size_t size = 0;
  bool regular = false;
};

/// Reads up to `capacity` bytes and returns how many there were.
std::size_t read_up_to(const Descriptor& file, const std::filesystem::path& path, char* bytes,
                       std::size_t capacity) {
  std::size_t size = 0;
  while (size < capacity) {
    const ssize_t count = read(file.value, bytes + size, capacity - size);
    if (count < 0 && errno == EINTR) continue;
    if (count < 0) cannot_read(path, errno);
    if (count == 0) break;
    size += static_cast<std::size_t>(count);
  }
  return size;
}

[[noreturn]] void fail_empty(const std::filesystem::path& path) {
  throw InputError("cannot read '" + path.string() + "': the file is empty");
}

}  // namespace

InputText::InputText(const std::filesystem::path& path) : source_(path.string()) {
  const Descriptor file(path);
  std::size_t capacity = file.regular ? file.size : std::size_t{1} << 16;
  bytes_.reset(new char[capacity]);
  size_ = read_up_to(file, path, bytes_.get(), capacity);
  while (!file.regular && size_ == capacity) {  // a pipe: its size is known at its end only
    capacity *= 2;
    std::unique_ptr<char[]> larger(new char[capacity]);
    std::memcpy(larger.get(), bytes_.get(), size_);
    bytes_ = std::move(larger);
    size_ += read_up_to(file, path, bytes_.get() + size_, capacity - size_);
  }
  if (size_ == 0) fail_empty(path);
  if (!is_gzip_name(path)) return;
  OwnedBytes unpacked = unpack_gzip(source_, bytes(), most_unpacked());
  if (unpacked.size == 0) fail_empty(path);
  bytes_ = std::move(unpacked.bytes);
  size_ = unpacked.size;
}

InputText::InputText(std::string source, std::string_view bytes)
    : source_(std::move(source)), bytes_(new char[bytes.size()]), size_(bytes.size()) {
  std::memcpy(bytes_.get(), bytes.data(), bytes.size());
}

std::string InputText::where(const char* place) const {
  place = std::min(place, end());
  const auto before = static_cast<std::size_t>(place - begin());
  if (before > 0 && std::memchr(begin(), 0, before) != nullptr)
    return source_ + ": byte " + std::to_string(before);
  return source_ + ":" + std::to_string(1 + std::count(begin(), place, '\n'));
}

void InputText::fail(const char* place, const std::string& message) const {
  throw InputError(where(place) + ": " + message);
}

void InputText::fail_format(const std::string& expected) const {
  const std::string_view found = describe_content(bytes());
  std::string message = "this is not " + expected;
  if (!found.empty()) message += "; it looks like " + std::string(found);
  fail(begin(), message + ". The extension must name the format of the content");
}

InputText input_at(const std::filesystem::path& path) {
  if (path != "-") return InputText(path);
  std::string bytes;
  std::array<char, 1 << 16> block;
  for (std::size_t count = 0; (count = std::fread(block.data(), 1, block.size(), stdin)) > 0;)
    bytes.append(block.data(), count);
  if (std::ferror(stdin) != 0 || bytes.empty())
    throw InputError("standard input: there is nothing to be read from it");
  return {"standard input", bytes};
}

bool is_gzip_name(const std::filesystem::path& path) {
  const std::string extension = path.extension().string();
  return extension == ".gz" || extension == ".GZ";
}

std::size_t require_readable_file(const std::filesystem::path& path) {
  const Descriptor file(path);
  if (!file.regular)
    throw InputError("cannot read '" + path.string() +
                     "': it is not a regular file, which this format needs");
  if (file.size == 0) fail_empty(path);
  return file.size;
}

std::string printable(std::string_view text, std::size_t longest) {
  std::string shown;
  for (const char c : text.substr(0, longest)) {
    const bool is_printable = static_cast<unsigned char>(c) >= 0x20 && c != 0x7f;
    shown += is_printable ? c : '?';
  }
  return text.size() > longest ? shown + "..." : shown;
}

std::string_view describe_content(std::string_view bytes) {
  const auto starts = [&](std::string_view with) { return bytes.substr(0, with.size()) == with; };
  if (starts("\x1f\x8b")) return "a gzip archive (unpack it, or add .gz to its name)";
  if (starts("# vtk DataFile")) return "a legacy VTK file (.vtk)";
  const std::string_view head = bytes.substr(0, 4096);
  if (head.find('\0') != std::string_view::npos) return "binary data";
  const auto text = head.find_first_not_of(" \t\r\n");
  if (text == std::string_view::npos) return "blank lines";
  bytes.remove_prefix(text);
  if (starts("<")) return "an XML file (.vtu?)";
  // A bracket before a word starts a section of a configuration, say.
  const auto inner = bytes.substr(0, 4096).find_first_not_of(" \t\r\n", 1);
  const bool is_list =
      starts("[") && inner != std::string_view::npos &&
      std::string_view("[{]\"-0123456789").find(bytes[inner]) != std::string_view::npos;
  if (starts("{") || is_list) return "a JSON file";
  if (starts("$MeshFormat")) return "a gmsh file (.msh)";
  if (starts("MeshVersion")) return "a Medit file (.mesh)";
  return {};
}

}  // namespace cleave::app
