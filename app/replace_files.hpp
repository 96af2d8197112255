#pragma once
#include <filesystem>
#include <memory>
#include <span>
#include <string>

#include "temporaries.hpp"

namespace cleave::app {

/// A file that is complete, flushed to the disk and has a temporary name in the folder of the one
/// it is to replace; or, with no `from`, a file that is to go.
struct Replacement {
  std::filesystem::path from, to;
  std::filesystem::path shown;  // `to` as the user named it, for messages
};

/// Renames all `from` to their `to` and removes what is to go, in this order. If one of these steps
/// fails, those before it are taken back, so that what stood at every `to` stands there again, and
/// OutputError is thrown; the `from` that were not renamed stay. Taking back needs hard links,
/// which are made first; on a file system without them (FAT) the steps before the one that fails
/// stay done. A process that is killed between two steps has done the first ones.
void replace_together(std::span<const Replacement> replacements);

/// A name in the folder of `target` that nobody else uses: `.cleave-PROCESS-COUNT.tmp`, hidden and
/// short enough for every file system.
std::filesystem::path temporary_name(const std::filesystem::path& target);

/// The folder that `file` is in; "." for a bare name.
std::filesystem::path folder_of(const std::filesystem::path& file);

/// The file that `path` names when symbolic links are followed, whether there is one or not: `path`
/// itself if it is no link. After 40 links, as the kernel does, it gives up and returns a link.
std::filesystem::path behind_links(const std::filesystem::path& path);

/// Throws OutputError: `shown` cannot be written, why, and what to do.
[[noreturn]] void cannot_write(const std::filesystem::path& shown, int error_number);

}  // namespace cleave::app
