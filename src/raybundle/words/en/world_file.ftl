world_file-six_numbers = A world file has six numbers, one in each line.
    .do = Correct the file.

world_file-rotated = The pixels are not square, or the picture is rotated.
    .do = Give a picture with columns to the right and rows downwards.
