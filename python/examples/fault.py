"""A fault opened in a block of rock, checked, and taken back: a notebook as a plain script.

Run it as it is, `python3 python/examples/fault.py`, or cell by cell in an editor that knows `# %%`.
It needs cleave, numpy and meshio.
"""

# %% The mesh: tetrahedra, and two groups of facets that meet in a T
import pathlib

import meshio
import numpy as np

import cleave
import cleave.meshio

rock = meshio.read(pathlib.Path(__file__).parents[2] / "data" / "fault.msh")
found = cleave.meshio.check(rock)
print(f"{len(cleave.meshio.cells_of(rock))} cells, level {found.level}, "
      f"{len(found.findings)} findings, {found.pieces} piece")

# %% The cut: both groups at once; nothing else opens
opened, cut = cleave.meshio.cut(rock, group=["fault", "branch"])
copies = len(opened.points) - len(rock.points)
print(f"{len(cut.opened)} facets opened, {len(cut.shut)} are shut, {copies} vertices are copies")

# %% The proof of this result: certify shares no code with cut
facets = np.concatenate([cleave.meshio.group_of(rock, name) for name in ("fault", "branch")])
print("certified:", bool(cleave.certify(cleave.meshio.cells_of(rock), facets,
                                        cleave.meshio.cells_of(opened))))

# %% Data follow `parents`: here a field that is the height of each point
height = rock.points[:, 2]
assert np.array_equal(height[cut.parents], opened.points[:, 2])

# %% Step by step, with a way back: cut the branch, then the fault, take the branch back
incision = cleave.Incision(cleave.meshio.cells_of(rock))
branch = cleave.locate(incision.cells, cleave.meshio.group_of(rock, "branch"))
fault = cleave.locate(incision.cells, cleave.meshio.group_of(rock, "fault"))
for step, change in [("cut branch", incision.cut(branch)), ("cut fault", incision.cut(fault)),
                     ("stitch branch", incision.stitch(branch)), ("undo", incision.undo())]:
    print(f"{step:13}: {len(change.opened):3} opened, {len(change.closed):3} closed, "
          f"{len(change.splits):3} splits, {len(change.merges):3} merges")

# %% The same scored facets give the same mesh, whatever the way to them
at_once = cleave.cut(cleave.meshio.cells_of(rock), np.concatenate([branch, fault]))
assert np.array_equal(incision.canonical[incision.cells], at_once.cells)

# %% A facet that cannot open says why: one facet inside has no vertex that separates its cells
alone = cleave.Incision(cleave.meshio.cells_of(rock))
for inside in fault:
    if len(alone.cut([inside]).opened) == 0:
        break
    alone.undo()
for because in alone.explain(int(inside)):
    print(f"around vertex {because.vertex} the cells {because.through} hold together")
