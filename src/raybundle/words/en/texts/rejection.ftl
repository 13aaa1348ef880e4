# $kind = "blunder"
# $axis = "x"
# $tau = 5.24
# $limit = 4.2
rejection-reason = { $kind ->
        [blunder] blunder
        [blunder_not_located] blunder in one of the point's rays
        [behind_camera] behind the camera
        [rays_diverge] rays diverge
        [single_ray] single ray left
        [residual] residual
        *[given] given as rejected
    }{ $axis ->
        [none] {""}
        *[other] : tau { NUM($tau, decimals: 2) } > { NUM($limit, decimals: 2) } in { $axis }
    }
