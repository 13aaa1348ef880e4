# $width_m = 12.0
# $height_m = 8.0
object_size-flat = { NUM($width_m, digits: 5) } x { NUM($height_m, digits: 5) } m

# $width_m = 4.0
# $depth_m = 3.0
# $height_m = 2.5
# $corners = 6
object_size-building = { NUM($width_m, digits: 5) } x { NUM($depth_m, digits: 5) } x { NUM($height_m, digits: 5) } m{ $corners ->
        [4] {""}
        *[other] , { $corners } corners
    }

# $diameter_m = 3.0
# $height_m = 4.0
object_size-cylinder = { NUM($diameter_m, digits: 5) } m across, { NUM($height_m, digits: 5) } m high

# $length_m = 60.0
# $width_m = 8.0
object_size-corridor = { NUM($length_m, digits: 5) } m long, { NUM($width_m, digits: 5) } m wide

# $width_m = 120.0
# $length_m = 80.0
# $cell_m = 0.5
object_size-heights = { NUM($width_m, digits: 5) } x { NUM($length_m, digits: 5) } m, cells of { NUM($cell_m) } m

# $n = 812
# $width_m = 12.3
# $length_m = 4.5
object_size-points = of { $n } points, { NUM($width_m) } x { NUM($length_m) } m

# $x_m = 2.0
# $y_m = 1.0
# $z_m = 1.5
# $n = 12
object_size-mesh = { NUM($x_m, digits: 4) } x { NUM($y_m, digits: 4) } x { NUM($z_m, digits: 4) } m, { $n } triangles

# $size = "12 x 8 m"
object_size-free_scale = { $size }, of an arbitrary scale
