# $n = 40
# $needed = 100
old_heights-too_few = The alignment needs { $needed } cells that have not moved; there are { $n }.
    .do = Give a larger area with { OPTION("stable", "FILE") }, or another model.

# $shift = [120.0, -40.0]
# $cell = 0.5
old_heights-not_converged = The other model cannot be aligned: its shift in plan is beyond reach ({ LIST($shift, most: 2) }).
    .why = Slopes show shifts of some cells of { $cell }.
    .do = Check its coordinate system, or give an area that has not moved with { OPTION("stable", "FILE") }.

old_heights-not_determined = The stable area does not determine shift and tilts of the other model.
    .why = It lies along a line, or is even.
    .do = Give an area with slopes in several directions with { OPTION("stable", "FILE") }.

# $direction_deg = 35.0
# $sigma = 0.8
# $limit = 0.5
old_heights-plan_undetermined = The stable area does not determine the shift in plan towards { NUM($direction_deg, digits: 3) }°: sigma { NUM($sigma, digits: 2) } (limit { NUM($limit, digits: 2) }).
    .why = The angle is clockwise from up. Only slopes along it show this shift; the limit is a cell.
    .do = Give an area with such slopes with { OPTION("stable", "FILE") }.

old_heights-no_map = A model without photographs needs a surface in a map in metres.
    .do = Compute the surface with a coordinate system (raybundle surface, control or positions with one).

old_heights-not_needed = { OPTION("stable", "FILE") } is for a model without photographs.
    .why = Two surfaces lie in the frame of their control.

# $missing = 1200
# $total = 19200
old_heights-cloud_cut_off = The point cloud is cut off: { $missing } of { $total } points are missing.
    .do = Copy the file again.

old_heights-ambiguous = Two alignments of the other model fit equally well: what is stable is not certain.
    .why = Nearly half moved alike.
    .do = Give the stable area with { OPTION("stable", "FILE") }.

# $share = 0.58
# $limit = 0.65
# $moved = 0.45
old_heights-narrow = The alignment rests on { PERCENT($share) } % of the common heights (limit { PERCENT($limit) } %).
    .why = It holds only if what moved alike is less than { PERCENT($moved) } %.
    .do = Give the stable area with { OPTION("stable", "FILE") }.

# $up = 150.2
# $limit = 110.0
old_heights-far = The other model lies { NUM($up, digits: 4) } m off in height (limit { NUM($limit, digits: 3) } m).
    .why = Vertical datums differ by less.
    .do = Check unit and vertical datum of both.

# $ratio = 3.28
# $feet = "yes"
old_heights-other_unit = The other model has another unit: its height differences are { NUM($ratio, digits: 3) } times those of the surface.
    .why = { $feet ->
        [yes] A metre has 3.28 feet.
       *[other] A foot has 0.305 metres.
     }
    .do = Give the model in the unit of the surface.

old_heights-whole_units = The heights of the other model are rounded to whole units.
    .why = Rounded heights do not determine slopes and the shift in plan.
    .do = Give the model with decimals.
