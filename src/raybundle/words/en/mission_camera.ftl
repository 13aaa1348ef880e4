# $camera = "phantom4"
# $entry = "interval_s"
# $value = 0.0
mission_camera-not_positive = Camera { $camera }: { $entry } is { $value }.
    .do = Give a value above 0.
