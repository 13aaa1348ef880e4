# $name = "part.stl"
mesh-no_triangles = Mesh { $name } has no triangles.
    .do = Create a mesh from the point cloud, or give another file.

# $name = "part.stl"
# $vertex = 12
mesh-vertex_not_finite = Mesh { $name }: vertex { $vertex } has a coordinate that is not a finite number.
    .do = Correct the coordinate, or delete the vertex with its triangles.

# $name = "part.stl"
# $vertex = 120
# $n = 80
mesh-unknown_vertex = Mesh { $name }: a triangle refers to vertex { $vertex }, but there are { $n } vertices.
    .do = Correct this triangle, or add the missing vertices.

# $name = "part.stl"
mesh-no_area = Mesh { $name }: its triangles have no area.
    .do = Check the unit and the vertices of the mesh.

# $name = "part.stl"
mesh-nothing_to_measure = Mesh { $name }: every triangle is excluded from measurement.
    .do = Select at least one part that is to be measured.

# $detail = "unknown file type"
mesh-not_readable = The file cannot be read as a mesh ({ $detail }).
    .do = Give a mesh as STL, PLY or OBJ.

# $n = 8000000
# $most = 5000000
mesh-too_many_triangles = The mesh has { $n } triangles; at most { $most } are read.
    .do = Simplify it first.

# $extent_mm = 0.02
# $unit_m = 0.001
# $least_mm = 1.0
mesh-too_small = The mesh is { $extent_mm } mm large if its unit is { $unit_m } m; at least { $least_mm } mm are needed.
    .do = Give its unit; { OPTION("unit", 0.001) } is for millimetres.
