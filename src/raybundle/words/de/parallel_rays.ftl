parallel_rays = { $n } { $n ->
        [one] Verknüpfungspunkt wurde
       *[other] Verknüpfungspunkte wurden
    } ausgeschlossen: Parallele Strahlen haben keine Tiefe.
