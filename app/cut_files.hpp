#pragma once
#include <optional>
#include <string>
#include <vector>

#include "certificate.hpp"
#include "output_files.hpp"
#include "record.hpp"

namespace cleave::app {

/// The record beside OUT, of the mesh that was there before, is to be gone when the files appear.
/// Beside a device or a pipe there is none.
void remove_record(OutputFiles& files, const std::string& out);

/// Throws InputError for a name without a format, or whose format cannot hold what is to be
/// written: cohesive elements.
void require_format(const std::string& out, bool cohesive);

/// What a command says of a cut: `json`, `fix_it` and `certificate` to files of these names, if
/// they have any, and `text` to standard output.
struct CutAnswer {
  std::string json_file, json, text;
  std::string fix_it_file = {}, fix_it = {};
  std::string certificate_file = {};  // "-": standard output, instead of `text`
  std::optional<Certificate> certificate = {};
};

/// An answer: with --json - it is the JSON that goes to standard output, else, unless `quiet`, the
/// text. `json_option` is the argument of --json, or empty.
CutAnswer answer(const std::string& json_option, std::string json, std::string text, bool quiet);

/// Adds a certificate to an answer, for the file of this name; "-" is standard output.
void add_certificate(CutAnswer& answer, const std::string& file,
                     std::optional<Certificate> certificate);

/// Throws CLI::ValidationError if a certificate cannot go where --certificate says: onto one of
/// `files`, or to standard output together with the JSON.
void refuse_certificate(const std::string& certificate, const std::vector<std::string>& files,
                        const std::string& json);

/// Writes what a dry run writes. Throws OutputError.
void write_answer(const CutAnswer& answer);

/// Writes the mesh of a cut and its record, into which the hashes are filled, and the answer: all
/// of them, or none if one cannot be written. Should the machine stop in between, a record beside
/// another mesh than its own is noticed by the hash. No record is written if there is none, if OUT
/// is no regular file, or if a group has a name that is not UTF-8, which is warned about: then one
/// that lies there is removed. Throws OutputError.
void write_cut(const std::string& out, const Mesh& mesh, IncisionRecord* record,
               const CutAnswer& answer);

}  // namespace cleave::app
