surface_drawing-line_or_area = Corners of a line or of an area are needed, not of both.
    .do = Give { OPTION("line", flag: "x") } or { OPTION("area", flag: "x") }.

# $n = 2
# $surface = "surface"
surface_drawing-none = Nothing is drawn on { $surface }.
    .why = { $n ->
        [0] The project has no drawings.
       *[other] { $n } drawings are on other surfaces or layers.
     }
    .do = Draw in the studio (Products, Plan), or with raybundle mark draw.

# $n = 2
# $names = ["edge", "pile"]
surface_drawing-no_heights = The surface has no height at any corner of { LIST($names, most: 5) }.
    .do = Draw within the surface, or fill holes with { OPTION("fill", "WIDTH") }.

# $names = ["walls"]
# $known = ["lines", "breaklines"]
surface_drawing-no_layer = No drawing is on layer { LIST($names, most: 5) }.
    .why = Layers are: { LIST($known, most: 10) }.
    .do = Use one of these names.

# $n = 3
# $layers = ["lines", "breaklines"]
surface_drawing-written = { $n } { $n ->
        [one] drawing
       *[other] drawings
    } on { LIST($layers, most: 5) }.

# $n = 2
surface_drawing-others = { $n } { $n ->
        [one] drawing is
       *[other] drawings are
    } on other surfaces or layers.

# $n = 1
# $names = ["edge"]
surface_drawing-heights_between = Corners without a height in { LIST($names, most: 5) }.
    .why = Their heights follow from the corners beside them.
    .do = Fill holes with { OPTION("fill", "WIDTH") }.

# $n = 1
# $names = ["edge"]
surface_drawing-left_out = Without any height, left out: { LIST($names, most: 5) }.
    .do = Draw within the surface.
