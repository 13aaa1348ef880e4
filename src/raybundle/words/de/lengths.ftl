lengths-tolerance_without_lengths = { OPTION("allowed") } braucht bekannte Längen.
    .do = { OPTION("lengths") } oder { OPTION("check_length") } angeben.
