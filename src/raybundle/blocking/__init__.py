"""Helmert's blocking: a network cut into parts that are reduced one by one, exactly (Helmert 1880; Wolf 1978).

graph             which unknowns meet in an observation
tree              parts and the separators between them, by nested dissection
cutting           where a network is cut, by its incidences alone
skeleton          what all parts share: unknowns, observations outside the images
part              the sub-network of one tree node, as the kernels take it
columns           a block as columns that are read a piece at a time
network           a network that is cut
front             the dense normal equations of a node: elimination, solution, cofactors
sweeps            up and down the tree, a task for each node of it; `tasks` names them for other processes
answers           counts, datum, observations and points of a part; `similarity` within an open datum
fields            noise fields of a part; `fields_in_parts` adds them up
normals           what the iteration takes for normal equations; `normals_in_parts` in place of those in one piece
network_in_memory a network in parts that lies in memory; `memory` keeps its products
network_store     a network whose parts lie in a store; `stored` adjusts it, `decision` rejects and chooses there
store             where the tasks keep their products
"""
