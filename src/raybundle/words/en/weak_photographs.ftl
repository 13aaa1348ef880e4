# $weak = 2
# $photographs = 40
# $common = 20
# $ids = ["IMG_1", "IMG_2"]
weak_photographs = { $weak } of { $photographs } photographs share { $common } points with fewer than two others: { $ids }.
    .why = Their orientation depends on one connection or on few points.
    .do = Add photographs from positions between theirs and the next.
