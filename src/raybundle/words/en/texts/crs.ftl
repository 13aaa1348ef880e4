# $system = "EPSG:32633"
# $name = "none"
crs-without_effect = The coordinate system { $system } has no effect.
    .why = { $name ->
        [none] No positions of a grid are given
        *[other] { $name } states its own system
    }; no control file lacks a system; there is no satellite scene.
