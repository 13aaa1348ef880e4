# $family = "aicon14"
# $ids_missing = [900]
# $n = 516
# $first = 1
# $last = 516
target-no_such_id = Target family { $family } has no id { $ids_missing }.
    .why = Its { $n } ids are between { $first } and { $last }.
    .do = Use ids of this family.

# $name = "'aicon13'"
# $known = ["agisoft12", "aicon14"]
target-unknown_ring_family = Target family { $name } is unknown.
    .do = Use one of { LIST($known, most: 30) }.

# $kind = "float64"
# $shape = [100, 200, 3]
target-image_type = Targets cannot be detected in an image of type { $kind } and shape ({ $shape }).
    .do = Give a grey image of 8 or 16 bits.

# $name = "'aruco-4x4_60'"
# $near = ["aruco-4x4_50"]
# $n = 1
# $known = ["apriltag-36h11", "aruco-4x4_50"]
target-unknown_tags = Tags { $name } are unknown.
    .do = { $n ->
        [0] Use
       *[other] Check whether { $near } is meant, or use
     } one of { LIST($known, most: 30) }.

# $name = "'aicon15'"
# $near = ["aicon14"]
# $n = 1
# $known = ["agisoft12", "aicon14"]
target-unknown_family = Target family { $name } is unknown.
    .do = { $n ->
        [0] Use
       *[other] Check whether { $near } is meant, or use
     } one of { LIST($known, most: 30) }.

# $family = "aicon14"
# $n = 516
# $wanted = 600
target-too_few_codes = Target family { $family } has { $n } targets; { $wanted } are requested.
    .do = Request fewer targets, or use a larger family.

# $sheet = true
target-table_settings = { OPTION("table") } and { OPTION("bits") } define targets of your own; one is missing, or others are named.
    .do = Give both, without { OPTION("target") }{ $sheet ->
        [yes] { " " }and { OPTION("sheet") }
       *[no] { "" }
     }.

# $name = "bench"
target-needs_photographs = { OPTION("target") } and { OPTION("dots") } belong to photographs; { $name } is a result.
    .do = Leave them out.

# $known = ["agisoft12", "aicon14"]
target-family_missing = The family of the targets is not named.
    .why = Families use the same rings with different numbers.
    .do = Give { OPTION("target", "FAMILY") } ({ LIST($known, most: 40) }), or { OPTION("table", "FILE") } and { OPTION("bits", "N") }.

# $text = "1,a"
# $word = "'a'"
target-code_form = { OPTION("codes", $text) }: { $word } is neither a number nor a range.
    .do = Write a range as 7-12.

# $word = "'1-99999999'"
# $most = 100000
target-code_range = { OPTION("codes") }: { $word } is more than the { $most } possible targets.
    .do = Choose a smaller range.

# $text = "1,1"
target-code_twice = { OPTION("codes", $text) }: a number occurs twice, or a range runs downwards.
    .do = Correct the list.

# $names = ["rings12"]
target-family_twice = Target families given twice: { $names }.
    .do = Give each family once.

# $photographs = 4
# $best = "aicon14"
target-family_ambiguous = The targets in { $photographs } photographs fit several families; codes and ring widths do not decide.
    .do = Name the printed family: { OPTION("target", $best) }.

# $family = "aicon14"
# $n = 40
target-family_points = Target family { $family }: { $n } points detected.

# $board = "raster"
# $names = ["circles-7x5", "circles-6x5"]
# $photographs = 4
# $families = ["aicon12", "aicon14"]
target-board_ambiguous = { $board ->
        [raster] A raster of dots
       *[chessboard] A chessboard
    } is visible, but its size is ambiguous: { $names }.
    .why = It must be complete and look alike in most of { $photographs } photographs. Tested too: { LIST($families, most: 30) }, AprilTag, ArUco, ChArUco.
    .do = Name the board: { $board ->
        [raster] { OPTION("target", "circles-7x5") }, or acircles-4x11 if staggered
       *[chessboard] { OPTION("target", "chessboard-9x6") }, by its inner corners
    }.
