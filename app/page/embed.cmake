# cmake -DSOURCE_DIR=.. -DASSETS=a;b -DOUTPUT=assets.cpp -P embed.cmake
# Writes the bytes of the assets as string literals into a C++ file that defines asset(). The files
# under third_party/three must have the checksums of their npm package.
cmake_policy(VERSION 3.25)

file(STRINGS ${SOURCE_DIR}/third_party/three/SHA256SUMS sums)
foreach(line IN LISTS sums)
  string(REGEX MATCH "^([0-9a-f]+)  (.+)$" matched "${line}")
  file(SHA256 ${SOURCE_DIR}/third_party/three/${CMAKE_MATCH_2} found)
  if(NOT found STREQUAL CMAKE_MATCH_1)
    message(FATAL_ERROR "third_party/three/${CMAKE_MATCH_2} is not the file of the npm package: "
      "SHA-256 is ${found}, SHA256SUMS says ${CMAKE_MATCH_1}. Restore it with git checkout.")
  endif()
endforeach()

set(chunk 32000)  # hexadecimal digits: compilers need not take longer literals than 65536 bytes
set(arrays "")
set(lookup "")
set(number 0)
foreach(name IN LISTS ASSETS)
  file(READ ${SOURCE_DIR}/${name} bytes HEX)
  string(LENGTH "${bytes}" length)
  string(APPEND arrays "constexpr std::string_view kAsset${number}[] = {\n")
  set(at 0)
  while(at LESS length)
    string(SUBSTRING "${bytes}" ${at} ${chunk} part)
    string(REGEX REPLACE "(..)" "\\\\x\\1" part "${part}")
    string(APPEND arrays "    \"${part}\"sv,\n")
    math(EXPR at "${at} + ${chunk}")
  endwhile()
  string(APPEND arrays "};\n")
  get_filename_component(base ${name} NAME)
  string(APPEND lookup "  if (name == \"${base}\") return joined(kAsset${number});\n")
  math(EXPR number "${number} + 1")
endforeach()

file(WRITE ${OUTPUT} "// Written by embed.cmake.
#include \"page/assets.hpp\"

#include <span>
#include <stdexcept>

namespace cleave::app::page {
namespace {

using namespace std::string_view_literals;

${arrays}
std::string joined(std::span<const std::string_view> chunks) {
  std::string all;
  for (const auto chunk : chunks) all += chunk;
  return all;
}

}  // namespace

std::string asset(std::string_view name) {
${lookup}  throw std::logic_error(\"no asset of the page is called \" + std::string(name));
}

}  // namespace cleave::app::page
")
