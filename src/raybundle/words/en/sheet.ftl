# $name = "'A9'"
# $known = ["A4", "A3"]
sheet-unknown_paper = Paper { $name } is unknown.
    .do = Use one of { LIST($known, most: 20) }.

# $radius_mm = 0.0
sheet-dot_radius_not_positive = The radius of the dots is { $radius_mm } mm.
    .do = Give a radius above 0: { OPTION("dot_radius") }.

# $radius_mm = 40.0
# $side_mm = 320.0
# $paper = "A4"
# $width_mm = 210.0
# $height_mm = 297.0
# $most_mm = 23.4
sheet-target_too_large = A target with a dot of { $radius_mm } mm radius ({ $side_mm } mm) does not fit on { $paper }.
    .why = The paper has { $width_mm } x { $height_mm } mm.
    .do = Use a radius of at most { NUM($most_mm, decimals: 1) } mm ({ OPTION("dot_radius") }), or a larger paper.

# $spacing_mm = 0.0
sheet-spacing_not_positive = The spacing of the board is { $spacing_mm } mm.
    .do = Give a spacing above 0: { OPTION("spacing") }.

# $board = "chessboard-9x6"
# $spacing_mm = 40.0
# $width_mm = 400.0
# $height_mm = 280.0
# $paper = "A4"
# $room_width_mm = 190.0
# $room_height_mm = 260.0
# $most_mm = 19.0
sheet-board_too_large = { $board } of { $spacing_mm } mm needs { $width_mm } x { $height_mm } mm; { $paper } has { $room_width_mm } x { $room_height_mm } mm.
    .do = Use a spacing of at most { NUM($most_mm, decimals: 1) } mm, a larger paper, or { OPTION("lying", "True") }.

# $side_mm = 0.0
sheet-side_not_positive = The side of a tag is { $side_mm } mm.
    .do = Give a side above 0.

# $family = "apriltag-36h11"
# $tag = 700
# $last = 586
sheet-no_such_tag = { $family } has no tag { $tag }.
    .do = Use numbers from 0 to { $last }.

# $side_mm = 300.0
# $paper = "A4"
sheet-tag_too_large = A tag of { $side_mm } mm with its light border does not fit on { $paper }.
    .do = Use a smaller side or a larger paper.

# $radius_mm = 8.0
# $spacing_mm = 15.0
# $most_mm = 5.8
sheet-dots_too_large = Dots of { $radius_mm } mm radius are too large for a spacing of { $spacing_mm } mm.
    .why = They need a gap between them.
    .do = Use a radius of at most { NUM($most_mm, decimals: 1) } mm: { OPTION("dot_radius") }.

# $paper = "A4"
# $most = 80
# $spacing_mm = 20.0
# $n = 100
sheet-too_many_dots = { $paper } has space for { $most } dots at a spacing of { $spacing_mm } mm; { $n } are requested.
    .do = Use a smaller spacing or a larger paper.

sheet-boards_are_dark = Boards and square tags can be printed dark on light only.
    .do = Remove { OPTION("polarity", "light") }.

# $family = "custom"
sheet-not_printable = { $family } cannot be printed.
    .do = Use a board, tags or rings.

# $ending = ".png"
sheet-file_type = A sheet cannot be written in the format of this name (ending "{ $ending }").
    .do = Use .pdf or .svg.

# $factor = 1.08
sheet-print_factor = The print is { NUM($factor, decimals: 3) } times its design (limits 0.95 and 1.05).
    .do = Measure the scale bar of the sheet again.

sheet-no_sidecar = This is not the file of a sheet of targets: family or [[pages]] is missing.
    .do = Give the .toml file that was written with the sheet.

# $name = "'12'"
sheet-target_twice = Target { $name } occurs twice.
    .do = Delete one of the two entries.

# $radii = "[5.0, 15.0]"
# $radius_mm = 5.0
sheet-ring_radii = Rings of { $radii } mm are not possible with a dot of { $radius_mm } mm radius.
    .do = Correct ring_radii_mm or dot_radius_mm.

# $name = "'A'"
sheet-name_no_number = Target { $name } of a table of own codes has a name that is not a number.
    .do = Rename it to its id.

sheet-same_ring = Two targets have the same ring.
    .do = Correct the code of one of them.

# $value_mm = 1000000000.0
# $most_mm = 100000.0
sheet-place_out_of_range = { $value_mm } mm is not a position on a sheet.
    .do = Give a value between -{ $most_mm } and { $most_mm } mm.

# $value_mm = -1.0
# $most_mm = 100000.0
sheet-length_out_of_range = { $value_mm } mm is not a length on a sheet.
    .do = Give a value from 0 to { $most_mm } mm.

# $family = "apriltag-36h11"
sheet-spacing_missing = { $family }: the side of a square or the distance of dots is missing.
    .do = Give { OPTION("spacing", "25mm") }.

sheet-dots_without_numbers = Dots have no numbers from which { OPTION("codes") } could choose.
    .do = Give { OPTION("count") }, or nothing for as many as there is space for.

# $family = "chessboard-9x6"
sheet-board_without_numbers = { $family } is a board; its points have no numbers to choose from.
    .do = Leave out { OPTION("codes") } and { OPTION("count") }.

# $names = ["41", "42"]
sheet-other_targets = The photographs show targets that are not on the sheet: { LIST($names, most: 10) }.
    .do = Give the file of the sheet that was photographed, or the family alone: { OPTION("target") }.
