// Output files are written completely or not at all; files that cannot be read are named.
#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <csignal>

#include "error.hpp"
#include "files_support.hpp"
#include "mesh_file.hpp"
#include "output_files.hpp"

namespace cleave::app::test {
namespace {

using Output = Files;
using Names = std::vector<std::string>;

/// The message of the OutputError that writing 600000 bytes to `path` throws.
std::string writing_error(const std::filesystem::path& path) {
  try {
    write_file(path, std::string(600000, 'x'));
  } catch (const OutputError& error) {
    return error.what();
  }
  ADD_FAILURE() << path << " was written";
  return {};
}

/// Without the rights of the superuser, whom no permission stops.
struct OrdinaryUser {
  OrdinaryUser() {
    if (geteuid() == 0) {
      EXPECT_EQ(seteuid(65534), 0);
    }
  }
  ~OrdinaryUser() {
    if (getuid() == 0) {
      EXPECT_EQ(seteuid(0), 0);
    }
  }
};

TEST_F(Output, AppearsOnlyWhenItIsComplete) {
  {
    OutputFile file(path("a"));
    file.write("half");
    for (const std::string& name : names()) EXPECT_EQ(name.rfind(".cleave-", 0), 0u) << name;
  }
  EXPECT_TRUE(names().empty());
  OutputFile file(path("a"));
  file.write(std::string(400000, 'a'));
  file.write("b");
  file.commit();
  EXPECT_EQ(names(), Names{"a"});
  EXPECT_EQ(bytes("a"), std::string(400000, 'a') + "b");
}

TEST_F(Output, ReplacesAFileAndKeepsItsPermissions) {
  put("a", "old");
  ASSERT_EQ(chmod(path("a").c_str(), 0640), 0);
  { OutputFile(path("a")).write("never committed"); }
  EXPECT_EQ(bytes("a"), "old");
  write_file(path("a"), "new");
  EXPECT_EQ(bytes("a"), "new");
  struct stat status {};
  ASSERT_EQ(stat(path("a").c_str(), &status), 0);
  EXPECT_EQ(status.st_mode & 0777, 0640u);
  EXPECT_EQ(names(), Names{"a"});
}

TEST_F(Output, NewFilesFollowTheUmask) {
  const mode_t before = umask(027);
  write_file(path("a"), "x");
  umask(before);
  struct stat status {};
  ASSERT_EQ(stat(path("a").c_str(), &status), 0);
  EXPECT_EQ(status.st_mode & 0777, 0640u);
}

TEST_F(Output, ASymbolicLinkStaysOne) {
  put("real", "old");
  std::filesystem::create_symlink("real", path("link"));
  write_file(path("link"), "new");
  EXPECT_TRUE(std::filesystem::is_symlink(path("link")));
  EXPECT_EQ(bytes("real"), "new");
}

TEST_F(Output, ASymbolicLinkToNothingIsFollowed) {
  std::filesystem::create_directory(path("folder"));
  std::filesystem::create_symlink("folder/next", path("link"));
  std::filesystem::create_symlink("../real", path("folder/next"));
  write_file(path("link"), "new");
  EXPECT_TRUE(std::filesystem::is_symlink(path("link")));
  EXPECT_TRUE(std::filesystem::is_symlink(path("folder/next")));
  EXPECT_EQ(bytes("real"), "new");
  std::filesystem::create_symlink("loop", path("loop"));
  EXPECT_NE(writing_error(path("loop")).find("Too many levels"), std::string::npos);
  EXPECT_TRUE(std::filesystem::is_symlink(path("loop")));
  std::filesystem::create_symlink("nowhere/file", path("lost"));
  EXPECT_NE(writing_error(path("lost")).find("nowhere' does not exist"), std::string::npos);
}

TEST_F(Output, APipeIsWrittenDirectlyAlsoBehindALink) {
  std::array<int, 2> ends{};
  ASSERT_EQ(pipe(ends.data()), 0);
  write_file("/proc/self/fd/" + std::to_string(ends[1]), "through");
  std::array<char, 16> got{};
  EXPECT_EQ(read(ends[0], got.data(), got.size()), 7);
  EXPECT_STREQ(got.data(), "through");
  close(ends[0]);
  close(ends[1]);
}

TEST_F(Output, AFolderWithoutNewFilesIsNotCalledMissing) {
  const std::string message = writing_error("/proc/x.msh");
  EXPECT_EQ(message.find("does not exist"), std::string::npos) << message;
  EXPECT_NE(message.find("cannot write '/proc/x.msh'"), std::string::npos) << message;
}

TEST_F(Output, AFullDiskIsAnError) {
  const std::string message = writing_error("/dev/full");
  EXPECT_NE(message.find("/dev/full"), std::string::npos) << message;
  EXPECT_NE(message.find("No space left"), std::string::npos) << message;
  EXPECT_THROW(write_file("/dev/full", "little enough to be buffered"), OutputError);
  write_file("/dev/null", "fine");
}

TEST_F(Output, AFileThatCannotGrowIsAnErrorAndLeavesNothing) {
  put("a", "old");
  const auto ignored = std::signal(SIGXFSZ, SIG_IGN);
  rlimit before{};
  ASSERT_EQ(getrlimit(RLIMIT_FSIZE, &before), 0);
  const rlimit small{100000, before.rlim_max};
  ASSERT_EQ(setrlimit(RLIMIT_FSIZE, &small), 0);
  const std::string message = writing_error(path("a"));
  ASSERT_EQ(setrlimit(RLIMIT_FSIZE, &before), 0);
  std::signal(SIGXFSZ, ignored);
  EXPECT_NE(message.find("File too large"), std::string::npos) << message;
  EXPECT_EQ(names(), Names{"a"});
  EXPECT_EQ(bytes("a"), "old");
}

TEST_F(Output, SaysWhyItCannotWrite) {
  EXPECT_NE(writing_error(path("no/such")).find("does not exist; make it"), std::string::npos);
  EXPECT_NE(writing_error(path("")).find("Is a directory"), std::string::npos);
  EXPECT_NE(writing_error("").find("empty"), std::string::npos);
  put("file", "");
  EXPECT_NE(writing_error(path("file/a")).find("Not a directory"), std::string::npos);
  put("mine", "old");
  ASSERT_EQ(chmod(path("mine").c_str(), 0400), 0);
  const OrdinaryUser ordinary;
  EXPECT_NE(writing_error(path("mine")).find("Permission denied"), std::string::npos);
  if (getuid() == 0) {  // the folder belongs to the superuser then
    EXPECT_NE(writing_error(path("new")).find("Permission denied"), std::string::npos);
  }
}

TEST_F(Output, ASignalRemovesTheTemporaryAndEndsTheProcess) {
  for (const int signal : {SIGINT, SIGTERM, SIGHUP}) {
    put("a", "old");
    const pid_t child = fork();
    ASSERT_GE(child, 0);
    if (child == 0) {
      OutputFile file(path("a"));
      file.write(std::string(600000, 'x'));
      raise(signal);
      _exit(2);
    }
    int status = 0;
    ASSERT_EQ(waitpid(child, &status, 0), child);
    ASSERT_TRUE(WIFSIGNALED(status)) << WEXITSTATUS(status);
    EXPECT_EQ(WTERMSIG(status), signal);
    EXPECT_EQ(names(), Names{"a"});
    EXPECT_EQ(bytes("a"), "old");
  }
}

TEST_F(Output, ASignalThatIsIgnoredStaysIgnored) {
  const pid_t child = fork();
  ASSERT_GE(child, 0);
  if (child == 0) {
    std::signal(SIGHUP, SIG_IGN);  // as nohup does
    OutputFile file(path("a"));
    file.write("x");
    raise(SIGHUP);
    file.commit();
    _exit(0);
  }
  int status = 0;
  ASSERT_EQ(waitpid(child, &status, 0), child);
  EXPECT_TRUE(WIFEXITED(status));
  EXPECT_EQ(names(), Names{"a"});
}

TEST_F(Output, FilesThatBelongTogetherAppearTogether) {
  put("a", "old a");
  put("stale", "old");
  {
    OutputFiles files;
    files.add(path("a")).write("never");
    files.add(path("b")).write("never");
    files.remove(path("stale"));
  }
  EXPECT_EQ(bytes("a"), "old a");
  EXPECT_EQ(names(), (Names{"a", "stale"}));
  OutputFiles files;
  files.add(path("a")).write("new a");
  files.add(path("b")).write("new b");
  files.remove(path("stale"));
  files.remove(path("was never there"));
  files.commit();
  EXPECT_EQ(bytes("a"), "new a");
  EXPECT_EQ(bytes("b"), "new b");
  EXPECT_EQ(names(), (Names{"a", "b"}));
}

TEST_F(Output, WhatAppearedIsTakenBackIfALaterFileCannot) {
  put("a", "old a");
  put("gone", "old");
  OutputFiles files;
  files.add(path("a")).write("new a");
  files.add(path("b")).write("new b");
  files.add(path("c")).write("new c");
  files.remove(path("gone"));
  std::filesystem::create_directory(path("c"));  // after it was found to be free
  put("c/inside", "x");
  EXPECT_THROW(files.commit(), OutputError);
  EXPECT_EQ(bytes("a"), "old a");
  EXPECT_EQ(bytes("gone"), "old");
  EXPECT_FALSE(std::filesystem::exists(path("b")));
}

TEST_F(Output, AFolderThatGoesMeanwhileIsAnError) {
  std::filesystem::create_directory(path("folder"));
  {
    OutputFiles files;
    files.add(path("folder/a")).write("new");
    files.add(path("b")).write("new");
    std::filesystem::remove_all(path("folder"));
    EXPECT_THROW(files.commit(), OutputError);
  }
  EXPECT_TRUE(names().empty());
}

TEST_F(Output, AMeshThatCannotBeWrittenLeavesNothing) {
  EXPECT_THROW(write_mesh(path("no/such.vtu"), grouped_mesh()), OutputError);
  EXPECT_THROW(write_mesh(path("a.stl"), grouped_mesh()), InputError);
  EXPECT_TRUE(names().empty());
}

TEST_F(Output, FilesThatCannotBeReadAreNamed) {
  std::filesystem::create_directory(path("folder.mesh"));
  for (const std::string extension : {".mesh", ".msh", ".vtu", ".vtk"}) {
    expect_reading_error(path("none" + extension), {"none" + extension, "No such file"});
    expect_reading_error(put("empty" + extension, ""), {"empty" + extension, "empty"});
    expect_reading_error(put("blank" + extension, "\n \n\t\n"), {"blank" + extension + ":1:"});
    std::filesystem::create_directories(path("folder" + extension));
    expect_reading_error(path("folder" + extension), {"folder" + extension, "Is a directory"});
  }
  for (const char* name : {"a.stl", "a", "a.gz", "a.stl.gz", ".mesh"})
    expect_reading_error(put(name, "x"), {"extension", ".mesh", ".msh", ".vtu", ".vtk"});
  put("secret.mesh", "x");
  ASSERT_EQ(chmod(path("secret.mesh").c_str(), 0), 0);
  const OrdinaryUser ordinary;
  expect_reading_error(path("secret.mesh"), {"secret.mesh", "Permission denied"});
}

TEST_F(Output, ContentThatIsNotOfTheFormatIsNamed) {
  const std::pair<const char*, std::string> contents[] = {
      {"an XML file", "<?xml version=\"1.0\"?>\n<VTKFile>"},
      {"a JSON file", "{\"a\": 1}"},
      {"a gzip archive", "\x1f\x8b\x08 and so on"},
      {"binary data", std::string("MeshVersionFormatted\0\1\2", 23)},
      {"a gmsh file", "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n"},
      {"a Medit file", "MeshVersionFormatted 1\n"},
      {"a legacy VTK file", "# vtk DataFile Version 3.0\n"},
  };
  const std::pair<const char*, const char*> formats[] = {{".mesh", "a Medit file"},
                                                         {".msh", "a gmsh file"},
                                                         {".vtu", "an XML file"},
                                                         {".vtk", "a legacy VTK file"}};
  for (const auto& [extension, own] : formats)
    for (const auto& [kind, content] : contents)
      if (std::string(kind) != own)
        expect_reading_error(put(std::string("a") + extension, content), {kind, "not a"});
}

}  // namespace
}  // namespace cleave::app::test
