# $name = "P1"
plane-points_in_line = Plane { $name }: its points lie on a straight line.
    .why = The plane can rotate about this line.
    .do = Add a point beside the line.
