# $name = "sphere"
# $needs = "DIAMETER"
object-takes_no_line = Object { $name } takes no line of points.
    .do = Give { $needs }.

# $name = "box"
# $n = 2
# $needs = "LENGTH, WIDTH, HEIGHT"
object-number_count = Object { $name }: { $n } numbers are given.
    .do = Give { $needs }.

# $name = "sphere"
# $dimension = "diameter"
# $value_m = -1.0
# $largest_m = 1000000.0
object-dimension_out_of_range = Object { $name }: { $dimension } is { $value_m } m.
    .do = Give a value above 0 and at most { $largest_m } m.

# $text = "tower.xyz"
# $kinds = ["box:1,2,3", "sphere:1"]
# $meshes = [".obj", ".ply"]
# $rasters = [".tif"]
object-unknown = Object { $text } is neither a kind of object nor a file or folder of one.
    .do = Give a kind ({ LIST($kinds, most: 20) }), a mesh ({ LIST($meshes, most: 9) }), a height grid ({ LIST($rasters, most: 9) }) or a result folder.

# $text = "box:a"
# $name = "box"
# $needs = "LENGTH, WIDTH, HEIGHT"
# $example = "box:1,2,3"
object-number_form = Object { $text }: { $name } needs numbers with commas between them.
    .do = Give { $needs }, for example { $example }.
