// A cube with three planes that cross in its middle, for docs/semantics.md. octants.msh was made of
// it: gmsh -3 -format msh22 octants.geo -o octants.msh
SetFactory("OpenCASCADE");
Mesh.MeshSizeMin = 0.5;
Mesh.MeshSizeMax = 0.5;
Box(1) = {-1, -1, -1, 2, 2, 2};
Rectangle(101) = {-1, -1, 0, 2, 2};
Rectangle(102) = {-1, -1, 0, 2, 2};
Rotate {{1, 0, 0}, {0, 0, 0}, Pi/2} { Surface{102}; }
Rectangle(103) = {-1, -1, 0, 2, 2};
Rotate {{0, 1, 0}, {0, 0, 0}, Pi/2} { Surface{103}; }
BooleanFragments { Volume{1}; Delete; } { Surface{101 : 103}; Delete; }
e = 0.001;
x() = Surface In BoundingBox {-e, -1 - e, -1 - e, e, 1 + e, 1 + e};
y() = Surface In BoundingBox {-1 - e, -e, -1 - e, 1 + e, e, 1 + e};
z() = Surface In BoundingBox {-1 - e, -1 - e, -e, 1 + e, 1 + e, e};
Physical Surface("x") = {x()};
Physical Surface("y") = {y()};
Physical Surface("z") = {z()};
Physical Volume("cube") = {Volume{:}};
