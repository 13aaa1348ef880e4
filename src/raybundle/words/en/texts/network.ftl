# $n = 8
# $object = "facade 6 x 4 m"
# $aim = "worst"
# $reached = "0.32 mm"
# $wanted = "0.30 mm"
# $target = "missed"
network-stations = { $n } { $n ->
        [one] photograph
        *[other] photographs
    } of { $object }: { $aim ->
        [calibration] uncertainty of projection
        [reliability] least redundancy number
        [mean] mean sigma
        *[worst] worst sigma
    } { $reached }{ $target ->
        [none] {""}
        [met] {" "}(wanted { $wanted })
        *[missed] {" "}(wanted { $wanted }, not reached)
    }.

# $mean = "0.20 mm"
# $worst = "0.32 mm"
# $coordinate = "0.25 mm"
network-precision = Predicted sigma: mean { $mean }, worst { $worst }, largest of a coordinate { $coordinate }.

# $share = 0.97
# $median = "0.22 mm"
# $largest = "0.60 mm"
# $known = false
network-object = Object seen twice or more: { PERCENT($share) } %, sigma median { $median }, largest { $largest }{ $known ->
        [yes] {" "}(with what is known)
        *[no] {""}
    }.

# $base_to_depth = 0.42
# $rays = 4.2
# $scale = 250.0
# $q = 0.7
# $sigma_px = 0.2
network-geometry = B/D { NUM($base_to_depth, decimals: 2) }, rays { NUM($rays, decimals: 1) }, image scale 1 : { NUM($scale, decimals: 0) }, q { NUM($q, decimals: 2) }, image sigma { $sigma_px } px.

# $minutes = 12.0
# $path_m = 80.0
network-effort = On site: { NUM($minutes, decimals: 0) } min, { NUM($path_m, decimals: 0) } m to walk.

# $near_m = 2.1
# $far_m = 0.0
network-sharp = Sharp from { $near_m } m to { $far_m ->
        [0] infinity
        *[other] { $far_m } m
    }.

# $n = 2
# $again = true
# $known = true
# $before = "0.4 mm"
# $after = "0.3 mm"
# $share = 0.02
network-added = Added: { $n } { $n ->
        [one] photograph
        *[other] photographs
    } { $again ->
        [yes] from existing stations
        *[no] for all of the visible surface
    }{ $known ->
        [yes] : { $before } to { $after }
        *[no] {""}
    }; { PERCENT($share) } % stay above the required sigma.

# $control = 4
# $bars = 1
# $lengths_m = [1.5]
# $worst = "0.4 mm"
# $mean = "0.2 mm"
network-known = With { $control } control points and { $bars } scale bars{ $bars ->
        [0] {""}
        *[other] {" "}({ $lengths_m } m)
    }: worst { $worst }, mean { $mean }.

# $parameters = ["c 0.2 px", "x0 0.1 px"]
# $known = true
# $worst_px = 0.3
network-calibrated = Calibrated with it: { $parameters }{ $known ->
        [yes] ; image points to { NUM($worst_px, digits: 2) } px at worst
        *[no] {""}
    }.

# $folder = "plan"
network-next = Open { $folder }/network.html; stations.csv lists the stations.

# $n = 12
network-listed = Listed: { $n } { $n ->
        [one] photograph
        *[other] photographs
    }.

# $folder = "house"
network-next_list = Print { $folder }/list.pdf.

# $judged = 120
# $reached = 300
network-judged = { $judged } of { $reached } candidates within reach show enough.

# $goal = "largest sigma"
# $before = "0.4 mm"
# $after = "0.3 mm"
# $n = 2
network-lowered = { $goal }: { $before } now, { $after } with { $n } { $n ->
        [one] photograph
        *[other] photographs
    }.

# $parameters = ["P1"]
network-freed = With it, the block determines { $parameters }.

# $n = 2
# $file_name = "next.csv"
network-more_proposals = { $n } further { $n ->
        [one] proposal
        *[other] proposals
    }: { $file_name }.

# $name = "next-1"
# $text = "2 m to the left of IMG_3."
network-proposal = { $name }: { $text }
