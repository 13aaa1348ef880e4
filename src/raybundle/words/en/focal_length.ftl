# $lengths = [-1200.0, 1200.0]
focal_length-not_positive = The focal length is { $lengths }; it must be positive.
    .do = Correct the value, or export the file again.
