#include "output_file.hpp"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <cstddef>
#include <system_error>

namespace cleave::app {
namespace {

constexpr std::size_t kBufferSize = std::size_t{1} << 18;

std::filesystem::path folder_of(const std::filesystem::path& file) {
  return file.has_parent_path() ? file.parent_path() : std::filesystem::path(".");
}

/// A name nobody else uses: hidden, short enough for every file system, told apart by process and
/// count.
std::filesystem::path temporary_name(const std::filesystem::path& target) {
  static std::atomic<unsigned> count{0};
  return folder_of(target) /
         (".cleave-" + std::to_string(getpid()) + "-" + std::to_string(count++) + ".tmp");
}

/// Makes a rename survive a power cut. Some file systems cannot, which is no error of ours.
void sync_folder(const std::filesystem::path& folder) {
  const int descriptor = open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  if (descriptor < 0) return;
  fsync(descriptor);
  close(descriptor);
}

}  // namespace

OutputFile::OutputFile(const std::filesystem::path& target) : shown_(target), target_(target) {
  if (target.empty()) throw OutputError("cannot write: the name of the output file is empty");
  std::error_code error;
  if (std::filesystem::is_symlink(target, error)) {
    target_ = std::filesystem::weakly_canonical(target, error);
    if (error) fail(error.value());
  }
  struct stat status {};
  const bool exists = stat(target_.c_str(), &status) == 0;
  if (exists && S_ISDIR(status.st_mode)) fail(EISDIR);
  if (exists && access(target_.c_str(), W_OK) != 0) fail(errno);
  if (exists && !S_ISREG(status.st_mode)) {
    open_in_place();
  } else {
    open_temporary();
    if (exists && fchmod(descriptor_, status.st_mode & 07777) != 0) fail(errno);
  }
  buffer_.reserve(kBufferSize);
}

OutputFile::~OutputFile() { discard(); }

void OutputFile::open_in_place() {
  descriptor_ = open(target_.c_str(), O_WRONLY | O_CLOEXEC);
  if (descriptor_ < 0) fail(errno);
}

void OutputFile::open_temporary() {
  while (descriptor_ < 0) {
    const auto name = temporary_name(target_);
    watch_ = std::make_unique<WatchedTemporary>(name.string());
    descriptor_ = open(name.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
    if (descriptor_ >= 0) {
      temporary_ = name;
    } else if (errno != EEXIST) {
      const int error_number = errno;
      if (error_number == ENOENT)
        throw OutputError("cannot write '" + shown_.string() + "': the folder '" +
                          folder_of(target_).string() + "' does not exist; make it first");
      fail(error_number);
    }
  }
}

void OutputFile::write(std::string_view bytes) {
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
    const ssize_t count = ::write(descriptor_, bytes.data(), bytes.size());
    if (count < 0 && errno == EINTR) continue;
    if (count < 0) fail(errno);
    bytes.remove_prefix(static_cast<std::size_t>(count));
  }
}

void OutputFile::commit() {
  write_out(buffer_);
  buffer_.clear();
  if (temporary_.empty()) {
    close_descriptor();
    return;
  }
  if (fsync(descriptor_) != 0) fail(errno);
  close_descriptor();
  if (rename(temporary_.c_str(), target_.c_str()) != 0) fail(errno);
  temporary_.clear();
  watch_.reset();
  sync_folder(folder_of(target_));
}

void OutputFile::close_descriptor() {
  const int descriptor = descriptor_;
  descriptor_ = -1;
  if (close(descriptor) != 0) fail(errno);
}

void OutputFile::discard() {
  if (descriptor_ >= 0) close(descriptor_);
  descriptor_ = -1;
  if (!temporary_.empty()) unlink(temporary_.c_str());
  temporary_.clear();
  watch_.reset();
}

void OutputFile::fail(int error_number) {
  discard();
  std::string what =
      "cannot write '" + shown_.string() + "': " + std::generic_category().message(error_number);
  if (error_number == ENOSPC || error_number == EDQUOT)
    what += "; free some space or write elsewhere, no partial file is left";
  if (error_number == EISDIR) what += "; give the name of a file in it";
  throw OutputError(what);
}

void write_file(const std::filesystem::path& target, std::string_view bytes) {
  OutputFile file(target);
  file.write(bytes);
  file.commit();
}

}  // namespace cleave::app
