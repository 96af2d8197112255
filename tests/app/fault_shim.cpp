// Preloaded into the command (LD_PRELOAD): counts the calls that change files, and lets one of them
// fail, or the process die just before it. What a full disk or kill -9 does at random happens here
// at every possible place, one after the other.
//
//   CLEAVE_FAULT="N WHAT"     at the N-th call (from 1 on): `kill`, or an error number
//   CLEAVE_FAULT="N WHAT on"  and at every later call that needs space on the disk
//   CLEAVE_FAULT_NAMED=1      files without a name are refused, as some file systems do
//   CLEAVE_FAULT_LOG=FILE     receives the name of the call that was hit; nothing if none was
#include <dlfcn.h>
#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <cstdarg>
#include <cstdlib>
#include <cstring>

namespace {

struct Fault {
  long at = 0;
  int error_number = 0;  // 0: kill
  bool on = false, named = false;

  Fault() {
    const char* text = std::getenv("CLEAVE_FAULT");
    named = std::getenv("CLEAVE_FAULT_NAMED") != nullptr;
    if (text == nullptr) return;
    char* rest = nullptr;
    at = std::strtol(text, &rest, 10);
    error_number =
        std::strncmp(rest, " kill", 5) == 0 ? 0 : static_cast<int>(std::strtol(rest, &rest, 10));
    on = std::strstr(rest, " on") != nullptr;
  }
};

const Fault& fault() {
  static const Fault value;
  return value;
}

template <class Function>
Function next(const char* name) {
  void* symbol = dlsym(RTLD_NEXT, name);
  Function function = nullptr;
  static_assert(sizeof symbol == sizeof function);
  std::memcpy(&function, &symbol, sizeof function);
  return function;
}

void log_hit(const char* call) {
  const char* path = std::getenv("CLEAVE_FAULT_LOG");
  if (path == nullptr) return;
  const int log =
      next<int (*)(const char*, int, ...)>("open")(path, O_WRONLY | O_CREAT | O_TRUNC, 0666);
  static_cast<void>(
      next<ssize_t (*)(int, const void*, size_t)>("write")(log, call, std::strlen(call)));
  next<int (*)(int)>("close")(log);
}

/// Whether this call is to fail; errno is set then.
bool hit(const char* call, bool needs_space) {
  static long count = 0;
  ++count;
  if (fault().at == 0) return false;
  const bool first = count == fault().at;
  if (!first && !(fault().on && count > fault().at && needs_space)) return false;
  if (first) log_hit(call);
  if (fault().error_number == 0) raise(SIGKILL);
  errno = fault().error_number;
  return true;
}

bool writes(int flags) { return (flags & (O_WRONLY | O_RDWR)) != 0; }

int open_file(const char* name, const char* path, int flags, mode_t mode) {
  if ((flags & O_TMPFILE) == O_TMPFILE && fault().named) {
    errno = EOPNOTSUPP;
    return -1;
  }
  if (writes(flags) && hit("open", true)) return -1;
  return next<int (*)(const char*, int, ...)>(name)(path, flags, mode);
}

mode_t mode_of(int flags, std::va_list list) {
  return (flags & (O_CREAT | O_TMPFILE)) != 0 ? va_arg(list, mode_t) : 0;
}

}  // namespace

extern "C" {

int open(const char* path, int flags, ...) {
  std::va_list list;
  va_start(list, flags);
  const mode_t mode = mode_of(flags, list);
  va_end(list);
  return open_file("open", path, flags, mode);
}

int open64(const char* path, int flags, ...) {
  std::va_list list;
  va_start(list, flags);
  const mode_t mode = mode_of(flags, list);
  va_end(list);
  return open_file("open64", path, flags, mode);
}

ssize_t write(int file, const void* bytes, size_t size) {
  if (hit("write", true)) return -1;
  return next<ssize_t (*)(int, const void*, size_t)>("write")(file, bytes, size);
}

int fsync(int file) {
  if (hit("fsync", true)) return -1;
  return next<int (*)(int)>("fsync")(file);
}

int fchmod(int file, mode_t mode) {
  if (hit("fchmod", false)) return -1;
  return next<int (*)(int, mode_t)>("fchmod")(file, mode);
}

int rename(const char* from, const char* to) {
  if (hit("rename", false)) return -1;
  return next<int (*)(const char*, const char*)>("rename")(from, to);
}

int link(const char* from, const char* to) {
  if (hit("link", true)) return -1;
  return next<int (*)(const char*, const char*)>("link")(from, to);
}

int linkat(int from_folder, const char* from, int to_folder, const char* to, int flags) {
  if (hit("linkat", true)) return -1;
  return next<int (*)(int, const char*, int, const char*, int)>("linkat")(from_folder, from,
                                                                          to_folder, to, flags);
}

int unlink(const char* path) {
  if (hit("unlink", false)) return -1;
  return next<int (*)(const char*)>("unlink")(path);
}

int mkdir(const char* path, mode_t mode) {
  if (hit("mkdir", true)) return -1;
  return next<int (*)(const char*, mode_t)>("mkdir")(path, mode);
}

}  // extern "C"
