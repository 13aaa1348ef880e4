qgc-no_plan = This is not a plan of QGroundControl ("fileType" is not "Plan").
    .do = Check that it is the right file.

# $kind = "'ComplexItem'"
qgc-complex_item = The item is a { $kind }; QGroundControl alone makes way points of it.
    .do = Convert it there to simple items.
