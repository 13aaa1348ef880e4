# $camera = "d5100"
plot-cell_means = camera { $camera }: means of cells

# $camera = "d5100"
plot-none_of_camera = no image point of camera { $camera } has one

# $mean = 0.612
# $smallest = 0.08
plot-mean_and_smallest = mean { NUM($mean, decimals: 3) } (line), smallest { NUM($smallest, decimals: 3) }

# $median_px = 0.42
# $largest_px = 3.1
plot-median_and_largest = median { NUM($median_px, digits: 2) } px (line), largest { NUM($largest_px, digits: 2) } px

# $n = 12
# $limit = 0.01
plot-not_counted = { $n } with r below { $limit } not counted

# $camera = "d5100"
# $n = 1500
# $of = 4000
plot-residuals = camera { $camera }: { $n } of { $of } residuals

# $n = 3
# $of = 40
plot-means_from_zero = means of cells; { $of ->
        [0] too few points
        *[other] { $n } of { $of } differ from zero (bold)
    }

plot-no_sigma = no residual has a standard deviation

# $n = 8000
plot-coordinates = { $n } coordinates

plot-normal = normal

# $rms = 1.02
# $n = 9
# $expected = 8.1
plot-beyond = rms { NUM($rms, decimals: 2) }; { $n } beyond ±3.29 ({ NUM($expected, digits: 2) } expected)

plot-radial = radial correction, ideal − measured

plot-decentring = decentring, largest over directions

plot-decentring_curve = decentring

plot-correction_sigma = standard deviation of the corrections

# $times = 20.0
# $largest_px = 12.3
plot-corrections = corrections, { $times ->
        [1] true size
        *[other] times { $times }
    }; largest { NUM($largest_px) } px

# $distance = 3.2
# $unit = "m"
# $largest_px = 0.42
plot-projection = uncertainty of projection at { $distance ->
        [0] infinity
        *[other] { NUM($distance, digits: 2) } { $unit ->
            [units] units
            *[other] { $unit }
        }
    }; largest { NUM($largest_px, digits: 2) } px

# $images = 40
# $points = 1200
# $far = 3
plot-network = { $images } { $images ->
        [one] image
        *[other] images
    }, { $points } object { $points ->
        [one] point
        *[other] points
    }{ $far ->
        [0] {""}
        *[other] {" "}({ $far } far ones outside)
    }

# $n = 50
# $times = 1000.0
plot-ellipses = error ellipses of { $n } points, one sigma, enlarged { NUM($times, digits: 6) } times

plot-error_ellipses = error ellipses

plot-differences_in_plan = differences in plan

plot-in_order_of_names = points in the order of their names
