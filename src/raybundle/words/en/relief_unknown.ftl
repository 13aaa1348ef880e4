# $columns = ["misfit", "relief"]
# $ids = ["misfit", "relief"]
relief_unknown = Tie points have no values in the columns { $columns }.
    .why = Their standard deviations do not contain the relief within the matching windows.
    .do = Use points.csv with all of its columns, or orient the photographs again.
