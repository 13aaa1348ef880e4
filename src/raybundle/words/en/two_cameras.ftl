# $camera = "d5100"
# $other = "d5100-2"
# $n = 12
# $others = 20
# $by = "names"
# $name = "DSC"
# $dc_px = -14.2
# $dx0_px = 2.1
# $dy0_px = -3.0
two_cameras = Camera { $camera }: { $n } and { $others } photographs have different interior orientations.
    .why = c differs by { NUM($dc_px, decimals: 1) } px, the principal point by { NUM($dx0_px, decimals: 1) }, { NUM($dy0_px, decimals: 1) } px; { $by ->
        [names] photographs not named { $name }...
        [order] photographs after { $name }
       *[values] the second group
    } became camera { $other }.
    .do = If these are two cameras, or zoom or focus changed, state it: { OPTION("own_camera", "PATTERN") }.
