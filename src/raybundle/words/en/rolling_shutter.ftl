# $camera = "p4p"
rolling_shutter = Camera { $camera }: affinity and shear are the effect of a rolling shutter.
    .why = It is not modelled, so the standard deviations are too small.
    .do = Give photographs with exposure times and a scale (positions, control or a scale bar), fly more slowly, or stop for each photograph.

# $camera = "p4p"
rolling_shutter-possible = Camera { $camera }: affinity and shear may be the effect of a rolling shutter.
    .why = The velocities in the axes of the camera are too similar to separate the two; the standard deviations are too small.
    .do = Give the read-out time ({ OPTION("read_out") }), fly more slowly, or stop for each photograph.
