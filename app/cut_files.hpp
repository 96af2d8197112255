#pragma once
#include <string>

#include "record.hpp"

namespace cleave::app {

/// What a command says of a cut: `json` and `fix_it` to files of these names, if they have any, and
/// `text` to standard output.
struct CutAnswer {
  std::string json_file, json, text;
  std::string fix_it_file = {}, fix_it = {};
};

/// An answer: with --json - it is the JSON that goes to standard output, else, unless `quiet`, the
/// text. `json_option` is the argument of --json, or empty.
CutAnswer answer(const std::string& json_option, std::string json, std::string text, bool quiet);

/// Writes what a dry run writes. Throws OutputError.
void write_answer(const CutAnswer& answer);

/// Writes the mesh of a cut and its record, into which the hashes are filled, and the answer: all
/// of them, or none if one cannot be written. They appear in this order, so that a record beside
/// another mesh than its own, should the machine stop in between, is one whose hash does not fit.
/// No record is written if there is none, if OUT is no regular file, or if a group has a name that
/// is not UTF-8, which is warned about: then one that lies there is removed. Throws OutputError.
void write_cut(const std::string& out, const Mesh& mesh, IncisionRecord* record,
               const CutAnswer& answer);

}  // namespace cleave::app
