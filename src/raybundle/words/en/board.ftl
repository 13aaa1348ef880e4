# $view = 3
# $n = 2
# $least = 4
board-view_too_few_points = View { $view } of the board shows { $n } points; { $least } are needed.
    .do = Leave the view out.

# $residual_px = 45.0
board-no_lens = No lens model fits the views of the board: the best start leaves residuals of { $residual_px } px.
    .do = Check rows and columns of the corners, and that all views show the same board.

# $name = "'charuco-8'"
board-charuco_name = { $name } is not the name of a ChArUco board.
    .do = Name it by squares and tags, as charuco-8x6-5x5_100; append -0.8 if tags are not 0.75 of a square.

# $name = "'charuco-2x2-5x5_100'"
board-charuco_size = { $name } is not possible as a ChArUco board.
    .do = Use at least 3 x 3 squares, and tags of 0.3 to 0.95 of a square.

# $name = "'charuco-20x20-4x4_50'"
# $n = 200
# $tags = "4x4_50"
# $most = 50
board-charuco_tags = { $name } needs { $n } tags; { $tags } has { $most }.
    .do = Use a larger dictionary, or fewer squares.

# $name = "'chessboard-9'"
board-chessboard_name = { $name } is not the name of a chessboard.
    .do = Name it by its inner corners, as chessboard-9x6.

# $name = "'chessboard-2x2'"
board-chessboard_size = { $name }: a chessboard needs at least 3 x 3 inner corners.
    .do = Use a board with more squares.

# $name = "'circles-7'"
board-dots_name = { $name } is not the name of a raster of dots.
    .do = Name it by the numbers of dots, as circles-7x5 or acircles-4x11.

# $name = "'circles-2x2'"
board-dots_size = { $name }: a raster needs at least 3 x 3 dots.
    .do = Use a raster with more dots.

# $board = "charuco 8x11"
board-not_alone = A board ({ $board }) cannot be combined with other targets in a calibration.
    .do = Give { OPTION("target") } with one board, or with single targets only.
