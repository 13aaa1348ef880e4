# $system = "EPSG:31467"
# $off_m = 1.2
scene_datum = { $system } has another datum than the scenes (WGS 84): { NUM($off_m, decimals: 2) } m at a distance of 10 km.
    .why = Coordinates were transformed to WGS 84 by the best transformation of PROJ without grids.
