// A mesh file: it is refused with an InputError, or read; then it is sane, can be checked and cut,
// and is read back as it was written.
#include "check_report.hpp"
#include "cut_mesh.hpp"
#include "error.hpp"
#include "mesh_file.hpp"
#include "mesh_laws.hpp"
#include "progress.hpp"
#include "targets.hpp"

namespace cleave::fuzz {
namespace {

void write_and_read_back(const Folder& folder, const app::Mesh& mesh, const std::string& extension,
                         Keeps keeps) {
  const auto path = folder.path("again" + extension);
  try {
    app::write_mesh(path, mesh);
  } catch (const app::OutputError&) {
    return;  // a name, say, that this format cannot hold
  }
  const app::Mesh again = app::read_mesh(path);
  if (keeps == Keeps::everything)
    require_same_content(mesh, again);
  else
    require_same_cells(mesh, again);
}

void cut_everything(const Folder& folder, const app::Mesh& mesh, const std::string& extension) {
  app::CutOptions options;
  options.all = true;
  options.quiet = true;
  options.verify = topology::Verify::all;
  options.out = folder.path("cut" + extension).string();
  app::Progress progress(1, true);
  try {
    const app::CutResult result = app::cut_mesh({mesh, {}, {}}, options, progress);
    require_places(result.mesh);
    app::write_mesh(options.out, result.mesh);
    require_places(app::read_mesh(options.out));
  } catch (const app::InputError&) {
  } catch (const app::OutputError&) {
  }
}

}  // namespace

void fuzz_mesh(const std::string& extension, Keeps keeps, Bytes bytes) {
  static const Folder folder;
  folder.clear();
  const auto path = folder.put_all("input" + extension, text_of(bytes));
  app::Mesh mesh;
  try {
    mesh = app::read_mesh(path);
  } catch (const app::InputError&) {
    return;
  }
  require_places(mesh);
  const app::CheckReport report = app::check_mesh(mesh, {});
  FUZZ_REQUIRE(!app::text_of(report, 5, true).empty());
  FUZZ_REQUIRE(!app::json_of({report}).empty());
  write_and_read_back(folder, mesh, extension, keeps);
  cut_everything(folder, mesh, extension);
}

}  // namespace cleave::fuzz
