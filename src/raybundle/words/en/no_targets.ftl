# $n = 3
# $names = ["a.jpg", "b.jpg", "c.jpg"]
no_targets = Calibrated by natural points: { $n } tested photographs show no coded targets and no board.
    .why = Natural points are several times less precise. Tested: { $names }.
    .do = If others show targets, put them into a folder of their own and name the targets: { OPTION("target", "chessboard-12x9") }.

# $n = 3
# $names = ["a.jpg", "b.jpg", "c.jpg"]
# $families = ["aicon14"]
# $first = "aicon14"
no_targets-few = Calibrated by natural points: fewer than half of { $n } tested photographs show targets ({ $families }).
    .why = Natural points are several times less precise. Tested: { $names }.
    .do = Put the photographs of targets into a folder of their own, or name the targets: { OPTION("target", $first) }.

# $families = ["aicon14"]
no_targets-unread = No target of { $families } was read in any photograph.
    .do = Check the name of the family and the size of the targets in the images.
