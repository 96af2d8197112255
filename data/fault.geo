// A block of rock, 4 x 3 x 2 km, with a fault that ends inside and a branch that meets it in a T.
// fault.msh was made of it: gmsh -3 -format msh41 fault.geo -o fault.msh
SetFactory("OpenCASCADE");
Box(1) = {0, 0, 0, 4, 3, 2};
Rectangle(101) = {0, 0, 0, 3, 2, 0};
Rotate {{1, 0, 0}, {0, 0, 0}, Pi/2} { Surface{101}; }
Translate {0.5, 1.5, 0} { Surface{101}; }
Rectangle(102) = {0, 0, 0, 1.5, 2, 0};
Rotate {{1, 0, 0}, {0, 0, 0}, Pi/2} { Surface{102}; }
Rotate {{0, 0, 1}, {0, 0, 0}, Pi/2} { Surface{102}; }
Translate {2, 1.5, 0} { Surface{102}; }
BooleanFragments { Volume{1}; Delete; } { Surface{101, 102}; Delete; }
eps = 0.001;
fault() = Surface In BoundingBox {0.5 - eps, 1.5 - eps, -eps, 3.5 + eps, 1.5 + eps, 2 + eps};
branch() = Surface In BoundingBox {2 - eps, 1.5 - eps, -eps, 2 + eps, 3 + eps, 2 + eps};
Physical Surface("fault") = {fault()};
Physical Surface("branch") = {branch()};
base() = Surface In BoundingBox {-eps, -eps, -eps, 4 + eps, 3 + eps, eps};
Physical Surface("base") = {base()};
Physical Volume("rock") = {Volume{:}};
Mesh.MeshSizeMin = 0.4;
Mesh.MeshSizeMax = 0.4;
