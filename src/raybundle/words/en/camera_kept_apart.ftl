# $camera = "d5100"
# $other = "d5100-2"
# $n = 4
# $photographs = 20
# $width_px = 3264
# $height_px = 4928
# $turned = true
# $reduced = false
camera_kept_apart-not_adjusted = Camera { $camera }: { $n } of { $photographs } photographs ({ $width_px } x { $height_px } px) could not be adjusted with the others.
    .why = They are { $turned ->
        [yes] stored turned
       *[no] of another size
    }{ $reduced ->
        [yes] {" "}and reduced
       *[no] {""}
    }, and are camera { $other } now.
    .do = Give the files as the camera stored them.

# $camera = "d5100"
# $other = "d5100-2"
# $n = 4
# $photographs = 20
# $width_px = 3264
# $height_px = 4928
# $turned = true
# $reduced = false
# $chi_square = 140.2
# $dof = 5
camera_kept_apart = Camera { $camera }: { $n } of { $photographs } photographs ({ $width_px } x { $height_px } px) have another interior orientation.
    .why = They are { $turned ->
        [yes] stored turned
       *[no] of another size
    }{ $reduced ->
        [yes] {" "}and reduced
       *[no] {""}
    }; focus, zoom or crop changed (chi-square { NUM($chi_square, decimals: 1) } of { $dof }). They are camera { $other } now.
    .do = Give the files as the camera stored them.
