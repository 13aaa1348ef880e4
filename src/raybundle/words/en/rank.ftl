rank-not_determined = The observations do not determine all unknowns.
    .why = No standard deviation can be given.
    .do = Add observations or control, or hold the undetermined parameters.

# $n = 1
rank-no_observation = { $n } { $n ->
        [one] unknown has
       *[other] unknowns have
     } no observation.
    .do = Give these unknowns a sigma or a smoothness, or measure points there.

# $n = 2
# $points = ["P1", "P2"]
rank-parallel_rays = The rays to { $n } object { $n ->
        [one] point
       *[other] points
     } are parallel or coincide: { LIST($points, most: 10) }.
    .do = Measure them from another station.

# $n = 2
# $parameter = "scale"
rank-undetermined_together = The observations do not determine these unknowns together:
    .do = { $parameter ->
        [scale] Hold c (leave it out of `estimate`), or add convergent images or points at different depths.
        [principal_point] Hold the principal point, or add images rolled by 90°.
        [radial] Hold this parameter, or measure points up to the corners of the format.
        [decentring] Hold this parameter, or add images rolled by 90°.
        [affinity] Hold this parameter, or add images rolled by 90°.
        [harmonic] Hold this parameter, or measure points up to the edges of the format in images rolled by 90°.
        [read_out] Hold this parameter, or give the motion of the images (`per_image`) as held or observed values.
        [none] Add points or control there, or leave the images out.
       *[other] Hold this parameter.
     }

# $kind = "parameter"
# $name = "d5100"
# $symbol = "c"
# $image = ""
# $share = 0.5
rank-share = Share { PERCENT($share) } %: { $kind ->
        [parameter] parameter { $symbol } of camera { $name } { $image }
        [image] exterior orientation of image { $name }
        [point] point { $name }
        *[other] { $name }
    }
