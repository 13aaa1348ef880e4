lengths-tolerance_without_lengths = { OPTION("allowed") } demande des longueurs connues.
