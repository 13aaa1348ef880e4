# $n = 14
# $observations = 5871
rejected = { $n } of { $observations } image observations were rejected.

# $n = 14
# $kind = "blunder"
rejected-kind = { $kind ->
        [blunder] Blunders
        [blunder_not_located] Blunders in one of a point's rays
        [behind_camera] Points behind the camera
        [rays_diverge] Diverging rays
        [single_ray] Points with a single ray left
        [residual] Large residuals
       *[given] Left out as given
     }: { $n }
