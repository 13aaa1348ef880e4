# $source = "ins.csv"
# $angle_deg = 90.0
# $quarter = true
# $alike = false
attitudes_mount = The camera is rotated by { NUM($angle_deg, decimals: 0) }°{ $quarter ->
     [yes] { "" } about its viewing direction
     *[no] { "" }
    } against the attitudes of { $source ->
     [gimbal] the gimbal
     *[other] { $source }
    }.
    .why = This is taken as its mounting{ $alike ->
     [yes] ; all headings are alike, so a wrong yaw would look the same
     *[no] { "" }
    }.
    .do = { $alike ->
     [yes] Check the yaw angles.
     *[no] { "" }
    }
