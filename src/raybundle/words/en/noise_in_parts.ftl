noise_in_parts = Standard deviations are based on white noise: noise fields need the normal equations in one piece.
    .why = With photographs such standard deviations are too small.
    .do = Allow more memory ({ OPTION("memory", "GB") }), or multiply the standard deviations.
