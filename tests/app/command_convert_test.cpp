// cleave convert and cleave info.
#include <nlohmann/json.hpp>

#include "command_support.hpp"

namespace cleave::app::test {
namespace {

using nlohmann::json;

class Convert : public CommandTest {
 protected:
  void expect_valid(const std::string& schema, const std::string& file) const {
    const Outcome outcome = run({"/usr/bin/python3", CLEAVE_VALIDATE_JSON,
                                 CLEAVE_SCHEMAS "/" + schema + ".schema.json", file});
    EXPECT_TRUE(outcome.status == 0 || outcome.status == 77) << outcome.err;  // 77: no jsonschema
  }
};

const std::string kVtu =
    "<VTKFile type=\"UnstructuredGrid\" version=\"0.1\" byte_order=\"LittleEndian\">\n"
    "<UnstructuredGrid><Piece NumberOfPoints=\"4\" NumberOfCells=\"2\"><PointData>\n"
    "<DataArray type=\"Float64\" Name=\"heat\" format=\"ascii\">1 2 3 4</DataArray></PointData>\n"
    "<CellData><DataArray type=\"Float64\" Name=\"flow\" format=\"ascii\">7 8</DataArray>\n"
    "</CellData><Points>\n"
    "<DataArray type=\"Float64\" NumberOfComponents=\"3\" format=\"ascii\">\n"
    "0 0 0 1 0 0 0 1 0 0 0 1</DataArray></Points><Cells>\n"
    "<DataArray type=\"Int64\" Name=\"connectivity\" format=\"ascii\">0 1 2 0 1 2 3</DataArray>\n"
    "<DataArray type=\"Int64\" Name=\"offsets\" format=\"ascii\">3 7</DataArray>\n"
    "<DataArray type=\"UInt8\" Name=\"types\" format=\"ascii\">5 10</DataArray>\n"
    "</Cells></Piece></UnstructuredGrid></VTKFile>\n";

TEST_F(Convert, NamesWhatTheTargetCannotHold) {
  write("a.vtu", kVtu);
  const Outcome outcome = cleave({"convert", "a.vtu", "b.mesh", "--json", "r.json"});
  EXPECT_EQ(outcome.status, 0);
  for (const char* part : {"1 field of points is left out", "1 field of cells is left out",
                           "1 field of facets is left out"})
    EXPECT_NE(outcome.err.find(part), std::string::npos) << part << "\n" << outcome.err;
  expect_valid("cleave-convert-1", "r.json");
  const json report = json::parse(read("r.json"));
  EXPECT_EQ(report["output"]["format"], "Medit");
  EXPECT_EQ(report["losses"].size(), 3u);
  EXPECT_EQ(report["losses"][0]["kind"], "point-fields");
  EXPECT_EQ(read("b.mesh").substr(0, 22), "MeshVersionFormatted 2");
}

TEST_F(Convert, CountsWhatIsLostInTheRightNumber) {
  std::string two = kVtu;
  const std::string heat = two.substr(two.find("<PointData>") + 11,
                                      two.find("</PointData>") - two.find("<PointData>") - 11);
  std::string cold = heat;
  cold.replace(cold.find("\"heat\""), 6, "\"cold\"");
  two.insert(two.find("</PointData>"), cold);
  write("a.vtu", two);
  const Outcome outcome = cleave({"convert", "a.vtu", "b.mesh"});
  EXPECT_EQ(outcome.status, 0);
  for (const char* part : {"2 fields of points are left out", "1 field of cells is left out"})
    EXPECT_NE(outcome.err.find(part), std::string::npos) << part << "\n" << outcome.err;
}

TEST_F(Convert, StrictRefusesALossAndWritesNothing) {
  write("a.vtu", kVtu);
  const Outcome outcome = cleave({"convert", "a.vtu", "b.mesh", "--strict", "--json", "r.json"});
  EXPECT_EQ(outcome.status, 3);
  EXPECT_NE(outcome.err.find("--strict refuses a loss"), std::string::npos) << outcome.err;
  EXPECT_NE(outcome.err.find("1 field of points is left out"), std::string::npos) << outcome.err;
  EXPECT_EQ(files(), std::vector<std::string>{"a.vtu"});
  EXPECT_EQ(cleave({"convert", "a.vtu", "b.vtk", "--strict"}).status, 0);
  write("c.inp",
        "*NODE\n1, 0, 0, 0\n2, 1, 0, 0\n*ELEMENT, TYPE=T3D2\n1, 1, 2\n*MATERIAL, NAME=x\n");
  EXPECT_EQ(cleave({"convert", "c.inp", "c.vtu", "--strict"}).status, 3);
  const Outcome warned = cleave({"convert", "c.inp", "c.vtu"});
  EXPECT_EQ(warned.status, 0);
  EXPECT_NE(warned.err.find("*MATERIAL"), std::string::npos) << warned.err;
}

TEST_F(Convert, TakesEveryFormAndRefusesOnesThatDoNotFit) {
  const std::string fault = data("fault.msh");
  EXPECT_EQ(cleave({"convert", fault, "a.msh", "--msh-version", "2.2", "--text"}).status, 0);
  EXPECT_EQ(read("a.msh").substr(0, 22), "$MeshFormat\n2.2 0 8\n$E");
  for (const char* encoding : {"text", "raw", "base64", "zlib"}) {
    EXPECT_EQ(cleave({"convert", fault, "a.vtu", "--encoding", encoding}).status, 0);
    EXPECT_NE(cleave({"info", "a.vtu"}).out.find("group 'branch'"), std::string::npos);
  }
  EXPECT_EQ(cleave({"convert", fault, "a.vtk", "--text"}).status, 0);
  EXPECT_NE(read("a.vtk").find("\nASCII\n"), std::string::npos);
  const auto refused = [&](const std::vector<std::string>& args, int status) {
    std::vector<std::string> all{"convert", fault};
    all.insert(all.end(), args.begin(), args.end());
    const Outcome outcome = cleave(all);
    EXPECT_EQ(outcome.status, status) << outcome.err;
    return outcome.err;
  };
  EXPECT_NE(refused({"b.vtu", "--binary"}, 3).find(".msh and .vtk files only"), std::string::npos);
  EXPECT_NE(refused({"b.mesh", "--encoding", "raw"}, 3).find(".vtu files only"), std::string::npos);
  EXPECT_NE(refused({"b.inp", "--msh-version", "4.1"}, 3).find(".msh files only"),
            std::string::npos);
  EXPECT_NE(refused({"b.xyz"}, 3).find(".mesh (Medit), .msh (gmsh), .node (TetGen)"),
            std::string::npos);
  refused({"b.vtk", "--binary", "--text"}, 2);
  refused({"b.msh", "--msh-version", "3"}, 2);
  refused({"b.node", "--json", "b.ele"}, 2);
}

TEST_F(Convert, InfoSaysWhatAFileHolds) {
  const Outcome text = cleave({"info", data("fault.msh")});
  EXPECT_EQ(text.status, 0);
  for (const char* part :
       {"gmsh 4.1, text; dimension 3", "630 vertices, numbers 1 to 630",
        "2295 tetrahedra, numbers 375 to 2669",
        "group 'fault' of dimension 2 (integer 1): 104 elements", "from (0, 0, 0) to (4, 3, 2)",
        "1 piece, 1 boundary component, Euler characteristic 1"})
    EXPECT_NE(text.out.find(part), std::string::npos) << part << "\n" << text.out;
  write("a.vtu", kVtu);
  EXPECT_EQ(cleave({"info", "a.vtu", "--json", "i.json"}).status, 0);
  expect_valid("cleave-info-1", "i.json");
  const json info = json::parse(read("i.json"));
  EXPECT_EQ(info["format"], "VTK XML");
  EXPECT_EQ(info["version"], "0.1");
  EXPECT_EQ(info["encoding"], "text");
  EXPECT_EQ(info["elements"].size(), 2u);
  EXPECT_EQ(info["fields"].size(), 3u);
  EXPECT_EQ(info["fields"][0]["ranges"], json::parse("[[1.0, 4.0]]"));
  EXPECT_EQ(info["bounding_box"]["high"], json::parse("[1.0, 1.0, 1.0]"));
  EXPECT_EQ(info["topology"]["pieces"], 1);
  write("n.mesh",
        "MeshVersionFormatted 2\nDimension 3\nVertices\n3\n0 0 0 0\n1 nan 0 0\n0 1 0 0\n"
        "Triangles\n1\n1 2 3 0\nEnd\n");
  const Outcome odd = cleave({"info", "n.mesh", "--json", "-"});
  EXPECT_EQ(json::parse(odd.out)["vertices"]["not_finite"], 1);
  EXPECT_EQ(json::parse(odd.out)["version"], "2");
  EXPECT_EQ(cleave({"info", "none.msh"}).status, 3);
}

}  // namespace
}  // namespace cleave::app::test
