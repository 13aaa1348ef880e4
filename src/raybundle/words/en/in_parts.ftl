# $parts = 4
# $needed_gb = 12.4
# $allowed_gb = 8.0
in_parts = The normal equations were reduced in { $parts } parts (Helmert-Wolf).
    .why = In one piece they need { $needed_gb } GB; { OPTION("memory") } allows { $allowed_gb } GB. The result is the same within rounding.

# $parts = 4
# $needed_gb = 12.4
# $allowed_gb = 2.0
# $least_gb = 3.1
in_parts-least = The normal equations were reduced in { $parts } parts (Helmert-Wolf), and still need about { $least_gb } GB.
    .why = In one piece they need { $needed_gb } GB; { OPTION("memory") } allows { $allowed_gb } GB. The result is the same within rounding.
    .do = If the memory is not available, use fewer image points.

# $parts = 4
in_parts-cluster = The normal equations were reduced in { $parts } parts by workers of a cluster (Helmert-Wolf).
    .why = The result is the same within rounding.
