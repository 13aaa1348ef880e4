# $images = 24
# $points = 812
# $observations = 4210
# $name = "inside"
block-merged = Merged: { $images } images, { $points } points, { $observations } image observations (frame of { $name }).

# $block = "both"
block-adjust_merged = raybundle adjust { $block } { OPTION("reject", "snooping") } { OPTION("out", "RESULT") }

# $images = 24
# $points = 812
# $observations = 4210
# $formats = ["colmap"]
block-converted = Converted ({ $formats }): { $images } oriented images, { $points } points, { $observations } image observations.

# $largest_px = 0.03
block-cameras_fitted = Cameras are fitted: largest deviation { $largest_px } px.

# $n = 3
block-more_files = { $n } further { $n ->
        [one] file is
        *[other] files are
    } beside it.

# $images = 24
# $points = 812
# $observations = 4210
# $blunders = 3
block-simulated = Simulated: { $images } images, { $points } object points, { $observations } image observations, { $blunders } { $blunders ->
        [one] blunder
        *[other] blunders
    }.

# $origin = "A"
# $axis = "B"
block-transformed = Transformed: origin { $origin }, X axis through { $axis }.
