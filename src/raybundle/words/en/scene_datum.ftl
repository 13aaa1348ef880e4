# $system = "EPSG:31467"
# $off_m = 1.2
scene_datum = { $system } has another datum than the scenes (WGS 84): { NUM($off_m, decimals: 2) } m at a distance of 10 km.
    .why = Coordinates were transformed to WGS 84 without grids; the accuracy of this transformation limits the absolute position.
    .do = For a better position, first transform the control to WGS 84 with the official grid.
