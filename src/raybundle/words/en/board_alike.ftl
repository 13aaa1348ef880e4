# $board = "chessboard 9x6"
board_alike = Board { $board } looks the same when turned, so its points are held as printed and flat.
    .why = If the board is not flat, the principal point is wrong.
    .do = Use a board with an odd and an even number of rows and columns.
