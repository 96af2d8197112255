// Eight squares with a cut in each, for docs/semantics.md. junctions.msh was made of it:
// gmsh -2 -format msh22 junctions.geo -o junctions.msh
SetFactory("OpenCASCADE");
Mesh.MeshSizeMin = 0.17;
Mesh.MeshSizeMax = 0.17;
For i In {0 : 7}
  Rectangle(1 + i) = {1.5 * i, 0, 0, 1, 1};
EndFor

Macro Segment  // from (X0, Y0) to (X1, Y1)
  P = newp; Point(P) = {X0, Y0, 0}; Point(P + 1) = {X1, Y1, 0};
  L = newc; Line(L) = {P, P + 1};
  lines() += L;
Return

lines() = {};
X0 = 0.5;  Y0 = 0;    X1 = 0.5;  Y1 = 1;    Call Segment;  // tee: a line from side to side
X0 = 0.5;  Y0 = 0.5;  X1 = 1;    Y1 = 0.5;  Call Segment;  //      and a branch
X0 = 2;    Y0 = 0;    X1 = 2;    Y1 = 1;    Call Segment;  // cross
X0 = 1.5;  Y0 = 0.5;  X1 = 2.5;  Y1 = 0.5;  Call Segment;
X0 = 3.28; Y0 = 1;    X1 = 3.5;  Y1 = 0.25; Call Segment;  // vee: a fold
X0 = 3.72; Y0 = 1;    X1 = 3.5;  Y1 = 0.25; Call Segment;
X0 = 4.96; Y0 = 0;    X1 = 4.96; Y1 = 1;    Call Segment;  // close: two lines closer than a cell
X0 = 5.04; Y0 = 0;    X1 = 5.04; Y1 = 1;    Call Segment;
X0 = 7.5;  Y0 = 0.5;  X1 = 8.1;  Y1 = 0.5;  Call Segment;  // edge: from the boundary to a tip
X0 = 9.2;  Y0 = 0.5;  X1 = 9.8;  Y1 = 0.5;  Call Segment;  // inside: two tips
X0 = 11;   Y0 = 0;    X1 = 11;   Y1 = 0.5;  Call Segment;  // mixed: two halves that point
X0 = 11;   Y0 = 1;    X1 = 11;   Y1 = 0.5;  Call Segment;  //        towards each other
L = newc; Circle(L) = {6.5, 0.5, 0, 0.3};                  // ring: closed
lines() += L;
BooleanFragments { Surface{1 : 8}; Delete; } { Curve{lines()}; Delete; }

e = 0.001;
tee() = Curve In BoundingBox {0.5 - e, -e, -e, 0.5 + e, 1 + e, e};
tee() += Curve In BoundingBox {0.5 - e, 0.5 - e, -e, 1 + e, 0.5 + e, e};
cross() = Curve In BoundingBox {2 - e, -e, -e, 2 + e, 1 + e, e};
cross() += Curve In BoundingBox {1.5 - e, 0.5 - e, -e, 2.5 + e, 0.5 + e, e};
vee() = Curve In BoundingBox {3.28 - e, 0.25 - e, -e, 3.5 + e, 1 + e, e};
vee() += Curve In BoundingBox {3.5 - e, 0.25 - e, -e, 3.72 + e, 1 + e, e};
close() = Curve In BoundingBox {4.96 - e, -e, -e, 4.96 + e, 1 + e, e};
close() += Curve In BoundingBox {5.04 - e, -e, -e, 5.04 + e, 1 + e, e};
ring() = Curve In BoundingBox {6.2 - e, 0.2 - e, -e, 6.8 + e, 0.8 + e, e};
edge() = Curve In BoundingBox {7.5 - e, 0.5 - e, -e, 8.1 + e, 0.5 + e, e};
inside() = Curve In BoundingBox {9.2 - e, 0.5 - e, -e, 9.8 + e, 0.5 + e, e};
mixed() = Curve In BoundingBox {11 - e, -e, -e, 11 + e, 1 + e, e};
Physical Curve("tee") = {tee()};
Physical Curve("cross") = {cross()};
Physical Curve("vee") = {vee()};
Physical Curve("close") = {close()};
Physical Curve("ring") = {ring()};
Physical Curve("edge") = {edge()};
Physical Curve("inside") = {inside()};
Physical Curve("mixed") = {mixed()};
rim() = Point In BoundingBox {0.5 - e, -e, -e, 0.5 + e, e, e};  // where lines end at a side
rim() += Point In BoundingBox {0.5 - e, 1 - e, -e, 0.5 + e, 1 + e, e};
rim() += Point In BoundingBox {1 - e, 0.5 - e, -e, 1 + e, 0.5 + e, e};
rim() += Point In BoundingBox {2 - e, -e, -e, 2 + e, e, e};
rim() += Point In BoundingBox {2 - e, 1 - e, -e, 2 + e, 1 + e, e};
rim() += Point In BoundingBox {1.5 - e, 0.5 - e, -e, 1.5 + e, 0.5 + e, e};
rim() += Point In BoundingBox {2.5 - e, 0.5 - e, -e, 2.5 + e, 0.5 + e, e};
rim() += Point In BoundingBox {3.28 - e, 1 - e, -e, 3.72 + e, 1 + e, e};
rim() += Point In BoundingBox {4.96 - e, -e, -e, 5.04 + e, e, e};
rim() += Point In BoundingBox {4.96 - e, 1 - e, -e, 5.04 + e, 1 + e, e};
rim() += Point In BoundingBox {11 - e, -e, -e, 11 + e, e, e};
rim() += Point In BoundingBox {11 - e, 1 - e, -e, 11 + e, 1 + e, e};
Physical Point("rim") = {rim()};
Physical Surface("sheet") = {Surface{:}};
