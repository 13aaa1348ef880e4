# $camera = "d5100"
# $other = "d5100-2"
# $n = 4
# $photographs = 20
# $width_px = 3264
# $height_px = 4928
# $turned = true
# $reduced = false
# $chi_square = 4.2
# $dof = 5
# $turn_deg = 90
# $other_chi_square = 60.0
camera_joined = Camera { $camera }: { $n } of { $photographs } photographs ({ $width_px } x { $height_px } px) share its interior orientation.
    .why = They are { $turned ->
        [yes] stored turned by { $turn_deg }° clockwise (chi-square { NUM($chi_square, decimals: 1) } of { $dof }; { NUM($other_chi_square, decimals: 1) } for the other turn)
       *[no] of another size (chi-square { NUM($chi_square, decimals: 1) } of { $dof })
    }{ $reduced ->
        [yes] {" "}and reduced
       *[no] {""}
    }; camera { $other } was joined.

# $camera = "d5100"
# $other = "d5100-2"
# $n = 4
# $photographs = 20
# $width_px = 3264
# $height_px = 4928
# $turned = true
# $reduced = false
# $chi_square = 4.2
# $dof = 5
# $turn_deg = 90
# $other_chi_square = 6.0
camera_joined-doubtful = Camera { $camera }: the turn of { $n } of { $photographs } photographs ({ $width_px } x { $height_px } px) is ambiguous.
    .why = Assumed: stored turned by { $turn_deg }° clockwise{ $reduced ->
        [yes] {" "}and reduced
       *[no] {""}
    }, camera { $other } joined (chi-square { NUM($chi_square, decimals: 1) } of { $dof }; { NUM($other_chi_square, decimals: 1) } for the other turn, which would move the principal point).
    .do = Give the files as the camera stored them.

# $n = 4
# $others = 16
# $gain = 140.0
# $ids = ["a.jpg", "b.jpg"]
camera_joined-gimbal = { $n } { $n ->
        [one] photograph is
       *[other] photographs are
    } stored upside down beside the other { $others }: { LIST($ids, most: 3) }.
    .why = Their gimbal angles agree, and one camera fits better after a turn by 180° (chi-square smaller by { NUM($gain, decimals: 0) }).

# $n = 4
# $first = "a.jpg"
# $last = "d.jpg"
# $others = 16
# $gain = 140.0
camera_joined-half_turned = { $n } photographs ({ $first } to { $last }) are stored upside down beside the other { $others }.
    .why = After a turn by 180° the same camera fits all (chi-square smaller by { NUM($gain, decimals: 0) }); the photographs have no metadata to confirm it.
