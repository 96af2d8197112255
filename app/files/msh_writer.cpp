#include <limits>
#include <string>

#include "error.hpp"
#include "files/msh_output.hpp"

namespace cleave::app {
namespace {

void write_format(MshRows& rows, MshVersion version) {
  TextOutput& out = rows.text();
  out << "$MeshFormat\n"
      << (version == MshVersion::k41 ? "4.1 " : "2.2 ") << (rows.binary() ? "1 8\n" : "0 8\n");
  if (rows.binary()) {
    rows.row(std::int32_t{1});  // tells the order of the bytes
    out << '\n';
  }
  out << "$EndMeshFormat\n";
}

void write_physical_names(TextOutput& out, const std::vector<MshLevel>& levels) {
  std::string names;
  std::size_t count = 0;
  for (const MshLevel& level : levels) {
    if (level.kind.cohesive) continue;  // their groups are the cells'
    for (std::size_t g = 0; g < level.groups.size(); ++g) {
      const std::string& name = level.groups[g].name;
      const std::string tag = std::to_string(level.tags[g]);
      if (name.empty() || (name == tag && !level.groups[g].elements.empty())) continue;
      if (name.size() > 127 || name.find_first_of("\"\r\n") != std::string::npos)
        throw OutputError("the group '" + name +
                          "' cannot be named in a .msh file: no quotation mark or line break is "
                          "allowed, and at most 127 bytes; rename it");
      names += std::to_string(level.kind.dimension) + " " + tag + " \"" + name + "\"\n";
      ++count;
    }
  }
  if (count > 0) out << "$PhysicalNames\n" << count << '\n' << names << "$EndPhysicalNames\n";
}

}  // namespace

void write_msh(TextOutput& out, const Mesh& mesh, const MshForm& form) {
  MshRows rows(out, form.binary);
  const std::vector<MshLevel> levels = msh_levels(mesh);
  const bool is_41 = form.version == MshVersion::k41;
  std::size_t repeated = 0;  // rows beyond one per element in version 2.2
  for (const MshLevel& level : levels)
    for (const Group& group : level.groups) repeated += group.elements.size();
  const std::uint64_t greatest = form.binary && !is_41
                                     ? std::uint64_t{std::numeric_limits<std::int32_t>::max()}
                                     : std::numeric_limits<std::uint64_t>::max();
  const MshNumbers numbers(mesh, greatest, is_41 ? greatest : greatest - repeated);
  write_format(rows, form.version);
  write_physical_names(out, levels);
  is_41 ? write_msh41(rows, mesh, levels, numbers) : write_msh22(rows, mesh, levels, numbers);
  write_msh_data(rows, mesh, numbers);
}

}  // namespace cleave::app
