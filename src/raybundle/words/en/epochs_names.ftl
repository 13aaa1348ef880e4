# $moved = 20
# $n = 30
# $epochs = ["before", "after"]
# $ids = ["before", "after"]
epochs_names = { $moved } of { $n } common points of { $epochs } moved, more than half.
    .why = The test cannot decide which half is stable; often the names are wrong.
    .do = Check for exchanged or shifted point names, or name the datum points: { OPTION("datum", "NAMES") }.
