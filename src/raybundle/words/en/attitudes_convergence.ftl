# $about_deg = 1.52
# $convergence_deg = -1.53
attitudes_convergence = The attitudes are rotated by { NUM($about_deg, decimals: 2) }° about the vertical: they refer to another north.
    .why = Grid north and true north differ by { NUM($convergence_deg, decimals: 2) }° here in UTM; the misalignment absorbs the difference.
    .do = Check whether the headings refer to true north or to grid north.
