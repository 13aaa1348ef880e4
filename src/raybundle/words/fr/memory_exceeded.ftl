memory_exceeded = Une compensation a utilisé { $used_gb } GB ; { OPTION("memory") } autorise { $allowed_gb } GB.

memory_exceeded-program = { OPTION("memory") } autorise { $allowed_gb } GB ; le programme lui-même demande { $program_gb } GB.
