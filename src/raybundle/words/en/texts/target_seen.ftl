# $n = 3
# $target = "chessboard-9x6"
target_seen-corners_blurred = { $n } corners of { $target } seen, none sharp enough to be measured.

# $n = 3
# $least = 6
# $target = "chessboard-9x6"
target_seen-corners_missing = { $n } corners of { $target } seen, { $least } are needed.

# $n = 12
# $of = 54
# $target = "chessboard-9x6"
target_seen-few_corners = { $target } seen, but only { $n } of { $of } corners can be measured.
    .why = The others are not sharp or even enough.

# $columns = 9
# $rows = 6
target_seen-larger_board = The chessboard has more than { $columns } x { $rows } inner corners.
    .do = Name the right number.

# $squares = true
# $named = "chessboard-8x5"
# $target = "chessboard-9x6"
target_seen-no_board = No whole { $target } seen{ $squares ->
        [yes] , but one of as many squares: it is called { $named }
        *[no] {""}
    }.

# $n = 80
# $target = "circles-7x5"
target_seen-no_raster = No whole { $target } among { $n } dots seen.

# $n = 96
target_seen-no_rings = { $n } dots in a raster seen, but not two rings of one to four arcs.

# $columns = 8
# $rows = 5
# $target = "circles-7x5"
target_seen-other_raster = Dots in { $columns } columns and { $rows } rows seen, not { $target }.

# $target = "12"
target_seen-read_twice = Target { $target } is read in two places.

# $tag = "12"
# $n = 2
target_seen-tag_in_places = Tag { $tag } is seen in { $n } places: its corners have no name.

# $target = "chessboard-9x6"
target_seen-two_boards = { $target } is seen in two places, which cannot be distinguished.
    .do = Cover one of them, or take a second one with other numbers of points.

# $photographs = 2
# $n = 12
# $target = "AICON (Schneider), 12 bits"
target_seen-points = { $photographs } { $photographs ->
        [one] photograph
        *[other] photographs
    }, { $n } { $n ->
        [one] point
        *[other] points
    } of { $target }.

# $named = 24
# $unnamed = 3
target_seen-observations = Image observations: { $named } with a name, { $unnamed } without.

# $name = "a.png"
# $n = 3
# $points = "1, 2, 3"
target_seen-photograph = { $name }: { $n } { $n ->
        [one] point
        *[other] points
    }: { $points }
