bingo-photograph_line = A photograph begins with its name and the name of its camera.
    .do = Complete this line.

bingo-point_before_photograph = This image point has no photograph.
    .do = Add a line with photograph and camera before it.
