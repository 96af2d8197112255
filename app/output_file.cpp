#include "output_file.hpp"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstddef>
#include <system_error>

namespace cleave::app {
namespace {

constexpr std::size_t kBufferSize = std::size_t{1} << 18;

/// Calls again what a signal has interrupted.
template <class Call>
auto uninterrupted(const Call& call) {
  auto result = call();
  while (result < 0 && errno == EINTR) result = call();
  return result;
}

/// Where an open file can be found as long as it has no name.
std::string link_to(int descriptor) { return "/proc/self/fd/" + std::to_string(descriptor); }

}  // namespace

OutputFile::OutputFile(const std::filesystem::path& target) : shown_(target) {
  if (target.empty()) throw OutputError("cannot write: the name of the output file is empty");
  std::error_code error;
  target_ = behind_links(target);
  if (std::filesystem::is_symlink(target_, error)) fail(ELOOP);
  struct stat status {};
  const bool exists = stat(target.c_str(), &status) == 0;
  if (exists && S_ISDIR(status.st_mode)) fail(EISDIR);
  if (exists && access(target.c_str(), W_OK) != 0) fail(errno);
  if (exists && !S_ISREG(status.st_mode)) {
    open_in_place();
  } else {
    open_temporary();
    if (exists && fchmod(descriptor_, status.st_mode & 07777) != 0) fail(errno);
  }
  buffer_.reserve(kBufferSize);
}

OutputFile::~OutputFile() { discard(); }

/// By the name as it was given: where /dev/stdout is a pipe, the link ends in no name of a file.
void OutputFile::open_in_place() {
  in_place_ = true;
  descriptor_ = uninterrupted([&] { return open(shown_.c_str(), O_WRONLY | O_CLOEXEC); });
  if (descriptor_ < 0) fail(errno);
}

/// A file without a name goes with the process that has it open, however that ends.
bool OutputFile::open_unnamed() {
  descriptor_ = uninterrupted(
      [&] { return open(folder_of(target_).c_str(), O_WRONLY | O_TMPFILE | O_CLOEXEC, 0666); });
  if (descriptor_ >= 0 && access(link_to(descriptor_).c_str(), F_OK) != 0) {
    close(descriptor_);  // no /proc here, so it could never get a name
    descriptor_ = -1;
  }
  return descriptor_ >= 0;
}

void OutputFile::open_temporary() {
  if (open_unnamed()) return;
  while (descriptor_ < 0) {
    const auto name = temporary_name(target_);
    watch_ = std::make_unique<WatchedTemporary>(name.string());
    descriptor_ = uninterrupted(
        [&] { return open(name.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666); });
    if (descriptor_ >= 0) {
      temporary_ = name;
    } else if (errno != EEXIST) {
      const int error_number = errno;
      std::error_code error;
      if (error_number == ENOENT && !std::filesystem::exists(folder_of(target_), error))
        throw OutputError("cannot write '" + shown_.string() + "': the folder '" +
                          folder_of(target_).string() + "' does not exist; make it first");
      fail(error_number);
    }
  }
}

void OutputFile::write(std::string_view bytes) {
  if (digest_ != nullptr) digest_->add(bytes);
  if (buffer_.size() + bytes.size() > kBufferSize) {
    write_out(buffer_);
    buffer_.clear();
  }
  if (bytes.size() >= kBufferSize)
    write_out(bytes);
  else
    buffer_.append(bytes);
}

void OutputFile::write_out(std::string_view bytes) {
  while (!bytes.empty()) {
    const ssize_t count =
        uninterrupted([&] { return ::write(descriptor_, bytes.data(), bytes.size()); });
    if (count < 0) fail(errno);
    if (count == 0) fail(EIO);
    bytes.remove_prefix(static_cast<std::size_t>(count));
  }
}

void OutputFile::commit() {
  const auto replacement = finish();
  if (replacement) replace_together({&*replacement, 1});
  forget_temporary();
}

/// Brings everything to the disk and gives the file its temporary name; what is left to do is what
/// is returned. Nothing for a file that is written in place.
std::optional<Replacement> OutputFile::finish() {
  write_out(buffer_);
  buffer_.clear();
  if (in_place_) {
    close_descriptor();
    return std::nullopt;
  }
  if (uninterrupted([&] { return fsync(descriptor_); }) != 0) fail(errno);
  if (temporary_.empty()) give_name();
  close_descriptor();
  return Replacement{temporary_, target_, shown_};
}

void OutputFile::give_name() {
  while (temporary_.empty()) {
    const auto name = temporary_name(target_);
    watch_ = std::make_unique<WatchedTemporary>(name.string());
    if (linkat(AT_FDCWD, link_to(descriptor_).c_str(), AT_FDCWD, name.c_str(), AT_SYMLINK_FOLLOW) ==
        0)
      temporary_ = name;
    else if (errno != EEXIST)
      fail(errno);
  }
}

void OutputFile::close_descriptor() {
  const int descriptor = descriptor_;
  descriptor_ = -1;
  if (close(descriptor) != 0 && errno != EINTR) fail(errno);  // it is closed after EINTR, too
}

void OutputFile::discard() {
  if (descriptor_ >= 0) close(descriptor_);
  descriptor_ = -1;
  if (!temporary_.empty()) unlink(temporary_.c_str());
  forget_temporary();
}

/// For a file that has its own name, or none.
void OutputFile::forget_temporary() {
  temporary_.clear();
  watch_.reset();
}

void OutputFile::fail(int error_number) {
  discard();
  cannot_write(shown_, error_number);
}

void write_file(const std::filesystem::path& target, std::string_view bytes) {
  OutputFile file(target);
  file.write(bytes);
  file.commit();
}

}  // namespace cleave::app
