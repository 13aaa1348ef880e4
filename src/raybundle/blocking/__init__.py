"""Helmert's blocking: a network cut into parts that are reduced one by one, exactly (Helmert 1880; Wolf 1978).

graph      which unknowns meet in an observation
tree       parts and the separators between them, by nested dissection
skeleton   what all parts share: unknowns, observations outside the images
part       the sub-network of one tree node, as the kernels take it
front      its dense normal equations: elimination, solution, cofactors
sweeps     up and down the tree, a task for each node of it
fields     noise fields of a part; `fields_in_parts` adds them up
normals    what the iteration takes for normal equations
adjusted   the adjustment of a block that lies in memory
stored     that of columns whose parts lie in a store
deciding   blunders and parameters there
"""
