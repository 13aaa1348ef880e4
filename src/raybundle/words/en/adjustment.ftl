# $camera = "d5100"
# $model = "fisheye"
adjustment-corrected_residuals = Camera { $camera }: corrected residuals are defined for the model brown only, not for { $model }.
    .do = Use residuals = "measured".

adjustment-no_point = No object point takes part in the adjustment.
    .why = All points lie behind the cameras that measure them, or have no ray.
    .do = Check the given orientations and the sign and unit of the camera constant, or leave the orientations out.

# $type = "dict"
adjustment-options_type = The options are of type { $type }, not AdjustmentOptions.
    .do = Give AdjustmentOptions(...).

# $type = "str"
adjustment-block_type = The block is of type { $type }, not Block.
    .do = Read one with raybundle.read_block(path).

# $name = "datum"
# $given = "'best'"
# $known = ["auto", "inner"]
adjustment-option_choice = Option { $name } is { $given }.
    .do = Use one of { LIST($known, most: 12) }.

# $name = "statistics"
# $given = "'yes'"
adjustment-option_not_bool = Option { $name } is { $given }; it must be True or False.
    .do = Give { $name }=True or { $name }=False.

# $name = "hold"
# $given = "'c'"
# $pairs = true
adjustment-option_not_names = Option { $name } is { $given }; it must be a tuple of { $pairs ->
        [yes] pairs of names
       *[no] names
     }.
    .do = Give, for example, { $name }={ $pairs ->
            [yes] (("d5100", "c"),)
            *[no] ("P1", "P2")
        }.

# $name = "jobs"
# $given = "-1"
# $whole = true
# $low = 0.0
# $high = 4096.0
adjustment-option_range = Option { $name } is { $given }; it must be a { $whole ->
        [yes] whole number
       *[no] number
     } from { $low } to { $high }.
    .do = Give { $name } a number within these limits.

adjustment-no_statistics = This result has no normal equations.
    .why = It was adjusted without statistics, or it is a copy of a result.
    .do = Use the original result, or adjust with AdjustmentOptions(statistics=True).

adjustment-groups_without_statistics = Variance factors of groups need redundancy numbers.
    .do = Adjust with statistics=True.

# $block = "facade"
# $n = 120
adjustment-all_rejected = Block { $block }: all { $n } image observations are rejected.
    .do = Check whether observations.csv names the images and points of this block.

# $block = "facade"
adjustment-no_observation = Block { $block } has no image observations.
    .do = Check whether observations.csv names the images and points of this block.

# $n = 10
# $unknowns = 12
# $missing = 2
# $parameters = ["c (d5100)"]
# $free = 1
adjustment-too_few_observations = { $n } observations do not determine { $unknowns } unknowns; { $missing } are missing.
    .why = Standard deviations need even more.
    .do = { $free ->
        [0] Measure more points in more images, or give control.
       *[other] Hold some of { LIST($parameters, most: 10) }, measure more points in more images, or give control.
     }

# $share = 0.12
# $limit = 0.05
adjustment-image_points_contradict = The image points contradict each other by { PERCENT($share) } % of the diagonal (limit { PERCENT($limit) } %).
    .why = That is the median deviation from the best solution found.
    .do = Check point and image names, unit and origin of image coordinates, the camera constant and the control.

# $iterations = 3
adjustment-not_finite = No convergence: after { $iterations } iterations the normal equations are not finite.
    .why = Image points, coordinates or approximate values are too large.
    .do = Check units and decimal points.

# $iterations = 50
# $step_sigmas = 12.5
adjustment-no_convergence = No convergence after { $iterations } iterations (last step { NUM($step_sigmas, digits: 2) } standard deviations).
    .why = Blunders or poor approximate values are the usual cause.
    .do = Use { OPTION("robust_start", "True") } with { OPTION("reject", "snooping") }, and check names of marks and approximate values.

# $pairs = 1
adjustment-identical_images = No convergence: { $pairs } { $pairs ->
        [one] pair of images has
       *[other] pairs of images have
    } the same image points within half a pixel.
    .why = They are the same photograph twice, or have no base between them.
    .do = Exclude one image of each pair.

adjustment-out_missing = Nothing states where the result goes: this is no project.
    .do = Give a folder: { OPTION("out") }.
