memory_exceeded = Eine Ausgleichung benötigte { $used_gb } GB; { OPTION("memory") } erlaubt { $allowed_gb } GB.
    .why = Bis { $whole_gb } GB bleiben die Normalgleichungen in einem Stück; das Programm selbst benötigt { $program_gb } GB.

memory_exceeded-program = { OPTION("memory") } erlaubt { $allowed_gb } GB; das Programm selbst benötigt { $program_gb } GB.
    .why = Es wurde mehr Speicher verwendet als erlaubt.
