# $columns = ["misfit", "relief"]
# $ids = ["misfit", "relief"]
relief_unknown = Tie points have no values in the columns { $columns }.
    .why = Their standard deviations do not contain the relief within the matching windows.
    .do = Use points.csv with all of its columns, or orient the photographs again.

relief_unknown-quick = Standard deviations of tie points do not contain the relief of the object ({ OPTION("precise", "False", flag: "quick") }).
    .why = On rough ground and in vegetation errors are up to three times as large, and one in five exceeds five standard deviations.
    .do = Orient without this option for figures that are handed over.
