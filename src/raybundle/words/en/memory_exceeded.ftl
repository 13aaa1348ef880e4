# $allowed_gb = 1.0
# $used_gb = 1.4
# $whole_gb = 2.0
# $program_gb = 0.5
memory_exceeded = An adjustment used { $used_gb } GB; { OPTION("memory") } allows { $allowed_gb } GB.
    .why = Up to { $whole_gb } GB the normal equations stay in one piece; the program itself needs { $program_gb } GB.

# $allowed_gb = 0.3
# $program_gb = 0.5
memory_exceeded-program = { OPTION("memory") } allows { $allowed_gb } GB; the program itself needs { $program_gb } GB.
    .why = More memory than allowed was used.
