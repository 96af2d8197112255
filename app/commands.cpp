#include "commands.hpp"

#include <fmt/format.h>

#include <CLI/Error.hpp>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <new>
#include <stdexcept>

#include "error.hpp"
#include "output_file.hpp"

namespace cleave::app {
namespace {

// Nobody can be told when standard error takes nothing, so that is no failure.
void print_on_stderr(const std::string& text) { std::fputs((text + '\n').c_str(), stderr); }

bool same_file(const std::string& a, const std::string& b) {
  std::error_code ignored;
  if (std::filesystem::equivalent(a, b, ignored)) return true;
  const auto absolute = [&](const std::string& name) {
    return std::filesystem::weakly_canonical(std::filesystem::absolute(name, ignored), ignored);
  };
  return absolute(a) == absolute(b);
}

}  // namespace

std::optional<Failure> attempt(const std::function<void()>& action) {
  try {
    action();
    return std::nullopt;
  } catch (const InputError& e) {
    return Failure{kBadInput, e.what()};
  } catch (const OutputError& e) {
    return Failure{kBadInput, e.what()};
  } catch (const std::length_error& e) {
    return Failure{kBadInput, fmt::format("{}; divide the mesh", e.what())};
  } catch (const std::bad_alloc&) {
    return Failure{kBadInput, "there is not enough memory for this mesh; use a machine with more"};
  } catch (const std::exception& e) {
    return Failure{kBroken, fmt::format("a defect of cleave, please report it: {}", e.what())};
  }
}

int complain(const Failure& failure) {
  print_on_stderr("cleave: error: " + failure.text);
  return failure.status;
}

int guarded(const Action& action) {
  int status = kFine;
  const auto failure = attempt([&] { status = action(); });
  return failure ? complain(*failure) : status;
}

void warn(const std::string& text) { print_on_stderr("cleave: warning: " + text); }

void note(const std::string& text) { print_on_stderr("cleave: " + text); }

void refuse_report_onto(const std::string& report, const std::vector<std::string>& files,
                        const std::string& option, const std::string& what) {
  if (report.empty() || report == "-") return;
  for (const std::string& file : files)
    if (!file.empty() && same_file(report, file))
      throw CLI::ValidationError(
          option, fmt::format("the {} would overwrite '{}'; give it another name", what, file));
}

void write_report(const std::string& path, const std::string& text) {
  if (path == "-") return print(text);
  write_file(path, text);
}

void print(const std::string& text) {
  if (std::fwrite(text.data(), 1, text.size(), stdout) != text.size() || std::fflush(stdout) != 0)
    throw OutputError(fmt::format("standard output: {}", std::strerror(errno)));
}

}  // namespace cleave::app
