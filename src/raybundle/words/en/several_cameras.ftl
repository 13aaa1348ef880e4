# $camera = "d5100"
# $photographs = 20
# $cameras = 2
# $symbol = "c"
# $spread_px = 12.0
# $scatter_px = 1.1
# $p = 1e-08
# $ids = ["d5100", "d5100-2"]
several_cameras = Camera { $camera }: its { $photographs } photographs belong to { $cameras } different cameras, zooms or focus settings.
    .why = { $symbol } differs by { NUM($spread_px, digits: 2) } px, within a group by { NUM($scatter_px, digits: 2) } px (p { NUM($p, digits: 1) }); standard deviations are too small.
    .do = Orient again with:

# $pattern = "IMG_1|IMG_2"
several_cameras-own = { OPTION("own_camera", $pattern) }
