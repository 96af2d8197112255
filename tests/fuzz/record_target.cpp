// A mesh file with the record of its cut: refused with an InputError, or the mesh that was cut,
// which can be cut on and of which everything can be taken back. Hashes are not compared: no change
// of an input would get past them.
#include "cut_mesh.hpp"
#include "error.hpp"
#include "mesh_file.hpp"
#include "mesh_laws.hpp"
#include "stitch_mesh.hpp"
#include "targets.hpp"

namespace cleave::fuzz {
namespace {

template <class Options>
Options all_of_it() {
  Options options;
  options.all = true;
  options.quiet = true;
  options.verify = topology::Verify::all;
  return options;
}

void require_same_when_written(const Folder& folder, const app::IncisionRecord& record) {
  const auto text = app::json_of(record);
  FUZZ_REQUIRE(text);  // it was JSON before
  const auto again = app::read_record(folder.put("again.json", *text));
  FUZZ_REQUIRE(app::json_of(again) == text);
}

}  // namespace

void fuzz_record(Bytes bytes) {
  static const Folder folder;
  folder.clear();
  const auto path = folder.put_all("cut.mesh", text_of(bytes));
  app::Progress progress(1, true);
  try {
    const auto record = app::record_path(path);
    app::CutSource source;
    source.record = app::read_record(record);
    require_same_when_written(folder, *source.record);
    source.mesh = app::read_mesh(path);
    if (source.record->dimension != source.mesh.dimension) return;
    source.restored = app::restore_original(source.record->original, source.mesh, record.string());
    require_places(*source.restored);
    const auto stitched = app::stitch_mesh(source, all_of_it<app::StitchOptions>(), progress).mesh;
    require_same_content(stitched, *source.restored);
    require_places(app::cut_mesh(source, all_of_it<app::CutOptions>(), progress).mesh);
  } catch (const app::InputError&) {
  }
}

}  // namespace cleave::fuzz
