# $n = 3
# $names = ["points", "images", "check"]
workbook-written = Workbook: { $n } { $n ->
        [one] sheet
        *[other] sheets
    } ({ $names }).
