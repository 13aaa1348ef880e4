# $n = 3
# $names = ["points", "images", "check"]
workbook-written = Workbook: { $n } { $n ->
        [one] sheet
        *[other] sheets
    } ({ $names }).

# $name = "points.csv"
# $cause = "rows"
# $rows = 1048575
workbook-left_out = { $name } { $cause ->
        [parquet] is stored as Parquet, because it is too long for a sheet.
        [empty] has no rows.
        *[rows] has more rows than a sheet holds ({ $rows }).
    }
