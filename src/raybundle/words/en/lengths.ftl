lengths-tolerance_without_lengths = { OPTION("allowed") } needs known lengths.
    .do = Give { OPTION("lengths") } or { OPTION("check_length") }.
