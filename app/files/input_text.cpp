#include "files/input_text.hpp"

#include <fcntl.h>
#include <sys/mman.h>
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
#include "temporaries.hpp"

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

void ReleaseBytes::operator()(char* bytes) const {
  if (mapped > 0)
    munmap(bytes, mapped);
  else
    delete[] bytes;
}

/// Leaves everything as it is if the file cannot be mapped.
void InputText::map(int descriptor, std::size_t size) {
  void* const at = mmap(nullptr, size, PROT_READ, MAP_PRIVATE, descriptor, 0);
  if (at == MAP_FAILED) return;
  madvise(at, size, MADV_SEQUENTIAL);
  watch_mapped_input();
  bytes_ = {static_cast<char*>(at), ReleaseBytes{size}};
  size_ = size;
}

const char* InputText::passed(const char* place) const {
  constexpr std::ptrdiff_t kStep = 1 << 22;
  if (how_far_ && size_ > 0)
    how_far_(static_cast<double>(place - begin()) / static_cast<double>(size_));
  const std::ptrdiff_t before = place - begin();
  if (bytes_.get_deleter().mapped > 0 && before >= kStep) {  // it can be read again
    const std::ptrdiff_t page = sysconf(_SC_PAGESIZE);
    const std::ptrdiff_t end = before / page * page,
                         first = std::max<std::ptrdiff_t>(0, end - 2 * kStep);
    madvise(bytes_.get() + first, static_cast<std::size_t>(end - first), MADV_DONTNEED);
  }
  return end() - place > kStep ? place + kStep : end();
}

InputText::InputText(const std::filesystem::path& path, HowFar how_far)
    : source_(path.string()), how_far_(std::move(how_far)) {
  const Descriptor file(path);
  if (file.regular && file.size > 0) map(file.value, file.size);
  std::size_t capacity = file.regular ? file.size : std::size_t{1} << 16;
  if (!bytes_) {
    bytes_.reset(new char[capacity]);
    size_ = read_up_to(file, path, bytes_.get(), capacity);
  }
  while (!file.regular && size_ == capacity) {  // a pipe: its size is known at its end only
    capacity *= 2;
    std::unique_ptr<char[], ReleaseBytes> larger(new char[capacity]);
    std::memcpy(larger.get(), bytes_.get(), size_);
    bytes_ = std::move(larger);
    size_ += read_up_to(file, path, bytes_.get() + size_, capacity - size_);
  }
  if (size_ == 0) fail_empty(path);
  if (!is_gzip_name(path)) return;
  OwnedBytes unpacked = unpack_gzip(source_, bytes(), most_unpacked());
  if (unpacked.size == 0) fail_empty(path);
  bytes_ = {unpacked.bytes.release(), ReleaseBytes{}};
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
