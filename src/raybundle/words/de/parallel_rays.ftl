parallel_rays = { $n } { $n ->
        [one] Verknüpfungspunkt wurde
       *[other] Verknüpfungspunkte wurden
    } ausgeschlossen: Aus nahezu parallelen Strahlen lässt sich keine Tiefe bestimmen.
