# $images = 7
# $n = 120
# $sigma_px = 0.1
demo-simulated = Simulated and calibrated: { $images } images of { $n } targets, noise { NUM($sigma_px, digits: 2) } px.

# $length_m = 2.0
# $sigma_mm = 0.02
# $c_mm = 24.5
# $error = 0.02
demo-given = Given: one scale bar ({ NUM($length_m, decimals: 4) } m, sigma { $sigma_mm } mm), c = { $c_mm } mm (error { PERCENT($error) } %).
    .why = Distortion, orientations and coordinates are not given.

# $length_m = 2.0
# $sigma_mm = 0.02
demo-scale_bar = Scale bar: { NUM($length_m, decimals: 4) } m, standard deviation { $sigma_mm } mm.

# $n = 8
# $ratio = 1.8
# $symbol = "P1"
demo-interior = Interior orientation: the { $n } parameters err by at most { NUM($ratio, digits: 2) } sigma ({ $symbol }).

# $kind = "targets"
# $rms_mm = 0.05
# $stated_mm = 0.05
demo-points = { $kind ->
        [targets] Targets
        *[other] Projection centres
    }: true error { NUM($rms_mm, digits: 2) } mm (rms), stated { NUM($stated_mm, digits: 2) } mm.
