#include "commands.hpp"

#include <fmt/format.h>

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <new>
#include <stdexcept>

#include "error.hpp"
#include "output_file.hpp"

namespace cleave::app {
namespace {

int fail(ExitStatus status, const std::string& text) {
  fmt::print(stderr, "cleave: error: {}\n", text);
  return status;
}

}  // namespace

int guarded(const Action& action) {
  try {
    return action();
  } catch (const InputError& e) {
    return fail(kBadInput, e.what());
  } catch (const OutputError& e) {
    return fail(kBadInput, e.what());
  } catch (const std::length_error& e) {
    return fail(kBadInput, fmt::format("{}; divide the mesh", e.what()));
  } catch (const std::bad_alloc&) {
    return fail(kBadInput, "there is not enough memory for this mesh; use a machine with more");
  } catch (const std::exception& e) {
    return fail(kBroken, fmt::format("a defect of cleave, please report it: {}", e.what()));
  }
}

void warn(const std::string& text) { fmt::print(stderr, "cleave: warning: {}\n", text); }

void write_report(const std::string& path, const std::string& text) {
  if (path == "-") return print(text);
  write_file(path, text);
}

void print(const std::string& text) {
  if (std::fwrite(text.data(), 1, text.size(), stdout) != text.size() || std::fflush(stdout) != 0)
    throw OutputError(fmt::format("standard output: {}", std::strerror(errno)));
}

}  // namespace cleave::app
