# $stage = "depth_maps"
# $name = "depth maps"
progress-stage = { $name }

# $stage = "depth maps"
# $share = 0.4
# $left = 2.5
progress-line = { $stage }: { PERCENT($share) } %{ $left ->
        [0] {""}
       *[other] , { NUM($left, digits: 2) } min left
    }
